//! How many elements share a face.

use fe_mesh::{CellKind, Face, Mesh};
use std::collections::HashMap;

/// Corners of a face, ascending; unused ones are the largest number.
type Corners = [u32; 4];

fn corners(mesh: &Mesh, face: Face) -> Corners {
    let (kind, local) = mesh.kind(face.cell).face(face.face);
    let count = match kind {
        CellKind::Line2 | CellKind::Line3 => 2,
        CellKind::Tri3 | CellKind::Tri6 => 3,
        _ => 4,
    };
    let cell = mesh.cell(face.cell);
    let mut corners = [u32::MAX; 4];
    corners.iter_mut().zip(&local[..count]).for_each(|(corner, &i)| *corner = cell[i]);
    corners.sort_unstable();
    corners
}

/// Counts of the elements at some faces.
pub struct Shared<'m> {
    mesh: &'m Mesh,
    counts: HashMap<Corners, u32>,
}

impl<'m> Shared<'m> {
    /// Goes once through all cells.
    pub fn of(mesh: &'m Mesh, faces: impl Iterator<Item = Face>) -> Self {
        let mut counts: HashMap<Corners, u32> = faces.map(|face| (corners(mesh, face), 0)).collect();
        let mut touched = vec![false; mesh.points.len()];
        // The order does not matter: marks are only set.
        counts.keys().flatten().filter(|&&n| n != u32::MAX).for_each(|&n| touched[n as usize] = true);
        if !counts.is_empty() {
            // A line along an edge is no body beyond it.
            for cell in mesh.cells().filter(|&cell| mesh.kind(cell).dimension() > 1) {
                for face in 0..mesh.kind(cell).faces().len() {
                    let face = Face { cell, face: face as u8 };
                    let (_, local) = mesh.kind(cell).faces()[face.face as usize];
                    if touched[mesh.cell(cell)[local[0]] as usize]
                        && let Some(count) = counts.get_mut(&corners(mesh, face))
                    {
                        *count += 1;
                    }
                }
            }
        }
        Shared { mesh, counts }
    }

    /// True when no other element has this face.
    pub fn is_free(&self, face: Face) -> bool {
        self.counts.get(&corners(self.mesh, face)).is_none_or(|&count| count < 2)
    }
}
