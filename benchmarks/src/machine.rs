//! Where and with what a figure was measured.

use std::fmt;
use std::process::Command;

/// Machine, version and commit: what stands beside every figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// Processor and number of cores.
    pub machine: String,
    /// Version of the program.
    pub version: String,
    /// Commit of its sources, `+` where they were changed since; `unknown` outside a repository.
    pub commit: String,
}

impl Origin {
    /// Of this process.
    pub fn here() -> Self {
        let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        let model = model.map_or(std::env::consts::ARCH, |(_, name)| name.trim());
        let machine = format!("{model}, {cores} cores");
        Origin { machine, version: format!("signorini {}", env!("CARGO_PKG_VERSION")), commit: commit() }
    }
}

/// Machine and commit, as tables begin.
impl fmt::Display for Origin {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        write!(out, "{}; commit {}", self.machine, self.commit)
    }
}

/// The Python that has gmsh: that of `SIGNORINI_PYTHON`, or `python3`.
pub fn python() -> String {
    std::env::var("SIGNORINI_PYTHON").unwrap_or_else(|_| "python3".into())
}

fn commit() -> String {
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_string())
    };
    let Some(hash) = git(&["rev-parse", "--short=10", "HEAD"]) else { return "unknown".into() };
    let changed = git(&["status", "--porcelain", "--untracked-files=no", "*.rs", "*.toml"]);
    if changed.is_none_or(|files| !files.is_empty()) { hash + "+" } else { hash }
}
