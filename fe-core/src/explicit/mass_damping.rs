//! Damping proportional to the mass: a dashpot α m from each node to the ground.

use super::{Advance, ExplicitTerm, Halt, Moving};

/// The dashpots of all freedoms that have one.
#[derive(Clone, Debug)]
pub struct MassDamping {
    /// Freedom, α m [M/T], and force [F] at the end of the last increment.
    dashpots: Vec<(usize, f64, f64)>,
    /// Largest α m over the mass [1/T].
    rate: f64,
    dissipated: f64,
}

impl MassDamping {
    /// From α m [M/T] of all freedoms; `None` where nothing is damped.
    pub fn new(damping: &[f64]) -> Option<Self> {
        let damped = damping.iter().enumerate().filter(|(_, c)| **c > 0.0);
        let dashpots: Vec<(usize, f64, f64)> = damped.map(|(f, &c)| (f, c, 0.0)).collect();
        (!dashpots.is_empty()).then_some(MassDamping { dashpots, rate: 0.0, dissipated: 0.0 })
    }
}

impl ExplicitTerm for MassDamping {
    fn name(&self) -> &str {
        "damping by mass"
    }

    fn weigh(&mut self, mass: &[f64]) {
        let rates = self.dashpots.iter().filter(|dashpot| mass[dashpot.0] > 0.0).map(|&(f, c, _)| c / mass[f]);
        self.rate = rates.fold(0.0, f64::max);
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        for (f, c, before) in &mut self.dashpots {
            let force = *c * at.v[*f];
            forces[*f] -= force;
            // What central differences lose to a force is half of it before and half of it now, times the way.
            self.dissipated += 0.5 * (*before + force) * at.v[*f] * at.dt;
            *before = force;
        }
        Ok(Advance { damping: self.rate, ..Advance::default() })
    }

    fn stored(&self) -> f64 {
        self.dissipated
    }
}
