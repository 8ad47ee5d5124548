//! Consistent nodal forces of loads: what work a load does on each shape function.

use super::LoadKind;
use crate::element::{Family, Space};
use crate::freedoms::Freedoms;
use crate::member::{self, BadMember};
use crate::structure::{Discrete, LineSection, Section, Structure};
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellId, CellKind, Face, shape};
use std::collections::BTreeMap;

/// A load that cannot be turned into forces.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LoadError {
    /// A nodal load on a freedom that its node does not have.
    #[error("node {label} has no freedom {} to be loaded: it belongs to no element that moves there", .component + 1)]
    NoFreedom {
        /// Label of the node.
        label: String,
        /// Freedom, from 0.
        component: u8,
    },
    /// Gravity on a material without density.
    #[error("gravity acts on element {label}, whose material {material} has no *DENSITY")]
    NoDensity {
        /// Label of the first such element.
        label: String,
        /// Name of the material.
        material: String,
    },
    /// Gravity across the axis of an axisymmetric model is no axisymmetric load.
    #[error("gravity on the axisymmetric element {label} must point along the axis (y)")]
    AcrossAxis {
        /// Label of the first such element.
        label: String,
    },
    /// A face that the element does not have.
    #[error("element {label} has no face S{} to press on", .face + 1)]
    NoFace {
        /// Label of the element.
        label: String,
        /// Face, from 0.
        face: u8,
    },
    /// A line that has no stiffness.
    #[error("{0}")]
    Line(#[from] BadMember),
    /// A loaded cell without element type and material.
    #[error("element {label} is loaded but has no section")]
    NoSection {
        /// Label of the element.
        label: String,
    },
}

/// Nodal forces [F] of a load of magnitude 1 by freedom, ascending, each freedom once.
pub fn unit_forces(
    load: &LoadKind,
    structure: &Structure,
    freedoms: &Freedoms,
) -> Result<Vec<(usize, f64)>, LoadError> {
    let mut forces = Forces { structure, freedoms, sum: BTreeMap::new() };
    match load {
        LoadKind::Nodal { nodes, component } => {
            nodes.iter().try_for_each(|&n| forces.add(n, usize::from(*component), 1.0))?;
        }
        LoadKind::Pressure { faces } => faces.iter().try_for_each(|&f| forces.press(f))?,
        LoadKind::Line { cells, component } => {
            let q = std::array::from_fn(|i| if i == usize::from(*component) { 1.0 } else { 0.0 });
            for &cell in cells {
                let label = || structure.mesh.cell_name(cell);
                let section = structure.line_section_of(cell);
                forces.along(section.ok_or_else(|| LoadError::NoSection { label: label() })?, cell, q)?;
            }
        }
        LoadKind::Gravity { cells, direction } => cells.iter().try_for_each(|&c| forces.weigh(c, direction))?,
    }
    Ok(forces.sum.into_iter().collect())
}

struct Forces<'a> {
    structure: &'a Structure,
    freedoms: &'a Freedoms,
    sum: BTreeMap<usize, f64>,
}

/// Largest number of nodes of a loaded cell or face.
const NODES: usize = 10;

impl Forces<'_> {
    fn add(&mut self, node: u32, component: usize, force: f64) -> Result<(), LoadError> {
        let freedom = freedom(self.structure, self.freedoms, (node, component))?;
        *self.sum.entry(freedom).or_insert(0.0) += force;
        Ok(())
    }

    fn press(&mut self, face: Face) -> Result<(), LoadError> {
        let face = PressedFace::new(face, self.structure, self.freedoms)?;
        face.forces(&[], |f, force| *self.sum.entry(f).or_insert(0.0) += force);
        Ok(())
    }

    /// A force per length q [F/L] on a truss or beam.
    fn along(&mut self, section: &LineSection, cell: CellId, q: [f64; 3]) -> Result<(), LoadError> {
        let structure = self.structure;
        let forces = member::nodal_forces(structure, section, cell, q)?;
        for (&node, force) in structure.mesh.cell(cell).iter().zip(forces) {
            // What is zero needs no freedom: across the plane, and moments of trusses.
            (0..6).filter(|&c| force[c] != 0.0).try_for_each(|c| self.add(node, c, force[c]))?;
        }
        Ok(())
    }

    /// Gravity on what has a mass: solids, trusses, beams and masses; springs and contact elements have none.
    fn weigh(&mut self, cell: CellId, direction: &[f64; 3]) -> Result<(), LoadError> {
        let structure = self.structure;
        match structure.elements[cell.block as usize].family() {
            Family::Solid => self.pull(cell, direction),
            Family::Truss | Family::Beam => {
                let label = || structure.mesh.cell_name(cell);
                let section = structure.line_section_of(cell).ok_or_else(|| LoadError::NoSection { label: label() })?;
                let bare = || LoadError::NoDensity { label: label(), material: section.name.clone() };
                let mass = section.density.ok_or_else(bare)? * section.profile.area;
                self.along(section, cell, direction.map(|d| mass * d))
            }
            Family::Mass => {
                let of_cell = |s: &&Discrete| s.cells.binary_search(&cell).is_ok();
                let mass = structure.discrete.iter().find(of_cell).map_or(0.0, |s| s.magnitude);
                let node = structure.mesh.cell(cell)[0];
                (0..structure.dimension()).try_for_each(|i| self.add(node, i, mass * direction[i]))
            }
            Family::RotaryInertia | Family::Spring | Family::Dashpot | Family::Gap | Family::Tube | Family::Rigid => {
                Ok(())
            }
        }
    }

    /// f_a = ρ ∫ N_a dV times the direction.
    fn pull(&mut self, cell: CellId, direction: &[f64; 3]) -> Result<(), LoadError> {
        let structure = self.structure;
        let mesh = &structure.mesh;
        let section = section(structure, cell)?;
        let (space, thickness) = (section.element.space(), section.thickness);
        let material = &structure.materials[section.material];
        let label = || mesh.cell_name(cell);
        let density =
            material.density.ok_or_else(|| LoadError::NoDensity { label: label(), material: material.name.clone() })?;
        if space == Space::Axisymmetric && direction[0] != 0.0 {
            return Err(LoadError::AcrossAxis { label: label() });
        }
        let kind = mesh.kind(cell);
        let nodes = mesh.cell(cell);
        let degree = match kind {
            CellKind::Tet4 => 1,
            CellKind::Tri3 => 2,
            CellKind::Tet10 => 5,
            _ => 3,
        };
        let x: Vec<[f64; 3]> = nodes.iter().map(|&n| mesh.points[n as usize]).collect();
        let mut mass = [0.0; NODES];
        for (xi, weight) in Rule::of(kind, degree).points {
            let at = Place::new(kind, &x, &xi);
            let normal = cross(&at.tangents[0], &at.tangents[1]);
            let jacobian = match kind.dimension() {
                2 => normal[2],
                _ => (0..3).map(|i| normal[i] * at.tangents[2][i]).sum(),
            };
            let measure = weight * jacobian * across(space, thickness, at.position[0]);
            mass.iter_mut().zip(at.values).for_each(|(m, value)| *m += density * value * measure);
        }
        for (node, mass) in nodes.iter().zip(mass) {
            (0..space.dimension()).try_for_each(|i| self.add(*node, i, mass * direction[i]))?;
        }
        Ok(())
    }
}

fn section(structure: &Structure, cell: CellId) -> Result<&Section, LoadError> {
    structure.section_of(cell).ok_or_else(|| LoadError::NoSection { label: structure.mesh.cell_name(cell) })
}

fn freedom(structure: &Structure, freedoms: &Freedoms, (node, component): (u32, usize)) -> Result<usize, LoadError> {
    freedoms
        .index(node as usize, component)
        .ok_or_else(|| LoadError::NoFreedom { label: structure.mesh.point_name(node), component: component as u8 })
}

/// A face of a solid that a pressure acts on.
#[derive(Clone, Debug)]
pub struct PressedFace {
    kind: CellKind,
    space: Space,
    /// Of a plane [L].
    thickness: f64,
    /// Where its nodes are at the start [L], and their translations.
    nodes: Vec<([f64; 3], [usize; 3])>,
}

impl PressedFace {
    /// With the freedoms of its nodes.
    ///
    /// # Errors
    /// Where the element has no such face or no section, or a node no freedoms.
    pub fn new(face: Face, structure: &Structure, freedoms: &Freedoms) -> Result<Self, LoadError> {
        let mesh = &structure.mesh;
        let section = section(structure, face.cell)?;
        let (space, thickness) = (section.element.space(), section.thickness);
        if usize::from(face.face) >= mesh.kind(face.cell).faces().len() {
            return Err(LoadError::NoFace { label: mesh.cell_name(face.cell), face: face.face });
        }
        let (kind, nodes) = mesh.face(face);
        let node = |&n: &u32| {
            let mut own = [0; 3];
            for (c, own) in own.iter_mut().enumerate().take(space.dimension()) {
                *own = freedom(structure, freedoms, (n, c))?;
            }
            Ok::<_, LoadError>((mesh.points[n as usize], own))
        };
        let nodes = nodes.iter().map(node).collect::<Result<_, _>>()?;
        Ok(PressedFace { kind, space, thickness, nodes })
    }

    /// Freedoms of its nodes, in the order of [`Self::forces`].
    pub fn freedoms(&self) -> impl Iterator<Item = usize> + '_ {
        self.nodes.iter().flat_map(|(_, own)| own.iter().copied().take(self.space.dimension()))
    }

    /// Force [F] of a pressure of 1 on each of the freedoms, where they have moved by `u` [L], all of the model; without one, at
    /// the start: f_a = −∫ N_a n dA, n outward. The rule is exact for the face's own polynomials.
    pub fn forces(&self, u: &[f64], mut add: impl FnMut(usize, f64)) {
        let degree = match self.kind {
            CellKind::Tri3 => 1,
            CellKind::Tri6 => 4,
            CellKind::Quad4 => 3,
            _ => 5,
        };
        let (dimension, count) = (self.space.dimension(), self.nodes.len());
        let mut x = [[0.0; 3]; NODES];
        for (x, (start, own)) in x.iter_mut().zip(&self.nodes) {
            *x = *start;
            (0..dimension).for_each(|c| x[c] += u.get(own[c]).copied().unwrap_or(0.0));
        }
        let mut force = [[0.0; 3]; NODES];
        for (xi, weight) in Rule::of(self.kind, degree).points {
            let at = Place::new(self.kind, &x[..count], &xi);
            let normal = match self.kind.dimension() {
                1 => [at.tangents[0][1], -at.tangents[0][0], 0.0],
                _ => cross(&at.tangents[0], &at.tangents[1]),
            };
            let measure = weight * across(self.space, self.thickness, at.position[0]);
            for (force, value) in force.iter_mut().zip(at.values).take(count) {
                (0..3).for_each(|i| force[i] -= value * measure * normal[i]);
            }
        }
        for ((_, own), force) in self.nodes.iter().zip(force) {
            (0..dimension).for_each(|c| add(own[c], force[c]));
        }
    }
}

/// What a length in the plane is multiplied with: thickness or circumference [L]; 1 in space.
fn across(space: Space, thickness: f64, radius: f64) -> f64 {
    match space {
        Space::Solid | Space::Plane | Space::Any => 1.0,
        Space::PlaneStrain | Space::PlaneStress => thickness,
        Space::Axisymmetric => std::f64::consts::TAU * radius,
    }
}

/// Shape functions, position and tangents ∂x/∂ξ_d at one place of a cell or face.
struct Place {
    values: [f64; NODES],
    position: [f64; 3],
    tangents: [[f64; 3]; 3],
}

impl Place {
    fn new(kind: CellKind, x: &[[f64; 3]], xi: &[f64; 3]) -> Self {
        let (mut values, mut gradients) = ([0.0; NODES], [[0.0; 3]; NODES]);
        shape::values(kind, xi, &mut values);
        shape::gradients(kind, xi, &mut gradients);
        // Tangents from the first node, so that differences keep their digits far from the origin.
        let (mut position, mut tangents, origin) = ([0.0; 3], [[0.0; 3]; 3], x[0]);
        for ((x, n), g) in x.iter().zip(&values).zip(&gradients) {
            for i in 0..3 {
                position[i] += n * x[i];
                tangents.iter_mut().zip(g).for_each(|(t, g)| t[i] += g * (x[i] - origin[i]));
            }
        }
        Place { values, position, tangents }
    }
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}
