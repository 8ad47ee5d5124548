//! How a magnitude goes through a step.

use crate::amplitude::Amplitude;
use std::sync::Arc;

/// A magnitude over one step: along its amplitude, or straight from where it was to its new value.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// Value at the start of the step.
    pub from: f64,
    /// Value at the end of the step, or the factor on the amplitude.
    pub to: f64,
    /// Amplitude, if any.
    pub amplitude: Option<Arc<Amplitude>>,
}

impl Ramp {
    /// A value that stays.
    pub fn constant(value: f64) -> Self {
        Ramp { from: value, to: value, amplitude: None }
    }

    /// True where it does not change over the step.
    pub fn is_constant(&self) -> bool {
        self.amplitude.is_none() && self.from == self.to
    }

    /// The value at a time of the step; `period` is the step's.
    pub fn at(&self, step_time: f64, total_time: f64, period: f64) -> f64 {
        match &self.amplitude {
            Some(amplitude) => self.to * amplitude.at(step_time, total_time),
            None if step_time >= period => self.to,
            None => self.from + (self.to - self.from) * (step_time / period),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_exactly_at_its_value() {
        let ramp = Ramp { from: 0.1, to: 0.3, amplitude: None };
        assert_eq!(ramp.at(0.0, 5.0, 2.0), 0.1);
        assert_eq!(ramp.at(2.0, 7.0, 2.0), 0.3);
        assert!((ramp.at(1.0, 6.0, 2.0) - 0.2).abs() < 1e-16);
    }
}
