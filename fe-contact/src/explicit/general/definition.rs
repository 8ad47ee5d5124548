//! What general contact is made of.

use crate::explicit::behaviour::Behaviour;

/// Which sides of a face may be touched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The outer one: the face of a solid.
    Outer,
    /// Both: a facet of a rigid sheet.
    Both,
}

/// A face that may touch.
#[derive(Clone, Debug, PartialEq)]
pub struct GeneralFace {
    /// Corner nodes, three or four, counter-clockwise seen from outside.
    pub nodes: Vec<u32>,
    /// Sides.
    pub sides: Sides,
    /// Row and column of [`GeneralDefinition::table`].
    pub class: u16,
}

/// What acts between two classes of faces; where a node has faces of several classes, the larger numbers hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Acting {
    /// Index of the behaviour.
    pub behaviour: u16,
    /// Index of the factor on the penalty.
    pub scale: u16,
}

/// What two classes of faces are to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// Nothing includes them: they pass through each other.
    Nothing,
    /// They are excluded: so is a node or an edge that has other faces, too.
    Excluded,
    /// They may touch.
    Acting(Acting),
}

/// General contact: any of its faces may touch any other, as the table says.
#[derive(Clone, Debug)]
pub struct GeneralDefinition {
    /// What messages call it.
    pub name: String,
    /// Faces.
    pub faces: Vec<GeneralFace>,
    /// What two classes of faces are to each other, symmetric.
    pub table: Vec<Vec<Between>>,
    /// Behaviours.
    pub behaviours: Vec<Behaviour>,
    /// Factors on the penalty [-].
    pub scales: Vec<f64>,
}
