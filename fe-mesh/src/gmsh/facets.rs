//! Which faces of cells the elements of a surface are.

use super::ElementBlock;
use crate::cell::CellKind;
use crate::mesh::{Face, Mesh};

/// Faces of cells by their corners, those only that are asked for.
pub(super) struct Facets {
    /// Sorted corners of each facet, ascending.
    keys: Vec<Corners>,
    /// Where the faces of each key start in `faces`, one more at the end.
    starts: Vec<usize>,
    /// Faces of each key, that of the cell with the lowest label first.
    faces: Vec<Face>,
}

/// Sorted corners of a face, filled up with `u32::MAX`.
type Corners = [u32; 4];

/// Corners of a line, triangle or quadrangle with these nodes.
fn corners(kind: CellKind, node: impl Fn(usize) -> u32) -> Corners {
    let many = match kind {
        CellKind::Line2 | CellKind::Line3 => 2,
        CellKind::Tri3 | CellKind::Tri6 => 3,
        _ => 4,
    };
    let mut corners = [u32::MAX; 4];
    for (i, corner) in corners[..many].iter_mut().enumerate() {
        *corner = node(i);
    }
    corners.sort_unstable();
    corners
}

impl Facets {
    /// Finds the faces of the mesh's cells that these elements are.
    pub fn on(mesh: &Mesh, sides: &[&ElementBlock]) -> Self {
        let mut touched = vec![false; mesh.points.len()];
        let mut keys = Vec::new();
        for side in sides {
            for element in side.nodes.chunks_exact(side.kind.nodes()) {
                let key = corners(side.kind, |i| element[i]);
                key.iter().filter(|&&node| node != u32::MAX).for_each(|&node| touched[node as usize] = true);
                keys.push(key);
            }
        }
        keys.sort_unstable();
        keys.dedup();
        let mut found: Vec<(usize, u64, Face)> = Vec::new();
        for id in mesh.cells() {
            let cell = mesh.cell(id);
            for (face, (kind, local)) in mesh.kind(id).faces().iter().enumerate() {
                let key = corners(*kind, |i| cell[local[i]]);
                if key.iter().all(|&node| node == u32::MAX || touched[node as usize])
                    && let Ok(place) = keys.binary_search(&key)
                {
                    found.push((place, mesh.cell_label(id), Face { cell: id, face: face as u8 }));
                }
            }
        }
        found.sort_unstable();
        let starts = (0..=keys.len()).map(|key| found.partition_point(|&(place, ..)| place < key)).collect();
        Facets { keys, starts, faces: found.into_iter().map(|(_, _, face)| face).collect() }
    }

    /// Faces of cells with the corners of this element, that of the lowest label first; empty when there is none.
    pub fn cells_at(&self, kind: CellKind, element: &[u32]) -> &[Face] {
        match self.keys.binary_search(&corners(kind, |i| element[i])) {
            Ok(key) => &self.faces[self.starts[key]..self.starts[key + 1]],
            Err(_) => &[],
        }
    }
}
