//! What steps say of contact, through the program: pairs removed and added. The slider against a rigid stop, hard by
//! multipliers: k x + N = F while it touches.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::slider::{Body, DISTANCE, K, pair};
use fe_io::results::read::tables;

/// Prints ten digits.
const PRINTED: f64 = 5e-10;

/// Values of a component (from 1) of the first row of all tables of a title and a set.
fn all(text: &str, title: &str, set: &str, component: usize) -> Vec<f64> {
    let blocks = tables(text).unwrap();
    let wanted = blocks.iter().filter(|b| b.title.starts_with(title) && b.set == set);
    wanted.map(|b| b.rows[0].values[component - 1]).collect()
}

fn run(name: &str, deck: &str) -> String {
    let scratch = Scratch::new(name);
    scratch.write("slider.inp", deck);
    let run = scratch.fe(&["run", "slider.inp", "--quiet"]);
    assert_eq!(run.status, 0, "{name}: {}\n{deck}", run.error);
    scratch.read("slider.dat")
}

fn close(what: &str, got: &[f64], expected: &[f64], size: f64) {
    assert_eq!(got.len(), expected.len(), "{what}: {got:?}");
    assert!(
        got.iter().zip(expected).all(|(g, e)| (g - e).abs() <= PRINTED * size),
        "{what}: {got:?}, not {expected:?}"
    );
}

/// The pair acts, is removed, and acts again. Its force ramps to zero over the step that removes it, N = 400 (1 − t), while
/// the column goes on to x = F/k; added again, it presses the column back.
#[test]
fn a_pair_is_removed_and_added() {
    let change = |what: &str| {
        format!("*STEP\n*STATIC, DIRECT\n0.25, 1.\n*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nSEC, FLOOR\n*END STEP\n")
    };
    for body in [Body::Brick, Body::Plane, Body::Ring] {
        let deck = format!(
            "{}{}*SURFACE INTERACTION, NAME=I\n{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n*DSLOAD\nSEC, P, -500.\n\
             *NODE PRINT, NSET=REF\nRF\n*NODE PRINT, NSET=NEAR\nU\n*END STEP\n{}{}*STEP\n*STATIC\n*END STEP\n",
            body.deck(),
            body.stop(false),
            pair("SURFACE TO SURFACE, SMALL SLIDING"),
            change("REMOVE"),
            change("ADD")
        );
        let text = run("model_change", &deck);
        let held = 500.0 - K * DISTANCE;
        let mut forces = vec![held];
        forces.extend([0.75, 0.5, 0.25, 0.0].map(|t| t * held));
        forces.extend([held; 5]);
        let x: Vec<f64> = forces.iter().map(|n| -(500.0 - n) / K).collect();
        close("force on the stop", &all(&text, "forces", "REF", body.axis()), &forces, held);
        close("displacement", &all(&text, "displacements", "NEAR", body.axis()), &x, 1.0);
    }
}
