//! The program: measures problems with known answers.

use benchmarks::explicit::{self, general, impacts, poured};
use benchmarks::study::Options;
use benchmarks::{card, compare, growth, hard, measure, problems, reading, study};
use clap::{Parser, Subcommand};
use std::error::Error;
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Speed against error: problems with known answers, run through the same entry as `fe`.
#[derive(Parser)]
#[command(name = "benchmarks", version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List the problems, their curves and errors.
    List,
    /// Measure problems on all their meshes: table, rates, rows and plots.
    Run {
        /// Their names; all when left out.
        problems: Vec<String>,
        #[command(flatten)]
        settings: Settings,
    },
    /// Run decks of problems through this program and CalculiX in turn.
    Compare {
        /// Their names; all that have such decks when left out.
        problems: Vec<String>,
        #[command(flatten)]
        settings: Settings,
    },
    /// The cantilever beside CalculiX: the same as `compare cantilever`.
    Cantilever {
        #[command(flatten)]
        settings: Settings,
    },
    /// The hard cases: what happens in each scene, and its error against its bound; status 1 where one failed.
    Hard {
        /// Identifiers, say `D07`; all when left out.
        cases: Vec<String>,
        /// Folder of decks and results.
        #[arg(long, default_value = "target/benchmarks/hard")]
        work: PathBuf,
    },
    /// The laws and enforcements of *SURFACE BEHAVIOR side by side on problems with closed answers.
    Laws {
        /// Folder of decks and results.
        #[arg(long, default_value = "target/benchmarks/laws")]
        work: PathBuf,
    },
    /// The penalty of Hertz's line contact over twelve decades: errors against iterations.
    Penalty {
        /// Folder of decks and results.
        #[arg(long, default_value = "target/benchmarks/penalty")]
        work: PathBuf,
    },
    /// Read a gmsh file of a million nodes, as text and as binary, beside gmsh's own reader.
    Reading {
        /// Hexahedra along each edge of the block.
        #[arg(long, default_value_t = 100)]
        edge: usize,
        #[command(flatten)]
        settings: Settings,
    },
    /// How seconds by phase and memory grow with the unknowns of the cantilever.
    Growth {
        #[command(flatten)]
        settings: Settings,
    },
    /// Explicit steps: updates of elements a second beside the memory, and two bars that hit each other beside CalculiX.
    Explicit {
        #[command(flatten)]
        settings: Settings,
    },
    /// How general contact grows with its facets, and its share of an increment.
    General {
        /// Threads.
        #[arg(long, default_value_t = 1)]
        threads: usize,
    },
    /// Kinematic contact and penalties side by side on impacts: overclosure, energy lost, impulse, increments.
    Impacts {
        /// Threads.
        #[arg(long, default_value_t = 1)]
        threads: usize,
    },
    /// The poured balls of the examples: time an element and increment, and the share of general contact in it.
    Poured(poured::Options),
    /// Run a deck and print its seconds by phase.
    #[command(hide = true, name = growth::PHASES)]
    Phases {
        deck: PathBuf,
        #[arg(long, default_value_t = 1)]
        threads: usize,
    },
    /// Run a deck as the program `fe` does.
    #[command(hide = true)]
    Fe {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Launch one command and report what it took.
    #[command(hide = true, name = measure::LAUNCH)]
    Launch {
        log: String,
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        command: Vec<String>,
    },
}

#[derive(clap::Args)]
struct Settings {
    /// Threads of each run.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Counted runs of each scene, after one that is not counted.
    #[arg(long, default_value_t = 5)]
    runs: usize,
    /// Leave out scenes with more unknowns.
    #[arg(long, value_name = "UNKNOWNS", default_value_t = usize::MAX)]
    most: usize,
    /// Folder of decks, meshes and answers.
    #[arg(long, default_value = "target/benchmarks")]
    work: PathBuf,
    /// Folder of rows and plots.
    #[arg(long, default_value = "target/benchmarks/results")]
    results: PathBuf,
}

impl Settings {
    fn options(self) -> Options {
        let Settings { threads, runs, most, work, results } = self;
        Options { threads, runs: runs.max(1), most, work, results }
    }
}

fn main() -> ExitCode {
    match execute(Arguments::parse().command) {
        Ok(code) => code,
        Err(error) => {
            // Nothing can be said where standard error is closed.
            let _ = writeln!(std::io::stderr().lock(), "{error}");
            ExitCode::FAILURE
        }
    }
}

fn execute(command: Command) -> Result<ExitCode, Box<dyn Error>> {
    let out = &mut std::io::stdout();
    match command {
        Command::List => list(out)?,
        Command::Run { problems, settings } => {
            let options = settings.options();
            for problem in chosen(&problems, |_| true)? {
                study::study(&*problem, &options, out)?;
            }
        }
        Command::Compare { problems, settings } => compare_all(&problems, &settings.options(), out)?,
        Command::Cantilever { settings } => compare_all(&["cantilever".into()], &settings.options(), out)?,
        Command::Hard { cases, work } => return hard_cases(&cases, &work, out),
        Command::Laws { work } => card::laws(&work, out)?,
        Command::Penalty { work } => card::sweep(&work, out)?,
        Command::Reading { edge, settings } => {
            let Options { runs, work, results, .. } = settings.options();
            reading::study(&reading::Options { edge, runs, work, results }, out)?;
        }
        Command::Growth { settings } => growth::study(&settings.options(), out)?,
        Command::Explicit { settings } => explicit::study(&settings.options(), out)?,
        Command::General { threads } => general::study(threads, out)?,
        Command::Impacts { threads } => impacts::study(threads, out)?,
        Command::Poured(options) => poured::study(&options, out)?,
        Command::Phases { deck, threads } => growth::phases(&deck, threads, out)?,
        Command::Fe { arguments } => {
            return Ok(fe::main_with(fe::standard(), std::iter::once("fe".into()).chain(arguments)));
        }
        Command::Launch { log, command } => {
            let Some(line) = measure::report(&log, &command)? else { return Ok(ExitCode::FAILURE) };
            writeln!(out, "{line}")?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn compare_all(names: &[String], options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    for problem in chosen(names, |problem| !problem.compared().is_empty())? {
        compare::compare(&*problem, options, out)?;
    }
    Ok(())
}

fn hard_cases(names: &[String], work: &Path, out: &mut dyn Write) -> Result<ExitCode, Box<dyn Error>> {
    match hard::run(&hard::chosen(names)?, work, out)? {
        0 => Ok(ExitCode::SUCCESS),
        failed => Err(format!("{failed} scenes failed").into()),
    }
}

/// The problems of these names, or all that fit.
fn chosen(
    names: &[String],
    fits: impl Fn(&dyn problems::Problem) -> bool,
) -> Result<Vec<Box<dyn problems::Problem>>, String> {
    if names.is_empty() {
        return Ok(problems::all().into_iter().filter(|problem| fits(&**problem)).collect());
    }
    names.iter().map(|name| problems::find(name)).collect()
}

fn list(out: &mut dyn Write) -> std::io::Result<()> {
    for problem in problems::all() {
        writeln!(out, "{}: {}", problem.name(), problem.about())?;
        for curve in problem.curves() {
            writeln!(out, "    {:<16} n = {:?}", curve.name(), curve.sizes)?;
        }
        let norms: Vec<&str> = problem.norms().iter().map(|norm| norm.name).collect();
        writeln!(out, "    errors: {}", norms.join(", "))?;
    }
    Ok(())
}
