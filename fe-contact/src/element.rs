//! What contact elements have in common: a node apart from a place that other nodes carry, and how far apart it may be.

use crate::build::Found;
use crate::carry::Ground;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::interaction::Interaction;
use crate::point::{ContactPoint, Measure, Round};
use crate::share::{Row, Share};
use crate::sides::Prepared;
use crate::stiffness;
use crate::summary::Origin;
use crate::tangents::Space;
use fe_core::{Freedoms, Structure};
use fe_mesh::CellId;
use nalgebra::Matrix3;
use std::collections::BTreeSet;

/// A contact element that stands for no constraint; `element` is its label.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ElementFault {
    /// GAPUNI without a direction on nodes at one place.
    #[error("element {element} (GAPUNI) has no direction: none is given, and its nodes coincide")]
    NoDirection {
        /// Label.
        element: u64,
    },
    /// GAPUNI whose direction is across the plane of the model.
    #[error("element {element} (GAPUNI) has a direction across the plane, in which its nodes cannot move")]
    AcrossPlane {
        /// Label.
        element: u64,
    },
    /// A least separation of nodes at one place.
    #[error(
        "element {element} ({kind}) has no direction: its nodes coincide{across}, and a negative distance is kept between \
         nodes that are apart"
    )]
    Coincident {
        /// Label.
        element: u64,
        /// Its type.
        kind: &'static str,
        /// ` across its axis`, or nothing.
        across: &'static str,
    },
}

/// Lengths below this part of the coordinates that they are differences of are round-off [-].
const ROUND_OFF: f64 = 1e-12;

/// An offset w = P (x − Σ N X) of a node from a place carried by others.
pub(crate) struct Offset {
    /// The node.
    pub node: u32,
    /// The other nodes with their N.
    pub carriers: Vec<(u32, f64)>,
    /// P: takes out what does not count.
    pub across: Matrix3<f64>,
}

impl Offset {
    /// w [L] at the reference geometry; `None` where it is no more than round-off.
    pub fn start(&self, structure: &Structure) -> Option<Vec3> {
        let place = |n: u32| Vec3::from(structure.mesh.points[n as usize]);
        let at = place(self.node);
        let apart: Vec3 = self.carriers.iter().map(|&(n, weight)| (at - place(n)) * weight).sum();
        let w = self.across * apart;
        let size = self.carriers.iter().fold(at.amax(), |size, c| size.max(place(c.0).amax()));
        (w.norm() > ROUND_OFF * size).then_some(w)
    }

    /// A flat point, with its directions along: g = `gap` + n·(u − Σ N U) with the unit vector n.
    pub fn flat(&self, normal: Vec3, gap: f64, measure: Measure, freedoms: &Freedoms) -> ContactPoint {
        let mut share = Share { weight: 1.0, gap, normal, ..Share::new(self.node) };
        share.rows.push(Row::new(self.node, &normal, 1.0));
        share.rows.extend(self.carriers.iter().map(|&(n, weight)| Row::new(n, &normal, -weight)));
        share.compress();
        let plane = freedoms.index(self.node as usize, 2).is_none();
        let space = if plane { Space::Plane } else { Space::Solid };
        share.into_point(measure, freedoms, None, Some(space))
    }

    /// A point whose nodes are at most (d > 0) or at least (d < 0) |d| [L] apart. Without large displacements its direction
    /// is that of the initial offset; where there is none, it follows the offset. `None` with d < 0 and no offset.
    pub fn apart(
        &self,
        distance: f64,
        measure: Measure,
        (structure, freedoms): (&Structure, &Freedoms),
    ) -> Option<ContactPoint> {
        match self.start(structure) {
            Some(w) if distance > 0.0 => Some(self.flat(-w.normalize(), distance - w.norm(), measure, freedoms)),
            Some(w) => Some(self.flat(w.normalize(), w.norm() + distance, measure, freedoms)),
            None if distance > 0.0 => Some(self.round(distance, measure, freedoms)),
            None => None,
        }
    }

    fn round(&self, distance: f64, measure: Measure, freedoms: &Freedoms) -> ContactPoint {
        let axes = [0, 1, 2].map(|c| {
            let direction: Vec3 = self.across.row(c).transpose();
            self.flat(direction, 0.0, measure, freedoms)
        });
        let nodes = axes[0].nodes.clone();
        let rows = axes.map(|axis| axis.row);
        let row = vec![0.0; rows[0].len()];
        let round = Some(Box::new(Round { start: [0.0; 3], rows, distance }));
        ContactPoint { node: self.node, gap: distance, normal: [0.0; 3], measure, nodes, row, round, slide: None }
    }
}

/// Contact elements of one set with their points.
pub(crate) struct Elements {
    /// Name of the set.
    pub name: String,
    /// What they are.
    pub origin: Origin,
    /// Each element with its point.
    pub points: Vec<(CellId, ContactPoint)>,
    /// Nodes of the main side.
    pub main_nodes: BTreeSet<u32>,
    /// Remarks, a line each.
    pub notes: Vec<String>,
}

impl Contact {
    /// Of contact elements. Their characteristic length is 1.0, as nothing about them has a size (Abaqus Analysis User's
    /// Manual, Frictional behavior: where no surface has facets).
    pub(crate) fn of_elements(
        bodies: (&Structure, &Freedoms),
        mut elements: Elements,
        interaction: &Interaction,
    ) -> Self {
        elements.points.sort_by_key(|(cell, point)| (point.node, *cell));
        let secondary_nodes: BTreeSet<u32> = elements.points.iter().map(|(_, point)| point.node).collect();
        let (cells, points): (Vec<CellId>, Vec<ContactPoint>) = elements.points.into_iter().unzip();
        let beneath = stiffness::at_points(bodies, &points).or_else(|| {
            let chosen = stiffness::anywhere(bodies).unwrap_or(1.0);
            elements.notes.push(format!(
                "no element gives the nodes of {} a stiffness: {chosen:.6e} stands for it in the penalty of hard contact",
                elements.name
            ));
            Some(chosen)
        });
        let sides = Prepared {
            secondary_nodes: secondary_nodes.into_iter().collect(),
            main_nodes: elements.main_nodes.into_iter().collect(),
            notes: elements.notes,
            ..Prepared::default()
        };
        let found = Found {
            surfaces: (elements.name.clone(), elements.name.clone()),
            name: elements.name,
            points,
            cells,
            reference: None,
            origin: elements.origin,
            searched: None,
        };
        let ground = Ground { beneath, length: 1.0, slides_far: false };
        Contact::of_points(bodies, (found, sides), interaction, ground).expect("the stiffness beneath is known")
    }
}
