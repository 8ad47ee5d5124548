//! The hourglass shapes as carriers of movement, and the way from them back to the nodes.
//!
//! A movement of the nodes has at each point the gradient Σ_a u_a b̄_a + Σ_k q_k (∇h_k − mean), q_k = Σ_a γ_ka u_a,
//! with h_k = ξη, … and γ_k = (h_k − Σ_i (h_k·x_i) b_i)/N (Flanagan and Belytschko, Int. J. Numer. Meth. Eng. 17
//! (1981) 679), b the gradients at the centroid, b̄ their means. It holds on any shape.

use super::super::tables::PRODUCTS;
use super::geometry::transformed;
use super::{Element, Work};
use crate::lanes::Lanes;

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    /// Coordinates as the carriers have them: of the nodes, or h_k·x/N.
    #[inline(always)]
    pub(super) fn carriers<const FUSED: bool>(&self, x: &[[Lanes; D]; N]) -> [[Lanes; D]; R] {
        let mut out = [[Lanes::ZERO; D]; R];
        for k in 0..R {
            if !Self::REDUCED {
                out[k] = x[k];
                continue;
            }
            for a in 0..N {
                let share = Lanes::splat(self.tables.hourglass[a][k] / N as f64);
                for i in 0..D {
                    out[k][i] = out[k][i].plus_product::<FUSED>(share, x[a][i]);
                }
            }
        }
        out
    }

    /// ∂/∂ξ of the carriers' shapes at a point, `[R]` at least.
    #[inline(always)]
    pub(super) fn carrier_gradients(&self, p: usize) -> &[[f64; 3]] {
        if Self::REDUCED { &self.tables.product_gradients[p] } else { &self.tables.gradients[p] }
    }

    /// Fills γ, the mean gradients and the volume; takes the mean out of the hourglass gradients.
    #[inline(always)]
    pub(super) fn uniform_part<const FUSED: bool>(
        &self,
        (cofactor, determinant): &([[Lanes; D]; D], Lanes),
        carriers: &[[Lanes; D]; R],
        work: &mut Work<N, R, M, D, G, P, A>,
    ) {
        let mut means = [[Lanes::ZERO; D]; R];
        work.volume = Lanes::ZERO;
        for p in 0..P {
            work.volume += work.weights[p];
            for k in 0..R {
                for i in 0..D {
                    means[k][i] = means[k][i].plus_product::<FUSED>(work.weights[p], work.gradients[p][k][i]);
                }
            }
        }
        let inverse = Lanes::splat(1.0) / work.volume;
        for k in 0..R {
            for i in 0..D {
                means[k][i] = means[k][i] * inverse;
                for p in 0..P {
                    work.gradients[p][k][i] = work.gradients[p][k][i] - means[k][i];
                }
            }
        }
        let inverse = Lanes::splat(1.0) / *determinant;
        for a in 0..N {
            let mut uniform = transformed::<FUSED, D>(cofactor, &self.tables.central[a]);
            for i in 0..D {
                uniform[i] = uniform[i] * inverse;
            }
            for k in 0..R {
                let mut gamma = Lanes::splat(self.tables.hourglass[a][k.min(PRODUCTS - 1)] / N as f64);
                for i in 0..D {
                    gamma = gamma.plus_product::<FUSED>(-carriers[k][i], uniform[i]);
                }
                work.hourglass[a][k] = gamma;
            }
            for k in 0..R {
                for i in 0..D {
                    uniform[i] = uniform[i].plus_product::<FUSED>(work.hourglass[a][k], means[k][i]);
                }
            }
            work.uniform[a] = uniform;
        }
    }

    /// Lower blocks of the nodes, from those of the hourglass shapes and constant strains:
    /// K_ab = V (b̄_a, C b̄_b) + Σ_kl γ_ka γ_lb K_kl.
    #[inline(always)]
    pub(super) fn expand<const FUSED: bool>(&self, work: &Work<N, R, M, D, G, P, A>, lower: &mut [Lanes]) {
        let mut places = lower.chunks_exact_mut(D * D);
        for a in 0..N {
            let half = Self::half_expanded::<FUSED>(work, a);
            for b in 0..=a {
                let mut t = [[Lanes::ZERO; G]; G];
                for i in 0..D {
                    let weighted = work.uniform[a][i] * work.volume;
                    for j in 0..D {
                        t[i][j] = weighted * work.uniform[b][j];
                    }
                }
                let mut block = self.elastic::<FUSED>(&t);
                for l in 0..R {
                    let gamma = work.hourglass[b][l];
                    for i in 0..D {
                        for j in 0..D {
                            block[i][j] = block[i][j].plus_product::<FUSED>(half[l][i][j], gamma);
                        }
                    }
                }
                let place = places.next().expect("one place a lower block");
                (0..D).for_each(|i| place[i * D..(i + 1) * D].copy_from_slice(&block[i]));
            }
        }
    }

    /// Σ_k γ_ka K_kl for each l.
    #[inline(always)]
    fn half_expanded<const FUSED: bool>(work: &Work<N, R, M, D, G, P, A>, a: usize) -> [[[Lanes; D]; D]; R] {
        let mut half = [[[Lanes::ZERO; D]; D]; R];
        for l in 0..R {
            for k in 0..R {
                let gamma = work.hourglass[a][k];
                let (high, low) = (k.max(l), k.min(l));
                let block = &work.lower[(high * (high + 1) / 2 + low) * D * D..][..D * D];
                for i in 0..D {
                    for j in 0..D {
                        let value = if k >= l { block[i * D + j] } else { block[j * D + i] };
                        half[l][i][j] = half[l][i][j].plus_product::<FUSED>(gamma, value);
                    }
                }
            }
        }
        half
    }

    /// Movements of the carriers that movements of the nodes are.
    #[inline(always)]
    pub(super) fn carrier_movements<const FUSED: bool>(
        u: &[Lanes],
        work: &Work<N, R, M, D, G, P, A>,
    ) -> [[Lanes; D]; R] {
        let mut out = [[Lanes::ZERO; D]; R];
        for k in 0..R {
            for i in 0..D {
                if !Self::REDUCED {
                    out[k][i] = u[k * D + i];
                    continue;
                }
                for a in 0..N {
                    out[k][i] = out[k][i].plus_product::<FUSED>(work.hourglass[a][k], u[a * D + i]);
                }
            }
        }
        out
    }

    /// The mean of ∂u_i/∂x_j, where the carriers leave it out.
    #[inline(always)]
    pub(super) fn uniform_gradient<const FUSED: bool>(
        u: &[Lanes],
        work: &Work<N, R, M, D, G, P, A>,
    ) -> [[Lanes; G]; D] {
        let mut gradient = [[Lanes::ZERO; G]; D];
        if Self::REDUCED {
            for a in 0..N {
                for i in 0..D {
                    for j in 0..D {
                        gradient[i][j] = gradient[i][j].plus_product::<FUSED>(u[a * D + i], work.uniform[a][j]);
                    }
                }
            }
        }
        gradient
    }
}
