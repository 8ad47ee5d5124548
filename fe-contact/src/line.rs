//! Lines of trusses and beams in space: each node stands for a length.

use crate::facet::Vec3;
use fe_core::Structure;
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellId, shape};
use std::collections::BTreeMap;

/// Most nodes a line has.
const MOST: usize = 3;
/// Degree to which the shape functions of a straight line are integrated exactly.
const DEGREE: usize = 3;

/// The length [L] that each node stands for: ∫ N ds along the lines at it. Half of a line of two nodes; of a straight
/// one of three a sixth, and two thirds in the middle.
pub fn lengths(structure: &Structure, cells: &[CellId]) -> BTreeMap<u32, f64> {
    let mesh = &structure.mesh;
    let mut lengths = BTreeMap::new();
    for &cell in cells {
        let (kind, nodes) = (mesh.kind(cell), mesh.cell(cell));
        let (mut values, mut gradients) = ([0.0; MOST], [[0.0; 3]; MOST]);
        for (xi, weight) in Rule::of(kind, DEGREE).points {
            shape::values(kind, &xi, &mut values);
            shape::gradients(kind, &xi, &mut gradients);
            let part = |(&node, gradient): (&u32, &[f64; 3])| Vec3::from(mesh.points[node as usize]) * gradient[0];
            let tangent: Vec3 = nodes.iter().zip(&gradients).map(part).sum();
            for (&node, value) in nodes.iter().zip(&values) {
                *lengths.entry(node).or_insert(0.0) += value * weight * tangent.norm();
            }
        }
    }
    lengths
}
