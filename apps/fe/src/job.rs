//! The straight line: deck, model, terms; step by step, increment by increment; results and certificate.

use crate::certificate::RunCertificate;
use crate::course::Course;
use crate::explicit;
use crate::observer::{Event, Observer};
use crate::recorder::{self, Recorder};
use crate::step_run::StepRun;
use crate::terms::Terms;
use fe_core::procedure::Converged;
use fe_core::procedure::system::Scene;
use fe_core::step::{self, Controls, Increments};
use fe_io::model::Step;
use fe_io::{Deck, Library, Model, resolve};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Why a job did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum JobFailure {
    /// The deck or a mesh has faults; the text holds them all.
    #[error("{0}")]
    Deck(String),
    /// A step ended before its time.
    #[error("step {step} ended at step time {time:.6e}: {reason}\n{help}")]
    Step {
        /// Number, from 1.
        step: usize,
        /// Step time of the last converged increment [T].
        time: f64,
        /// What happened.
        reason: String,
        /// What usually helps.
        help: String,
    },
    /// Results could not be written.
    #[error("{0}")]
    Results(#[from] fe_io::results::ResultsError),
}

/// What a finished job leaves.
#[derive(Debug)]
pub struct Report {
    /// Certificate of the run.
    pub certificate: RunCertificate,
    /// Last converged state.
    pub last: Converged,
    /// Results file.
    pub results: PathBuf,
}

/// Reads, checks and runs a deck. Results stand beside it and replace those of an earlier run once deck and
/// meshes have been read and checked.
pub fn run(deck: &Path, library: &Library, observer: &mut dyn Observer) -> Result<Report, JobFailure> {
    let start = Instant::now();
    let cards = Deck::read(deck).map_err(|faults| JobFailure::Deck(faults.to_string()))?;
    let model = resolve(&cards, library).map_err(|faults| JobFailure::Deck(faults.to_string()))?;
    spare_sources(deck, &cards)?;
    // A job needs the model alone, not the text it stood in.
    drop(cards);
    let read = start.elapsed().as_secs_f64();
    run_model(&model, deck, read, observer)
}

/// Results never replace a file that the deck is made of.
fn spare_sources(job: &Path, cards: &Deck) -> Result<(), JobFailure> {
    let there = |path: &Path| path.canonicalize().ok();
    for results in [recorder::fields_path(job), recorder::tables_path(job)] {
        let same = |name: &str| there(Path::new(name)).is_some_and(|source| there(&results).as_ref() == Some(&source));
        if let Some(source) = cards.sources.iter().find(|source| same(&source.name)) {
            let name = &source.name;
            return Err(JobFailure::Deck(format!(
                "error: `{name}` is part of the deck, and results of this job would replace it\nhelp: give the file another ending, say .inp"
            )));
        }
    }
    Ok(())
}

/// Runs a model; results are named after `job`, with other endings. `read` are the seconds spent on reading.
pub fn run_model(model: &Model, job: &Path, read: f64, observer: &mut dyn Observer) -> Result<Report, JobFailure> {
    let start = Instant::now();
    if model.steps.iter().any(|step| matches!(step.procedure, step::Procedure::Explicit(_))) {
        return explicit::run_model(model, job, read, observer);
    }
    let mut terms = Terms::new(model).map_err(JobFailure::Deck)?;
    model.notes.iter().chain(&terms.notes).for_each(|note| observer.event(Event::Note(note)));
    let mut recorder = Recorder::create(job, model, &terms)?;
    let mut at = terms.rest();
    recorder.start(&terms, &at)?;
    let mut certificate = RunCertificate::default();
    let ended = steps(model, &mut terms, &mut at, &mut certificate, (&mut *observer, &mut recorder));
    certificate.seconds.read = read;
    certificate.seconds.search = terms.search_seconds;
    certificate.seconds.write = recorder.seconds();
    certificate.seconds.total = read + start.elapsed().as_secs_f64();
    certificate.peak_memory = fe_io::memory::peak();
    let results = recorder.path();
    let closed = recorder.finish(&certificate, at.total_time, if ended.is_ok() { "completed" } else { "failed" });
    // Where the results could not be written, the first reason tells more than that the file is shut.
    ended?;
    closed?;
    observer.event(Event::Done(&certificate));
    Ok(Report { certificate, last: at, results })
}

/// Increments and controls of a static step; a step of another kind is refused.
pub fn static_procedure(step: &Step) -> Result<(Increments, Controls), JobFailure> {
    match step.procedure {
        step::Procedure::Static { increments, controls } => Ok((increments, controls)),
        step::Procedure::Explicit(_) => {
            let fe_io::model::Place { file, line } = &step.place;
            Err(JobFailure::Deck(format!(
                "error: explicit steps are not there yet\n --> {file}:{line}\nhelp: static steps are there: `*STATIC`"
            )))
        }
    }
}

/// All steps, one after the other; `at` is the last converged state, also where a step fails.
fn steps(
    model: &Model,
    terms: &mut Terms,
    at: &mut Converged,
    certificate: &mut RunCertificate,
    (observer, recorder): (&mut dyn Observer, &mut Recorder),
) -> Result<(), JobFailure> {
    let mut course = Course::new(model);
    for (index, step) in model.steps.iter().enumerate() {
        let number = index + 1;
        enter(model, terms, index, &mut course, at);
        StepRun { terms, step, number, observer, recorder }.run(&course, at, certificate)?;
    }
    Ok(())
}

/// Enters a step, by its index, from the state that it starts with: what it says of contacts, supports and loads holds from
/// now on.
pub fn enter(model: &Model, terms: &mut Terms, index: usize, course: &mut Course, at: &mut Converged) {
    let step = &model.steps[index];
    let initial: &[_] = if index == 0 { &model.supports } else { &[] };
    let released = terms.enter(step, at);
    course.enter(initial, step, &terms.freedoms, at);
    course.release(released);
    terms.hold(&course.prescribed().into_iter().collect());
}

/// The scene of a step that was entered: what acts in it.
pub fn scene<'a>(terms: &'a Terms, step: &Step, course: &Course) -> Result<Scene<'a>, JobFailure> {
    let external = course
        .external(&terms.structure, &terms.freedoms)
        .map_err(|error| JobFailure::Deck(format!("{}:{}: {error}", step.place.file, step.place.line)))?;
    Ok(Scene {
        freedoms: &terms.freedoms,
        terms: terms.all(),
        external,
        prescribed: course.prescribed(),
        period: step.procedure.period(),
    })
}
