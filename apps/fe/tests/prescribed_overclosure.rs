//! Laws steeper than a thousand times the elements beneath, at points that supports alone move: the law itself answers.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{ALGEBRAIC, relative};
use common::results::Results;
use common::slider::{Body, K, pair};

/// The brick overlaps its stop by this [L] at the start.
const OVERLAP: f64 = 1e-3;

fn deck(slope: f64, steps: &str) -> String {
    let stop = Body::Brick.stop(false).replace("-0.1", "0.001");
    format!(
        "{}{stop}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{slope:e}\n{}*BOUNDARY\n\
         HELD, 1, 3\nREF, 1, 6\n{steps}",
        Body::Brick.deck(),
        pair("SURFACE TO SURFACE")
    )
}

/// Force on the stop at the end of the steps.
fn force(results: &Results) -> f64 {
    let node = results.point_at([0.0, 0.0, -5.0]);
    results.point_field("RF", 3, results.times().len() - 1)[3 * node + 2]
}

fn assert_close(what: &str, found: f64, expected: f64) {
    relative(what, [found], [expected], ALGEBRAIC);
}

/// Everything is prescribed: slope × overclosure × area from one iteration, up to a billion times the elements beneath.
#[test]
fn everything_is_prescribed() {
    let scratch = Scratch::new("prescribed_overclosure");
    for factor in [1e3, 1e4, 1e6, 1e9] {
        let slope = factor * K;
        scratch.write("brick.inp", &deck(slope, "NEAR, 1, 3\n*STEP\n*STATIC\n*END STEP\n"));
        let report = fe::run(&scratch.path("brick.inp"), &fe::standard(), &mut fe::observer::Silent).unwrap();
        assert_eq!(report.certificate.iterations, 1, "{factor:e}");
        assert_close(&format!("{factor:e}"), force(&Results::open(&report.results)), slope * OVERLAP);
    }
    let told = scratch.fe(&["check", "brick.inp"]).output;
    assert!(told.contains("4 points that prescribed freedoms alone move"), "{told}");
    assert!(!told.contains("over-constraint"), "{told}");
}

/// A later step lets go of the near face: column and law in series are compressed by the overlap.
#[test]
fn supports_let_go() {
    let scratch = Scratch::new("prescribed_overclosure_released");
    for factor in [2e3, 1e5] {
        let slope = factor * K;
        let steps = "*STEP\n*STATIC\n*BOUNDARY\nNEAR, 1, 3\n*END STEP\n*STEP\n*STATIC\n0.25, 1.\n*CONTROLS, PARAMETERS=FIELD\n\
                     1e-12\n*BOUNDARY, OP=NEW\nHELD, 1, 3\nREF, 1, 6\nNEAR, 1, 2\n*END STEP\n";
        scratch.write("brick.inp", &deck(slope, steps));
        let report = fe::run(&scratch.path("brick.inp"), &fe::standard(), &mut fe::observer::Silent).unwrap();
        let expected = OVERLAP / (1.0 / K + 1.0 / slope);
        assert_close(&format!("{factor:e}"), force(&Results::open(&report.results)), expected);
    }
}
