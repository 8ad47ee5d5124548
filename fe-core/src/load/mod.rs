//! Loads and supports as a model holds them.

mod force;

pub use force::{LoadError, PressedFace, unit_forces};

use fe_mesh::{CellId, Face};

/// What of a freedom is prescribed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Prescribed {
    /// Its displacement [L or rad].
    #[default]
    Displacement,
    /// Its velocity [L/T or rad/T], in explicit steps.
    Velocity,
    /// Its acceleration [L/T² or rad/T²], in explicit steps.
    Acceleration,
}

/// A prescribed freedom of one node.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// Node index.
    pub node: u32,
    /// Freedom, 0..6.
    pub component: u8,
    /// What the value is of.
    pub prescribed: Prescribed,
    /// Value at the end of the step, before the amplitude.
    pub value: f64,
    /// Index of the amplitude; without one, a value ramps over a static step from where it was, and holds from the start of
    /// an explicit one.
    pub amplitude: Option<usize>,
}

/// What loads a body.
#[derive(Clone, Debug, PartialEq)]
pub enum LoadKind {
    /// A force (or moment) [F] on each node of a list, in direction 0..6. Of the full circumference in
    /// axisymmetric models.
    Nodal {
        /// Node indices.
        nodes: Vec<u32>,
        /// Freedom, 0..6.
        component: u8,
    },
    /// A pressure [F/L²] on faces, positive towards the body.
    Pressure {
        /// Faces.
        faces: Vec<Face>,
    },
    /// A force per length [F/L] on trusses and beams, in direction 0..3.
    Line {
        /// Cells.
        cells: Vec<CellId>,
        /// Direction, 0..3.
        component: u8,
    },
    /// Gravity [L/T²] on cells, in a unit direction.
    Gravity {
        /// Cells.
        cells: Vec<CellId>,
        /// Unit direction.
        direction: [f64; 3],
    },
}

/// One load card's line.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// What it is.
    pub kind: LoadKind,
    /// Magnitude at the end of the step, before the amplitude.
    pub magnitude: f64,
    /// Index of the amplitude; without one, the magnitude ramps over a static step from where it was, and acts in full from
    /// the start of an explicit one.
    pub amplitude: Option<usize>,
}
