//! A brick pressed onto the stop, free along its axis: the softened law alone holds it, and places it exactly.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{ALGEBRAIC, Job, close};
use common::slider::{Body, DISTANCE, K, pair};

/// Starts at a clearance, kink, plateau, last slope 600 continued.
const TABLE: &str = "0., -0.02\n10., 0.\n10., 0.05\n200., 0.10\n260., 0.20\n";

/// Held across, loaded on the far face; `steps` are the data lines of `*STATIC`.
fn deck(law: &str, data: &str, load: f64, steps: &str) -> String {
    let body = Body::Brick;
    format!(
        "{}{}*SURFACE, NAME=FAR\nE, S2\n*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law}\n\
         {data}{}*BOUNDARY\n1, 1, 2\n2, 2\n4, 1\n5, 1, 2\n6, 2\n8, 1\nREF, 1, 6\n*STEP\n*STATIC\n{steps}\
         *CONTROLS, PARAMETERS=FIELD\n1e-12\n*DSLOAD\nFAR, P, {load}\n*END STEP\n",
        body.deck(),
        body.stop(false),
        pair("SURFACE TO SURFACE")
    )
}

/// Overclosure, and by how much the brick got shorter.
fn solve(name: &str, deck: &str) -> [f64; 2] {
    let results = Job::run(name, deck).results();
    let u = results.point_field("U", 3, results.times().len() - 1);
    let [near, far] = [[0.0; 3], [0.0, 0.0, 1.0]].map(|x| u[3 * results.point_at(x) + 2]);
    [-near - DISTANCE, near - far]
}

fn assert_placed(what: &str, found: [f64; 2], overclosure: f64, load: f64) {
    let size = DISTANCE + load / K;
    close(&format!("{what}, {load}"), found, [overclosure, load / K], ALGEBRAIC * size);
}

/// An exponential law has no slope where it begins: the brick is brought there, and finds the overclosure h = (z − 1) c₀
/// of the load p₀ z (eᶻ − 1)/(e − 1), from far below the pressure at zero clearance to a hundredfold.
#[test]
fn an_exponential_law_holds_a_body() {
    let [c, p] = [0.05, 200.0];
    for z in [0.01f64, 0.5, 1.0, 2.0, 4.0] {
        let load = p * z * z.exp_m1() / 1f64.exp_m1();
        let found = solve("held_exponential", &deck("EXPONENTIAL", "0.05, 200.\n", load, ""));
        assert_placed("exponential", found, (z - 1.0) * c, load);
    }
}

/// Loads below, about and above the plateau of 10, in one increment and in small ones.
#[test]
fn a_body_passes_a_plateau() {
    for (load, overclosure) in [
        (5.0, -0.01),
        (9.9, -0.0002),
        (10.001, 0.05 + 0.001 / 3800.0),
        (12.0, 0.05 + 2.0 / 3800.0),
        (150.0, 0.05 + 140.0 / 3800.0),
        (710.0, 0.95),
    ] {
        for steps in ["1., 1.\n", "0.3, 1., , 0.3\n"] {
            let found = solve("held_plateau", &deck("TABULAR", TABLE, load, steps));
            assert_placed(steps, found, overclosure, load);
        }
    }
}

/// A load on the plateau has no unique position.
#[test]
fn a_load_on_the_plateau_is_refused() {
    let scratch = Scratch::new("held_undecided");
    for (steps, time) in [("1., 1.\n", "1.000000e0"), ("0.25, 1., , 0.25\n", "1.000000e0")] {
        scratch.write("brick.inp", &deck("TABULAR", TABLE, 10.0, steps));
        let run = scratch.fe(&["run", "brick.inp", "--quiet"]);
        assert_eq!(run.status, 1, "{}", run.output);
        for words in ["body E has no unique position", "plateau", "along z", time] {
            assert!(run.error.contains(words), "{words}: {}", run.error);
        }
    }
}
