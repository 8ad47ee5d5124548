//! What a pair does at a displacement: point by point, in sum, and as nodal forces.

use crate::contact::Contact;
use crate::enforce::{Answer, SLIPPING, Separation};
use crate::facet::Vec3;
use crate::point::{ContactStatus, Measure};
use crate::summary::{Means, MeasureKind, Origin};
use crate::viscous::Taken;
use std::collections::BTreeMap;

/// One point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// Secondary node.
    pub node: u32,
    /// Gap [L], positive when open: COPEN.
    pub opening: f64,
    /// The law's number (see [`Measure`]), positive in compression, and what damping adds to it, on open points, too: CPRESS.
    pub pressure: f64,
    /// Open, closed or slipping: CSTATUS.
    pub status: ContactStatus,
    /// Shear along t₁ and t₂ in the pressure's unit, on the main side, against it on the secondary one: CSHEAR1, CSHEAR2.
    pub shear: [f64; 2],
    /// Slip [L] of the secondary side along t₁ and t₂ while it was closed: CSLIP1, CSLIP2.
    pub slip: [f64; 2],
    /// How much surface it stands for: CNAREA.
    pub measure: Measure,
}

impl PointState {
    /// With all of the normal force [F] on its node over the node's area [L²], where the other side of a contact presses there, too;
    /// what it has along the surface grows with it. Points that have no area, or pull, stay as they are.
    pub fn pressed_by(self, force: f64, area: f64) -> Self {
        if !matches!(self.measure, Measure::Area(_)) || area <= 0.0 || self.pressure < 0.0 {
            return self;
        }
        let pressure = force / area;
        let grown = if self.pressure > 0.0 { pressure / self.pressure } else { 0.0 };
        let is_touched = self.status == ContactStatus::Open && pressure > 0.0;
        let status = if is_touched { ContactStatus::Closed } else { self.status };
        PointState { pressure, status, shear: self.shear.map(|shear| shear * grown), ..self }
    }
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
    /// What friction adds on the secondary side: CSHEARF, CFS, CMS; `None` without friction.
    pub secondary_shear: Option<SideForce>,
    /// What friction adds on the main side.
    pub main_shear: Option<SideForce>,
    /// Node and amount [L] of the largest overclosure; `None` when nothing overlaps.
    pub largest_overclosure: Option<(u32, f64)>,
    /// Node and amount of the largest tensile pressure that is not allowed; `None` when nothing pulls.
    pub largest_tension: Option<(u32, f64)>,
    /// Energies that damping and stabilisation have taken so far.
    pub taken: Taken,
    /// Area [L²] of closed points that have one: CAREA.
    pub closed_area: f64,
    /// Middle [L] of the closed points by their measures; 0 where none is closed.
    pub center: [f64; 3],
    /// Mean outward unit normal of the secondary side there; 0 where none is closed.
    pub normal: [f64; 3],
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
    /// Open, closed or slipping.
    pub status: ContactStatus,
    /// Shear along t₁ and t₂.
    pub shear: [f64; 2],
    /// Slip along t₁ and t₂ [L].
    pub slip: [f64; 2],
    /// Area [L²] (or length) that it stands for; 0 at mid-side nodes and where it faces nothing.
    pub measure: f64,
    /// What the law's number is.
    pub kind: MeasureKind,
}

/// Overclosure of a penalty over the length of a facet up to which contact may be called hard [-].
const SMALL: f64 = 0.01;

/// What a penalty gives way over what the elements beneath do [-] that is another layer of them, but for rounding.
const A_LAYER: f64 = 1.0 - 1e-9;

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

impl ContactState {
    /// Force [F] and moment about the origin [F L] on the secondary side, friction included: CFT, CMT.
    pub fn total(&self) -> ([f64; 3], [f64; 3]) {
        let (mut force, mut moment) = (self.secondary.force, self.secondary.moment);
        if let Some(shear) = &self.secondary_shear {
            (0..3).for_each(|c| force[c] += shear.force[c]);
            (0..3).for_each(|c| moment[c] += shear.moment[c]);
        }
        (force, moment)
    }
}

/// Sums over the closed points of a contact.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Closed {
    area: f64,
    weight: f64,
    places: Vec3,
    normals: Vec3,
}

impl Closed {
    /// Takes a closed point at a place, with the normal of the main side.
    pub fn add(&mut self, measure: Measure, place: &Vec3, normal: &Vec3) {
        if let Measure::Area(area) = measure {
            self.area += area;
        }
        self.weight += measure.value();
        self.places += place * measure.value();
        self.normals -= normal * measure.value();
    }

    /// Writes what they come to.
    pub fn tell(&self, state: &mut ContactState) {
        state.closed_area = self.area;
        let size = self.normals.norm();
        if self.weight > 0.0 && size > 0.0 {
            (state.center, state.normal) = ((self.places / self.weight).into(), (self.normals / size).into());
        }
    }
}

/// Results at nodes of a secondary surface: of several points of a node that of the one that presses most.
pub(crate) fn at_nodes(
    nodes: impl Iterator<Item = u32>,
    kind: MeasureKind,
    points: &[PointState],
) -> BTreeMap<u32, NodeValues> {
    let none = |node| NodeValues {
        node,
        opening: None,
        pressure: 0.0,
        status: ContactStatus::Open,
        shear: [0.0; 2],
        slip: [0.0; 2],
        measure: 0.0,
        kind,
    };
    let mut values: BTreeMap<u32, NodeValues> = nodes.map(|n| (n, none(n))).collect();
    for &PointState { node, opening, pressure, status, shear, slip, measure } in points {
        let (kind, measure) = (MeasureKind::of(measure), measure.value());
        let v = NodeValues { node, opening: Some(opening), pressure, status, shear, slip, measure, kind };
        let at = values.entry(node).or_insert(v);
        if at.opening.is_none() || (v.pressure, -opening) > (at.pressure, -at.opening.unwrap_or_default()) {
            *at = v;
        }
    }
    values
}

/// Forces by node of the secondary and of the main side, for a node may be on either in different points, and what turns the
/// reference node.
#[derive(Default)]
struct Forces {
    secondary: BTreeMap<u32, Vec3>,
    main: BTreeMap<u32, Vec3>,
    turning: Vec3,
}

impl Contact {
    /// The state at a displacement, with the history that belongs to it.
    pub fn state(&self, u: &[f64], history: &[f64]) -> ContactState {
        let mut state = ContactState { taken: self.taken(history), ..ContactState::default() };
        let (mut normal, mut along, mut touch) = (Forces::default(), Forces::default(), Closed::default());
        for (i, p) in self.points.iter().enumerate() {
            let here = self.at(i, u);
            let opening = here.gap + self.allowed(i, history);
            let Answer { response: answer, status: closed, .. } =
                if self.acts() { self.answer(i, here.gap, (history, history)) } else { Answer::default() };
            let (shear, slip) = self.shear_and_slip(i, history);
            let slips = closed != ContactStatus::Open && history[i] == SLIPPING;
            let status = if slips { ContactStatus::Slipping } else { closed };
            let measure = p.measure.value();
            let pressure = answer.pressure + self.damped(i, history);
            state.points.push(PointState { node: p.node, opening, pressure, status, shear, slip, measure: p.measure });
            if self.acts() {
                keep_larger(&mut state.largest_overclosure, p.node, -opening);
            }
            if self.separation == Separation::Free {
                keep_larger(&mut state.largest_tension, p.node, -answer.pressure);
            }
            if status != ContactStatus::Open {
                touch.add(p.measure, &self.positions[&p.node], &Vec3::from(p.normal));
            }
            self.spread(i, &here.row, pressure * measure, &mut normal);
            if shear != [0.0; 2]
                && let Some(slide) = self.slide_from(i, u)
            {
                for (row, shear) in slide.rows.iter().zip(shear) {
                    self.spread(i, row, -shear * measure, &mut along);
                }
            }
        }
        touch.tell(&mut state);
        state.secondary = self.side(&normal.secondary, &self.sides.secondary_nodes, Vec3::zeros());
        state.main = self.side(&normal.main, &self.sides.main_nodes, normal.turning);
        if self.tangential.is_some() {
            state.secondary_shear = Some(self.side(&along.secondary, &self.sides.secondary_nodes, Vec3::zeros()));
            state.main_shear = Some(self.side(&along.main, &self.sides.main_nodes, along.turning));
        }
        state
    }

    /// Adds force · row of a point.
    fn spread(&self, point: usize, row: &[f64], force: f64, forces: &mut Forces) {
        let (mut row, p) = (row.iter(), &self.points[point]);
        for (&n, place) in p.nodes.iter().zip(&self.places[point]) {
            let is_main = n != p.node && self.sides.main_nodes.binary_search(&n).is_ok();
            let at = if is_main { &mut forces.main } else { &mut forces.secondary }.entry(n).or_default();
            let components = self.components.get(&n);
            for (k, d) in row.by_ref().take(place.len()).enumerate() {
                match components.map_or(k, |c| c[k]) {
                    c @ 0..3 => at[c] += force * d,
                    c => forces.turning[c - 3] += force * d,
                }
            }
        }
    }

    /// What is to be said of an overclosure that a penalty leaves, where it is no longer small beside the facets, or as large as
    /// what the elements give way. A nonlinear penalty counts with its pressure over the overclosure, and is asked to leave the
    /// overclosure from which on it is as stiff as it gets.
    pub fn too_soft(&self, state: &ContactState) -> Option<TooSoft> {
        let has_facets = matches!(self.summary.origin, Origin::Pair(_));
        let penalty = self.summary.penalty.filter(|p| p.means.is_bare() && has_facets)?;
        let (node, depth) = state.largest_overclosure?;
        let overclosure = depth + penalty.clearance;
        let (limit, stiffness) = match penalty.means {
            Means::NonlinearPenalty(upper) => {
                (upper.max(SMALL * self.length), self.law.respond(-depth).pressure / overclosure)
            }
            _ => (SMALL * self.length, penalty.stiffness),
        };
        let part = if self.length > 0.0 { overclosure / self.length } else { 0.0 };
        let layers = self.summary.beneath.map_or(0.0, |beneath| beneath / stiffness);
        (part > 0.0 && overclosure > limit || layers >= A_LAYER).then_some(TooSoft { node, overclosure, part, layers })
    }

    fn side(&self, forces: &BTreeMap<u32, Vec3>, nodes: &[u32], turning: Vec3) -> SideForce {
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
        let nodes = self.secondary_nodes().iter().copied();
        let mut values = at_nodes(nodes, self.summary.measure, &state.points);
        for facet in self.sides.secondary.iter().filter(|f| !f.is_linear()) {
            let (nodes, corners) = (facet.nodes(), facet.corners());
            for (m, &middle) in nodes[corners..].iter().enumerate() {
                let (a, b) = (values[&nodes[m]], values[&nodes[(m + 1) % corners]]);
                let opening = a.opening.zip(b.opening).map(|(a, b)| 0.5 * (a + b));
                if opening.is_some() {
                    let unlike = a.status != b.status;
                    let status =
                        if unlike { self.respond(&*self.law, opening.unwrap_or_default()).status } else { a.status };
                    let pressure = 0.5 * (a.pressure + b.pressure);
                    let mean = |a: [f64; 2], b: [f64; 2]| [0, 1].map(|i| 0.5 * (a[i] + b[i]));
                    let (shear, slip) = (mean(a.shear, b.shear), mean(a.slip, b.slip));
                    let (node, measure, kind) = (middle, 0.0, a.kind);
                    values.insert(middle, NodeValues { node, opening, pressure, status, shear, slip, measure, kind });
                }
            }
        }
        values.into_values().collect()
    }
}

pub(crate) fn keep_larger(largest: &mut Option<(u32, f64)>, node: u32, value: f64) {
    if value > largest.map_or(0.0, |l| l.1) {
        *largest = Some((node, value));
    }
}
