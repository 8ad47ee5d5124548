//! The bodies of a scene: mesh, element types, materials and sections.

use crate::element::{ElementType, Space};
use crate::freedoms::Freedoms;
use crate::material::Material;
use fe_mesh::{CellId, Mesh};

/// Cells of one element type with one material: a block of like elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Element type of every cell.
    pub element: ElementType,
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// Index into [`Structure::materials`].
    pub material: usize,
    /// Thickness [L] of plane elements; 1 otherwise.
    pub thickness: f64,
}

/// Mesh, materials and sections. Every mesh block is of one element type; points that belong to no cell
/// (reference nodes, unused nodes) are allowed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// Points, cells, sets and element-based surfaces.
    pub mesh: Mesh,
    /// Element type of each mesh block.
    pub elements: Vec<ElementType>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Sections; together they hold every cell exactly once.
    pub sections: Vec<Section>,
}

impl Structure {
    /// True when the scene is plane or axisymmetric. All element types live in the same dimension.
    pub fn is_plane(&self) -> bool {
        self.elements.iter().any(|e| e.space() != Space::Solid)
    }

    /// True when the scene is axisymmetric.
    pub fn is_axisymmetric(&self) -> bool {
        self.elements.iter().any(|e| e.space() == Space::Axisymmetric)
    }

    /// The freedoms, a bit each, of a node of elements and of the reference node of a rigid body. A rigid body around
    /// an axis moves along it: radial motion and turning would strain it.
    pub fn freedom_masks(&self) -> (u8, u8) {
        match (self.is_axisymmetric(), self.is_plane()) {
            (true, _) => (0b11, 0b10),
            (_, true) => (0b11, 0b100011),
            _ => (0b111, 0b111111),
        }
    }

    /// Section of a cell.
    pub fn section_of(&self, cell: CellId) -> Option<&Section> {
        self.sections.iter().find(|s| s.cells.binary_search(&cell).is_ok())
    }

    /// The freedoms of all nodes: translations where an element is, and on each of `references` (nodes that
    /// carry a rigid body) the rigid motions of the space.
    pub fn freedoms(&self, references: &[u32]) -> Freedoms {
        let (node, rigid) = self.freedom_masks();
        let mut masks = vec![0u8; self.mesh.points.len()];
        for section in &self.sections {
            for &cell in &section.cells {
                self.mesh.cell(cell).iter().for_each(|&n| masks[n as usize] |= node);
            }
        }
        references.iter().for_each(|&n| masks[n as usize] |= rigid);
        Freedoms::new(&masks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rigid_body_has_the_motions_of_its_space() {
        let masks = |element| Structure { elements: vec![element], ..Structure::default() }.freedom_masks();
        assert_eq!(masks(ElementType::C3D10), (0b111, 0b111111));
        assert_eq!(masks(ElementType::CPS4), (0b11, 0b100011));
        assert_eq!(masks(ElementType::CAX4), (0b11, 0b10));
    }
}
