//! When Newton's iteration ends: the decks' criteria, and ours on top of them.
//!
//! Forces are always those of the true laws at the iterate, so a residual that round-off explains is equilibrium,
//! also when points that barely touch changed status on the way.

use super::Convergence;
use crate::reject::Reject;
use crate::step::Controls;

/// What one iteration left.
#[derive(Clone, Copy, Debug)]
pub struct Iterate {
    /// Largest residual on a free freedom [F].
    pub residual: f64,
    /// Largest external, reaction or contact force [F].
    pub largest_force: f64,
    /// Mean of the external, reaction and contact forces that are not zero [F].
    pub mean_force: f64,
    /// Largest correction of the iteration [L].
    pub correction: f64,
    /// Largest displacement of the increment [L].
    pub increment: f64,
    /// Points whose status changed in the iteration.
    pub status_changes: usize,
    /// Residual that round-off alone explains [F].
    pub round_off: f64,
}

/// A residual below `R_l` of the mean force needs no test of the correction (the decks' R_l).
const LINEAR_INCREMENT: f64 = 1e-8;

/// A residual above this part of the last one does not fall any more.
const STAGNANT: f64 = 0.5;

/// A residual falls ever faster when the logarithm of its fall grows by more than this factor.
const QUICKENS: f64 = 1.1;

/// What to do after an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// The increment is done.
    Converged,
    /// One more iteration.
    GoOn,
}

/// Follows the iterations of one increment.
pub struct Newton {
    controls: Controls,
    status_iterations: usize,
    equilibrium_iterations: usize,
    /// Equilibrium iterations before the last augmentation.
    augmented: usize,
    /// Residual of the last iteration without a change of status, since the last one with.
    last_residual: f64,
    /// ln of how many times the residual became smaller in the last iteration.
    last_fall: f64,
    /// Residual of the last iteration.
    before: f64,
    grown: usize,
    /// Mean force of the earlier increments of the step: sum and count.
    past: (f64, usize),
}

impl Newton {
    /// At the start of an increment; `past` holds sum and count of the mean forces of the step's increments.
    pub fn new(controls: Controls, past: (f64, usize)) -> Self {
        Newton {
            controls,
            status_iterations: 0,
            equilibrium_iterations: 0,
            augmented: 0,
            last_residual: f64::INFINITY,
            last_fall: f64::INFINITY,
            before: f64::INFINITY,
            grown: 0,
            past,
        }
    }

    /// Counts an iteration and judges it.
    pub fn judge(&mut self, now: &Iterate) -> Result<Verdict, Reject> {
        let c = self.controls;
        let mean = (self.past.0 + now.mean_force) / (self.past.1 + 1) as f64;
        let ratio = if now.largest_force > 0.0 { now.residual / now.largest_force } else { 0.0 };
        if now.status_changes > 0 {
            self.status_iterations += 1;
            let most = if c.convert_sdi { c.i_s_converted } else { c.i_s };
            // A point that flips with a pressure below round-off leaves an equilibrium as it was.
            if self.settled(now, mean) {
                return Ok(Verdict::Converged);
            }
            self.before = now.residual;
            if self.status_iterations > most {
                let iterations = self.status_iterations;
                return Err(Reject::StatusChanges { iterations, changes: now.status_changes });
            }
            // The decks count equilibrium iterations anew after each change of status.
            self.equilibrium_iterations = 0;
            self.last_residual = f64::INFINITY;
            self.grown = 0;
            return Ok(Verdict::GoOn);
        }
        self.equilibrium_iterations += 1;
        if self.balanced(now, mean) {
            return Ok(Verdict::Converged);
        }
        let iterations = self.equilibrium_iterations;
        let foreseen = self.foreseen(now, mean);
        // On a steep law Newton's method quickens late.
        let fall = (self.last_residual / now.residual).ln();
        let quickens = fall > QUICKENS * std::mem::replace(&mut self.last_fall, fall);
        self.grown = if now.residual > self.last_residual { self.grown + 1 } else { 0 };
        self.last_residual = now.residual;
        self.before = now.residual;
        if iterations > c.i_0 && self.grown >= 2 {
            return Err(Reject::Diverging { iterations, residual: ratio });
        }
        if iterations >= c.i_c || (iterations >= c.i_r && foreseen > c.i_c as f64 && !quickens) {
            return Err(Reject::NoConvergence { iterations, residual: ratio });
        }
        Ok(Verdict::GoOn)
    }

    /// Counts anew after an augmentation.
    pub fn augmented(&mut self) {
        self.augmented += self.equilibrium_iterations;
        self.equilibrium_iterations = 0;
        self.last_residual = f64::INFINITY;
        self.grown = 0;
        self.before = f64::INFINITY;
    }

    /// Round-off explains the residual; where that is more than the controls allow, and yet not all there is, another
    /// iteration must not help any more.
    fn settled(&self, now: &Iterate, mean: f64) -> bool {
        let little = now.residual <= self.allowed(now, mean) || now.round_off >= now.largest_force;
        now.residual <= now.round_off && (little || now.residual > STAGNANT * self.before)
    }

    /// Largest residual [F] that is allowed.
    fn allowed(&self, now: &Iterate, mean: f64) -> f64 {
        let c = self.controls;
        let tolerance = if self.equilibrium_iterations > c.i_p { c.late_residual } else { c.residual };
        (tolerance * mean).min(c.balance * now.largest_force)
    }

    /// Iterations in all until the residual is small enough, if it goes on to fall as it just did.
    fn foreseen(&self, now: &Iterate, mean: f64) -> f64 {
        let allowed = self.allowed(now, mean).max(now.round_off);
        let fall = (self.last_residual / now.residual).ln();
        if now.residual <= allowed {
            self.equilibrium_iterations as f64
        } else if fall > 0.0 {
            self.equilibrium_iterations as f64 + (now.residual / allowed).ln() / fall
        } else {
            f64::INFINITY
        }
    }

    /// Residual and correction are small enough.
    fn balanced(&self, now: &Iterate, mean: f64) -> bool {
        let c = self.controls;
        if self.settled(now, mean) {
            return true;
        }
        let force = now.residual <= self.allowed(now, mean);
        let motion = now.correction <= c.correction * now.increment || now.residual <= LINEAR_INCREMENT * mean;
        force && motion
    }

    /// How the increment converged.
    pub fn convergence(&self, last: &Iterate) -> Convergence {
        Convergence {
            status_iterations: self.status_iterations,
            equilibrium_iterations: self.equilibrium_iterations,
            augmented_iterations: self.augmented,
            residual: last.residual,
            largest_force: last.largest_force,
            round_off: last.round_off,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn iterate(residual: f64, status_changes: usize) -> Iterate {
        Iterate {
            residual,
            largest_force: 1.0,
            mean_force: 0.1,
            correction: 1.0,
            increment: 1.0,
            status_changes,
            round_off: 1e-14,
        }
    }

    #[test]
    fn a_change_of_status_goes_on_unless_round_off_is_all_that_is_left() {
        let mut newton = Newton::new(Controls::default(), (0.0, 0));
        assert_eq!(newton.judge(&iterate(1e-13, 1)), Ok(Verdict::GoOn));
        assert_eq!(newton.judge(&iterate(1e-15, 1)), Ok(Verdict::Converged));
    }

    /// At the eighth iteration (I_R): by tenths from 10 the goal of 1e-9 is 3 iterations away, by halves 26.
    #[test]
    fn slow_convergence_is_seen_before_the_last_iteration() {
        for (factor, rejected) in [(0.1f64, false), (0.5, true)] {
            let mut newton = Newton::new(Controls::default(), (0.0, 0));
            let verdicts: Vec<_> = (0..8).map(|k| newton.judge(&iterate(10.0 * factor.powi(k), 0))).collect();
            assert!(verdicts[..7].iter().all(|v| *v == Ok(Verdict::GoOn)));
            assert_eq!(verdicts[7].is_err(), rejected, "{factor}: {:?}", verdicts[7]);
        }
    }

    #[test]
    fn the_correction_counts_until_the_residual_is_tiny() {
        let mut newton = Newton::new(Controls::default(), (0.0, 0));
        assert_eq!(newton.judge(&iterate(5e-9, 0)), Ok(Verdict::GoOn));
        assert_eq!(newton.judge(&iterate(5e-10, 0)), Ok(Verdict::Converged));
    }

    /// Round-off above what the controls ask for (1e-8 of the largest force): the residual falls as far as it can.
    #[test]
    fn large_round_off_is_taken_when_it_stays() {
        let mut newton = Newton::new(Controls::default(), (0.0, 0));
        let rough = |residual| Iterate { round_off: 1e-3, ..iterate(residual, 0) };
        assert_eq!(newton.judge(&rough(9e-4)), Ok(Verdict::GoOn));
        assert_eq!(newton.judge(&rough(4e-5)), Ok(Verdict::GoOn));
        assert_eq!(newton.judge(&rough(3e-5)), Ok(Verdict::Converged));
    }

    #[test]
    fn growth_after_the_first_iterations_is_divergence() {
        let mut newton = Newton::new(Controls::default(), (0.0, 0));
        for residual in [1.0, 0.5, 0.4, 0.3, 0.35] {
            assert_eq!(newton.judge(&iterate(residual, 0)), Ok(Verdict::GoOn));
        }
        assert!(matches!(newton.judge(&iterate(0.4, 0)), Err(Reject::Diverging { .. })));
    }

    #[test]
    fn statuses_that_do_not_settle_are_given_up() {
        let mut newton = Newton::new(Controls { convert_sdi: false, ..Controls::default() }, (0.0, 0));
        for _ in 0..12 {
            assert_eq!(newton.judge(&iterate(1.0, 3)), Ok(Verdict::GoOn));
        }
        assert_eq!(newton.judge(&iterate(1.0, 3)), Err(Reject::StatusChanges { iterations: 13, changes: 3 }));
    }
}
