//! The sums of one cell.

use super::parts::{Part, place};
use super::{Quadrature, VolumeErrors, corners};
use crate::exact::Exact;
use fe_core::Structure;
use fe_core::element::Space;
use fe_core::material::Elastic;
use fe_core::solid::SolidBlock;
use fe_mesh::quadrature::Rule;
use fe_mesh::shape;
use nalgebra::Matrix3;

/// Squares of errors and of the exact fields, integrated.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    energy: [f64; 2],
    displacement: [f64; 2],
    deviator: [f64; 2],
}

impl Sums {
    pub fn add(&mut self, other: &Sums) {
        let pairs = [
            (&mut self.energy, other.energy),
            (&mut self.displacement, other.displacement),
            (&mut self.deviator, other.deviator),
        ];
        pairs.into_iter().for_each(|(sum, [error, size])| *sum = [sum[0] + error, sum[1] + size]);
    }

    pub fn relative(&self) -> VolumeErrors {
        let relative = |[error, size]: [f64; 2]| (error / size).sqrt();
        VolumeErrors {
            energy: relative(self.energy),
            displacement: relative(self.displacement),
            deviator: relative(self.deviator),
        }
    }
}

/// What the cells of a section are compared with.
pub(super) struct Task<'a> {
    pub structure: &'a Structure,
    pub block: &'a SolidBlock,
    /// Stress at the nodes of each cell, `[cells × nodes]` [F/L²].
    pub stress: &'a [[f64; 6]],
    /// Displacement of each point [L].
    pub u: &'a [[f64; 3]],
    pub exact: &'a (dyn Fn([f64; 3]) -> Exact + Sync),
    pub elastic: Elastic,
    pub quadrature: &'a Quadrature<'a>,
}

impl Task<'_> {
    /// Of one cell.
    pub fn sums(&self, cell: usize) -> Sums {
        let kind = self.block.element().kind();
        let linear = corners(kind);
        let near = |part: &Part| self.is_near(cell, part);
        let rule = Rule::of(kind, 2 * self.quadrature.points - 1);
        let mut sums = Sums::default();
        for part in Part::of(linear, &near) {
            let share = 0.5f64.powi((kind.dimension() * part.level) as i32);
            for (xi, weight) in &rule.points {
                let at = if part.level == 0 { *xi } else { place(linear, &part, xi) };
                self.add_point(cell, &at, share * weight, &mut sums);
            }
        }
        sums
    }

    fn nodes(&self, cell: usize) -> &[u32] {
        let count = self.block.element().kind().nodes();
        &self.block.nodes()[cell * count..(cell + 1) * count]
    }

    /// True for a part that is larger than its distance from what is singular, and may be halved further.
    fn is_near(&self, cell: usize, part: &Part) -> bool {
        let Some(distance) = self.quadrature.singular.filter(|_| part.level < self.quadrature.splits) else {
            return false;
        };
        let centre = self.position(cell, &part.centre());
        let to_corner = |corner: &[f64; 3]| {
            let corner = self.position(cell, corner);
            (0..3).map(|i| (corner[i] - centre[i]).powi(2)).sum::<f64>().sqrt()
        };
        distance(centre) < 2.0 * part.corners.iter().map(to_corner).fold(0.0, f64::max)
    }

    fn position(&self, cell: usize, xi: &[f64; 3]) -> [f64; 3] {
        let mut values = [0.0; 10];
        shape::values(self.block.element().kind(), xi, &mut values);
        let mut x = [0.0; 3];
        for (&node, value) in self.nodes(cell).iter().zip(values) {
            (0..3).for_each(|i| x[i] += value * self.structure.mesh.points[node as usize][i]);
        }
        x
    }

    fn add_point(&self, cell: usize, xi: &[f64; 3], weight: f64, sums: &mut Sums) {
        let element = self.block.element();
        let (kind, dimension, nodes) = (element.kind(), element.space().dimension(), self.nodes(cell));
        let (mut values, mut gradients, mut linear) = ([0.0; 10], [[0.0; 3]; 10], [0.0; 10]);
        shape::values(kind, xi, &mut values);
        shape::gradients(kind, xi, &mut gradients);
        shape::values(corners(kind), xi, &mut linear);
        let (mut x, mut u, mut stress, mut jacobian) = ([0.0; 3], [0.0; 3], [0.0; 6], Matrix3::<f64>::zeros());
        jacobian.view_mut((dimension, dimension), (3 - dimension, 3 - dimension)).fill_with_identity();
        for (a, &node) in nodes.iter().enumerate() {
            let (at, moved) = (self.structure.mesh.points[node as usize], self.u[node as usize]);
            (0..3).for_each(|i| x[i] += values[a] * at[i]);
            (0..dimension).for_each(|i| u[i] += values[a] * moved[i]);
            (0..dimension).for_each(|i| (0..dimension).for_each(|d| jacobian[(i, d)] += at[i] * gradients[a][d]));
            (0..6).for_each(|i| stress[i] += linear[a] * self.stress[cell * nodes.len() + a][i]);
        }
        let around = if element.space() == Space::Axisymmetric { x[0] } else { 1.0 };
        let volume: f64 = weight * jacobian.determinant() * around;
        let exact = (self.exact)(x);
        let difference: [f64; 6] = std::array::from_fn(|i| stress[i] - exact.stress[i]);
        let error: [f64; 3] = std::array::from_fn(|i| u[i] - exact.displacement[i]);
        let square = |v: [f64; 3]| v.iter().map(|v| v * v).sum::<f64>();
        let add =
            |sum: &mut [f64; 2], [error, size]: [f64; 2]| *sum = [sum[0] + volume * error, sum[1] + volume * size];
        add(&mut sums.energy, [difference, exact.stress].map(|s| complementary(s, &self.elastic)));
        add(&mut sums.displacement, [error, exact.displacement].map(square));
        add(&mut sums.deviator, [difference, exact.stress].map(|s| contracted(deviator(s))));
    }
}

/// σ:D⁻¹:σ = ((1+ν) σ:σ − ν tr²σ)/E
fn complementary(stress: [f64; 6], elastic: &Elastic) -> f64 {
    let nu = elastic.poisson;
    ((1.0 + nu) * contracted(stress) - nu * (stress[0] + stress[1] + stress[2]).powi(2)) / elastic.young
}

/// σ:σ
fn contracted([xx, yy, zz, xy, yz, xz]: [f64; 6]) -> f64 {
    xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + yz * yz + xz * xz)
}

fn deviator(mut stress: [f64; 6]) -> [f64; 6] {
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    stress[..3].iter_mut().for_each(|s| *s -= mean);
    stress
}
