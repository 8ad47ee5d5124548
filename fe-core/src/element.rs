//! The element types that decks name.

use fe_mesh::CellKind;

/// An element type.
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
    C3D8R,
    CPE4R,
    CPS4R,
    CAX4R,
    T2D2,
    T3D2,
    T3D3,
    B21,
    B23,
    B31,
    B33,
    SPRING1,
    SPRING2,
    SPRINGA,
    DASHPOT1,
    DASHPOT2,
    DASHPOTA,
    MASS,
    ROTARYI,
    GAPUNI,
    GAPCYL,
    GAPSPHER,
    ITT21,
    ITT31,
    R2D2,
    R3D3,
    R3D4,
}

/// What kind of thing an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Family {
    /// A part of a body, with stress in all of it.
    Solid,
    /// A line with a force along it.
    Truss,
    /// A line that bends and twists.
    Beam,
    /// A stiffness of a node or between two.
    Spring,
    /// A viscosity of a node or between two.
    Dashpot,
    /// The mass of a node.
    Mass,
    /// The rotary inertia of a node.
    RotaryInertia,
    /// Contact between two nodes.
    Gap,
    /// Contact of a node with a line of others, tube in tube.
    Tube,
    /// A facet of a rigid body, whose nodes follow its reference node.
    Rigid,
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
    /// A line in the plane, which has no thickness.
    Plane,
    /// That of the other elements; by itself three-dimensional.
    Any,
}

use ElementType::*;

/// One line an element: type, name, shape, family, space.
const TABLE: [(ElementType, &str, CellKind, Family, Space); 36] = [
    (C3D4, "C3D4", CellKind::Tet4, Family::Solid, Space::Solid),
    (C3D10, "C3D10", CellKind::Tet10, Family::Solid, Space::Solid),
    (C3D8, "C3D8", CellKind::Hex8, Family::Solid, Space::Solid),
    (CPE3, "CPE3", CellKind::Tri3, Family::Solid, Space::PlaneStrain),
    (CPE4, "CPE4", CellKind::Quad4, Family::Solid, Space::PlaneStrain),
    (CPS3, "CPS3", CellKind::Tri3, Family::Solid, Space::PlaneStress),
    (CPS4, "CPS4", CellKind::Quad4, Family::Solid, Space::PlaneStress),
    (CAX3, "CAX3", CellKind::Tri3, Family::Solid, Space::Axisymmetric),
    (CAX4, "CAX4", CellKind::Quad4, Family::Solid, Space::Axisymmetric),
    (C3D8R, "C3D8R", CellKind::Hex8, Family::Solid, Space::Solid),
    (CPE4R, "CPE4R", CellKind::Quad4, Family::Solid, Space::PlaneStrain),
    (CPS4R, "CPS4R", CellKind::Quad4, Family::Solid, Space::PlaneStress),
    (CAX4R, "CAX4R", CellKind::Quad4, Family::Solid, Space::Axisymmetric),
    (T2D2, "T2D2", CellKind::Line2, Family::Truss, Space::Plane),
    (T3D2, "T3D2", CellKind::Line2, Family::Truss, Space::Solid),
    (T3D3, "T3D3", CellKind::Line3, Family::Truss, Space::Solid),
    (B21, "B21", CellKind::Line2, Family::Beam, Space::Plane),
    (B23, "B23", CellKind::Line2, Family::Beam, Space::Plane),
    (B31, "B31", CellKind::Line2, Family::Beam, Space::Solid),
    (B33, "B33", CellKind::Line2, Family::Beam, Space::Solid),
    (SPRING1, "SPRING1", CellKind::Point1, Family::Spring, Space::Any),
    (SPRING2, "SPRING2", CellKind::Line2, Family::Spring, Space::Any),
    (SPRINGA, "SPRINGA", CellKind::Line2, Family::Spring, Space::Any),
    (DASHPOT1, "DASHPOT1", CellKind::Point1, Family::Dashpot, Space::Any),
    (DASHPOT2, "DASHPOT2", CellKind::Line2, Family::Dashpot, Space::Any),
    (DASHPOTA, "DASHPOTA", CellKind::Line2, Family::Dashpot, Space::Any),
    (MASS, "MASS", CellKind::Point1, Family::Mass, Space::Any),
    (ROTARYI, "ROTARYI", CellKind::Point1, Family::RotaryInertia, Space::Any),
    (GAPUNI, "GAPUNI", CellKind::Line2, Family::Gap, Space::Any),
    (GAPCYL, "GAPCYL", CellKind::Line2, Family::Gap, Space::Any),
    (GAPSPHER, "GAPSPHER", CellKind::Line2, Family::Gap, Space::Any),
    (ITT21, "ITT21", CellKind::Point1, Family::Tube, Space::Plane),
    (ITT31, "ITT31", CellKind::Point1, Family::Tube, Space::Solid),
    (R2D2, "R2D2", CellKind::Line2, Family::Rigid, Space::Plane),
    (R3D3, "R3D3", CellKind::Tri3, Family::Rigid, Space::Solid),
    (R3D4, "R3D4", CellKind::Quad4, Family::Rigid, Space::Solid),
];

/// The first types of the table.
const fn first<const N: usize>() -> [ElementType; N] {
    let (mut types, mut i) = ([C3D4; N], 0);
    while i < N {
        types[i] = TABLE[i].0;
        i += 1;
    }
    types
}

impl ElementType {
    /// All of them.
    pub const ALL: [ElementType; TABLE.len()] = first();

    /// The solids with as many integration points as they need.
    pub const SOLIDS: [ElementType; 9] = first();

    /// The solids with one integration point, for explicit steps: hourglass control holds the rest of their shape.
    pub const REDUCED: [ElementType; 4] = [C3D8R, CPE4R, CPS4R, CAX4R];

    /// As decks write it.
    pub const fn name(self) -> &'static str {
        TABLE[self as usize].1
    }

    /// By name, capitals.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|t| t.name() == name)
    }

    /// Shape.
    pub const fn kind(self) -> CellKind {
        TABLE[self as usize].2
    }

    /// What kind of thing it is.
    pub const fn family(self) -> Family {
        TABLE[self as usize].3
    }

    /// Space it lives in.
    pub const fn space(self) -> Space {
        TABLE[self as usize].4
    }

    /// The freedoms, a bit each, that the element gives to its nodes in a space of so many dimensions: translations,
    /// and rotations where it bends; facets of rigid bodies give none. What the section of a spring or dashpot names comes on top.
    pub const fn freedoms(self, dimension: usize) -> u8 {
        match (self, dimension) {
            (SPRING1 | SPRING2 | DASHPOT1 | DASHPOT2 | R2D2 | R3D3 | R3D4, _) => 0,
            (ROTARYI, 2) => 0b100000,
            (ROTARYI, _) => 0b111000,
            (B21 | B23, _) => 0b100011,
            (B31 | B33, _) => 0b111111,
            (_, 2) => 0b11,
            _ => 0b111,
        }
    }
}

impl Space {
    /// Translations a node has: 3 or 2.
    pub const fn dimension(self) -> usize {
        match self {
            Space::Solid | Space::Any => 3,
            _ => 2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_stands_in_the_order_of_the_types() {
        for (i, entry) in TABLE.iter().enumerate() {
            assert_eq!(entry.0 as usize, i, "{}", entry.1);
            assert_eq!(ElementType::from_name(entry.1), Some(entry.0));
            let solid = ElementType::SOLIDS.contains(&entry.0) || ElementType::REDUCED.contains(&entry.0);
            assert_eq!(solid, entry.3 == Family::Solid, "{}", entry.1);
        }
    }
}
