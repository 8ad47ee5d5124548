//! A34 (a), NAFEMS CGS-4: a wedge of weight G on an incline of tan α = t = 0.1 slides up when a horizontal force is
//! F = G (t + μ)/(1 − μ t), and down at G (t − μ)/(1 + μ t), whatever the distribution of its pressure.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;

/// Relative bound of a discrete problem that has the closed answer.
const ALGEBRAIC: f64 = 1e-10;

/// tan α [-].
const T: f64 = 0.1;
/// Weight [F] of the wedge: density 2, area 15, depth 1, gravity 1.
const WEIGHT: f64 = 30.0;

/// How wedge and incline are built.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scene {
    /// Plane strain on a rigid line.
    Plane,
    /// A brick on a rigid plane.
    Brick,
    /// Plane strain on plane strain.
    Deformable,
}

const SCENES: [Scene; 3] = [Scene::Plane, Scene::Brick, Scene::Deformable];

/// Nodes 1 to 8 at most are the wedge's, in WEDGE; its lower face is SEC. It has a level top and upright ends.
fn model(scene: Scene, friction: &str, kind: &str) -> String {
    let corners = [(2.0, 2.0 * T), (8.0, 8.0 * T), (8.0, 3.0), (2.0, 3.0)];
    let brick = scene == Scene::Brick;
    let mut nodes = String::new();
    for (layer, depth) in [0.0, 1.0].into_iter().take(if brick { 2 } else { 1 }).enumerate() {
        for (k, (x, y)) in corners.iter().enumerate() {
            nodes += &format!("{}, {x:e}, {y:e}, {depth:e}\n", 4 * layer + k + 1);
        }
    }
    let element = if brick { "C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8" } else { "CPE4, ELSET=E\n1, 1, 2, 3, 4" };
    let last = if brick { 8 } else { 4 };
    let end = 10.0 * T;
    let (incline, supports) = match scene {
        Scene::Plane => (format!("TYPE=SEGMENTS\nSTART, 0., 0.\nLINE, 10., {end:e}\n"), "99, 1, 6\n"),
        Scene::Brick => (
            // Local x is the global one, local y = x × (c − a) the global y.
            format!("TYPE=CYLINDER\n0., 0., 0., 1., 0., 0.\n0., 0., -1.\nSTART, 0., 0.\nLINE, 10., {end:e}\n"),
            "99, 1, 6\nWEDGE, 3\n",
        ),
        Scene::Deformable => (String::new(), "GROUND, 1, 2\n"),
    };
    let main = if scene == Scene::Deformable {
        format!(
            "*NODE\n11, 0., -1.\n12, 10., -1.\n13, 10., {end:e}\n14, 0., 0.\n*ELEMENT, TYPE=CPE4, ELSET=RAMP\n2, 11, 12, 13, 14\n\
             *SOLID SECTION, ELSET=RAMP, MATERIAL=M\n*NSET, NSET=GROUND\n11, 12\n*SURFACE, NAME=INCLINE\nRAMP, S3\n"
        )
    } else {
        format!(
            "*NODE\n99, 0., -5.\n*SURFACE, NAME=INCLINE, {incline}*RIGID BODY, ANALYTICAL SURFACE=INCLINE, REF NODE=99\n"
        )
    };
    format!(
        "*NODE\n{nodes}*ELEMENT, TYPE={element}\n*NSET, NSET=WEDGE, GENERATE\n1, {last}\n*MATERIAL, NAME=M\n*ELASTIC\n1e4, 0.3\n\
         *DENSITY\n2.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=SEC\nE, {}\n{main}*SURFACE INTERACTION, NAME=I\n\
         *FRICTION{friction}*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nSEC, INCLINE\n*BOUNDARY\n{supports}",
        if brick { "S3" } else { "S1" }
    )
}

fn step(cards: &str) -> String {
    format!("*STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n{cards}*END STEP\n")
}

/// Laid down while it is held, then moved along x by so much in steps; the horizontal force at the end of each of them.
fn forces(scratch: &Scratch, model: &str, moves: &[f64]) -> Vec<f64> {
    let laid = step("*DLOAD\nE, GRAV, 1., 0., -1., 0.\n*BOUNDARY\nWEDGE, 1\n");
    let moved: String = moves.iter().map(|x| step(&format!("*BOUNDARY\nWEDGE, 1, 1, {x:e}\n"))).collect();
    let deck = format!("{model}{laid}{moved}");
    scratch.write("wedge.inp", &deck);
    let report = fe::run(&scratch.path("wedge.inp"), &fe::standard(), &mut fe::observer::Silent)
        .unwrap_or_else(|failure| panic!("{failure}\n{deck}"));
    let results = Results::open(&report.results);
    let wedge = results.integer("VTKHDF/PointData/NodeLabel").iter().map(|label| *label < 9).collect::<Vec<_>>();
    let at = |frame| {
        let reactions = results.point_field("RF", 3, frame);
        reactions.chunks_exact(3).zip(&wedge).filter(|(_, of_wedge)| **of_wedge).map(|(r, _)| r[0]).sum()
    };
    (2..results.times().len()).map(at).collect()
}

/// Moved up, and down again where sticking points give way, by far more than the elastic slips.
#[test]
fn a34_wedge_on_an_incline() {
    let scratch = Scratch::new("wedge");
    for scene in SCENES {
        for (friction, kind, moves) in [
            (", LAGRANGE", "SURFACE TO SURFACE", &[0.2][..]),
            (", ELASTIC SLIP=1e-4", "NODE TO SURFACE", &[0.2]),
            ("", "SURFACE TO SURFACE", &[0.2, -0.2]),
        ] {
            for mu in [0.0, 0.1, 0.2, 0.3] {
                let found = forces(&scratch, &model(scene, &format!("{friction}\n{mu}\n"), kind), moves);
                let expected = [(T + mu) / (1.0 - mu * T), (T - mu) / (1.0 + mu * T)];
                for (found, expected) in found.into_iter().zip(expected) {
                    let error = (found / WEIGHT - expected).abs();
                    assert!(error <= ALGEBRAIC, "{scene:?}{friction} {kind} {mu}: {}, not {expected}", found / WEIGHT);
                }
            }
        }
    }
}
