//! Whether a term is what it claims: its force the derivative of its energy, its stiffness that of its force.

use crate::freedoms::Freedoms;
use crate::matrix::{BlockMatrix, Couplings, Pattern};
use crate::reject::Reject;
use crate::term::{Assembly, Motion, Term};
use std::sync::Arc;

/// How far a term is from consistent, as parts of the largest force and of the largest stiffness entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consistency {
    /// Force against central differences of the energy [-].
    pub force: f64,
    /// Stiffness against central differences of the force [-].
    pub stiffness: f64,
    /// Force and energy with the stiffness asked for against those without [-]: zero unless the two paths differ.
    pub paths: f64,
}

/// Compares a term with its own differences about `u`, each freedom moved by ± `step` [L]. The truncation is of
/// order step², the round-off ε |u| / step.
pub fn term(term: &dyn Term, freedoms: &Freedoms, u: &[f64], step: f64) -> Result<Consistency, Reject> {
    let mut couplings = Couplings::new(freedoms.nodes());
    term.couplings(&mut couplings);
    let mut stiffness = BlockMatrix::zero(Arc::new(Pattern::new(freedoms, &couplings)));
    let (force, energy) = evaluate(term, u, Some(&mut stiffness))?;
    let (plain_force, plain_energy) = evaluate(term, u, None)?;
    let largest_force = force.iter().fold(f64::MIN_POSITIVE, |m, f| m.max(f.abs()));
    let largest_stiffness = stiffness.values.iter().fold(f64::MIN_POSITIVE, |m, k| m.max(k.abs()));
    let mut result = Consistency { force: 0.0, stiffness: 0.0, paths: 0.0 };
    for (a, b) in force.iter().zip(&plain_force) {
        result.paths = result.paths.max((a - b).abs() / largest_force);
    }
    result.paths = result.paths.max((energy - plain_energy).abs() / energy.abs().max(f64::MIN_POSITIVE));
    for freedom in 0..freedoms.len() {
        let mut moved = u.to_vec();
        moved[freedom] = u[freedom] + step;
        let (plus, energy_plus) = evaluate(term, &moved, None)?;
        moved[freedom] = u[freedom] - step;
        let (minus, energy_minus) = evaluate(term, &moved, None)?;
        let slope = (energy_plus - energy_minus) / (2.0 * step);
        result.force = result.force.max((slope - force[freedom]).abs() / largest_force);
        let (mut unit, mut column) = (vec![0.0; u.len()], vec![0.0; u.len()]);
        unit[freedom] = 1.0;
        stiffness.multiply_add(&unit, &mut column);
        for i in 0..u.len() {
            let difference = (plus[i] - minus[i]) / (2.0 * step);
            result.stiffness = result.stiffness.max((difference - column[i]).abs() / largest_stiffness);
        }
    }
    Ok(result)
}

/// Force and energy of a term from a fresh history.
fn evaluate(term: &dyn Term, u: &[f64], stiffness: Option<&mut BlockMatrix>) -> Result<(Vec<f64>, f64), Reject> {
    let old = vec![0.0; term.history()];
    let mut new = old.clone();
    let mut residual = vec![0.0; u.len()];
    let at = Motion { u, du: u, step_time: 1.0, total_time: 1.0, dt: 1.0 };
    let mut out = Assembly { residual: &mut residual, stiffness, energy: 0.0, status_changes: 0 };
    term.evaluate(at, &old, &mut new, &mut out)?;
    let energy = out.energy;
    Ok((residual, energy))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic spring to ground, f = c u³, with a stiffness wrong by the factor `slip`.
    struct Cubic {
        slip: f64,
    }

    impl Term for Cubic {
        fn name(&self) -> &str {
            "cubic spring"
        }

        fn couplings(&self, couplings: &mut Couplings) {
            couplings.add(&[0]);
        }

        fn evaluate(&self, at: Motion, _: &[f64], _: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
            out.energy += 0.25 * at.u[0].powi(4);
            out.residual[0] += at.u[0].powi(3);
            if let Some(k) = out.stiffness.as_deref_mut() {
                k.add_block(0, 0, &[self.slip * 3.0 * at.u[0].powi(2)]);
            }
            Ok(())
        }
    }

    /// Truncation of the differences at u = 1: u h² in the force, h² in 3 of the stiffness; h = 1e-4.
    #[test]
    fn finds_a_wrong_stiffness_and_passes_a_right_one() {
        let freedoms = Freedoms::new(&[1]);
        let right = term(&Cubic { slip: 1.0 }, &freedoms, &[1.0], 1e-4).unwrap();
        assert!(right.force < 2e-8 && right.stiffness < 1e-8 && right.paths == 0.0, "{right:?}");
        let wrong = term(&Cubic { slip: 1.001 }, &freedoms, &[1.0], 1e-4).unwrap();
        assert!((wrong.stiffness - 1e-3 / 1.001).abs() < 1e-7, "{wrong:?}");
    }
}
