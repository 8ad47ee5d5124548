//! Elements of the plane with one integration point: polygons.

use super::shape::{Shape, Vector};
use crate::element::Space;
use crate::lanes::Lanes;
use std::f64::consts::PI;

/// CPE4R and CPE3, or with `STRESS` CPS4R and CPS3.
#[derive(Debug)]
pub(super) struct Plane<const STRESS: bool>;

/// CAX4R and CAX3: integrals over the circumference, exact, so that ∂V/∂x_a is conjugate to the volume, and a motion along the
/// axis meets no force.
#[derive(Debug)]
pub(super) struct Ring;

const SQUARE: [[f64; 4]; 1] = [[1.0, -1.0, 1.0, -1.0]];

impl<const STRESS: bool> Shape<4, 1> for Plane<STRESS> {
    const SPACE: Space = if STRESS { Space::PlaneStress } else { Space::PlaneStrain };
    const HOURGLASS: [[f64; 4]; 1] = SQUARE;

    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 4]) -> [Vector; 4] {
        polygon(x)
    }
}

impl<const STRESS: bool> Shape<3, 0> for Plane<STRESS> {
    const SPACE: Space = if STRESS { Space::PlaneStress } else { Space::PlaneStrain };
    const HOURGLASS: [[f64; 3]; 0] = [];

    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 3]) -> [Vector; 3] {
        polygon(x)
    }
}

impl Shape<4, 1> for Ring {
    const SPACE: Space = Space::Axisymmetric;
    const HOURGLASS: [[f64; 4]; 1] = SQUARE;

    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 4]) -> [Vector; 4] {
        ring(x, &<Self as Shape<4, 1>>::hoop(x))
    }

    /// 2π (A/6 + c_a/12), c_a the cross product of the edges at the corner: linear in the corner's Jacobian.
    #[inline(always)]
    fn hoop(x: &[Vector; 4]) -> [Lanes; 4] {
        let corner: [Lanes; 4] = std::array::from_fn(|a| corner(x, a));
        // Both pairs of opposite triangles fill the square.
        let whole = (corner[0] + corner[1] + corner[2] + corner[3]) * (PI / 12.0);
        corner.map(|c| whole + c * (PI / 6.0))
    }

    fn shares(x: &[Vector; 4]) -> [Lanes; 4] {
        shares(x, &<Self as Shape<4, 1>>::hoop(x), 0.5)
    }
}

impl Shape<3, 0> for Ring {
    const SPACE: Space = Space::Axisymmetric;
    const HOURGLASS: [[f64; 3]; 0] = [];

    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 3]) -> [Vector; 3] {
        ring(x, &<Self as Shape<3, 0>>::hoop(x))
    }

    /// 2π A/3.
    #[inline(always)]
    fn hoop(x: &[Vector; 3]) -> [Lanes; 3] {
        [corner(x, 0) * (PI / 3.0); 3]
    }

    fn shares(x: &[Vector; 3]) -> [Lanes; 3] {
        shares(x, &<Self as Shape<3, 0>>::hoop(x), 1.0)
    }
}

/// Cross product of the edges at a corner: twice the area of the triangle there.
#[inline(always)]
fn corner<const N: usize>(x: &[Vector; N], a: usize) -> Lanes {
    let (p, last, next) = (&x[a], &x[(a + N - 1) % N], &x[(a + 1) % N]);
    (next[0] - p[0]) * (last[1] - p[1]) - (next[1] - p[1]) * (last[0] - p[0])
}

/// ∂A/∂x_a of the corners.
#[inline(always)]
fn polygon<const N: usize>(x: &[Vector; N]) -> [Vector; N] {
    std::array::from_fn(|a| {
        let (last, next) = (&x[(a + N - 1) % N], &x[(a + 1) % N]);
        [(next[1] - last[1]) * 0.5, (last[0] - next[0]) * 0.5, Lanes::ZERO]
    })
}

/// ∂V/∂x_a of the corners, less the `hoop` part: V = π/3 Σ (z_b − z_a)(r_a² + r_a r_b + r_b²) over the edges.
#[inline(always)]
fn ring<const N: usize>(x: &[Vector; N], hoop: &[Lanes; N]) -> [Vector; N] {
    let of_edge = |a: &Vector, b: &Vector| a[0] * a[0] + a[0] * b[0] + b[0] * b[0];
    std::array::from_fn(|a| {
        let (p, last, next) = (&x[a], &x[(a + N - 1) % N], &x[(a + 1) % N]);
        let outward = (p[1] - last[1]) * (p[0] * 2.0 + last[0]) + (next[1] - p[1]) * (p[0] * 2.0 + next[0]);
        let along = of_edge(last, p) - of_edge(p, next);
        [outward * (PI / 3.0) - hoop[a], along * (PI / 3.0), Lanes::ZERO]
    })
}

/// Parts of ∫N_a dV, as ∫N_a dA (r_a + k Σr): exact in triangles (k = 1) and rectangles (k = ½).
fn shares<const N: usize>(x: &[Vector; N], hoop: &[Lanes; N], k: f64) -> [Lanes; N] {
    let sum = x.iter().fold(Lanes::ZERO, |sum, x| sum + x[0]);
    let parts: [Lanes; N] = std::array::from_fn(|a| hoop[a] * (x[a][0] + sum * k));
    let whole = parts.iter().fold(Lanes::ZERO, |sum, &part| sum + part);
    parts.map(|part| part / whole)
}
