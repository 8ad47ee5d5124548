//! The secondary sides of a contact pair, one or both, and how kinematic contact goes over them.

use super::kinematic::Correction;
use super::pair::ContactPair;
use super::{Normal, Unsettled};
use fe_core::explicit::{Advance, ExplicitTerm, Halt, Moving, Predicted};

/// Sweeps over all points at most.
const SWEEPS: usize = 200;

/// How often the sides of hard balanced contact answer for each other: the first time by a weighted mean, and once more for
/// what that leaves (Abaqus Analysis User's Manual, Contact constraint enforcement methods in Explicit).
const PASSES: usize = 2;

/// A contact pair by its secondary sides: one of its surfaces, or both, each on the other one and each for its part.
#[derive(Debug)]
pub struct PairSides {
    /// The sides at work.
    pub pairs: Vec<ContactPair>,
}

impl ExplicitTerm for PairSides {
    fn name(&self) -> &str {
        self.pairs.first().map_or("contact", |pair| pair.label())
    }

    fn weigh(&mut self, mass: &[f64]) {
        self.pairs.iter_mut().for_each(|pair| pair.weigh(mass));
    }

    fn correct(&mut self, at: &mut Predicted) {
        correct(&mut self.pairs, at);
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        let mut sides = self.pairs.iter_mut();
        sides.try_fold(Advance::default(), |all, pair| Ok(all.and(pair.advance(at, forces)?)))
    }

    fn stored(&self) -> f64 {
        self.pairs.iter().map(|pair| pair.stored()).sum()
    }
}

/// Corrects the end of an increment by impulses of kinematic sides.
pub(super) fn correct(sides: &mut [ContactPair], at: &mut Predicted) {
    let parts: Vec<f64> = sides.iter().filter_map(|side| side.part()).collect();
    if parts.len() < sides.len() {
        return;
    }
    let mut corrections: Vec<Correction> = sides.iter_mut().map(|side| side.predict(at)).collect();
    let is_hard = matches!(sides.first().map(|side| &side.definition.behaviour.normal), Some(Normal::Hard));
    if sides.len() > 1 && is_hard {
        balance(sides, &parts, &mut corrections, at);
    } else {
        // Laws act on both sides, each on its part of the area.
        solve(sides, &mut corrections, 1.0, at);
    }
    sides.iter_mut().zip(corrections).for_each(|(side, correction)| side.settle(correction, at));
}

/// Goes over all points in turn until nothing changes.
fn solve(sides: &mut [ContactPair], corrections: &mut [Correction], widened: f64, at: &mut Predicted) {
    let settled = corrections.iter().map(|correction| correction.settled).fold(0.0, f64::max);
    let mut change = 0.0;
    for _ in 0..SWEEPS {
        let each = sides.iter().zip(corrections.iter_mut()).map(|(side, own)| side.sweep(own, widened, at));
        change = each.fold(0.0, f64::max);
        if change <= settled {
            return;
        }
    }
    let Unsettled { increments, change: most } = &mut sides[0].unsettled;
    (*increments, *most) = (*increments + 1, most.max(change));
}

/// Each side alone finds impulses that leave its nodes without overclosure, beside those that the other one has; of what is new
/// it takes its part. Momentum stays, and bodies of like meshes are corrected at once.
fn balance(sides: &mut [ContactPair], parts: &[f64], corrections: &mut [Correction], at: &mut Predicted) {
    for pass in 0..PASSES {
        let mut next: Vec<Vec<f64>> = Vec::with_capacity(sides.len());
        for (i, part) in parts.iter().enumerate() {
            let own = std::slice::from_mut(&mut corrections[i]);
            let before = own[0].impulses();
            // At first the side bears all, on all of the area.
            let widened = if pass == 0 { 1.0 / part } else { 1.0 };
            solve(std::slice::from_mut(&mut sides[i]), own, widened, at);
            let wanted = own[0].impulses();
            own[0].change(&before, at);
            next.push(before.iter().zip(wanted).map(|(before, wanted)| before + part * (wanted - before)).collect());
        }
        corrections.iter_mut().zip(&next).for_each(|(own, impulses)| own.change(impulses, at));
    }
}
