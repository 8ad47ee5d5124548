//! A Python with h5py and VTK: that of `SIGNORINI_PYTHON`, which spares time, or one that is set up once below the
//! target directory.
#![allow(dead_code)]

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const NEEDS: &str = "import h5py, numpy, vtkmodules.vtkIOHDF";

fn runs(program: &Path, arguments: &[&str]) -> bool {
    let status = Command::new(program).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
    status.is_ok_and(|s| s.success())
}

/// The interpreter, or why there is none.
pub fn python() -> Result<PathBuf, &'static str> {
    if let Some(named) = std::env::var_os("SIGNORINI_PYTHON") {
        let named = PathBuf::from(named);
        return if runs(&named, &["-c", NEEDS]) { Ok(named) } else { Err("SIGNORINI_PYTHON lacks h5py or VTK") };
    }
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python");
    let program = |folder: &Path| folder.join("bin").join("python");
    if runs(&program(&place), &["-c", NEEDS]) {
        return Ok(program(&place));
    }
    // Made under a name of its own, so that tests side by side do not meet.
    let made = place.with_extension(std::process::id().to_string());
    if !runs(Path::new("python3"), &["-m", "venv", &made.to_string_lossy()]) {
        return Err("no python3 with venv");
    }
    let pip = |packages: &[&str]| runs(&program(&made), &[&["-m", "pip", "install", "--quiet"], packages].concat());
    // What VTK names as its needs is for drawing.
    if !(pip(&["h5py", "numpy"]) && pip(&["--no-deps", "vtk"])) {
        let _ = std::fs::remove_dir_all(&made);
        return Err("pip cannot install h5py, numpy and vtk (no network?)");
    }
    if std::fs::rename(&made, &place).is_err() {
        let _ = std::fs::remove_dir_all(&made);
    }
    if runs(&program(&place), &["-c", NEEDS]) { Ok(program(&place)) } else { Err("h5py or VTK does not start") }
}

/// Runs `tests/python/check_results.py` on a file of `frames` frames and `hexes` hexahedra.
pub fn check(python: &Path, file: &Path, hexes: usize, frames: usize) {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/python/check_results.py");
    let output = Command::new(python).arg(script).arg(file).args([hexes.to_string(), frames.to_string()]).output();
    let output = output.expect("the interpreter has just run");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
}
