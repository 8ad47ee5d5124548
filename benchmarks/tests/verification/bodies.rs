//! Meshes of the cases.

use fe_core::element::{ElementType, Space};
use fe_mesh::generate::Block;
use fe_mesh::{CellKind, Mesh};
use std::collections::BTreeSet;

/// A block of an element's cells; plane ones take two divisions.
pub fn block(element: ElementType, divisions: [usize; 3]) -> Block {
    let plane = [divisions[0], divisions[1]];
    match element.kind() {
        CellKind::Tri3 => Block::tri3(plane),
        CellKind::Quad4 => Block::quad4(plane),
        CellKind::Tet4 => Block::tet4(divisions),
        CellKind::Tet10 => Block::tet10(divisions),
        _ => Block::hex8(divisions),
    }
}

/// Translations that a node of the element has, from 0.
pub fn components(element: ElementType) -> &'static [usize] {
    if element.space() == Space::Solid { &[0, 1, 2] } else { &[0, 1] }
}

/// All nodes on the sides of a block.
pub fn sides(mesh: &Mesh) -> Vec<u32> {
    let sides = mesh.node_sets.iter().filter(|(name, _)| name.ends_with("MIN") || name.ends_with("MAX"));
    sides.flat_map(|(_, nodes)| nodes.iter().copied()).collect::<BTreeSet<u32>>().into_iter().collect()
}

/// A point of the unit square or cube, whose inner points lie a part `amount` of a cell of a grid of `cells` elsewhere:
/// multilinear between the points of that grid, so that refined meshes follow the same pattern.
pub fn distorted(x: [f64; 3], cells: usize, amount: f64) -> [f64; 3] {
    let n = cells as f64;
    let low = x.map(|x| (x * n).floor().min(n - 1.0));
    let mut moved = x;
    for corner in 0..8 {
        let at: [f64; 3] = std::array::from_fn(|i| low[i] + f64::from(corner >> i & 1));
        let weight: f64 = (0..3).map(|i| (1.0 - (x[i] * n - at[i]).abs()).max(0.0)).product();
        let plane = x[2] == 0.0;
        let inside = |i: usize| at[i] > 0.5 && at[i] < n - 0.5;
        if inside(0) && inside(1) && (plane || inside(2)) {
            let axes = if plane { 2 } else { 3 };
            (0..axes).for_each(|i| moved[i] += weight * amount / n * noise(at, i));
        }
    }
    moved
}

/// A number in [−1, 1] that depends on a place only, erratically.
fn noise(x: [f64; 3], salt: usize) -> f64 {
    let s = (x[0] * 12.71 + x[1] * 31.17 + x[2] * 7.47 + salt as f64 * 5.39).sin() * 43758.5453;
    2.0 * (s - s.floor()) - 1.0
}

/// Puts the middle nodes of quadratic tetrahedra halfway between the ends of their edges.
pub fn straighten(mesh: &mut Mesh) {
    const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
    for block in mesh.blocks.iter().filter(|block| block.kind == CellKind::Tet10) {
        for cell in block.nodes.chunks_exact(10) {
            for (middle, [a, b]) in EDGES.iter().enumerate() {
                let [p, q] = [a, b].map(|&i| mesh.points[cell[i] as usize]);
                mesh.points[cell[4 + middle] as usize] = std::array::from_fn(|i| 0.5 * (p[i] + q[i]));
            }
        }
    }
}
