//! Lines of trusses and beams in space: each node stands for a length, and slides along the line or across.

use crate::facet::Vec3;
use fe_core::Structure;
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellId, shape};
use std::collections::BTreeMap;

/// Most nodes a line has.
const MOST: usize = 3;
/// Degree to which the shape functions of a straight line are integrated exactly.
const DEGREE: usize = 3;

/// A node of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The length [L] that it stands for: ∫ N ds along the lines at it. Half of a line of two nodes; of a straight one of
    /// three a sixth, and two thirds in the middle.
    pub length: f64,
    /// Unit direction of the line: the mean ∫ N dx of the lines at it, in the sense of the first of them.
    pub direction: Vec3,
}

/// The nodes of lines.
pub fn nodes<'a>(structure: &Structure, cells: impl IntoIterator<Item = &'a CellId>) -> BTreeMap<u32, Node> {
    let mesh = &structure.mesh;
    let mut found: BTreeMap<u32, Node> = BTreeMap::new();
    for &cell in cells {
        let (kind, nodes) = (mesh.kind(cell), mesh.cell(cell));
        let (mut values, mut gradients) = ([0.0; MOST], [[0.0; 3]; MOST]);
        let mut parts = [Node { length: 0.0, direction: Vec3::zeros() }; MOST];
        for (xi, weight) in Rule::of(kind, DEGREE).points {
            shape::values(kind, &xi, &mut values);
            shape::gradients(kind, &xi, &mut gradients);
            let part = |(&node, gradient): (&u32, &[f64; 3])| Vec3::from(mesh.points[node as usize]) * gradient[0];
            let tangent: Vec3 = nodes.iter().zip(&gradients).map(part).sum();
            for (part, value) in parts.iter_mut().zip(&values) {
                part.length += value * weight * tangent.norm();
                part.direction += tangent * (value * weight);
            }
        }
        for (&node, part) in nodes.iter().zip(parts) {
            let add = |n: &mut Node| {
                n.length += part.length;
                n.direction += part.direction * if n.direction.dot(&part.direction) < 0.0 { -1.0 } else { 1.0 };
            };
            found.entry(node).and_modify(add).or_insert(part);
        }
    }
    let unit = |d: Vec3| d.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
    found.values_mut().for_each(|n| n.direction = unit(n.direction));
    found
}

/// Mean length [L] of lines, where there are any.
pub fn mean_length<'a>(structure: &Structure, cells: impl Iterator<Item = &'a CellId>) -> Option<f64> {
    let cells: Vec<&CellId> = cells.collect();
    let all: f64 = nodes(structure, cells.iter().copied()).values().map(|node| node.length).sum();
    Some(all / cells.len() as f64).filter(|length| *length > 0.0)
}
