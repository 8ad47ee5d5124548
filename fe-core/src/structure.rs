//! The bodies of a scene: mesh, element types, materials and sections.

use crate::element::{ElementType, Space};
use crate::freedoms::Freedoms;
use crate::material::Material;
pub use crate::section::{Discrete, Hourglass, HourglassControl, LineSection, Profile, RotaryInertia, Section};
use fe_mesh::{CellId, Mesh};

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
    /// Sections of solids; with those below they hold every cell exactly once that is neither a contact element
    /// nor a facet of a rigid body.
    pub sections: Vec<Section>,
    /// Trusses and beams.
    pub lines: Vec<LineSection>,
    /// Springs, dashpots and masses.
    pub discrete: Vec<Discrete>,
    /// Rotary inertias.
    pub rotary: Vec<RotaryInertia>,
    /// Nodes of slide lines, which have the freedoms of the elements that follow them.
    pub slide_nodes: Vec<u32>,
}

impl Structure {
    /// True when the scene is plane or axisymmetric. All element types live in the same dimension.
    pub fn is_plane(&self) -> bool {
        self.elements.iter().any(|e| e.space().dimension() == 2)
    }

    /// True when the scene is axisymmetric.
    pub fn is_axisymmetric(&self) -> bool {
        self.elements.iter().any(|e| e.space() == Space::Axisymmetric)
    }

    /// Translations a node of elements has: 3 or 2.
    pub fn dimension(&self) -> usize {
        if self.is_plane() { 2 } else { 3 }
    }

    /// The freedoms, a bit each, of the reference node of a rigid body: the rigid motions of the space. A rigid body
    /// around an axis moves along it: radial motion and turning would strain it.
    pub fn rigid_mask(&self) -> u8 {
        match (self.is_axisymmetric(), self.is_plane()) {
            (true, _) => 0b10,
            (_, true) => 0b100011,
            _ => 0b111111,
        }
    }

    /// The freedoms, a bit each, that elements give to each node, `[points]`.
    pub fn masks(&self) -> Vec<u8> {
        let dimension = self.dimension();
        let mut masks = vec![0u8; self.mesh.points.len()];
        for (block, element) in self.mesh.blocks.iter().zip(&self.elements) {
            block.nodes.iter().for_each(|&n| masks[n as usize] |= element.freedoms(dimension));
        }
        let translations = (1 << dimension) - 1;
        self.slide_nodes.iter().for_each(|&n| masks[n as usize] |= translations);
        for section in self.discrete.iter().filter(|s| s.element.freedoms(dimension) == 0) {
            for &cell in &section.cells {
                let nodes = self.mesh.cell(cell).iter().zip(section.components);
                nodes.for_each(|(&n, component)| masks[n as usize] |= 1 << component);
            }
        }
        masks
    }

    /// The cells of every section: solids, trusses and beams, springs and the like, rotary inertias.
    pub fn section_cells(&self) -> impl Iterator<Item = &[CellId]> {
        let solids = self.sections.iter().map(|s| s.cells.as_slice());
        let lines = self.lines.iter().map(|s| s.cells.as_slice());
        let discrete = self.discrete.iter().map(|s| s.cells.as_slice());
        solids.chain(lines).chain(discrete).chain(self.rotary.iter().map(|s| s.cells.as_slice()))
    }

    /// Section of a truss or beam.
    pub fn line_section_of(&self, cell: CellId) -> Option<&LineSection> {
        self.lines.iter().find(|s| s.cells.binary_search(&cell).is_ok())
    }

    /// Section of a solid cell.
    pub fn section_of(&self, cell: CellId) -> Option<&Section> {
        self.sections.iter().find(|s| s.cells.binary_search(&cell).is_ok())
    }

    /// The freedoms of all nodes: those of the elements at each, and on each of `references` (nodes that carry a rigid
    /// body) the rigid motions of the space.
    pub fn freedoms(&self, references: &[u32]) -> Freedoms {
        let mut masks = self.masks();
        references.iter().for_each(|&n| masks[n as usize] |= self.rigid_mask());
        Freedoms::new(&masks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fe_mesh::CellBlock;

    #[test]
    fn a_rigid_body_has_the_motions_of_its_space() {
        let mask = |element| Structure { elements: vec![element], ..Structure::default() }.rigid_mask();
        assert_eq!(mask(ElementType::C3D10), 0b111111);
        assert_eq!(mask(ElementType::CPS4), 0b100011);
        assert_eq!(mask(ElementType::CAX4), 0b10);
    }

    /// One element of each type, side by side on nodes of their own.
    fn masks(elements: &[ElementType]) -> Vec<u8> {
        let mut structure = Structure { elements: elements.to_vec(), ..Structure::default() };
        let points = &mut structure.mesh.points;
        for element in elements {
            let first = points.len() as u32;
            points.extend(vec![[0.0; 3]; element.kind().nodes()]);
            let nodes = (first..points.len() as u32).collect();
            structure.mesh.blocks.push(CellBlock { nodes, ..CellBlock::new(element.kind()) });
        }
        structure.masks()
    }

    #[test]
    fn nodes_have_the_freedoms_of_their_elements() {
        use ElementType::*;
        assert_eq!(masks(&[SPRING1, T3D2, B33]), [0, 0b111, 0b111, 0b111111, 0b111111]);
        assert_eq!(masks(&[MASS, T2D2, B23]), [0b11, 0b11, 0b11, 0b100011, 0b100011]);
        assert_eq!(masks(&[GAPUNI, ITT21]), [0b11; 3]);
        assert_eq!(masks(&[GAPUNI, SPRINGA]), [0b111; 4]);
    }
}
