//! What a run tells while it goes on.

use crate::certificate::{Certificate, RunCertificate};
use crate::explicit::Frame;
use crate::plan::Plan;
use fe_core::increment::Attempt;
use fe_core::procedure::Convergence;

/// Something that happened in a run.
pub enum Event<'a> {
    /// A remark: a card without effect, a body moved into contact.
    Note(&'a str),
    /// A step begins.
    Step {
        /// Number, from 1.
        number: usize,
        /// What it needs.
        plan: &'a Plan,
        /// Step time [T].
        period: f64,
    },
    /// An increment converged.
    Increment {
        /// Number of the step, from 1.
        step: usize,
        /// The attempt that converged.
        attempt: Attempt,
        /// How.
        convergence: &'a Convergence,
        /// What stands beside it.
        certificate: &'a Certificate,
        /// Contact force, summed over the pairs' resultants [F].
        contact_force: f64,
    },
    /// An attempt failed.
    Cutback {
        /// Number of the step, from 1.
        step: usize,
        /// The attempt.
        attempt: Attempt,
        /// Why, with the labels of the deck.
        reason: &'a str,
    },
    /// A frame of an explicit step was stored, or it has gone on for a while without one.
    Frame(&'a Frame),
    /// All steps are complete.
    Done(&'a RunCertificate),
}

/// Follows a run.
pub trait Observer {
    /// Takes an event.
    fn event(&mut self, event: Event);
}

/// Follows nothing.
pub struct Silent;

impl Observer for Silent {
    fn event(&mut self, _: Event) {}
}
