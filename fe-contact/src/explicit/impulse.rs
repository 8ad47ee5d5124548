//! The impulse of a point by a law, with damping, at the corrected end of an increment.

use super::behaviour::{Behaviour, pressed};
use crate::law::NormalLaw;

/// A point without an impulse of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unpressed {
    /// Gap [L] at the end of the increment.
    pub gap: f64,
    /// Rate [L/T] at which it grows.
    pub rate: f64,
    /// What an impulse adds to the rate [1/M].
    pub compliance: f64,
    /// Area, length or 1.
    pub measure: f64,
    /// Length of the increment, and time over which forces change the velocity [T].
    pub dt: f64,
    pub mean: f64,
    /// It pulls, too.
    pub bonded: bool,
}

impl Unpressed {
    /// λ = (p(g + c λ Δt) A − μ (v + c λ)) Δt: law and damping at the corrected end, by Newton's method between bounds. Nothing
    /// acts where the corrected gap is open, and damping never pulls.
    pub fn impulse(&self, behaviour: &Behaviour, law: &dyn NormalLaw) -> f64 {
        let first = self.answer(0.0, behaviour, law).0;
        // Forces fall as the gap grows: the impulse lies between none and that of the predicted gap.
        let (mut low, mut high) = (first.min(0.0), first.max(0.0));
        let mut impulse = first;
        for _ in 0..100 {
            let (force, slope) = self.answer(impulse, behaviour, law);
            let left = impulse - force;
            if left > 0.0 {
                high = impulse
            } else {
                low = impulse
            }
            let next = impulse - left / (1.0 + slope);
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if (next - impulse).abs() <= 1e-15 * first.abs() || left == 0.0 {
                break;
            }
            impulse = next;
        }
        impulse
    }

    /// Impulse [F T] of the forces at the end of an increment with an impulse, and how much it falls with it [-].
    fn answer(&self, impulse: f64, behaviour: &Behaviour, law: &dyn NormalLaw) -> (f64, f64) {
        let growth = self.compliance * self.dt;
        let (pressure, slope) = pressed(law, self.gap + growth * impulse, self.bonded);
        if pressure <= 0.0 && !self.bonded {
            return (0.0, 0.0);
        }
        let (stiffness, mass) = (slope * self.measure, if self.compliance > 0.0 { 1.0 / self.compliance } else { 0.0 });
        let damping = behaviour.viscosity(self.measure, mass, stiffness);
        let force = pressure * self.measure - damping * (self.rate + self.compliance * impulse);
        if force <= 0.0 && !self.bonded {
            return (0.0, 0.0);
        }
        (force * self.mean, (stiffness * growth + damping * self.compliance) * self.mean)
    }
}
