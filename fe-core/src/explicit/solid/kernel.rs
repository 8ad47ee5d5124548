//! Eight elements with one integration point over an increment: stress, hourglass resistance, bulk viscosity, forces.

use super::flow::{Flow, Matrix, Symmetric, moved};
use super::hourglass::{Hourglass, resist, resistance};
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

pub(super) struct Batch<const N: usize> {
    pub forces: [Vector; N],
    /// Internal, plastic, hourglass, viscous.
    pub energies: [Lanes; 4],
    volume: Lanes,
    stable: Lanes,
}

/// Where eight elements are and how the increment moved them there.
pub(super) struct Geometry<const N: usize> {
    /// ∫∇N dV of each node [L²].
    pub integrals: [Vector; N],
    /// Volume [L³], and 1 over it.
    volume: Lanes,
    pub by: Lanes,
    /// ∂Δu/∂x₁.
    pub gradient: Matrix,
    /// Trace of A = Σ g gᵀ, g the mean gradients of the nodes, and what its largest eigenvalue does not exceed [1/L²].
    trace: Lanes,
    largest: Lanes,
}

#[inline(always)]
fn geometry<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(
    x: &[Vector; N],
    du: &[Vector; N],
) -> Geometry<N> {
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
    let trace = a[0][0] + a[1][1] + a[2][2];
    Geometry { integrals, volume, by, gradient: l, trace, largest: largest_eigenvalue(&a, trace) }
}

#[inline(always)]
fn batch<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(
    common: &Common,
    dt: f64,
    (x, du): (&[Vector; N], &[Vector; N]),
    state: &mut [Lanes],
) -> Batch<N> {
    let geometry = geometry::<S, N, H, FUSED>(x, du);
    let (volume, mass) = (geometry.volume, state[MASS]);
    let motion = moved(&geometry.gradient);
    let mut stress: Symmetric = [state[0], state[1], state[2], state[3], state[4], state[5]];
    let mut plastic = state[PLASTIC];
    let work = common.flow.advance::<FUSED>(&motion, &mut stress, &mut plastic);
    state[..6].copy_from_slice(&stress);
    state[PLASTIC] = plastic;
    let opened = motion.strain[0] + motion.strain[1] + motion.strain[2];
    let middle = volume * (Lanes::splat(1.0) - opened * 0.5);

    // ω² ≤ N V/m (2μ a + λ tr A) with a ≥ the largest eigenvalue of A: equality for cubes and blocks with one short side.
    let (lambda, mu) = (common.flow.lambda, common.flow.mu);
    let per_mass = volume * N as f64 / mass;
    let square = per_mass * (geometry.largest * (2.0 * mu) + geometry.trace * lambda.max(0.0));
    let (viscous, stable) = bulk_viscosity(common, dt, (volume, mass), (opened, square));

    // V σ, less what the hourglass forces have of a constant gradient.
    let s = [stress[0] + viscous, stress[1] + viscous, stress[2] + viscous, stress[3], stress[4], stress[5]];
    let mut t = [[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]];
    let mut out = Batch {
        forces: [[Lanes::ZERO; 3]; N],
        energies: [work.all * middle, work.plastic * middle, Lanes::ZERO, viscous * opened * middle],
        volume,
        stable,
    };
    for k in 0..H {
        let resistance = resistance(common, dt, k, (geometry.volume * geometry.trace, mass * square.sqrt()));
        let kept = &mut state[8 + 3 * k..11 + 3 * k];
        resist::<N, FUSED>(
            &S::HOURGLASS[k],
            (x, du),
            (&geometry, &motion.rotation),
            resistance,
            kept,
            (&mut t, &mut out),
        );
    }
    for n in 0..N {
        for i in 0..3 {
            for j in 0..3 {
                out.forces[n][i] = out.forces[n][i].plus_product::<FUSED>(t[i][j], geometry.integrals[n][j]);
            }
        }
    }
    out
}

/// Bulk viscosity, a pressure against the rate of volume, as a stress; and the stable increment that it leaves of 2/ω.
#[inline(always)]
fn bulk_viscosity(
    common: &Common,
    dt: f64,
    (volume, mass): (Lanes, Lanes),
    (opened, square): (Lanes, Lanes),
) -> (Lanes, Lanes) {
    let free = Lanes::splat(2.0) / square.sqrt();
    let speed = (volume / mass * (common.flow.lambda + 2.0 * common.flow.mu)).sqrt();
    let [linear, quadratic] = common.viscosity;
    let (rate, density) = if dt > 0.0 { (opened * (1.0 / dt), mass / volume) } else { (Lanes::ZERO, Lanes::ZERO) };
    let length = speed * free;
    let closing = (-rate).max(Lanes::ZERO);
    let fraction = Lanes::splat(linear) + closing * free * (quadratic * quadratic);
    let viscous = density * speed * length * fraction * rate;
    (viscous, free * ((fraction * fraction + Lanes::splat(1.0)).sqrt() - fraction))
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
