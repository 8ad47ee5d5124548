//! Writes a job's results: frames and histories of the results file, and the printed tables.

use crate::certificate::{COLUMNS, Certificate, RunCertificate};
use crate::contact_fields::{self, Shown};
use crate::fields::{Recovered, Source, needs_recovery};
use crate::histories;
use crate::printed::{self, Printed};
use crate::terms::Terms;
use fe_contact::state::{ContactState, NodeValues};
use fe_contact::summary::MeasureKind;
use fe_core::increment::Attempt;
use fe_core::procedure::Converged;
use fe_core::structure::Structure;
use fe_io::Model;
use fe_io::model::{Frames, Step};
use fe_io::results::fields::{FIELDS, is_usual, requested};
use fe_io::results::history::CERTIFICATE;
use fe_io::results::{self, FieldInfo, Grid, GridBlock, HistoryInfo, HistoryRow, JobInfo, ResultsError, ResultsFile};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A converged increment, with what stands beside it.
pub struct Increment<'a> {
    /// State.
    pub at: &'a Converged,
    /// The attempt that converged.
    pub attempt: Attempt,
    /// Number of the step, from 1.
    pub step: usize,
    /// Certificate.
    pub certificate: &'a Certificate,
    /// States of the pairs.
    pub states: &'a [ContactState],
    /// Prescribed freedoms.
    pub fixed: &'a [bool],
}

/// The results file of a job.
pub fn fields_path(job: &Path) -> PathBuf {
    job.with_extension("vtkhdf")
}

/// The printed tables of a job.
pub fn tables_path(job: &Path) -> PathBuf {
    job.with_extension("dat")
}

/// The files of a job, and what goes into them.
pub struct Recorder {
    file: ResultsFile,
    printed: Printed,
    seconds: f64,
}

/// Columns of the run's certificate.
const RUN_COLUMNS: [&str; 13] = [
    "increments",
    "cutbacks",
    "iterations",
    "factorisations",
    "seconds_read",
    "seconds_search",
    "seconds_order",
    "seconds_assemble",
    "seconds_factor",
    "seconds_solve",
    "seconds_write",
    "seconds_total",
    "peak_memory",
];
/// Name of the run's certificate.
pub const RUN: &str = "Run";

impl Recorder {
    /// Creates the files: the job's name with other endings.
    pub fn create(job: &Path, model: &Model, terms: &Terms) -> Result<Self, ResultsError> {
        let start = Instant::now();
        let held = (chosen_fields(model, terms), histories(terms));
        let file = results_file(job, model, &terms.structure, held)?;
        let printed = Printed::create(&tables_path(job))?;
        Ok(Recorder { file, printed, seconds: start.elapsed().as_secs_f64() })
    }

    /// Where the results file is.
    pub fn path(&self) -> PathBuf {
        self.file.path().to_path_buf()
    }

    /// Seconds spent on writing.
    pub fn seconds(&self) -> f64 {
        self.seconds
    }

    /// The frame at time 0.
    pub fn start(&mut self, terms: &Terms, at: &Converged) -> Result<(), ResultsError> {
        let states = terms.states(at);
        let fixed = vec![false; at.u.len()];
        let start = Instant::now();
        let recovered = self.file.fields().iter().any(needs_recovery).then(|| Recovered::at(terms, &at.u));
        let nodes = at_nodes(terms, &states);
        let contacts: Vec<Shown> = states.iter().zip(&nodes).map(|(state, nodes)| (state, nodes.as_slice())).collect();
        let source =
            Source { terms, at, fixed: &fixed, states: &states, contacts: &contacts, recovered: recovered.as_ref() };
        self.frame(&source, (0, 0), &[])?;
        self.seconds += start.elapsed().as_secs_f64();
        Ok(())
    }

    /// A converged increment: its histories, its frame where the step asks for one, its tables.
    pub fn increment(&mut self, terms: &Terms, step: &Step, now: &Increment) -> Result<(), ResultsError> {
        let start = Instant::now();
        let times = [now.attempt.step_time - now.attempt.dt, now.attempt.step_time];
        let due = |when: &Frames| when.hold(now.attempt.increment, times, step.procedure.period());
        let stored = due(&step.output.frames);
        let tables: Vec<_> = step.output.tables.iter().filter(|table| due(&table.when)).collect();
        let recover = stored && self.file.fields().iter().any(needs_recovery)
            || tables.iter().any(|t| printed::needs_recovery(t));
        let recovered = recover.then(|| Recovered::at(terms, &now.at.u));
        let nodes = if stored { at_nodes(terms, now.states) } else { Vec::new() };
        let contacts: Vec<Shown> =
            now.states.iter().zip(&nodes).map(|(state, nodes)| (state, nodes.as_slice())).collect();
        let (at, fixed, states) = (now.at, now.fixed, now.states);
        let source = Source { terms, at, fixed, states, contacts: &contacts, recovered: recovered.as_ref() };
        let certificate = now.certificate.row();
        let pairs: Vec<(String, Vec<f64>)> =
            history_names(terms).into_iter().zip(now.states.iter().map(histories::row)).collect();
        let mut rows = vec![HistoryRow { name: CERTIFICATE, values: &certificate }];
        rows.extend(pairs.iter().map(|(name, values)| HistoryRow { name, values }));
        if stored {
            self.frame(&source, (now.step, now.attempt.increment), &rows)?;
        } else {
            self.file.append_history(now.at.total_time, now.step, now.attempt.increment, &rows)?;
        }
        self.printed.tables(&source, &tables)?;
        self.seconds += start.elapsed().as_secs_f64();
        Ok(())
    }

    fn frame(
        &mut self,
        source: &Source,
        (step, increment): (usize, usize),
        rows: &[HistoryRow],
    ) -> Result<(), ResultsError> {
        let values: Vec<Vec<f64>> = self.file.fields().iter().map(|field| source.values(field)).collect();
        let fields: Vec<&[f64]> = values.iter().map(Vec::as_slice).collect();
        self.file.append(&results::Frame { time: source.at.total_time, step, increment, fields: &fields }, rows)
    }

    /// The end of a job: its certificate, and how it ended.
    pub fn finish(mut self, certificate: &RunCertificate, time: f64, outcome: &str) -> Result<(), ResultsError> {
        let (s, p) = (certificate.seconds, certificate.seconds.procedure);
        let counts = [certificate.increments, certificate.cutbacks, certificate.iterations, certificate.factorisations];
        let mut row = counts.map(|n| n as f64).to_vec();
        row.extend([s.read, s.search, p.order, p.assemble, p.factor, p.solve, s.write, s.total]);
        row.push(certificate.peak_memory.map_or(f64::NAN, |bytes| bytes as f64));
        self.file.append_history(time, 0, 0, &[HistoryRow { name: RUN, values: &row }])?;
        self.file.finish(outcome)
    }
}

/// Results of all contacts at their nodes.
fn at_nodes(terms: &Terms, states: &[ContactState]) -> Vec<Vec<NodeValues>> {
    terms.contacts.iter().zip(states).map(|(pair, state)| pair.node_values(state)).collect()
}

/// The results file of a job on these bodies, with fields and histories.
pub fn results_file(
    job: &Path,
    model: &Model,
    structure: &Structure,
    (fields, histories): (Vec<FieldInfo>, Vec<HistoryInfo>),
) -> Result<ResultsFile, ResultsError> {
    let mesh = &structure.mesh;
    let blocks: Vec<GridBlock> = mesh
        .blocks
        .iter()
        .map(|block| GridBlock { kind: block.kind, labels: &block.labels, nodes: &block.nodes })
        .collect();
    let body = sections_of_cells(structure);
    let grid = Grid {
        points: &mesh.points,
        node_labels: &mesh.point_labels,
        blocks: &blocks,
        body: &body,
        instances: &mesh.instances,
    };
    let name = job.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let info = JobInfo { job: &name, heading: &model.heading, version: env!("CARGO_PKG_VERSION") };
    ResultsFile::create(&fields_path(job), info, &grid, &fields, &histories)
}

/// Section of each cell, in the mesh's order.
fn sections_of_cells(structure: &Structure) -> Vec<u32> {
    let mesh = &structure.mesh;
    let first = mesh.first_cells();
    let mut body = vec![0; mesh.cell_count()];
    for (index, cells) in structure.section_cells().enumerate() {
        for cell in cells {
            body[first[cell.block as usize] + cell.cell as usize] = index as u32;
        }
    }
    body
}

/// The fields that any step asks for; all that make sense where none chooses. No contact field without a contact, none of a
/// kind of number that no point has, none of shear and slip without friction, no section force without a line.
pub fn chosen_fields(model: &Model, terms: &Terms) -> Vec<FieldInfo> {
    let wanted = |field: &FieldInfo| {
        model.steps.iter().any(|step| match &step.output.fields {
            None => is_usual(field),
            Some(words) => words.iter().any(|word| requested(word).contains(&field)),
        })
    };
    let rubs = terms.contacts.iter().any(|pair| pair.friction().is_some());
    let first = terms.contacts.first().map(|contact| contact.summary().measure);
    let points = terms.contacts.iter().flat_map(|contact| &contact.points);
    let mut kinds: Vec<MeasureKind> = first.into_iter().collect();
    for kind in points.map(|point| MeasureKind::of(point.measure)) {
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let there = |field: &FieldInfo| match field.name {
        "V" | "PEEQ" => false,
        "SF" | "SM" => !terms.structure.lines.is_empty(),
        name if name.starts_with('C') => contact_fields::has(field, &kinds, rubs),
        _ => true,
    };
    FIELDS.iter().filter(|f| wanted(f) && there(f)).copied().collect()
}

/// Names of the pairs' histories.
fn history_names(terms: &Terms) -> Vec<String> {
    histories::names(terms.contacts.iter().map(|pair| pair.name()))
}

fn histories(terms: &Terms) -> Vec<HistoryInfo> {
    let own = |words: &[&str]| words.iter().map(|w| w.to_string()).collect::<Vec<_>>();
    let mut list = vec![
        HistoryInfo {
            name: CERTIFICATE.into(),
            columns: own(&COLUMNS.map(|c| c.0)),
            units: own(&COLUMNS.map(|c| c.1)),
            meaning: "what was checked of each increment".into(),
        },
        run_info(&RUN_COLUMNS),
    ];
    list.extend(history_names(terms).iter().map(|name| histories::info(name)));
    list
}

/// What the results file says of the run's certificate, whose columns are these.
pub fn run_info(columns: &[&str]) -> HistoryInfo {
    let unit = |name: &&str| match *name {
        name if name.starts_with("seconds") => "s".to_owned(),
        "peak_memory" => "byte".to_owned(),
        _ => "1".to_owned(),
    };
    HistoryInfo {
        name: RUN.into(),
        columns: columns.iter().map(|name| name.to_string()).collect(),
        units: columns.iter().map(unit).collect(),
        meaning: "what the whole run took".into(),
    }
}
