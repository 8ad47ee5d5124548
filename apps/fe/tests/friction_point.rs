//! A28: surfaces under a constant pressure of 100 along a given path, μ = 0.3: shear, slip and the work that is lost. A
//! column of area 1 is pressed onto a rigid plane by its load alone, and all its nodes, or the plane, move along it.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use common::slider::{Body, pair};

/// Bound of shears over the largest one, of slips over the longest, of works over the whole one: a discrete problem that
/// has the closed answer.
const ALGEBRAIC: f64 = 1e-10;

const KINDS: [&str; 2] = ["SURFACE TO SURFACE", "NODE TO SURFACE"];
const LAWS: [&str; 3] = [", DIRECT\n", ", PENALTY\n", ", PRESSURE-OVERCLOSURE=LINEAR\n1000.\n"];

/// Where the moving side stands at the end of each step [L].
const PATH: [f64; 5] = [0.005, 0.02, 0.015, 0.0, -0.02];

/// What moves along the plane.
#[derive(Clone, Copy, Debug)]
struct Drive {
    body: Body,
    /// `ALL` for the column, `REF` for the plane.
    set: &'static str,
    /// Direction.
    component: usize,
    /// The other direction in which it moves as far, if so.
    both: bool,
}

const DRIVES: [Drive; 5] = [
    Drive { body: Body::Plane, set: "ALL", component: 1, both: false },
    Drive { body: Body::Brick, set: "ALL", component: 1, both: false },
    Drive { body: Body::Brick, set: "ALL", component: 2, both: false },
    Drive { body: Body::Brick, set: "REF", component: 1, both: false },
    Drive { body: Body::Brick, set: "ALL", component: 1, both: true },
];

/// Column and plane, which touch; the far face is FAR, all nodes of the column ALL.
fn model(body: Body, law: &str, friction: &str, kind: &str) -> String {
    let far = if body == Body::Brick { "S2" } else { "S3" };
    format!(
        "{}{}*NSET, NSET=ALL\nNEAR, HELD\n*SURFACE, NAME=FAR\nE, {far}\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR{law}*FRICTION{friction}{}",
        body.deck(),
        body.stop(false).replace("-0.1", "0."),
        pair(kind)
    )
}

/// A step in so many increments, down to a residual of round-off.
fn step(increments: usize, cards: &str) -> String {
    let first = 1.0 / increments as f64;
    format!("*STEP\n*STATIC, DIRECT\n{first}, 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n{cards}*END STEP\n")
}

fn along_path(drive: Drive, model: &str, increments: usize) -> String {
    let lateral = if drive.body == Body::Brick { 2 } else { 1 };
    let supports = format!("*BOUNDARY\nREF, 1, 6\nALL, 1, {lateral}\n");
    let moved = |x: f64| {
        let Drive { set, component, both, .. } = drive;
        let last = if both { 2 } else { component };
        // As far along the diagonal.
        let x = if both { x * std::f64::consts::FRAC_1_SQRT_2 } else { x };
        step(increments, &format!("*BOUNDARY\n{set}, {component}, {last}, {x:e}\n"))
    };
    let steps: String = PATH.map(moved).concat();
    format!("{model}{supports}{}{steps}", step(1, "*DSLOAD\nFAR, P, 100.\n"))
}

/// What a run leaves: shears and slips of the near face along the path at the end of each step, the first one too, and the
/// work that friction took.
struct Found {
    shears: Vec<[f64; 2]>,
    slips: Vec<[f64; 2]>,
    lost: f64,
}

/// Runs a deck of steps in so many increments; the numbers are the same at all four, or two, nodes.
fn solve(scratch: &Scratch, body: Body, deck: &str, increments: usize) -> Found {
    scratch.write("point.inp", deck);
    let report = fe::run(&scratch.path("point.inp"), &fe::standard(), &mut fe::observer::Silent)
        .unwrap_or_else(|failure| panic!("{failure}\n{deck}"));
    let results = Results::open(&report.results);
    let corners: &[[f64; 3]] = match body {
        Body::Brick => &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]],
        _ => &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]],
    };
    let nodes: Vec<usize> = corners.iter().map(|&corner| results.point_at(corner)).collect();
    let at_ends = |name: &str, size: f64| {
        let ends = (1..results.times().len()).filter(|frame| *frame == 1 || (frame - 1) % increments == 0);
        let of_frame = |frame| {
            let pair = [1, 2].map(|i| results.point_field(&format!("{name}{i}"), 1, frame));
            let values = nodes.iter().map(|&n| [pair[0][n], pair[1][n]]);
            let first = [pair[0][nodes[0]], pair[1][nodes[0]]];
            values.for_each(|v| assert_near(name, &v, &first, size));
            first
        };
        ends.map(of_frame).collect::<Vec<_>>()
    };
    let lost = report.last.energy.friction;
    Found { shears: at_ends("CSHEAR", 30.0), slips: at_ends("CSLIP", 0.02), lost }
}

fn assert_near(what: &str, found: &[f64], expected: &[f64], size: f64) {
    let near = found.iter().zip(expected).all(|(f, e)| (f - e).abs() <= ALGEBRAIC * size);
    assert!(near && found.len() == expected.len(), "{what}: {found:?}, not {expected:?}");
}

/// Components along the path: the secondary side slips against the plane as the column does, or against it.
fn assert_along(what: &str, drive: Drive, found: &[[f64; 2]], expected: &[f64], size: f64) {
    // In a plane t₁ = e_z × n, and n points up.
    let direction = match (drive.set, drive.both, drive.component) {
        _ if drive.body == Body::Plane => [-1.0, 0.0],
        ("REF", ..) => [-1.0, 0.0],
        (_, true, _) => [std::f64::consts::FRAC_1_SQRT_2; 2],
        (.., 2) => [0.0, 1.0],
        _ => [1.0, 0.0],
    };
    let expected: Vec<f64> = expected.iter().flat_map(|e| direction.map(|d| d * e)).collect();
    assert_near(what, found.as_flattened(), &expected, size);
}

/// Elastic slip 0.01, also under TAUMAX = 20, and sticking points that do not move: from one increment a step or three.
#[test]
fn a28_coulomb_point() {
    let scratch = Scratch::new("friction_point");
    let cases = [
        (", ELASTIC SLIP=0.01\n0.3\n", [0.0, 15.0, 30.0, 15.0, -30.0, -30.0], 0.9),
        (", ELASTIC SLIP=0.01, TAUMAX=20.\n0.3\n", [0.0, 10.0, 20.0, 10.0, -20.0, -20.0], 0.6),
        (", LAGRANGE\n0.3\n", [0.0, 30.0, 30.0, -30.0, -30.0, -30.0], 30.0 * 0.06),
    ];
    for (friction, shears, lost) in cases {
        for drive in DRIVES {
            for ((law, kind), increments) in LAWS.into_iter().zip(KINDS.into_iter().cycle()).zip([1, 3, 1]) {
                let what = format!("{friction}{law}{kind} {increments} {drive:?}");
                let deck = along_path(drive, &model(drive.body, law, friction, kind), increments);
                let found = solve(&scratch, drive.body, &deck, increments);
                assert_along(&what, drive, &found.shears, &shears, 30.0);
                let slips: Vec<f64> = [0.0].into_iter().chain(PATH).collect();
                assert_along(&what, drive, &found.slips, &slips, 0.02);
                assert_near(&what, &[found.lost], &[lost], lost);
            }
        }
    }
}

/// The far face is driven along the plane, the near one is free to follow: the column is sheared by τ = G (U − slip), G = 500,
/// under an overclosure of 0.1 that presses by 100. Exact stick: nothing slips up to μ p, all of the rest does beyond. Rough:
/// nothing slips at any shear, but for what a penalty of 1000 gives way.
#[test]
fn a28_sheared_column() {
    let scratch = Scratch::new("friction_sheared");
    let linear = ", PRESSURE-OVERCLOSURE=LINEAR\n1000.\n";
    let stiff = [0.05, 1.0, -1.0, 0.0];
    let given_way = |u: f64| u * 500.0 / 1500.0;
    type Case<'a> = (&'a str, &'a str, [f64; 4], [f64; 4], f64);
    let cases: [Case; 3] = [
        (linear, ", LAGRANGE\n0.3\n", [0.05, 0.1, 0.05, -0.05], [0.0, 0.04, 0.04, 0.01], 30.0 * 0.07),
        (linear, ", ROUGH\n", stiff, [0.0; 4], 0.0),
        (", PENALTY\n1000.\n", ", ROUGH\n", stiff, stiff.map(given_way), 0.0),
    ];
    for (law, friction, path, slips, lost) in cases {
        for body in [Body::Plane, Body::Brick] {
            for kind in KINDS {
                let what = format!("{friction}{law}{kind} {body:?}");
                let drive = Drive { body, set: "ALL", component: 1, both: false };
                let axis = body.axis();
                let across = if body == Body::Brick { "ALL, 2\n" } else { "" };
                let first = step(1, &format!("*BOUNDARY\nALL, {axis}, {axis}, -0.1\n"));
                let steps = path.map(|u| step(1, &format!("*BOUNDARY\nHELD, 1, 1, {u}\n"))).concat();
                let model = model(body, law, friction, kind);
                let deck = format!("{model}*BOUNDARY\nREF, 1, 6\nHELD, 1\n{across}{first}{steps}");
                let found = solve(&scratch, body, &deck, 1);
                let shears = path.iter().zip(slips).map(|(u, slip)| 500.0 * (u - slip));
                let shears: Vec<f64> = [0.0].into_iter().chain(shears).collect();
                let slips: Vec<f64> = [0.0].into_iter().chain(slips).collect();
                assert_along(&what, drive, &found.shears, &shears, 500.0);
                assert_along(&what, drive, &found.slips, &slips, 1.0);
                assert_near(&what, &[found.lost], &[lost], 2.0);
            }
        }
    }
}
