//! What moves with the bodies of explicit steps: pressures with their faces, and nodes with the rigid body they belong to.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A square of side 1 and density 1 that spins once about its centre while a pressure of 0.001 acts on one side: it pushes in
/// all directions for the same time, and leaves no momentum, where a force that keeps its direction would leave 0.001 · 2π. What
/// the pressure does to the shape, 1e-7, and centrifugal forces, 1e-4, change that by their part.
#[test]
fn a_pressure_turns_with_its_face() {
    let mut deck = String::from("*NODE, NSET=ALL\n1, -0.5, -0.5\n2, 0.5, -0.5\n3, 0.5, 0.5\n4, -0.5, 0.5\n");
    deck += "*ELEMENT, TYPE=CPE4R, ELSET=E\n1, 1, 2, 3, 4\n*MATERIAL, NAME=M\n*ELASTIC\n10000., 0.\n*DENSITY\n1.\n\
             *SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*SURFACE, NAME=SIDE\nE, S1\n*INITIAL CONDITIONS, TYPE=VELOCITY\n";
    for (node, x, y) in [(1, -0.5, -0.5), (2, 0.5, -0.5), (3, 0.5, 0.5), (4, -0.5, 0.5)] {
        deck += &format!("{node}, 1, {}\n{node}, 2, {x}\n", -y);
    }
    deck +=
        &format!("*STEP\n*DYNAMIC, EXPLICIT\n, {TAU}\n*DSLOAD\nSIDE, P, 0.001\n*NODE PRINT, NSET=ALL\nV\n*END STEP\n");
    let job = Job::run("pressure_turns", &deck);
    let table = job.tables().into_iter().next().unwrap();
    for c in 0..2 {
        let mean: f64 = table.rows.iter().map(|row| row.values[c]).sum::<f64>() / 4.0;
        assert!(mean.abs() < 1e-3 * 0.001 * TAU, "{mean}");
    }
    assert!(job.plan().contains("on 1 faces, which they follow"), "{}", job.plan());
}

/// A facet whose reference node goes by (3, 0, 0) and turns by a right angle about z: in fields, tables and histories its nodes are
/// where the body carries them, at its velocity.
#[test]
fn nodes_of_a_rigid_body_move_with_it() {
    let deck = format!(
        "*NODE, NSET=ALL\n1, 1., 0., 0.\n2, 2., 0., 0.\n3, 2., 1., 0.\n4, 1., 1., 0.\n9, 0., 0., 0.\n\
         *ELEMENT, TYPE=R3D4, ELSET=PLATE\n1, 1, 2, 3, 4\n*RIGID BODY, ELSET=PLATE, REF NODE=9\n*NSET, NSET=THIRD\n3\n\
         *ELEMENT, TYPE=MASS, ELSET=M\n2, 9\n*MASS, ELSET=M\n1.\n\
         *STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.125, 1.\n*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 3.\n9, 2, 5\n\
         9, 6, 6, {FRAC_PI_2}\n*NODE PRINT, NSET=THIRD\nU, V\n*OUTPUT, HISTORY, FREQUENCY=4\n*NODE OUTPUT, NSET=THIRD\nU\n\
         *END STEP\n"
    );
    let job = Job::run("rigid_motion", &deck);
    // (2, 1) → (−1, 2), and 3 along x.
    let (u, v) = ([0.0, 1.0, 0.0], [3.0 - 2.0 * FRAC_PI_2, -FRAC_PI_2, 0.0]);
    let near = |name: &str, got: &[f64], wanted: [f64; 3]| {
        assert!(got.iter().zip(wanted).all(|(g, w)| (g - w).abs() < 1e-9), "{name}: {got:?}, not {wanted:?}");
    };
    for (title, wanted) in [("displacements", u), ("velocities", v)] {
        near(title, &[1, 2, 3].map(|c| job.last(title, "THIRD", c)), wanted);
    }
    let results = job.results();
    let (place, frame) = (results.point_at([2.0, 1.0, 0.0]), results.times().len() - 1);
    near("U", &results.point_field("U", 3, frame)[3 * place..3 * place + 3], u);
    near("V", &results.point_field("V", 3, frame)[3 * place..3 * place + 3], v);
    let history = results.real("Signorini/History/U of THIRD");
    near("history", &history[history.len() - 3..], u);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    near("half way", &history[9..12], [1.5 + half - 2.0, 3.0 * half - 1.0, 0.0]);
}
