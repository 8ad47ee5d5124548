//! Explicit jobs: step by step, increment by increment, with frames at equal intervals of time.

mod contact;
mod contact_states;
mod energies;
mod general;
mod mass_scaling;
mod plan;
mod record;
mod scene;
mod series;
mod spent;
mod values;

use crate::certificate::RunCertificate;
use crate::course::Course;
use crate::job::{JobFailure, Report};
use crate::number::scientific;
use crate::observer::{Event, Observer};
use crate::plan::Plan;
pub use energies::{Balance, Frame};
use fe_core::explicit::central_difference::{CentralDifference, State, Support};
use fe_core::explicit::{Advance, Halt};
use fe_core::procedure::Converged;
use fe_core::step::{Explicit, IncrementChoice, Procedure};
use fe_core::structure::Structure;
use fe_io::Model;
use fe_io::model::Step;
use record::{Left, Record, Turn};
use scene::Scene;
pub use spent::Spent;
use std::path::Path;
use std::time::{Duration, Instant};
use values::Moment;

/// Part of the largest stable increment that is used [-]: x = ωΔt/2 of the highest mode. The mode swings with 1/√(1 − x²) times
/// its amplitude, 5 here and 22 at 0.999; and an element that shrinks stays within it as long as its ends close in with less
/// than a fiftieth of the speed of sound.
const SAFETY: f64 = 0.98;

/// Most that an increment may be larger than the one before [-]. Changing increments feed the highest modes: one at x = 0.98 of
/// which one increment in twenty is cut at random to 0.5…0.95 grows by 0.7 % an increment with this, by 1.4 % with 1.2 and by
/// 4 % without a bound (counted over a growth by 1e12); the usual bulk viscosity takes 11 %.
const GROWTH: f64 = 1.05;

/// Energy that appears or is lost, over the largest that there was, at which a run is stopped [-]. What changes of the increment
/// give to the highest modes is known and does not count. All runs of the tests that are to end well stay below 0.003, but for two
/// bars of a few elements that begin with a jump, which stay below 0.02.
const DRIFT: f64 = 0.1;

/// Energy in motion and in springs, over what was given, at which a run is stopped [-]: no mode has so much up to x = 0.995, or,
/// where the deck says the increments, 0.9995. At x = 1.01 it grows by (x + √(x² − 1))⁴ = 1.8 an increment.
const SWELL: [f64; 2] = [100.0, 1000.0];

/// Stable increment of the elements over the largest one before in the job at which a run is stopped [-]: an increment follows
/// the size of an element, and no mesh means anything with one pressed to a ten thousandth.
const COLLAPSE: f64 = 1e-4;

/// Time from one line to the next where frames are farther apart.
const QUIET: Duration = Duration::from_secs(10);

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
    let mut run = Run {
        scene: &mut scene,
        state: &mut state,
        record: &mut record,
        certificate: &mut certificate,
        largest: 0.0,
        told: Instant::now(),
    };
    let ended = run.steps(model, observer);
    certificate.seconds.read = read;
    certificate.seconds.write = record.seconds();
    certificate.seconds.total = read + start.elapsed().as_secs_f64();
    certificate.elements = scene.structure.mesh.cell_count();
    certificate.peak_memory = fe_io::memory::peak();
    let results = record.path();
    let closed = record.finish(&certificate, state.total_time, if ended.is_ok() { "completed" } else { "failed" });
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
    let supports: Vec<Support> = course.moved().map(support).collect();
    let fixed = course.fixed(state.u.len());
    let most = match explicit.increment {
        IncrementChoice::Fixed(dt) => dt,
        _ => explicit.largest.unwrap_or(f64::INFINITY),
    };
    let times = (explicit.period, most);
    let failed = |scene: &Scene, halt: Halt| failure((number, 0.0), in_words(scene, &halt));
    let mut procedure = CentralDifference::new(&mut scene.terms(), supports.clone(), times, state)
        .map_err(|halt| failed(scene, halt))?;
    if let Some(stable) = mass_scaling::begin(scene, step, explicit.bulk_viscosity[0]) {
        let worked = state.work;
        procedure.weigh(&mut scene.terms(), state, stable).map_err(|halt| failed(scene, halt))?;
        if number == 1 {
            // The job begins with these masses.
            state.work = worked;
        }
        procedure =
            CentralDifference::new(&mut scene.terms(), supports, times, state).map_err(|halt| failed(scene, halt))?;
    }
    let prescribed = fixed.iter().filter(|fixed| **fixed).count();
    let plan = plan::plan(scene, step, prescribed, &procedure);
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
    /// Largest stable increment of the elements so far [T].
    largest: f64,
    /// When something was told last.
    told: Instant,
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
        let (start, written) = (Instant::now(), self.record.seconds());
        let ended = self.increments(model, (number, step), (&mut procedure, &fixed), observer);
        let seconds = [start.elapsed().as_secs_f64(), self.record.seconds() - written];
        self.certificate.spent.add(self.scene, &procedure, seconds);
        ended?;
        contact::unsettled(self.scene).iter().for_each(|note| observer.event(Event::Note(note)));
        Ok(())
    }

    /// All increments of a step.
    fn increments(
        &mut self,
        model: &Model,
        (number, step): (usize, &Step),
        (procedure, fixed): (&mut CentralDifference, &[bool]),
        observer: &mut dyn Observer,
    ) -> Result<(), JobFailure> {
        let explicit = explicit(step).expect("all steps are explicit");
        let mut last = self.state.dt;
        let mut turn = Turn { step: number, increment: 0, times: [0.0; 2], period: explicit.period };
        while self.state.step_time < explicit.period {
            turn.increment += 1;
            let marks = step.output.marks.iter().map(|marks| marks.end(self.state.step_time, explicit.period));
            let end = marks.fold(explicit.period, f64::min);
            let left = end - self.state.step_time;
            let dt = increment_size(&explicit, procedure.stable().increment(), (last, left));
            self.judge_increment(&procedure.stable(), dt).map_err(|halted| self.failure(&turn, halted))?;
            last = dt;
            turn.times[0] = self.state.step_time;
            let reaches = dt >= left;
            let advanced = procedure.advance(&mut self.scene.terms(), self.state, dt);
            advanced.map_err(|halt| self.failure(&turn, in_words(self.scene, &halt)))?;
            if reaches {
                self.state.step_time = end;
            }
            turn.times[1] = self.state.step_time;
            self.certificate.increments += 1;
            if mass_scaling::is_due(step, &turn) {
                let stable = mass_scaling::again(self.scene, step, explicit.bulk_viscosity[0]);
                procedure
                    .weigh(&mut self.scene.terms(), self.state, stable)
                    .map_err(|halt| failure((number, self.state.step_time), in_words(self.scene, &halt)))?;
            }
            let at = moment((model, self.scene), self.state, procedure, fixed);
            let Left { balance, has_frame } = self.record.increment(at, &turn, &step.output)?;
            let Some(balance) = balance else { continue };
            self.certificate.explicit = Some(balance);
            if has_frame || self.told.elapsed() >= QUIET {
                let (increment, step_time) = (turn.increment, self.state.step_time);
                observer.event(Event::Frame(&Frame { step: number, increment, step_time, dt, balance }));
                self.told = Instant::now();
            }
            let most = SWELL[usize::from(matches!(explicit.increment, IncrementChoice::Fixed(_)))];
            // What is no number is no sound energy.
            let is_sound = balance.drift() < DRIFT && balance.swell() < most;
            if !is_sound {
                let halted = self.drifted(&balance, (dt, &procedure.stable()));
                return Err(self.failure(&turn, halted));
            }
        }
        Ok(())
    }

    /// Why an increment of length `dt` [T] cannot be, with what its terms say of it.
    fn judge_increment(&mut self, stable: &Advance, dt: f64) -> Result<(), Halted> {
        if !dt.is_finite() {
            return Err(Halted {
                reason: "no element has both mass and stiffness: no increment is the largest stable one".into(),
                help: "give one: *DYNAMIC, EXPLICIT, DIRECT USER CONTROL",
            });
        }
        let largest = stable.stable.max(self.largest);
        if largest.is_finite() {
            self.largest = largest;
        }
        if stable.stable < COLLAPSE * self.largest {
            return Err(Halted {
                reason: format!(
                    "the stable increment has shrunk from {} to {}{}",
                    scientific(self.largest, 4),
                    scientific(stable.stable, 4),
                    of_element(&self.scene.structure, stable)
                ),
                help: "an element is pressed flat: a finer mesh there, a stiffer law, or less of what presses it",
            });
        }
        Ok(())
    }

    /// Energies are not sound, after an increment of length `dt` [T].
    fn drifted(&self, balance: &Balance, (dt, stable): (f64, &Advance)) -> Halted {
        let scientific = |value| scientific(value, 4);
        let mut reason = match balance.drift() {
            drift if drift < DRIFT => {
                let (times, given) = (balance.swell(), scientific(balance.given));
                format!("the motion has {times:.0} times the energy that there was or came from outside, {given}")
            }
            drift => {
                let (percent, largest) = (100.0 * drift, scientific(balance.largest));
                format!("the energy balance is off by {percent:.1} % of the largest energy, {largest}")
            }
        };
        if dt > stable.increment() {
            reason += &format!(
                "; the increment, {}, is longer than the stable one, {}{}",
                scientific(dt),
                scientific(stable.increment()),
                of_element(&self.scene.structure, stable)
            );
        }
        Halted {
            reason,
            help: "smaller increments (SCALE FACTOR, DIRECT USER CONTROL), *BULK VISCOSITY, or a motion that has an end",
        }
    }

    /// With the increment, and the energies at the last look at them.
    fn failure(&self, turn: &Turn, halted: Halted) -> JobFailure {
        let e = |value: f64| scientific(value, 3);
        let energies = self.certificate.explicit.map_or(String::new(), |b| {
            let (kinetic, internal, work) = (e(b.kinetic), e(b.internal()), e(b.work));
            format!("; energy in motion {kinetic}, in the elements {internal}, work {work}")
        });
        let reason = format!("in increment {}: {}{energies}", turn.increment, halted.reason);
        failure((turn.step, self.state.step_time), Halted { reason, ..halted })
    }
}

/// Why a run cannot go on, and what helps.
struct Halted {
    reason: String,
    help: &'static str,
}

/// `, fastest element 7`.
fn of_element(structure: &Structure, stable: &Advance) -> String {
    stable.element.map_or(String::new(), |cell| format!(", fastest element {}", structure.mesh.cell_name(cell)))
}

fn moment<'a>(
    (model, scene): (&'a Model, &'a Scene),
    state: &'a State,
    procedure: &'a CentralDifference,
    fixed: &'a [bool],
) -> Moment<'a> {
    Moment { model, scene, state, procedure, fixed }
}

fn failure((step, time): (usize, f64), Halted { reason, help }: Halted) -> JobFailure {
    JobFailure::Step { step, time, reason, help: format!("help: {help}") }
}

/// Why terms cannot go on, with the labels of the deck.
fn in_words(scene: &Scene, halt: &Halt) -> Halted {
    let mesh = &scene.structure.mesh;
    let node = |freedom: usize| mesh.point_name(scene.freedoms.node(freedom) as u32);
    match *halt {
        Halt::Inverted { cell } => Halted {
            reason: format!("element {} has turned inside out", mesh.cell_name(cell)),
            help: "a finer mesh there, a smaller velocity, or a smaller SCALE FACTOR",
        },
        Halt::Unbounded { freedom } => Halted {
            reason: format!(
                "the force on node {} in direction {} has no end",
                node(freedom),
                scene.freedoms.component(freedom) + 1
            ),
            help: "smaller increments (SCALE FACTOR, DIRECT USER CONTROL), or loads and materials that are finite",
        },
        Halt::Massless { freedom } => Halted {
            reason: format!(
                "node {} has no mass in direction {}",
                node(freedom),
                scene.freedoms.component(freedom) + 1
            ),
            help: match scene.freedoms.component(freedom) {
                0..3 => "*DENSITY, *MASS, or hold it by *BOUNDARY",
                _ => "*ROTARY INERTIA, or hold it by *BOUNDARY",
            },
        },
        Halt::Spinning { freedom } => Halted {
            reason: format!("node {} turns too far in an increment", node(freedom)),
            help: "smaller increments: a fraction of a turn each",
        },
    }
}

/// The next increment [T]: the deck's, or the stable one, growing slowly; the last two before the end of the step, or a time mark,
/// share what is left.
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
