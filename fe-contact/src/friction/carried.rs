//! What carries friction: its words, and what carries the pressure, made into a law and its multipliers.

use super::{Coulomb, Friction, Spring, Stick};
use crate::carry::{Carried, Ground};
use crate::enforce::Multipliers;
use crate::slip::Tangential;

impl Carried {
    /// Where points stick exactly, the springs beneath the multipliers are those of the pressure, or a thousand times the
    /// elements beneath. Rough points have multipliers unless a penalty alone carries the pressure.
    pub(crate) fn friction(&self, friction: &Friction, ground: Ground) -> Tangential {
        let stiff = self.multipliers.map(|m| m.slope).or(ground.stiffest());
        let slope = stiff.unwrap_or_else(|| self.law.typical_stiffness());
        let exact = Multipliers { slope, length: ground.length, allowed: self.multipliers.and_then(|m| m.allowed) };
        match friction {
            Friction::Rough => {
                let penalty = self.penalty.filter(|p| p.means.is_bare());
                let spring = Spring::Stiffness(penalty.map_or(slope, |p| p.stiffness));
                let multipliers = penalty.is_none().then_some(exact);
                Tangential { law: Coulomb { limit: None, spring }, change: None, multipliers }
            }
            Friction::Coulomb { coefficient, largest, stick } => {
                let length = if ground.length > 0.0 { ground.length } else { 1.0 };
                let (spring, multipliers) = match stick {
                    Stick::Lagrange => (Spring::Stiffness(slope), Some(exact)),
                    Stick::Slope(slope) => (Spring::Stiffness(*slope), None),
                    Stick::ElasticSlip(slip) => (Spring::Slip(*slip), None),
                    Stick::Tolerance(part) => (Spring::Slip(part * length), None),
                };
                let limit = Some((coefficient.clone(), *largest));
                Tangential { law: Coulomb { limit, spring }, change: None, multipliers }
            }
        }
    }
}
