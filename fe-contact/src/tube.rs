//! Tube-to-tube elements: the nodes of an inner pipe within an outer one, or beside it, whose nodes are a slide line.
//!
//! With r = x − X from the nearest point of the line: g = c − |r| for a clearance c ≥ 0 (tube in tube), |r| − |c| for
//! c < 0 (side by side, |c| the sum of the outer radii). Abaqus Analysis User's Manual, Tube-to-tube contact elements.

use crate::contact::Contact;
use crate::element::{ElementFault, Elements, Offset, each};
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::point::{ContactPoint, Measure};
use crate::slide_line::{Curve, SlideLine, nearest};
use crate::summary::Origin;
use crate::tangents::Space;
use fe_core::element::ElementType;
use fe_core::{Freedoms, Structure};
use fe_mesh::CellId;
use nalgebra::Matrix3;

/// Tube-to-tube elements of one type on one slide line as a model holds them.
#[derive(Clone, Debug)]
pub struct TubeDefinition {
    /// Name of the element set.
    pub name: String,
    /// ITT21 or ITT31.
    pub element: ElementType,
    /// The elements, ascending.
    pub cells: Vec<CellId>,
    /// Radial clearance c [L].
    pub clearance: f64,
    /// The outer pipe.
    pub line: SlideLine,
    /// Index of the interaction.
    pub interaction: usize,
}

/// The clearance that stands for none, of the distance of the line's nodes [-]: pipes without clearance that begin
/// concentric need a circle, however small, on which they meet.
const NO_CLEARANCE: f64 = 1e-9;

/// An element and its point.
type Placed = (CellId, Option<ContactPoint>);

impl TubeDefinition {
    /// The points of all elements, `None` past the ends of the line, or the first element that stands for none.
    fn points(&self, bodies: (&Structure, &Freedoms)) -> Result<Vec<Placed>, (CellId, ElementFault)> {
        let curves = self.line.curves();
        each(&self.cells, |cell| self.point(cell, &curves, bodies))
    }

    /// The first element that stands for no constraint.
    pub fn check(&self, structure: &Structure) -> Result<(), (CellId, ElementFault)> {
        self.points((structure, &structure.freedoms(&[]))).map(|_| ())
    }

    fn point(
        &self,
        cell: CellId,
        curves: &[Curve],
        bodies: (&Structure, &Freedoms),
    ) -> Result<Option<ContactPoint>, ElementFault> {
        let (structure, _) = bodies;
        let node = structure.mesh.cell(cell)[0];
        let (element, kind) = (structure.mesh.cell_label(cell), self.element.name());
        if self.line.nodes.contains(&node) {
            return Err(ElementFault::OnItsLine { element, kind });
        }
        let Some(foot) = nearest(curves, structure, node) else { return Ok(None) };
        let tangent = Vec3::from(foot.tangent);
        let offset = Offset { node, carriers: foot.weights, across: Matrix3::identity(), space: Space::Led(tangent) };
        let point = match offset.start(structure) {
            Some(r) if self.clearance == 0.0 => Some(offset.flat(-r.normalize(), -r.norm(), Measure::Point, bodies.1)),
            Some(_) => offset.apart(self.clearance, Measure::Point, bodies),
            None => {
                let across = Matrix3::identity() - tangent * tangent.transpose();
                Offset { across, ..offset }.apart(self.concentric_clearance(structure), Measure::Point, bodies)
            }
        };
        point.map(Some).ok_or(ElementFault::Coincident { element, kind, coincide: "its node lies on its slide line" })
    }

    fn concentric_clearance(&self, structure: &Structure) -> f64 {
        if self.clearance == 0.0 { NO_CLEARANCE * self.line.spacing(structure) } else { self.clearance }
    }
}

impl Contact {
    /// Of tube-to-tube elements; their nodes are the secondary side, the slide line's the main one.
    pub fn of_tubes(
        bodies: (&Structure, &Freedoms),
        definition: &TubeDefinition,
        interaction: &Interaction,
    ) -> Result<Self, ElementFault> {
        let points = definition.points(bodies).map_err(|(_, fault)| fault)?;
        let (name, mesh) = (&definition.name, &bodies.0.mesh);
        let mut notes = Vec::new();
        let past: Vec<u64> =
            points.iter().filter(|(_, p)| p.is_none()).map(|(cell, _)| mesh.cell_label(*cell)).collect();
        if let Some(first) = past.first() {
            let count = past.len();
            notes.push(format!(
                "warning: {count} elements of {name} lie past the ends of their slide line and touch nothing, the first is \
                 {first}"
            ));
        }
        if definition.clearance == 0.0 && points.iter().any(|(_, p)| p.as_ref().is_some_and(|p| p.round.is_some())) {
            let clearance = definition.concentric_clearance(bodies.0);
            notes
                .push(format!("{name}: a clearance of {clearance:.3e} L stands for none where pipes begin concentric"));
        }
        let elements = Elements {
            name: name.clone(),
            origin: Origin::Elements(definition.element),
            points: points.into_iter().filter_map(|(cell, point)| Some((cell, point?))).collect(),
            main_nodes: definition.line.nodes.iter().copied().collect(),
            notes,
        };
        Ok(Contact::of_elements(bodies, elements, interaction))
    }
}
