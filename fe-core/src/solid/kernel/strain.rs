//! Strains at the integration points.

use super::{Element, Work};
use crate::lanes::Lanes;

impl<const N: usize, const R: usize, const M: usize, const D: usize, const G: usize, const P: usize, const A: usize>
    Element<N, R, M, D, G, P, A>
{
    /// Strains xx, yy, zz, xy, yz, xz (tensor shear) of one batch into `out`, `[P × 6]`; the hoop strain is zz.
    #[inline(always)]
    pub(super) fn batch_strains<const FUSED: bool>(u: &[Lanes], work: &Work<N, R, M, D, G, P, A>, out: &mut [Lanes]) {
        let carriers = Self::carrier_movements::<FUSED>(u, work);
        let uniform = Self::uniform_gradient::<FUSED>(u, work);
        let alpha = Self::parameters::<FUSED>(&carriers, work);
        for (p, strain) in out.chunks_exact_mut(6).enumerate() {
            let mut gradient = uniform; // ∂u_i/∂x_j
            for a in 0..M {
                for i in 0..D {
                    let movement = if a < R { carriers[a][i] } else { alpha[(a - R) * D + i] };
                    for j in 0..G {
                        gradient[i][j] = gradient[i][j].plus_product::<FUSED>(movement, work.gradients[p][a][j]);
                    }
                }
            }
            let mut volumetric = Lanes::ZERO;
            for v in Self::DIRECTIONAL..A {
                volumetric += alpha[v] * work.volumetric[p][v - Self::DIRECTIONAL];
            }
            let shear = |i: usize, j: usize| (gradient[i][j] + gradient[j][i]) * 0.5;
            strain.fill(Lanes::ZERO);
            strain[0] = gradient[0][0] + volumetric;
            strain[1] = gradient[1][1] + volumetric;
            strain[3] = shear(0, 1);
            if D == 3 {
                strain[2] = gradient[2][2] + volumetric;
                strain[4] = shear(1, 2);
                strain[5] = shear(0, 2);
            } else if Self::AXISYMMETRIC {
                strain[2] = gradient[0][2] + volumetric;
            }
        }
    }
}
