//! Contact by penalty or softened law: equal and opposite forces where secondary nodes are closed.

use super::definition::{Enforcement, Normal};
use super::pair::{ContactPair, Point, open};
use super::target::{Hit, Target};
use crate::facet::Vec3;
use crate::friction::{Sliding, Spring};
use crate::point::ContactStatus;
use crate::tangents::tangents;
use crate::viscous::DampingAmount;
use fe_core::explicit::{Advance, Moving};

/// Stiffness of hard contact of a node over m/Δt² [-], m the mass that the two sides have against each other and Δt the
/// increment that the elements allow: the increment shrinks by some percent.
const PENALTY: f64 = 0.1;

impl ContactPair {
    /// Adds the forces [F] at the end of an increment.
    pub(super) fn press(&mut self, at: &Moving, forces: &mut [f64]) -> Advance {
        self.look(at.u, at.v);
        if !self.has_penalty {
            self.stiffen(at.stable);
        }
        for i in 0..self.points.len() {
            let point = self.points[i];
            let index = point.index as usize;
            let (x, v) = (self.carriers.x[index], self.carriers.v[index]);
            let Some(hit) = self.target.nearest(&self.carriers, i, &x) else {
                self.points[i] = Point { gap: f64::INFINITY, force: Vec3::zeros(), ..open(&point) };
                continue;
            };
            let main: Vec3 = match &self.target {
                Target::Faces(_) => hit.shares.iter().map(|&(node, w)| self.carriers.v[node as usize] * w).sum(),
                Target::Rigid(_) => self.carriers.bodies[0].velocity_at(&x),
            };
            let moved = (v - main) * at.dt;
            let (next, force, [stiffness, damping, rubbed]) = self.meet(&point, &hit, &moved, at.dt);
            self.work -= 0.5 * (point.force + force).dot(&moved);
            self.rubbed += rubbed;
            self.points[i] = Point { force, ..next };
            if force == Vec3::zeros() {
                continue;
            }
            self.carriers.stiffen(point.index, &hit.shares, [stiffness, damping]);
            self.carriers.force[index] += force;
            match &self.target {
                Target::Faces(_) => {
                    hit.shares.iter().for_each(|&(node, w)| self.carriers.force[node as usize] -= force * w);
                }
                Target::Rigid(_) => self.carriers.bodies[0].push(&-force, &x),
            }
        }
        self.carriers.scatter(forces);
        let [rate, damping] = self.carriers.rates();
        Advance { rate, damping, ..Advance::default() }
    }

    /// Mass [M] that a point and what it meets have against each other: 1/m = 1/m_s + Σ N²/m_i; what has none counts as held.
    fn mass(&self, point: &Point, hit: &Hit) -> f64 {
        let inverse = |index: u32| {
            let mass = self.carriers.mass[index as usize];
            if mass > 0.0 { 1.0 / mass } else { 0.0 }
        };
        let main: f64 = hit.shares.iter().map(|&(node, w)| if w > 0.0 { w * w * inverse(node) } else { 0.0 }).sum();
        let all = inverse(point.index) + main;
        if all > 0.0 { 1.0 / all } else { 0.0 }
    }

    /// Stiffness of hard contact, once the increment is known.
    fn stiffen(&mut self, increment: f64) {
        let Enforcement::Penalty(scale) = self.definition.enforcement else { return };
        for point in &mut self.points {
            let mass = self.carriers.mass[point.index as usize];
            point.penalty = if increment.is_finite() { scale * PENALTY * mass / (increment * increment) } else { 0.0 };
        }
        self.has_penalty = true;
    }

    /// Pressure and slope of a point, in the law's unit.
    fn normal(&self, point: &Point, gap: f64) -> (f64, f64) {
        match &self.definition.normal {
            Normal::Softened(law) => {
                let response = law.respond(gap);
                (response.pressure, response.stiffness)
            }
            Normal::Hard => {
                let slope = point.penalty / point.measure;
                if gap < 0.0 { (-slope * gap, slope) } else { (0.0, 0.0) }
            }
        }
    }

    /// One point at a hit: its new state, and the force [F] on the secondary node.
    fn meet(&self, point: &Point, hit: &Hit, moved: &Vec3, dt: f64) -> (Point, Vec3, [f64; 3]) {
        let mut next = Point { gap: hit.gap, ..*point };
        let (law, slope) = self.normal(point, hit.gap);
        let mass = self.mass(point, hit);
        let stiffness = slope * point.measure;
        let mut pressure = law;
        let mut damping = 0.0;
        if let Some(amount) = self.definition.damping
            && law > 0.0
            && dt > 0.0
        {
            damping = match amount {
                DampingAmount::Coefficient(coefficient) => coefficient * point.measure,
                DampingAmount::CriticalFraction(part) => part * (4.0 * mass * stiffness).sqrt(),
            };
            // It never pulls.
            pressure = (law - damping * moved.dot(&hit.normal) / dt / point.measure).max(0.0);
        }
        next.pressure = pressure;
        next.status = if law > 0.0 { ContactStatus::Closed } else { ContactStatus::Open };
        let mut force = hit.normal * (pressure * point.measure);
        (next.elastic, next.shear) = (Vec3::zeros(), [0.0; 2]);
        let mut rubbed = 0.0;
        if let Some(friction) = &self.definition.friction
            && law > 0.0
        {
            let directions = tangents(&hit.normal, self.space);
            let along = |v: &Vec3| directions.map(|t| t.dot(v));
            let (elastic, slip) = (along(&point.elastic), along(moved));
            let stiff = point.penalty / point.measure;
            let spring = if stiff > 0.0 { Spring::Stiffness(stiff) } else { friction.spring };
            let answer = friction.respond_on(spring, Sliding { pressure, elastic, slip, dt });
            for i in 0..2 {
                force -= directions[i] * (answer.shear[i] * point.measure);
                next.elastic += directions[i] * answer.elastic[i];
                next.slip[i] += slip[i];
                let heat = slip[i] - (answer.elastic[i] - elastic[i]);
                rubbed += answer.shear[i] * heat * point.measure;
            }
            next.shear = answer.shear;
            if answer.slips {
                next.status = ContactStatus::Slipping;
            }
        }
        (next, force, [stiffness, damping, rubbed])
    }
}
