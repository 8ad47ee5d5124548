//! Bars of cubes that hit each other: contact by laws as stiff as the cubes, and far stiffer.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;
use std::fmt::Write;

/// Edge of a bar across, and along.
const CELLS: [usize; 2] = [3, 10];

/// Nodes and elements of a bar from z = `from` on.
fn bar(name: &str, first: usize, from: f64) -> String {
    let [wide, long] = CELLS;
    let node = |i: usize, j: usize, k: usize| first + i + (wide + 1) * (j + (wide + 1) * k);
    let mut cards = format!("*NODE, NSET={name}\n");
    for (k, j, i) in (0..=long).flat_map(|k| (0..=wide).flat_map(move |j| (0..=wide).map(move |i| (k, j, i)))) {
        let _ = writeln!(cards, "{}, {i}., {j}., {:?}", node(i, j, k), from + k as f64);
    }
    let _ = writeln!(cards, "*ELEMENT, TYPE=C3D8R, ELSET={name}");
    for (k, j, i) in (0..long).flat_map(|k| (0..wide).flat_map(move |j| (0..wide).map(move |i| (k, j, i)))) {
        let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let at = |up: usize| corners.map(|(x, y)| node(i + x, j + y, k + up).to_string()).join(", ");
        let _ = writeln!(cards, "{}, {}, {}", first + i + wide * (j + wide * k), at(0), at(1));
    }
    cards
}

/// The second bar at rest, touched by the first one, until both are free again.
fn deck(slope: f64, weight: f64) -> String {
    let long = CELLS[1] as f64;
    format!(
        "{}{}*SURFACE, NAME=FRONT\nA, S2\n*SURFACE, NAME=BACK\nB, S1\n*MATERIAL, NAME=M\n*ELASTIC\n{E:?}, 0.\n*DENSITY\n{DENSITY:?}\n\
         *SOLID SECTION, ELSET=A, MATERIAL=M\n*SOLID SECTION, ELSET=B, MATERIAL=M\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{slope:?}\n*INITIAL CONDITIONS, TYPE=VELOCITY\nA, 3, {SPEED:?}\n\
         *STEP\n*DYNAMIC, EXPLICIT\n, {:?}\n*CONTACT PAIR, INTERACTION=I, MECHANICAL CONSTRAINT=PENALTY, WEIGHT={weight:?}\n\
         FRONT, BACK\n*END STEP\n",
        bar("A", 1, 0.0),
        bar("B", 10001, long),
        3.0 * long / (E / DENSITY).sqrt(),
    )
}

const E: f64 = 210e3;
const DENSITY: f64 = 7.85e-9;
const SPEED: f64 = 1000.0;

/// At the end of the run: energy of motion and energy of contact over that of the start, and the drift of the balance.
fn energies(job: &Job) -> [f64; 3] {
    let number = |name: &str| {
        let line = job
            .told
            .lines()
            .find_map(|line| line.trim_start().strip_prefix(name))
            .unwrap_or_else(|| panic!("{}", job.told));
        let word = line.split_whitespace().next().unwrap();
        word.trim_end_matches(',').parse::<f64>().unwrap()
    };
    let start =
        job.told.split("at the start ").nth(1).unwrap().split_whitespace().next().unwrap().parse::<f64>().unwrap();
    [number("kinetic  ") / start, number("contact  ") / start, number("balance  ")]
}

/// What springs take and do not give back is at most the energy of the two layers of nodes that meet, 1/2n of all of it,
/// whatever their stiffness over that of the cubes; they give nothing. Increments change along the way, and what central
/// differences conserve with them: by the same share of those layers.
#[test]
fn stiff_springs_take_no_more_than_what_meets() {
    for stiffer in [1.0, 10.0, 100.0, 1000.0] {
        for weight in [0.0, 0.5] {
            let job = Job::run(&format!("bars_{stiffer}_{weight}"), &deck(stiffer * E, weight));
            let [kinetic, contact, drift] = energies(&job);
            let most = 0.5 / CELLS[1] as f64;
            let what = format!("{stiffer} {weight}: {kinetic} {contact} {drift}");
            assert!(kinetic < 1.0 && contact > -most * 0.1 && contact < most && drift < most * 0.5, "{what}");
        }
    }
}
