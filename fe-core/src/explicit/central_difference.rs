//! Central differences: velocities stand in the middle of the increments.
//!
//! v(n+½) = v(n−½) + a(n) (Δt(n−1) + Δt(n))/2, u(n+1) = u(n) + v(n+½) Δt(n), a = M⁻¹ f. With a constant increment
//! ½ v(n−½) M v(n+½) plus what the forces have taken, by the trapezoidal rule, is constant to rounding. An increment of another
//! length changes it by ¼ f(n) (v(n+½) − v(n−½)) (Δt(n−1) − Δt(n)), which is ⅛ a M a (Δt(n−1)² − Δt(n)²): much of what the highest
//! modes have. Nodes with rotations in space: [`super::rotation`].

use super::rotation::Triad;
use super::{Advance, ExplicitTerm, Halt, Moving, Predicted};
use crate::freedoms::Freedoms;
use crate::load::Prescribed;
use crate::ramp::Ramp;
use std::time::Instant;

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
    /// Displacement since the start, over all freedoms [L or rad]; rotations in space are a rotation vector.
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
    /// What changes of the increment have given so far [F L]; at constant increments it stays.
    pub fed: f64,
    /// First rotation of each node that has three of them.
    pub rotations: Vec<usize>,
}

impl State {
    /// All at rest.
    pub fn rest(freedoms: &Freedoms) -> Self {
        let zero = || vec![0.0; freedoms.len()];
        State { u: zero(), v: zero(), force: zero(), rotations: freedoms.rotations().collect(), ..State::default() }
    }
}

/// What acts in a step: elements first, then loads and contact.
pub type Terms<'t> = [&'t mut dyn ExplicitTerm];

/// One step by central differences.
#[derive(Debug)]
pub struct CentralDifference {
    /// Mass or moment of inertia of each freedom; 0 where nothing moves; of a tensor the least principal one.
    mass: Vec<f64>,
    triads: Vec<Triad>,
    supports: Vec<Support>,
    is_prescribed: Vec<bool>,
    /// Freedoms that impulses have moved in the last increment.
    corrected: Vec<usize>,
    period: f64,
    advance: Advance,
    /// Seconds that each term has taken.
    seconds: Vec<f64>,
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
        let mut is_prescribed = vec![false; state.u.len()];
        supports.iter().for_each(|support| is_prescribed[support.freedom] = true);
        let (mass, triads) = weigh(terms, state, &is_prescribed)?;
        state.step_time = 0.0;
        let at =
            Moving { u: &state.u, v: &state.v, step_time: 0.0, total_time: state.total_time, dt: 0.0, stable: most };
        let mut seconds = vec![0.0; terms.len()];
        let advance = act(terms, &at, (&mut state.force, &mut seconds))?;
        // The start is no part of an increment.
        seconds.fill(0.0);
        let corrected = Vec::new();
        Ok(CentralDifference { mass, triads, supports, is_prescribed, corrected, period, advance, seconds })
    }

    /// Goes on with other masses of the terms, with which the elements are stable up to another increment [T]. Velocities stay: what
    /// the motion gains by it counts as work of supports.
    ///
    /// # Errors
    /// Where a freedom has lost its mass.
    pub fn weigh(&mut self, terms: &mut Terms, state: &mut State, stable: f64) -> Result<(), Halt> {
        let before = self.conserved(state);
        let turned: Vec<_> = self.triads.iter().map(|triad| triad.counted()).collect();
        (self.mass, self.triads) = weigh(terms, state, &self.is_prescribed)?;
        self.triads.iter_mut().zip(turned).for_each(|(triad, turned)| triad.count(turned));
        state.work += self.conserved(state) - before;
        self.advance.stable = stable;
        Ok(())
    }

    /// Masses of all freedoms [M or M L²].
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// What the terms say of the largest stable increment at present.
    pub fn stable(&self) -> Advance {
        self.advance
    }

    /// Seconds by the clock that each term, in their order, has taken in the increments of the step so far.
    pub fn seconds(&self) -> &[f64] {
        &self.seconds
    }

    /// One increment of length `dt` [T], of the terms that the step began with.
    ///
    /// # Errors
    /// Where an element is lost or the motion has no end.
    pub fn advance(&mut self, terms: &mut Terms, state: &mut State, dt: f64) -> Result<(), Halt> {
        assert_eq!(terms.len(), self.seconds.len(), "other terms than the step began with");
        let (mean, shorter) = (0.5 * (state.dt + dt), state.dt - dt);
        let power = if shorter == 0.0 { 0.0 } else { self.power(state) };
        self.triads.iter_mut().for_each(|triad| triad.begin(&state.v, state.dt));
        let free = state.v.iter_mut().zip(&state.force).zip(&self.mass).zip(&self.is_prescribed);
        for (((v, f), m), prescribed) in free {
            if !prescribed {
                *v += f / m * mean;
            }
        }
        let before = self.prescribe(state, (dt, mean));
        for triad in &mut self.triads {
            triad.accelerate(state, (dt, mean), &self.is_prescribed)?;
        }
        state.u.iter_mut().zip(&state.v).for_each(|(u, v)| *u += v * dt);
        self.corrected.clear();
        let mut predicted = Predicted {
            u: &mut state.u,
            v: &mut state.v,
            force: &state.force,
            mass: &self.mass,
            is_prescribed: &self.is_prescribed,
            dt,
            mean,
            triads: &self.triads,
            corrected: &mut self.corrected,
        };
        let mut clock = Instant::now();
        for (term, seconds) in terms.iter_mut().zip(&mut self.seconds) {
            term.correct(&mut predicted);
            lap(&mut clock, seconds);
        }
        for triad in &mut self.triads {
            triad.turn(state, dt, &self.is_prescribed)?;
        }
        if shorter != 0.0 {
            state.fed += 0.25 * shorter * (self.power(state) - power);
        }
        (state.step_time, state.total_time, state.dt) = (state.step_time + dt, state.total_time + dt, dt);
        let (step_time, total_time) = (state.step_time, state.total_time);
        let at = Moving { u: &state.u, v: &state.v, step_time, total_time, dt, stable: dt };
        self.advance = act(terms, &at, (&mut state.force, &mut self.seconds))?;
        for (&Support { freedom, .. }, (force, old)) in self.supports.iter().zip(before) {
            // What it gave in kinetic energy, and what it held the other forces with.
            let v = state.v[freedom];
            let gained = match self.triad_of(freedom) {
                Some((triad, component)) if triad.has_tensor() => triad.gained(component).into_iter().product(),
                _ => self.mass[freedom] * (v * v - old * old),
            };
            state.work += 0.5 * (gained - (force + state.force[freedom]) * v * dt);
        }
        Ok(())
    }

    /// What the forces of the last end give to free freedoms at the velocities there are [F L/T].
    fn power(&self, state: &State) -> f64 {
        let free = state.force.iter().zip(&state.v).zip(&self.is_prescribed).filter(|(_, prescribed)| !**prescribed);
        free.map(|((f, v), _)| f * v).sum()
    }

    /// Sets the velocities of supports; what they had as force and velocity before.
    fn prescribe(&self, state: &mut State, (dt, mean): (f64, f64)) -> Vec<(f64, f64)> {
        let (step_time, total_time) = (state.step_time + dt, state.total_time + dt);
        let mut before = Vec::with_capacity(self.supports.len());
        for support in &self.supports {
            let f = support.freedom;
            before.push((state.force[f], state.v[f]));
            let course = |back: f64| support.course.at(step_time - back, total_time - back, self.period);
            let from = self.triad_of(f).map_or(state.u[f], |(triad, component)| triad.turned(component));
            state.v[f] = match support.kind {
                Prescribed::Displacement => (course(0.0) - from) / dt,
                Prescribed::Velocity => course(0.5 * dt),
                Prescribed::Acceleration => state.v[f] + course(dt) * mean,
            };
        }
        before
    }

    /// The node in space that a freedom turns, and about which axis.
    fn triad_of(&self, freedom: usize) -> Option<(&Triad, usize)> {
        let place = self.triads.partition_point(|triad| triad.first + 2 < freedom);
        let triad = self.triads.get(place).filter(|triad| triad.first <= freedom)?;
        Some((triad, freedom - triad.first))
    }

    fn tensors(&self) -> impl Iterator<Item = &Triad> {
        self.triads.iter().filter(|triad| triad.has_tensor())
    }

    /// Kinetic energy [F L] at the end of the last increment, ½ v M v.
    pub fn kinetic(&self, state: &State) -> f64 {
        let velocity = self.velocity(state);
        let turning = |triad: &Triad| {
            let [omega, momentum] = triad.at_end(state, &self.is_prescribed);
            let own = triad.first..triad.first + 3;
            0.5 * omega.dot(&momentum) - own.map(|f| 0.5 * self.mass[f] * velocity[f] * velocity[f]).sum::<f64>()
        };
        let straight: f64 = velocity.iter().zip(&self.mass).map(|(v, m)| 0.5 * m * v * v).sum();
        straight + self.tensors().map(turning).sum::<f64>()
    }

    /// What stands for it in the balance [F L]: ½ v(n−½) M v(n+½), less what changes of the increment have given to it. It may be
    /// below 0.
    pub fn conserved(&self, state: &State) -> f64 {
        let next = |f: usize| if self.is_prescribed[f] { 0.0 } else { state.force[f] * state.dt };
        let each = |f: usize| 0.5 * state.v[f] * (self.mass[f] * state.v[f] + next(f));
        let turning = |triad: &Triad| {
            let [_, momentum] = triad.middle(state);
            let own = triad.first..triad.first + 3;
            own.map(|f| 0.5 * state.v[f] * (momentum[f - triad.first] - self.mass[f] * state.v[f])).sum::<f64>()
        };
        (0..state.v.len()).map(each).sum::<f64>() + self.tensors().map(turning).sum::<f64>() - state.fed
    }

    /// Velocity [L/T or 1/T] at the end of the last increment. Forces do not act alone on what impulses have moved: the next ones
    /// answer them, and what lies on a wall is at rest. There the velocity in the middle stands, ½ a Δt off.
    pub fn velocity(&self, state: &State) -> Vec<f64> {
        let each = |f: usize| {
            let gained = if self.is_prescribed[f] { 0.0 } else { 0.5 * state.dt * state.force[f] / self.mass[f] };
            state.v[f] + gained
        };
        let mut velocity: Vec<f64> = (0..state.v.len()).map(each).collect();
        self.corrected.iter().for_each(|&f| velocity[f] = state.v[f]);
        for triad in self.tensors() {
            let [omega, _] = triad.at_end(state, &self.is_prescribed);
            velocity[triad.first..triad.first + 3].copy_from_slice(omega.as_slice());
        }
        velocity
    }
}

/// Masses of all freedoms, and the nodes that turn in space; the terms are told.
fn weigh(terms: &mut Terms, state: &State, is_prescribed: &[bool]) -> Result<(Vec<f64>, Vec<Triad>), Halt> {
    let mut mass = vec![0.0; state.u.len()];
    terms.iter().for_each(|term| term.add_mass(&mut mass));
    let rotary: Vec<_> = terms.iter().flat_map(|term| term.rotary().iter().copied()).collect();
    let mut triads = Vec::with_capacity(state.rotations.len());
    for &first in &state.rotations {
        let tensors = rotary.iter().filter(|tensor| tensor.0 == first).map(|tensor| tensor.1);
        let mut triad = Triad::new(first, &state.u, tensors);
        triad.weigh(&mut mass, is_prescribed)?;
        triads.push(triad);
    }
    terms.iter_mut().for_each(|term| term.weigh(&mass));
    match (0..mass.len()).find(|&f| mass[f] <= 0.0 && !is_prescribed[f]) {
        Some(freedom) => Err(Halt::Massless { freedom }),
        None => Ok((mass, triads)),
    }
}

/// Forces of all terms; their seconds are added.
fn act(terms: &mut Terms, at: &Moving, (forces, seconds): (&mut [f64], &mut [f64])) -> Result<Advance, Halt> {
    forces.fill(0.0);
    let mut all = Advance::default();
    let mut clock = Instant::now();
    for (term, seconds) in terms.iter_mut().zip(seconds) {
        let stable = at.stable.min(all.increment());
        all = all.and(term.advance(&Moving { stable, ..*at }, forces)?);
        lap(&mut clock, seconds);
    }
    match unbounded(forces) {
        Some(freedom) => Err(Halt::Unbounded { freedom }),
        None => Ok(all),
    }
}

/// Adds the seconds that have gone since the clock began, and begins it anew.
fn lap(clock: &mut Instant, seconds: &mut f64) {
    let now = Instant::now();
    *seconds += now.duration_since(*clock).as_secs_f64();
    *clock = now;
}

/// The first force that is infinite or no number; by blocks, so that it takes no time beside the forces themselves.
fn unbounded(forces: &[f64]) -> Option<usize> {
    let is_bad = |block: &[f64]| block.iter().fold(false, |bad, f| bad | !f.is_finite());
    let block = forces.chunks(64).position(is_bad)?;
    let within = forces[64 * block..].iter().position(|f| !f.is_finite())?;
    Some(64 * block + within)
}

#[cfg(test)]
mod tests;
