//! What resists the motion of the surfaces against each other in proportion to the velocity: damping, which belongs to an
//! interaction, and stabilisation, which a step adds.

use crate::contact::Contact;
use crate::point::dot;
use crate::term::{Blocks, add};
use fe_core::{Assembly, Motion};

/// `*CONTACT CONTROLS, STABILIZE` of one step: pressure and shear against the velocities of points that are closed or not
/// far open. Abaqus Analysis User's Manual, Adjusting contact controls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stabilization {
    /// How large the coefficient is.
    pub coefficient: Coefficient,
    /// Coefficient along the surface over that across it [-].
    pub tangent_fraction: f64,
    /// Factor at the end of the step [-], reached straight from 1 at its start.
    pub end: f64,
    /// Clearance [L] from which on nothing acts, falling from half of it on; `None`: the facets' length.
    pub range: Option<f64>,
}

/// `*CONTACT DAMPING` of an interaction: p = μ(c) v against the speed v at which a clearance c closes. It acts on open points,
/// too. Abaqus Analysis User's Manual, Contact damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping {
    /// μ₀ [F T/L³], by the unit rule [F T/L²] or [F T/L].
    pub coefficient: f64,
    /// Clearance c₀ [L] from which on nothing acts.
    pub clearance: f64,
    /// η [-]: μ₀ acts in full up to η c₀, and falls straight from there to c₀.
    pub constant_part: f64,
    /// Coefficient along the surface over that across it [-].
    pub tangent_fraction: f64,
}

/// `*CONTACT DAMPING` of an interaction in explicit steps: it acts on closed points alone, and along the surface on what
/// sticks. Abaqus Analysis User's Manual, Contact damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExplicitDamping {
    /// Across the surface.
    pub amount: DampingAmount,
    /// Damping along the surface over that across it [-].
    pub tangent_fraction: f64,
}

/// How large a damping force of explicit steps is, at a relative velocity v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DampingAmount {
    /// μ₀ A v: μ₀ [F T/L³], by the unit rule [F T/L²] or [F T/L].
    Coefficient(f64),
    /// ξ √(4 m k) v: ξ [-], m the mass of the node, k the stiffness [F/L] of contact there.
    CriticalFraction(f64),
}

impl Default for ExplicitDamping {
    /// ξ = 0.03, along the surface too: what Abaqus has for contact by penalty and for softened laws.
    fn default() -> Self {
        ExplicitDamping { amount: DampingAmount::CriticalFraction(0.03), tangent_fraction: 1.0 }
    }
}

/// A damping coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coefficient {
    /// So much [F T/L³].
    Given(f64),
    /// A multiple [-] of [`AUTOMATIC`] times the stiffness of the elements beneath times the step's period.
    Automatic(f64),
}

/// The automatic coefficient over k_e T [-]: at a constant velocity over the step the resistance is that part of what the
/// elements would do against the same displacement.
pub const AUTOMATIC: f64 = 1e-3;

/// What resists in one contact.
#[derive(Clone, Debug, Default)]
pub(crate) struct Viscous {
    /// What the interaction says.
    pub given: Option<Damping>,
    /// It, in the present step.
    pub damping: Option<Resistance>,
    /// What stabilises the contact in the present step.
    pub stabilization: Option<Resistance>,
    /// Energies of the steps before.
    pub before: Taken,
}

/// Energies [F L] that were taken from the motion of the surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Taken {
    /// By damping.
    pub damping: f64,
    /// By stabilisation: ALLSD.
    pub stabilization: f64,
}

/// A resistance at the points of a contact.
#[derive(Clone, Debug)]
pub(crate) struct Resistance {
    /// Coefficients [F T/L³] across and along the surface.
    pub coefficients: [f64; 2],
    /// Clearances [L] between which they fall to 0.
    pub fall: [f64; 2],
    /// Factor at the end of the step, and its period [T].
    pub course: (f64, f64),
    /// Where the energy it takes stands in the history, before the pressures of the points if they are kept.
    place: usize,
    /// Whether the pressures are kept, as part of CPRESS.
    keeps_pressures: bool,
}

impl Resistance {
    /// Damping in a step of so long a `period` [T]; `place` is its own in the history.
    pub fn damping(damping: &Damping, period: f64, place: usize) -> Self {
        let coefficients = [damping.coefficient, damping.tangent_fraction * damping.coefficient];
        let fall = [damping.constant_part * damping.clearance, damping.clearance];
        Resistance { coefficients, fall, course: (1.0, period), place, keeps_pressures: true }
    }

    /// Stabilisation in a step of so long a `period` [T]; `place` is its own in the history.
    pub fn stabilization(contact: &Contact, stabilization: &Stabilization, period: f64, place: usize) -> Self {
        let coefficient = match stabilization.coefficient {
            Coefficient::Given(coefficient) => coefficient,
            Coefficient::Automatic(factor) => {
                let beneath = contact.summary.beneath.unwrap_or_else(|| contact.law.typical_stiffness());
                factor * AUTOMATIC * beneath * period
            }
        };
        let range = stabilization.range.or(Some(contact.length)).filter(|l| *l > 0.0).unwrap_or(f64::INFINITY);
        let coefficients = [coefficient, stabilization.tangent_fraction * coefficient];
        let (fall, course) = ([0.5 * range, range], (stabilization.end, period));
        Resistance { coefficients, fall, course, place, keeps_pressures: false }
    }

    /// Numbers of history.
    pub fn numbers(&self, points: usize) -> usize {
        if self.keeps_pressures { 1 + points } else { 1 }
    }

    /// Factor [-] at a clearance [L] and its slope [1/L], of an increment: the mean over its time, so that the last one has
    /// some, too.
    fn factor(&self, clearance: f64, at: &Motion) -> [f64; 2] {
        let ([from, to], (end, period)) = (self.fall, self.course);
        let near = if clearance <= from {
            [1.0, 0.0]
        } else if clearance < to {
            [(to - clearance) / (to - from), -1.0 / (to - from)]
        } else {
            [0.0; 2]
        };
        near.map(|near| near * (1.0 + (end - 1.0) * ((at.step_time - 0.5 * at.dt) / period)))
    }
}

impl Contact {
    /// What damps the surfaces; `None` where nothing does, or the step has removed the contact.
    pub fn damping(&self) -> Option<&Damping> {
        self.viscous.given.as_ref().filter(|_| self.acts())
    }

    /// Begins a step with its resistances, which keep their numbers at the end of `history`; it ends with what is kept over
    /// steps, and what it had of the step before is in `before`.
    pub(crate) fn resist_in_step(
        &mut self,
        stabilization: Option<&Stabilization>,
        period: f64,
        before: Taken,
        history: &mut Vec<f64>,
    ) {
        self.viscous.before = before;
        let damping = self.damping().map(|d| Resistance::damping(d, period, history.len()));
        let numbers = |resistance: &Option<Resistance>| resistance.as_ref().map_or(0, |r| r.numbers(self.points.len()));
        history.resize(history.len() + numbers(&damping), 0.0);
        let stabilization = stabilization.filter(|_| self.acts());
        let stabilization = stabilization.map(|s| Resistance::stabilization(self, s, period, history.len()));
        history.resize(history.len() + numbers(&stabilization), 0.0);
        (self.viscous.damping, self.viscous.stabilization) = (damping, stabilization);
    }

    /// What resists in the present step.
    pub(crate) fn resistances(&self) -> impl Iterator<Item = &Resistance> {
        self.viscous.damping.iter().chain(&self.viscous.stabilization)
    }

    /// Energies taken so far, by the history of an evaluation.
    pub(crate) fn taken(&self, history: &[f64]) -> Taken {
        let of = |resistance: &Option<Resistance>| resistance.as_ref().map_or(0.0, |r| history[r.place]);
        let Viscous { damping, stabilization, before, .. } = &self.viscous;
        Taken { damping: before.damping + of(damping), stabilization: before.stabilization + of(stabilization) }
    }

    /// Pressure of a point by damping, in the law's unit.
    pub(crate) fn damped(&self, point: usize, history: &[f64]) -> f64 {
        self.viscous.damping.as_ref().map_or(0.0, |r| history[r.place + 1 + point])
    }

    /// Adds all resistances at all points, and keeps the energy that they take in the increment.
    pub(crate) fn resist(
        &self,
        at: &Motion,
        (old, new): (&[f64], &mut [f64]),
        blocks: Option<&Blocks>,
        out: &mut Assembly,
    ) {
        for resistance in self.resistances().filter(|_| at.dt > 0.0) {
            let mut taken = 0.0;
            for i in 0..self.points.len() {
                let (pressure, energy) = self.resist_at(i, (resistance, at), self.allowed(i, new), blocks, out);
                taken += energy;
                if resistance.keeps_pressures {
                    new[resistance.place + 1 + i] = pressure;
                }
            }
            new[resistance.place] = old[resistance.place] + taken;
        }
    }

    /// One point, of which an overclosure is `allowed`: its pressure, and the energy it takes in the increment.
    fn resist_at(
        &self,
        point: usize,
        (resistance, at): (&Resistance, &Motion),
        allowed: f64,
        blocks: Option<&Blocks>,
        out: &mut Assembly,
    ) -> (f64, f64) {
        let (here, places) = (self.at(point, at.u), &self.places[point]);
        let [factor, slope] = resistance.factor(here.gap + allowed, at);
        if factor == 0.0 {
            return (0.0, 0.0);
        }
        let measure = self.points[point].measure.value();
        let [across, along] = resistance.coefficients.map(|c| c * measure / at.dt);
        let opened = dot(&here.row, at.du, places);
        let force = across * factor * opened;
        add(&here.row, force, places, out.residual);
        let slide = if along > 0.0 { self.points[point].slide_at((at.u, at.du), places) } else { None };
        let mut taken = force * opened;
        for row in slide.iter().flat_map(|slide| &slide.rows) {
            let slid = dot(row, at.du, places);
            taken += along * factor * slid * slid;
            add(row, along * factor * slid, places, out.residual);
        }
        if let (Some(blocks), Some(matrix)) = (blocks, out.stiffness.as_deref_mut()) {
            // Opening out of reach the force falls again, and the matrix is to stay positive definite.
            let across = [(across * (factor + slope * opened).max(0.0), &*here.row)];
            let turning = here.bending.iter().map(|(turning, row)| (force * turning, row.as_slice()));
            let rows = slide.iter().flat_map(|slide| &slide.rows).filter(|row| !row.is_empty());
            let along = rows.map(|row| (along * factor, row.as_slice()));
            across
                .into_iter()
                .chain(turning)
                .chain(along)
                .for_each(|part| self.add_stiffness(point, part, blocks, matrix));
        }
        (-force / measure, taken)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// μ₀ = 10, c₀ = 0.1, η = 0.5 at a closing speed of 2.
    #[test]
    fn a27_contact_damping() {
        let (coefficients, fall, course) = ([10.0, 0.0], [0.05, 0.1], (1.0, 1.0));
        let resistance = Resistance { coefficients, fall, course, place: 0, keeps_pressures: true };
        let at = Motion { u: &[], du: &[], step_time: 0.5, total_time: 0.5, dt: 0.25 };
        for (clearance, expected) in [(-0.01, 20.0), (0.025, 20.0), (0.05, 20.0), (0.075, 10.0), (0.12, 0.0)] {
            let [factor, slope] = resistance.factor(clearance, &at);
            assert!((2.0 * 10.0 * factor - expected).abs() < 1e-13, "{clearance}: {factor}");
            assert_eq!(slope, if clearance == 0.075 { -1.0 / (0.1 - 0.05) } else { 0.0 });
        }
    }
}
