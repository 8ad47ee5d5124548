//! The sides of a pair as a model names them.

use crate::rigid::RigidSurface;
use fe_mesh::Face;

/// The secondary side.
#[derive(Clone, Debug, PartialEq)]
pub enum Secondary {
    /// Faces of elements.
    Faces(Vec<Face>),
    /// Nodes, each with its area [L²] where one is given.
    Nodes(Vec<(u32, Option<f64>)>),
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
