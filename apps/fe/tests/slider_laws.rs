//! The slider with softened laws, through the program: k x + A p(x − g₀) = F with g₀ = 0.1, k = 1000, A = 1. Numbers of
//! the closed forms have 13 digits or more; the algebraic bound of 1e-10 holds for displacement and pressure, read with
//! all their digits from the results file.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{ALGEBRAIC, Job, relative};
use common::slider::{Body, pair};

const KINDS: [&str; 2] = ["SURFACE TO SURFACE", "NODE TO SURFACE"];

const BODIES: [(Body, bool); 4] =
    [(Body::Brick, false), (Body::Brick, true), (Body::Plane, false), (Body::Ring, false)];

/// A05: starts at a clearance, kink, plateau, last slope 600 continued.
const A05: &str = "0., -0.02\n10., 0.\n10., 0.05\n200., 0.10\n260., 0.20\n";

fn law(name: &str, data: &str) -> String {
    format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={name}\n{data}")
}

/// A load towards the stop, with a residual of 1e-12 of the mean force asked for.
fn deck(body: Body, revolved: bool, load: f64, contact: &str) -> String {
    format!(
        "{}{}{contact}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n\
         *DSLOAD\nSEC, P, {}\n*END STEP\n",
        body.deck(),
        body.stop(revolved),
        -load
    )
}

/// Displacement towards the stop and the law's number at the node in the origin.
fn solve(name: &str, body: Body, deck: &str) -> [f64; 2] {
    let results = Job::run(name, deck).results();
    let node = results.point_at([0.0; 3]);
    let last = results.times().len() - 1;
    let x = -results.point_field("U", 3, last)[3 * node + body.axis() - 1];
    let names = results.names("VTKHDF/PointData");
    let number = if names.iter().any(|name| name == "CPRESS") { "CPRESS" } else { "CPRESS_FORCE" };
    [x, results.point_field(number, 1, last)[node]]
}

fn assert_close(what: &str, found: [f64; 2], expected: [f64; 2]) {
    relative(what, found, expected, ALGEBRAIC);
}

/// On all bodies, stops and discretizations.
fn everywhere(name: &str, load: f64, contact: &str, expected: [f64; 2]) {
    for (body, revolved) in BODIES {
        for kind in KINDS {
            let found = solve(name, body, &deck(body, revolved, load, &(contact.to_owned() + &pair(kind))));
            assert_close(&format!("{name} {body:?} {revolved} {kind} {load}"), found, expected);
        }
    }
}

/// A02: LINEAR K = 4000 and its table: x = 0.18, p = 320.
#[test]
fn a02_linear_slider() {
    everywhere("laws_linear", 500.0, &law("LINEAR", "4000.\n"), [0.18, 320.0]);
    everywhere("laws_two_points", 500.0, &law("TABULAR", "0., 0.\n4000., 1.\n"), [0.18, 320.0]);
}

/// A03: c₀ = 0.05, p₀ = 200; a largest slope has no effect in a static step, which is told.
#[test]
fn a03_exponential_slider() {
    let expected = [0.113951372312813, 386.0486276871873];
    everywhere("laws_exponential", 500.0, &law("EXPONENTIAL", "0.05, 200.\n"), expected);
    let limited = law("EXPONENTIAL", "0.05, 200., 3e4\n") + &pair(KINDS[0]);
    let limited = deck(Body::Brick, false, 500.0, &limited);
    assert_close("limited", solve("laws_limited", Body::Brick, &limited), expected);
    let scratch = Scratch::new("laws_limited_told");
    scratch.write("slider.inp", &limited);
    let told = scratch.fe(&["check", "slider.inp"]).output;
    assert!(told.contains("largest slope") && told.contains("in Explicit only"), "{told}");
}

/// A05: before the plateau, on it, and beyond.
#[test]
fn a05_tabular_slider() {
    for (load, expected) in [
        (90.0, [0.08 + 0.02 / 3.0, 10.0 / 3.0]),
        (140.0, [0.13, 10.0]),
        (300.0, [0.179 + 0.0005 / 3.0, 120.0 + 2.5 / 3.0]),
        // Beyond the table: 1000 x + 260 + 600 (x − 0.3) = 700.
        (700.0, [0.3875, 312.5]),
    ] {
        everywhere("laws_tabular", load, &law("TABULAR", A05), expected);
    }
}

/// A formula that says the same as A02, A03 and A05 has their answers; K h^1.5 with K = 45000: 1000 x + K (x − 0.1)^1.5 = 500
/// has x = 0.14, where p = 360.
#[test]
fn a_formula_has_the_closed_answer() {
    let exponential = "p = p0/(exp(1) - 1) * z * (exp(z) - 1)\nz = 1 + h/c0\nc0 = 0.05\np0 = 200.\nreach = c0\n";
    let tabular =
        "p = 500*max(0, h + 0.02) - 500*max(0, h) + 3800*max(0, h - 0.05) - 3200*max(0, h - 0.1)\nreach = 0.02\n";
    for (name, load, formula, expected) in [
        ("linear", 500.0, "p = K*h\nK = 4000.\n", [0.18, 320.0]),
        ("exponential", 500.0, exponential, [0.113951372312813, 386.0486276871873]),
        ("tabular", 300.0, tabular, [0.179 + 0.0005 / 3.0, 120.0 + 2.5 / 3.0]),
        ("plateau", 140.0, tabular, [0.13, 10.0]),
        ("hertz", 500.0, "p = K * h^1.5\nK = 4.5e4\n", [0.14, 360.0]),
    ] {
        everywhere(&format!("laws_formula_{name}"), load, &law("FORMULA", formula), expected);
    }
}

/// Four nodes without area: the law's number is a force, a quarter of the load on each; with areas a pressure again.
#[test]
fn without_area_the_number_is_a_force() {
    let quarters = "0., -0.02\n2.5, 0.\n2.5, 0.05\n50., 0.10\n65., 0.20\n";
    let [x, p] = [0.179 + 0.0005 / 3.0, 120.0 + 2.5 / 3.0];
    for (area, table, number) in [("", quarters, 0.25 * p), (", 0.25", A05, p)] {
        let nodes = format!("*SURFACE, NAME=POINTS, TYPE=NODE\nNEAR{area}\n");
        let contact = nodes + &law("TABULAR", table) + &pair(KINDS[1]).replace("SEC,", "POINTS,");
        let found = solve("laws_points", Body::Brick, &deck(Body::Brick, true, 300.0, &contact));
        assert_close(area, found, [x, number]);
    }
}

/// The plan shows each law with its numbers, and their units as the surface has areas or not.
#[test]
fn the_plan_shows_the_law() {
    let scratch = Scratch::new("laws_plan");
    let points = "*SURFACE, NAME=POINTS, TYPE=NODE\nNEAR\n";
    for (name, data, area, point) in [
        ("LINEAR", "4000.\n", "LINEAR, slope 4000 [F/L³]", "LINEAR, slope 4000 [F/L]"),
        ("EXPONENTIAL", "0.05, 200.\n", "200 [F/L²] at zero clearance with slope 1.032791e4 [F/L³]", "200 [F] at zero"),
        (
            "FORMULA",
            "p = K * h^1.5\nK = 4e4\n",
            "FORMULA, [F/L²] of the overclosure h [L]: p = K * h^1.5; K = 4e4",
            "FORMULA, [F] of",
        ),
        ("TABULAR", A05, "[F/L²] at an overclosure [L]: 0 at -0.02, 10 at 0, 10 at 0.05", "on with slope 600 [F/L]"),
    ] {
        for (contact, words) in [
            (law(name, data) + &pair(KINDS[0]), area),
            (points.to_owned() + &law(name, data) + &pair(KINDS[1]).replace("SEC,", "POINTS,"), point),
        ] {
            scratch.write("slider.inp", &deck(Body::Brick, false, 500.0, &contact));
            let told = scratch.fe(&["check", "slider.inp"]);
            assert!(told.status == 0 && told.output.contains(words), "{words}: {}{}", told.output, told.error);
        }
    }
}
