//! What a process takes, from launch to exit: seconds by the wall clock, processor seconds, peak memory.
//!
//! The system accounts memory for all children of a process together, as a maximum. So each run is launched by a
//! small process of its own (this program again, by [`report`]), which has just that one child.

use nix::sys::resource::{Usage, UsageWho, getrusage};
use std::fs::File;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Name of the subcommand that launches one process and reports what it took.
pub const LAUNCH: &str = "launch";

/// What one process took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Seconds by the wall clock.
    pub wall: f64,
    /// Processor seconds, user and system, of all threads.
    pub cpu: f64,
    /// Peak resident memory [bytes].
    pub memory: f64,
}

/// Why a process could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    /// It could not be started, or its report not be read.
    #[error("`{command}`: {error}")]
    Launch {
        /// The command.
        command: String,
        /// What the system said.
        error: io::Error,
    },
    /// It ended with a fault.
    #[error("`{command}` failed; its messages stand in {log}")]
    Failed {
        /// The command.
        command: String,
        /// File with what it printed.
        log: String,
    },
}

/// Runs `command` (program and arguments) in `folder`, what it prints into `log` there, with so many threads asked
/// for in the environment variables that such programs heed. To be called by the program `benchmarks` alone.
pub fn run(command: &[String], folder: &Path, log: &str, threads: usize) -> Result<Cost, MeasureError> {
    let shown = command.join(" ");
    let launch = |error| MeasureError::Launch { command: shown.clone(), error };
    let own = std::env::current_exe().map_err(launch)?;
    let count = threads.to_string();
    let output = Command::new(own)
        .args([LAUNCH, log])
        .args(command)
        .current_dir(folder)
        .envs(["OMP_NUM_THREADS", "CCX_NPROC_EQUATION_SOLVER", "NUMBER_OF_CPUS"].map(|name| (name, &count)))
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .output()
        .map_err(launch)?;
    if !output.status.success() {
        return Err(MeasureError::Failed { command: shown, log: folder.join(log).display().to_string() });
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    match numbers[..] {
        [wall, cpu, memory] => Ok(Cost { wall, cpu, memory }),
        _ => Err(launch(io::Error::other(format!("no report: {text}")))),
    }
}

/// Launches `command`, what it prints into the file `log`, and gives its cost as the line that [`run`] reads; `None`
/// where it fails.
pub fn report(log: &str, command: &[String]) -> io::Result<Option<String>> {
    let (program, arguments) = command.split_first().ok_or_else(|| io::Error::other("no command"))?;
    let file = File::create(log)?;
    let start = Instant::now();
    let status = Command::new(program).args(arguments).stdout(file.try_clone()?).stderr(file).status()?;
    let wall = start.elapsed().as_secs_f64();
    let usage = getrusage(UsageWho::RUSAGE_CHILDREN)?;
    Ok(status.success().then(|| format!("{wall} {} {}", cpu_seconds(&usage), peak_bytes(&usage))))
}

/// Processor seconds of this process so far, all threads.
pub fn own_cpu() -> io::Result<f64> {
    Ok(cpu_seconds(&getrusage(UsageWho::RUSAGE_SELF)?))
}

fn cpu_seconds(usage: &Usage) -> f64 {
    [usage.user_time(), usage.system_time()].iter().map(|t| t.tv_sec() as f64 + 1e-6 * t.tv_usec() as f64).sum()
}

/// Linux counts in kB, macOS in bytes.
fn peak_bytes(usage: &Usage) -> f64 {
    let unit = if cfg!(target_os = "macos") { 1.0 } else { 1024.0 };
    usage.max_rss() as f64 * unit
}
