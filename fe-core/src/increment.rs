//! The size of the next increment: growth, cutback, and when a step is given up.

use crate::reject::Reject;
use crate::step::{Controls, Increments};

/// One try of an increment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// Number of the increment in its step, from 1.
    pub increment: usize,
    /// Number of the attempt, from 1.
    pub attempt: usize,
    /// Time increment [T].
    pub dt: f64,
    /// Step time at its end [T]; exactly the period for the last one.
    pub step_time: f64,
}

/// Why a step ended before its time.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Failure {
    /// The increment was tried too often.
    #[error("the increment was tried {attempts} times; the last time: {last}")]
    TooManyAttempts {
        /// Tries.
        attempts: usize,
        /// Last reason.
        last: Reject,
    },
    /// The increment would have to be smaller than the smallest allowed.
    #[error(
        "an increment of {needed:.3e} would be needed, less than the smallest allowed ({minimum:.3e}); the last reason: {last}"
    )]
    TooSmall {
        /// Increment [T].
        needed: f64,
        /// Smallest allowed [T].
        minimum: f64,
        /// Last reason.
        last: Reject,
    },
    /// `*STEP, INC=` increments are used up.
    #[error("{most} increments are used up at step time {step_time:.6e} of {period:.6e} (*STEP, INC=)")]
    TooMany {
        /// Most increments.
        most: usize,
        /// Step time reached [T].
        step_time: f64,
        /// Step time wanted [T].
        period: f64,
    },
    /// An increment that cannot be cut (fixed size) was rejected.
    #[error("increments of fixed size cannot be cut back; the reason: {last}")]
    Fixed {
        /// Reason.
        last: Reject,
    },
}

/// Chooses the increments of one step.
#[derive(Clone, Debug)]
pub struct IncrementSize {
    increments: Increments,
    controls: Controls,
    step_time: f64,
    next: f64,
    accepted: usize,
    attempt: usize,
    easy: usize,
}

impl IncrementSize {
    /// At the start of a step.
    pub fn new(increments: Increments, controls: Controls) -> Self {
        let next = increments.initial;
        IncrementSize { increments, controls, step_time: 0.0, next, accepted: 0, attempt: 0, easy: 0 }
    }

    /// The next try, or `None` when the step is complete.
    pub fn next_attempt(&mut self) -> Result<Option<Attempt>, Failure> {
        let period = self.increments.period;
        let left = period - self.step_time;
        // What is left of a step that round-off would make an increment of its own.
        if left <= 1e-12 * period {
            return Ok(None);
        }
        if self.accepted == self.increments.most {
            return Err(Failure::TooMany { most: self.increments.most, step_time: self.step_time, period });
        }
        self.attempt += 1;
        let last = self.next >= left * (1.0 - 1e-9);
        let dt = if last { left } else { self.next };
        let step_time = if last { period } else { self.step_time + dt };
        Ok(Some(Attempt { increment: self.accepted + 1, attempt: self.attempt, dt, step_time }))
    }

    /// The try converged in so many iterations without a change of status.
    pub fn accept(&mut self, attempt: Attempt, iterations: usize) {
        self.step_time = attempt.step_time;
        self.accepted += 1;
        self.attempt = 0;
        if self.increments.fixed {
            return;
        }
        self.easy = if iterations <= self.controls.i_g { self.easy + 1 } else { 0 };
        if iterations > self.controls.i_l {
            self.next = (self.next * self.controls.d_b).max(self.increments.minimum);
        } else if self.easy >= 2 {
            self.next = (self.next * self.controls.d_d).min(self.increments.maximum);
        }
    }

    /// The try failed: a smaller one next, or the end.
    pub fn cut_back(&mut self, attempt: Attempt, last: Reject) -> Result<(), Failure> {
        if self.increments.fixed {
            return Err(Failure::Fixed { last });
        }
        if attempt.attempt >= self.controls.i_a {
            return Err(Failure::TooManyAttempts { attempts: attempt.attempt, last });
        }
        let factor = match last {
            Reject::StatusChanges { .. } => self.controls.d_s,
            Reject::NoConvergence { .. } => self.controls.d_c,
            _ => self.controls.d_f,
        };
        let needed = attempt.dt * factor;
        if needed < self.increments.minimum {
            return Err(Failure::TooSmall { needed, minimum: self.increments.minimum, last });
        }
        self.next = needed;
        self.easy = 0;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn increments(initial: f64) -> Increments {
        Increments { initial, period: 1.0, minimum: 1e-5, maximum: 0.5, fixed: false, most: 100 }
    }

    #[test]
    fn grows_after_two_easy_increments_and_ends_exactly() {
        let mut size = IncrementSize::new(increments(0.1), Controls::default());
        let mut steps = Vec::new();
        while let Some(attempt) = size.next_attempt().unwrap() {
            steps.push(attempt.dt);
            size.accept(attempt, 2);
            assert!(attempt.step_time <= 1.0);
        }
        let expected = [0.1, 0.1, 0.15, 0.225, 0.3375, 0.0875];
        assert!(steps.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{steps:?}");
    }

    #[test]
    fn ten_tenths_are_ten_increments() {
        let mut size = IncrementSize::new(Increments { fixed: true, ..increments(0.1) }, Controls::default());
        let mut count = 0;
        while let Some(attempt) = size.next_attempt().unwrap() {
            size.accept(attempt, 20);
            count += 1;
        }
        assert_eq!(count, 10);
    }

    #[test]
    fn gives_up_with_the_last_reason() {
        let mut size = IncrementSize::new(increments(1.0), Controls::default());
        let reason = || Reject::Diverging { iterations: 6, residual: 1.0 };
        for tried in 1..=5 {
            let attempt = size.next_attempt().unwrap().unwrap();
            assert_eq!(attempt.attempt, tried);
            let end = size.cut_back(attempt, reason());
            assert_eq!(end.is_err(), tried == 5);
        }
        let mut size = IncrementSize::new(increments(2e-5), Controls::default());
        let attempt = size.next_attempt().unwrap().unwrap();
        assert!(matches!(size.cut_back(attempt, reason()), Err(Failure::TooSmall { .. })));
    }
}
