//! Kinematic contact: each increment is predicted without contact and corrected by impulses.
//!
//! An impulse λ of a point moves freedoms by Δv = M⁻¹ Jᵀ λ and Δu = Δv Δt, J the row of the gap: for a single node on a held
//! surface λ/Δt = m δ/Δt², the force that leaves no overclosure (Abaqus Analysis User's Manual, Contact constraint enforcement
//! methods in Explicit). Points that share nodes are solved in turn (Gauss-Seidel), until nothing changes; action is reaction.

use super::behaviour::{Normal, Separation};
use super::carriers::Carriers;
use super::impulse::Unpressed;
use super::pair::{ContactPair, Point, open};
use super::row::Row;
use super::target::{Hit, Target};
use crate::facet::Vec3;
use crate::friction::{Sliding, Spring};
use crate::point::ContactStatus;
use crate::tangents::tangents;
use fe_core::explicit::Predicted;
use std::collections::BTreeMap;

/// Change of a gap over the deepest overclosure at which sweeps end [-].
const SETTLED: f64 = 1e-13;

/// The same over the way of the nodes in the increment [-]: what rounding leaves of it.
const ROUNDING: f64 = 1e-15;

/// A secondary node that is or may come closed.
#[derive(Debug)]
struct Closing {
    place: usize,
    measure: f64,
    hit: Hit,
    /// It may pull.
    bonded: bool,
    normal: Row,
    /// Along the surface, where there is friction, with the elastic slip [L] of before.
    along: Vec<Row>,
    elastic: [f64; 2],
    slips: bool,
}

impl Closing {
    fn rows(&mut self) -> impl Iterator<Item = &mut Row> {
        [&mut self.normal].into_iter().chain(&mut self.along)
    }

    /// What presses, or pulls: a point without friction of its own accord.
    fn acts(&self) -> bool {
        self.bonded || self.normal.impulse > 0.0
    }
}

/// The correction of an increment.
#[derive(Debug)]
pub(super) struct Correction {
    closing: Vec<Closing>,
    /// Change of a gap [L] at which sweeps end.
    pub settled: f64,
}

impl Correction {
    /// The impulses of all points.
    pub fn impulses(&mut self) -> Vec<f64> {
        self.closing.iter_mut().flat_map(|point| point.rows()).map(|row| row.impulse).collect()
    }

    /// Puts others in their place.
    pub fn change(&mut self, impulses: &[f64], at: &mut Predicted) {
        let rows = self.closing.iter_mut().flat_map(|point| point.rows());
        rows.zip(impulses).for_each(|(row, &impulse)| {
            row.change(impulse, at);
        });
    }
}

impl ContactPair {
    /// The gaps of all points; the hits of those near.
    pub(super) fn survey(&mut self, u: &[f64], v: &[f64]) -> Vec<(usize, Hit)> {
        self.look(u, v);
        let mut hits = Vec::new();
        for (place, point) in self.points.iter_mut().enumerate() {
            let hit = self.target.nearest(&self.carriers, place, &self.carriers.x[point.index as usize]);
            point.gap = hit.as_ref().map_or(f64::INFINITY, |hit| hit.gap);
            hits.extend(hit.map(|hit| (place, hit)));
        }
        hits
    }

    /// The points that are or may come closed in a predicted increment, without impulses.
    pub(super) fn predict(&mut self, at: &Predicted) -> Correction {
        let mut hits = self.survey(at.u, at.v);
        let reach = if let Normal::Softened(law) = &self.definition.behaviour.normal { law.reach() } else { 0.0 };
        let depth = |(place, hit): &(usize, Hit)| {
            let depth = reach - hit.gap;
            if self.points[*place].bonded { depth.abs() } else { depth }
        };
        let deepest = hits.iter().map(depth).fold(0.0, f64::max);
        // The main side moves by no more than the deepest.
        hits.retain(|(place, hit)| self.points[*place].bonded || (deepest > 0.0 && hit.gap < reach + deepest));
        let closing: Vec<Closing> = hits.into_iter().map(|(place, hit)| self.closing(place, hit, at)).collect();
        self.points.iter_mut().for_each(|point| *point = Point { force: Vec3::zeros(), ..open(point) });
        let way = closing.iter().map(|point| point.normal.way(at)).fold(0.0, f64::max);
        Correction { closing, settled: SETTLED * deepest + ROUNDING * way }
    }

    fn closing(&self, place: usize, hit: Hit, at: &Predicted) -> Closing {
        let point = &self.points[place];
        let row = |direction: &Vec3| Row::new(self.row(point.index, &hit, direction), at);
        let normal = row(&hit.normal);
        let directions = tangents(&hit.normal, self.space);
        let along = match self.definition.behaviour.friction {
            Some(_) => directions.iter().map(row).collect(),
            None => Vec::new(),
        };
        let elastic = directions.map(|direction| direction.dot(&point.elastic));
        let Point { measure, bonded, .. } = *point;
        Closing { place, measure, hit, bonded, normal, along, elastic, slips: false }
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

    /// Each point once, on areas that are `widened` by a factor; the largest way that one is moved by [L].
    pub(super) fn sweep(&self, correction: &mut Correction, widened: f64, at: &mut Predicted) -> f64 {
        correction.closing.iter_mut().map(|point| self.solve(point, widened, at)).fold(0.0, f64::max)
    }

    /// The impulses of a point as the others are; what they move it by [L].
    fn solve(&self, point: &mut Closing, widened: f64, at: &mut Predicted) -> f64 {
        let (measure, compliance) = (point.measure * widened, point.normal.compliance);
        let rate = point.normal.free_rate(at);
        let gap = point.hit.gap + (rate - point.normal.predicted) * at.dt;
        let impulse = match &self.definition.behaviour.normal {
            Normal::Softened(law) => {
                let (dt, mean, bonded) = (at.dt, at.mean, point.bonded);
                let unpressed = Unpressed { gap, rate, compliance, measure, dt, mean, bonded };
                unpressed.impulse(&self.definition.behaviour, law.as_ref())
            }
            Normal::Hard | Normal::ScaleFactor { .. } if compliance > 0.0 => {
                let closes = -gap / (compliance * at.dt);
                if point.bonded { closes } else { closes.max(0.0) }
            }
            Normal::Hard | Normal::ScaleFactor { .. } => 0.0,
        };
        let change = point.normal.change(impulse, at);
        change.max(self.rub(point, measure * at.mean, at))
    }

    /// The impulses of friction, on an `area` times time.
    fn rub(&self, point: &mut Closing, area: f64, at: &mut Predicted) -> f64 {
        let behaviour = &self.definition.behaviour;
        let compliance = point.along.iter().map(|row| row.compliance).fold(0.0, f64::max);
        let Some(friction) = behaviour.friction.as_ref().filter(|_| compliance > 0.0) else { return 0.0 };
        if !point.acts() {
            point.slips = false;
            return point.along.iter_mut().map(|row| row.change(0.0, at)).fold(0.0, f64::max);
        }
        // Shear that takes a unit of slip back within the increment; springs of the deck stand in series with it.
        let whole = 1.0 / (compliance * at.dt * area);
        let (stiffness, elastic) = match behaviour.shear_slope {
            Some(slope) => (slope * whole / (slope + whole), point.elastic),
            None => (whole, [0.0; 2]),
        };
        let slip = [0, 1].map(|i| {
            let row = &point.along[i];
            (row.rate(at) - compliance * row.impulse) * at.dt
        });
        let sliding = Sliding { pressure: point.normal.impulse / area, elastic, slip, dt: at.dt };
        let answer = friction.respond_on(Spring::Stiffness(stiffness), sliding);
        point.slips = answer.slips;
        let changes = point.along.iter_mut().zip(answer.shear).map(|(row, shear)| row.change(-shear * area, at));
        changes.fold(0.0, f64::max)
    }

    /// Moves the freedoms, and keeps what there is to tell.
    pub(super) fn settle(&mut self, correction: Correction, at: &mut Predicted) {
        let before = std::mem::take(&mut self.reactions);
        for point in correction.closing {
            let own = &mut self.points[point.place];
            own.gap = point.hit.gap + point.normal.moved(at);
            if !point.acts() {
                continue;
            }
            for row in [&point.normal].into_iter().chain(&point.along) {
                let reactions = &mut self.reactions;
                self.work += row.settle(at, |f, force| *reactions.entry(f).or_insert(0.0) += force);
            }
            let area = at.mean * point.measure;
            own.bonded = self.definition.behaviour.separation == Separation::Never;
            own.pressure = point.normal.impulse / area;
            own.status = if point.slips { ContactStatus::Slipping } else { ContactStatus::Closed };
            own.force = point.hit.normal * (point.normal.impulse / at.mean);
            let directions = tangents(&point.hit.normal, self.space);
            for (i, row) in point.along.iter().enumerate() {
                let (shear, slip) = (-row.impulse / area, row.rate(at) * at.dt);
                let elastic = self.definition.behaviour.shear_slope.map_or(0.0, |slope| shear / slope);
                let stored =
                    elastic - if self.definition.behaviour.shear_slope.is_some() { point.elastic[i] } else { 0.0 };
                own.shear[i] = shear;
                own.slip[i] += slip;
                own.elastic += directions[i] * elastic;
                own.force += directions[i] * (row.impulse / at.mean);
                self.rubbed += shear * (slip - stored) * point.measure;
            }
        }
        // Supports reckon by the trapezoidal rule.
        for (&f, force) in before.iter().chain(&self.reactions) {
            self.work -= 0.5 * force * at.v[f] * at.dt;
        }
    }
}
