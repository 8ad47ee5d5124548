//! Trusses, beams and springs: elements of few freedoms, whose strains are linear in them and whose moduli are constant.
//!
//! Each element is some integration points, each point the rates B of its strains: strain = B u, force Σ w Bᵀ D B u. Small
//! displacements.

pub(crate) mod beam;
mod spring;
mod term;
mod truss;

#[cfg(test)]
mod tests;

use crate::element::{ElementType, Family};
use crate::freedoms::Freedoms;
use crate::structure::{Discrete, LineSection, Structure};
use fe_mesh::{CellId, Mesh};

/// An element that has no stiffness.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("element {label} ({}) {defect}", .element.name())]
pub struct BadMember {
    /// The cell.
    pub cell: CellId,
    /// Its label.
    pub label: String,
    /// Its element type.
    pub element: ElementType,
    /// What is wrong.
    pub defect: Defect,
}

/// What is wrong with a line.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Defect {
    /// Its ends coincide.
    #[error("has no length: its nodes are in one place")]
    NoLength,
    /// The mid node is so far out that the line folds.
    #[error("is folded: its mid node is not between its ends")]
    Folded,
    /// Axis 1 of the cross-section runs along the line.
    #[error("lies along axis 1 of its cross-section: give a direction n1 across the beam")]
    AlongFirstAxis,
}

/// One integration point of an element: its weight [L] (1 for springs), and of each strain the rates with all six freedoms
/// of every node, `[strains × nodes]`.
struct Point {
    weight: f64,
    rates: Vec<[f64; 6]>,
}

/// State of a truss at an integration point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniaxial {
    /// Strain [-].
    pub strain: f64,
    /// Stress [F/L²], tension positive.
    pub stress: f64,
    /// Unit direction of the line.
    pub direction: [f64; 3],
}

/// The elements of one section of trusses, beams or springs.
#[derive(Clone, Debug)]
pub struct Members {
    name: String,
    element: ElementType,
    cells: Vec<CellId>,
    /// Node indices, `[cells × nodes]`.
    nodes: Vec<u32>,
    /// Freedoms, `[cells × per cell]`.
    freedoms: Vec<u32>,
    per_cell: usize,
    /// Strains at a point.
    strains: usize,
    /// Integration points of a cell.
    points: usize,
    /// `[cells × points]`.
    weights: Vec<f64>,
    /// `[cells × points × strains × freedoms per cell]`.
    rates: Vec<f64>,
    /// D, `[strains × strains]`.
    moduli: Vec<f64>,
    /// Area of the cross-section [L²]; 1 for springs.
    area: f64,
}

impl Members {
    /// Trusses or beams; the first bad one is the error.
    pub fn lines(structure: &Structure, section: &LineSection, freedoms: &Freedoms) -> Result<Self, BadMember> {
        let (moduli, points) = line_moduli(section);
        let mask = section.element.freedoms(structure.dimension());
        let members = Members {
            name: format!("{} elements of {}", section.element.name(), section.name),
            area: section.profile.area,
            ..Members::empty(section.element, points, moduli)
        };
        members.filled(structure, &section.cells, &[mask; 3], freedoms, |mesh, cell| line_points(mesh, section, cell))
    }

    /// Springs; the first bad one is the error.
    pub fn springs(structure: &Structure, section: &Discrete, freedoms: &Freedoms) -> Result<Self, BadMember> {
        let element = section.element;
        let masks = match element {
            ElementType::SPRINGA => [element.freedoms(structure.dimension()); 2],
            _ => section.components.map(|component| 1 << component),
        };
        let members = Members {
            name: format!("{} elements of stiffness {}", element.name(), section.magnitude),
            ..Members::empty(element, 1, vec![section.magnitude])
        };
        members.filled(structure, &section.cells, &masks, freedoms, |mesh, cell| {
            spring::rates(mesh, section, cell).map(|rates| vec![Point { weight: 1.0, rates }])
        })
    }

    fn empty(element: ElementType, points: usize, moduli: Vec<f64>) -> Self {
        Members {
            name: String::new(),
            element,
            cells: Vec::new(),
            nodes: Vec::new(),
            freedoms: Vec::new(),
            per_cell: 0,
            strains: moduli.len().isqrt(),
            points,
            weights: Vec::new(),
            rates: Vec::new(),
            moduli,
            area: 1.0,
        }
    }

    /// With cells, whose nodes take part by the freedoms of `masks`.
    fn filled(
        mut self,
        structure: &Structure,
        cells: &[CellId],
        masks: &[u8],
        freedoms: &Freedoms,
        points: impl Fn(&Mesh, CellId) -> Result<Vec<Point>, Defect>,
    ) -> Result<Self, BadMember> {
        let mesh = &structure.mesh;
        for &cell in cells {
            let bad = |defect| BadMember { cell, label: mesh.cell_name(cell), element: self.element, defect };
            let points = points(mesh, cell).map_err(bad)?;
            let nodes = mesh.cell(cell);
            let own = |mask: u8| (0..6).filter(move |c| mask >> c & 1 == 1);
            let places: Vec<(usize, usize)> =
                (0..nodes.len()).flat_map(|a| own(masks[a]).map(move |c| (a, c))).collect();
            self.per_cell = places.len();
            self.nodes.extend_from_slice(nodes);
            self.freedoms.extend(places.iter().map(|&(a, c)| {
                let freedom = freedoms.index(nodes[a] as usize, c);
                freedom.expect("a structure gives the nodes of elements their freedoms") as u32
            }));
            for point in points {
                self.weights.push(point.weight);
                for strain in point.rates.chunks_exact(nodes.len()) {
                    self.rates.extend(places.iter().map(|&(a, c)| strain[a][c]));
                }
            }
            self.cells.push(cell);
        }
        Ok(self)
    }

    /// Element type of all cells.
    pub fn element(&self) -> ElementType {
        self.element
    }

    /// The cells, in the order of all results.
    pub fn cells(&self) -> &[CellId] {
        &self.cells
    }

    /// Integration points of a cell.
    pub fn points(&self) -> usize {
        self.points
    }
}

/// The first line that has no stiffness.
pub fn check(structure: &Structure, section: &LineSection) -> Result<(), BadMember> {
    let mesh = &structure.mesh;
    section.cells.iter().try_for_each(|&cell| {
        let bad = |defect| BadMember { cell, label: mesh.cell_name(cell), element: section.element, defect };
        line_points(mesh, section, cell).map(|_| ()).map_err(bad)
    })
}

/// The first spring along a line that has none.
pub fn check_springs(structure: &Structure, section: &Discrete) -> Result<(), BadMember> {
    let mesh = &structure.mesh;
    section.cells.iter().try_for_each(|&cell| {
        let bad = |defect| BadMember { cell, label: mesh.cell_name(cell), element: section.element, defect };
        spring::rates(mesh, section, cell).map(|_| ()).map_err(bad)
    })
}

/// Nodal forces and moments, x, y, z each, of a force per length q [F/L] over a whole truss or beam: the work of q on the
/// displacements.
pub fn nodal_forces(
    structure: &Structure,
    section: &LineSection,
    cell: CellId,
    q: [f64; 3],
) -> Result<Vec<[f64; 6]>, BadMember> {
    let (mesh, element) = (&structure.mesh, section.element);
    let x: Vec<[f64; 3]> = mesh.cell(cell).iter().map(|&n| mesh.points[n as usize]).collect();
    match element.family() {
        Family::Beam => beam::nodal_forces(element, [x[0], x[1]], q).map_err(|defect| BadMember {
            cell,
            label: mesh.cell_name(cell),
            element,
            defect,
        }),
        _ => Ok(truss::nodal_forces(mesh.kind(cell), &x, q)),
    }
}

/// D, and the number of integration points.
fn line_moduli(section: &LineSection) -> (Vec<f64>, usize) {
    match section.element.family() {
        Family::Beam => (beam::moduli(section), beam::points(section.element)),
        _ => (vec![section.young * section.profile.area], truss::points(section.element)),
    }
}

fn line_points(mesh: &Mesh, section: &LineSection, cell: CellId) -> Result<Vec<Point>, Defect> {
    let x: Vec<[f64; 3]> = mesh.cell(cell).iter().map(|&n| mesh.points[n as usize]).collect();
    match section.element.family() {
        Family::Beam => beam::integration(section.element, [x[0], x[1]], section.first_axis),
        _ => truss::integration(mesh.kind(cell), &x),
    }
}

/// Parts of a line's length, or of a direction's, that are round-off.
const ROUND_OFF: f64 = 1e-12;

/// From a to b: unit direction and length [L].
fn along(a: &[f64; 3], b: &[f64; 3]) -> Result<([f64; 3], f64), Defect> {
    let d: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
    let length = norm(&d);
    let size = a.iter().chain(b).fold(0.0f64, |m, x| m.max(x.abs()));
    if length <= ROUND_OFF * size || length == 0.0 {
        Err(Defect::NoLength)
    } else {
        Ok((d.map(|d| d / length), length))
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn norm(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}
