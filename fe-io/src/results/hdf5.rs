//! The results file: a temporal VTKHDF unstructured grid (format document of VTK, version 2.0), and histories
//! below `/Signorini`.
//!
//! Every increment is complete in the file before the next begins, and no lock is held between: a viewer may open
//! the file of a running job, and a job that is killed leaves all its finished increments. To that end frames
//! begin with a chunk (a compressed chunk is never rewritten), and a frame comes in two steps: its rows, then
//! its time together with the count of frames.

use super::container::{Attribute, Container, Numbers, Owner, RustHdf5, Series, aligned_chunk};
use super::error::ResultsError;
use super::fields::{FieldInfo, Location};
use super::grid::Grid;
use super::history::{self, HistoryInfo, HistoryRow};
use super::steps;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The job, as the file's reader should know it.
#[derive(Clone, Copy, Debug, Default)]
pub struct JobInfo<'a> {
    /// Name of the job.
    pub job: &'a str,
    /// `*HEADING`.
    pub heading: &'a str,
    /// Version of the program.
    pub version: &'a str,
}

/// One stored increment.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Total time [T].
    pub time: f64,
    /// Step, from 1; 0 for the state before the first.
    pub step: usize,
    /// Increment in the step, from 1; 0 for the state before the first.
    pub increment: usize,
    /// Values of each declared field, `[rows × width]`, in the order of declaration; NaN where not defined.
    pub fields: &'a [&'a [f64]],
}

/// The results file of a job. Open only while something is added.
#[derive(Debug)]
pub struct ResultsFile {
    path: PathBuf,
    fields: Vec<FieldInfo>,
    histories: Vec<HistoryInfo>,
    points: usize,
    cells: usize,
    frames: usize,
    /// Where the file is until its first frame is complete.
    unfinished: Option<PathBuf>,
    halted: bool,
    /// Rows of histories that wait to be written, and since when.
    kept: BTreeMap<String, Vec<f64>>,
    since: Option<Instant>,
}

/// Longest time that rows of histories wait: opening and closing the file takes some milliseconds.
const LONGEST_WAIT: Duration = Duration::from_secs(1);

/// Sessions in which the container moves the headers that have grown to where they stay.
const SETTLING_SESSIONS: usize = 2;

/// The least version that knows temporal unstructured grids.
const VTKHDF_VERSION: [i64; 2] = [2, 0];

impl ResultsFile {
    /// Creates the file with its grid and no frame. It is at `path`, and an earlier file there replaced, as soon as
    /// its first frame is complete: viewers do not open a file without one.
    pub fn create(
        path: &Path,
        job: JobInfo,
        grid: &Grid,
        fields: &[FieldInfo],
        histories: &[HistoryInfo],
    ) -> Result<Self, ResultsError> {
        grid.check()?;
        history::check(histories)?;
        check_names(fields, grid)?;
        let unfinished = beside(path);
        let file = RustHdf5::create(&unfinished)?;
        write_start(&file, job, grid, fields, histories)?;
        file.close(true)?;
        Ok(ResultsFile {
            path: path.into(),
            fields: fields.to_vec(),
            histories: histories.to_vec(),
            points: grid.points.len(),
            cells: grid.cells(),
            frames: 0,
            unfinished: Some(unfinished),
            halted: false,
            kept: BTreeMap::new(),
            since: None,
        })
    }

    /// Where the file is from its first frame on.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The fields, in the order in which a frame holds them.
    pub fn fields(&self) -> &[FieldInfo] {
        &self.fields
    }

    /// Number of stored frames.
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// Numbers that a frame holds of a field: rows × width.
    pub fn values_of(&self, field: &FieldInfo) -> usize {
        self.rows(field.location) * field.width()
    }

    /// Adds a frame and rows of histories at the same increment.
    pub fn append(&mut self, frame: &Frame, rows: &[HistoryRow]) -> Result<(), ResultsError> {
        self.check_rows(rows)?;
        ResultsError::length("fields of the frame", self.fields.len(), frame.fields.len())?;
        for (field, values) in self.fields.iter().zip(frame.fields) {
            ResultsError::length(format!("field {}", field.name), self.values_of(field), values.len())?;
        }
        self.write_kept()?;
        self.session(|this, file| {
            for (field, values) in this.fields.iter().zip(frame.fields) {
                this.append_field(file, field, values)?;
            }
            let first_row = |location| this.frames * aligned_chunk(this.rows(location)).frame_rows;
            steps::append(file, &this.fields, first_row)?;
            let head = [frame.time, frame.step as f64, frame.increment as f64];
            history::append(file, head, HistoryRow { name: history::FRAMES, values: &[] })?;
            rows.iter().try_for_each(|&row| history::append(file, head, row))
        })?;
        self.session(|this, file| steps::commit(file, this.frames + 1, frame.time))?;
        self.frames += 1;
        self.take_its_name()
    }

    /// Adds rows of histories at an increment that is not stored as a frame.
    pub fn append_history(
        &mut self,
        time: f64,
        step: usize,
        increment: usize,
        rows: &[HistoryRow],
    ) -> Result<(), ResultsError> {
        self.keep_history(time, step, increment, rows)?;
        self.write_kept()
    }

    /// The same of increments that follow each other fast: rows are written together, after a second or with what comes next.
    pub fn keep_history(
        &mut self,
        time: f64,
        step: usize,
        increment: usize,
        rows: &[HistoryRow],
    ) -> Result<(), ResultsError> {
        self.check_rows(rows)?;
        for row in rows {
            let kept = self.kept.entry(row.name.to_owned()).or_default();
            kept.extend([time, step as f64, increment as f64]);
            kept.extend(row.values);
        }
        let since = *self.since.get_or_insert_with(Instant::now);
        if since.elapsed() >= LONGEST_WAIT { self.write_kept() } else { Ok(()) }
    }

    fn write_kept(&mut self) -> Result<(), ResultsError> {
        self.since = None;
        let kept = std::mem::take(&mut self.kept);
        if kept.is_empty() {
            return Ok(());
        }
        self.session(|_, file| kept.iter().try_for_each(|(name, rows)| history::append_rows(file, name, rows)))
    }

    /// Notes how the job ended (`completed`, `failed`; until then the file says `running`) and waits for the disk.
    pub fn finish(mut self, outcome: &str) -> Result<(), ResultsError> {
        self.write_kept()?;
        self.take_its_name()?;
        let file = RustHdf5::open(&self.path)?;
        file.attribute(Owner::Group("Signorini"), "outcome", Attribute::Text(outcome))?;
        file.close(true)
    }

    fn take_its_name(&mut self) -> Result<(), ResultsError> {
        let Some(unfinished) = &self.unfinished else { return Ok(()) };
        for _ in 0..SETTLING_SESSIONS {
            RustHdf5::open(unfinished)?.close(false)?;
        }
        std::fs::rename(unfinished, &self.path).map_err(|e| ResultsError::file(&self.path, e))?;
        self.unfinished = None;
        Ok(())
    }

    fn rows(&self, location: Location) -> usize {
        match location {
            Location::Point => self.points,
            Location::Cell => self.cells,
        }
    }

    fn check_rows(&self, rows: &[HistoryRow]) -> Result<(), ResultsError> {
        for row in rows {
            let history = self.histories.iter().find(|h| h.name == row.name);
            let history = history.ok_or_else(|| ResultsError::UnknownHistory(row.name.into()))?;
            ResultsError::length(format!("history {}", row.name), history.columns.len(), row.values.len())?;
        }
        Ok(())
    }

    /// Opens the file, adds to it and closes it; after a failure nothing more is added.
    fn session(&mut self, add: impl FnOnce(&Self, &RustHdf5) -> Result<(), ResultsError>) -> Result<(), ResultsError> {
        if self.halted {
            return Err(ResultsError::Halted(self.path.clone()));
        }
        self.halted = true;
        let file = RustHdf5::open(self.unfinished.as_ref().unwrap_or(&self.path))?;
        add(self, &file)?;
        file.close(false)?;
        self.halted = false;
        Ok(())
    }

    fn append_field(&self, file: &RustHdf5, field: &FieldInfo, values: &[f64]) -> Result<(), ResultsError> {
        let frame_rows = aligned_chunk(self.rows(field.location)).frame_rows;
        if frame_rows == 0 {
            return Ok(());
        }
        let path = field_path(field);
        let padded = frame_rows * field.width();
        if padded == values.len() {
            return file.append(&path, Numbers::Real(values));
        }
        let mut padded_values = Vec::with_capacity(padded);
        padded_values.extend_from_slice(values);
        padded_values.resize(padded, f64::NAN);
        file.append(&path, Numbers::Real(&padded_values))
    }
}

/// What has no frame yet is of no use to anyone.
impl Drop for ResultsFile {
    fn drop(&mut self) {
        if let Some(unfinished) = &self.unfinished {
            // Where it cannot be removed it stays, under a name that tells.
            let _ = std::fs::remove_file(unfinished);
        }
    }
}

fn field_path(field: &FieldInfo) -> String {
    format!("VTKHDF/{}/{}", field.location.group(), field.name)
}

/// The name under which a file is made before it takes its own.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".unfinished");
    name.into()
}

fn check_names(fields: &[FieldInfo], grid: &Grid) -> Result<(), ResultsError> {
    for (i, field) in fields.iter().enumerate() {
        let same = |name: &str, location| name == field.name && location == field.location.group();
        let taken = fields[..i].iter().any(|f| same(f.name, f.location.group()))
            || grid.constant_arrays().any(|(name, group)| same(name, group));
        if field.name.is_empty() || field.name.contains(['/', '.']) || taken {
            return Err(ResultsError::Name(field.name.into()));
        }
    }
    Ok(())
}

/// Everything that is there before the first frame.
fn write_start(
    file: &RustHdf5,
    job: JobInfo,
    grid: &Grid,
    fields: &[FieldInfo],
    histories: &[HistoryInfo],
) -> Result<(), ResultsError> {
    for group in ["VTKHDF", "VTKHDF/PointData", "VTKHDF/CellData", "Signorini", "Signorini/History"] {
        file.group(group)?;
    }
    file.attribute(Owner::Group("VTKHDF"), "Version", Attribute::Integers(&VTKHDF_VERSION))?;
    file.attribute(Owner::Group("VTKHDF"), "Type", Attribute::Ascii("UnstructuredGrid"))?;
    grid.write(file)?;
    for field in fields {
        write_field(file, field, grid)?;
    }
    for (name, text) in [("version", job.version), ("job", job.job), ("heading", job.heading), ("outcome", "running")] {
        file.attribute(Owner::Group("Signorini"), name, Attribute::Text(text))?;
    }
    let frames = HistoryInfo {
        name: history::FRAMES.into(),
        columns: Vec::new(),
        units: Vec::new(),
        meaning: "the stored frames, in order".into(),
    };
    history::create(file, &frames)?;
    histories.iter().try_for_each(|history| history::create(file, history))?;
    steps::create(file, fields, grid)
}

fn write_field(file: &RustHdf5, field: &FieldInfo, grid: &Grid) -> Result<(), ResultsError> {
    let rows = if field.location == Location::Point { grid.points.len() } else { grid.cells() };
    let path = field_path(field);
    let chunk_rows = aligned_chunk(rows).rows;
    file.real_series(&path, Series { columns: field.width(), chunk_rows, compressed: true })?;
    file.attribute(Owner::Array(&path), "unit", Attribute::Text(field.unit))?;
    file.attribute(Owner::Array(&path), "meaning", Attribute::Text(field.meaning))?;
    if !field.components.is_empty() {
        file.attribute(Owner::Array(&path), "components", Attribute::Texts(field.components))?;
    }
    Ok(())
}
