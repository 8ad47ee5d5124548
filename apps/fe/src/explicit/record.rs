//! Results of explicit jobs: frames, histories, tables, each when it is due.

use super::contact;
use super::energies::{Balance, Energies};
use super::scene::Scene;
use super::series::{self, Series};
use super::values::{Moment, Values};
use crate::certificate::RunCertificate;
use crate::contact_fields;
use crate::recorder::{RUN, results_file, run_info, tables_path};
use fe_contact::summary::MeasureKind;
use fe_io::Model;
use fe_io::model::{Frames, History, Output};
use fe_io::results::fields::{FIELDS, is_usual, requested};
use fe_io::results::table::Tables;
use fe_io::results::{self, FieldInfo, HistoryRow, Location, ResultsError, ResultsFile};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Increments from one look at the balance of energies to the next: a look costs about as much as an increment of contact.
const LOOK: usize = 100;

/// Columns of the run's certificate: seconds of elements are those of all that acts besides contact.
const RUN_COLUMNS: [&str; 9] = [
    "increments",
    "elements",
    "seconds_read",
    "seconds_increments",
    "seconds_elements",
    "seconds_contact",
    "seconds_write",
    "seconds_total",
    "peak_memory",
];

/// Which increment it is that has ended.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Number of the step, from 1; 0 before the first.
    pub step: usize,
    /// Number in the step, from 1; 0 before the first.
    pub increment: usize,
    /// Step times [T] at which it began and ended.
    pub times: [f64; 2],
    /// Step time [T] of the whole step.
    pub period: f64,
}

impl Turn {
    /// Before the first step: everything is stored.
    pub const START: Turn = Turn { step: 0, increment: 0, times: [0.0; 2], period: 0.0 };

    /// True when something is stored or done after it.
    pub fn is_due(&self, when: &Frames) -> bool {
        when.hold(self.increment, self.times, self.period)
    }
}

/// What an increment left.
#[derive(Clone, Copy, Debug, Default)]
pub struct Left {
    /// Its energies, where they were looked at.
    pub balance: Option<Balance>,
    /// A frame was stored.
    pub has_frame: bool,
}

/// The files of a job.
pub struct Record {
    file: ResultsFile,
    tables: Tables,
    series: Vec<Series>,
    energies: Energies,
    seconds: f64,
}

impl Record {
    /// Creates them.
    pub fn create(job: &Path, model: &Model, scene: &Scene) -> Result<Self, ResultsError> {
        let series = series::of(model, &scene.structure.mesh);
        let histories = series.iter().map(|series| series.info.clone()).chain([run_info(&RUN_COLUMNS)]).collect();
        let file = results_file(job, model, &scene.structure, (fields(model, scene), histories))?;
        let tables = Tables::create(&tables_path(job))?;
        Ok(Record { file, tables, series, energies: Energies::default(), seconds: 0.0 })
    }

    /// Where the results file is.
    pub fn path(&self) -> PathBuf {
        self.file.path().to_path_buf()
    }

    /// Seconds spent on writing.
    pub fn seconds(&self) -> f64 {
        self.seconds
    }

    /// Stores and prints what is due after an increment.
    pub fn increment(&mut self, at: Moment, turn: &Turn, output: &Output) -> Result<Left, ResultsError> {
        let has_frame = turn.is_due(&output.frames);
        let due: Vec<&History> = output.histories.iter().filter(|h| turn.is_due(&h.when)).map(|h| &h.of).collect();
        let tables: Vec<_> = output.tables.iter().filter(|t| turn.step > 0 && turn.is_due(&t.when)).collect();
        let looks = has_frame || due.contains(&&History::Energies) || turn.increment.is_multiple_of(LOOK);
        if !looks && due.is_empty() && tables.is_empty() {
            return Ok(Left::default());
        }
        let start = Instant::now();
        let balance = looks.then(|| self.energies.balance(at.scene, at.state, at.procedure));
        let values = Values::at(at);
        for table in &tables {
            values.print(table, &mut self.tables)?;
        }
        if !tables.is_empty() {
            self.tables.flush()?;
        }
        let mut rows: Vec<(&str, Vec<f64>)> = Vec::new();
        for series in &self.series {
            // Energies and resultants stand beside every frame.
            let row = match (&series.of, &balance) {
                (History::Energies, Some(balance)) if has_frame || due.contains(&&History::Energies) => {
                    Some(balance.row(at.state.dt).to_vec())
                }
                _ if series.is_due(&due, has_frame) => series.row(&values),
                _ => None,
            };
            rows.extend(row.map(|row| (series.info.name.as_str(), row)));
        }
        let rows: Vec<HistoryRow> = rows.iter().map(|(name, values)| HistoryRow { name, values }).collect();
        let (time, step, increment) = (at.state.total_time, turn.step, turn.increment);
        if has_frame {
            let values: Vec<Vec<f64>> = self.file.fields().iter().map(|field| values.field(field)).collect();
            let fields: Vec<&[f64]> = values.iter().map(Vec::as_slice).collect();
            self.file.append(&results::Frame { time, step, increment, fields: &fields }, &rows)?;
        } else if !rows.is_empty() {
            self.file.keep_history(time, step, increment, &rows)?;
        }
        self.seconds += start.elapsed().as_secs_f64();
        Ok(Left { balance, has_frame })
    }

    /// The end of a job: its certificate, and how it ended.
    pub fn finish(mut self, certificate: &RunCertificate, time: f64, outcome: &str) -> Result<(), ResultsError> {
        let RunCertificate { increments, elements, spent, seconds, peak_memory, .. } = certificate;
        let mut row = vec![*increments as f64, *elements as f64];
        row.extend([seconds.read, spent.all, spent.others(), spent.contacts(), seconds.write, seconds.total]);
        row.push(peak_memory.map_or(f64::NAN, |bytes| bytes as f64));
        self.file.append_history(time, 0, 0, &[HistoryRow { name: RUN, values: &row }])?;
        self.file.finish(outcome)
    }
}

/// The fields that any step asks for, or the usual ones.
fn fields(model: &Model, scene: &Scene) -> Vec<FieldInfo> {
    let pairs = || model.steps.iter().flat_map(|step| &step.explicit_pairs);
    let general = || model.steps.iter().filter_map(|step| step.general_contact.as_ref());
    let mut kinds: Vec<MeasureKind> = general().next().map(|_| MeasureKind::Pressure).into_iter().collect();
    for kind in pairs().map(|active| contact::kind(&model.explicit_pairs[active.pair].0.secondary)) {
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let assigned = general().flat_map(|general| &general.interactions).map(|(_, interaction)| *interaction);
    let mut interactions = pairs().filter_map(|active| active.interaction).chain(assigned);
    let rubs = interactions.any(|interaction| model.interactions[interaction].friction.is_some());
    let there = |field: &&FieldInfo| match (field.name, field.location) {
        ("U" | "V" | "RF", _) => true,
        ("S" | "MISES" | "PEEQ", Location::Cell) => scene.solids.is_some(),
        (name, _) if name.starts_with('C') => contact_fields::has(field, &kinds, rubs),
        _ => false,
    };
    let wanted = |field: &&FieldInfo| {
        model.steps.iter().any(|step| match &step.output.fields {
            None => is_usual(field),
            Some(words) => words.iter().any(|word| requested(word).contains(field)),
        })
    };
    FIELDS.iter().filter(there).filter(wanted).copied().collect()
}
