//! Hyperelasticity of [`NeoHooke`] in eight elements.

use super::motion::{Matrix, Symmetric, inverse};
use crate::lanes::Lanes;
use crate::material::NeoHooke;

/// Cauchy stress from F⁻¹, σ = 2 C₁₀/J dev b̄ + 2 (J − 1)/D₁ with b̄ = J^(−2/3) F Fᵀ, and what λ and μ do not exceed.
///
/// The second derivative of the energy of the undeformed volume along x → (1 + h) x is, with t = tr h, b = F Fᵀ and its deviator d,
/// C₁₀ J^(−2/3) [2 h b : h + ⅔ tr b h : hᵀ − (4/9) tr b t² − (8/3) t d : h] + 2 J/D₁ [(2J − 1) t² − (J − 1) h : hᵀ].
/// With h : hᵀ ≤ |h|², m = tr b/3, δ = √(2/3) |d|, largest eigenvalue of b at most m + δ, and (8/3) |t d : h| ≤
/// (4/9) tr b s t² + 4 |d|²/(s tr b) |h|² for s = δ/2m, that is at most 2μ |h|² + λ t², where
/// 2μ = C₁₀ J^(−2/3) (4m + 6δ) + 2 J |J − 1|/D₁ and λ = C₁₀ J^(−2/3) (2δ − 4m)/3 + 2 J (2J − 1)/D₁; over J for the present volume.
/// At F = 1 these are the constants of small strains.
#[inline(always)]
pub(super) fn stress(material: &NeoHooke, backward: &Matrix) -> (Symmetric, [Lanes; 2]) {
    let (f, contraction) = inverse(backward);
    let one = Lanes::splat(1.0);
    let j = one / contraction;
    let b = |i: usize, k: usize| f[i][0] * f[k][0] + f[i][1] * f[k][1] + f[i][2] * f[k][2];
    let mut d = [b(0, 0), b(1, 1), b(2, 2), b(0, 1), b(1, 2), b(2, 0)];
    let mean = (d[0] + d[1] + d[2]) * (1.0 / 3.0);
    (0..3).for_each(|i| d[i] = d[i] - mean);
    let factor = j.map(|j| material.c10 * j.powf(-5.0 / 3.0));
    let pressure = (j - one) * (2.0 / material.d1);
    let mut stress = d.map(|d| d * factor * 2.0);
    (0..3).for_each(|i| stress[i] += pressure);

    let mut square = Lanes::ZERO;
    for i in 0..3 {
        square += d[i] * d[i] + d[i + 3] * d[i + 3] * 2.0;
    }
    let apart = (square * (2.0 / 3.0)).sqrt();
    let opened = (j - one).max(one - j);
    let mu = factor * (mean * 2.0 + apart * 3.0) + opened * (1.0 / material.d1);
    let lambda = factor * (apart * 2.0 - mean * 4.0) * (1.0 / 3.0) + (j * 2.0 - one) * (2.0 / material.d1);
    (stress, [lambda, mu])
}

/// Stretch λ across a plane with the in-plane part of F⁻¹ that leaves no stress there: with the area's J₂ and the trace I of the
/// in-plane part of b, ∂W/∂λ = 2 C₁₀ J₂^(−2/3) (2 λ^(1/3) − I λ^(−5/3))/3 + 2 J₂ (J₂ λ − 1)/D₁ = 0, by Newton from the last one.
#[inline(always)]
pub(super) fn stretch_across(material: &NeoHooke, backward: &Matrix, last: Lanes) -> Lanes {
    let m = backward;
    let area = Lanes::splat(1.0) / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    let mut trace = Lanes::ZERO;
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        trace += m[i][j] * m[i][j] * area * area;
    }
    let mut out = last;
    for lane in 0..out.0.len() {
        let (area, trace) = (area.0[lane], trace.0[lane]);
        let (shear, bulk) = (2.0 / 3.0 * material.c10 * area.powf(-2.0 / 3.0), 2.0 / material.d1 * area);
        let stretch = &mut out.0[lane];
        for _ in 0..MOST {
            let root = stretch.cbrt();
            let fifth = trace / (root * root * *stretch);
            let force = shear * (2.0 * root - fifth) + bulk * (area * *stretch - 1.0);
            let slope = shear * (2.0 * root + 5.0 * fifth) / (3.0 * *stretch) + bulk * area;
            let next = (*stretch - force / slope).max(0.5 * *stretch);
            let step = (next - *stretch).abs();
            *stretch = next;
            if step <= 1e-15 * next {
                break;
            }
        }
    }
    out
}

/// Iterations at most: Newton takes three or four.
const MOST: usize = 50;
