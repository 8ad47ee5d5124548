//! `*STATIC`: equilibrium at each time, by Newton's method.

use super::newton::{Iterate, Newton, Verdict};
use super::system::{Evaluation, Scene, System, dot};
use super::{Converged, Convergence, Energy, Procedure, Seconds};
use crate::increment::Attempt;
use crate::linear::{Cost, LinearSolver};
use crate::matrix::BlockMatrix;
use crate::reject::Reject;
use crate::step::Controls;
use crate::term::Motion;
use std::time::Instant;

/// Residuals of a backward stable solver are a modest multiple of ε |K||u| (Higham, Accuracy and Stability of
/// Numerical Algorithms, 2nd ed., theorem 10.4; the multiple grows with the row length in theory, hardly in
/// practice).
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// A line search is made when the step overshoots: the residual along it comes out with the other sign and more
/// than this part of its size at the start.
const OVERSHOOT: f64 = 0.5;

/// Most evaluations of one line search.
const SEARCHES: usize = 6;

/// Static equilibrium over the increments of one step.
pub struct StaticGeneral<'a> {
    system: System<'a>,
    controls: Controls,
    solver: Box<dyn LinearSolver + 'a>,
    /// Values that the factor was made of.
    factored: Vec<f64>,
    factorisations: usize,
    mean_forces: (f64, usize),
    seconds: Seconds,
}

impl<'a> StaticGeneral<'a> {
    /// Assembles what stays the same over the step.
    pub fn new(scene: Scene<'a>, controls: Controls, mut solver: Box<dyn LinearSolver + 'a>) -> Result<Self, Reject> {
        let mut seconds = Seconds::default();
        let start = Instant::now();
        let system = System::new(scene)?;
        seconds.assemble = start.elapsed().as_secs_f64();
        if let Some(linear) = &system.linear {
            let start = Instant::now();
            solver.analyse(&linear.pattern, &system.scene.free());
            seconds.order = start.elapsed().as_secs_f64();
        }
        let (factored, mean_forces) = (Vec::new(), (0.0, 0));
        Ok(StaticGeneral { system, controls, solver, factored, factorisations: 0, mean_forces, seconds })
    }

    /// What one factorisation costs; `None` where there is no matrix.
    pub fn cost(&self) -> Option<Cost> {
        self.system.linear.as_ref().map(|_| self.solver.cost())
    }

    /// Factorisations made so far.
    pub fn factorisations(&self) -> usize {
        self.factorisations
    }

    fn evaluate(&mut self, step: &Increment, u: &[f64], new: &mut [Vec<f64>]) -> Result<Evaluation, Reject> {
        let start = Instant::now();
        let du: Vec<f64> = u.iter().zip(&step.from.u).map(|(a, b)| a - b).collect();
        let at = step.motion(u, &du);
        let evaluation = self.system.evaluate(at, &step.external, (&step.from.history, new), true);
        self.seconds.assemble += start.elapsed().as_secs_f64();
        evaluation
    }

    /// Solves K δ = −r on the free freedoms; the prescribed ones move by `given`.
    fn correction(&mut self, evaluation: &Evaluation, given: &[f64]) -> Result<Vec<f64>, Reject> {
        let mut delta = given.to_vec();
        let Some(tangent) = evaluation.tangent.as_ref().or(self.system.linear.as_ref()) else {
            return Ok(delta);
        };
        let start = Instant::now();
        if self.factored != tangent.values {
            self.factored.clear();
            let freedoms = &self.system.scene.freedoms;
            self.solver.factor(tangent).map_err(|singular| Reject::Singular {
                node: freedoms.node(singular.freedom),
                component: freedoms.component(singular.freedom),
            })?;
            self.factored.extend_from_slice(&tangent.values);
            self.factorisations += 1;
        }
        self.seconds.factor += start.elapsed().as_secs_f64();
        let start = Instant::now();
        let mut right = vec![0.0; delta.len()];
        if given.iter().any(|&g| g != 0.0) {
            tangent.multiply_add(given, &mut right);
        }
        right.iter_mut().zip(&evaluation.residual).for_each(|(b, r)| *b = -*b - r);
        self.solver.solve(&mut right);
        delta.iter_mut().zip(&right).for_each(|(d, x)| *d += x);
        self.seconds.solve += start.elapsed().as_secs_f64();
        Ok(delta)
    }

    /// Goes along `delta`: all of it, unless the residual along it changes sign by too much. The potential of a
    /// convex problem falls along a Newton step, so its slope has one zero; regula falsi finds it. Returns the
    /// part of `delta` taken and the evaluation there.
    fn search(
        &mut self,
        step: &Increment,
        u: &mut [f64],
        delta: &[f64],
        slope: f64,
        new: &mut Vec<Vec<f64>>,
    ) -> Result<(f64, Evaluation), Reject> {
        let start = u.to_vec();
        let (mut low, mut low_slope, mut length) = (0.0, slope, 1.0);
        let (mut high, mut high_slope) = (f64::NAN, f64::NAN);
        let enough = OVERSHOOT * slope.abs();
        for searched in 1.. {
            u.iter_mut().zip(start.iter().zip(delta)).for_each(|(a, (s, d))| *a = s + length * d);
            let mut history = new.clone();
            let now = self.evaluate(step, u, &mut history)?;
            let here = dot(delta, &now.residual);
            let short = here < -enough && !high.is_nan();
            if slope >= 0.0 || (here <= enough && !short) || searched == SEARCHES {
                *new = history;
                return Ok((length, now));
            }
            if short {
                (low, low_slope) = (length, here);
            } else {
                (high, high_slope) = (length, here);
            }
            length = low - low_slope * (high - low) / (high_slope - low_slope);
        }
        unreachable!("the search ends after {SEARCHES} evaluations")
    }

    fn iterate(&self, step: &Increment, u: &[f64], correction: f64, now: &Evaluation) -> Iterate {
        let mut forces = ForceScale::default();
        let mut residual: f64 = 0.0;
        for (f, r) in now.residual.iter().enumerate() {
            let reaction = if step.free[f] { 0.0 } else { r.abs() };
            residual = if step.free[f] { residual.max(r.abs()) } else { residual };
            forces.add(step.external[f].abs().max(now.nonlinear[f].abs()).max(reaction));
        }
        let tangent = now.tangent.as_ref().or(self.system.linear.as_ref());
        let round_off = tangent.map_or(0.0, |k| ROUND_OFF * largest_product(k, u));
        Iterate {
            residual,
            largest_force: forces.largest,
            mean_force: forces.mean(),
            correction,
            increment: u.iter().zip(&step.from.u).fold(0.0, |m, (a, b)| (a - b).abs().max(m)),
            status_changes: now.status_changes,
            round_off,
        }
    }
}

/// The fixed part of one increment.
struct Increment<'s> {
    from: &'s Converged,
    attempt: Attempt,
    external: Vec<f64>,
    free: Vec<bool>,
}

impl Increment<'_> {
    fn motion<'m>(&self, u: &'m [f64], du: &'m [f64]) -> Motion<'m> {
        let total_time = self.total_time();
        Motion { u, du, step_time: self.attempt.step_time, total_time, dt: self.attempt.dt }
    }

    fn total_time(&self) -> f64 {
        self.from.total_time - self.from.step_time + self.attempt.step_time
    }
}

#[derive(Default)]
struct ForceScale {
    largest: f64,
    sum: f64,
    count: usize,
}

impl ForceScale {
    fn add(&mut self, force: f64) {
        if force > 0.0 {
            self.largest = self.largest.max(force);
            self.sum += force;
            self.count += 1;
        }
    }

    fn mean(&self) -> f64 {
        if self.count > 0 { self.sum / self.count as f64 } else { 0.0 }
    }
}

/// maxᵢ Σⱼ |Kᵢⱼ||xⱼ|.
fn largest_product(k: &BlockMatrix, x: &[f64]) -> f64 {
    let absolute = BlockMatrix { pattern: k.pattern.clone(), values: k.values.iter().map(|v| v.abs()).collect() };
    let x: Vec<f64> = x.iter().map(|v| v.abs()).collect();
    let mut y = vec![0.0; x.len()];
    absolute.multiply_add(&x, &mut y);
    y.into_iter().fold(0.0, f64::max)
}

impl Procedure for StaticGeneral<'_> {
    fn advance(&mut self, from: &Converged, attempt: Attempt) -> Result<(Converged, Convergence), Reject> {
        let scene = &self.system.scene;
        let total_time = from.total_time - from.step_time + attempt.step_time;
        let mut given = vec![0.0; from.u.len()];
        for (f, ramp) in &scene.prescribed {
            given[*f] = ramp.at(attempt.step_time, total_time, scene.period) - from.u[*f];
        }
        let external = scene.external.at(attempt.step_time, total_time, scene.period, from.u.len());
        let step = Increment { from, attempt, external, free: scene.free() };
        let mut new = from.history.clone();
        let mut u = from.u.clone();
        let mut now = self.evaluate(&step, &u, &mut new)?;
        let mut newton = Newton::new(self.controls, self.mean_forces);
        loop {
            let delta = self.correction(&now, &given)?;
            // The first correction carries the prescribed motion and is taken whole.
            let prescribed = given.iter().any(|&g| g != 0.0);
            let slope = if prescribed { 0.0 } else { dot(&delta, &now.residual) };
            given.fill(0.0);
            let length;
            (length, now) = self.search(&step, &mut u, &delta, slope, &mut new)?;
            let correction = delta.iter().fold(0.0, |m: f64, d| m.max((length * d).abs()));
            let iterate = self.iterate(&step, &u, correction, &now);
            tracing::debug!(?iterate, length, "iteration");
            if newton.judge(&iterate)? == Verdict::Converged {
                self.mean_forces = (self.mean_forces.0 + iterate.mean_force, self.mean_forces.1 + 1);
                return Ok((converged(step, u, new, now), newton.convergence(&iterate)));
            }
        }
    }

    fn seconds(&self) -> Seconds {
        self.seconds
    }
}

/// The accepted state.
fn converged(step: Increment, u: Vec<f64>, history: Vec<Vec<f64>>, now: Evaluation) -> Converged {
    let from = step.from;
    let mut work = from.energy.work;
    for f in 0..u.len() {
        let force =
            |external: &[f64], residual: &[f64]| if step.free[f] { external[f] } else { external[f] + residual[f] };
        let before = if from.external.is_empty() { 0.0 } else { force(&from.external, &from.residual) };
        work += 0.5 * (before + force(&step.external, &now.residual)) * (u[f] - from.u[f]);
    }
    Converged {
        step_time: step.attempt.step_time,
        total_time: step.total_time(),
        energy: Energy { solids: now.linear_energy, contact: now.nonlinear_energy, work },
        u,
        residual: now.residual,
        external: step.external,
        history,
    }
}
