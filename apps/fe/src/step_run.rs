//! One step: bodies are brought into contact, then increment by increment, each certified and recorded.

use crate::approach::{Approach, FreeBody, approach, free_bodies, in_words, undecided};
use crate::certificate::{Certificate, RunCertificate};
use crate::course::Course;
use crate::job::{JobFailure, scene, static_procedure};
use crate::number::scientific;
use crate::observer::{Event, Observer};
use crate::plan::{Matrix, Plan};
use crate::reason::{explain, help};
use crate::recorder::{Increment, Recorder};
use crate::terms::Terms;
use fe_contact::point::ContactStatus;
use fe_contact::redundant::contradiction;
use fe_contact::state::{ContactState, TooSoft};
use fe_core::bodies::RigidMotion;
use fe_core::increment::{Failure, IncrementSize};
use fe_core::linear::multifrontal::Multifrontal;
use fe_core::procedure::static_general::StaticGeneral;
use fe_core::procedure::system::Scene;
use fe_core::procedure::{Converged, Procedure};
use fe_core::step::Increments;
use fe_io::model::Step;

/// One step of a job.
pub(crate) struct StepRun<'a, 'o> {
    /// The terms, entered into the step.
    pub terms: &'a Terms,
    /// What the deck says.
    pub step: &'a Step,
    /// Its number, from 1.
    pub number: usize,
    /// Is told what happens.
    pub observer: &'o mut dyn Observer,
    /// Writes the increments.
    pub recorder: &'o mut Recorder,
}

impl StepRun<'_, '_> {
    /// Runs it; `at` is the last converged state, also where it fails.
    pub fn run(
        &mut self,
        course: &Course,
        at: &mut Converged,
        certificate: &mut RunCertificate,
    ) -> Result<(), JobFailure> {
        let (increments, controls) = static_procedure(self.step)?;
        let scene = scene(self.terms, self.step, course)?;
        let fixed = course.fixed(at.u.len());
        let free =
            free_bodies(&self.terms.structure, &self.terms.freedoms, &self.terms.bodies, &fixed, &self.terms.contacts);
        at.step_time = 0.0;
        self.bring_into_contact(&free, (&scene, increments), at)?;
        self.must_not_contradict(&scene, at, &fixed)?;
        let solver = Box::new(Multifrontal::default());
        let mut procedure = StaticGeneral::new(scene, controls, solver)
            .map_err(|reject| self.failure(0.0, explain(&reject, self.terms), help(&reject)))?;
        let matrix = procedure.pattern().zip(procedure.cost()).map(|(pattern, cost)| Matrix::of(pattern, cost));
        let plan = Plan::of(self.terms, self.step, (&at.u, &fixed), matrix, &free);
        let period = increments.period;
        self.observer.event(Event::Step { number: self.number, plan: &plan, period });
        let mut size = IncrementSize::new(increments, controls);
        let ended = self.increments(&mut size, &mut procedure, at, (&fixed, &free), certificate);
        certificate.seconds.procedure += procedure.seconds();
        certificate.factorisations += procedure.factorisations();
        self.tell_contact(at);
        ended
    }

    /// Says where nothing touches, and warns where a penalty let bodies overlap visibly.
    fn tell_contact(&mut self, at: &Converged) {
        let states = self.terms.states(at);
        let contacts = || self.terms.contacts.iter().zip(&states);
        let label = |node: u32| self.terms.structure.mesh.point_name(node);
        for (contact, soft) in contacts().filter_map(|(contact, state)| Some((contact, contact.too_soft(state)?))) {
            let TooSoft { node, overclosure, part, layers } = soft;
            self.observer.event(Event::Note(&format!(
                "warning: the penalty of {} lets node {} in by {overclosure:.3e}, {:.2} % of a facet and {layers:.2} times what an \
                 element gives way: contact is not hard; a stiffer penalty, AUGMENTED LAGRANGE or DIRECT is",
                contact.name(),
                label(node),
                100.0 * part
            )));
        }
        let open = |state: &ContactState| state.points.iter().all(|p| p.status == ContactStatus::Open);
        for (contact, state) in contacts().filter(|(contact, state)| contact.acts() && open(state)) {
            let Some(nearest) = state.points.iter().min_by(|a, b| a.opening.total_cmp(&b.opening)) else { continue };
            self.observer.event(Event::Note(&format!(
                "{}: no contact at the end of step {}, the smallest gap is {:.3e} (node {})",
                contact.name(),
                self.number,
                nearest.opening,
                label(nearest.node)
            )));
        }
    }

    fn increments(
        &mut self,
        size: &mut IncrementSize,
        procedure: &mut StaticGeneral,
        at: &mut Converged,
        (fixed, free): (&[bool], &[FreeBody]),
        run: &mut RunCertificate,
    ) -> Result<(), JobFailure> {
        loop {
            let attempt = match size.next_attempt() {
                Ok(Some(attempt)) => attempt,
                Ok(None) => return Ok(()),
                Err(failure) => return Err(self.gave_up(at, &failure)),
            };
            match procedure.advance(at, attempt) {
                Ok((next, convergence)) => {
                    *at = next;
                    size.accept(attempt, convergence.equilibrium_iterations);
                    self.must_be_decided(free, at)?;
                    let states = self.terms.states(at);
                    let certificate = Certificate::of(self.terms, at, &convergence, &states, fixed);
                    if let Some(fault) = certificate.fault() {
                        return Err(self.failure(at.step_time, fault, "this increment was not written".into()));
                    }
                    run.add(&certificate, &convergence);
                    let now =
                        Increment { at, attempt, step: self.number, certificate: &certificate, states: &states, fixed };
                    self.recorder.increment(self.terms, self.step, &now)?;
                    let contact_force = states.iter().map(|s| norm(s.total().0)).sum();
                    let step = self.number;
                    let convergence = &convergence;
                    let certificate = &certificate;
                    self.observer.event(Event::Increment { step, attempt, convergence, certificate, contact_force });
                }
                Err(reason) => {
                    let reason_in_words = &explain(&reason, self.terms);
                    self.observer.event(Event::Cutback { step: self.number, attempt, reason: reason_in_words });
                    run.cutbacks += 1;
                    size.cut_back(attempt, reason).map_err(|failure| self.gave_up(at, &failure))?;
                }
            }
        }
    }

    /// Bodies held by contact alone are moved, without strain, until they touch.
    fn bring_into_contact(
        &mut self,
        free: &[FreeBody],
        (scene, increments): (&Scene, Increments),
        at: &mut Converged,
    ) -> Result<(), JobFailure> {
        let terms = self.terms;
        let name = |body: &FreeBody| terms.body_name(&terms.bodies[body.body]);
        let words = |body: &FreeBody, m: &RigidMotion| in_words(m, terms.bodies[body.body].size);
        let free_in = |body: &FreeBody| body.motions.iter().map(|m| words(body, m)).collect::<Vec<_>>().join(", ");
        if let Some(body) = free.iter().find(|body| !body.touched) {
            let reason =
                format!("nothing holds {}: it is free {}, and no contact pair has it", name(body), free_in(body));
            return Err(self.failure(0.0, reason, "hold it by *BOUNDARY, or bring it into a *CONTACT PAIR".into()));
        }
        if free.is_empty() {
            return Ok(());
        }
        // The loads at the end, or where an amplitude has taken them away by then, at first.
        let Increments { period, initial, .. } = increments;
        let loads = |time: f64| scene.external.at(time, at.total_time + time, period, at.u.len());
        let mut external = loads(period);
        if external.iter().all(|f| *f == 0.0) {
            external = loads(initial);
        }
        let mut end = approach(terms, free, &at.u, &external);
        // Loads that turn within the step may press at first.
        if let Approach::Lost(..) = end
            && let held @ Approach::Moved(_) = approach(terms, free, &at.u, &loads(initial))
        {
            end = held;
        }
        match end {
            Approach::Moved(bodies) => {
                for (b, motion) in bodies {
                    let (body, name) = (&terms.bodies[free[b].body], name(&free[b]));
                    let field = body.field(&terms.structure, &terms.freedoms, &motion);
                    at.u.iter_mut().zip(&field).for_each(|(u, d)| *u += d);
                    let (free_in, [x, y, z, turns @ ..]) = (free_in(&free[b]), motion);
                    let moved = [x, y, z];
                    let [x, y, z] = without_round_off(moved).map(|v| scientific(v, 6));
                    let turn = norm(turns);
                    let rim = turn * body.size;
                    let turned =
                        if rim > 1e-9 * norm(moved) { format!(" and turned by {turn:.3e} rad") } else { "".into() };
                    self.observer.event(Event::Note(&format!(
                        "{name} is held by contact alone (free {free_in}): moved by ({x}, {y}, {z}){turned} into first contact, without strain"
                    )));
                }
                Ok(())
            }
            Approach::Lost(b, direction) => {
                let [x, y, z] = without_round_off(direction);
                let (name, free_in) = (name(&free[b]), free_in(&free[b]));
                let reason = format!(
                    "{name} is free {free_in}; its load drives it along ({x:.3}, {y:.3}, {z:.3}), where no surface of a pair stops it"
                );
                Err(self.failure(0.0, reason, "turn the load, or hold the body by *BOUNDARY".into()))
            }
            Approach::Unheld(b, motion) => {
                let (name, way) = (name(&free[b]), words(&free[b], &motion));
                let reason = format!("{name} is free {way}, and the surfaces of its pairs cannot hold it that way");
                Err(self.failure(0.0, reason, "hold it by *BOUNDARY".into()))
            }
        }
    }

    /// Refuses supports that hold a node inside a body that hard contact holds it out of.
    fn must_not_contradict(&self, scene: &Scene, at: &Converged, fixed: &[bool]) -> Result<(), JobFailure> {
        let mut end = at.u.clone();
        let total = at.total_time + scene.period;
        scene.prescribed.iter().for_each(|(f, ramp)| end[*f] = ramp.at(scene.period, total, scene.period));
        let Some(found) = contradiction(&self.terms.contacts, &end, fixed) else { return Ok(()) };
        let (secondary, main) = self.terms.contacts[found.contact].surfaces();
        let label = self.terms.structure.mesh.point_name(found.node);
        let reason = format!(
            "*BOUNDARY holds node {label} of {secondary} {:.3e} inside {main} at the end of the step, and hard contact \
             holds it out",
            found.overclosure
        );
        Err(self.failure(0.0, reason, "move one of them, or use *SURFACE BEHAVIOR, PENALTY".into()))
    }

    /// Refuses an equilibrium in which a free body might as well stand elsewhere.
    fn must_be_decided(&self, free: &[FreeBody], at: &Converged) -> Result<(), JobFailure> {
        let Some((b, motion)) = undecided(self.terms, free, &at.u) else { return Ok(()) };
        let body = &self.terms.bodies[free[b].body];
        let (name, way) = (self.terms.body_name(body), in_words(&motion, body.size));
        let reason =
            format!("{name} has no unique position: its load stands on a plateau of the law that holds it, free {way}");
        let help = "give the law a slope there, change the load a little, or hold the body by *BOUNDARY";
        Err(self.failure(at.step_time, reason, help.into()))
    }

    fn gave_up(&self, at: &Converged, failure: &Failure) -> JobFailure {
        let (last, text) = match failure {
            Failure::TooManyAttempts { last, .. } | Failure::TooSmall { last, .. } | Failure::Fixed { last } => {
                (Some(last), failure.to_string().replace(&last.to_string(), &explain(last, self.terms)))
            }
            Failure::TooMany { .. } => (None, failure.to_string()),
        };
        let help = last.map_or("allow more by *STEP, INC=".into(), help);
        self.failure(at.step_time, text, help)
    }

    fn failure(&self, time: f64, reason: String, help: String) -> JobFailure {
        JobFailure::Step { step: self.number, time, reason, help: format!("help: {help}") }
    }
}

/// A vector for a message: parts that are round-off of the whole print as 0.
fn without_round_off(v: [f64; 3]) -> [f64; 3] {
    let size = norm(v);
    v.map(|x| if x.abs() < 1e-9 * size { 0.0 } else { x })
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
