//! Stresses and strains at the integration points, and at the nodes.

use super::kernel::Kernel;
use super::{SolidBlock, tables, with_kernel};
use crate::element::Space;
use crate::lanes::LANES;
use fe_mesh::{CellKind, shape};
use rayon::prelude::*;

/// Cells of a chunk, a multiple of the lanes.
const CHUNK: usize = 16 * LANES;

/// Stresses and strains, `[cells × points][6]` in the order xx, yy, zz, xy, yz, xz; around an axis xx is radial,
/// yy axial, zz the hoop.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFields {
    /// Cauchy stress [F/L²], tension positive.
    pub stress: Vec<[f64; 6]>,
    /// Strain [-], tensor shear (half the engineering one).
    pub strain: Vec<[f64; 6]>,
}

impl SolidBlock {
    /// Stresses and strains at the integration points, enhanced strains included.
    pub fn stresses(&self, u: &[f64]) -> PointFields {
        let mut strain = with_kernel!(self, kernel => self.strains(&kernel, u));
        let stress = strain.par_iter_mut().map(|strain| self.respond(strain)).collect();
        PointFields { stress, strain }
    }

    /// Values at the integration points, `[cells × points]`, carried on to the nodes of each cell by the (multi-)
    /// linear function through the points: `[cells × nodes]`.
    pub fn nodal(&self, at_points: &[[f64; 6]]) -> Vec<[f64; 6]> {
        let weights = self.extrapolation();
        let mut nodal = Vec::with_capacity(self.nodes.len());
        for values in at_points.chunks_exact(self.points()) {
            nodal.extend(weights.iter().map(|weights| {
                let mut sum = [0.0; 6];
                for (w, value) in weights.iter().zip(values) {
                    sum.iter_mut().zip(value).for_each(|(s, v)| *s += w * v);
                }
                sum
            }));
        }
        nodal
    }

    fn strains<K: Kernel>(&self, kernel: &K, u: &[f64]) -> Vec<[f64; 6]> {
        let mut flat = vec![0.0; self.cells.len() * K::POINTS * 6];
        flat.par_chunks_mut(CHUNK * K::POINTS * 6).enumerate().for_each(|(c, place)| {
            let chunk = c * CHUNK..self.cells.len().min((c + 1) * CHUNK);
            self.with_batches(chunk, u, |batches| kernel.strains(batches, place));
        });
        flat.chunks_exact(6).map(|s| std::array::from_fn(|i| s[i])).collect()
    }

    /// σ = λ tr ε 1 + 2 μ ε; in plane stress ε_zz is first set to what leaves σ_zz = 0.
    fn respond(&self, strain: &mut [f64; 6]) -> [f64; 6] {
        let (lambda, mu) = (self.elastic.lambda(), self.elastic.mu());
        let plane_stress = self.element.space() == Space::PlaneStress;
        if plane_stress {
            strain[2] = -lambda / (lambda + 2.0 * mu) * (strain[0] + strain[1]);
        }
        let pressure = lambda * (strain[0] + strain[1] + strain[2]);
        let mut stress = strain.map(|e| 2.0 * mu * e);
        stress[..3].iter_mut().for_each(|s| *s += pressure);
        if plane_stress {
            stress[2] = 0.0;
        }
        stress
    }

    /// Share of each integration point's value in each node's, `[nodes][points]`: linear shape functions of the
    /// cell that has the points for corners.
    fn extrapolation(&self) -> Vec<Vec<f64>> {
        let kind = self.element.kind();
        let points: Vec<[f64; 3]> = tables::rule(self.element).points.iter().map(|p| p.0).collect();
        if points.len() == 1 {
            return vec![vec![1.0]; kind.nodes()];
        }
        let linear = match kind {
            CellKind::Tet10 => CellKind::Tet4,
            other => other,
        };
        let (centre, corners) = (shape::centroid(kind), shape::nodes(linear));
        let distance = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>();
        let nearest = |corner: &[f64; 3]| {
            (0..points.len()).min_by(|&p, &q| distance(&points[p], corner).total_cmp(&distance(&points[q], corner)))
        };
        let scale = (distance(&corners[0], &centre) / distance(&points[0], &centre)).sqrt();
        let weights = |node: &[f64; 3]| {
            let (mut values, mut weights) = ([0.0; 8], vec![0.0; points.len()]);
            shape::values(linear, &std::array::from_fn(|i| centre[i] + scale * (node[i] - centre[i])), &mut values);
            for (corner, value) in corners.iter().zip(values) {
                if let Some(p) = nearest(corner) {
                    weights[p] = value;
                }
            }
            weights
        };
        shape::nodes(kind).iter().map(weights).collect()
    }
}
