//! External forces: dead loads over a step.

use crate::ramp::Ramp;

/// Dead loads: sparse force vectors for a magnitude of one, each with its course over the step. They have no
/// stiffness and no history, so they are a vector and not a term; pressures that follow the motion are in [`crate::explicit::loads`].
#[derive(Clone, Debug, Default)]
pub struct ExternalForces {
    /// (freedom, force for magnitude 1) and the magnitude.
    pub parts: Vec<(Vec<(usize, f64)>, Ramp)>,
}

impl ExternalForces {
    /// The forces [F] at a time, over `freedoms` freedoms; `period` is the step's.
    pub fn at(&self, step_time: f64, total_time: f64, period: f64, freedoms: usize) -> Vec<f64> {
        let mut force = vec![0.0; freedoms];
        for (unit, ramp) in &self.parts {
            let magnitude = ramp.at(step_time, total_time, period);
            unit.iter().for_each(|&(f, value)| force[f] += magnitude * value);
        }
        force
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_add_up() {
        let up = Ramp { from: 0.0, to: 2.0, amplitude: None };
        let parts = vec![(vec![(0, 1.0), (2, 3.0)], up), (vec![(2, 1.0)], Ramp::constant(5.0))];
        let external = ExternalForces { parts };
        assert_eq!(external.at(0.5, 9.0, 1.0, 3), [1.0, 0.0, 8.0]);
    }
}
