//! Eight elements with one integration point over an increment: stress, hourglass resistance, bulk viscosity, forces.

use super::flow::{Flow, Symmetric, moved};
use super::shape::{Shape, Vector};
use crate::lanes::{LANES, Lanes};
use pulp::{Arch, Simd, WithSimd};

/// A node of a chunk: place x₁ [L] at the end of the increment and displacement Δu [L] in it.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(super) struct Place {
    pub x: [f64; 3],
    pub du: [f64; 3],
}

/// What resists hourglass motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hourglass {
    /// Springs, times a factor [-], so stiff that blocks of cubes bend as they should: E V tr A/72 for the three shapes of
    /// bending, with A = Σ g gᵀ over the mean gradients g of the nodes, a third of it for the fourth.
    Enhanced(f64),
    /// Springs of a part κ [-] of 2μ V tr A (Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679).
    Stiffness(f64),
    /// Dashpots of a part [-] of what is critical for the volumetric motion.
    Viscous(f64),
}

/// What all elements of a chunk have in common.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Common {
    pub flow: Flow,
    pub hourglass: Hourglass,
    /// Linear and quadratic bulk viscosity [-].
    pub viscosity: [f64; 2],
}

/// Energies [F L] that an increment put into the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Work of the stress: recoverable and plastic.
    pub internal: f64,
    /// Of that, dissipated by plastic flow.
    pub plastic: f64,
    /// Into the resistance to hourglass motion.
    pub hourglass: f64,
    /// Dissipated by bulk viscosity.
    pub viscous: f64,
}

impl std::ops::AddAssign for Energies {
    fn add_assign(&mut self, other: Self) {
        self.internal += other.internal;
        self.plastic += other.plastic;
        self.hourglass += other.hourglass;
        self.viscous += other.viscous;
    }
}

/// What an increment made of a chunk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome {
    pub energies: Energies,
    /// Largest stable increment [T], and the element it is of.
    pub stable: (f64, usize),
    /// The first element turned inside out.
    pub inverted: Option<usize>,
}

/// Numbers of state of a batch: stress, plastic strain, element mass, hourglass forces.
pub(super) const fn numbers(hourglass: usize) -> usize {
    8 + 3 * hourglass
}
pub(super) const PLASTIC: usize = 6;
pub(super) const MASS: usize = 7;

/// The batches of a chunk.
pub(super) struct Run<'a, const N: usize> {
    pub common: &'a Common,
    pub dt: f64,
    /// Elements.
    pub count: usize,
    /// Local nodes of eight elements each; the last batch repeats its last element.
    pub batches: &'a [[[u32; LANES]; N]],
    pub places: &'a [Place],
    pub state: &'a mut [Lanes],
    /// Internal forces [F] on the local nodes, to which those of the elements are added.
    pub forces: &'a mut [[f64; 4]],
}

/// A run over elements of one shape.
pub(super) struct Of<'a, S, const N: usize, const H: usize>(pub Run<'a, N>, pub std::marker::PhantomData<S>);

impl<S: Shape<N, H>, const N: usize, const H: usize> Of<'_, S, N, H> {
    pub fn go(self) -> Outcome {
        Arch::new().dispatch(self)
    }
}

impl<S: Shape<N, H>, const N: usize, const H: usize> WithSimd for Of<'_, S, N, H> {
    type Output = Outcome;

    #[inline(always)]
    fn with_simd<V: Simd>(self, _: V) -> Outcome {
        if V::IS_SCALAR { all::<S, N, H, false>(self.0) } else { all::<S, N, H, true>(self.0) }
    }
}

#[inline(always)]
fn all<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(run: Run<N>) -> Outcome {
    let Run { common, dt, count, batches, places, state, forces } = run;
    let mut sums = [Lanes::ZERO; 4];
    let mut outcome = Outcome { energies: Energies::default(), stable: (f64::INFINITY, 0), inverted: None };
    for (b, (nodes, state)) in batches.iter().zip(state.chunks_exact_mut(numbers(H))).enumerate() {
        let (mut x, mut du) = ([[Lanes::ZERO; 3]; N], [[Lanes::ZERO; 3]; N]);
        for a in 0..N {
            for lane in 0..LANES {
                let place = &places[nodes[a][lane] as usize];
                for c in 0..3 {
                    x[a][c].0[lane] = place.x[c];
                    du[a][c].0[lane] = place.du[c];
                }
            }
        }
        let batch = batch::<S, N, H, FUSED>(common, dt, (&x, &du), state);
        let real = (count - b * LANES).min(LANES);
        for (sum, part) in sums.iter_mut().zip(batch.energies) {
            for lane in 0..real {
                sum.0[lane] += part.0[lane];
            }
        }
        for lane in 0..real {
            if batch.stable.0[lane] < outcome.stable.0 {
                outcome.stable = (batch.stable.0[lane], b * LANES + lane);
            }
            let volume = batch.volume.0[lane];
            if (volume <= 0.0 || volume.is_nan()) && outcome.inverted.is_none() {
                outcome.inverted = Some(b * LANES + lane);
            }
        }
        for lane in 0..real {
            for a in 0..N {
                let force = &mut forces[nodes[a][lane] as usize];
                (0..3).for_each(|c| force[c] += batch.forces[a][c].0[lane]);
            }
        }
    }
    let [internal, plastic, hourglass, viscous] = sums.map(|sum| sum.0.iter().sum::<f64>());
    outcome.energies = Energies { internal, plastic, hourglass, viscous };
    outcome
}

struct Batch<const N: usize> {
    forces: [Vector; N],
    energies: [Lanes; 4],
    volume: Lanes,
    stable: Lanes,
}

#[inline(always)]
fn batch<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(
    common: &Common,
    dt: f64,
    (x, du): (&[Vector; N], &[Vector; N]),
    state: &mut [Lanes],
) -> Batch<N> {
    // Gradients, volume, and the gradient of the increment by the place at its end.
    let integrals = S::gradients::<FUSED>(x);
    let mut volume = Lanes::ZERO;
    let (mut l, mut a) = ([[Lanes::ZERO; 3]; 3], [[Lanes::ZERO; 3]; 3]);
    for n in 0..N {
        for i in 0..3 {
            volume = volume.plus_product::<FUSED>(integrals[n][i], x[n][i]);
            for j in 0..3 {
                l[i][j] = l[i][j].plus_product::<FUSED>(du[n][i], integrals[n][j]);
            }
            for j in 0..=i {
                a[i][j] = a[i][j].plus_product::<FUSED>(integrals[n][i], integrals[n][j]);
            }
        }
    }
    volume = volume * (1.0 / 3.0);
    let by = Lanes::splat(1.0) / volume;
    l.iter_mut().flatten().for_each(|entry| *entry = *entry * by);
    a.iter_mut().flatten().for_each(|entry| *entry = *entry * by * by);
    let motion = moved(&l);
    let mut stress: Symmetric = [state[0], state[1], state[2], state[3], state[4], state[5]];
    let (mut plastic, mass) = (state[PLASTIC], state[MASS]);
    let work = common.flow.advance::<FUSED>(&motion, &mut stress, &mut plastic);
    state[..6].copy_from_slice(&stress);
    state[PLASTIC] = plastic;
    let opened = motion.strain[0] + motion.strain[1] + motion.strain[2];
    let middle = volume * (Lanes::splat(1.0) - opened * 0.5);

    // ω² ≤ N V/m (2μ a + λ tr A) with a ≥ the largest eigenvalue of A: equality for cubes and blocks with one short side.
    let (lambda, mu) = (common.flow.lambda, common.flow.mu);
    let trace = a[0][0] + a[1][1] + a[2][2];
    let largest = largest_eigenvalue(&a, trace);
    let per_mass = volume * N as f64 / mass;
    let square = per_mass * (largest * (2.0 * mu) + trace * lambda.max(0.0));
    let free = Lanes::splat(2.0) / square.sqrt();

    // Bulk viscosity: a pressure against the rate of volume.
    let speed = (volume / mass * (lambda + 2.0 * mu)).sqrt();
    let [linear, quadratic] = common.viscosity;
    let (rate, density) = if dt > 0.0 { (opened * (1.0 / dt), mass / volume) } else { (Lanes::ZERO, Lanes::ZERO) };
    let length = speed * free;
    let closing = (-rate).max(Lanes::ZERO);
    let fraction = Lanes::splat(linear) + closing * free * (quadratic * quadratic);
    let viscous = density * speed * length * fraction * rate;
    let stable = free * ((fraction * fraction + Lanes::splat(1.0)).sqrt() - fraction);

    // V σ, less what the hourglass forces have of a constant gradient.
    let s = [stress[0] + viscous, stress[1] + viscous, stress[2] + viscous, stress[3], stress[4], stress[5]];
    let mut t = [[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]];
    let mut out = Batch {
        forces: [[Lanes::ZERO; 3]; N],
        energies: [work.all * middle, work.plastic * middle, Lanes::ZERO, viscous * opened * middle],
        volume,
        stable,
    };
    let young = mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu);
    for k in 0..H {
        let shape = &S::HOURGLASS[k];
        let (mut place, mut turned) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
        for n in 0..N {
            for i in 0..3 {
                place[i] = place[i].plus_product::<FUSED>(x[n][i], Lanes::splat(shape[n]));
                turned[i] = turned[i].plus_product::<FUSED>(du[n][i], Lanes::splat(shape[n]));
            }
        }
        let share = if k < 3 { 1.0 } else { 1.0 / 3.0 };
        let stiffness = volume
            * trace
            * match common.hourglass {
                Hourglass::Enhanced(factor) => factor * young * share / 72.0,
                Hourglass::Stiffness(part) => 2.0 * mu * part,
                Hourglass::Viscous(_) => 0.0,
            };
        // A dashpot c q/Δt, with c so that ω²_hourglass of a spring c ω would be critical.
        let damping = match common.hourglass {
            Hourglass::Viscous(part) if dt > 0.0 => mass * square.sqrt() * (part / (64.0 * dt)),
            _ => Lanes::ZERO,
        };
        for i in 0..3 {
            let q = turned[i] - (l[i][0] * place[0] + l[i][1] * place[1] + l[i][2] * place[2]);
            turned[i] = q;
        }
        let kept = [state[8 + 3 * k], state[9 + 3 * k], state[10 + 3 * k]];
        for i in 0..3 {
            let r = &motion.rotation[i];
            let before = r[0] * kept[0] + r[1] * kept[1] + r[2] * kept[2];
            let now = before.plus_product::<FUSED>(stiffness, turned[i]);
            state[8 + 3 * k + i] = now;
            let force = now.plus_product::<FUSED>(damping, turned[i]);
            out.energies[2] += ((before + now) * 0.5).plus_product::<FUSED>(damping, turned[i]) * turned[i];
            for j in 0..3 {
                t[i][j] = t[i][j] - force * place[j] * by;
            }
            for n in 0..N {
                out.forces[n][i] = out.forces[n][i].plus_product::<FUSED>(force, Lanes::splat(shape[n]));
            }
        }
    }
    for n in 0..N {
        for i in 0..3 {
            for j in 0..3 {
                out.forces[n][i] = out.forces[n][i].plus_product::<FUSED>(t[i][j], integrals[n][j]);
            }
        }
    }
    out
}

/// At least the largest eigenvalue of a symmetric matrix (lower triangle): mean + √(2/3) · norm of the deviator, equal to it
/// where the two others are equal.
#[inline(always)]
fn largest_eigenvalue(a: &[[Lanes; 3]; 3], trace: Lanes) -> Lanes {
    let mean = trace * (1.0 / 3.0);
    let mut square = Lanes::ZERO;
    for i in 0..3 {
        let d = a[i][i] - mean;
        square += d * d;
        for j in 0..i {
            square += a[i][j] * a[i][j] * 2.0;
        }
    }
    mean + (square * (2.0 / 3.0)).sqrt()
}
