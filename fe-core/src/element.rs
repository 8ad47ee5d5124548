//! The element types that decks name.

use fe_mesh::CellKind;

/// A solid element type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum ElementType {
    C3D4,
    C3D10,
    C3D8,
    CPE3,
    CPE4,
    CPS3,
    CPS4,
    CAX3,
    CAX4,
}

/// What the space around an element looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Space {
    /// Three-dimensional.
    Solid,
    /// Plane strain of a given thickness.
    PlaneStrain,
    /// Plane stress of a given thickness.
    PlaneStress,
    /// Axisymmetric about y: x is the radius; forces are those of the full circumference.
    Axisymmetric,
}

use ElementType::*;

impl ElementType {
    /// All of them.
    pub const ALL: [ElementType; 9] = [C3D4, C3D10, C3D8, CPE3, CPE4, CPS3, CPS4, CAX3, CAX4];

    /// As decks write it.
    pub const fn name(self) -> &'static str {
        match self {
            C3D4 => "C3D4",
            C3D10 => "C3D10",
            C3D8 => "C3D8",
            CPE3 => "CPE3",
            CPE4 => "CPE4",
            CPS3 => "CPS3",
            CPS4 => "CPS4",
            CAX3 => "CAX3",
            CAX4 => "CAX4",
        }
    }

    /// By name, capitals.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|t| t.name() == name)
    }

    /// Shape.
    pub const fn kind(self) -> CellKind {
        match self {
            C3D4 => CellKind::Tet4,
            C3D10 => CellKind::Tet10,
            C3D8 => CellKind::Hex8,
            CPE3 | CPS3 | CAX3 => CellKind::Tri3,
            CPE4 | CPS4 | CAX4 => CellKind::Quad4,
        }
    }

    /// Space it lives in.
    pub const fn space(self) -> Space {
        match self {
            C3D4 | C3D10 | C3D8 => Space::Solid,
            CPE3 | CPE4 => Space::PlaneStrain,
            CPS3 | CPS4 => Space::PlaneStress,
            CAX3 | CAX4 => Space::Axisymmetric,
        }
    }
}

impl Space {
    /// Translations a node has: 3 or 2.
    pub const fn dimension(self) -> usize {
        match self {
            Space::Solid => 3,
            _ => 2,
        }
    }
}
