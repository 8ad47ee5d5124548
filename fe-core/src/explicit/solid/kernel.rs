//! Eight elements with one integration point over an increment: stress, hourglass resistance, bulk viscosity, forces.

use super::batch::{Batch, Common};
use super::hourglass::{resist, resistance};
use super::motion::{Matrix, Motion, full};
use super::one_point::{HOURGLASS, MASS, PLASTIC, VISCOUS};
use super::response::Point;
use super::shape::{Shape, Vector};
use super::viscosity::Viscosity;
use crate::element::Space;
use crate::lanes::Lanes;

/// Where eight elements are and how the increment moved them there.
pub(super) struct Geometry<const N: usize> {
    /// ∫∇N dV of each node [L²].
    pub integrals: [Vector; N],
    /// ∫N/r dV of each node [L²], axisymmetric.
    hoop: [Lanes; N],
    /// Volume [L³], and 1 over it.
    pub volume: Lanes,
    pub by: Lanes,
    /// ∂Δu/∂x₁.
    pub gradient: Matrix,
    /// Trace of A = Σ g gᵀ, g the mean gradients of the nodes, and what its largest eigenvalue does not exceed [1/L²].
    pub trace: Lanes,
    largest: Lanes,
    /// Σ of the squares of what the nodes' motions do to the volume [1/L²]: the trace, but for rings.
    divergence: Lanes,
}

/// With L = ∂Δu/∂x₁ from `du`.
#[inline(always)]
pub(super) fn geometry<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(
    x: &[Vector; N],
    du: &[Vector; N],
) -> Geometry<N> {
    let integrals = S::gradients::<FUSED>(x);
    let hoop = S::hoop(x);
    let dimension = S::SPACE.dimension();
    let mut volume = Lanes::ZERO;
    let (mut l, mut a) = ([[Lanes::ZERO; 3]; 3], [[Lanes::ZERO; 3]; 3]);
    for n in 0..N {
        for i in 0..dimension {
            volume = volume.plus_product::<FUSED>(integrals[n][i], x[n][i]);
            for j in 0..dimension {
                l[i][j] = l[i][j].plus_product::<FUSED>(du[n][i], integrals[n][j]);
            }
            for j in 0..=i {
                a[i][j] = a[i][j].plus_product::<FUSED>(integrals[n][i], integrals[n][j]);
            }
        }
    }
    volume = volume * (1.0 / dimension as f64);
    if S::SPACE == Space::Axisymmetric {
        volume = Lanes::ZERO;
        for n in 0..N {
            volume = volume.plus_product::<FUSED>(hoop[n], x[n][0]);
            l[2][2] = l[2][2].plus_product::<FUSED>(hoop[n], du[n][0]);
        }
    }
    let by = Lanes::splat(1.0) / volume;
    l.iter_mut().flatten().for_each(|entry| *entry = *entry * by);
    a.iter_mut().flatten().for_each(|entry| *entry = *entry * by * by);
    let trace = a[0][0] + a[1][1] + a[2][2];
    let (mut largest, mut divergence) = (largest_eigenvalue(&a, trace, dimension), trace);
    if S::SPACE == Space::Axisymmetric {
        for n in 0..N {
            let (hoop, outward) = (hoop[n] * by, integrals[n][0] * by);
            largest += hoop * hoop;
            divergence += hoop * (hoop + outward * 2.0);
        }
    }
    Geometry { integrals, hoop, volume, by, gradient: l, trace, largest, divergence }
}

impl<const N: usize> Geometry<N> {
    /// F⁻¹ = ∂X/∂x, from where the nodes were at the start.
    #[inline(always)]
    fn backward(&self, space: Space, reference: &[Vector; N]) -> Matrix {
        let mut out = [[Lanes::ZERO; 3]; 3];
        for n in 0..N {
            for i in 0..3 {
                for j in 0..3 {
                    out[i][j] += reference[n][i] * self.integrals[n][j] * self.by;
                }
            }
            out[2][2] += reference[n][0] * self.hoop[n] * self.by;
        }
        if matches!(space, Space::PlaneStrain | Space::PlaneStress) {
            out[2][2] = Lanes::splat(1.0);
        }
        out
    }

    /// What is a plane of thickness 1, of this one.
    #[inline(always)]
    fn thicken(&mut self, thickness: Lanes) {
        self.integrals.iter_mut().flatten().for_each(|entry| *entry = *entry * thickness);
        self.volume = self.volume * thickness;
        self.by = self.by / thickness;
    }
}

/// An increment of eight elements; `reference`, where they began, is looked at where the material needs it.
#[inline(always)]
pub(super) fn batch<S: Shape<N, H>, const N: usize, const H: usize, const FUSED: bool>(
    common: &Common,
    dt: f64,
    [x, du, reference]: [&[Vector; N]; 3],
    state: &mut [Lanes],
) -> Batch<N> {
    let mut geometry = geometry::<S, N, H, FUSED>(x, du);
    let mut motion = Motion::new(&geometry.gradient);
    let backward = match common.answer.is_total() {
        true => geometry.backward(S::SPACE, reference),
        false => [[Lanes::ZERO; 3]; 3],
    };
    let mass = state[MASS];
    let stress = [state[0], state[1], state[2], state[3], state[4], state[5]];
    let mut point = Point { stress, plastic: state[PLASTIC] };
    let lightest = if S::SPACE == Space::Solid { Lanes::splat(N as f64) } else { state[HOURGLASS + 3 * H] };
    let done = match S::SPACE {
        Space::PlaneStress => {
            let stretch = &mut state[HOURGLASS + 3 * H + 1];
            common.answer.advance_plane::<FUSED>(&mut motion, &backward, (&mut point, stretch))
        }
        _ => common.answer.advance::<FUSED>(&motion, &backward, &mut point),
    };
    state[..6].copy_from_slice(&point.stress);
    state[PLASTIC] = point.plastic;
    match S::SPACE {
        Space::PlaneStrain => geometry.thicken(Lanes::splat(common.thickness)),
        Space::PlaneStress => geometry.thicken(state[HOURGLASS + 3 * H + 1] * common.thickness),
        _ => {}
    }
    let volume = geometry.volume;
    let middle = volume * (Lanes::splat(1.0) - motion.opened() * 0.5);

    // No stiffness is above V (2μ a + λ Σ(∂V/∂x)²/V²) with a ≥ the largest eigenvalue of A: equality for cubes and blocks with one
    // short side.
    let [lambda, mu] = done.moduli;
    let stiffness = volume * (geometry.largest * mu * 2.0 + geometry.divergence * lambda.max(Lanes::ZERO));
    let lightness = lightest / mass;
    let square = stiffness * lightness;
    let squares = [square, volume * geometry.divergence * lightness];
    let viscosity = Viscosity::new(common, (dt, state[VISCOUS]), (&motion, squares), S::SPACE == Space::PlaneStress);
    state[VISCOUS] = viscosity.pressure;

    // V σ, less what the hourglass forces have of a constant gradient.
    let mut stress = point.stress;
    (0..6).for_each(|i| stress[i] += viscosity.stress[i]);
    let mut t = full(&stress);
    let mut out = Batch {
        forces: [[Lanes::ZERO; 3]; N],
        energies: [done.work * middle, done.dissipated * middle, Lanes::ZERO, viscosity.work * middle],
        stiffness,
        volume,
        damping: viscosity.damping,
        stable: viscosity.stable,
    };
    for k in 0..H {
        let sizes = (volume * geometry.trace, mass * square.sqrt());
        let resistance = resistance::<S, N, H>(common, dt, k, sizes);
        let kept = &mut state[HOURGLASS + 3 * k..HOURGLASS + 3 + 3 * k];
        let turned = (&geometry, &motion.rotation, done.kept);
        resist::<N, FUSED>(&S::HOURGLASS[k], (x, du), turned, resistance, kept, (&mut t, &mut out));
    }
    for n in 0..N {
        for i in 0..S::SPACE.dimension() {
            for j in 0..S::SPACE.dimension() {
                out.forces[n][i] = out.forces[n][i].plus_product::<FUSED>(t[i][j], geometry.integrals[n][j]);
            }
        }
        if S::SPACE == Space::Axisymmetric {
            out.forces[n][0] = out.forces[n][0].plus_product::<FUSED>(t[2][2], geometry.hoop[n]);
        }
    }
    out
}

/// At least the largest eigenvalue of a symmetric matrix (lower triangle): mean + √(2/3) · norm of the deviator, equal to it
/// where the two others are equal; in the plane exact.
#[inline(always)]
fn largest_eigenvalue(a: &[[Lanes; 3]; 3], trace: Lanes, dimension: usize) -> Lanes {
    let mean = trace * (1.0 / dimension as f64);
    let mut square = Lanes::ZERO;
    for i in 0..dimension {
        let d = a[i][i] - mean;
        square += d * d;
        for j in 0..i {
            square += a[i][j] * a[i][j] * 2.0;
        }
    }
    // Of n eigenvalues with the sum 0 the square of the largest is at most (n − 1)/n of the sum of squares.
    mean + (square * ((dimension - 1) as f64 / dimension as f64)).sqrt()
}
