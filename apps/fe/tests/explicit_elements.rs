//! Elements and materials of explicit steps, from the deck to the table: one element that swings along one axis is a mass on a
//! spring, whose course by central differences is known.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, close};

const E: f64 = 210e3;
const NU: f64 = 0.3;
const DENSITY: f64 = 7.85e-9;

/// A cell of height 1 along the last axis, 2 wide, its lower nodes held and the upper ones free to move up alone.
fn deck(element: &str, material: &str) -> String {
    let solid = element.starts_with("C3D");
    let (nodes, cell, up, held) = match solid {
        true => (
            "1, 0., 0., 0.\n2, 2., 0., 0.\n3, 2., 2., 0.\n4, 0., 2., 0.\n5, 0., 0., 1.\n6, 2., 0., 1.\n7, 2., 2., 1.\n8, 0., 2., 1.",
            "1, 1, 2, 3, 4, 5, 6, 7, 8",
            "5, 6, 7, 8",
            "ALL, 1, 2\nLOW, 3",
        ),
        false => ("1, 0., 0.\n2, 2., 0.\n3, 2., 1.\n4, 0., 1.", "1, 1, 2, 3, 4", "3, 4", "ALL, 1\nLOW, 2"),
    };
    let (low, axis) = if solid { ("1, 2, 3, 4", 3) } else { ("1, 2", 2) };
    format!(
        "*NODE, NSET=ALL\n{nodes}\n*ELEMENT, TYPE={element}, ELSET=E\n{cell}\n*NSET, NSET=LOW\n{low}\n*NSET, NSET=UP\n{up}\n\
         *MATERIAL, NAME=M\n{material}\n*DENSITY\n{DENSITY}\n*SOLID SECTION, ELSET=E, MATERIAL=M\n{thickness}*BOUNDARY\n{held}\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nUP, {axis}, {SPEED}\n*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n{DT}, {period}\n\
         *BULK VISCOSITY\n0., 0.\n*NODE PRINT, NSET=UP, FREQUENCY=100000\nU\n*END STEP\n",
        thickness = if element.starts_with("CP") { "0.5,\n" } else { "" },
        period = DT * STEPS as f64,
    )
}

const DT: f64 = 1e-8;
const STEPS: usize = 200;
/// So slow that strains are 1e-7.
const SPEED: f64 = 1.0;

/// Where the recurrence u₁ − (2 − k Δt²/m − c Δt/m) u + (1 − c Δt/m) u₋₁ = 0 is after the steps, from u = 0; the first increment is
/// as fast as the start, less half an increment of its damping by mass: rates of strain are not known yet.
fn course([square, alpha, beta]: [f64; 3]) -> f64 {
    let damping = alpha + beta * square;
    let (mut last, mut now) = (0.0, SPEED * (1.0 - 0.5 * alpha * DT) * DT);
    for _ in 1..STEPS {
        let next = (2.0 - square * DT * DT - damping * DT) * now - (1.0 - damping * DT) * last;
        (last, now) = (now, next);
    }
    now
}

fn swings(element: &str, material: &str, of: [f64; 3]) {
    let job = Job::run(&format!("swings_{element}_{}", material.len()), &deck(element, material));
    let axis = if element.starts_with("C3D") { 3 } else { 2 };
    let expected = course(of);
    let got = job.last("displacements", "UP", axis);
    // Strains of 1e-7 are a few times as far from linear.
    close(element, [got / expected], [1.0], 1e-6);
}

/// Modulus of an element held sideways, or with its thickness free.
fn modulus(element: &str, (young, nu): (f64, f64)) -> f64 {
    match element.starts_with("CPS") {
        true => young / (1.0 - nu * nu),
        false => young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)),
    }
}

const ELEMENTS: [&str; 7] = ["C3D8R", "CPE4R", "CPS4R", "CAX4R", "C3D8", "CPE4", "CAX4"];

#[test]
fn elastic_elements_swing() {
    let material = format!("*ELASTIC\n{E}, {NU}");
    for element in ELEMENTS {
        // Half of the mass on a spring of the whole section.
        swings(element, &material, [2.0 * modulus(element, (E, NU)) / DENSITY, 0.0, 0.0]);
    }
}

/// Small strains of rubber are those of its constants.
#[test]
fn rubber_swings() {
    let (c10, d1) = (40e3, 2e-5);
    let (mu, bulk) = (2.0 * c10, 2.0 / d1);
    let elastic = (9.0 * bulk * mu / (3.0 * bulk + mu), (3.0 * bulk - 2.0 * mu) / (6.0 * bulk + 2.0 * mu));
    for element in ELEMENTS {
        let square = 2.0 * modulus(element, elastic) / DENSITY;
        swings(element, &format!("*HYPERELASTIC, NEO HOOKE\n{c10}, {d1}"), [square, 0.0, 0.0]);
    }
}

/// Rayleigh damping: c = α m + β k.
#[test]
fn damped_elements_swing() {
    let (alpha, beta) = (3e5, 2e-9);
    let material = format!("*ELASTIC\n{E}, {NU}\n*DAMPING, ALPHA={alpha}, BETA={beta}");
    for element in ELEMENTS {
        let square = 2.0 * modulus(element, (E, NU)) / DENSITY;
        swings(element, &material, [square, alpha, beta]);
    }
}
