//! What a step says of one contact, besides its law.

use crate::contact::Contact;

/// What a step says of one contact; by default nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conditions {
    /// Whether it acts at all.
    pub activity: Activity,
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
    /// Enters a step of which the conditions hold; `history` is the contact's, and becomes what the step starts with.
    pub fn enter(&mut self, conditions: &Conditions, history: &mut [f64]) {
        self.conditions = conditions.clone();
        if !self.acts() {
            // What comes back later has never been closed.
            history.fill(0.0);
        }
    }

    /// False where the step has removed it.
    pub fn acts(&self) -> bool {
        self.conditions.activity == Activity::Acting
    }
}
