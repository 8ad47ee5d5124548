//! Gradients, volumes and enhanced modes at the integration points.

use super::super::lanes::Lanes;
use super::super::tables::VOLUMETRIC;
use super::{Element, Work};

impl<const N: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, M, D, G, P, A>
{
    /// Fills gradients, weights and volumetric modes of one batch.
    #[inline(always)]
    pub(super) fn geometry<const FUSED: bool>(&self, x: &[Lanes], work: &mut Work<N, M, G, P, A>) {
        let mut central = ([[Lanes::ZERO; D]; D], Lanes::ZERO);
        let mut means = [Lanes::ZERO; 3];
        let mut volumetric_mean = Lanes::ZERO;
        if A > 0 {
            central = cofactors(&jacobian::<FUSED, N, D>(x, &self.tables.central));
            if Self::AXISYMMETRIC {
                (means, volumetric_mean) = self.means(x);
            }
        }
        for p in 0..P {
            let gradients = &self.tables.gradients[p];
            let (cofactor, determinant) = cofactors(&jacobian::<FUSED, N, D>(x, gradients));
            let inverse = Lanes::splat(1.0) / determinant;
            for a in 0..N {
                for i in 0..D {
                    let mut g = cofactor[i][0] * gradients[a][0];
                    for d in 1..D {
                        g = g.plus_product::<FUSED>(cofactor[i][d], Lanes::splat(gradients[a][d]));
                    }
                    work.gradients[p][a][i] = g * inverse;
                }
            }
            let mut weight = determinant * (self.tables.weights[p] * self.factor);
            if Self::AXISYMMETRIC {
                let radius = self.radius(x, p);
                weight = weight * radius;
                for a in 0..N {
                    work.gradients[p][a][2] = Lanes::splat(self.tables.values[p][a]) / radius;
                }
            }
            work.weights[p] = weight;
            for k in 0..M - N {
                let function = (Lanes::splat(self.tables.points[p][k]) - means[k]) * inverse;
                for i in 0..D {
                    work.gradients[p][N + k][i] = central.0[i][k] * function;
                }
            }
            if A > Self::DIRECTIONAL {
                let ratio = central.1 * inverse;
                for v in 0..VOLUMETRIC {
                    let mean = if v == 0 { volumetric_mean } else { Lanes::ZERO };
                    work.volumetric[p][v] = (Lanes::splat(self.tables.volumetric[p][v]) - mean) * ratio;
                }
            }
        }
    }

    #[inline(always)]
    fn radius(&self, x: &[Lanes], p: usize) -> Lanes {
        let mut radius = Lanes::ZERO;
        for a in 0..N {
            radius += x[a * D] * self.tables.values[p][a];
        }
        radius
    }

    /// Σ w r m / Σ w r of the functions ξ, η and ξη: with the Jacobian in the modes' denominator, it cancels.
    #[inline(always)]
    fn means(&self, x: &[Lanes]) -> ([Lanes; 3], Lanes) {
        let (mut means, mut volumetric, mut total) = ([Lanes::ZERO; 3], Lanes::ZERO, Lanes::ZERO);
        for p in 0..P {
            let measure = self.radius(x, p) * self.tables.weights[p];
            total += measure;
            volumetric += measure * self.tables.volumetric[p][0];
            for k in 0..D {
                means[k] += measure * self.tables.points[p][k];
            }
        }
        (means.map(|m| m / total), volumetric / total)
    }
}

/// J_id = ∂x_i/∂ξ_d.
#[inline(always)]
fn jacobian<const FUSED: bool, const N: usize, const D: usize>(
    x: &[Lanes],
    gradients: &[[f64; 3]; N],
) -> [[Lanes; D]; D] {
    let mut j = [[Lanes::ZERO; D]; D];
    for a in 0..N {
        for i in 0..D {
            for d in 0..D {
                j[i][d] = j[i][d].plus_product::<FUSED>(x[a * D + i], Lanes::splat(gradients[a][d]));
            }
        }
    }
    j
}

/// Cofactors (det J · J⁻ᵀ) and determinant of a matrix of order 2 or 3.
#[inline(always)]
fn cofactors<const D: usize>(j: &[[Lanes; D]; D]) -> ([[Lanes; D]; D], Lanes) {
    let mut c = [[Lanes::ZERO; D]; D];
    for a in 0..D {
        for b in 0..D {
            let (a1, b1) = ((a + 1) % D, (b + 1) % D);
            c[a][b] = if D == 2 {
                if a == b { j[a1][b1] } else { -j[a1][b1] }
            } else {
                let (a2, b2) = ((a + 2) % D, (b + 2) % D);
                j[a1][b1] * j[a2][b2] - j[a1][b2] * j[a2][b1]
            };
        }
    }
    let mut determinant = j[0][0] * c[0][0];
    for d in 1..D {
        determinant += j[0][d] * c[0][d];
    }
    (c, determinant)
}
