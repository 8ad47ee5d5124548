//! The sides of a pair as a model names them.

use crate::rigid::RigidSurface;
use fe_mesh::{CellId, Face, Mesh};

/// The secondary side.
#[derive(Clone, Debug, PartialEq)]
pub enum Secondary {
    /// Faces of elements.
    Faces(Vec<Face>),
    /// Nodes, each with its area [L²] where one is given.
    Nodes(Vec<(u32, Option<f64>)>),
    /// Trusses and beams in space: the law gives a force per length.
    Lines(Vec<CellId>),
}

impl Secondary {
    /// Its nodes, ascending, each once.
    pub fn nodes(&self, mesh: &Mesh) -> Vec<u32> {
        let mut nodes: Vec<u32> = match self {
            Secondary::Faces(faces) => faces.iter().flat_map(|&face| mesh.face(face).1).collect(),
            Secondary::Nodes(list) => list.iter().map(|n| n.0).collect(),
            Secondary::Lines(cells) => cells.iter().flat_map(|&cell| mesh.cell(cell)).copied().collect(),
        };
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }
}

/// The main side.
#[derive(Clone, Debug, PartialEq)]
pub enum Main {
    /// Faces of elements.
    Faces(Vec<Face>),
    /// An analytical rigid surface that moves with a reference node.
    Rigid {
        /// Shape.
        surface: RigidSurface,
        /// Node index.
        reference: u32,
    },
}
