//! Gap elements: two nodes that keep on one side of each other, or within or beyond a distance.
//!
//! With x the offset of the second node from the first, u₂ − u₁ how it changes and P = I − a aᵀ: GAPUNI
//! g = d + n·(u₂ − u₁); GAPCYL g = d − |P x| for d > 0 and |P x| − |d| for d < 0; GAPSPHER the same with P = I. Abaqus
//! Analysis User's Manual, Gap contact elements.

use crate::contact::Contact;
use crate::element::{ElementFault, Elements, Offset, each};
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::point::{ContactPoint, Measure};
use crate::summary::Origin;
use crate::tangents::Space;
use fe_core::element::ElementType;
use fe_core::{Freedoms, Structure};
use fe_mesh::CellId;
use nalgebra::Matrix3;

/// Gap elements of one type as a model holds them.
#[derive(Clone, Debug)]
pub struct GapDefinition {
    /// Name of the element set.
    pub name: String,
    /// GAPUNI, GAPCYL or GAPSPHER.
    pub element: ElementType,
    /// The elements, ascending.
    pub cells: Vec<CellId>,
    /// d [L]. GAPUNI: initial clearance, whatever the coordinates. Otherwise the largest (d > 0) or the least (d < 0)
    /// distance of the nodes, not 0.
    pub distance: f64,
    /// Direction of a GAPUNI from the first node to the second, of any length, `None`: that of the coordinates. Axis of a
    /// GAPCYL.
    pub direction: Option<[f64; 3]>,
    /// Area [L²] of each; `None`: the law's number is a force.
    pub area: Option<f64>,
    /// Index of the interaction.
    pub interaction: usize,
}

impl GapDefinition {
    /// The points of all elements, or the first element that stands for none.
    fn points(&self, bodies: (&Structure, &Freedoms)) -> Result<Vec<(CellId, ContactPoint)>, (CellId, ElementFault)> {
        each(&self.cells, |cell| self.point(cell, bodies))
    }

    /// The first element that stands for no constraint.
    pub fn check(&self, structure: &Structure) -> Result<(), (CellId, ElementFault)> {
        self.points((structure, &structure.freedoms(&[]))).map(|_| ())
    }

    fn point(&self, cell: CellId, bodies: (&Structure, &Freedoms)) -> Result<ContactPoint, ElementFault> {
        let (structure, freedoms) = bodies;
        let nodes = structure.mesh.cell(cell);
        let element = structure.mesh.cell_label(cell);
        let measure = self.area.map_or(Measure::Point, Measure::Area);
        let direction = self.direction.and_then(|d| Vec3::from(d).try_normalize(0.0));
        let across = match (self.element, direction) {
            (ElementType::GAPCYL, Some(axis)) => Matrix3::identity() - axis * axis.transpose(),
            _ => Matrix3::identity(),
        };
        let offset = Offset { node: nodes[1], carriers: vec![(nodes[0], 1.0)], across, space: Space::Solid };
        if self.element == ElementType::GAPUNI {
            let along = direction.or_else(|| offset.start(structure).map(|w| w.normalize()));
            let n = along.ok_or(ElementFault::NoDirection { element })?;
            if structure.is_plane() && n.xy().norm() == 0.0 {
                return Err(ElementFault::AcrossPlane { element });
            }
            return Ok(offset.flat(n, self.distance, measure, freedoms));
        }
        let cylinder = self.element == ElementType::GAPCYL;
        let coincident = || ElementFault::Coincident {
            element,
            kind: self.element.name(),
            coincide: if cylinder { "its nodes coincide across its axis" } else { "its nodes coincide" },
        };
        offset.apart(self.distance, measure, bodies).ok_or_else(coincident)
    }
}

impl Contact {
    /// Of gap elements; the second nodes are the secondary side.
    pub fn of_gaps(
        bodies: (&Structure, &Freedoms),
        definition: &GapDefinition,
        interaction: &Interaction,
    ) -> Result<Self, ElementFault> {
        let points = definition.points(bodies).map_err(|(_, fault)| fault)?;
        let mesh = &bodies.0.mesh;
        let elements = Elements {
            name: definition.name.clone(),
            origin: Origin::Elements(definition.element),
            main_nodes: definition.cells.iter().map(|&cell| mesh.cell(cell)[0]).collect(),
            points,
            notes: Vec::new(),
        };
        Ok(Contact::of_elements(bodies, elements, interaction))
    }
}
