//! `*STATIC`: equilibrium at each time, by Newton's method.

use super::newton::{Iterate, Newton, Verdict};
use super::scale::Scale;
use super::system::{Evaluation, Scene, System, dot};
use super::{Converged, Convergence, Energy, Procedure, Seconds};
use crate::increment::Attempt;
use crate::linear::gmres::gmres;
use crate::linear::{Cost, LinearSolver};
use crate::matrix::{BlockMatrix, Pattern};
use crate::reject::Reject;
use crate::step::Controls;
use crate::term::{Equilibrium, Lacking, Motion, Overlap};
use std::time::Instant;

/// Residuals of a backward stable solver are a modest multiple of ε |K||u| (Higham, Accuracy and Stability of
/// Numerical Algorithms, 2nd ed., theorem 10.4; the multiple grows with the row length in theory, hardly in
/// practice).
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// A line search is made when the step overshoots: the residual along it comes out with the other sign and more
/// than this part of its size at the start.
const OVERSHOOT: f64 = 0.5;

/// A step falls short when no contact changed status on it and the residual along it keeps more than this part of its
/// size: a point within round-off of touching has the stiffness of the closed side, which may hold back one that leaves,
/// and a law on a plateau has none, of which nothing tells how far to go.
const UNDERSHOOT: f64 = 0.9;

/// Most augmentations of the multipliers of an increment (the decks' default).
const AUGMENTATIONS: usize = 50;

/// Residual of unsymmetric systems [-], of the right-hand side: not above what the factor itself leaves, so that Newton's
/// method converges as fast as with a factor of the whole.
const SOLVED: f64 = 1e-13;

/// Directions kept in a search for their solution, and products in all.
const RESTART: usize = 80;
const PRODUCTS: usize = 400;

/// Most evaluations of one line search.
const SEARCHES: usize = 16;

/// What the factor was made of.
enum Factored {
    Nothing,
    /// The stiffness of the linear terms.
    Linear,
    /// A tangent.
    Tangent(BlockMatrix),
}

/// Static equilibrium over the increments of one step.
pub struct StaticGeneral<'a> {
    system: System<'a>,
    controls: Controls,
    solver: Box<dyn LinearSolver + 'a>,
    factored: Factored,
    /// Memory of a tangent that is no longer needed.
    spare: Option<BlockMatrix>,
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
            solver.analyse(&linear.pattern, &system.scene.free(), &system.changing);
            seconds.order = start.elapsed().as_secs_f64();
        }
        let (factored, mean_forces) = (Factored::Nothing, (0.0, 0));
        Ok(StaticGeneral { system, controls, solver, factored, spare: None, factorisations: 0, mean_forces, seconds })
    }

    /// What one factorisation costs; `None` where there is no matrix.
    pub fn cost(&self) -> Option<Cost> {
        self.system.linear.as_ref().map(|_| self.solver.cost())
    }

    /// Which blocks the matrix has; `None` where there is no matrix.
    pub fn pattern(&self) -> Option<&Pattern> {
        self.system.linear.as_ref().map(|linear| &*linear.pattern)
    }

    /// Factorisations made so far.
    pub fn factorisations(&self) -> usize {
        self.factorisations
    }

    fn evaluate(&mut self, step: &Increment, u: &[f64], new: &mut [Vec<f64>]) -> Result<Evaluation, Reject> {
        let start = Instant::now();
        let du: Vec<f64> = u.iter().zip(&step.from.u).map(|(a, b)| a - b).collect();
        let at = step.motion(u, &du);
        let evaluation = self.system.evaluate(at, &step.external, (&step.from.history, new), self.spare.take());
        self.seconds.assemble += start.elapsed().as_secs_f64();
        evaluation
    }

    /// Lets the terms take new multipliers at an equilibrium; the worst overlap that made one do so.
    fn augment(&self, step: &Increment, at: Equilibrium, new: &mut [Vec<f64>]) -> Option<Overlap> {
        let terms = self.system.scene.terms.iter().zip(&step.from.history).zip(new);
        let overlaps = terms.filter_map(|((term, old), new)| term.augment(at, old, new));
        overlaps.max_by(|a, b| a.overclosure.abs().total_cmp(&b.overclosure.abs()))
    }

    /// Factors the tangent of an evaluation at `u`, unless it stands factored. Where it is singular the terms may
    /// stiffen it.
    fn factor(&mut self, u: &[f64], evaluation: &mut Evaluation) -> Result<(), Reject> {
        let start = Instant::now();
        let Some(tangent) = evaluation.tangent.as_ref().or(self.system.linear.as_ref()) else { return Ok(()) };
        let current = match (&self.factored, &evaluation.tangent) {
            (Factored::Linear, None) => true,
            (Factored::Tangent(last), Some(tangent)) => self.system.same(last, tangent),
            _ => false,
        };
        if current {
            return Ok(());
        }
        let mut factored = match std::mem::replace(&mut self.factored, Factored::Nothing) {
            Factored::Nothing => self.solver.factor(tangent),
            Factored::Linear => self.solver.factor_again(tangent),
            Factored::Tangent(last) => {
                self.spare = Some(last);
                self.solver.factor_again(tangent)
            }
        };
        if let (Err(_), Some(tangent)) = (factored, &mut evaluation.tangent)
            && self.system.stiffen(u, tangent)
        {
            factored = self.solver.factor(tangent);
        }
        let freedoms = &self.system.scene.freedoms;
        factored.map_err(|singular| Reject::Singular {
            node: freedoms.node(singular.freedom),
            component: freedoms.component(singular.freedom),
        })?;
        self.factorisations += 1;
        self.seconds.factor += start.elapsed().as_secs_f64();
        Ok(())
    }

    /// Solves K δ = −r on the free freedoms; the prescribed ones move by `given`. Returns δ and the slope δ·r of the
    /// potential along it: 0 where a prescribed motion is carried, which is taken whole.
    fn correction(
        &mut self,
        here: &Here,
        mut evaluation: Evaluation,
        given: &[f64],
    ) -> Result<(Vec<f64>, f64), Reject> {
        let mut delta = given.to_vec();
        self.factor(here.u, &mut evaluation)?;
        let Some(tangent) = evaluation.tangent.as_ref().or(self.system.linear.as_ref()) else {
            return Ok((delta, 0.0));
        };
        let start = Instant::now();
        let mut right = vec![0.0; delta.len()];
        let carries = given.iter().any(|&g| g != 0.0);
        if carries {
            tangent.multiply_add(given, &mut right);
        }
        let lacking = here.lacking(&self.system);
        lacking.iter().for_each(|product| product(given, &mut right));
        right.iter_mut().zip(&evaluation.residual).for_each(|(b, r)| *b = -*b - r);
        if !lacking.is_empty() {
            self.bring_in(&lacking, here.step, &mut right);
        }
        self.solver.solve(&mut right);
        delta.iter_mut().zip(&right).for_each(|(d, x)| *d += x);
        let factored = evaluation.tangent.map_or(Factored::Linear, Factored::Tangent);
        if let Factored::Tangent(last) = std::mem::replace(&mut self.factored, factored) {
            self.spare = Some(last);
        }
        self.seconds.solve += start.elapsed().as_secs_f64();
        let slope = if carries { 0.0 } else { dot(&delta, &evaluation.residual) };
        Ok((delta, slope))
    }

    /// Makes b of (S + C) δ = b into w of S δ = w, where S is what stands factored: w = b + r, (1 + C S⁻¹) r = −C S⁻¹ b. r
    /// lives on the freedoms of contact alone, and so do the directions of the search for it.
    fn bring_in(&self, lacking: &[Lacking], step: &Increment, right: &mut [f64]) {
        let changing = &self.system.changing;
        let freedoms = self.system.scene.freedoms;
        let touched: Vec<usize> = (0..right.len()).filter(|&f| step.free[f] && changing[freedoms.node(f)]).collect();
        let product = |mut w: Vec<f64>| -> Vec<f64> {
            self.solver.solve(&mut w);
            let mut y = vec![0.0; w.len()];
            lacking.iter().for_each(|product| product(&w, &mut y));
            touched.iter().map(|&f| y[f]).collect()
        };
        let begin: Vec<f64> = product(right.to_vec()).iter().map(|v| -v).collect();
        let apply = |r: &[f64]| -> Vec<f64> {
            let mut w = vec![0.0; right.len()];
            touched.iter().zip(r).for_each(|(&f, r)| w[f] = *r);
            product(w).iter().zip(r).map(|(c, r)| c + r).collect()
        };
        let tolerance = SOLVED * dot(right, right).sqrt();
        let (r, residual) = gmres(apply, &begin, tolerance, (RESTART, PRODUCTS));
        tracing::debug!(residual, tolerance, "couplings");
        touched.iter().zip(r).for_each(|(&f, r)| right[f] += r);
    }

    /// Goes along `delta`: all of it, unless the residual along it changes sign by too much, or hardly falls. The potential of a
    /// convex problem falls along a Newton step, so its slope has one zero. Newton's method finds it, between bounds
    /// that close in: from the stiff side, where contact has closed, it lands near the kink at once. Returns the
    /// part of `delta` taken and the evaluation there.
    fn search(
        &mut self,
        step: &Increment,
        u: &mut [f64],
        (delta, slope): (&[f64], f64),
        new: &mut Vec<Vec<f64>>,
    ) -> Result<(f64, Evaluation), Reject> {
        let start = u.to_vec();
        let (mut low, mut high, mut length) = (0.0, f64::INFINITY, 1.0);
        let enough = OVERSHOOT * slope.abs();
        let mut searched = 0;
        loop {
            searched += 1;
            u.iter_mut().zip(start.iter().zip(delta)).for_each(|(a, (s, d))| *a = s + length * d);
            let mut history = new.clone();
            let now = self.evaluate(step, u, &mut history)?;
            let here = dot(delta, &now.residual);
            let short = here < -enough && high.is_finite();
            let held_back = now.status_changes == 0 && high.is_infinite() && here < -UNDERSHOOT * slope.abs();
            if slope >= 0.0 || (here <= enough && !short && !held_back) || searched == SEARCHES {
                *new = history;
                return Ok((length, now));
            }
            if held_back {
                low = length;
                length *= 2.0;
                continue;
            }
            *(if short { &mut low } else { &mut high }) = length;
            let curvature = self.tangent(&now).map_or(0.0, |tangent| {
                let mut product = vec![0.0; delta.len()];
                tangent.multiply_add(delta, &mut product);
                let lacking = Here { step, u, new: &history }.lacking(&self.system);
                lacking.iter().for_each(|lacks| lacks(delta, &mut product));
                dot(delta, &product)
            });
            let next = length - here / curvature;
            length = if low < next && next < high { next } else { 0.5 * (low + high) };
        }
    }

    /// The tangent at an evaluation: its own, or that of the linear terms.
    fn tangent<'e>(&'e self, at: &'e Evaluation) -> Option<&'e BlockMatrix> {
        at.tangent.as_ref().or(self.system.linear.as_ref())
    }

    /// Turned into heat in an increment.
    fn dissipated(&self, step: &Increment, new: &[Vec<f64>]) -> f64 {
        let terms = self.system.scene.terms.iter().zip(&step.from.history).zip(new);
        terms.map(|((term, old), new)| term.dissipated(old, new)).sum()
    }

    /// Largest force [F] that the terms which are not linear explain by rounding.
    fn round_off(&self, u: &[f64], history: &[Vec<f64>]) -> f64 {
        let terms = self.system.scene.terms.iter().zip(history);
        terms.map(|(term, history)| term.force_round_off(u, history)).fold(0.0, f64::max)
    }

    /// What an iteration left that moved by `length` · `delta` to `u`.
    fn iterate(&self, step: &Increment, u: &[f64], (length, delta): (f64, &[f64]), now: &Evaluation) -> Iterate {
        let tangent = self.tangent(now);
        // Where a large displacement is taken back, the rounding of the correction stays.
        let moved: Vec<f64> = u.iter().zip(delta).map(|(u, d)| u.abs().max((length * d).abs())).collect();
        let products = tangent.map_or_else(|| self.system.shaken(&moved), |k| k.absolute_product(&moved));
        // Forces and moments have scales of their own, displacements and rotations, too.
        let (mut forces, mut moments) = (Scale::default(), Scale::default());
        for (f, r) in now.residual.iter().enumerate() {
            let turns = self.system.scene.freedoms.component(f) >= 3;
            let scale = if turns { &mut moments } else { &mut forces };
            let (residual, reaction) = if step.free[f] { (r.abs(), 0.0) } else { (0.0, r.abs()) };
            scale.residual = scale.residual.max(residual);
            scale.product = products.get(f).map_or(scale.product, |p| scale.product.max(*p));
            scale.correction = scale.correction.max((length * delta[f]).abs());
            scale.increment = scale.increment.max((u[f] - step.from.u[f]).abs());
            scale.add(step.external[f].abs().max(now.nonlinear[f].abs()).max(reaction));
        }
        let scale = forces.with(&moments);
        Iterate {
            residual: scale.residual,
            largest_force: scale.largest,
            mean_force: scale.mean(),
            correction: scale.correction,
            increment: scale.increment,
            status_changes: now.status_changes,
            round_off: ROUND_OFF * scale.product,
        }
    }
}

/// Where an iteration stands.
struct Here<'h> {
    step: &'h Increment<'h>,
    u: &'h [f64],
    /// History that the evaluation there left.
    new: &'h [Vec<f64>],
}

impl Here<'_> {
    /// What the tangent lacks.
    fn lacking<'s>(&self, system: &'s System) -> Vec<Lacking<'s>> {
        let from = self.step.from;
        let du: Vec<f64> = self.u.iter().zip(&from.u).map(|(a, b)| a - b).collect();
        system.lacking(self.step.motion(self.u, &du), (&from.history, self.new))
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
        let mut passes = 0;
        loop {
            let (delta, slope) = self.correction(&Here { step: &step, u: &u, new: &new }, now, &given)?;
            given.fill(0.0);
            let length;
            (length, now) = self.search(&step, &mut u, (&delta, slope), &mut new)?;
            let mut iterate = self.iterate(&step, &u, (length, &delta), &now);
            let of_elements = iterate.round_off;
            iterate.round_off += self.round_off(&u, &new);
            tracing::debug!(?iterate, length, "iteration");
            if newton.judge(&iterate)? == Verdict::Converged {
                let noise = iterate.residual.max(of_elements);
                let at = Equilibrium { u: &u, noise, passes };
                if let Some(Overlap { node, overclosure }) = self.augment(&step, at, &mut new) {
                    passes += 1;
                    if passes > AUGMENTATIONS {
                        return Err(Reject::NotEnforced { passes: AUGMENTATIONS, node, overclosure });
                    }
                    newton.augmented();
                    now = self.evaluate(&step, &u, &mut new)?;
                    continue;
                }
                self.mean_forces = (self.mean_forces.0 + iterate.mean_force, self.mean_forces.1 + 1);
                let dissipated = self.dissipated(&step, &new);
                return Ok((converged(step, u, new, (now, dissipated)), newton.convergence(&iterate)));
            }
        }
    }

    fn seconds(&self) -> Seconds {
        self.seconds
    }
}

/// The accepted state.
fn converged(step: Increment, u: Vec<f64>, history: Vec<Vec<f64>>, (now, dissipated): (Evaluation, f64)) -> Converged {
    let from = step.from;
    let mut work = from.energy.work;
    for (f, (end, start)) in u.iter().zip(&from.u).enumerate() {
        // A freedom that is free now may have been held before: its reaction counts until it is released.
        let before = if from.external.is_empty() { 0.0 } else { from.external[f] + from.residual[f] };
        let reaction = if step.free[f] { 0.0 } else { now.residual[f] };
        work += 0.5 * (before + step.external[f] + reaction) * (end - start);
    }
    Converged {
        step_time: step.attempt.step_time,
        total_time: step.total_time(),
        energy: Energy {
            solids: now.linear_energy,
            contact: now.nonlinear_energy,
            friction: from.energy.friction + dissipated,
            work,
        },
        u,
        residual: now.residual,
        external: step.external,
        history,
    }
}
