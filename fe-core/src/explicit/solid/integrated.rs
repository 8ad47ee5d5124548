//! Elements with several integration points, of any shape: C3D8, C3D10, CPE4, CAX4.
//!
//! What a motion does to the volume is the same at all points of an element, its mean (Hughes, Int. J. Numer. Meth. Eng. 15 (1980)
//! 1413): with b = ∂V/∂x/V of the nodes the gradients ∇N keep their deviators and have b for the rest, so that nothing locks where
//! the volume stays. Masses are lumped in proportion to ∫N dV; of C3D10, whose corners would have less than nothing, to ∫N² dV,
//! which is positive at all nodes (Hinton, Rock, Zienkiewicz, Earthq. Eng. Struct. Dyn. 4 (1976) 245).

use super::batch::{Batch, Common, Outcome, Run, all, batches, gather};
use super::chunk::Elements;
use super::motion::{Matrix, Motion, Symmetric, full, inverse};
use super::response::Point;
use super::shape::Vector;
use super::viscosity::Viscosity;
use crate::element::{ElementType, Space};
use crate::lanes::{LANES, Lanes};
use crate::solid::tables::Tables;
use pulp::{Arch, Simd, WithSimd};
use std::f64::consts::TAU;

/// Numbers of state of a point: stress, plastic strain.
const OF_POINT: usize = 7;

#[derive(Debug)]
pub(super) struct Integrated<const N: usize, const P: usize> {
    space: Space,
    tables: Tables<N, P>,
    /// Local nodes of eight elements each; the last batch repeats its last element.
    nodes: Vec<[[u32; LANES]; N]>,
    /// Mass, volume and pressure of bulk viscosity at the end of the last increment, parts of the mass at the nodes, then the points,
    /// batch after batch.
    state: Vec<Lanes>,
}

/// The surroundings of a point of eight elements.
#[derive(Clone, Copy)]
struct Around<const N: usize> {
    /// ∇N of each node [1/L].
    gradients: [Vector; N],
    /// N/r of each node [1/L], axisymmetric.
    hoop: [Lanes; N],
    /// Its part of the volume [L³].
    volume: Lanes,
}

/// What an increment did to a point of eight elements.
#[derive(Clone, Copy)]
struct Moved {
    motion: Motion,
    stress: Symmetric,
    /// Work, and of it what went into plastic flow [F L].
    work: Lanes,
    dissipated: Lanes,
    /// Volume in the middle of the increment [L³].
    middle: Lanes,
}

impl Moved {
    const ZERO: Moved = Moved {
        motion: Motion { strain: [Lanes::ZERO; 6], rotation: [[Lanes::ZERO; 3]; 3] },
        stress: [Lanes::ZERO; 6],
        work: Lanes::ZERO,
        dissipated: Lanes::ZERO,
        middle: Lanes::ZERO,
    };
}

impl<const N: usize> Around<N> {
    const ZERO: Around<N> = Around { gradients: [[Lanes::ZERO; 3]; N], hoop: [Lanes::ZERO; N], volume: Lanes::ZERO };

    /// What the motion of a node along an axis does to the volume.
    #[inline(always)]
    fn divergence(&self, a: usize, i: usize) -> Lanes {
        if i == 0 { self.gradients[a][0] + self.hoop[a] } else { self.gradients[a][i] }
    }

    /// Σ u ∇N, with u_r/r in zz.
    #[inline(always)]
    fn gradient(&self, u: &[Vector; N]) -> Matrix {
        let mut out = [[Lanes::ZERO; 3]; 3];
        for a in 0..N {
            for i in 0..3 {
                for j in 0..3 {
                    out[i][j] += u[a][i] * self.gradients[a][j];
                }
            }
            out[2][2] += u[a][0] * self.hoop[a];
        }
        out
    }
}

impl<const N: usize, const P: usize> Integrated<N, P> {
    const NUMBERS: usize = 3 + N + OF_POINT * P;

    /// Power of N that masses go with: functions of corners alone are positive.
    const POWER: i32 = if N > 8 { 2 } else { 1 };

    /// Free of stress.
    pub fn new(element: ElementType, elements: &[Vec<u32>]) -> Self {
        let nodes = batches(elements);
        let state = vec![Lanes::ZERO; nodes.len() * Self::NUMBERS];
        Integrated { space: element.space(), tables: Tables::new(element), nodes, state }
    }

    #[inline(always)]
    fn around(&self, p: usize, thickness: f64, x: &[Vector; N]) -> Around<N> {
        let (values, derivatives) = (&self.tables.values[p], &self.tables.gradients[p]);
        let dimension = self.space.dimension();
        let mut jacobian = [[Lanes::ZERO; 3]; 3];
        let mut radius = Lanes::ZERO;
        for a in 0..N {
            radius += x[a][0] * values[a];
            for i in 0..dimension {
                for j in 0..dimension {
                    jacobian[i][j] += x[a][i] * derivatives[a][j];
                }
            }
        }
        if dimension == 2 {
            jacobian[2][2] = Lanes::splat(1.0);
        }
        let (back, determinant) = inverse(&jacobian);
        let mut out = Around {
            gradients: [[Lanes::ZERO; 3]; N],
            hoop: [Lanes::ZERO; N],
            volume: determinant * (self.tables.weights[p] * thickness),
        };
        for a in 0..N {
            for i in 0..dimension {
                for j in 0..dimension {
                    out.gradients[a][i] += back[j][i] * derivatives[a][j];
                }
            }
        }
        if self.space == Space::Axisymmetric {
            out.volume = out.volume * radius * TAU;
            out.hoop = values.map(|value| Lanes::splat(value) / radius);
        }
        out
    }

    /// An increment of eight elements.
    #[inline(always)]
    fn batch<const FUSED: bool>(
        &self,
        common: &Common,
        dt: f64,
        [x, du, reference]: [&[Vector; N]; 3],
        state: &mut [Lanes],
    ) -> Batch<N> {
        let mut around = [Around::ZERO; P];
        for p in 0..P {
            around[p] = self.around(p, common.thickness, x);
        }
        let volume = around.iter().fold(Lanes::ZERO, |sum, point| sum + point.volume);
        let mean = mean(&around, volume);
        let (own, of_points) = state.split_at_mut(3 + N);
        let mass = own[0];
        // Strain of the volume, over the one in the middle.
        let opened = (volume - own[1]) / (volume + own[1]) * 2.0;
        own[1] = volume;

        let (mut lambda, mut mu) = (Lanes::ZERO, Lanes::ZERO);
        let mut points = [Moved::ZERO; P];
        for p in 0..P {
            let mut motion = Motion::new(&around[p].gradient(du));
            let own = motion.opened();
            let shift = (opened - own) * (1.0 / 3.0);
            (0..3).for_each(|i| motion.strain[i] += shift);
            let backward = match common.answer.is_total() {
                true => self.backward(&around[p], reference, volume * common.density / mass),
                false => [[Lanes::ZERO; 3]; 3],
            };
            let kept = &mut of_points[OF_POINT * p..OF_POINT * (p + 1)];
            let mut point = Point { stress: std::array::from_fn(|i| kept[i]), plastic: kept[6] };
            let done = common.answer.advance::<FUSED>(&motion, &backward, &mut point);
            kept[..6].copy_from_slice(&point.stress);
            kept[6] = point.plastic;
            (lambda, mu) = (lambda.max(done.moduli[0]), mu.max(done.moduli[1]));
            let middle = around[p].volume * (Lanes::splat(1.0) - own * 0.5);
            let [work, dissipated] = [done.work * middle, done.dissipated * middle];
            points[p] = Moved { motion, stress: point.stress, work, dissipated, middle };
        }

        let squares = squares(&around, &mean, (volume, mass, &own[3..]), [lambda, mu]);
        let zero = Lanes::ZERO;
        let mut out = Batch {
            forces: [[zero; 3]; N],
            stiffness: squares[0] * mass * own[3..].iter().fold(zero, |most, share| most.max(*share)),
            energies: [zero; 4],
            volume: around[0].volume,
            damping: zero,
            stable: zero,
        };
        let before = own[2];
        for (around, point) in around.iter().zip(&points) {
            let Moved { motion, stress, work, dissipated, middle } = point;
            let viscosity = Viscosity::new(common, (dt, before), (motion, squares), false);
            out.energies[0] += *work;
            out.energies[1] += *dissipated;
            out.energies[3] += viscosity.work * *middle;
            own[2] = viscosity.pressure;
            out.volume = -(-out.volume).max(-around.volume);
            // The volume opens at all points alike.
            (out.damping, out.stable) = (viscosity.damping, viscosity.stable);
            let mut all = *stress;
            (0..6).for_each(|i| all[i] = (all[i] + viscosity.stress[i]) * around.volume);
            let t = full(&all);
            let third = (t[0][0] + t[1][1] + t[2][2]) * (1.0 / 3.0);
            for a in 0..N {
                for i in 0..3 {
                    let mut force = (mean[a][i] - around.divergence(a, i)) * third;
                    (0..3).for_each(|j| force += t[i][j] * around.gradients[a][j]);
                    out.forces[a][i] += force;
                }
                out.forces[a][0] += t[2][2] * around.hoop[a];
            }
        }
        out
    }

    /// F⁻¹ with the mean change of volume of the element.
    #[inline(always)]
    fn backward(&self, around: &Around<N>, reference: &[Vector; N], opened: Lanes) -> Matrix {
        let mut backward = around.gradient(reference);
        if self.space == Space::PlaneStrain {
            backward[2][2] = Lanes::splat(1.0);
        }
        let (_, contraction) = inverse(&backward);
        let factor = (contraction * opened).map(|change| 1.0 / change.cbrt());
        backward.map(|row| row.map(|entry| entry * factor))
    }
}

/// ∂V/∂x/V of the nodes.
#[inline(always)]
fn mean<const N: usize, const P: usize>(around: &[Around<N>; P], volume: Lanes) -> [Vector; N] {
    let mut out = [[Lanes::ZERO; 3]; N];
    for point in around {
        let part = point.volume / volume;
        for a in 0..N {
            (0..3).for_each(|i| out[a][i] += point.divergence(a, i) * part);
        }
    }
    out
}

/// ω² ≤ 2μ max_a Σ_b |Λ_ab|/m_a + λ V Σ_a |b_a|²/m_a with Λ_ab = ∫∇N_a · ∇N_b dV (Gershgorin), in rings N_a N_b/r² besides: within
/// a tenth of a cube's. Also what λ is multiplied with.
#[inline(always)]
fn squares<const N: usize, const P: usize>(
    around: &[Around<N>; P],
    mean: &[Vector; N],
    (volume, mass, shares): (Lanes, Lanes, &[Lanes]),
    [lambda, mu]: [Lanes; 2],
) -> [Lanes; 2] {
    let (mut largest, mut sum) = (Lanes::ZERO, Lanes::ZERO);
    for a in 0..N {
        let mut row = Lanes::ZERO;
        for b in 0..N {
            let mut entry = Lanes::ZERO;
            for point in around {
                let (g, h) = (&point.gradients[a], &point.gradients[b]);
                let product = g[0] * h[0] + g[1] * h[1] + g[2] * h[2] + point.hoop[a] * point.hoop[b];
                entry += product * point.volume;
            }
            row += entry.max(-entry);
        }
        largest = largest.max(row / shares[a]);
        let b = &mean[a];
        sum += (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) / shares[a];
    }
    [largest * mu * 2.0 + sum * volume * lambda, sum * volume].map(|square| square / mass)
}

impl<const N: usize, const P: usize> Elements for Integrated<N, P> {
    fn weigh(
        &mut self,
        common: &Common,
        (count, reference): (usize, &[[f64; 3]]),
        factor: &dyn Fn(usize) -> f64,
        masses: &mut [f64],
    ) {
        for b in 0..self.nodes.len() {
            let x = gather(&self.nodes[b], |n| reference[n]);
            let (mut volume, mut parts, mut whole) = (Lanes::ZERO, [Lanes::ZERO; N], Lanes::ZERO);
            for p in 0..P {
                let point = self.around(p, common.thickness, &x).volume;
                volume += point;
                for a in 0..N {
                    let part = point * self.tables.values[p][a].powi(Self::POWER);
                    parts[a] += part;
                    whole += part;
                }
            }
            let own = &mut self.state[b * Self::NUMBERS..];
            // Weighed anew, elements are as large as the last increment left them.
            if own[1].0 == Lanes::ZERO.0 {
                own[1] = volume;
            }
            own[0] = volume * common.density;
            for a in 0..N {
                own[3 + a] = parts[a] / whole;
                for lane in 0..(count - b * LANES).min(LANES) {
                    let mass = factor(b * LANES + lane) * own[0].0[lane];
                    masses[self.nodes[b][a][lane] as usize] += mass * own[3 + a].0[lane];
                }
            }
        }
    }

    fn advance(&mut self, run: Run) -> Outcome {
        Arch::new().dispatch(Pass { run, elements: self })
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.state[..])
    }

    /// Means of the points.
    fn point(&self, element: usize) -> ([f64; 6], f64) {
        let points = &self.state[element / LANES * Self::NUMBERS + 3 + N..];
        let mean = |i: usize| (0..P).map(|p| points[OF_POINT * p + i].0[element % LANES]).sum::<f64>() / P as f64;
        (std::array::from_fn(mean), mean(6))
    }
}

/// An increment of them all, on the widest vectors that the machine has.
struct Pass<'a, 'b, const N: usize, const P: usize> {
    run: Run<'a>,
    elements: &'b mut Integrated<N, P>,
}

impl<const N: usize, const P: usize> WithSimd for Pass<'_, '_, N, P> {
    type Output = Outcome;

    #[inline(always)]
    fn with_simd<V: Simd>(self, _: V) -> Outcome {
        if V::IS_SCALAR { self.go::<false>() } else { self.go::<true>() }
    }
}

impl<const N: usize, const P: usize> Pass<'_, '_, N, P> {
    #[inline(always)]
    fn go<const FUSED: bool>(self) -> Outcome {
        let (common, dt) = (self.run.common, self.run.dt);
        let mut state = std::mem::take(&mut self.elements.state);
        let elements = &*self.elements;
        let parts = state.chunks_exact_mut(Integrated::<N, P>::NUMBERS);
        let outcome = all(
            self.run,
            &elements.nodes,
            parts,
            #[inline(always)]
            |motion, state| elements.batch::<FUSED>(common, dt, motion, state),
        );
        self.elements.state = state;
        outcome
    }
}
