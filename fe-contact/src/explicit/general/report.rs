//! What is told of general contact.

use super::GeneralContact;
use super::touch::Look;
use crate::explicit::state::{NodeForce, Side, Tally};
use crate::facet::Vec3;
use crate::point::{ContactStatus, Measure};
use crate::state::{ContactState, NodeValues, PointState, at_nodes};
use crate::summary::MeasureKind;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::mem::size_of_val;

/// How much general contact there is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GeneralCount {
    /// Faces that may touch.
    pub faces: usize,
    /// Their nodes.
    pub nodes: usize,
    /// Their feature edges.
    pub edges: usize,
    /// Pairs of a node and a face, and of edges, near each other.
    pub near: usize,
    /// Those that touch.
    pub closed: usize,
    /// Searches so far.
    pub searches: usize,
    /// Bytes of all of it.
    pub bytes: usize,
    /// Least and largest stiffness [F/L] of hard contact of a node; `None` before the first increment, or where all is held.
    pub penalty: Option<[f64; 2]>,
}

impl GeneralContact {
    /// What messages call it.
    pub fn label(&self) -> &str {
        &self.name
    }

    /// What acts, behaviour after behaviour.
    pub fn in_words(&self) -> String {
        let all = self.ground.table.behaviours.iter().map(|behaviour| behaviour.in_words("hard"));
        all.collect::<Vec<_>>().join("; ")
    }

    /// Searches so far.
    pub fn searches(&self) -> usize {
        self.searches
    }

    /// How much there is at present.
    pub fn count(&self) -> GeneralCount {
        let ground = &self.ground;
        let near = |run: &super::Nodes| run.candidates();
        let moving = ground.penalties.iter().copied().filter(|penalty| penalty.is_finite());
        let penalty = moving.fold(None, |all: Option<[f64; 2]>, p| {
            let [least, most] = all.unwrap_or([p, p]);
            Some([least.min(p), most.max(p)])
        });
        GeneralCount {
            faces: ground.surface.faces.len(),
            nodes: ground.surface.nodes.len(),
            edges: ground.surface.edges.len(),
            near: self.nodes.iter().map(near).sum::<usize>()
                + self.edges.iter().map(|run| run.candidates()).sum::<usize>(),
            closed: self.touches().filter(|touch| touch.is_closed()).count(),
            searches: self.searches,
            bytes: self.bytes(),
            penalty,
        }
    }

    fn bytes(&self) -> usize {
        let ground = &self.ground;
        let lists = size_of_val(&ground.surface.faces[..])
            + size_of_val(&ground.surface.nodes[..])
            + ground.surface.nodes.iter().map(|node| size_of_val(&node.faces[..])).sum::<usize>()
            + size_of_val(&ground.surface.edges[..])
            + size_of_val(&ground.penalties[..])
            + size_of_val(&self.searched[..]);
        let runs = self.nodes.iter().map(|run| run.bytes()).sum::<usize>()
            + self.edges.iter().map(|r| r.bytes()).sum::<usize>();
        lists + runs + ground.carriers.bytes()
    }

    /// Energy [F L] that friction has turned into heat.
    pub fn rubbed(&self) -> f64 {
        self.rubbed
    }

    /// The state at the end of the last increment. Points are those of nodes near faces, once for each surface that a node
    /// touches; edges that cross have forces alone. What parts from the rest as nodes move along a normal is the secondary side.
    pub fn state(&self) -> ContactState {
        let mut tally = Tally::default();
        let (carriers, surface) = (&self.ground.carriers, &self.ground.surface);
        let scene = self.ground.scene(0.0, Look::Again);
        let forces = self.forces();
        for run in &self.nodes {
            for touch in run.touches.iter().filter(|touch| touch.point.gap.is_finite()) {
                let p = touch.point;
                let (node, measure) = (carriers.nodes[touch.first as usize], Measure::Area(p.measure));
                let (pressure, shear, slip, status) = (p.pressure, p.shear, p.slip, p.status);
                let own = PointState { node, opening: p.gap, pressure, shear, slip, status, measure };
                let state = self.pressed(own, (touch.first, &touch.normal), &forces);
                tally.point(state, &carriers.x[touch.first as usize], &touch.normal);
            }
            for (node, gap) in run.gaps(&scene) {
                let own = PointState {
                    node: carriers.nodes[node as usize],
                    opening: gap,
                    pressure: 0.0,
                    shear: [0.0; 2],
                    slip: run.slip(node),
                    status: ContactStatus::Open,
                    measure: Measure::Area(surface.area(node, &carriers.x)),
                };
                let largest = forces.get(&node).and_then(|all| all.iter().copied().max_by(by_size)).unwrap_or_default();
                let state = self.pressed(own, (node, &largest), &forces);
                tally.point(state, &carriers.x[node as usize], &Vec3::zeros());
            }
        }
        for touch in self.touches().filter(|touch| touch.is_closed()) {
            let pressed = touch.normal_force();
            for &(node, d) in touch.row.iter().filter(|entry| entry.1 != 0.0) {
                let side = if d > 0.0 { Side::Secondary } else { Side::Main };
                let (place, shear) = (carriers.x[node as usize], (touch.point.force - pressed) * d);
                let (node, normal) = (carriers.nodes[node as usize], pressed * d);
                tally.force(side, &NodeForce { node, place, normal, shear, ..NodeForce::default() });
            }
        }
        tally.finish(self.ground.table.behaviours.iter().any(|behaviour| behaviour.friction.is_some()))
    }

    /// Normal forces [F] on each node whose face or which itself is pressed on, by its place in the carriers.
    fn forces(&self) -> HashMap<u32, Vec<Vec3>> {
        let mut out: HashMap<u32, Vec<Vec3>> = HashMap::new();
        for touch in self.nodes.iter().flat_map(|run| &run.touches).filter(|touch| touch.is_closed()) {
            let pressed = touch.normal_force();
            touch.row.iter().filter(|entry| entry.1 != 0.0).for_each(|&(node, d)| {
                out.entry(node).or_default().push(pressed * d);
            });
        }
        out
    }

    /// A point with all that presses on its node along a direction, over the area that faces it; what is against the direction
    /// presses on the other side of a sheet.
    fn pressed(&self, own: PointState, at: (u32, &Vec3), forces: &HashMap<u32, Vec<Vec3>>) -> PointState {
        let (node, direction) = at;
        let (Some(all), Some(unit)) = (forces.get(&node), direction.try_normalize(0.0)) else { return own };
        let force: f64 = all.iter().map(|force| force.dot(&unit).max(0.0)).sum();
        own.pressed_by(force, self.ground.surface.facing(node, &unit, &self.ground.carriers.x))
    }

    /// Results at all nodes that may touch, ascending.
    pub fn node_values(&self, state: &ContactState) -> Vec<NodeValues> {
        let (carriers, surface) = (&self.ground.carriers, &self.ground.surface);
        let values = at_nodes(carriers.nodes.iter().copied(), MeasureKind::Pressure, &state.points);
        let area = |node: u32| surface.area(carriers.index(node) as u32, &carriers.x);
        values.into_values().map(|value| NodeValues { measure: area(value.node), ..value }).collect()
    }
}

fn by_size(a: &Vec3, b: &Vec3) -> Ordering {
    a.norm_squared().total_cmp(&b.norm_squared())
}
