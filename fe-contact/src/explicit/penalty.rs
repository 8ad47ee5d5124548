//! Contact by penalty or softened law: equal and opposite forces where secondary nodes are closed.

use super::behaviour::Meeting;
use super::definition::Enforcement;
use super::pair::{ContactPair, Point, open};
use super::target::Target;
use crate::facet::Vec3;
use fe_core::explicit::{Advance, Moving};

/// Stiffness of hard contact of a node over m/Δt² [-], m the mass of the node and Δt the increment that the elements allow: the
/// increment shrinks by some percent.
pub(super) const PENALTY: f64 = 0.1;

/// Increments over which what comes is foreseen [-]: the next one, should it be twice as long or the sides twice as fast.
pub(super) const AHEAD: f64 = 2.0;

/// Increments at the beginning of a step that differ by less than this part from those that springs were made for are like
/// them [-].
const LIKE: f64 = 0.1;

/// True where springs that were made for an increment [T] are to be made anew. They stay as they are as long as masses and
/// increments do: a step that goes on with a contact goes on with its forces.
pub(super) fn is_stale(made_for: Option<f64>, at: &Moving) -> bool {
    made_for.is_none_or(|made_for| at.dt == 0.0 && (at.stable / made_for - 1.0).abs() > LIKE)
}

impl ContactPair {
    /// Adds the forces [F] at the end of an increment.
    pub(super) fn press(&mut self, at: &Moving, forces: &mut [f64]) -> Advance {
        self.look(at.u, at.v);
        if is_stale(self.made_for, at) {
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
            let [a, b, c, d] = hit.shares;
            let row = [(point.index, 1.0), a, b, c, d];
            let (main, mass): (Vec3, f64) = match &self.target {
                Target::Faces(_) => {
                    let velocity = hit.shares.iter().map(|&(node, w)| self.carriers.v[node as usize] * w).sum();
                    (velocity, self.carriers.mass_of(&row))
                }
                Target::Rigid(_) => {
                    (self.carriers.bodies[0].velocity_at(&x), self.carriers.mass_on_surface(point.index))
                }
            };
            let meeting = Meeting {
                gap: hit.gap,
                normal: hit.normal,
                moved: (v - main) * at.dt,
                closing: (AHEAD * at.stable * (main - v).dot(&hit.normal)).max(0.0),
                mass,
                dt: at.dt,
                space: self.space,
            };
            let answer = self.definition.behaviour.meet(&point, &meeting);
            let force = answer.point.force;
            self.work -= 0.5 * (point.force + force).dot(&meeting.moved);
            self.rubbed += answer.rubbed;
            self.points[i] = answer.point;
            if answer.rates != [0.0; 2] {
                match &self.target {
                    Target::Faces(_) => self.carriers.stiffen(&row, answer.rates),
                    Target::Rigid(_) => self.carriers.stiffen_on_surface(point.index, answer.rates),
                }
            }
            if force == Vec3::zeros() {
                continue;
            }
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

    /// Stiffness of hard contact, once the increment is known; where the node has no mass, that of a mean node of the surfaces.
    fn stiffen(&mut self, increment: f64) {
        let Enforcement::Penalty(scale) = self.definition.enforcement else { return };
        let all = || self.carriers.inverse_mass.iter().filter(|inverse| **inverse > 0.0);
        let mean = all().sum::<f64>() / all().count().max(1) as f64;
        for point in &mut self.points {
            let own = self.carriers.inverse_mass[point.index as usize];
            let inverse = if own > 0.0 { own } else { mean } * increment * increment;
            point.penalty = if inverse.is_finite() && inverse > 0.0 { scale * PENALTY / inverse } else { 0.0 };
        }
        self.made_for = Some(increment);
    }
}
