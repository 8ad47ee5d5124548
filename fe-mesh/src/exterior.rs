//! The outside of a mesh.

use crate::{CellKind, Face, Mesh};

/// Faces of cells in space that no other such cell has, cells ascending.
pub fn exterior(mesh: &Mesh) -> Vec<Face> {
    let mut faces: Vec<([u32; 4], Face)> = Vec::new();
    for cell in mesh.cells().filter(|&cell| mesh.kind(cell).dimension() == 3) {
        let nodes = mesh.cell(cell);
        for (number, (kind, local)) in mesh.kind(cell).faces().iter().enumerate() {
            let count = if matches!(kind, CellKind::Tri3 | CellKind::Tri6) { 3 } else { 4 };
            let mut corners = [u32::MAX; 4];
            (0..count).for_each(|i| corners[i] = nodes[local[i]]);
            corners.sort_unstable();
            faces.push((corners, Face { cell, face: number as u8 }));
        }
    }
    faces.sort_unstable();
    let alone = faces.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() == 1);
    let mut out: Vec<Face> = alone.map(|same| same[0].1).collect();
    out.sort_unstable();
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Block;

    #[test]
    fn a_block_shows_its_six_sides() {
        for (block, each) in [(Block::hex8([2, 3, 4]), 1), (Block::tet4([2, 3, 4]), 2)] {
            assert_eq!(exterior(&block.mesh()).len(), each * 2 * (2 * 3 + 3 * 4 + 4 * 2));
        }
    }
}
