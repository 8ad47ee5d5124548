//! How a law is enforced: as it stands, or with multipliers.
//!
//! Multipliers λ are found by augmenting a penalty K (Hestenes 1969, Powell 1969): p = ⟨λ + K h⟩ with h = −g, λ ← p
//! after each equilibrium, until the overclosure is small enough. λ is kept as the shift λ/K [L] of the gap, so that the
//! law is asked at g − λ/K. The matrix stays positive definite and unchanged from pass to pass, and constraints that say
//! the same twice share their force. A softened law stands in series with K ([`crate::law::series`]), which the multiplier
//! takes out again: the law may be as steep as it likes. In both cases (p − λ)/K is what the gap is off by.

use crate::contact::Contact;
use crate::law::{NormalLaw, NormalResponse};
use crate::point::ContactStatus;
use fe_core::term::{Equilibrium, Overlap};

/// History of an open point, of a closed one, and of one that slips.
pub(crate) const OPEN: f64 = 0.0;
pub(crate) const CLOSED: f64 = 1.0;
pub(crate) const SLIPPING: f64 = 2.0;

/// When points may pull.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separation {
    /// Never.
    Free,
    /// Once they have closed: `NO SEPARATION`.
    OnceClosed,
    /// From the start on: `TIED`.
    Tied,
}

/// Part of the largest pressure that a multiplier may be wrong by where no overclosure is allowed [-]: what rounding
/// leaves of systems with a condition number up to 1e4.
const EXACT: f64 = 1e-12;

/// Constraints that say nearly the same twice (one beside a node that a support holds) are met ever more slowly, by
/// ever larger multipliers: after so many passes they may be off by [`NEARLY`].
const PATIENCE: usize = 10;

/// Overclosure over the facets' length [-] that is left to such constraints.
const NEARLY: f64 = 1e-6;

/// Multipliers on top of a penalty, or of a law in series with one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Multipliers {
    /// K [F/L³].
    pub slope: f64,
    /// Length [L] of the facets.
    pub length: f64,
    /// Largest overclosure [L] that is left as it is; `None`: as small as rounding lets it be.
    pub allowed: Option<f64>,
}

impl Multipliers {
    /// Largest overclosure [L] that is left where the largest pressure is `largest`.
    pub(crate) fn limit(&self, largest: f64, passes: usize) -> f64 {
        match self.allowed {
            Some(allowed) => allowed,
            None if passes < PATIENCE => EXACT * largest / self.slope,
            None => NEARLY * self.length,
        }
    }
}

/// A law's answer at a point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Answer {
    /// Energy, pressure and stiffness.
    pub response: NormalResponse,
    /// Open or closed.
    pub status: ContactStatus,
    /// It stands at the kink of the law.
    pub touches: bool,
    /// Stiffness [F/L³] of the law itself, without what a touching point is lent.
    pub own_slope: f64,
}

impl Contact {
    /// The law's answer of a point at a gap [L], with the contact's history at hand: that of the increment's start, which
    /// tells whether the point may pull, and the present one.
    pub(crate) fn answer(&self, point: usize, gap: f64, (old, new): (&[f64], &[f64])) -> Answer {
        let (law, shift) = match self.law_of_stuck(point) {
            Some(law) => (law, 0.0),
            None => (&*self.law, self.shift(point, new)),
        };
        let gap = gap + self.allowed(point, new) - shift;
        let mut answer = self.respond(law, gap);
        if answer.status == ContactStatus::Open && self.is_held(point, old) {
            (answer.response, answer.status) = (mirrored(law, gap), ContactStatus::Closed);
        }
        if shift != 0.0 {
            // What the multiplier itself has stored is no energy of the contact.
            answer.response.energy -= self.multipliers.map_or(0.0, |m| 0.5 * m.slope * shift * shift);
        }
        answer
    }

    /// λ/K [L] of a point.
    pub(crate) fn shift(&self, point: usize, history: &[f64]) -> f64 {
        if self.multipliers.is_some() { history[self.points.len() + point] } else { 0.0 }
    }

    /// What rounding leaves of gaps and slips [L].
    pub(crate) fn round_off(&self) -> f64 {
        4.0 * f64::EPSILON / TOUCH * self.touch
    }

    /// True where a point may not open any more: one that was closed at the end of the last increment, or a tied one.
    pub(crate) fn is_held(&self, point: usize, history: &[f64]) -> bool {
        match self.separation {
            Separation::Free => false,
            Separation::OnceClosed => history[point] != OPEN,
            Separation::Tied => true,
        }
    }

    /// Takes pressures and shears as multipliers; the worst of what is not met yet.
    pub(crate) fn take_multipliers(&self, at: Equilibrium, old: &[f64], new: &mut [f64]) -> Option<Overlap> {
        let pressures = self.take_pressures(at, old, new);
        let shears = self.take_shears(at, old, new);
        pressures.into_iter().chain(shears).max_by(|a, b| a.overclosure.abs().total_cmp(&b.overclosure.abs()))
    }

    /// Takes the pressures as multipliers, unless the overclosures are small enough already, or no larger than what is
    /// not balanced explains. Returns the largest one that is not.
    fn take_pressures(&self, at: Equilibrium, old: &[f64], new: &mut [f64]) -> Option<Overlap> {
        let multipliers = self.multipliers?;
        let slope = multipliers.slope;
        let pressures: Vec<f64> = (0..self.points.len())
            .map(|i| self.answer(i, self.opening(i, at.u), (old, new)).response.pressure)
            .collect();
        let is_stuck = |i: usize| self.law_of_stuck(i).is_some();
        let found = |(i, _): &(usize, &f64)| !is_stuck(*i);
        let largest = pressures.iter().enumerate().filter(found).fold(0.0, |m: f64, p| m.max(p.1.abs()));
        let stuck = pressures.iter().enumerate().filter(|(i, _)| is_stuck(*i));
        let excesses = pressures.iter().enumerate().filter(found).map(|(i, pressure)| {
            // How far the gap of a point that presses, or is held, is from where it belongs.
            let excess = if *pressure == 0.0 { 0.0 } else { pressure / slope - self.shift(i, new) };
            (i, if multipliers.allowed.is_some() { excess.max(0.0) } else { excess })
        });
        let worst = self.worst(&multipliers, at, largest, excesses);
        let points = self.points.len();
        // What the law asks of a point that is prescribed may be out of all proportion once a later step lets go of it.
        let mut take =
            |(i, pressure): (usize, &f64)| new[points + i] = if is_stuck(i) { 0.0 } else { pressure / slope };
        match worst {
            Some(_) => pressures.iter().enumerate().for_each(take),
            None => stuck.for_each(&mut take),
        }
        worst
    }

    /// The point that is furthest off, of several that may be off by so much [L] each; none where rounding, or what is not
    /// balanced, explains all. `largest` is the largest pressure or shear.
    pub(crate) fn worst(
        &self,
        multipliers: &Multipliers,
        at: Equilibrium,
        largest: f64,
        off: impl Iterator<Item = (usize, f64)>,
    ) -> Option<Overlap> {
        let limit = multipliers.limit(largest, at.passes).max(self.round_off());
        let mut worst: Option<Overlap> = None;
        for (i, overclosure) in off {
            let point = &self.points[i];
            let limit = limit.max(at.noise / (multipliers.slope * point.measure.value()));
            let off = overclosure.abs();
            if off > limit && worst.is_none_or(|w| off > w.overclosure.abs()) {
                worst = Some(Overlap { node: point.node as usize, overclosure });
            }
        }
        worst
    }
}

/// A gap that near to the kink of the law, of the model's size, touches [-].
pub(crate) const TOUCH: f64 = 1e-12;

/// The law continued beyond its reach as it begins there, into tension.
fn mirrored(law: &dyn NormalLaw, gap: f64) -> NormalResponse {
    let kink = law.reach();
    let answer = law.respond(2.0 * kink - gap);
    NormalResponse { pressure: -answer.pressure, ..answer }
}
