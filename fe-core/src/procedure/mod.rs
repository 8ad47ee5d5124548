//! Procedures: from one converged state to the next.

pub mod newton;
mod scale;
pub mod static_general;
pub mod system;

use crate::increment::Attempt;
use crate::reject::Reject;

/// A converged state; nothing edits it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Converged {
    /// Displacement since the start, over all freedoms [L or rad].
    pub u: Vec<f64>,
    /// Internal minus external force, over all freedoms [F]: the reaction where a freedom is prescribed,
    /// what is left of the balance elsewhere.
    pub residual: Vec<f64>,
    /// External force, over all freedoms [F].
    pub external: Vec<f64>,
    /// History of each term.
    pub history: Vec<Vec<f64>>,
    /// Time since the start of the step [T].
    pub step_time: f64,
    /// Time since the start of the job [T].
    pub total_time: f64,
    /// Energies.
    pub energy: Energy,
}

/// Energies of a state [F L].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Stored in the terms that are linear in the displacement (solids).
    pub solids: f64,
    /// Stored in all other terms (contact).
    pub contact: f64,
    /// Turned into heat by friction, summed over the increments.
    pub friction: f64,
    /// Work of loads and prescribed displacements, summed over the increments by the trapezoidal rule.
    pub work: f64,
}

/// How an increment converged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Convergence {
    /// Iterations in which a contact status changed.
    pub status_iterations: usize,
    /// Iterations without such a change.
    pub equilibrium_iterations: usize,
    /// Equilibrium iterations before the last augmentation of multipliers.
    pub augmented_iterations: usize,
    /// Largest residual [F].
    pub residual: f64,
    /// Largest external, reaction or contact force on one freedom [F].
    pub largest_force: f64,
    /// Residual that round-off alone explains [F].
    pub round_off: f64,
}

impl Convergence {
    /// All iterations of the increment.
    pub fn iterations(&self) -> usize {
        self.status_iterations + self.augmented_iterations + self.equilibrium_iterations
    }

    /// Largest residual over the largest force [-]; 0 in a scene without forces above round-off.
    pub fn ratio(&self) -> f64 {
        if self.largest_force > self.round_off { self.residual / self.largest_force } else { 0.0 }
    }
}

/// Takes the converged state and an increment, and returns the next converged state or a reason to cut back.
pub trait Procedure {
    /// One increment.
    fn advance(&mut self, from: &Converged, attempt: Attempt) -> Result<(Converged, Convergence), Reject>;

    /// Seconds spent so far.
    fn seconds(&self) -> Seconds;
}

/// Wall-clock seconds by phase.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds {
    /// Pattern, ordering and symbolic factorisation.
    pub order: f64,
    /// Forces and stiffness.
    pub assemble: f64,
    /// Numerical factorisation.
    pub factor: f64,
    /// Forward and back substitution.
    pub solve: f64,
}

impl std::ops::AddAssign for Seconds {
    fn add_assign(&mut self, other: Self) {
        self.order += other.order;
        self.assemble += other.assemble;
        self.factor += other.factor;
        self.solve += other.solve;
    }
}
