//! What a step says of one contact, besides its law.

use crate::contact::Contact;
use crate::interference::{Allowance, Interference};

/// What a step says of one contact; by default nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conditions {
    /// Whether it acts at all.
    pub activity: Activity,
    /// Overclosure that is let be.
    pub interference: Option<Interference>,
}

/// `*MODEL CHANGE` of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Activity {
    /// It acts.
    #[default]
    Acting,
    /// Its surfaces know nothing of each other.
    Removed,
}

impl Contact {
    /// Enters a step of which the conditions hold; `time` is the total one [T] at its start, and its period [T]. `history` is
    /// the contact's, and becomes what the step starts with.
    pub fn enter(&mut self, conditions: &Conditions, time: (f64, f64), history: &mut Vec<f64>) {
        self.activity = conditions.activity;
        history.truncate(self.numbers());
        if !self.acts() {
            // What comes back later has never been closed.
            history.fill(0.0);
        }
        let interference = conditions.interference.as_ref();
        self.allowance = interference.map(|interference| Allowance::new(self, interference, time));
        history.extend(self.allowance.as_ref().map(|allowance| allowance.first));
    }

    /// False where the step has removed it.
    pub fn acts(&self) -> bool {
        self.activity == Activity::Acting
    }

    /// Numbers of history without what a step alone needs: a status for each point, and its multiplier.
    pub(crate) fn numbers(&self) -> usize {
        if self.multipliers.is_some() { 2 * self.points.len() } else { self.points.len() }
    }
}
