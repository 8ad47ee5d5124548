//! `*CONTACT INTERFERENCE`: overclosure that a step lets be, less and less of it.

use crate::contact::Contact;
use fe_core::Motion;
use fe_core::ramp::Ramp;

/// How much overclosure a step lets be, and its course: the constraint is g + v(t) ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Interference {
    /// Where the course is at 1.
    pub allowed: Allowed,
    /// Factor on it over the step [-].
    pub course: Ramp,
}

/// Overclosure that is let be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// So much [L] everywhere.
    Overclosure(f64),
    /// What a shift [L] of the secondary side takes away.
    Shift([f64; 3]),
    /// Of each point what it has at the start of the job.
    Own,
}

/// An interference at the points of a contact.
#[derive(Clone, Debug)]
pub(crate) struct Allowance {
    course: Ramp,
    /// Of the step [T].
    period: f64,
    /// Factor [-] at the start of the step.
    pub first: f64,
    /// Overclosure [L] of each point where the course is at 1.
    amounts: Vec<f64>,
    /// Where its factor stands in the history, which keeps that of the last evaluation.
    place: usize,
}

impl Allowance {
    /// For a step that starts at a total time [T] and lasts for a period [T].
    pub fn new(contact: &Contact, interference: &Interference, (start, period): (f64, f64)) -> Self {
        let freedoms = contact.places.iter().flatten().map(|place| place.end).max().unwrap_or(0);
        let rest = vec![0.0; freedoms];
        let amount = |i: usize| match interference.allowed {
            Allowed::Overclosure(depth) => depth,
            Allowed::Own => (-contact.opening(i, &rest)).max(0.0),
            Allowed::Shift(shift) => opened(contact, i, &contact.at(i, &rest).row, shift),
        };
        let amounts = (0..contact.points.len()).map(amount).collect();
        let course = interference.course.clone();
        Allowance { first: course.at(0.0, start, period), course, period, amounts, place: contact.numbers() }
    }
}

impl Contact {
    /// Overclosure [L] of a point that is let be, by the history of an evaluation.
    pub(crate) fn allowed(&self, point: usize, history: &[f64]) -> f64 {
        self.allowance.as_ref().map_or(0.0, |a| a.amounts[point] * history[a.place])
    }

    /// Gap [L] of a point at a displacement, with what is let be at the start of the step.
    pub(crate) fn opening_at_start(&self, point: usize, u: &[f64]) -> f64 {
        self.opening(point, u) + self.allowance.as_ref().map_or(0.0, |a| a.amounts[point] * a.first)
    }

    /// Keeps how much is let be at a motion's time.
    pub(crate) fn allow(&self, at: &Motion, history: &mut [f64]) {
        if let Some(allowance) = &self.allowance {
            history[allowance.place] = allowance.course.at(at.step_time, at.total_time, allowance.period);
        }
    }
}

/// How much a shift of the secondary nodes opens a point [L].
fn opened(contact: &Contact, point: usize, row: &[f64], shift: [f64; 3]) -> f64 {
    let nodes = contact.points[point].nodes.iter().zip(&contact.places[point]);
    let (mut first, mut sum) = (0, 0.0);
    for (node, place) in nodes {
        if contact.secondary_nodes().binary_search(node).is_ok() {
            sum += row[first..first + place.len()].iter().zip(shift).map(|(d, s)| d * s).sum::<f64>();
        }
        first += place.len();
    }
    sum
}
