//! Gradients, volumes and enhanced modes at the integration points.

use super::super::tables::PRODUCTS;
use super::{Element, Work};
use crate::lanes::Lanes;

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    /// Fills gradients, weights and volumetric modes of one batch.
    #[inline(always)]
    pub(super) fn geometry<const FUSED: bool>(&self, x: &[Lanes], work: &mut Work<N, R, M, D, G, P, A>) {
        let nodes: &[[Lanes; D]; N] = x.as_chunks().0.try_into().expect("D coordinates a node");
        let mut constant = [[Lanes::ZERO; D]; D]; // of the Jacobian matrix
        let mut central = (constant, Lanes::ZERO);
        let mut means = [Lanes::ZERO; 3];
        let mut volumetric_mean = Lanes::ZERO;
        if A > 0 {
            let jacobian = jacobian::<FUSED, N, D>([[Lanes::ZERO; D]; D], nodes, &self.tables.central);
            central = cofactors(&jacobian);
            if Self::AXISYMMETRIC {
                (means, volumetric_mean) = self.means(x);
            }
            if Self::REDUCED {
                constant = jacobian;
            }
        }
        let carriers = self.carriers::<FUSED>(nodes);
        for p in 0..P {
            let gradients = self.carrier_gradients(p);
            let (cofactor, determinant) = cofactors(&jacobian::<FUSED, R, D>(constant, &carriers, gradients));
            let inverse = Lanes::splat(1.0) / determinant;
            for a in 0..R {
                let gradient = transformed::<FUSED, D>(&cofactor, &gradients[a]);
                for i in 0..D {
                    work.gradients[p][a][i] = gradient[i] * inverse;
                }
            }
            let mut weight = determinant * (self.tables.weights[p] * self.factor);
            if Self::AXISYMMETRIC {
                let radius = self.radius(x, p);
                weight = weight * radius;
                for a in 0..R {
                    work.gradients[p][a][2] = Lanes::splat(self.tables.values[p][a]) / radius;
                }
            }
            work.weights[p] = weight;
            for k in 0..M - R {
                let function = (Lanes::splat(self.tables.points[p][k]) - means[k]) * inverse;
                for i in 0..D {
                    work.gradients[p][R + k][i] = central.0[i][k] * function;
                }
            }
            if A > Self::DIRECTIONAL {
                let ratio = central.1 * inverse;
                for v in 0..PRODUCTS {
                    let mean = if v == 0 { volumetric_mean } else { Lanes::ZERO };
                    work.volumetric[p][v] = (Lanes::splat(self.tables.products[p][v]) - mean) * ratio;
                }
            }
        }
        if Self::REDUCED {
            self.uniform_part::<FUSED>(&central, &carriers, work);
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
            volumetric += measure * self.tables.products[p][0];
            for k in 0..D {
                means[k] += measure * self.tables.points[p][k];
            }
        }
        (means.map(|m| m / total), volumetric / total)
    }
}

/// J_id = ∂x_i/∂ξ_d, added to `j`.
#[inline(always)]
fn jacobian<const FUSED: bool, const R: usize, const D: usize>(
    mut j: [[Lanes; D]; D],
    x: &[[Lanes; D]; R],
    gradients: &[[f64; 3]],
) -> [[Lanes; D]; D] {
    for a in 0..R {
        for i in 0..D {
            for d in 0..D {
                j[i][d] = j[i][d].plus_product::<FUSED>(x[a][i], Lanes::splat(gradients[a][d]));
            }
        }
    }
    j
}

/// C ∂/∂ξ.
#[inline(always)]
pub(super) fn transformed<const FUSED: bool, const D: usize>(c: &[[Lanes; D]; D], gradient: &[f64; 3]) -> [Lanes; D] {
    let mut out = [Lanes::ZERO; D]; // closures of array functions are not inlined into the instruction set
    for i in 0..D {
        for d in 0..D {
            out[i] = out[i].plus_product::<FUSED>(c[i][d], Lanes::splat(gradient[d]));
        }
    }
    out
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
