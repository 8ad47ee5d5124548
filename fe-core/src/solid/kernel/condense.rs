//! The internal parameters: their rows of the stiffness, and their elimination.

use super::super::lanes::Lanes;
use super::{Element, Work};

impl<const N: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, M, D, G, P, A>
{
    /// Stores the block of pseudo-node `a` with node or pseudo-node `b`.
    #[inline(always)]
    pub(super) fn keep(&self, work: &mut Work<N, M, G, P, A>, a: usize, b: usize, block: &[[Lanes; D]; D]) {
        let row = (a - N) * D;
        for i in 0..D {
            for j in 0..D {
                if b < N {
                    work.coupling[b * D + j][row + i] = block[i][j];
                } else {
                    work.inner[row + i][(b - N) * D + j] = block[i][j];
                }
            }
        }
    }

    /// Rows of the volumetric modes: their stress is κ m 1 with κ = n λ + 2 μ, n directions of unit strain.
    #[inline(always)]
    pub(super) fn volumetric_rows<const FUSED: bool>(&self, work: &mut Work<N, M, G, P, A>) {
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
                    if b < N {
                        work.coupling[b * D + j][Self::DIRECTIONAL + v] = sum;
                    } else {
                        work.inner[Self::DIRECTIONAL + v][(b - N) * D + j] = sum;
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

    /// K − Wᵀ W into `lower`; leaves L in `inner` (its diagonal inverted) and Wᵀ in `coupling`.
    #[inline(always)]
    pub(super) fn condense<const FUSED: bool>(&self, work: &mut Work<N, M, G, P, A>, lower: &mut [Lanes]) {
        cholesky::<FUSED, A>(&mut work.inner);
        for row in &mut work.coupling {
            for k in 0..A {
                let mut value = row[k];
                for l in 0..k {
                    value = value.plus_product::<FUSED>(-work.inner[k][l], row[l]);
                }
                row[k] = value * work.inner[k][k];
            }
        }
        let mut places = lower.chunks_exact_mut(D * D);
        for rows in (0..N).map(|a| &work.coupling[a * D..(a + 1) * D]) {
            let negative: [[Lanes; A]; D] = std::array::from_fn(|i| rows[i].map(|w| -w));
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

    /// Internal parameters that a movement of the nodes brings about: α = −L⁻ᵀ W u.
    #[inline(always)]
    pub(super) fn parameters<const FUSED: bool>(u: &[Lanes], work: &Work<N, M, G, P, A>) -> [Lanes; A] {
        let mut alpha = [Lanes::ZERO; A];
        for (row, &u) in work.coupling.iter().zip(u) {
            for k in 0..A {
                alpha[k] = alpha[k].plus_product::<FUSED>(row[k], -u);
            }
        }
        for k in (0..A).rev() {
            alpha[k] = alpha[k] * work.inner[k][k];
            for l in 0..k {
                alpha[l] = alpha[l].plus_product::<FUSED>(-work.inner[k][l], alpha[k]);
            }
        }
        alpha
    }
}

/// L of L Lᵀ in place of the lower triangle, the diagonal inverted.
#[inline(always)]
fn cholesky<const FUSED: bool, const A: usize>(matrix: &mut [[Lanes; A]; A]) {
    for k in 0..A {
        for i in k..A {
            let mut value = matrix[i][k];
            for l in 0..k {
                value = value.plus_product::<FUSED>(-matrix[i][l], matrix[k][l]);
            }
            matrix[i][k] = if i == k { Lanes::splat(1.0) / value.map(f64::sqrt) } else { value * matrix[k][k] };
        }
    }
}
