//! What elements with one integration point do against motions that their mean gradients do not see.

use super::batch::{Batch, Common};
use super::kernel::Geometry;
use super::motion::Matrix;
use super::shape::{Shape, Vector};
use crate::element::Space;
use crate::lanes::Lanes;

/// What resists hourglass motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hourglass {
    /// Springs, times a factor [-], so stiff that blocks of cubes bend as they should: E V tr A/72 for the three shapes of
    /// bending, with A = Σ g gᵀ over the mean gradients g of the nodes, a third of it for the fourth; of squares E V tr A/24,
    /// with E/(1 − ν²) where they are not of plane stress.
    Enhanced(f64),
    /// Springs of a part κ [-] of 2μ V tr A (Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17 (1981) 679).
    Stiffness(f64),
    /// Dashpots of a part [-] of what is critical for the volumetric motion.
    Viscous(f64),
}

/// Stiffness [F/L], and viscosity over the increment [F/L], against the hourglass shape k; of V tr A [L] and m ω.
#[inline(always)]
pub(super) fn resistance<S: Shape<N, H>, const N: usize, const H: usize>(
    common: &Common,
    dt: f64,
    k: usize,
    (size, critical): (Lanes, Lanes),
) -> (Lanes, Lanes) {
    let (lambda, mu) = (common.answer.lambda, common.answer.mu);
    let bending = match S::SPACE {
        Space::PlaneStrain | Space::Axisymmetric => 4.0 * mu * (lambda + mu) / (lambda + 2.0 * mu) / 24.0,
        Space::PlaneStress => mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu) / 24.0,
        _ => mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu) / 72.0,
    };
    let share = if k < 3 { 1.0 } else { 1.0 / 3.0 };
    match common.hourglass {
        Hourglass::Enhanced(factor) => (size * (factor * bending * share), Lanes::ZERO),
        Hourglass::Stiffness(part) => (size * (2.0 * mu * part), Lanes::ZERO),
        // c q/Δt with c so that a spring c ω would be critical.
        Hourglass::Viscous(part) if dt > 0.0 => (Lanes::ZERO, critical * (part / ((N * N) as f64 * dt))),
        Hourglass::Viscous(_) => (Lanes::ZERO, Lanes::ZERO),
    }
}

/// The forces against one hourglass shape h: with γ = h − X·g, X = Σ h x, they act by γ, so that constant gradients meet none.
/// `kept` are the forces of springs, which turn with the element. They stand for the part of the stress that varies within the
/// element: where the material flows they are `relaxed` by the factor that the deviator is, else they would hold a flowing
/// element up with the stiffness of an elastic one.
#[inline(always)]
pub(super) fn resist<const N: usize, const FUSED: bool>(
    shape: &[f64; N],
    (x, du): (&[Vector; N], &[Vector; N]),
    (geometry, rotation, relaxed): (&Geometry<N>, &Matrix, Lanes),
    (stiffness, damping): (Lanes, Lanes),
    kept: &mut [Lanes],
    (t, out): (&mut Matrix, &mut Batch<N>),
) {
    let (mut place, mut turned) = ([Lanes::ZERO; 3], [Lanes::ZERO; 3]);
    for n in 0..N {
        for i in 0..3 {
            place[i] = place[i].plus_product::<FUSED>(x[n][i], Lanes::splat(shape[n]));
            turned[i] = turned[i].plus_product::<FUSED>(du[n][i], Lanes::splat(shape[n]));
        }
    }
    let last = [kept[0], kept[1], kept[2]];
    for i in 0..3 {
        let (l, r) = (&geometry.gradient[i], &rotation[i]);
        let q = turned[i] - (l[0] * place[0] + l[1] * place[1] + l[2] * place[2]);
        let before = r[0] * last[0] + r[1] * last[1] + r[2] * last[2];
        let now = before.plus_product::<FUSED>(stiffness, q) * relaxed;
        kept[i] = now;
        let force = now.plus_product::<FUSED>(damping, q);
        out.energies[2] += ((before + now) * 0.5).plus_product::<FUSED>(damping, q) * q;
        for j in 0..3 {
            t[i][j] = t[i][j] - force * place[j] * geometry.by;
        }
        for n in 0..N {
            out.forces[n][i] = out.forces[n][i].plus_product::<FUSED>(force, Lanes::splat(shape[n]));
        }
    }
}
