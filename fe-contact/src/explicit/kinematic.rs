//! Kinematic contact: each increment is predicted without contact and corrected by impulses.
//!
//! An impulse λ of a point moves freedoms by Δv = M⁻¹ Jᵀ λ and Δu = Δv Δt, J the row of the gap: for a single node on a held
//! surface λ/Δt = m δ/Δt², the force that leaves no overclosure (Abaqus Analysis User's Manual, Contact constraint enforcement
//! methods in Explicit). Points that share nodes are solved in turn (Gauss-Seidel), until nothing changes; action is reaction.

use super::behaviour::Normal;
use super::carriers::Carriers;
use super::pair::{ContactPair, Point, open};
use super::target::{Hit, Target};
use crate::facet::Vec3;
use crate::friction::{Sliding, Spring};
use crate::law::NormalLaw;
use crate::point::ContactStatus;
use crate::tangents::tangents;
use fe_core::explicit::Predicted;
use std::collections::BTreeMap;

/// Sweeps over all points at most.
const SWEEPS: usize = 200;

/// Change of a gap over the deepest overclosure at which sweeps end [-].
const SETTLED: f64 = 1e-13;

/// The same over the way of the nodes in the increment [-]: what rounding leaves of it.
const ROUNDING: f64 = 1e-15;

/// A direction in which a point and what it meets move against each other.
#[derive(Debug, Default)]
struct Row {
    /// Freedoms, with how far the distance grows as they move.
    entries: Vec<(usize, f64)>,
    /// Velocity that an impulse of 1 gives to each, M⁻¹ Jᵀ [1/M].
    gains: Vec<f64>,
    /// J M⁻¹ Jᵀ [1/M]; 0 where all is held.
    compliance: f64,
    /// Rate of the distance without this pair, and the same before the forces of the increment [L/T].
    rate: f64,
    before: f64,
    /// Impulse [F T].
    impulse: f64,
}

impl Row {
    fn new(entries: Vec<(usize, f64)>, at: &Predicted) -> Self {
        let gains = at.gains(&entries);
        let compliance = entries.iter().zip(&gains).map(|(entry, gain)| entry.1 * gain).sum();
        let gained: f64 = entries.iter().zip(&gains).map(|(entry, gain)| gain * at.force[entry.0] * at.mean).sum();
        let mut row = Row { entries, gains, compliance, ..Row::default() };
        row.rate = row.rate(at);
        row.before = row.rate - gained;
        row
    }

    fn rate(&self, at: &Predicted) -> f64 {
        self.entries.iter().map(|&(f, d)| d * at.v[f]).sum()
    }

    /// Sum of the ways [L] that its freedoms have in the increment.
    fn way(&self, at: &Predicted) -> f64 {
        self.entries.iter().map(|&(f, d)| (d * at.v[f]).abs()).sum::<f64>() * at.dt
    }

    /// Takes another impulse; what it moves the distance by [L].
    fn change(&mut self, impulse: f64, at: &mut Predicted) -> f64 {
        let more = impulse - self.impulse;
        self.impulse = impulse;
        self.entries.iter().zip(&self.gains).for_each(|(entry, gain)| at.v[entry.0] += more * gain);
        more.abs() * self.compliance * at.dt
    }
}

/// A secondary node that is or may come closed.
#[derive(Debug)]
struct Closing {
    place: usize,
    measure: f64,
    hit: Hit,
    normal: Row,
    /// Along the surface, where there is friction.
    along: Vec<Row>,
    shear: [f64; 2],
    slips: bool,
}

impl ContactPair {
    /// The gaps of all points; the hits of those near.
    pub(super) fn survey(&mut self, u: &[f64], v: &[f64]) -> Vec<(usize, Hit)> {
        self.look(u, v);
        let mut hits = Vec::new();
        for (place, point) in self.points.iter_mut().enumerate() {
            let hit = self.target.nearest(&self.carriers, place, &self.carriers.x[point.index as usize]);
            let gap = hit.as_ref().map_or(f64::INFINITY, |hit| hit.gap);
            *point = Point { gap, ..open(point) };
            hits.extend(hit.map(|hit| (place, hit)));
        }
        hits
    }

    pub(super) fn correct_kinematically(&mut self, at: &mut Predicted) {
        let mut hits = self.survey(at.u, at.v);
        let reach = if let Normal::Softened(law) = &self.definition.behaviour.normal { law.reach() } else { 0.0 };
        let deepest = hits.iter().map(|(_, hit)| reach - hit.gap).fold(0.0, f64::max);
        // The main side moves by no more than the deepest.
        hits.retain(|(_, hit)| deepest > 0.0 && hit.gap < reach + deepest);
        let mut closing: Vec<Closing> = hits.into_iter().map(|(place, hit)| self.closing(place, hit, at)).collect();
        let way = closing.iter().map(|point| point.normal.way(at)).fold(0.0, f64::max);
        let settled = SETTLED * deepest + ROUNDING * way;
        let mut change = 0.0;
        for _ in 0..SWEEPS {
            change = closing.iter_mut().map(|point| self.solve(point, at)).fold(0.0, f64::max);
            if change <= settled {
                break;
            }
        }
        if change > settled {
            self.unsettled.increments += 1;
            self.unsettled.change = self.unsettled.change.max(change);
        }
        self.settle(&closing, at);
    }

    fn closing(&self, place: usize, hit: Hit, at: &Predicted) -> Closing {
        let point = &self.points[place];
        let row = |direction: &Vec3| Row::new(self.row(point.index, &hit, direction), at);
        let normal = row(&hit.normal);
        let along = match self.definition.behaviour.friction {
            Some(_) => tangents(&hit.normal, self.space).iter().map(row).collect(),
            None => Vec::new(),
        };
        Closing { place, measure: point.measure, hit, normal, along, shear: [0.0; 2], slips: false }
    }

    /// Freedoms that move a point against what it meets.
    fn row(&self, node: u32, hit: &Hit, direction: &Vec3) -> Vec<(usize, f64)> {
        let carriers: &Carriers = &self.carriers;
        let mut entries = Vec::new();
        carriers.row(node, direction, &mut entries);
        match &self.target {
            Target::Faces(_) => {
                let shares = hit.shares.iter().filter(|share| share.1 != 0.0);
                shares.for_each(|&(main, share)| carriers.row(main, &(-direction * share), &mut entries));
            }
            Target::Rigid(_) => carriers.bodies[0].row(&-direction, &carriers.x[node as usize], &mut entries),
        }
        // Nodes of one body share its freedoms.
        let mut sums = BTreeMap::new();
        entries.into_iter().for_each(|(f, d)| *sums.entry(f).or_insert(0.0) += d);
        sums.into_iter().collect()
    }

    /// The impulses of a point as the others are; what they move it by [L].
    fn solve(&self, point: &mut Closing, at: &mut Predicted) -> f64 {
        let growth = point.normal.compliance * at.dt;
        let gap = point.hit.gap + (point.normal.rate(at) - point.normal.rate) * at.dt - growth * point.normal.impulse;
        let impulse = match &self.definition.behaviour.normal {
            Normal::Softened(law) => softened(law.as_ref(), gap, growth, point.measure * at.mean),
            Normal::Hard | Normal::ScaleFactor { .. } if growth > 0.0 => (-gap / growth).max(0.0),
            Normal::Hard | Normal::ScaleFactor { .. } => 0.0,
        };
        let mut change = point.normal.change(impulse, at);
        let Some(friction) = &self.definition.behaviour.friction else { return change };
        let growth = point.along.iter().map(|row| row.compliance).fold(0.0, f64::max) * at.dt;
        if growth == 0.0 {
            return change;
        }
        let area = point.measure * at.mean;
        let slip = [0, 1].map(|i| point.along[i].rate(at) * at.dt - growth * point.along[i].impulse);
        let sliding = Sliding { pressure: impulse / area, elastic: [0.0; 2], slip, dt: at.dt };
        // A spring that takes all of the slip back within the increment.
        let answer = friction.respond_on(Spring::Stiffness(1.0 / (growth * area)), sliding);
        let holds = if impulse > 0.0 { 1.0 } else { 0.0 };
        (point.shear, point.slips) = (answer.shear.map(|shear| shear * holds), answer.slips && impulse > 0.0);
        for (row, shear) in point.along.iter_mut().zip(point.shear) {
            change = change.max(row.change(-shear * area, at));
        }
        change
    }

    /// Moves the freedoms, and keeps what there is to tell.
    fn settle(&mut self, closing: &[Closing], at: &mut Predicted) {
        let before = std::mem::take(&mut self.reactions);
        for point in closing.iter().filter(|point| point.normal.impulse > 0.0) {
            for row in [&point.normal].into_iter().chain(&point.along) {
                // ½ λ (v(n−½) + v(n+½)) is what it gives to ½ v(n−½) M v(n+½).
                let free = |entry: &&(usize, f64)| !at.is_prescribed[entry.0];
                let held: f64 = row.entries.iter().filter(|e| !free(e)).map(|&(f, d)| d * at.v[f]).sum();
                self.work -= 0.5 * row.impulse * (row.before + row.rate(at) - 2.0 * held);
                for (&(f, d), gain) in row.entries.iter().zip(&row.gains) {
                    if at.is_prescribed[f] {
                        *self.reactions.entry(f).or_insert(0.0) += row.impulse * d / at.mean;
                    } else {
                        at.u[f] += row.impulse * gain * at.dt;
                    }
                }
            }
            let slip: Vec<f64> = point.along.iter().map(|row| row.rate(at) * at.dt).collect();
            let own = &mut self.points[point.place];
            own.pressure = point.normal.impulse / (at.mean * point.measure);
            own.status = if point.slips { ContactStatus::Slipping } else { ContactStatus::Closed };
            own.shear = point.shear;
            for (i, slip) in slip.into_iter().enumerate() {
                own.slip[i] += slip;
                self.rubbed += point.shear[i] * slip * point.measure;
            }
        }
        for point in closing {
            let moved = (point.normal.rate(at) - point.normal.rate) * at.dt;
            self.points[point.place].gap = point.hit.gap + moved;
        }
        // Supports reckon by the trapezoidal rule.
        for (&f, force) in before.iter().chain(&self.reactions) {
            self.work -= 0.5 * force * at.v[f] * at.dt;
        }
    }
}

/// λ = p(g + c λ) A Δt at the corrected gap, by Newton's method between bounds; `growth` c [L/(F T)], `area` A Δt.
fn softened(law: &dyn NormalLaw, gap: f64, growth: f64, area: f64) -> f64 {
    // Pressure falls as the gap grows.
    let (mut low, mut high) = (0.0, law.respond(gap).pressure.max(0.0) * area);
    let mut impulse = high;
    for _ in 0..100 {
        let response = law.respond(gap + growth * impulse);
        let left = impulse - response.pressure * area;
        if left > 0.0 {
            high = impulse
        } else {
            low = impulse
        }
        let next = impulse - left / (1.0 + response.stiffness * growth * area);
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (next - impulse).abs() <= 1e-15 * high || left == 0.0 {
            break;
        }
        impulse = next;
    }
    impulse
}
