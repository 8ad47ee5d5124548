//! The deck through the program, against its closed answer: 1000 x + 2.8e6 (x − 0.1)³ = 500 has x = 0.15, where p = 350.

use hdf5_reader::Hdf5File;
use std::path::Path;
use std::process::Command;

/// Of a discrete problem that has the closed answer; its residual is asked to be 1e-12 of the forces.
const ALGEBRAIC: f64 = 1e-10;

#[test]
fn the_cubic_slider() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cubic_slider");
    std::fs::create_dir_all(&folder).expect("the folder is the test's own");
    let deck = folder.join("cubic.inp");
    std::fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("cubic.inp"), &deck).expect("the deck is there");
    let run = Command::new(env!("CARGO_BIN_EXE_own-law")).arg("run").arg(&deck).arg("--quiet").output();
    let run = run.expect("the program starts");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let results = Hdf5File::open(folder.join("cubic.vtkhdf")).expect("there are results");
    let points = 5;
    // The last frame of a field.
    let last = |name: &str, width: usize| {
        let field = results.dataset(&format!("VTKHDF/PointData/{name}")).expect("it is a usual field");
        let all: Vec<f64> = field.read_array::<f64>().expect("its numbers are real").into_iter().collect();
        all[all.len() - points * width..].to_vec()
    };
    let moved = last("U", 3).chunks_exact(3).fold(0.0, |most: f64, u| most.max(-u[1]));
    let pressure = last("CPRESS", 1).into_iter().fold(0.0, f64::max);
    for (found, expected) in [(moved, 0.15), (pressure, 350.0)] {
        assert!((found - expected).abs() <= ALGEBRAIC * expected, "{found}, not {expected}");
    }
}

#[test]
fn the_manual_knows_the_law() {
    let out = Command::new(env!("CARGO_BIN_EXE_own-law")).args(["keywords", "SURFACE", "BEHAVIOR"]).output();
    let text = String::from_utf8(out.expect("the program starts").stdout).expect("it is text");
    assert!(text.contains("CUBIC: p = K h^3") && text.contains("factor [F/L⁵]"), "{text}");
}
