//! Elements with one integration point: the integrals of their shape functions' gradients, and what these do not see.

use super::motion::Matrix;
use crate::element::Space;
use crate::lanes::Lanes;

pub(super) type Vector = [Lanes; 3];

/// An element with `N` nodes and `H` hourglass shapes, nodal values that belong to no constant gradient.
pub(super) trait Shape<const N: usize, const H: usize>: std::fmt::Debug + Send + Sync {
    /// The space it lives in; elements of a plane are of thickness 1 here, axis and radius stand as in [`Space::Axisymmetric`].
    const SPACE: Space;

    /// The hourglass shapes.
    const HOURGLASS: [[f64; N]; H];

    /// ∫∇N_a dV of each node, exact on any shape: constant stresses pass the patch test.
    fn gradients<const FUSED: bool>(x: &[Vector; N]) -> [Vector; N];

    /// ∫N_a/r dV of each node [L²], axisymmetric; with it ∂V/∂r_a = ∫∂N_a/∂r dV + ∫N_a/r dV.
    #[inline(always)]
    fn hoop(_x: &[Vector; N]) -> [Lanes; N] {
        [Lanes::ZERO; N]
    }

    /// Parts of the mass that the nodes have [-].
    fn shares(_x: &[Vector; N]) -> [Lanes; N] {
        [Lanes::splat(1.0 / N as f64); N]
    }
}

/// C3D8R.
#[derive(Debug)]
pub(super) struct Hexahedron;

/// C3D4.
#[derive(Debug)]
pub(super) struct Tetrahedron;

/// The first four corners; the others lie opposite.
const CORNERS: [[f64; 3]; 4] = [[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0], [1.0, 1.0, -1.0], [-1.0, 1.0, -1.0]];
const OPPOSITE: [usize; 4] = [6, 7, 4, 5];

impl Shape<8, 4> for Hexahedron {
    const SPACE: Space = Space::Solid;

    /// ηζ, ζξ, ξη, ξηζ at the corners.
    const HOURGLASS: [[f64; 8]; 4] = [
        [1.0, 1.0, -1.0, -1.0, -1.0, -1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0],
        [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0],
        [-1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0, -1.0],
    ];

    /// With x = Σ a_i ξ_i + h₁ ηζ + h₂ ζξ + h₃ ξη + h₄ ξηζ (and a constant), the integral over the cube of
    /// (∂x/∂ξ_j × ∂x/∂ξ_k) ∂N_a/∂ξ_i, summed over i, is ξ_a·P + R over the products of two coordinates of the corner:
    /// P_i = a_j × a_k + h_k × h_j/3 for cyclic i, j, k, and from direction i come (a_j × h_i + h_k × h₄/3)/3 with ξ_iξ_j and
    /// (h_i × a_k + h₄ × h_j/3)/3 with ξ_iξ_k.
    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 8]) -> [Vector; 8] {
        let (mut apart, mut middle) = ([[Lanes::ZERO; 3]; 4], [[Lanes::ZERO; 3]; 4]);
        for n in 0..4 {
            for c in 0..3 {
                apart[n][c] = (x[n][c] - x[OPPOSITE[n]][c]) * 0.125;
                middle[n][c] = (x[n][c] + x[OPPOSITE[n]][c]) * 0.125;
            }
        }
        let sum = |of: &[Vector; 4], sign: [f64; 4]| {
            let mut out = [Lanes::ZERO; 3];
            for c in 0..3 {
                out[c] = of[0][c] * sign[0] + of[1][c] * sign[1] + of[2][c] * sign[2] + of[3][c] * sign[3];
            }
            out
        };
        let (mut a, mut h) = ([[Lanes::ZERO; 3]; 3], [[Lanes::ZERO; 3]; 3]);
        for i in 0..3 {
            a[i] = sum(&apart, [CORNERS[0][i], CORNERS[1][i], CORNERS[2][i], CORNERS[3][i]]);
            let s = &Self::HOURGLASS[i];
            h[i] = sum(&middle, [s[0], s[1], s[2], s[3]]);
        }
        let s = &Self::HOURGLASS[3];
        let last = sum(&apart, [s[0], s[1], s[2], s[3]]);
        let (mut p, mut r) = ([[Lanes::ZERO; 3]; 3], [[Lanes::ZERO; 3]; 3]);
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            p[i] = crosses::<FUSED>(&a[j], &a[k], &h[k], &h[j], 1.0);
            // ξ_i ξ_j is the shape k, ξ_i ξ_k the shape j.
            let first = crosses::<FUSED>(&a[j], &h[i], &h[k], &last, 1.0 / 3.0);
            let second = crosses::<FUSED>(&h[i], &a[k], &last, &h[j], 1.0 / 3.0);
            for c in 0..3 {
                r[k][c] += first[c];
                r[j][c] += second[c];
            }
        }
        let mut out = [[Lanes::ZERO; 3]; 8];
        for n in 0..4 {
            let odd = sum3(&p, CORNERS[n]);
            let even = sum3(&r, [Self::HOURGLASS[0][n], Self::HOURGLASS[1][n], Self::HOURGLASS[2][n]]);
            for c in 0..3 {
                out[n][c] = even[c] + odd[c];
                out[OPPOSITE[n]][c] = even[c] - odd[c];
            }
        }
        out
    }
}

impl Shape<4, 0> for Tetrahedron {
    const SPACE: Space = Space::Solid;
    const HOURGLASS: [[f64; 4]; 0] = [];

    /// A sixth of the cross products of edges.
    #[inline(always)]
    fn gradients<const FUSED: bool>(x: &[Vector; 4]) -> [Vector; 4] {
        let mut edges: Matrix = [[Lanes::ZERO; 3]; 3];
        for n in 0..3 {
            for c in 0..3 {
                edges[n][c] = x[n + 1][c] - x[0][c];
            }
        }
        let mut out = [[Lanes::ZERO; 3]; 4];
        for n in 0..3 {
            let normal = cross(&edges[(n + 1) % 3], &edges[(n + 2) % 3]);
            for c in 0..3 {
                out[n + 1][c] = normal[c] * (1.0 / 6.0);
                out[0][c] = out[0][c] - out[n + 1][c];
            }
        }
        out
    }
}

#[inline(always)]
fn sum3(of: &[Vector; 3], sign: [f64; 3]) -> Vector {
    let mut out = [Lanes::ZERO; 3];
    for c in 0..3 {
        out[c] = of[0][c] * sign[0] + of[1][c] * sign[1] + of[2][c] * sign[2];
    }
    out
}

/// (a × b + c × d/3) · factor.
#[inline(always)]
fn crosses<const FUSED: bool>(a: &Vector, b: &Vector, c: &Vector, d: &Vector, factor: f64) -> Vector {
    let (first, second) = (cross(a, b), cross(c, d));
    let mut out = [Lanes::ZERO; 3];
    for i in 0..3 {
        out[i] = first[i].plus_product::<FUSED>(second[i], Lanes::splat(1.0 / 3.0)) * factor;
    }
    out
}

#[inline(always)]
fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
