//! Programs that run a scene: this one, and CalculiX where it is installed.

use std::path::Path;
use std::process::Command;

/// A program that takes a deck.
#[derive(Clone, Debug, PartialEq)]
pub struct Solver {
    /// Its name in tables.
    pub name: &'static str,
    /// Its version.
    pub version: String,
    words: Vec<String>,
}

impl Solver {
    /// This program, as `fe` would run.
    pub fn own(version: &str) -> Result<Self, String> {
        let own = std::env::current_exe().map_err(|error| format!("this program's own path: {error}"))?;
        Ok(Solver { name: "signorini", version: version.into(), words: vec![own.display().to_string(), "fe".into()] })
    }

    /// CalculiX, by the path in `SIGNORINI_CCX` or as `ccx` on the search path.
    pub fn calculix() -> Option<Self> {
        let program = std::env::var("SIGNORINI_CCX").unwrap_or_else(|_| "ccx".into());
        let output = Command::new(&program).arg("-v").output().ok()?;
        let text = String::from_utf8_lossy(&output.stdout);
        let version = text.split_once("Version")?.1.split_whitespace().next()?.to_string();
        Some(Solver { name: "calculix", version: format!("calculix {version}"), words: vec![program] })
    }

    /// The command that runs a deck, to be given in the deck's folder.
    pub fn command(&self, deck: &Path, threads: usize) -> Vec<String> {
        let mut command = self.words.clone();
        if self.name == "calculix" {
            command.push(deck.file_stem().unwrap_or_default().to_string_lossy().into());
        } else {
            let file = deck.file_name().unwrap_or_default().to_string_lossy().into();
            command.extend(["run".into(), file, "--threads".into(), threads.to_string()]);
        }
        command
    }
}
