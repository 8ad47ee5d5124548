//! What contact elements have in common: a node apart from a place that other nodes carry, and how far apart it may be.

use crate::build::Found;
use crate::carry::Ground;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::interaction::{Interaction, NormalBehavior};
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
        "element {element} ({kind}) has no direction: {coincide}, and a negative distance is kept between \
         nodes that are apart"
    )]
    Coincident {
        /// Label.
        element: u64,
        /// Its type.
        kind: &'static str,
        /// What is at one place.
        coincide: &'static str,
    },
    /// A node that presses on itself.
    #[error("element {element} ({kind}) stands on a node of its own slide line")]
    OnItsLine {
        /// Label.
        element: u64,
        /// Its type.
        kind: &'static str,
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
    /// The two directions in which the node slides.
    pub space: Space,
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
        share.into_point(measure, freedoms, None, Some(self.space))
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
            None if distance > 0.0 => Some(self.round(Vec3::zeros(), distance, measure, freedoms)),
            None => None,
        }
    }

    /// A round point that begins at the offset `start`.
    fn round(&self, start: Vec3, distance: f64, measure: Measure, freedoms: &Freedoms) -> ContactPoint {
        let axes = [0, 1, 2].map(|c| self.flat(Vec3::ith(c, 1.0), 0.0, measure, freedoms));
        let nodes = axes[0].nodes.clone();
        let rows = axes.map(|axis| axis.row);
        let row = vec![0.0; rows[0].len()];
        let round =
            Some(Box::new(Round { start: start.into(), rows, across: self.across, space: self.space, distance }));
        ContactPoint { node: self.node, gap: distance, normal: [0.0; 3], measure, nodes, row, round, slide: None }
    }
}

/// Each element with what it is, or the first one that is not.
pub(crate) fn each<T>(
    cells: &[CellId],
    of: impl Fn(CellId) -> Result<T, ElementFault>,
) -> Result<Vec<(CellId, T)>, (CellId, ElementFault)> {
    cells.iter().map(|&cell| of(cell).map(|found| (cell, found)).map_err(|fault| (cell, fault))).collect()
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
        let beneath = match interaction.normal {
            NormalBehavior::Hard(_) => {
                let said = (elements.name.as_str(), &mut elements.notes);
                Some(stiffness::at_points_or_chosen(bodies, &points, said))
            }
            NormalBehavior::Softened(_) => stiffness::at_points(bodies, &points),
        };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gap::GapDefinition;
    use crate::tests::scene::{linear, numbers};
    use fe_core::Term;
    use fe_core::element::ElementType::{self, GAPCYL, GAPSPHER, GAPUNI};
    use fe_mesh::CellBlock;

    /// Gap elements of one type, each between the origin and a place.
    fn elements(element: ElementType, places: &[[f64; 3]]) -> (Structure, Freedoms) {
        let mut structure = Structure { elements: vec![element], ..Structure::default() };
        let mut block = CellBlock::new(element.kind());
        for (i, place) in places.iter().enumerate() {
            structure.mesh.points.extend([[0.0; 3], *place]);
            block.nodes.extend([2 * i as u32, 2 * i as u32 + 1]);
            block.labels.push(i as u64 + 1);
        }
        structure.mesh.point_labels = (1..=structure.mesh.points.len() as u64).collect();
        structure.mesh.blocks.push(block);
        let freedoms = structure.freedoms(&[]);
        (structure, freedoms)
    }

    fn gaps(element: ElementType, distance: f64, direction: [f64; 3], places: &[[f64; 3]]) -> (Contact, Freedoms) {
        let (structure, freedoms) = elements(element, places);
        let cells = structure.mesh.cells().collect();
        let (name, direction) = ("G".into(), Some(direction));
        let definition = GapDefinition { name, element, cells, distance, direction, area: None, interaction: 0 };
        (Contact::of_gaps((&structure, &freedoms), &definition, &linear()).unwrap(), freedoms)
    }

    /// A06 (b): openings at u₁ = (.01, −.02, .03), u₂ = (−.05, .01, −.10), with the direction that follows.
    #[test]
    fn a06_gap_kinematics() {
        const MOVED: [f64; 6] = [0.01, -0.02, 0.03, -0.05, 0.01, -0.10];
        let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-14, "{found}, not {expected}");
        let (uni, _) = gaps(GAPUNI, 0.1, [1.0, 2.0, 2.0], &[[9.0, 9.0, 9.0]]);
        close(uni.opening(0, &MOVED), 0.0133333333333333);
        let (inside, _) = gaps(GAPCYL, 0.1, [0.0, 0.0, 3.0], &[[0.0; 3]]);
        close(inside.opening(0, &MOVED), 0.0329179606750063);
        let along = Matrix3::from_diagonal(&Vec3::new(1.0, 1.0, 0.0));
        for (across, place, expected) in
            [(along, [0.3, 0.4, 7.0], 0.0424428900898053), (Matrix3::identity(), [0.3, 0.4, 0.0], 0.0593132631298738)]
        {
            let (structure, freedoms) = elements(GAPSPHER, &[place]);
            let offset = Offset { node: 1, carriers: vec![(0, 1.0)], across, space: Space::Solid };
            let start = offset.start(&structure).unwrap();
            let point = offset.round(start, -0.45, Measure::Point, &freedoms);
            let kinematics = point.at(&MOVED, &[0..3, 3..6]);
            close(kinematics.gap, expected);
            if across == along {
                close(kinematics.normal[0], 0.24 / 0.24f64.hypot(0.43));
            }
        }
    }

    /// Without large displacements the initial direction stays: the second node is pushed away from the first by a least
    /// distance and drawn to it by a largest one.
    #[test]
    fn forces_push_apart_or_draw_together() {
        for (distance, along) in [(-0.6, 1.0), (0.4, -1.0)] {
            let (balls, freedoms) = gaps(GAPSPHER, distance, [0.0; 3], &[[0.3, 0.4, 0.0]]);
            let state = balls.state(&vec![0.0; freedoms.len()], &vec![0.0; balls.history()]);
            // LINEAR with k = 100 at an overclosure of 0.1.
            let expected = [10.0 * along * 0.6, 10.0 * along * 0.8, 0.0];
            for ((secondary, main), expected) in state.secondary.force.iter().zip(state.main.force).zip(expected) {
                assert!((secondary - expected).abs() < 1e-13 && (main + expected).abs() < 1e-13);
            }
        }
    }

    /// Forces and stiffnesses of round points are slopes: central differences of |w| = O(1) with steps of 1e-5 leave
    /// (1e-5)²/6 of the third derivative, below 1/|w|² = 100, and round-off of 1e-16/1e-5.
    #[test]
    fn round_points_are_slopes() {
        let places = vec![[0.0; 3]; 12];
        for (element, axis) in [(GAPCYL, [1.0, 2.0, -2.0]), (GAPSPHER, [0.0; 3])] {
            let (round, freedoms) = gaps(element, 0.25, axis, &places);
            assert!(round.points.iter().all(|point| point.round.is_some()));
            let mut next = numbers(3);
            let u: Vec<f64> = (0..freedoms.len()).map(|_| 0.2 * next()).collect();
            let open = (0..places.len()).filter(|&i| round.opening(i, &u) > 0.0).count();
            assert!((1..places.len()).contains(&open), "both states are there");
            let found = fe_core::verify::term(&round, &freedoms, &u, 1e-5).unwrap();
            assert!(found.force < 1e-7 && found.stiffness < 1e-7 && found.paths == 0.0, "{found:?}");
        }
    }

    /// A chain of elements in one set: a node may be second of one and first of the next.
    #[test]
    fn sides_are_those_of_each_element() {
        let (mut structure, _) = elements(GAPUNI, &[[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
        structure.mesh.blocks[0].nodes = vec![0, 1, 1, 3];
        let freedoms = structure.freedoms(&[]);
        let cells = structure.mesh.cells().collect();
        let (name, direction) = ("G".into(), Some([1.0, 0.0, 0.0]));
        let definition =
            GapDefinition { name, element: GAPUNI, cells, distance: -0.1, direction, area: None, interaction: 0 };
        let chain = Contact::of_gaps((&structure, &freedoms), &definition, &linear()).unwrap();
        let state = chain.state(&vec![0.0; freedoms.len()], &vec![0.0; chain.history()]);
        assert_eq!((state.secondary.force[0], state.main.force[0]), (20.0, -20.0));
    }
}
