//! Dead loads in an explicit step.

use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::external::ExternalForces;

/// External forces with the work that they do.
#[derive(Clone, Debug)]
pub struct Loads {
    external: ExternalForces,
    period: f64,
    /// Magnitudes at the end of the last increment.
    before: Vec<f64>,
    work: f64,
}

impl Loads {
    /// Over a step of so long a period [T].
    pub fn new(external: ExternalForces, period: f64) -> Self {
        Loads { before: vec![0.0; external.parts.len()], external, period, work: 0.0 }
    }

    /// With the energy [F L] that those of the steps before took from the motion.
    pub fn after(mut self, stored: f64) -> Self {
        self.work = -stored;
        self
    }
}

impl ExplicitTerm for Loads {
    fn name(&self) -> &str {
        "loads"
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        for ((unit, ramp), before) in self.external.parts.iter().zip(&mut self.before) {
            let magnitude = ramp.at(at.step_time, at.total_time, self.period);
            let mut moved = 0.0;
            for &(f, value) in unit {
                forces[f] += magnitude * value;
                moved += value * at.v[f];
            }
            self.work += 0.5 * (*before + magnitude) * moved * at.dt;
            *before = magnitude;
        }
        Ok(Advance::default())
    }

    fn stored(&self) -> f64 {
        -self.work
    }
}
