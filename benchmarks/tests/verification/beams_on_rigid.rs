//! A10, A12: beams on rigid surfaces, by half: the middle at x = 0 neither turns nor goes along.

use crate::lines::{ALGEBRAIC, along_x, close, forces, of_forces, parts, row, section, solve, step};
use benchmarks::hard::Solved;
use std::f64::consts::PI;

/// A rigid line along x in the plane, or what its profile is; a pair of the lower side of the set BEAM with it.
fn on_floor(profile: &str, behavior: &str) -> String {
    format!(
        "*NODE\n9999, 0., -5.\n*SURFACE, NAME=FOOT\nBEAM, SNEG\n*SURFACE, NAME=FLOOR, TYPE=SEGMENTS\n{profile}\
         *RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=9999\n*SURFACE INTERACTION, NAME=I\n{behavior}\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE, SMALL SLIDING\nFOOT, FLOOR\n\
         *BOUNDARY\n9999, 1, 6\n1, 6\nN_BEAM, 1\n"
    )
}

const FLAT: &str = "START, -5000., 0.\nLINE, 5000., 0.\n";

/// A10: EI = 4.2e9, k = 5 force per length and overclosure, P = 1e4 in the middle.
const BED: f64 = 5.0;
const LOAD: f64 = 1e4;
const INERTIA: f64 = 2e4;
const YOUNG: f64 = 2.1e5;

fn lambda() -> f64 {
    (BED / (4.0 * YOUNG * INERTIA)).powf(0.25)
}

/// How the bed is made.
#[derive(Clone, Copy, Debug)]
enum Bed {
    /// Springs, which pull too.
    Springs,
    /// LINEAR contact of a line in space on a rigid plane.
    Line,
    /// The same in the plane, of the lower side.
    Side,
}

/// Half the beam in n parts. In space it bends about y.
fn bedded(bed: Bed, length: f64, n: usize) -> String {
    let (element, lift) = if matches!(bed, Bed::Line) { ("B33", 3) } else { ("B23", 2) };
    let law = format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{BED}\n");
    let bed = match bed {
        Bed::Springs => springs(length / n as f64, n),
        Bed::Line => format!(
            "*NODE\n9999, 0., 0., -5.\n*SURFACE, NAME=LINE\nBEAM,\n*SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n\
             0., 1., 0.\nSTART, -5000., 0.\nLINE, 5000., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=9999\n\
             *SURFACE INTERACTION, NAME=I\n{law}*CONTACT PAIR, INTERACTION=I\nLINE, FLOOR\n\
             *BOUNDARY\n9999, 1, 6\n1, 1\n1, 5\nN_BEAM, 2\nN_BEAM, 4\nN_BEAM, 6\n"
        ),
        Bed::Side => on_floor(FLAT, &law),
    };
    row(element, "BEAM", 1, &along_x(&parts(length, n), 0.0))
        + &section("BEAM", [600.0, INERTIA], YOUNG)
        + &bed
        + &step(&format!("*CLOAD\n1, {lift}, {}\n", -0.5 * LOAD))
}

/// A spring at each node, of half the length at both ends.
fn springs(h: f64, n: usize) -> String {
    let inner: String = (2..=n).map(|i| format!("{}, {i}\n", 1000 + i)).collect();
    let outer = format!("2001, 1\n2002, {}\n", n + 1);
    format!(
        "*ELEMENT, TYPE=SPRING1, ELSET=INNER\n{inner}*ELEMENT, TYPE=SPRING1, ELSET=OUTER\n{outer}\
         *SPRING, ELSET=INNER\n2\n{:?}\n*SPRING, ELSET=OUTER\n2\n{:?}\n*BOUNDARY\nN_BEAM, 1\n1, 6\n",
        BED * h,
        0.5 * BED * h
    )
}

/// Deflection and bending moment in the middle, with x and the deflection w of each node; the moment is that of the forces
/// beneath, Σ f x.
fn middle(solved: &Solved, component: usize, n: usize, h: f64) -> (f64, f64) {
    let w = |i: usize| -solved.displacement(i as u64 + 1).unwrap()[component];
    let share = |i: usize| if i == n { 0.5 * h } else { h };
    let pressed = |i: usize| if solved.pairs.is_empty() { w(i) } else { w(i).max(0.0) };
    (w(0), (1..=n).map(|i| BED * pressed(i) * share(i) * h * i as f64).sum())
}

/// The infinite beam, whose springs pull too: the end of a half of 3000 is e^−12 of it away. Nodal springs are a bed to
/// second order: w₀ to 1e-4 and M₀ to (λh)²/3.
#[test]
fn A10_winkler_bilateral_by_springs() {
    let (n, length) = (150, 3000.0);
    let (h, lambda) = (length / n as f64, lambda());
    let (_, solved) = solve("winkler_springs", &bedded(Bed::Springs, length, n));
    let (w, moment) = middle(&solved, 1, n, h);
    close("A10 springs w₀", w, LOAD * lambda / (2.0 * BED), 1e-4);
    close("A10 springs M₀", moment, LOAD / (4.0 * lambda), (lambda * h).powi(2) / 3.0);
}

/// Tensionless (Weitsman 1970, without weight): contact ends at π/(2λ). Lift-off falls between nodes; beyond it the beam
/// is straight. The force is P exactly.
#[test]
fn A10_winkler_through_contact() {
    let (length, lambda) = (800.0, lambda());
    let coth = 1.0 / (0.5 * PI).tanh();
    for (bed, component) in [(Bed::Line, 2), (Bed::Side, 1)] {
        for n in [40, 80] {
            let h = length / n as f64;
            let (_, solved) = solve(&format!("winkler_{bed:?}_{n}"), &bedded(bed, length, n));
            let (what, order) = (format!("A10 {bed:?} {n}"), (lambda * h).powi(2) / 3.0);
            let (w, moment) = middle(&solved, component, n, h);
            close(&format!("{what} w₀"), w, 4.528701586072404, 1e-4);
            close(&format!("{what} w₀"), w, LOAD * lambda / (2.0 * BED) * coth, 1e-4);
            close(&format!("{what} M₀"), moment, 656271.2085484087, order);
            close(&format!("{what} force"), forces(&solved).iter().sum::<f64>(), 0.5 * LOAD, ALGEBRAIC);
            let points = &solved.pairs[0].points;
            // A force per length, not per area of some width.
            close(&format!("{what} largest"), points[0].pressure, 22.64350793036, 1e-4);
            let pressed = points.iter().filter(|point| point.pressure > 0.0).count();
            let lift = (pressed as f64 - 0.5) * h;
            eprintln!("{what} lift-off: {lift} ± {h}");
            assert!((lift - 378.185345712966).abs() <= h, "{what}: {lift}");
            let end = |i: usize| solved.displacement(i as u64).unwrap()[component];
            close(&format!("{what} slope"), (end(n + 1) - end(n)) / h, 0.01499295807795, order);
        }
    }
}

/// A12: EI = 2e8, end force P = EI / (200 R) at x = 400: the strip is free beyond 200.
const STRIP: f64 = 2e8;
const ARM: f64 = 200.0;

/// Half the strip on a cylinder of this radius, or on a plane with the clearances x²/2R.
fn strip(n: usize, radius: f64, round: bool) -> String {
    let stations = parts(400.0, n);
    let end = -250_000.0 / (radius + (radius * radius - 250_000.0).sqrt());
    let arc = format!("START, -500., {end:?}\nCIRCL, 500., {end:?}, 0., {:?}\n", -radius);
    let clearances: String =
        stations.iter().zip(1..).map(|(x, i)| format!("{i}, {:?}\n", x * x / (2.0 * radius))).collect();
    let clearance = format!("*CLEARANCE, SECONDARY=FOOT, MAIN=FLOOR, TABULAR\n{clearances}");
    row("B23", "BEAM", 1, &along_x(&stations, 0.0))
        + &section("BEAM", [120.0, 1e3], 2e5)
        + &on_floor(if round { &arc } else { FLAT }, "*SURFACE BEHAVIOR, DIRECT\n")
        + if round { "" } else { &clearance }
        + &step(&format!("*CLOAD\n{}, 2, {:?}\n", n + 1, -STRIP / (radius * ARM)))
}

/// Tip drop on the parabola: of the wrap, of its slope, and of the arm.
fn drop(radius: f64) -> f64 {
    ARM * ARM / (2.0 * radius) + ARM * ARM / radius + ARM * ARM / (3.0 * radius)
}

/// How a strip lies.
struct Laid {
    /// Error of the tip's drop, over it.
    tip: f64,
    /// Error of the force at x = 200 (or at the two nodes about it), over P.
    edge: f64,
    /// Largest force of the nodes next to these, over P.
    beside: f64,
    /// Largest other force, over P.
    inside: f64,
}

fn laid(n: usize, radius: f64, round: bool) -> Laid {
    let (_, solved) = solve(&format!("strip_{n}_{round}"), &strip(n, radius, round));
    let (h, load) = (400.0 / n as f64, STRIP / (radius * ARM));
    let mut laid = Laid {
        tip: -solved.displacement(n as u64 + 1).unwrap()[1] / drop(radius) - 1.0,
        edge: -1.0,
        beside: 0.0,
        inside: 0.0,
    };
    for (i, force) in forces(&solved).into_iter().enumerate() {
        match ((i as f64 * h - ARM) / h).abs() {
            away if away < 0.999 => laid.edge += force / load,
            away if away < 1.999 => laid.beside = laid.beside.max(force.abs() / load),
            _ => laid.inside = laid.inside.max(force.abs() / load),
        }
    }
    let Laid { tip, edge, beside, inside } = laid;
    eprintln!("A12 {n} round {round}: tip {tip:.1e}, edge {edge:.1e}, beside {beside:.1e}, inside {inside:.1e}");
    laid
}

/// On the parabola, by clearances on a plane: exact where a node lies at x = 200, with no forces inside the wrap; else the
/// tip is off by at most (h/200)²/10 and two nodes share the force.
#[test]
fn A12_strip_on_parabola() {
    for n in [10, 16, 20, 40, 11, 15, 27] {
        let Laid { tip, edge, beside, inside } = laid(n, 5e4, false);
        let h = 400.0 / n as f64;
        let bound = if n % 2 == 0 { of_forces(n) } else { (h / ARM).powi(2) / 10.0 };
        assert!(tip.abs() < bound && edge.abs() < 1e-6 && beside.max(inside) < 1e-6, "{n}");
    }
}

/// On the cylinder itself, whose profile drops by x²/2R + x⁴/8R³: the strip bridges it. What would have to pull it down
/// there is q = 3 EI/R³ a length, 5e-5 of P on 200; its moment, no more than q 200²/2, is taken by a pair of forces at the
/// edge and the node beside it.
#[test]
fn A12_strip_on_cylinder() {
    let radius = 5e4f64;
    for n in [10, 20, 40] {
        let Laid { tip, edge, beside, inside } = laid(n, radius, true);
        let pair = 3.0 * STRIP / radius.powi(3) * ARM * ARM / 2.0 / (400.0 / n as f64) / (STRIP / (radius * ARM));
        assert!(tip.abs() < 1e-4 && edge.abs() < pair && beside < pair && inside < 1e-6, "{n}");
    }
}
