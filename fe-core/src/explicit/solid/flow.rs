//! Stress at one point of eight elements that move on by an increment: large displacements and rotations, with
//! isotropic elasticity between Cauchy stress and the strain of the increment, and plasticity after von Mises.
//!
//! The increment is cut in the middle (Hughes and Winget, Int. J. Numer. Meth. Eng. 15 (1980) 1862): with G the gradient of
//! the displacement increment by the place in the middle of it, ε = sym G is the strain, exactly 0 in a rigid rotation, and
//! Q = (1 − W/2)⁻¹ (1 + W/2), W = skew G, the rotation, exactly orthogonal: σ₁ = Q σ₀ Qᵀ + C : ε. For plastic flow follows the
//! radial return to the yield surface.

use crate::lanes::Lanes;
use crate::material::Hardening;

/// Symmetric tensors: xx, yy, zz, xy, yz, zx.
pub(super) type Symmetric = [Lanes; 6];
pub(super) type Matrix = [[Lanes; 3]; 3];

/// Moduli and yield stress of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Flow {
    /// Lamé's first constant λ [F/L²].
    pub lambda: f64,
    /// Shear modulus μ [F/L²].
    pub mu: f64,
    /// Yield stress over plastic strain; `None`: elastic.
    pub hardening: Option<Hardening>,
}

/// The motion of an increment at a point.
pub(super) struct Moved {
    /// Strain ε.
    pub strain: Symmetric,
    /// Rotation Q.
    pub rotation: Matrix,
}

/// What an increment did at a point, per volume [F/L²].
pub(super) struct Work {
    /// All of it: mean stress times strain.
    pub all: Lanes,
    /// Of that, into plastic flow.
    pub plastic: Lanes,
}

/// The motion from L = ∂Δu/∂x₁, the gradient by the place at the end of the increment: G = L (1 − L/2)⁻¹.
#[inline(always)]
pub(super) fn moved(l: &Matrix) -> Moved {
    let half = Lanes::splat(-0.5);
    let mut m = [[Lanes::ZERO; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            m[i][j] = l[i][j] * half;
        }
        m[i][i] += Lanes::splat(1.0);
    }
    let g = times(l, &inverse(&m));
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
    Moved { strain, rotation: q }
}

impl Flow {
    /// Moves stress and equivalent plastic strain on.
    #[inline(always)]
    pub(super) fn advance<const FUSED: bool>(&self, by: &Moved, stress: &mut Symmetric, plastic: &mut Lanes) -> Work {
        let before = rotated::<FUSED>(&by.rotation, stress);
        let e = &by.strain;
        let volumetric = (e[0] + e[1] + e[2]) * self.lambda;
        let mut now = before;
        for i in 0..3 {
            now[i] = (before[i] + volumetric).plus_product::<FUSED>(Lanes::splat(2.0 * self.mu), e[i]);
            now[i + 3] = before[i + 3].plus_product::<FUSED>(Lanes::splat(2.0 * self.mu), e[i + 3]);
        }
        let flowed = match &self.hardening {
            None => Lanes::ZERO,
            Some(hardening) => self.flow::<FUSED>(hardening, &mut now, plastic),
        };
        let mut all = Lanes::ZERO;
        for i in 0..6 {
            let mean = (before[i] + now[i]) * if i < 3 { 0.5 } else { 1.0 };
            all = all.plus_product::<FUSED>(mean, e[i]);
        }
        *stress = now;
        Work { all, plastic: flowed }
    }

    /// Takes the stress back to the yield surface; the energy that this dissipates.
    #[inline(always)]
    fn flow<const FUSED: bool>(&self, hardening: &Hardening, s: &mut Symmetric, plastic: &mut Lanes) -> Lanes {
        let p = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
        let d = [s[0] - p, s[1] - p, s[2] - p, s[3], s[4], s[5]];
        let mut square = Lanes::ZERO;
        for i in 0..3 {
            square = square.plus_product::<FUSED>(d[i], d[i]).plus_product::<FUSED>(d[i + 3] * 2.0, d[i + 3]);
        }
        let trial = (square * 1.5 + Lanes::splat(f64::MIN_POSITIVE)).sqrt();
        let added = self.added(hardening, trial, *plastic);
        let left = trial - added * (3.0 * self.mu);
        *plastic += added;
        let kept = left / trial;
        for i in 0..3 {
            s[i] = p + d[i] * kept;
            s[i + 3] = d[i + 3] * kept;
        }
        left * added
    }

    /// Plastic strain Δp ≥ 0 after which q − 3μ Δp is the yield stress at p + Δp. Both are straight between the rows: from row
    /// to row on, that solution counts which lies beyond the row.
    #[inline(always)]
    fn added(&self, hardening: &Hardening, trial: Lanes, p: Lanes) -> Lanes {
        let mut added = Lanes::ZERO;
        for (i, &(from, yield_stress)) in hardening.points.iter().enumerate() {
            let slope = hardening.points.get(i + 1).map_or(0.0, |next| (next.1 - yield_stress) / (next.0 - from));
            let beyond = trial - Lanes::splat(yield_stress) - (p - Lanes::splat(from)) * slope;
            let solution = beyond * (1.0 / (3.0 * self.mu + slope));
            // At least as far as the row itself.
            let counts = if i == 0 { solution } else { p + solution - Lanes::splat(from) };
            added = solution.where_positive(counts, added);
        }
        added.max(Lanes::ZERO)
    }
}

/// Q s Qᵀ.
#[inline(always)]
fn rotated<const FUSED: bool>(q: &Matrix, s: &Symmetric) -> Symmetric {
    let full = [[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]];
    let half = times(q, &full);
    let entry = |i: usize, j: usize| {
        (half[i][0] * q[j][0]).plus_product::<FUSED>(half[i][1], q[j][1]).plus_product::<FUSED>(half[i][2], q[j][2])
    };
    [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)]
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

#[inline(always)]
fn inverse(m: &Matrix) -> Matrix {
    let mut out = [[Lanes::ZERO; 3]; 3];
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        for a in 0..3 {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            out[a][i] = m[j][b] * m[k][c] - m[j][c] * m[k][b];
        }
    }
    let by = Lanes::splat(1.0) / (m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0]);
    out.iter_mut().flatten().for_each(|entry| *entry = *entry * by);
    out
}
