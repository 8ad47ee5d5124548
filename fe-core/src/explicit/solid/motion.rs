//! How an increment moves and turns the surroundings of a point.
//!
//! # Finite strain
//!
//! An increment is cut in the middle (Hughes and Winget, Int. J. Numer. Meth. Eng. 15 (1980) 1862): with G the gradient of
//! the displacement increment by the place in the middle of it, ε = sym G is the strain, exactly 0 in a rigid rotation, and
//! Q = (1 − W/2)⁻¹ (1 + W/2), W = skew G, the rotation, exactly orthogonal. Along fixed axes ε sums to the logarithmic strain,
//! to the square of the increments. Cauchy stress turns with Q and grows with ε, half of it before and half after; forces on the nodes are f = ∫ σ ∇N dv over
//! where the element is *now*, which takes from the motion the work ∫ σ : ε dv.
//!
//! Hyperelastic materials know the whole motion instead: F⁻¹ = ∂X/∂x = Σ X ⊗ ∇N with the gradients of now and the places of
//! the start gives F, and that the stress; nothing is summed up.
//!
//! All of it is asked of a state and an increment to the next one, so a method that looks for equilibrium at the end of an
//! increment can ask the same: with the derivative of σ by ε turned likewise (the material's part of its stiffness) and
//! ∫ ∇Nᵀ σ ∇N dv (the part of the geometry).

use crate::lanes::Lanes;

/// Symmetric tensors: xx, yy, zz, xy, yz, zx.
pub(super) type Symmetric = [Lanes; 6];
pub(super) type Matrix = [[Lanes; 3]; 3];

/// The motion of an increment at a point.
#[derive(Clone, Copy)]
pub(super) struct Motion {
    /// Strain ε.
    pub strain: Symmetric,
    /// Rotation Q.
    pub rotation: Matrix,
}

impl Motion {
    /// From L = ∂Δu/∂x₁, the gradient by the place at the end of the increment: G = L (1 − L/2)⁻¹.
    #[inline(always)]
    pub fn new(l: &Matrix) -> Self {
        let half = Lanes::splat(-0.5);
        let mut m = [[Lanes::ZERO; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] = l[i][j] * half;
            }
            m[i][i] += Lanes::splat(1.0);
        }
        let g = times(l, &inverse(&m).0);
        let (two, half) = (Lanes::splat(2.0), Lanes::splat(0.5));
        let shear = |i: usize, j: usize| (g[i][j] + g[j][i]) * half;
        let strain = [g[0][0], g[1][1], g[2][2], shear(0, 1), shear(1, 2), shear(2, 0)];
        // Q = 1 + (W + W²/2)/(1 + ω²/4), W x = ω × x.
        let w = [(g[2][1] - g[1][2]) * half, (g[0][2] - g[2][0]) * half, (g[1][0] - g[0][1]) * half];
        let square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        let by = Lanes::splat(1.0) / (Lanes::splat(1.0) + square * 0.25);
        let (by, by_half) = (by, by / two);
        let mut q = [[Lanes::ZERO; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                q[i][j] = w[i] * w[j] * by_half;
            }
            q[i][i] += Lanes::splat(1.0) - square * by_half;
        }
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            q[i][j] = q[i][j] - w[k] * by;
            q[j][i] += w[k] * by;
        }
        Motion { strain, rotation: q }
    }

    /// Strain of the volume.
    #[inline(always)]
    pub fn opened(&self) -> Lanes {
        self.strain[0] + self.strain[1] + self.strain[2]
    }
}

/// Q s Qᵀ.
#[inline(always)]
pub(super) fn rotated<const FUSED: bool>(q: &Matrix, s: &Symmetric) -> Symmetric {
    let half = times(q, &full(s));
    let entry = |i: usize, j: usize| {
        (half[i][0] * q[j][0]).plus_product::<FUSED>(half[i][1], q[j][1]).plus_product::<FUSED>(half[i][2], q[j][2])
    };
    [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)]
}

#[inline(always)]
pub(super) fn full(s: &Symmetric) -> Matrix {
    [[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]]
}

#[inline(always)]
pub(super) fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let mut out = [[Lanes::ZERO; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
    out
}

/// The inverse, and the determinant.
#[inline(always)]
pub(super) fn inverse(m: &Matrix) -> (Matrix, Lanes) {
    let mut out = [[Lanes::ZERO; 3]; 3];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for a in 0..3 {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            out[a][i] = m[j][b] * m[k][c] - m[j][c] * m[k][b];
        }
    }
    let determinant = m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0];
    let by = Lanes::splat(1.0) / determinant;
    out.iter_mut().flatten().for_each(|entry| *entry = *entry * by);
    (out, determinant)
}
