//! A job that ends well, and what it leaves.

use super::Scratch;
use super::results::Results;
use fe_io::results::read::{Table, tables};

/// Half a unit of the last of the ten digits that tables have.
pub const PRINTED: f64 = 5e-10;

/// Relative bound of a discrete problem that has the closed answer.
pub const ALGEBRAIC: f64 = 1e-10;

/// A job that ended well, in its folder.
pub struct Job {
    scratch: Scratch,
    /// What it printed.
    pub told: String,
}

impl Job {
    /// Runs a deck in a folder of this name; fails with the program's message.
    pub fn run(name: &str, deck: &str) -> Self {
        Job::run_in(Scratch::new(name), deck)
    }

    /// In a folder that holds what the deck includes.
    pub fn run_in(scratch: Scratch, deck: &str) -> Self {
        scratch.write("job.inp", deck);
        let run = scratch.fe(&["run", "job.inp"]);
        assert_eq!(run.status, 0, "{}\n{deck}", run.error);
        Job { scratch, told: run.output + &run.error }
    }

    /// Its plan.
    pub fn plan(&self) -> String {
        self.scratch.fe(&["check", "job.inp"]).output
    }

    /// Its results file.
    pub fn results(&self) -> Results {
        Results::open(&self.scratch.path("job.vtkhdf"))
    }

    /// Its tables.
    pub fn tables(&self) -> Vec<Table> {
        tables(&self.scratch.read("job.dat")).unwrap()
    }

    /// A component (from 1) of the first row of all tables whose title begins like this, of a set; not a number where a
    /// table is empty.
    pub fn all(&self, title: &str, set: &str, component: usize) -> Vec<f64> {
        let tables = self.tables();
        let wanted = tables.iter().filter(|table| table.title.starts_with(title) && table.set == set);
        wanted.map(|table| table.rows.first().map_or(f64::NAN, |row| row.values[component - 1])).collect()
    }

    /// The last of them.
    pub fn last(&self, title: &str, set: &str, component: usize) -> f64 {
        *self.all(title, set, component).last().unwrap_or_else(|| panic!("no table {title} of {set}"))
    }
}

/// Fails where a number is farther than `bound` from the expected one.
pub fn close(what: &str, got: impl AsRef<[f64]>, expected: impl AsRef<[f64]>, bound: f64) {
    judge(what, [got.as_ref(), expected.as_ref()], |_| bound);
}

/// Fails where a number is farther than `bound` times its size from the expected one.
pub fn relative(what: &str, got: impl AsRef<[f64]>, expected: impl AsRef<[f64]>, bound: f64) {
    judge(what, [got.as_ref(), expected.as_ref()], |size| bound * size.abs());
}

fn judge(what: &str, [got, expected]: [&[f64]; 2], bound: impl Fn(f64) -> f64) {
    let near = |(g, e): (&f64, &f64)| (g - e).abs() <= bound(*e);
    let fits = got.len() == expected.len() && got.iter().zip(expected).all(near);
    assert!(fits, "{what}: {got:?}, not {expected:?}");
}
