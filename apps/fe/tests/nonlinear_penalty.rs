//! The slider on a nonlinear penalty, through the program: k x + p(x − g₀) = F with k = 1000, g₀ = 0.1 and area 1, where the
//! elements beneath have the stiffness 1000.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{ALGEBRAIC, Job, relative};
use common::slider::{Body, DISTANCE, K, pair};

const BODIES: [(Body, bool); 4] =
    [(Body::Brick, false), (Body::Brick, true), (Body::Plane, false), (Body::Ring, false)];

/// Length of the near facet [L].
fn facet(body: Body) -> f64 {
    if body == Body::Ring { 1.0 / std::f64::consts::PI.sqrt() } else { 1.0 }
}

/// A load towards the stop, with a residual of 1e-12 of the mean force asked for.
fn deck((body, revolved): (Body, bool), kind: &str, line: &str, load: f64) -> String {
    format!(
        "{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY=NONLINEAR\n{line}{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n\
         *STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*DSLOAD\nSEC, P, {}\n*END STEP\n",
        body.deck(),
        body.stop(revolved),
        pair(kind),
        -load
    )
}

/// Displacement towards the stop and pressure at the node in the origin, and what the program said.
fn solve(name: &str, body: Body, deck: &str) -> ([f64; 2], String) {
    let job = Job::run(name, deck);
    let results = job.results();
    let node = results.point_at([0.0; 3]);
    let last = results.times().len() - 1;
    let x = -results.point_field("U", 3, last)[3 * node + body.axis() - 1];
    ([x, results.point_field("CPRESS", 1, last)[node]], job.told)
}

/// A01: a thousand times the table of K_i = 1, K_f = 100, x_e = 0.01, x_d = 0.03. These are a hundred times the elements
/// beneath, a hundredth of that, and the limits on a facet of length 1: the default. Contact is told to be soft where it is as
/// soft as the elements, below x_e, and beyond x_d.
#[test]
fn a01_slider_on_a_nonlinear_penalty() {
    for (h, p, soft) in
        [(0.005, 5.0, true), (0.01, 10.0, true), (0.02, 267.5, false), (0.03, 1020.0, false), (0.04, 2020.0, true)]
    {
        for (body, revolved) in BODIES {
            let upper = 0.03 / facet(body);
            for line in
                ["".to_owned(), format!("1e5, 0., 1., {upper}\n"), format!("5e4, , 2., {upper}, 0.01, {}\n", 1.0 / 3.0)]
            {
                if line.is_empty() && body == Body::Ring {
                    continue;
                }
                for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
                    let load = K * (DISTANCE + h) + p;
                    let (found, told) = solve("nonlinear_penalty", body, &deck((body, revolved), kind, &line, load));
                    let what = format!("{body:?} {revolved} {kind} {line} {h}");
                    relative(&what, found, [DISTANCE + h, p], ALGEBRAIC);
                    // At the limits themselves rounding decides.
                    let decided = h != 0.01 && h != 0.03;
                    assert!(!decided || told.contains("contact is not hard") == soft, "{what}: {told}");
                }
            }
        }
    }
}

/// The clearance moves the law: x = h + c. Steeper than a thousand times the elements beneath, it is found by multipliers:
/// p = 2 K_i x_e + (K_f − K_i) x_e²/(4 x_e) at x = 2 x_e = 0.02.
#[test]
fn clearance_and_steep_slopes() {
    let steep = 20.0 + (1e7 - 1e3) * 0.01 / 4.0;
    for (line, x, p) in [("1e5, 0.05\n", 0.02 - 0.05, 267.5), ("1e7, 0., 1., 0.03, 1e-4\n", 0.02, steep)] {
        let load = K * (DISTANCE + x) + p;
        let (found, _) = solve(
            "nonlinear_penalty_steep",
            Body::Brick,
            &deck((Body::Brick, false), "SURFACE TO SURFACE", line, load),
        );
        relative(line, found, [DISTANCE + x, p], ALGEBRAIC);
    }
}

#[test]
fn the_plan_shows_slopes_and_limits() {
    let scratch = Scratch::new("nonlinear_penalty_plan");
    scratch.write("slider.inp", &deck((Body::Brick, false), "SURFACE TO SURFACE", "", 500.0));
    let told = scratch.fe(&["check", "slider.inp"]);
    for words in [
        "hard by nonlinear penalty, slope 1.000000e3 [F/L³] up to an overclosure of 1.000e-2 [L], growing to 1.000000e5 [F/L³] \
         at 3.000e-2 [L]",
        "(a hundred times the elements beneath, scale 1)",
    ] {
        assert!(told.status == 0 && told.output.contains(words), "{words}: {}{}", told.output, told.error);
    }
}
