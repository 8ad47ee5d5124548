//! A term of the virtual work: all that is ever assembled.

use crate::matrix::{BlockMatrix, Couplings};
use crate::reject::Reject;

/// The motion that a term is evaluated at; vectors over all freedoms (see [`crate::Freedoms`]).
#[derive(Clone, Copy)]
pub struct Motion<'a> {
    /// Displacement since the start [L] (rotations in radians).
    pub u: &'a [f64],
    /// Displacement since the start of the increment.
    pub du: &'a [f64],
    /// Time at the end of the increment since the start of the step [T].
    pub step_time: f64,
    /// Time at the end of the increment since the start of the job [T].
    pub total_time: f64,
    /// Time increment [T].
    pub dt: f64,
}

/// Where one evaluation of all terms is collected; each term adds to it.
pub struct Assembly<'a> {
    /// Internal minus external force [F], over all freedoms.
    pub residual: &'a mut [f64],
    /// Derivative of the residual with respect to u; only when asked for.
    pub stiffness: Option<&'a mut BlockMatrix>,
    /// Stored energy less the potential of dead loads [F L].
    pub energy: f64,
    /// Points whose status (open, closed) differs from the last evaluation of this increment.
    pub status_changes: usize,
}

/// An equilibrium whose constraints may not be met yet.
#[derive(Clone, Copy)]
pub struct Equilibrium<'a> {
    /// Displacement since the start [L], over all freedoms.
    pub u: &'a [f64],
    /// Largest force [F] that is not balanced.
    pub noise: f64,
    /// Augmentations of this increment so far.
    pub passes: usize,
}

/// The worst of the constraints that are not met yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Node.
    pub node: usize,
    /// Overclosure [L]; negative where a held point stands open.
    pub overclosure: f64,
}

/// Adds C x to y, where (x, y) are its arguments, over all freedoms.
pub type Lacking<'s> = Box<dyn Fn(&[f64], &mut [f64]) + 's>;

/// One term of the virtual work: a whole block of like elements, all loads of a kind, one contact pair.
pub trait Term: Send + Sync {
    /// What messages call it.
    fn name(&self) -> &str;

    /// Which nodes it couples in the stiffness. Loads couple none.
    fn couplings(&self, _couplings: &mut Couplings) {}

    /// Numbers of history it keeps.
    fn history(&self) -> usize {
        0
    }

    /// Adds force, stiffness and energy at a motion. `old` is the history at the start of the increment, `new`
    /// what the previous evaluation of this increment left (at first a copy of `old`) and receives the new one.
    fn evaluate(&self, at: Motion, old: &[f64], new: &mut [f64], out: &mut Assembly) -> Result<(), Reject>;

    /// Takes what the constraints of this term need to be met more closely into `new`, at an equilibrium; `None` where they
    /// are met well enough. Another equilibrium is then looked for.
    fn augment(&self, _at: Equilibrium, _old: &[f64], _new: &mut [f64]) -> Option<Overlap> {
        None
    }

    /// True when residual and stiffness are linear in u with a constant stiffness in the whole step and no
    /// force at u = 0: the stiffness is then assembled once a step and the force is its product with u.
    fn is_linear(&self) -> bool {
        false
    }

    /// Largest force [F] that rounding of what it depends on explains, at a displacement and with the history of an evaluation
    /// there; where forces of displacements as large as `u` do not show it.
    fn force_round_off(&self, _u: &[f64], _history: &[f64]) -> f64 {
        0.0
    }

    /// What the symmetric stiffness of [`Term::evaluate`] lacks of the derivative of the residual at this motion and history
    /// (old, new), as a product; `None` where it lacks nothing.
    fn lacking<'s>(&'s self, _at: Motion, _history: (&[f64], &[f64])) -> Option<Lacking<'s>> {
        None
    }

    /// Work [F L] that an increment with this history, at its start and at its end, turned into heat.
    fn dissipated(&self, _old: &[f64], _new: &[f64]) -> f64 {
        0.0
    }

    /// Adds stiffness at a displacement where the term acts with a force and without stiffness of its own, for Newton's
    /// method to find on from where nothing else holds; true when there was such a place.
    fn stiffen(&self, _u: &[f64], _stiffness: &mut BlockMatrix) -> bool {
        false
    }
}
