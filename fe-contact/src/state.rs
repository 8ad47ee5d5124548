//! What a pair does at a displacement: point by point, in sum, and as nodal forces.

use crate::contact::Contact;
use crate::facet::Vec3;
use crate::point::{ContactStatus, Measure};
use crate::summary::{Means, Origin};
use std::collections::BTreeMap;

/// One point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// Secondary node.
    pub node: u32,
    /// Gap [L], positive when open: COPEN.
    pub opening: f64,
    /// The law's number (see [`Measure`]), positive in compression: CPRESS.
    pub pressure: f64,
    /// Open or closed: CSTATUS.
    pub status: ContactStatus,
    /// How much surface it stands for: CNAREA.
    pub measure: Measure,
}

/// Force on one side and what it adds up to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SideForce {
    /// Force [F] on each node of the side, nodes ascending: CNORMF.
    pub nodes: Vec<(u32, [f64; 3])>,
    /// Total force [F]: CFN.
    pub force: [f64; 3],
    /// Total moment [F L] about the origin, with the forces where the nodes were at first: CMN.
    pub moment: [f64; 3],
}

/// The state of a pair.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactState {
    /// The points, as in [`Contact::points`].
    pub points: Vec<PointState>,
    /// On the secondary side.
    pub secondary: SideForce,
    /// On the main side (on the reference node of a rigid one, its moment included in the total).
    pub main: SideForce,
    /// Node and amount [L] of the largest overclosure; `None` when nothing overlaps.
    pub largest_overclosure: Option<(u32, f64)>,
    /// Node and amount of the largest tensile pressure that is not allowed; `None` when nothing pulls.
    pub largest_tension: Option<(u32, f64)>,
    /// Energy [F L] that stabilisation has taken so far: ALLSD.
    pub stabilized: f64,
    /// Area [L²] of closed points that have one: CAREA.
    pub closed_area: f64,
}

/// Contact results at one node of the secondary surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeValues {
    /// Node.
    pub node: u32,
    /// Gap [L]; `None` where the node faces nothing.
    pub opening: Option<f64>,
    /// The law's number; 0 where the node faces nothing.
    pub pressure: f64,
    /// Open or closed.
    pub status: ContactStatus,
    /// Area [L²] (or length) that it stands for; 0 at mid-side nodes and where it faces nothing.
    pub measure: f64,
}

/// Overclosure of a penalty over the length of a facet up to which contact may be called hard [-].
const SMALL: f64 = 0.01;

/// A penalty so soft that the bodies overlap visibly, or that gives way like another layer of elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooSoft {
    /// Node with the largest overclosure.
    pub node: u32,
    /// It [L].
    pub overclosure: f64,
    /// It over the length of a facet [-]; 0 where there are none.
    pub part: f64,
    /// It over what the element beneath gives way [-]; 0 where that is not known.
    pub layers: f64,
}

/// Forces [F] by node.
type Forces = BTreeMap<u32, Vec3>;

impl Contact {
    /// The state at a displacement, with the history that belongs to it.
    pub fn state(&self, u: &[f64], history: &[f64]) -> ContactState {
        let mut state = ContactState { stabilized: self.stabilized(history), ..ContactState::default() };
        // A node may be on the secondary side of one element and on the main side of another.
        let (mut secondary, mut main) = (Forces::new(), Forces::new());
        let mut turning = Vec3::zeros();
        for (i, p) in self.points.iter().enumerate() {
            let here = self.at(i, u);
            let opening = here.gap + self.allowed(i, history);
            let (answer, status) = if self.acts() {
                self.answer(i, here.gap, history, self.is_held(i, history))
            } else {
                Default::default()
            };
            let force = answer.pressure * p.measure.value();
            state.points.push(PointState {
                node: p.node,
                opening,
                pressure: answer.pressure,
                status,
                measure: p.measure,
            });
            if self.acts() {
                keep_larger(&mut state.largest_overclosure, p.node, -opening);
            }
            if !self.no_separation {
                keep_larger(&mut state.largest_tension, p.node, -answer.pressure);
            }
            if let (ContactStatus::Closed | ContactStatus::Slipping, Measure::Area(a)) = (status, p.measure) {
                state.closed_area += a;
            }
            let mut row = here.row.iter();
            for (&n, place) in p.nodes.iter().zip(&self.places[i]) {
                let is_main = n != p.node && self.sides.main_nodes.binary_search(&n).is_ok();
                let at = if is_main { &mut main } else { &mut secondary }.entry(n).or_default();
                let components = self.reference.as_ref().filter(|r| r.0 == n).map(|r| r.1.as_slice());
                for (k, d) in row.by_ref().take(place.len()).enumerate() {
                    match components.map_or(k, |c| c[k]) {
                        c @ 0..3 => at[c] += force * d,
                        c => turning[c - 3] += force * d,
                    }
                }
            }
        }
        state.secondary = self.side(&secondary, &self.sides.secondary_nodes, Vec3::zeros());
        state.main = self.side(&main, &self.sides.main_nodes, turning);
        state
    }

    /// What is to be said of an overclosure that a penalty leaves, where it is no longer small beside the facets.
    pub fn too_soft(&self, state: &ContactState) -> Option<TooSoft> {
        let has_facets = matches!(self.summary.origin, Origin::Pair(_));
        let penalty = self.summary.penalty.filter(|p| p.means == Means::Penalty && has_facets)?;
        let (node, overclosure) = state.largest_overclosure?;
        let overclosure = overclosure + penalty.clearance;
        let part = if self.length > 0.0 { overclosure / self.length } else { 0.0 };
        let layers = self.summary.beneath.map_or(0.0, |beneath| beneath / penalty.stiffness);
        (part > SMALL || layers >= 1.0).then_some(TooSoft { node, overclosure, part, layers })
    }

    fn side(&self, forces: &Forces, nodes: &[u32], turning: Vec3) -> SideForce {
        let (mut force, mut moment, mut list) = (Vec3::zeros(), turning, Vec::with_capacity(nodes.len()));
        for &n in nodes {
            let f = forces.get(&n).copied().unwrap_or_default();
            force += f;
            moment += self.positions[&n].cross(&f);
            list.push((n, f.into()));
        }
        SideForce { nodes: list, force: force.into(), moment: moment.into() }
    }

    /// Results at all nodes of the secondary surface, ascending; mid-side nodes take the mean of their corners.
    pub fn node_values(&self, state: &ContactState) -> Vec<NodeValues> {
        let none = |node| NodeValues { node, opening: None, pressure: 0.0, status: ContactStatus::Open, measure: 0.0 };
        let mut values: BTreeMap<u32, NodeValues> = self.secondary_nodes().iter().map(|&n| (n, none(n))).collect();
        for p in &state.points {
            let measure = p.measure.value();
            let v =
                NodeValues { opening: Some(p.opening), pressure: p.pressure, status: p.status, measure, node: p.node };
            // Of several points of a node the one that presses most.
            let at = values.entry(p.node).or_insert(v);
            if at.opening.is_none() || (v.pressure, -p.opening) > (at.pressure, -at.opening.unwrap_or_default()) {
                *at = v;
            }
        }
        for facet in self.sides.secondary.iter().filter(|f| !f.is_linear()) {
            let (nodes, corners) = (facet.nodes(), facet.corners());
            for (m, &middle) in nodes[corners..].iter().enumerate() {
                let (a, b) = (values[&nodes[m]], values[&nodes[(m + 1) % corners]]);
                let opening = a.opening.zip(b.opening).map(|(a, b)| 0.5 * (a + b));
                if opening.is_some() {
                    let unlike = a.status != b.status;
                    let status = if unlike { self.respond(opening.unwrap_or_default()).1 } else { a.status };
                    let pressure = 0.5 * (a.pressure + b.pressure);
                    values.insert(middle, NodeValues { node: middle, opening, pressure, status, measure: 0.0 });
                }
            }
        }
        values.into_values().collect()
    }
}

fn keep_larger(largest: &mut Option<(u32, f64)>, node: u32, value: f64) {
    if value > largest.map_or(0.0, |l| l.1) {
        *largest = Some((node, value));
    }
}
