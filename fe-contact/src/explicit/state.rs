//! What explicit contact does at the end of an increment, as static contact tells it.

use super::pair::ContactPair;
use super::target::Target;
use crate::facet::Vec3;
use crate::point::{ContactStatus, Measure};
use crate::state::{Closed, ContactState, NodeValues, PointState, SideForce, at_nodes, keep_larger};
use crate::summary::MeasureKind;
use crate::tangents::tangents;
use std::collections::BTreeMap;

/// Which side of a contact a force acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The side whose points press.
    Secondary,
    /// The side they press on.
    Main,
}

/// Forces [F] on a node at a place [L], of pressure and of friction, and the moment [F L] that they have about it.
#[derive(Clone, Copy, Debug, Default)]
pub struct NodeForce {
    /// Node.
    pub node: u32,
    /// Where it is.
    pub place: Vec3,
    /// Of pressure.
    pub normal: Vec3,
    /// Of friction.
    pub shear: Vec3,
    /// Moments of both about the place: not 0 on the reference node of a rigid body.
    pub turning: [Vec3; 2],
}

/// Adds up what the points of an explicit contact do. Moments are about the origin, with the forces where the nodes are now.
#[derive(Debug, Default)]
pub struct Tally {
    state: ContactState,
    closed: Closed,
    /// By side, of pressure and of friction.
    nodes: [[BTreeMap<u32, Vec3>; 2]; 2],
    sums: [[[Vec3; 2]; 2]; 2],
}

impl Tally {
    /// A point that something is near, at a place with the normal of the main side.
    pub fn point(&mut self, point: PointState, place: &Vec3, normal: &Vec3) {
        keep_larger(&mut self.state.largest_overclosure, point.node, -point.opening);
        if point.status != ContactStatus::Open {
            self.closed.add(point.measure, place, normal);
        }
        self.state.points.push(point);
    }

    /// A force on a node.
    pub fn force(&mut self, side: Side, force: &NodeForce) {
        let side = side as usize;
        for (k, f) in [force.normal, force.shear].into_iter().enumerate() {
            *self.nodes[side][k].entry(force.node).or_default() += f;
            let [sum, moment] = &mut self.sums[side][k];
            *sum += f;
            *moment += force.place.cross(&f) + force.turning[k];
        }
    }

    /// All of it; what friction adds only where it `rubs`.
    pub fn finish(mut self, rubs: bool) -> ContactState {
        let (nodes, sums) = (&self.nodes, &self.sums);
        let of = |side: Side, k: usize| {
            let [force, moment] = sums[side as usize][k].map(Into::into);
            let list = nodes[side as usize][k].iter().map(|(&node, &f)| (node, f.into())).collect();
            SideForce { nodes: list, force, moment }
        };
        (self.state.secondary, self.state.main) = (of(Side::Secondary, 0), of(Side::Main, 0));
        self.state.secondary_shear = rubs.then(|| of(Side::Secondary, 1));
        self.state.main_shear = rubs.then(|| of(Side::Main, 1));
        self.closed.tell(&mut self.state);
        self.state
    }
}

impl ContactState {
    /// With what the same contact does where its sides are exchanged.
    pub fn and_exchanged(mut self, other: ContactState) -> Self {
        self.points.extend(other.points);
        add(&mut self.secondary, other.main);
        add(&mut self.main, other.secondary);
        for (own, more) in
            [(&mut self.secondary_shear, other.main_shear), (&mut self.main_shear, other.secondary_shear)]
        {
            if let Some(more) = more {
                add(own.get_or_insert_default(), more);
            }
        }
        if let Some((node, overclosure)) = other.largest_overclosure {
            keep_larger(&mut self.largest_overclosure, node, overclosure);
        }
        self.closed_area += other.closed_area;
        if self.normal == [0.0; 3] {
            (self.center, self.normal) = (other.center, other.normal.map(|n| -n));
        }
        self
    }
}

/// Adds the forces of another part of a contact.
fn add(side: &mut SideForce, other: SideForce) {
    let mut nodes: BTreeMap<u32, [f64; 3]> = std::mem::take(&mut side.nodes).into_iter().collect();
    for (node, force) in other.nodes {
        let own = nodes.entry(node).or_default();
        (0..3).for_each(|c| own[c] += force[c]);
    }
    side.nodes = nodes.into_iter().collect();
    (0..3).for_each(|c| side.force[c] += other.force[c]);
    (0..3).for_each(|c| side.moment[c] += other.moment[c]);
}

impl ContactPair {
    /// The state at the end of the last increment.
    pub fn state(&self) -> ContactState {
        let mut tally = Tally::default();
        let carriers = &self.carriers;
        for (i, point) in self.points.iter().enumerate().filter(|(_, point)| point.gap.is_finite()) {
            let place = carriers.x[point.index as usize];
            let node = carriers.nodes[point.index as usize];
            let measure = match self.definition.secondary.kind {
                MeasureKind::Pressure => Measure::Area(point.measure),
                MeasureKind::ForcePerLength => Measure::Length(point.measure),
                MeasureKind::Force => Measure::Point,
            };
            let (status, pressure, shear, slip) = (point.status, point.pressure, point.shear, point.slip);
            let state = PointState { node, opening: point.gap, pressure, status, shear, slip, measure };
            // As it was found when the forces were.
            let hit = self.target.nearest(carriers, i, &place).filter(|_| status != ContactStatus::Open);
            let Some(hit) = hit else {
                tally.point(state, &place, &Vec3::zeros());
                continue;
            };
            tally.point(state, &place, &hit.normal);
            let normal = hit.normal * (pressure * point.measure);
            let along = tangents(&hit.normal, self.space).into_iter().zip(shear);
            let shear: Vec3 = along.map(|(t, shear)| t * (-shear * point.measure)).sum();
            tally.force(Side::Secondary, &NodeForce { node, place, normal, shear, ..NodeForce::default() });
            match &self.target {
                Target::Faces(_) => {
                    for &(main, share) in hit.shares.iter().filter(|share| share.1 != 0.0) {
                        let (node, place) = (carriers.nodes[main as usize], carriers.x[main as usize]);
                        let (normal, shear) = (-normal * share, -shear * share);
                        tally.force(Side::Main, &NodeForce { node, place, normal, shear, ..NodeForce::default() });
                    }
                }
                Target::Rigid(_) => {
                    let body = &carriers.bodies[0];
                    let turning = [normal, shear].map(|f| (place - body.place).cross(&-f));
                    let (node, normal, shear) = (body.reference, -normal, -shear);
                    tally.force(Side::Main, &NodeForce { node, place: body.place, normal, shear, turning });
                }
            }
        }
        tally.finish(self.definition.behaviour.friction.is_some())
    }

    /// Results at all nodes of the secondary surface, ascending.
    pub fn node_values(&self, state: &ContactState) -> Vec<NodeValues> {
        let nodes = self.points.iter().map(|point| self.carriers.nodes[point.index as usize]);
        at_nodes(nodes, self.definition.secondary.kind, &state.points).into_values().collect()
    }
}
