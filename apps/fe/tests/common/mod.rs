//! What the tests of the program share: a folder to run in, and readers of what it leaves.
#![allow(dead_code)]

pub mod job;
pub mod results;
pub mod slider;

use std::path::{Path, PathBuf};
use std::process::Command;

/// The end of a run.
pub struct Run {
    /// Exit status.
    pub status: i32,
    /// Standard output.
    pub output: String,
    /// Standard error.
    pub error: String,
}

/// A folder of its own, removed in the end.
pub struct Scratch(PathBuf);

impl Scratch {
    /// Empty; `name` must be the test's own.
    pub fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Scratch(path)
    }

    /// With a copy of the acceptance decks and their meshes.
    pub fn with_decks(name: &str) -> Self {
        let scratch = Scratch::new(name);
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/decks");
        for entry in std::fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            std::fs::copy(entry.path(), scratch.0.join(entry.file_name())).unwrap();
        }
        scratch
    }

    /// A path inside.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    /// Reads a file.
    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// Runs the program here.
    pub fn fe(&self, arguments: &[&str]) -> Run {
        let out = Command::new(env!("CARGO_BIN_EXE_fe")).args(arguments).current_dir(&self.0).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        Run { status: out.status.code().unwrap_or(-1), output: text(out.stdout), error: text(out.stderr) }
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }
}
