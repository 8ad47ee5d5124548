//! Blocks of like solid elements: the term, stresses and strains. Small displacements, isotropic linear elasticity.
//!
//! Triangles and tetrahedra are the plain displacement elements. Linear quadrilaterals and hexahedra carry
//! enhanced strains, described in the element kernel (`solid/kernel`): they do not lock in bending, nor (all but
//! CPS4, which has no need) near incompressibility.
#![allow(clippy::needless_range_loop)] // index loops read like the formulas

mod check;
mod kernel;
mod recovery;
pub(crate) mod tables;
mod term;

#[cfg(test)]
mod tests;

pub use check::{BadElement, Defect, FoldedCorner, Place, check};
pub use recovery::PointFields;

use crate::element::{ElementType, Family, Space};
use crate::freedoms::Freedoms;
use crate::lanes::{LANES, Lanes};
use crate::material::Elastic;
use crate::matrix::{Pattern, Scatter};
use crate::structure::{Section, Structure};
use fe_mesh::{CellId, Mesh};
use std::sync::{Arc, Mutex};

/// The elements of one section: one type, one material.
pub struct SolidBlock {
    name: String,
    element: ElementType,
    elastic: Elastic,
    thickness: f64,
    cells: Vec<CellId>,
    /// Node indices, `[cells × nodes]`.
    nodes: Vec<u32>,
    /// First freedom of each node, `[cells × nodes]`.
    starts: Vec<u32>,
    /// Coordinates [L], eight cells side by side (the last one repeated), `[batches][nodes × directions]`.
    coordinates: Vec<Lanes>,
    /// Volume of each cell [L³].
    volumes: Vec<f64>,
    /// Number of freedoms of the scene.
    freedoms: usize,
    /// Where the elements stand in the stiffness of the pattern seen last.
    scatter: Mutex<Option<(Arc<Pattern>, Arc<Scatter>)>>,
}

impl SolidBlock {
    /// From a section, every cell of it checked.
    ///
    /// # Panics
    /// When `freedoms` lacks the translations of a cell's node ([`Structure::freedoms`] has them all), or a cell
    /// is not of the section's element type, or that is no solid.
    pub fn new(structure: &Structure, section: &Section, freedoms: &Freedoms) -> Result<Self, BadElement> {
        let (mesh, element) = (&structure.mesh, section.element);
        assert_eq!(element.family(), Family::Solid, "a block of solids holds solids");
        let directions = element.space().dimension();
        let volumes = check::volumes(mesh, section)?;
        let mut nodes = Vec::with_capacity(section.cells.len() * element.kind().nodes());
        for &cell in &section.cells {
            assert_eq!(mesh.kind(cell), element.kind(), "a section holds cells of its element type");
            nodes.extend_from_slice(mesh.cell(cell));
        }
        let start = |&node: &u32| {
            let own = freedoms.of_node(node as usize);
            assert!(own.len() >= directions, "the nodes of elements have their translations");
            own.start as u32
        };
        let starts = nodes.iter().map(start).collect();
        let material = &structure.materials[section.material];
        Ok(SolidBlock {
            name: format!("{} elements of {}", element.name(), material.name),
            element,
            elastic: material.response.elastic(),
            thickness: section.thickness,
            cells: section.cells.clone(),
            coordinates: local_coordinates(mesh, element, &nodes),
            nodes,
            starts,
            volumes,
            freedoms: freedoms.len(),
            scatter: Mutex::new(None),
        })
    }

    /// Element type of all cells.
    pub fn element(&self) -> ElementType {
        self.element
    }

    /// The cells, in the order of all results.
    pub fn cells(&self) -> &[CellId] {
        &self.cells
    }

    /// Node indices, `[cells × nodes]`.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// Volume of each cell [L³]: of the full circumference around an axis, with the thickness in the plane.
    pub fn volumes(&self) -> &[f64] {
        &self.volumes
    }

    /// Integration points of a cell.
    pub fn points(&self) -> usize {
        tables::rule(self.element).points.len()
    }

    fn nodes_per_cell(&self) -> usize {
        self.element.kind().nodes()
    }

    /// Displacements of the cells' nodes, packed like the coordinates.
    fn displacements(&self, cells: std::ops::Range<usize>, u: &[f64]) -> Vec<Lanes> {
        let n = self.nodes_per_cell();
        let starts = &self.starts[cells.start * n..cells.end * n];
        pack(starts, n, self.element.space().dimension(), |start, i| u[start as usize + i])
    }
}

/// Coordinates of the cells' nodes [L] from the first node of each cell, so that differences keep their digits far from
/// the origin; radii stay what they are.
fn local_coordinates(mesh: &Mesh, element: ElementType, nodes: &[u32]) -> Vec<Lanes> {
    let (per_cell, directions) = (element.kind().nodes(), element.space().dimension());
    let axisymmetric = element.space() == Space::Axisymmetric;
    let places: Vec<u32> = (0..nodes.len() as u32).collect();
    pack(&places, per_cell, directions, |place, i| {
        let first = place as usize / per_cell * per_cell;
        let [x, origin] = [place as usize, first].map(|place| mesh.points[nodes[place] as usize][i]);
        if axisymmetric && i == 0 { x } else { x - origin }
    })
}

/// Numbers of nodes, eight cells side by side, the last cell repeated: `[batches][nodes × directions]`.
fn pack(nodes: &[u32], per_cell: usize, directions: usize, value: impl Fn(u32, usize) -> f64) -> Vec<Lanes> {
    let mut packed = Vec::with_capacity(nodes.len().div_ceil(per_cell * LANES) * per_cell * directions);
    for batch in nodes.chunks(per_cell * LANES) {
        let last = batch.len() / per_cell - 1;
        for a in 0..per_cell {
            for i in 0..directions {
                packed.push(Lanes(std::array::from_fn(|lane| value(batch[lane.min(last) * per_cell + a], i))));
            }
        }
    }
    packed
}

/// Runs `$body` with the kernel of the block's element type.
macro_rules! with_kernel {
    ($block:expr, $kernel:ident => $body:expr) => {{
        use $crate::element::ElementType::*;
        use $crate::solid::kernel::Element;
        let (element, elastic, thickness) = ($block.element, &$block.elastic, $block.thickness);
        match element {
            C3D4 => with_kernel!(@ 4, 4, 4, 3, 3, 1, 0; element, elastic, thickness, $kernel => $body),
            C3D10 => with_kernel!(@ 10, 10, 10, 3, 3, 4, 0; element, elastic, thickness, $kernel => $body),
            C3D8 => with_kernel!(@ 8, 4, 7, 3, 3, 8, 13; element, elastic, thickness, $kernel => $body),
            CPE3 | CPS3 => with_kernel!(@ 3, 3, 3, 2, 2, 1, 0; element, elastic, thickness, $kernel => $body),
            CPE4 => with_kernel!(@ 4, 1, 3, 2, 2, 4, 5; element, elastic, thickness, $kernel => $body),
            CPS4 => with_kernel!(@ 4, 1, 3, 2, 2, 4, 4; element, elastic, thickness, $kernel => $body),
            CAX3 => with_kernel!(@ 3, 3, 3, 2, 3, 3, 0; element, elastic, thickness, $kernel => $body),
            CAX4 => with_kernel!(@ 4, 4, 6, 2, 3, 4, 5; element, elastic, thickness, $kernel => $body),
            other => unreachable!("{} is no solid", other.name()),
        }
    }};
    (@ $n:literal, $r:literal, $m:literal, $d:literal, $g:literal, $p:literal, $a:literal;
        $element:ident, $elastic:ident, $thickness:ident, $kernel:ident => $body:expr) => {{
        let $kernel = Element::<$n, $r, $m, $d, $g, $p, $a>::new($element, $elastic, $thickness);
        $body
    }};
}
use with_kernel;
