//! The poured balls of `apps/fe/examples`: what an element and increment takes where everything may touch everything, and the
//! share of contact in it.

use crate::machine::{self, Origin};
use crate::measure::own_cpu;
use fe::observer::Silent;
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// The script that writes the deck.
const SCRIPT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../apps/fe/examples/poured_balls/balls.py");

/// What is poured, and how long.
#[derive(Clone, Debug, PartialEq, clap::Args)]
pub struct Options {
    /// Layers of 16 balls.
    #[arg(long, default_value_t = 8)]
    pub layers: usize,
    /// Time that is followed [s]; the first layer lands after 0.004.
    #[arg(long, default_value_t = 0.12)]
    pub time: f64,
    /// Threads.
    #[arg(long, default_value_t = 1)]
    pub threads: usize,
    /// Folder of deck and results.
    #[arg(long, default_value = "target/benchmarks/poured")]
    pub work: PathBuf,
}

/// Makes the deck, runs it, and prints what that took.
pub fn study(options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let Options { layers, time, threads, work } = options;
    std::fs::create_dir_all(work)?;
    let deck = work.join("balls.inp");
    let told = write(&deck, *layers, *time)?;
    writeln!(out, "poured balls: {}, to {time} s", told.trim())?;
    writeln!(out, "{}; {threads} thread(s)", Origin::here())?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(*threads).build()?;
    let (start, before) = (Instant::now(), own_cpu()?);
    let run = pool.install(|| fe::run(&deck, &fe::standard(), &mut Silent))?.certificate;
    let (wall, cpu) = (start.elapsed().as_secs_f64(), own_cpu()? - before);
    let Some(balance) = run.explicit else { return Err("the run has no increments".into()) };
    let titles = ["elements", "increments", "wall s", "cpu s", "µs/elem./inc.", "contact", "output", "balance", "MB"];
    writeln!(out)?;
    titles.iter().try_for_each(|title| write!(out, "{title:>14}"))?;
    let [contact, output] = [run.spent.contacts(), run.spent.output].map(|part| 100.0 * part / run.spent.all);
    let memory = run.peak_memory.map_or("-".into(), |bytes| format!("{:.0}", 1e-6 * bytes as f64));
    writeln!(
        out,
        "\n{:>14}{:>14}{wall:>14.1}{cpu:>14.1}{:>14.3}{contact:>12.1} %{output:>12.1} %{:>14.1e}{memory:>14}",
        run.elements,
        run.increments,
        run.microseconds(),
        balance.drift()
    )?;
    Ok(writeln!(out, "\nof the increments' {:.1} s: {}", run.spent.all, run.spent)?)
}

/// Writes the deck, and gives what the script says of it.
fn write(deck: &Path, layers: usize, time: f64) -> Result<String, Box<dyn Error>> {
    let python = machine::python();
    let words = ["--layers".into(), layers.to_string(), "--time".into(), time.to_string()];
    let run = Command::new(&python).arg(SCRIPT).arg(deck).args(words).output();
    let output = run.map_err(|error| format!("`{python}`: {error}; $SIGNORINI_PYTHON may name another Python"))?;
    if !output.status.success() {
        let told = String::from_utf8_lossy(&output.stderr);
        let last = told.trim().lines().last().unwrap_or_default();
        return Err(format!("the deck is made by gmsh and numpy in {python} ($SIGNORINI_PYTHON): {last}").into());
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}
