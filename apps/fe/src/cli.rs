//! The command line.

use crate::console::Console;
use crate::{check, job};
use clap::{Parser, Subcommand, ValueEnum};
use fe_contact::law::Laws;
use fe_io::Library;
use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Finite elements for contact: a keyword deck in, a certified results file out.
#[derive(Parser)]
#[command(name = "fe", version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Threads; all cores when left out. Results do not depend on it.
    #[arg(long, global = true, value_name = "N")]
    threads: Option<usize>,
    /// What is logged to standard error.
    #[arg(long, global = true, value_name = "LEVEL", default_value = "warn")]
    log: Level,
}

#[derive(Clone, Copy, ValueEnum)]
enum Level {
    Off,
    Error,
    Warn,
    Info,
    Debug,
    Trace,
}

#[derive(Subcommand)]
enum Command {
    /// Run a deck; results stand beside it: JOB.vtkhdf for ParaView, JOB.dat with the printed tables.
    Run {
        /// The deck.
        deck: PathBuf,
        /// Print nothing but messages about faults.
        #[arg(long, short)]
        quiet: bool,
    },
    /// Read and check a deck, and print for each step what it needs and what it does not.
    Check {
        /// The deck.
        deck: PathBuf,
    },
    /// The manual: all cards, or one card in full.
    Keywords {
        /// A card, say `CONTACT PAIR`.
        card: Vec<String>,
    },
}

/// Runs the program with the arguments of the process. A program with laws of its own calls this with its library.
pub fn main(library: Library) -> ExitCode {
    main_with(library, std::env::args_os())
}

/// [`main`] with arguments of the caller's choice, the program's name first.
pub fn main_with(library: Library, arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(usage) => {
            let failed = usage.use_stderr();
            // Nothing can be said where the terminal is gone.
            let _ = usage.print();
            return if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS };
        }
    };
    start_log(arguments.log);
    if arguments.threads == Some(0) {
        return fail("--threads 0: give at least one thread");
    }
    let threads = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads.unwrap_or(0)).build();
    match threads {
        Ok(pool) => pool.install(|| execute(&arguments.command, &library)),
        Err(error) => fail(&format!("the threads could not be started: {error}")),
    }
}

fn start_log(level: Level) {
    use tracing_subscriber::filter::LevelFilter;
    let filter = match level {
        Level::Off => LevelFilter::OFF,
        Level::Error => LevelFilter::ERROR,
        Level::Warn => LevelFilter::WARN,
        Level::Info => LevelFilter::INFO,
        Level::Debug => LevelFilter::DEBUG,
        Level::Trace => LevelFilter::TRACE,
    };
    // A second start in one process keeps the first log.
    let _ = tracing_subscriber::fmt().with_max_level(filter).with_writer(std::io::stderr).try_init();
}

fn execute(command: &Command, library: &Library) -> ExitCode {
    match command {
        Command::Run { deck, quiet } => match job::run(deck, library, &mut Console::new(*quiet)) {
            Ok(_) => ExitCode::SUCCESS,
            Err(failure) => fail(&failure.to_string()),
        },
        Command::Check { deck } => match check::check(deck, library) {
            Ok(plan) => print(&plan),
            Err(failure) => fail(&failure.to_string()),
        },
        Command::Keywords { card } => match keywords(&card.join(" "), library) {
            Ok(text) => print(&text),
            Err(message) => fail(&message),
        },
    }
}

/// The manual of a card, or the list of all.
fn keywords(card: &str, library: &Library) -> Result<String, String> {
    if card.is_empty() { Ok(fe_io::manual::list()) } else { fe_io::manual::card(card, &library.laws) }
}

fn print(text: &str) -> ExitCode {
    // A closed pipe (fe keywords | head) is no fault of the run.
    let _ = writeln!(std::io::stdout().lock(), "{}", text.trim_end());
    ExitCode::SUCCESS
}

fn fail(message: &str) -> ExitCode {
    let _ = writeln!(std::io::stderr().lock(), "{}", message.trim_end());
    ExitCode::FAILURE
}

/// The laws that come with the program.
pub fn standard() -> Library {
    Library { laws: Laws::standard() }
}
