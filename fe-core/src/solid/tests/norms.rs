//! Errors of a solution, integrated over the elements.

use super::scene::Scene;
use crate::element::Space;
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellKind, shape};

/// Relative errors in L2 over the volume.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Of the displacement.
    pub displacement: f64,
    /// Of the stress.
    pub stress: f64,
    /// Of the stress less its mean pressure.
    pub deviator: f64,
}

/// Against exact fields, by at least eight points a direction in the plane, five in space. The stress is the
/// (multi-) linear function through the integration points.
pub fn errors(
    scene: &Scene,
    u: &[f64],
    displacement: impl Fn([f64; 3]) -> [f64; 3],
    stress: impl Fn([f64; 3]) -> [f64; 6],
) -> Errors {
    let (element, kind, block) = (scene.element(), scene.element().kind(), scene.block());
    let linear = if kind == CellKind::Tet10 { CellKind::Tet4 } else { kind };
    let nodal = block.nodal(&block.stresses(u).stress);
    let n = kind.nodes();
    let mut sums = [[0.0; 2]; 3];
    let rule = Rule::of(kind, if element.space() == Space::Solid { 9 } else { 15 });
    for (cell, nodes) in block.nodes().chunks_exact(n).enumerate() {
        for (xi, weight) in &rule.points {
            let (mut values, mut gradients, mut corner) = ([0.0; 10], [[0.0; 3]; 10], [0.0; 10]);
            shape::values(kind, xi, &mut values);
            shape::gradients(kind, xi, &mut gradients);
            shape::values(linear, xi, &mut corner);
            let (mut x, mut found, mut j) = ([0.0; 3], [0.0; 3], nalgebra::Matrix3::identity());
            let dimension = element.space().dimension();
            j.view_mut((0, 0), (dimension, dimension)).fill(0.0);
            let mut found_stress = [0.0; 6];
            for (a, &node) in nodes.iter().enumerate() {
                let at = scene.structure.mesh.points[node as usize];
                (0..3).for_each(|i| x[i] += values[a] * at[i]);
                let start = scene.freedoms.of_node(node as usize).start;
                (0..dimension).for_each(|i| found[i] += values[a] * u[start + i]);
                (0..dimension).for_each(|i| (0..dimension).for_each(|d| j[(i, d)] += at[i] * gradients[a][d]));
                (0..6).for_each(|i| found_stress[i] += corner[a] * nodal[cell * n + a][i]);
            }
            let radius = if element.space() == Space::Axisymmetric { x[0] } else { 1.0 };
            let volume = weight * j.determinant() * radius;
            let exact = displacement(x);
            let add = |sum: &mut [f64; 2], error: f64, size: f64| {
                sum[0] += volume * error;
                sum[1] += volume * size;
            };
            let square = |v: &[f64]| v.iter().map(|v| v * v).sum::<f64>();
            let exact_stress = stress(x);
            let difference: [f64; 6] = std::array::from_fn(|i| found_stress[i] - exact_stress[i]);
            let error: [f64; 3] = std::array::from_fn(|i| found[i] - exact[i]);
            add(&mut sums[0], square(&error), square(&exact));
            add(&mut sums[1], square(&difference), square(&exact_stress));
            add(&mut sums[2], square(&deviator(difference)), square(&deviator(exact_stress)));
        }
    }
    let [displacement, stress, deviator] = sums.map(|[error, size]| (error / size).sqrt());
    Errors { displacement, stress, deviator }
}

fn deviator(mut stress: [f64; 6]) -> [f64; 6] {
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    stress[..3].iter_mut().for_each(|s| *s -= mean);
    stress
}
