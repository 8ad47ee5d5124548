//! Contact elements between beams and trusses, through the program; cubic beams are exact at their nodes, so the algebraic
//! bound holds, times the condition number above 1e4 (a chain of ten beams is 10⁴ times as stiff in its last element as in
//! all, along its axis more than that).
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::Job;
use std::f64::consts::PI;

const YOUNG: f64 = 2.1e5;
const BOUND: f64 = 1e-7;

/// Displacements and contact forces of the last increment, `[points × 3]`.
fn solve(name: &str, deck: &str) -> (Vec<f64>, Vec<f64>) {
    let results = Job::run(name, deck).results();
    let last = results.times().len() - 1;
    (results.point_field("U", 3, last), results.point_field("CNORMF", 3, last))
}

fn close(what: &str, found: f64, expected: f64, bound: f64) {
    assert!((found - expected).abs() <= bound * expected.abs().max(1e-3), "{what}: {found}, not {expected}");
}

/// Moment of inertia of a pipe.
fn inertia(outer: f64, inner: f64) -> f64 {
    PI / 64.0 * (outer.powi(4) - inner.powi(4))
}

/// Two concentric cantilevers of ten B33 each, inner nodes 1…11, outer 101…111; elements at some inner nodes.
fn pipes(at: &[usize], clearance: f64, line: &str, angle: f64, load: f64) -> String {
    let mut deck = String::from("*NODE\n");
    for first in [1, 101] {
        (0..11).for_each(|i| deck += &format!("{}, {}, 0., 0.\n", first + i, 100 * i));
    }
    for (first, set) in [(1, "INNER"), (101, "OUTER")] {
        deck += &format!("*ELEMENT, TYPE=B33, ELSET={set}\n");
        (0..10).for_each(|i| deck += &format!("{}, {}, {}\n", first + i, first + i, first + i + 1));
    }
    for (set, outer, inner) in [("INNER", 44.0f64, 36.0f64), ("OUTER", 60.0, 50.0)] {
        let (area, i) = (PI / 4.0 * (outer * outer - inner * inner), inertia(outer, inner));
        deck += &format!(
            "*BEAM GENERAL SECTION, ELSET={set}, SECTION=GENERAL\n{area}, {i}, 0., {i}, {}\n0., 0., 1.\n{YOUNG}, 8e4\n",
            2.0 * i
        );
    }
    deck += "*ELEMENT, TYPE=ITT31, ELSET=TUBES\n";
    at.iter().for_each(|n| deck += &format!("{}, {n}\n", 200 + n));
    let (sine, cosine) = angle.sin_cos();
    deck + &format!(
        "*INTERFACE, ELSET=TUBES\n{clearance}\n*SLIDE LINE, ELSET=TUBES, GENERATE, {line}\n101, 111\n\
         *BOUNDARY\n1, 1, 6\n101, 1, 6\n*STEP\n*STATIC\n*CLOAD\n11, 2, {}\n11, 3, {}\n*END STEP\n",
        load * cosine,
        load * sine
    )
}

/// N, and the tips' deflections, of the closed form.
fn pipes_in_contact(clearance: f64, load: f64) -> [f64; 3] {
    let stiffness = |outer, inner| 3.0 * YOUNG * inertia(outer, inner) / 1e9;
    let (inner, outer) = (stiffness(44.0, 36.0), stiffness(60.0, 50.0));
    let force = (load / inner - clearance) / (1.0 / inner + 1.0 / outer);
    [force, (load - force) / inner, force / outer]
}

fn check_pipes(name: &str, (what, deck): (&str, &str), angle: f64, expected: [f64; 3]) {
    let (u, f) = solve(name, deck);
    let (sine, cosine) = angle.sin_cos();
    for (c, direction) in [(1, cosine), (2, sine)] {
        close(what, f[3 * 10 + c], -expected[0] * direction, BOUND);
        close(what, u[3 * 10 + c], expected[1] * direction, BOUND);
        close(what, u[3 * 21 + c], expected[2] * direction, BOUND);
    }
}

/// The same force for lines of both kinds, for any direction of the load, and with elements at ten stations.
#[test]
fn a07_itt_pipe_in_pipe() {
    let expected = pipes_in_contact(3.0, 2000.0);
    close("closed form", expected[0], 1382.0532848063135, 1e-12);
    let ten: Vec<usize> = (2..=11).collect();
    for (at, line, angle) in [
        (&[11][..], "TYPE=LINEAR", 0.0),
        (&[11], "TYPE=PARABOLIC", 0.0),
        (&[11], "TYPE=LINEAR, SMOOTH=0.2", 1.0),
        (&ten, "TYPE=LINEAR", -2.3),
    ] {
        let what = format!("{} {line} {angle}", at.len());
        check_pipes("pipes", (&what, &pipes(at, 3.0, line, angle, 2000.0)), angle, expected);
    }
}

/// A07: the pipes touch first under P = k_i c; a little less leaves them open.
#[test]
fn a07_first_touch() {
    let touch = 191.9035589260018;
    let stiffness = 3.0 * YOUNG * inertia(44.0, 36.0) / 1e9;
    close("closed form", 3.0 * stiffness, touch, 1e-12);
    for (part, force) in [(1.0 - 1e-6, 0.0), (1.0 + 1e-3, pipes_in_contact(3.0, 1.001 * touch)[0])] {
        let (u, f) = solve("pipes_touch", &pipes(&[11], 3.0, "TYPE=LINEAR", 0.0, part * touch));
        // The force is the difference of numbers a thousand times as large.
        close("force", if f[3 * 10 + 1].is_nan() { 0.0 } else { -f[3 * 10 + 1] }, force, 1e3 * BOUND);
        close("tip", u[3 * 10 + 1], (part * touch - force) / stiffness, BOUND);
    }
}

/// A07 with n linear beams: their flexibilities are 1 − 1/(4n²) of bending, and L/(κ G A) of shear. The element's E11 is the
/// clearance used up, its S11 the force.
#[test]
fn a07_pipes_of_linear_beams() {
    // The modulus of the deck's sections; κ of a general section is 1.
    let shear = 8e4;
    let flexibility = |outer: f64, inner: f64| {
        let area = PI / 4.0 * (outer * outer - inner * inner);
        1e9 / (3.0 * YOUNG * inertia(outer, inner)) * (1.0 - 1.0 / 400.0) + 1e3 / (shear * area)
    };
    let (inner, outer) = (flexibility(44.0, 36.0), flexibility(60.0, 50.0));
    let force = (2000.0 * inner - 3.0) / (inner + outer);
    let deck = pipes(&[11], 3.0, "TYPE=LINEAR", 0.4, 2000.0)
        .replace("TYPE=B33", "TYPE=B31")
        .replace("*END STEP", "*EL PRINT, ELSET=TUBES\nS, E\n*END STEP");
    let job = Job::run("linear_pipes", &deck);
    // Tables print ten digits, and linear beams of this slenderness keep eight.
    close("S11", job.last("stresses", "TUBES", 1), force, BOUND);
    close("E11", job.last("strains", "TUBES", 1), 0.0, 1e-6);
}

/// A clearance of a billionth of the radius, and none at all, where the pipes begin concentric.
#[test]
fn d23_thin_itt() {
    for clearance in [22e-9, 0.0] {
        let deck = pipes(&[11], clearance, "TYPE=LINEAR", 0.7, 2000.0);
        check_pipes("thin_pipes", (&format!("{clearance}"), &deck), 0.7, pipes_in_contact(clearance, 2000.0));
    }
    // Open: no load, no force.
    let (u, f) = solve("pipes_open", &pipes(&[11], 1.0, "TYPE=LINEAR", 0.0, 0.0));
    assert!(u.iter().all(|v| *v == 0.0) && f.iter().all(|v| v.is_nan() || *v == 0.0));
    // Side by side needs a distance.
    let scratch = Scratch::new("pipes_refused");
    scratch.write("job.inp", &pipes(&[11], -3.0, "TYPE=LINEAR", 0.0, 1.0));
    let run = scratch.fe(&["run", "job.inp", "--quiet"]);
    assert!(run.status == 1 && run.error.contains("element 211 (ITT31) has no direction"), "{}", run.error);
}

/// Two bars, apex over a gap of 1: N = 3000 − 2 EA 100²/L₀³.
#[test]
fn a08_two_bar_truss_on_gap() {
    let deck = "*NODE\n1, -1000., 0., 0.\n2, 0., 100., 0.\n3, 1000., 0., 0.\n4, 7., 5., 3.\n*NSET, NSET=HELD\n1, 3, 4\n\
                *ELEMENT, TYPE=T3D2, ELSET=BARS\n1, 1, 2\n2, 2, 3\n*ELEMENT, TYPE=GAPUNI, ELSET=G\n3, 4, 2\n\
                *MATERIAL, NAME=M\n*ELASTIC\n1e6, 0.\n*SOLID SECTION, ELSET=BARS, MATERIAL=M\n1.\n\
                *GAP, ELSET=G\n1., 0., 1., 0.\n*BOUNDARY\nHELD, 1, 3\n2, 3\n\
                *STEP\n*STATIC\n*CLOAD\n2, 2, -3000.\n*END STEP\n";
    let (u, f) = solve("truss_on_gap", deck);
    close("apex", u[4], -1.0, 1e-10);
    close("force", f[4], 2980.2962932631685, 1e-10);
}

/// Two cantilevers whose tips overlap by 3: N = 3/(1/96 + 1/24) = 57.6, in one increment and in ten, and in ten over which the
/// overlap is taken out.
#[test]
fn a16_cantilever_misfit() {
    for steps in [
        "1., 1.",
        "0.1, 1., 0.1, 0.1",
        "0.1, 1., 0.1, 0.1\n*CONTACT INTERFERENCE, TYPE=ELEMENT\nG, 3.",
        "0.1, 1., 0.1, 0.1\n*CONTACT INTERFERENCE, TYPE=ELEMENT\nG, 3., 0., 1., 0.",
        "0.1, 1., 0.1, 0.1\n*CONTACT INTERFERENCE, TYPE=ELEMENT, SHRINK\nG",
    ] {
        let deck = format!(
            "*NODE\n1, 0., 0., 0.\n2, 500., 0., 0.\n3, 1000., 0., 0.\n4, 500., 0., 0.\n\
             *ELEMENT, TYPE=B33, ELSET=STIFF\n1, 1, 2\n*ELEMENT, TYPE=B33, ELSET=SOFT\n2, 3, 4\n\
             *BEAM GENERAL SECTION, ELSET=STIFF, SECTION=GENERAL\n100., 4e4, 0., 4e4, 8e4\n0., 0., 1.\n1e5, 4e4\n\
             *BEAM GENERAL SECTION, ELSET=SOFT, SECTION=GENERAL\n100., 1e4, 0., 1e4, 2e4\n0., 0., 1.\n1e5, 4e4\n\
             *ELEMENT, TYPE=GAPUNI, ELSET=G\n3, 2, 4\n*GAP, ELSET=G\n-3., 0., 1., 0.\n\
             *BOUNDARY\n1, 1, 6\n3, 1, 6\n*STEP\n*STATIC\n{steps}\n*END STEP\n"
        );
        let (u, f) = solve("misfit", &deck);
        close(steps, u[3 + 1], -0.6, BOUND);
        close(steps, u[9 + 1], 2.4, BOUND);
        close(steps, f[9 + 1], 57.6, BOUND);
    }
}
