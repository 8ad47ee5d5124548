//! What a step says of one contact, besides its law.

use crate::carry::Carried;
use crate::contact::Contact;
use crate::friction::change::Change;
use crate::interference::{Allowance, Interference};
use crate::law::NormalLaw;
use crate::viscous::Stabilization;
use fe_core::ramp::Ramp;
use std::collections::BTreeMap;

/// What a step says of one contact; by default nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conditions {
    /// Whether it acts at all.
    pub activity: Activity,
    /// Overclosure that is let be.
    pub interference: Option<Interference>,
    /// How hard contact is enforced otherwise.
    pub overrides: Overrides,
    /// What becomes of its friction; `None`: it stays as it is.
    pub friction: Option<Change>,
    /// What resists its motion.
    pub stabilization: Option<Stabilization>,
}

/// What `*CONTACT CONTROLS` change of the enforcement of hard contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overrides {
    /// Factor on the penalty stiffness [-].
    pub stiffness_scale: f64,
    /// Overclosure that augmentation leaves; `None`: the usual one.
    pub tolerance: Option<Tolerance>,
    /// Whether multipliers carry it.
    pub multipliers: MultiplierUse,
}

/// `LAGRANGE MULTIPLIER=`: whether multipliers carry a contact. They are a way to solve, and no answer of a softened law or of
/// a penalty changes by them; hard contact for which the deck asks nothing is one or the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MultiplierUse {
    /// Beneath what is steeper than a thousand times the elements, and for hard contact where that is usual.
    #[default]
    Usual,
    /// Always: hard contact without overclosure, a softened law or a penalty exactly, whatever its slope.
    Always,
    /// Never, but for DIRECT and AUGMENTED LAGRANGE, which are made of them: the law or the penalty stands as it is.
    Never,
}

impl Default for Overrides {
    fn default() -> Self {
        Overrides { stiffness_scale: 1.0, tolerance: None, multipliers: MultiplierUse::Usual }
    }
}

/// Overclosure that augmentation leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// So much [L].
    Absolute(f64),
    /// So much of the facets' length [-].
    Relative(f64),
}

/// `*MODEL CHANGE` of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Activity {
    /// It acts.
    #[default]
    Acting,
    /// Its surfaces know nothing of each other.
    Removed,
}

impl Contact {
    /// Enters a step of which the conditions hold, at a displacement; `time` is the total one [T] at its start, and its
    /// period [T]. `history` is the contact's, and becomes what the step starts with.
    pub fn enter(&mut self, conditions: &Conditions, time: (f64, f64), u: &[f64], history: &mut Vec<f64>) {
        let taken = self.taken(history);
        self.change_friction(conditions.friction.as_ref(), time, u, history);
        self.activity = conditions.activity;
        history.truncate(self.numbers());
        self.carry(conditions.overrides, history);
        if !self.acts() {
            // What comes back later has never been closed.
            history.fill(0.0);
        }
        let interference = conditions.interference.as_ref();
        self.allowance = interference.map(|interference| Allowance::new(self, interference, time));
        history.extend(self.allowance.as_ref().map(|allowance| allowance.first));
        self.resist_in_step(conditions.stabilization.as_ref(), time.1, taken, history);
    }

    /// Enforces contact otherwise from now on. Multipliers keep their pressures.
    fn carry(&mut self, overrides: Overrides, history: &mut Vec<f64>) {
        let (normal, ground, before) = &self.origin;
        if *before == overrides {
            return;
        }
        // The same stiffness beneath was enough before.
        let Ok(Carried { law, bare, penalty, multipliers }) = Carried::new(normal, *ground, overrides) else { return };
        let shifts = self.points.len()..2 * self.points.len();
        if let (Some(old), Some(new)) = (self.multipliers, multipliers) {
            history[shifts.clone()].iter_mut().for_each(|shift| *shift *= old.slope / new.slope);
        }
        // What acts along the surface stands behind the shifts, and stays as it is.
        match (self.multipliers, multipliers) {
            (Some(_), None) => drop(history.drain(shifts)),
            (None, Some(_)) => drop(history.splice(self.points.len()..self.points.len(), shifts.map(|_| 0.0))),
            _ => {}
        }
        (self.law, self.bare) = (law, bare);
        (self.multipliers, self.summary.penalty) = (multipliers, penalty);
        self.origin.2 = overrides;
    }

    /// Is told the freedoms that the step prescribes, and their courses. What their motion makes of a gap leaves a multiplier
    /// nothing to find: points that nothing else moves are asked the law itself, where one in series with a spring is asked
    /// otherwise.
    pub fn hold(&mut self, supports: &BTreeMap<usize, Ramp>) {
        self.mirrored = self.mirrored(supports);
        let stuck = |i: usize| !self.points[i].moves_with(&self.places[i], |f| !supports.contains_key(&f));
        self.stuck = if self.bare.is_some() { (0..self.points.len()).map(stuck).collect() } else { Vec::new() };
    }

    /// The law that a point is asked that is stuck.
    pub(crate) fn law_of_stuck(&self, point: usize) -> Option<&dyn NormalLaw> {
        let is_stuck = self.stuck.get(point).copied().unwrap_or(false);
        self.bare.as_deref().filter(|_| is_stuck)
    }

    /// How many points nothing but prescribed freedoms moves, where that makes a difference.
    pub fn stuck_points(&self) -> usize {
        self.stuck.iter().filter(|stuck| **stuck).count()
    }

    /// True where something resists motions along its surface, too.
    pub fn holds_along(&self) -> bool {
        self.resistances().any(|r| r.coefficients[1] > 0.0)
    }

    /// Damping coefficients [F T/L³] of the step across and along the surface, and the clearance [L] up to which they act;
    /// `None` where nothing is stabilised.
    pub fn stabilization(&self) -> Option<([f64; 2], f64)> {
        self.viscous.stabilization.as_ref().map(|r| (r.coefficients, r.fall[1]))
    }

    /// False where the step has removed it.
    pub fn acts(&self) -> bool {
        self.activity == Activity::Acting
    }
}
