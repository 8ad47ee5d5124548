//! `*CHANGE FRICTION`: friction that becomes another one over a step.

use super::coefficient::mix;
use super::{Coefficient, Coulomb, Friction, Spring};
use crate::carry::Carried;
use crate::contact::Contact;
use crate::enforce::Separation;
use crate::slip::{ELASTIC, Tangential};
use fe_core::Motion;
use fe_core::ramp::Ramp;
use std::borrow::Cow;

/// What a step makes of the friction of a contact. Coefficient and elastic slip of sticking points go from what they were to
/// what they become; all else changes at once. Friction stays where the step leaves it. Abaqus Analysis User's Manual,
/// Frictional behavior.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// What it becomes.
    pub to: Friction,
    /// Part of the way there over the step [-], from 0 to 1.
    pub course: Ramp,
}

/// A change in the present step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Changing {
    /// The law at the start of the step.
    pub from: Coulomb,
    course: Ramp,
    /// Of the step [T].
    period: f64,
    /// Part of the way [-] at the end of the step.
    last: f64,
}

impl Coulomb {
    /// The law that a change has come to, part of the way [-] from one to another.
    pub fn between(from: &Self, to: &Self, part: f64) -> Self {
        let limit = match (&from.limit, &to.limit) {
            (Some((from, _)), Some((to, largest))) => Some((Coefficient::between(from, to, part), *largest)),
            _ => to.limit.clone(),
        };
        let spring = match (from.spring, to.spring) {
            (Spring::Slip(from), Spring::Slip(to)) => Spring::Slip(mix(from, to, part)),
            _ => to.spring,
        };
        Coulomb { limit, spring }
    }

    /// The elastic slip [L] of a point that sticks with this shear under a pressure: what the law answers with it at rest.
    fn elastic(&self, shear: [f64; 2], pressure: f64) -> [f64; 2] {
        let stiffness = self.stiffness(pressure);
        shear.map(|shear| if stiffness > 0.0 { shear / stiffness } else { 0.0 })
    }
}

impl Tangential {
    /// The law at a motion's time.
    pub fn at(&self, at: &Motion) -> Cow<'_, Coulomb> {
        match &self.change {
            Some(change) => {
                Cow::Owned(change.part(&self.law, change.course.at(at.step_time, at.total_time, change.period)))
            }
            None => Cow::Borrowed(&self.law),
        }
    }
}

impl Changing {
    fn part(&self, to: &Coulomb, part: f64) -> Coulomb {
        Coulomb::between(&self.from, to, part)
    }
}

impl Contact {
    /// Begins a step at a total time [T] and of a period [T] in which friction changes, or stays where the last step left it;
    /// `history` is that of the last step's end, at a displacement.
    pub(crate) fn change_friction(
        &mut self,
        change: Option<&Change>,
        (start, period): (f64, f64),
        u: &[f64],
        history: &mut Vec<f64>,
    ) {
        let Some(tangential) = &mut self.tangential else { return };
        if let Some(ended) = tangential.change.take() {
            tangential.law = ended.part(&tangential.law, ended.last);
        }
        // Tied points are rough throughout.
        let Some(change) = change.filter(|_| self.separation != Separation::Tied) else { return };
        let from = tangential.law.clone();
        let carried = Carried {
            law: self.law.clone(),
            bare: self.bare.clone(),
            penalty: self.summary.penalty,
            multipliers: self.multipliers,
        };
        let mut next = carried.friction(&change.to, self.origin.1);
        let last = change.course.at(period, start + period, period);
        let first = Coulomb::between(&from, &next.law, change.course.at(0.0, start, period));
        self.stick_otherwise(&first, next.history(), u, history);
        next.change = Some(Changing { from, course: change.course.clone(), period, last });
        self.tangential = Some(next);
    }

    /// Lets points keep their shear where they stick by other means from now on: by a law and with so many `numbers` each.
    fn stick_otherwise(&self, law: &Coulomb, numbers: usize, u: &[f64], history: &mut Vec<f64>) {
        let Some(before) = &self.tangential else { return };
        if before.law.spring == law.spring && before.history() == numbers {
            return;
        }
        let by_length = |spring: Spring| matches!(spring, Spring::Slip(_));
        let alike = by_length(before.law.spring) && by_length(law.spring);
        let mut own = Vec::with_capacity(numbers * self.points.len());
        for point in 0..self.points.len() {
            let mut kept = history[self.own(point)..self.own(point) + before.history()].to_vec();
            if !alike {
                let (shear, _) = self.shear_and_slip(point, history);
                let pressure = self.answer(point, self.opening(point, u), (history, history)).response.pressure;
                kept[ELASTIC..ELASTIC + 2].copy_from_slice(&law.elastic(shear, pressure));
            }
            // Shifts count from increment to increment alone.
            kept.resize(numbers, 0.0);
            own.extend(kept);
        }
        history.splice(self.own(0)..self.numbers(), own);
    }
}
