//! The internal parameters: their rows of the stiffness, and their elimination.

use super::{Element, Work};
use crate::lanes::Lanes;

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    /// Stores the block of pseudo-node `a` with carrier or pseudo-node `b`.
    #[inline(always)]
    pub(super) fn keep(&self, work: &mut Work<N, R, M, D, G, P, A>, a: usize, b: usize, block: &[[Lanes; D]; D]) {
        let row = (a - R) * D;
        for i in 0..D {
            for j in 0..D {
                if b < R {
                    work.coupling[b * D + j][row + i] = block[i][j];
                } else {
                    work.inner[row + i][(b - R) * D + j] = block[i][j];
                }
            }
        }
    }

    /// Rows of the volumetric modes: their stress is κ m 1 with κ = n λ + 2 μ, n directions of unit strain.
    #[inline(always)]
    pub(super) fn volumetric_rows<const FUSED: bool>(&self, work: &mut Work<N, R, M, D, G, P, A>) {
        let n = if G == 3 { 3.0 } else { 2.0 };
        let modulus = n * self.lambda + 2.0 * self.mu;
        for v in 0..A - Self::DIRECTIONAL {
            let mut weighted = [Lanes::ZERO; P];
            for p in 0..P {
                weighted[p] = work.volumetric[p][v] * work.weights[p] * modulus;
            }
            for b in 0..M {
                for j in 0..D {
                    let mut sum = Lanes::ZERO;
                    for p in 0..P {
                        let g = &work.gradients[p][b];
                        let trace = if Self::AXISYMMETRIC && j == 0 { g[0] + g[2] } else { g[j] };
                        sum = sum.plus_product::<FUSED>(weighted[p], trace);
                    }
                    if b < R {
                        work.coupling[b * D + j][Self::DIRECTIONAL + v] = sum;
                    } else {
                        work.inner[Self::DIRECTIONAL + v][(b - R) * D + j] = sum;
                    }
                }
            }
            for other in 0..=v {
                let mut sum = Lanes::ZERO;
                for p in 0..P {
                    sum = sum.plus_product::<FUSED>(weighted[p], work.volumetric[p][other]);
                }
                work.inner[Self::DIRECTIONAL + v][Self::DIRECTIONAL + other] = sum * n;
            }
        }
    }

    /// K − Wᵀ D⁻¹ W into `lower`; leaves L and 1/D in `inner`, and Wᵀ in `coupling`.
    #[inline(always)]
    pub(super) fn condense<const FUSED: bool>(&self, work: &mut Work<N, R, M, D, G, P, A>, lower: &mut [Lanes]) {
        factorize::<FUSED, A>(&mut work.inner);
        for row in &mut work.coupling {
            for l in 0..A {
                let known = -row[l];
                for k in l + 1..A {
                    row[k] = row[k].plus_product::<FUSED>(known, work.inner[k][l]);
                }
            }
        }
        let mut places = lower.chunks_exact_mut(D * D);
        for rows in (0..R).map(|a| &work.coupling[a * D..(a + 1) * D]) {
            let mut negative = [[Lanes::ZERO; A]; D];
            for i in 0..D {
                for k in 0..A {
                    negative[i][k] = -(rows[i][k] * work.inner[k][k]);
                }
            }
            for columns in work.coupling.chunks_exact(D) {
                let place = places.next().expect("one place a lower block");
                let mut block = [[Lanes::ZERO; D]; D];
                for i in 0..D {
                    block[i].copy_from_slice(&place[i * D..(i + 1) * D]);
                }
                for k in 0..A {
                    for i in 0..D {
                        for j in 0..D {
                            block[i][j] = block[i][j].plus_product::<FUSED>(negative[i][k], columns[j][k]);
                        }
                    }
                }
                for i in 0..D {
                    place[i * D..(i + 1) * D].copy_from_slice(&block[i]);
                }
                if std::ptr::eq(columns.as_ptr(), rows.as_ptr()) {
                    break;
                }
            }
        }
    }

    /// Internal parameters that movements of the carriers bring about: α = −L⁻ᵀ D⁻¹ W u.
    #[inline(always)]
    pub(super) fn parameters<const FUSED: bool>(u: &[[Lanes; D]; R], work: &Work<N, R, M, D, G, P, A>) -> [Lanes; A] {
        let mut alpha = [Lanes::ZERO; A];
        for (row, &u) in work.coupling.iter().zip(u.as_flattened()) {
            for k in 0..A {
                alpha[k] = alpha[k].plus_product::<FUSED>(row[k], -u);
            }
        }
        for k in 0..A {
            alpha[k] = alpha[k] * work.inner[k][k];
        }
        for k in (0..A).rev() {
            for l in 0..k {
                alpha[l] = alpha[l].plus_product::<FUSED>(-work.inner[k][l], alpha[k]);
            }
        }
        alpha
    }
}

/// L of L D Lᵀ below the diagonal, 1/D on it, in place of the lower triangle.
#[inline(always)]
fn factorize<const FUSED: bool, const A: usize>(matrix: &mut [[Lanes; A]; A]) {
    for l in 0..A {
        let inverse = Lanes::splat(1.0) / matrix[l][l];
        for i in l + 1..A {
            let factor = -(matrix[i][l] * inverse);
            for j in l + 1..=i {
                matrix[i][j] = matrix[i][j].plus_product::<FUSED>(factor, matrix[j][l]);
            }
        }
        for i in l + 1..A {
            matrix[i][l] = matrix[i][l] * inverse;
        }
        matrix[l][l] = inverse;
    }
}
