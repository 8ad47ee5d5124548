//! The slider built of springs and contact elements, or a node on a plane, through the program: k x + A p(x − g₀) = F with g₀ = 0.1 and
//! k = 1000. Read with all digits from the results file; the algebraic bound of 1e-10 holds.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{ALGEBRAIC, Job, close, relative};

/// The stop.
#[derive(Clone, Copy, Debug)]
enum Stop {
    /// GAPUNI with an area, or without: the law's number is a force. Its direction is not a unit vector, and its nodes are
    /// anywhere.
    Gap(Option<f64>),
    /// ITT31 in the middle of a slide line that is held.
    Tube,
    /// The node as a surface, with an area or without, on a rigid plane.
    Node(Option<f64>),
}

const STOPS: [Stop; 6] = [
    Stop::Gap(Some(1.0)),
    Stop::Gap(Some(0.25)),
    Stop::Gap(None),
    Stop::Tube,
    Stop::Node(Some(0.25)),
    Stop::Node(None),
];

impl Stop {
    fn area(self) -> f64 {
        if let Stop::Gap(Some(area)) | Stop::Node(Some(area)) = self { area } else { 1.0 }
    }

    /// Node 1 slides along y on a spring; `behavior` follows the card of the stop.
    fn deck(self, behavior: &str) -> String {
        let stop = match self {
            Stop::Gap(area) => format!(
                "*ELEMENT, TYPE=GAPUNI, ELSET=STOP\n2, 2, 1\n*GAP, ELSET=STOP\n0.1, 0., -3., 0.{}\n",
                area.map_or(String::new(), |area| format!(", {area}"))
            ),
            Stop::Tube => "*ELEMENT, TYPE=ITT31, ELSET=STOP\n2, 1\n*SLIDE LINE, ELSET=STOP, TYPE=LINEAR\n2, 3\n\
                           *INTERFACE, ELSET=STOP\n0.1\n"
                .into(),
            Stop::Node(area) => format!(
                "*SURFACE, NAME=POINT, TYPE=NODE\n1{}\n*SURFACE, NAME=FLAT, TYPE=CYLINDER\n0., 0.1, 0., 1., 0.1, 0.\n\
                 0., 0.1, 1.\nSTART, -5., 0.\nLINE, 5., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE=2\n\
                 *BOUNDARY\n2, 4, 6\n*SURFACE INTERACTION, NAME=I\n",
                area.map_or(String::new(), |area| format!(", {area}"))
            ),
        };
        // A spring alone gives its node the freedom along it.
        let (pair, across, held) = match self {
            Stop::Node(_) => ("*CONTACT PAIR, INTERACTION=I\nPOINT, FLAT\n", "", "2, 1, 3\n"),
            _ => ("", "1, 1\n1, 3\n", "HELD, 1, 3\n"),
        };
        format!(
            "*NODE\n1, 0., 0., 0.\n2, -2., 0., 0.\n3, 1., 0., 0.\n*NSET, NSET=HELD\n2, 3\n\
             *ELEMENT, TYPE=SPRING1, ELSET=SPRING\n1, 1\n*SPRING, ELSET=SPRING\n2\n1000.\n{stop}{behavior}{pair}\
             *BOUNDARY\n{across}{held}"
        )
    }
}

/// Steps with these loads, to a residual of 1e-12.
fn steps(loads: &[f64]) -> String {
    let step =
        |load: &f64| format!("*STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*CLOAD\n1, 2, {load}\n*END STEP\n");
    loads.iter().map(step).collect()
}

/// Displacement of node 1 and the force of the stop on it, against the load, at the end of the last increment.
fn solve(name: &str, deck: &str) -> [f64; 2] {
    let results = Job::run(name, deck).results();
    let (node, last) = (3 * results.point_at([0.0; 3]) + 1, results.times().len() - 1);
    [results.point_field("U", 3, last)[node], -results.point_field("CNORMF", 3, last)[node]]
}

/// With the balance k x + N = F of an expected force N.
fn everywhere(name: &str, load: f64, behavior: impl Fn(f64) -> String, force: impl Fn(f64) -> f64) {
    for stop in STOPS {
        let area = stop.area();
        let found = solve(name, &(stop.deck(&behavior(area)) + &steps(&[load])));
        let force = force(area);
        relative(&format!("{name} {stop:?}"), found, [(load - force) / 1000.0, force], ALGEBRAIC);
    }
}

/// N = 400 β/(1+β) for a penalty of βk over all of the area, over twelve orders of magnitude; a clearance of the penalty
/// brings the stop nearer, and a factor multiplies it. By multipliers N = 400.
#[test]
fn a01_hard_slider() {
    for beta in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
        let penalty = |area: f64| format!("*SURFACE BEHAVIOR, PENALTY\n{}\n", 1000.0 * beta / area);
        everywhere("element_penalty", 500.0, penalty, |_| 400.0 * beta / (1.0 + beta));
    }
    let nearer = |area: f64| format!("*SURFACE BEHAVIOR, PENALTY\n{}, 0.05\n", 1000.0 / area);
    everywhere("element_clearance", 500.0, nearer, |_| 225.0);
    let scaled = |area: f64| format!("*SURFACE BEHAVIOR, PENALTY\n{}, , 4.\n", 250.0 / area);
    everywhere("element_scale", 500.0, scaled, |_| 200.0);
    for behavior in ["", "*SURFACE BEHAVIOR\n", "*SURFACE BEHAVIOR, DIRECT\n"] {
        everywhere("element_hard", 500.0, |_| behavior.into(), |_| 400.0);
    }
}

#[test]
fn a02_linear_slider() {
    let linear = |_| "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n4000.\n".to_owned();
    // x = (F + A K g₀)/(k + A K).
    let force = |area: f64| {
        let slope = 4000.0 * area;
        500.0 - 1000.0 * (500.0 + slope * 0.1) / (1000.0 + slope)
    };
    assert!((force(1.0) - 320.0).abs() < 1e-12);
    everywhere("element_linear", 500.0, linear, force);
}

/// With an area A the number of the law is A times smaller: p₀/A gives the same force.
#[test]
fn a03_exponential_slider() {
    let law = |area: f64| format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n0.05, {}\n", 200.0 / area);
    everywhere("element_exponential", 500.0, law, |_| 386.0486276871873);
}

#[test]
fn a05_tabular_slider() {
    let table = [(0.0, -0.02), (10.0, 0.0), (10.0, 0.05), (200.0, 0.1), (260.0, 0.2)];
    let law = |area: f64| {
        let lines: String = table.iter().map(|(p, h)| format!("{}, {h}\n", p / area)).collect();
        format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n{lines}")
    };
    for (load, force) in [(90.0, 10.0 / 3.0), (140.0, 10.0), (300.0, 362.5 / 3.0)] {
        everywhere("element_table", load, law, |_| force);
    }
}

/// Pulled back to −300 after closing the stop holds on, or lets go at 100; one that never closed carries no tension.
#[test]
fn a06_no_separation() {
    for stop in STOPS {
        let held = stop.deck("*SURFACE BEHAVIOR, NO SEPARATION\n");
        let what = format!("{stop:?}");
        let found = solve("element_held", &(held.clone() + &steps(&[500.0, -300.0])));
        relative(&what, found, [0.1, -400.0], ALGEBRAIC);
        // The tube is free to go across its line, and meets it on the other side.
        let far = if matches!(stop, Stop::Tube) { [-0.1, -200.0] } else { [-0.3, 0.0] };
        relative(&what, solve("element_free", &(stop.deck("") + &steps(&[500.0, -300.0]))), far, ALGEBRAIC);
        relative(&what, solve("element_open", &(held + &steps(&[-50.0]))), [-0.05, 0.0], ALGEBRAIC);
    }
}

/// A06 (c): a pin in a tube of 0.2 more radius, pressed at 30°: N = 300 − 500·0.2, along the load.
#[test]
fn a06_pin_in_a_tube() {
    let (sine, cosine) = 30f64.to_radians().sin_cos();
    let deck = format!(
        "*NODE\n1, 0., 0., 0.\n2, 0., 0., 0.\n3, 9., 9., 9.\n*ELEMENT, TYPE=SPRING1, ELSET=X\n1, 2\n\
         *ELEMENT, TYPE=SPRING1, ELSET=Y\n2, 2\n*SPRING, ELSET=X\n1\n500.\n*SPRING, ELSET=Y\n2\n500.\n\
         *ELEMENT, TYPE=GAPCYL, ELSET=G\n3, 1, 2\n*GAP, ELSET=G\n0.2, 0., 0., 1.\n*BOUNDARY\n1, 1, 3\n2, 3\n\
         *STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*CLOAD\n2, 1, {}\n2, 2, {}\n\
         *EL PRINT, ELSET=G\nS, E\n*END STEP\n",
        300.0 * cosine,
        300.0 * sine
    );
    let job = Job::run("pin", &deck);
    let results = job.results();
    let last = results.times().len() - 1;
    let (u, f) = (results.point_field("U", 3, last), results.point_field("CNORMF", 3, last));
    // Node 2 comes second.
    for (c, direction) in [cosine, sine].into_iter().enumerate() {
        relative("pin", [u[3 + c], f[3 + c]], [0.2 * direction, -200.0 * direction], ALGEBRAIC);
    }
    // Ten digits are printed.
    close("pin", [job.last("stresses", "G", 1)], [200.0], 1e-6);
    close("pin", [job.last("strains", "G", 1)], [0.0], 1e-9);
}
