//! Explicit jobs: step by step, increment by increment, with frames at equal intervals of time.

mod contact;
mod contact_states;
mod energies;
mod general;
mod plan;
mod record;
mod scene;
mod series;
mod values;

use crate::certificate::RunCertificate;
use crate::course::Course;
use crate::job::{JobFailure, Report};
use crate::observer::{Event, Observer};
use crate::plan::Plan;
pub use energies::{Balance, Frame};
use fe_core::explicit::Halt;
use fe_core::explicit::central_difference::{CentralDifference, State, Support};
use fe_core::procedure::Converged;
use fe_core::step::{Explicit, IncrementChoice, Procedure};
use fe_io::Model;
use fe_io::model::Step;
use record::{Left, Record, Turn};
use scene::Scene;
use std::path::Path;
use std::time::Instant;
use values::Moment;

/// Part of the largest stable increment that is used [-]: the increment is that of the state before, which the next one may
/// stiffen.
const SAFETY: f64 = 0.98;

/// Most that an increment may be larger than the one before [-].
const GROWTH: f64 = 1.05;

/// Energy that appears or is lost, over the largest that there was, at which a run is stopped [-].
const DRIFT: f64 = 0.1;

/// Runs a model of explicit steps; results are named after `job`, with other endings.
pub fn run_model(model: &Model, job: &Path, read: f64, observer: &mut dyn Observer) -> Result<Report, JobFailure> {
    let start = Instant::now();
    let first = model.steps.iter().find_map(explicit).expect("a job of explicit steps");
    let mut scene = Scene::new(model, &first)?;
    model.notes.iter().for_each(|note| observer.event(Event::Note(note)));
    let mut record = Record::create(job, model, &scene)?;
    let mut state = State::rest(&scene.freedoms);
    for &(node, component, velocity) in &model.initial_velocities {
        if let Some(freedom) = scene.freedoms.index(node as usize, component) {
            state.v[freedom] = velocity;
        }
    }
    let mut certificate = RunCertificate::default();
    let mut run = Run { scene: &mut scene, state: &mut state, record: &mut record, certificate: &mut certificate };
    let ended = run.steps(model, observer);
    certificate.seconds.read = read;
    certificate.seconds.write = record.seconds();
    certificate.seconds.total = read + start.elapsed().as_secs_f64();
    certificate.peak_memory = fe_io::memory::peak();
    let results = record.path();
    let closed = record.finish(if ended.is_ok() { "completed" } else { "failed" });
    ended?;
    closed?;
    observer.event(Event::Done(&certificate));
    let last = Converged { u: state.u, total_time: state.total_time, ..Converged::default() };
    Ok(Report { certificate, last, results })
}

/// The plan of every step, in words: each as from the start of the job.
pub fn check(model: &Model) -> Result<String, JobFailure> {
    let first = model.steps.iter().find_map(explicit).expect("a job of explicit steps");
    let mut scene = Scene::new(model, &first)?;
    let mesh = &scene.structure.mesh;
    let mut text = format!("{} nodes, {} elements\n", mesh.points.len(), mesh.cell_count());
    let mut course = Course::new(model);
    let mut state = State::rest(&scene.freedoms);
    for (index, step) in model.steps.iter().enumerate() {
        enter(model, index, &mut course, &mut scene, &state)?;
        let begun = begin((index + 1, step), &course, &mut scene, &mut state)?;
        let plan = begun.plan;
        text += &format!("\nstep {}, time {}\n{plan}", index + 1, step.procedure.period());
    }
    Ok(text)
}

/// Enters a step, by its index, from a state.
fn enter(model: &Model, index: usize, course: &mut Course, scene: &mut Scene, state: &State) -> Result<(), JobFailure> {
    let step = &model.steps[index];
    let initial: &[_] = if index == 0 { &model.supports } else { &[] };
    let (u, residual) = (state.u.clone(), vec![0.0; state.u.len()]);
    let at = Converged { u, residual, total_time: state.total_time, ..Converged::default() };
    course.enter(initial, step, &scene.freedoms, &at);
    scene.enter(model, step, course)
}

/// A step that has begun.
struct Begun {
    procedure: CentralDifference,
    /// Prescribed freedoms.
    fixed: Vec<bool>,
    plan: Plan,
}

/// Begins a step that was entered.
fn begin(
    (number, step): (usize, &Step),
    course: &Course,
    scene: &mut Scene,
    state: &mut State,
) -> Result<Begun, JobFailure> {
    let explicit = explicit(step).expect("all steps are explicit");
    let support = |(freedom, kind, course)| Support { freedom, kind, course };
    let (supports, fixed) = (course.moved().map(support).collect(), course.fixed(state.u.len()));
    let most = match explicit.increment {
        IncrementChoice::Fixed(dt) => dt,
        _ => explicit.largest.unwrap_or(f64::INFINITY),
    };
    let procedure = CentralDifference::new(&mut scene.terms(), supports, (explicit.period, most), state)
        .map_err(|halt| halted(scene, (number, 0.0), &halt))?;
    let prescribed = fixed.iter().filter(|fixed| **fixed).count();
    let plan = plan::plan(scene, step, prescribed, &procedure.stable());
    Ok(Begun { procedure, fixed, plan })
}

pub(crate) fn explicit(step: &Step) -> Option<Explicit> {
    match step.procedure {
        Procedure::Explicit(explicit) => Some(explicit),
        Procedure::Static { .. } => None,
    }
}

struct Run<'a> {
    scene: &'a mut Scene,
    state: &'a mut State,
    record: &'a mut Record,
    certificate: &'a mut RunCertificate,
}

impl Run<'_> {
    fn steps(&mut self, model: &Model, observer: &mut dyn Observer) -> Result<(), JobFailure> {
        let mut course = Course::new(model);
        for (index, step) in model.steps.iter().enumerate() {
            enter(model, index, &mut course, self.scene, self.state)?;
            self.step(model, (index + 1, step), &course, observer)?;
        }
        Ok(())
    }

    fn step(
        &mut self,
        model: &Model,
        (number, step): (usize, &Step),
        course: &Course,
        observer: &mut dyn Observer,
    ) -> Result<(), JobFailure> {
        let explicit = explicit(step).expect("all steps are explicit");
        let Begun { mut procedure, fixed, plan } = begin((number, step), course, self.scene, self.state)?;
        observer.event(Event::Step { number, plan: &plan, period: explicit.period });
        if number == 1 {
            let at = moment((model, self.scene), self.state, &procedure, &fixed);
            self.record.increment(at, &Turn::START, &step.output)?;
        }
        let mut increment = 0;
        let mut last = self.state.dt;
        while self.state.step_time < explicit.period {
            let left = explicit.period - self.state.step_time;
            let dt = increment_size(&explicit, procedure.stable().increment(), (last, left));
            if !dt.is_finite() {
                return Err(self.failure(
                    number,
                    "no element has both mass and stiffness: no increment is the largest stable one".into(),
                    "give one: *DYNAMIC, EXPLICIT, DIRECT USER CONTROL",
                ));
            }
            last = dt;
            let before = self.state.step_time;
            let ends = dt >= left;
            procedure
                .advance(&mut self.scene.terms(), self.state, dt)
                .map_err(|halt| halted(self.scene, (number, self.state.step_time), &halt))?;
            if ends {
                self.state.step_time = explicit.period;
            }
            increment += 1;
            self.certificate.increments += 1;
            let turn = Turn { step: number, increment, times: [before, self.state.step_time], period: explicit.period };
            let at = moment((model, self.scene), self.state, &procedure, &fixed);
            let Left { balance, has_frame } = self.record.increment(at, &turn, &step.output)?;
            let Some(balance) = balance else { continue };
            self.certificate.explicit = Some(balance);
            if has_frame {
                let frame = Frame { step: number, increment, step_time: self.state.step_time, dt, balance };
                observer.event(Event::Frame(&frame));
            }
            if balance.drift() >= DRIFT || balance.drift().is_nan() {
                let reason =
                    format!("the energy balance is off by {:.1} % of the largest energy", 100.0 * balance.drift());
                let help = "the increment is too large (SCALE FACTOR, DIRECT USER CONTROL), or the motion has no end";
                return Err(self.failure(number, reason, help));
            }
        }
        contact::unsettled(self.scene).iter().for_each(|note| observer.event(Event::Note(note)));
        Ok(())
    }

    fn failure(&self, step: usize, reason: String, help: &str) -> JobFailure {
        failure((step, self.state.step_time), reason, help)
    }
}

fn moment<'a>(
    (model, scene): (&'a Model, &'a Scene),
    state: &'a State,
    procedure: &'a CentralDifference,
    fixed: &'a [bool],
) -> Moment<'a> {
    Moment { model, scene, state, procedure, fixed }
}

fn failure((step, time): (usize, f64), reason: String, help: &str) -> JobFailure {
    JobFailure::Step { step, time, reason, help: format!("help: {help}") }
}

/// Why a step ended at a time, with the labels of the deck.
fn halted(scene: &Scene, at: (usize, f64), halt: &Halt) -> JobFailure {
    let mesh = &scene.structure.mesh;
    match *halt {
        Halt::Inverted { cell } => {
            let reason = format!("element {} has turned inside out", mesh.cell_name(cell));
            failure(at, reason, "a finer mesh there, a smaller velocity, or a smaller SCALE FACTOR")
        }
        Halt::Massless { freedom } => {
            let node = mesh.point_name(scene.freedoms.node(freedom) as u32);
            let reason = format!("node {node} has no mass in direction {}", scene.freedoms.component(freedom) + 1);
            let help = match scene.freedoms.component(freedom) {
                0..3 => "*DENSITY, *MASS, or hold it by *BOUNDARY",
                _ => "*ROTARY INERTIA, or hold it by *BOUNDARY",
            };
            failure(at, reason, help)
        }
        Halt::Spinning { freedom } => {
            let node = mesh.point_name(scene.freedoms.node(freedom) as u32);
            let reason = format!("node {node} turns too far in an increment");
            failure(at, reason, "smaller increments: a fraction of a turn each")
        }
    }
}

/// The next increment [T]: the deck's, or the stable one, growing slowly; the last two of a step share what is left.
fn increment_size(step: &Explicit, stable: f64, (last, left): (f64, f64)) -> f64 {
    let dt = match step.increment {
        IncrementChoice::Fixed(dt) => dt,
        _ => {
            let grown = if last > 0.0 { GROWTH * last } else { f64::INFINITY };
            (SAFETY * step.scale * stable).min(grown).min(step.largest.unwrap_or(f64::INFINITY))
        }
    };
    let fixed = matches!(step.increment, IncrementChoice::Fixed(_));
    // Rounding of the time over a million increments; a last one of that size would bring forces of rounding.
    if left <= dt * (1.0 + 1e-6) {
        left
    } else if !fixed && left < 2.0 * dt {
        0.5 * left
    } else {
        dt
    }
}
