//! Element stiffness of eight elements at once.
//!
//! An element has `N` nodes, each moving in `D` directions, and behind them `M` − `N` pseudo-nodes whose
//! movements are internal parameters of the element: enhanced strains (Simo and Rifai, Int. J. Numer. Meth. Eng.
//! 29 (1990) 1595). With J the Jacobian matrix, j its determinant and 0 the centroid, pseudo-node k has the
//! gradient g_k = (j₀/j) (ξ_k − c_k) J₀⁻ᵀ e_k: the functions ξ in ε_ξξ, ξ and η in γ_ξη, … that bending needs,
//! four in the plane, nine in space. Against locking near ν = ½ follow volumetric modes
//! ε = (j₀/j) (m − c) 1 with m of ξη in the plane, of ξη, ηζ, ζξ, ξηζ in space; plane stress needs none. Together
//! with the first they let the volume change vary freely over the integration points about its mean.
//!
//! The constants c make the mean of every mode over the volume vanish, so that a constant stress does no work
//! on it and the patch test is passed on any shape: c = 0 but for axisymmetric elements, where
//! c = Σ w r ξ / Σ w r. In plane strain the mode m moves ε_xx and ε_yy only; else all three.
//!
//! Gradients have `G` components; an axisymmetric element keeps N_a/r, its hoop strain, in the third.
//! `A` = (`M` − `N`) `D` + the volumetric modes is the number of internal parameters α; they are condensed:
//! K − Wᵀ D⁻¹ W with W = L⁻¹ K_αu, K_αα = L D Lᵀ.
//!
//! The stiffness is first made for `R` carriers of movement. They are the nodes, or of plane and solid quadrilaterals
//! and hexahedra the hourglass shapes alone (ξη; ξη, ηζ, ζξ, ξηζ): constant strains do no work on what is left of
//! these less their mean, nor on the modes, so that their part of the stiffness is V B̄ᵀ C B̄ with the mean gradients.

mod condense;
mod geometry;
mod hourglass;
mod strain;

use super::tables::{PRODUCTS, Tables};
use crate::element::{ElementType, Space};
use crate::lanes::{LANES, Lanes};
use crate::material::Elastic;
use pulp::{Arch, Simd, WithSimd};

/// Batches of elements with their displacements.
#[derive(Clone, Copy)]
pub(super) struct Batches<'a> {
    /// Coordinates [L], `[batches][nodes × directions]`.
    pub coordinates: &'a [Lanes],
    /// Displacements [L], the same.
    pub displacements: &'a [Lanes],
}

/// What the term asks of an element type, whatever its sizes.
pub(super) trait Kernel: Sync {
    /// Nodes.
    const NODES: usize;
    /// Directions a node moves in.
    const DIRECTIONS: usize;
    /// Integration points.
    const POINTS: usize;
    /// Numbers that [`Kernel::stiffness`] yields an element: its lower blocks, then its nodal forces.
    const STIFFNESS: usize =
        Self::NODES * (Self::NODES + 1) / 2 * Self::DIRECTIONS * Self::DIRECTIONS + Self::NODES * Self::DIRECTIONS;

    /// Lower blocks and force K u of each element, `[elements][STIFFNESS]`.
    fn stiffness(&self, batches: Batches, out: &mut [f64]);

    /// Strains at the integration points, enhanced ones included, `[elements × POINTS][6]`; tensor shear.
    fn strains(&self, batches: Batches, out: &mut [f64]);
}

/// An element type with its constants.
pub(super) struct Element<
    const N: usize,
    const R: usize,
    const M: usize,
    const D: usize,
    const G: usize,
    const P: usize,
    const A: usize,
> {
    tables: Tables<N, P>,
    /// Lamé's first constant, or 2λμ/(λ+2μ) in plane stress [F/L²].
    lambda: f64,
    /// Shear modulus [F/L²].
    mu: f64,
    /// Thickness [L], 1 in space, 2π around an axis.
    factor: f64,
}

/// What the element routines share about one batch.
struct Work<
    const N: usize,
    const R: usize,
    const M: usize,
    const D: usize,
    const G: usize,
    const P: usize,
    const A: usize,
> {
    /// Gradients of carriers and pseudo-nodes; those of hourglass shapes less their mean.
    gradients: [[[Lanes; G]; M]; P],
    /// Volume of each point.
    weights: [Lanes; P],
    /// Volumetric modes at the points.
    volumetric: [[Lanes; PRODUCTS]; P],
    /// K_αα, lower; after condensation L, and 1/D on the diagonal.
    inner: [[Lanes; A]; A],
    /// K_αu transposed, `[carriers × directions][A]`; after condensation Wᵀ.
    coupling: Vec<[Lanes; A]>,
    /// Lower blocks of the hourglass shapes, `[R (R+1)/2 × D²]`.
    lower: Vec<Lanes>,
    /// γ_ka: how much of hourglass shape k is in a movement of node a.
    hourglass: [[Lanes; R]; N],
    /// Mean gradients of the nodes' shape functions.
    uniform: [[Lanes; D]; N],
    /// Volume of the element.
    volume: Lanes,
}

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    /// With the constants of a material; `thickness` is that of plane elements.
    pub fn new(element: ElementType, elastic: &Elastic, thickness: f64) -> Self {
        let (lambda, mu) = (elastic.lambda(), elastic.mu());
        let (lambda, factor) = match element.space() {
            Space::Solid | Space::Plane | Space::Any => (lambda, 1.0),
            Space::PlaneStrain => (lambda, thickness),
            Space::PlaneStress => (2.0 * lambda * mu / (lambda + 2.0 * mu), thickness),
            Space::Axisymmetric => (lambda, std::f64::consts::TAU),
        };
        Element { tables: Tables::new(element), lambda, mu, factor }
    }

    const AXISYMMETRIC: bool = G > D;
    const DIRECTIONAL: usize = (M - R) * D;
    const REDUCED: bool = R < N;

    fn work() -> Box<Work<N, R, M, D, G, P, A>> {
        Box::new(Work {
            gradients: [[[Lanes::ZERO; G]; M]; P],
            weights: [Lanes::ZERO; P],
            volumetric: [[Lanes::ZERO; PRODUCTS]; P],
            inner: [[Lanes::ZERO; A]; A],
            coupling: vec![[Lanes::ZERO; A]; R * D],
            lower: vec![Lanes::ZERO; R * (R + 1) / 2 * D * D],
            hourglass: [[Lanes::ZERO; R]; N],
            uniform: [[Lanes::ZERO; D]; N],
            volume: Lanes::ZERO,
        })
    }

    /// Lower blocks of one batch into `lower`, `[N (N+1)/2 × D²]`, the internal parameters condensed.
    #[inline(always)]
    fn batch_stiffness<const FUSED: bool>(
        &self,
        x: &[Lanes],
        work: &mut Work<N, R, M, D, G, P, A>,
        lower: &mut [Lanes],
    ) {
        self.geometry::<FUSED>(x, work);
        if Self::REDUCED {
            let mut hourglass = std::mem::take(&mut work.lower);
            self.carrier_stiffness::<FUSED>(work, &mut hourglass);
            work.lower = hourglass;
            self.expand::<FUSED>(work, lower);
        } else {
            self.carrier_stiffness::<FUSED>(work, lower);
        }
    }

    /// Lower blocks of the carriers, the internal parameters condensed.
    #[inline(always)]
    fn carrier_stiffness<const FUSED: bool>(&self, work: &mut Work<N, R, M, D, G, P, A>, lower: &mut [Lanes]) {
        let mut places = lower.chunks_exact_mut(D * D);
        for a in 0..M {
            let weighted = Self::weighted(work, a);
            for b in 0..=a {
                let block = self.block::<FUSED>(&weighted, work, b);
                if a < R {
                    let place = places.next().expect("one place a lower block");
                    (0..D).for_each(|i| place[i * D..(i + 1) * D].copy_from_slice(&block[i]));
                } else {
                    self.keep(work, a, b, &block);
                }
            }
        }
        if A > 0 {
            self.volumetric_rows::<FUSED>(work);
            self.condense::<FUSED>(work, lower);
        }
    }

    #[inline(always)]
    fn weighted(work: &Work<N, R, M, D, G, P, A>, a: usize) -> [[Lanes; G]; P] {
        let mut out = [[Lanes::ZERO; G]; P];
        for p in 0..P {
            for i in 0..G {
                out[p][i] = work.gradients[p][a][i] * work.weights[p];
            }
        }
        out
    }

    /// K_ab = λ t_a t_bᵀ + μ (g_b g_aᵀ + g_a·g_b 1), plus 2μ h_a h_b for the hoop, summed over the points;
    /// t is the trace of the strain that each movement makes. All of it comes from T = Σ w g_a g_bᵀ.
    #[inline(always)]
    fn block<const FUSED: bool>(
        &self,
        weighted: &[[Lanes; G]; P],
        work: &Work<N, R, M, D, G, P, A>,
        b: usize,
    ) -> [[Lanes; D]; D] {
        let mut t = [[Lanes::ZERO; G]; G];
        for p in 0..P {
            let g = &work.gradients[p][b];
            for i in 0..G {
                for j in 0..G {
                    t[i][j] = t[i][j].plus_product::<FUSED>(weighted[p][i], g[j]);
                }
            }
        }
        self.elastic::<FUSED>(&t)
    }

    /// K_ab from T.
    #[inline(always)]
    fn elastic<const FUSED: bool>(&self, t: &[[Lanes; G]; G]) -> [[Lanes; D]; D] {
        let (lambda, mu) = (Lanes::splat(self.lambda), Lanes::splat(self.mu));
        let mut dot = t[0][0] + t[1][1];
        if D == 3 {
            dot += t[2][2];
        }
        let mut traces = [[Lanes::ZERO; D]; D];
        for i in 0..D {
            traces[i].copy_from_slice(&t[i][..D]);
        }
        if Self::AXISYMMETRIC {
            for i in 0..D {
                traces[0][i] += t[2][i];
                traces[i][0] += t[i][2];
            }
            traces[0][0] += t[2][2];
        }
        let mut block = [[Lanes::ZERO; D]; D];
        for i in 0..D {
            for j in 0..D {
                block[i][j] = (mu * t[j][i]).plus_product::<FUSED>(lambda, traces[i][j]);
            }
            block[i][i] = block[i][i].plus_product::<FUSED>(mu, dot);
        }
        if Self::AXISYMMETRIC {
            block[0][0] = block[0][0].plus_product::<FUSED>(mu * 2.0, t[2][2]);
        }
        block
    }

    /// Eight elements' results of `count` numbers each, from lanes to one element after the other.
    #[inline(always)]
    fn unpack(lanes: &[Lanes], out: &mut [f64], count: usize) {
        if out.len() == LANES * count {
            for (i, lane) in lanes[..count].iter().enumerate() {
                for element in 0..LANES {
                    out[element * count + i] = lane.0[element];
                }
            }
            return;
        }
        for (element, place) in out.chunks_exact_mut(count).enumerate() {
            for (value, lane) in place.iter_mut().zip(lanes) {
                *value = lane.0[element];
            }
        }
    }
}

/// f_a = Σ_b K_ab u_b from the lower blocks.
#[inline(always)]
fn force<const FUSED: bool, const D: usize>(lower: &[Lanes], u: &[Lanes], force: &mut [Lanes]) {
    force.fill(Lanes::ZERO);
    let mut blocks = lower.chunks_exact(D * D);
    for a in 0..u.len() / D {
        for b in 0..=a {
            let block = blocks.next().expect("one block a pair of nodes");
            for i in 0..D {
                for j in 0..D {
                    force[a * D + i] = force[a * D + i].plus_product::<FUSED>(block[i * D + j], u[b * D + j]);
                    if a != b {
                        force[b * D + j] = force[b * D + j].plus_product::<FUSED>(block[i * D + j], u[a * D + i]);
                    }
                }
            }
        }
    }
}

/// One kernel run on a chunk of batches, compiled for each instruction set.
struct Run<'a, K> {
    element: &'a K,
    batches: Batches<'a>,
    out: &'a mut [f64],
    strains: bool,
}

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    WithSimd for Run<'_, Element<N, R, M, D, G, P, A>>
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        match (S::IS_SCALAR, self.strains) {
            (true, false) => self.element.run_stiffness::<false>(self.batches, self.out),
            (false, false) => self.element.run_stiffness::<true>(self.batches, self.out),
            (true, true) => self.element.run_strains::<false>(self.batches, self.out),
            (false, true) => self.element.run_strains::<true>(self.batches, self.out),
        }
    }
}

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    #[inline(always)]
    fn run_stiffness<const FUSED: bool>(&self, batches: Batches, out: &mut [f64]) {
        let mut work = Self::work();
        let count = <Self as Kernel>::STIFFNESS;
        let mut results = vec![Lanes::ZERO; count];
        let inputs = batches.coordinates.chunks_exact(N * D).zip(batches.displacements.chunks_exact(N * D));
        for ((x, u), place) in inputs.zip(out.chunks_mut(LANES * count)) {
            let (lower, forces) = results.split_at_mut(count - N * D);
            self.batch_stiffness::<FUSED>(x, &mut work, lower);
            force::<FUSED, D>(lower, u, forces);
            Self::unpack(&results, place, count);
        }
    }

    #[inline(always)]
    fn run_strains<const FUSED: bool>(&self, batches: Batches, out: &mut [f64]) {
        let mut work = Self::work();
        let mut lower = vec![Lanes::ZERO; <Self as Kernel>::STIFFNESS - N * D];
        let mut results = vec![Lanes::ZERO; P * 6];
        let inputs = batches.coordinates.chunks_exact(N * D).zip(batches.displacements.chunks_exact(N * D));
        for ((x, u), place) in inputs.zip(out.chunks_mut(LANES * P * 6)) {
            self.batch_stiffness::<FUSED>(x, &mut work, &mut lower);
            Self::batch_strains::<FUSED>(u, &work, &mut results);
            Self::unpack(&results, place, P * 6);
        }
    }
}

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Kernel for Element<N, R, M, D, G, P, A>
{
    const NODES: usize = N;
    const DIRECTIONS: usize = D;
    const POINTS: usize = P;

    fn stiffness(&self, batches: Batches, out: &mut [f64]) {
        Arch::new().dispatch(Run { element: self, batches, out, strains: false });
    }

    fn strains(&self, batches: Batches, out: &mut [f64]) {
        Arch::new().dispatch(Run { element: self, batches, out, strains: true });
    }
}
