//! Central differences: velocities stand in the middle of the increments.
//!
//! v(n+½) = v(n−½) + a(n) (Δt(n−1) + Δt(n))/2, u(n+1) = u(n) + v(n+½) Δt(n), a = M⁻¹ f. With a constant increment
//! ½ v(n−½) M v(n+½) plus what the forces have taken, by the trapezoidal rule, is constant to rounding.

use super::{Advance, ExplicitTerm, Halt, Moving, Predicted};
use crate::load::Prescribed;
use crate::ramp::Ramp;

/// A prescribed freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct Support {
    /// The freedom.
    pub freedom: usize,
    /// What is prescribed of it.
    pub kind: Prescribed,
    /// Its course over the step.
    pub course: Ramp,
}

/// The state of a motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Displacement since the start, over all freedoms [L or rad].
    pub u: Vec<f64>,
    /// Velocity in the middle of the last increment [L/T or 1/T]; before the first one that of the start.
    pub v: Vec<f64>,
    /// Length of the last increment [T]; 0 before the first one.
    pub dt: f64,
    /// Forces of all terms at `u` [F].
    pub force: Vec<f64>,
    /// Time since the start of the step [T].
    pub step_time: f64,
    /// Time since the start of the job [T].
    pub total_time: f64,
    /// Work of supports so far [F L].
    pub work: f64,
}

impl State {
    /// So many freedoms at rest.
    pub fn rest(freedoms: usize) -> Self {
        let zero = || vec![0.0; freedoms];
        State { u: zero(), v: zero(), force: zero(), ..State::default() }
    }
}

/// What acts in a step: elements first, then loads and contact.
pub type Terms<'t> = [&'t mut dyn ExplicitTerm];

/// One step by central differences.
#[derive(Debug)]
pub struct CentralDifference {
    /// Mass or moment of inertia of each freedom; 0 where nothing moves.
    mass: Vec<f64>,
    supports: Vec<Support>,
    is_prescribed: Vec<bool>,
    period: f64,
    advance: Advance,
}

impl CentralDifference {
    /// Begins a step of so long a `period` [T] with increments of at most `most` [T]; `state` is the one it starts with, whose
    /// forces are found.
    ///
    /// # Errors
    /// What the terms say of the start.
    pub fn new(
        terms: &mut Terms,
        supports: Vec<Support>,
        (period, most): (f64, f64),
        state: &mut State,
    ) -> Result<Self, Halt> {
        let mut mass = vec![0.0; state.u.len()];
        terms.iter().for_each(|term| term.add_mass(&mut mass));
        terms.iter_mut().for_each(|term| term.weigh(&mass));
        let mut is_prescribed = vec![false; mass.len()];
        supports.iter().for_each(|support| is_prescribed[support.freedom] = true);
        if let Some(freedom) = (0..mass.len()).find(|&f| mass[f] <= 0.0 && !is_prescribed[f]) {
            return Err(Halt::Massless { freedom });
        }
        state.step_time = 0.0;
        let at =
            Moving { u: &state.u, v: &state.v, step_time: 0.0, total_time: state.total_time, dt: 0.0, stable: most };
        let advance = act(terms, &at, &mut state.force)?;
        Ok(CentralDifference { mass, supports, is_prescribed, period, advance })
    }

    /// What the terms say of the largest stable increment at present.
    pub fn stable(&self) -> Advance {
        self.advance
    }

    /// One increment of length `dt` [T].
    ///
    /// # Errors
    /// Where an element is lost or the motion has no end.
    pub fn advance(&mut self, terms: &mut Terms, state: &mut State, dt: f64) -> Result<(), Halt> {
        let mean = 0.5 * (state.dt + dt);
        let free = state.v.iter_mut().zip(&state.force).zip(&self.mass).zip(&self.is_prescribed);
        for (((v, f), m), prescribed) in free {
            if !prescribed {
                *v += f / m * mean;
            }
        }
        let (step_time, total_time) = (state.step_time + dt, state.total_time + dt);
        let mut before = Vec::with_capacity(self.supports.len());
        for support in &self.supports {
            let f = support.freedom;
            before.push((state.force[f], state.v[f]));
            let course = |back: f64| support.course.at(step_time - back, total_time - back, self.period);
            state.v[f] = match support.kind {
                Prescribed::Displacement => (course(0.0) - state.u[f]) / dt,
                Prescribed::Velocity => course(0.5 * dt),
                Prescribed::Acceleration => state.v[f] + course(dt) * mean,
            };
        }
        state.u.iter_mut().zip(&state.v).for_each(|(u, v)| *u += v * dt);
        let mut predicted = Predicted {
            u: &mut state.u,
            v: &mut state.v,
            force: &state.force,
            mass: &self.mass,
            is_prescribed: &self.is_prescribed,
            dt,
            mean,
        };
        terms.iter_mut().for_each(|term| term.correct(&mut predicted));
        (state.step_time, state.total_time, state.dt) = (step_time, total_time, dt);
        let at = Moving { u: &state.u, v: &state.v, step_time, total_time, dt, stable: dt };
        self.advance = act(terms, &at, &mut state.force)?;
        for (&Support { freedom, .. }, (force, old)) in self.supports.iter().zip(before) {
            // What it gave in kinetic energy, and what it held the other forces with.
            let v = state.v[freedom];
            state.work += 0.5 * (self.mass[freedom] * (v * v - old * old) - (force + state.force[freedom]) * v * dt);
        }
        Ok(())
    }

    /// Kinetic energy [F L] at the end of the last increment, ½ v M v.
    pub fn kinetic(&self, state: &State) -> f64 {
        self.velocity(state).iter().zip(&self.mass).map(|(v, m)| 0.5 * m * v * v).sum()
    }

    /// What stands for it in the balance [F L]: ½ v(n−½) M v(n+½), which increments of the same length conserve. It is less by
    /// ⅛ Δt² a M a, and may be below 0.
    pub fn conserved(&self, state: &State) -> f64 {
        let each = |f: usize| {
            let next = if self.is_prescribed[f] { 0.0 } else { state.force[f] * state.dt };
            0.5 * state.v[f] * (self.mass[f] * state.v[f] + next)
        };
        (0..state.v.len()).map(each).sum()
    }

    /// Velocity [L/T or 1/T] at the end of the last increment.
    pub fn velocity(&self, state: &State) -> Vec<f64> {
        let each = |f: usize| {
            let gained = if self.is_prescribed[f] { 0.0 } else { 0.5 * state.dt * state.force[f] / self.mass[f] };
            state.v[f] + gained
        };
        (0..state.v.len()).map(each).collect()
    }
}

/// Forces of all terms.
fn act(terms: &mut Terms, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
    forces.fill(0.0);
    let mut all = Advance::default();
    for term in terms {
        let stable = at.stable.min(all.increment());
        all = all.and(term.advance(&Moving { stable, ..*at }, forces)?);
    }
    Ok(all)
}

#[cfg(test)]
mod tests;
