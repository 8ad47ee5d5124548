//! What steps say of contacts: cards that hold until a later step says otherwise.

use super::change_friction::Frictions;
use super::lines::{at_least_one, fields};
use super::scene::Scene;
use super::which_pair;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::model::Place;
use fe_contact::conditions::{Activity, Conditions};
use fe_contact::pair::PairDefinition;
use fe_core::amplitude::TimeBase;
use fe_core::ramp::Ramp;
use std::collections::BTreeSet;

fn in_total_time(course: &Ramp) -> bool {
    course.amplitude.as_ref().is_some_and(|amplitude| amplitude.base == TimeBase::Total)
}

/// The conditions in force, one for each contact pair once a step has said something of one.
#[derive(Clone, Debug, Default)]
pub struct InForce {
    conditions: Vec<Conditions>,
    /// Pairs with contact controls of their own.
    pub(super) own: BTreeSet<usize>,
    /// Changes of friction.
    pub(super) frictions: Frictions,
    /// Steps begun so far.
    pub(super) steps: usize,
    /// Period of the last step, and total time at its end [T].
    end: (f64, f64),
}

impl InForce {
    /// Begins a step: stabilisation and changes of friction end, interferences stay where the last step left them, or are taken out over this one where its cards
    /// replace them.
    pub fn begin_step(&mut self, replaces: bool) {
        self.steps += 1;
        self.frictions.begin_step();
        let (period, total) = self.end;
        for conditions in &mut self.conditions {
            (conditions.stabilization, conditions.friction) = (None, None);
            let course = conditions.interference.as_mut().map(|interference| &mut interference.course);
            if let Some(course) = course.filter(|course| replaces || !in_total_time(course)) {
                let held = course.at(period, total, period);
                *course = Ramp { from: held, to: if replaces { 0.0 } else { held }, amplitude: None };
            }
            conditions.interference.take_if(|interference| interference.course == Ramp::constant(0.0));
        }
    }

    /// Ends a step of so long a period [T].
    pub fn end_step(&mut self, period: f64) {
        self.end = (period, self.end.1 + period);
    }

    /// What holds after the cards of a step.
    pub fn conditions(&self) -> Vec<Conditions> {
        self.conditions.clone()
    }

    pub(super) fn of(&mut self, pair: usize) -> &mut Conditions {
        if self.conditions.len() <= pair {
            self.conditions.resize_with(pair + 1, Conditions::default);
        }
        &mut self.conditions[pair]
    }

    /// `*MODEL CHANGE`.
    pub fn change(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        pairs: &[(PairDefinition, Place)],
        diagnostics: &mut Diagnostics,
    ) {
        let (remove, add) = (entry.parameter("REMOVE"), entry.parameter("ADD"));
        let activity = match (remove, add) {
            (Some(_), None) => Activity::Removed,
            (None, Some(_)) => Activity::Acting,
            (Some(one), Some(other)) => {
                let fault = Diagnostic::error(other.span, "a card removes or adds, not both");
                diagnostics.push(fault.related(one.span, "the other one"));
                return;
            }
            (None, None) => {
                let fault = Diagnostic::error(entry.card.span, "`*MODEL CHANGE` needs `REMOVE` or `ADD`");
                diagnostics.push(fault);
                return;
            }
        };
        let lines = at_least_one(
            scene.deck.lines(entry.card),
            entry,
            ("this card names no pair", "add a line: secondary surface, main surface"),
            diagnostics,
        );
        for line in lines {
            let row = Row::read(line, fields(entry), diagnostics);
            let (Some(secondary), Some(main), true) = (row.token(0), row.token(1), row.sound) else { continue };
            let Some(pair) = which_pair::named((secondary, main), pairs, scene, diagnostics) else { continue };
            if which_pair::is_tied(entry, &pairs[pair], diagnostics) {
                continue;
            }
            let before = std::mem::replace(&mut self.of(pair).activity, activity);
            if before == activity {
                let already = if activity == Activity::Removed { "is removed" } else { "acts" };
                let note = Diagnostic::warning(row.span, format!("this pair {already} already"));
                diagnostics.push(note.label("the line changes nothing"));
            }
        }
    }
}
