//! D01, D02: penalties from far too soft to far too stiff, and bodies of unlike stiffness.

use super::gaps;
use crate::hard::Scene;
use crate::hard::ball::{self, Ball};
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, EXACT, PRESSURE, Patch};
use crate::hard::run::Run;
use crate::problem::{Curve, Problem};
use crate::problems::hertz_line::HertzLine;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

/// Relative bound of a discrete problem that has the closed answer.
const ALGEBRAIC: f64 = 1e-10;
/// Unit bricks of each bar, of stiffness [F/L] along it.
const BRICKS: usize = 50;
const BRICK: f64 = 1e3;
/// Force that presses the bars [F].
const FORCE: f64 = 100.0;

/// Two bars along z, the upper one held by contact alone, pressed by a pressure on its end.
fn bars(penalty: f64) -> String {
    let bar = |height: f64| Block::hex8([1, 1, BRICKS]).size([1.0, 1.0, BRICKS as f64]).origin([0.0, 0.0, height]);
    let mut mesh = bar(0.0).mesh().prefixed("LOW_");
    mesh.append(&bar(BRICKS as f64).mesh().prefixed("UP_"));
    let sets = ["LOW_BLOCK", "UP_BLOCK"];
    format!(
        "{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n{penalty:e}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nUP_ZMIN, LOW_ZMAX\n\
         *BOUNDARY\nLOW_ZMIN, 3\nLOW_BLOCK, 1, 2\nUP_BLOCK, 1, 2\n{}",
        deck::cards(&mesh, &sets.map(|set| (set, ElementType::C3D8)), Order::AsMade),
        deck::elastic(&sets, BRICK, 0.0),
        patch::step(EXACT, &format!("*DSLOAD\nUP_ZMAX, P, {FORCE}\n")),
    )
}

/// Scenes of D01.
pub fn penalties() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for exponent in [-6, -3, 0, 3, 6, 9, 12, 15, 18] {
        scenes.push(Scene::new(format!("bars, penalty 1e{exponent} of a brick"), move |place| {
            let penalty = BRICK * 10f64.powi(exponent);
            let run = place.run("bars", &bars(penalty));
            let warned = run.told(&["warning", "not hard"]);
            let soft = exponent <= 0;
            let end = -(2.0 * BRICKS as f64 * FORCE / BRICK + FORCE / penalty);
            Finding::converged(&run)
                .holds(warned == soft, format!("softer than a brick: {soft}, warned: {:?}", run.notes))
                .measured(&run, |solved| {
                    let labels = solved.terms.structure.mesh.node_sets["UP_ZMAX"].iter();
                    let ends: Vec<f64> =
                        labels.filter_map(|&n| Some(solved.u[solved.terms.freedoms.index(n as usize, 2)?])).collect();
                    // Beyond a condition number of 1e4 a bound grows in proportion.
                    let bound = ALGEBRAIC * (4.0 * BRICK / penalty * 1e-4).max(1.0);
                    vec![(from_value(FORCE, &solved.pressures()), bound), (from_value(end, &ends), bound)]
                })
        }));
    }
    for exponent in [-6, -4, -2, 0, 2, 4, 6] {
        scenes.push(Scene::new(format!("window, 1e{exponent} of the default penalty"), move |place| {
            let run = place.run("window", &window(exponent));
            let warned = run.told(&["warning", "not hard"]);
            Finding::converged(&run).holds(warned == (exponent < 0), format!("warned: {:?}", run.notes))
        }));
        scenes.push(ball_on_flat(exponent));
    }
    scenes
}

/// The ball pushed onto its flat. A penalty is soft where it gives way by more than a hundredth of an element.
fn ball_on_flat(exponent: i32) -> Scene {
    let scene = Scene::new(format!("ball, 1e{exponent} of the default penalty"), move |place| {
        let behavior = format!("*SURFACE BEHAVIOR, PENALTY\n,, 1e{exponent}\n");
        let deck = Ball::default().deck(&ball::mesh()).replace("*SURFACE BEHAVIOR, PENALTY\n", &behavior);
        let run = place.run("ball", &deck);
        let warned = run.told(&["warning", "not hard"]);
        Finding::converged(&run).holds(warned == (exponent < 0), format!("warned: {:?}", run.notes))
    });
    scene.slow()
}

/// Hertz's line contact with eight elements along half the contact width.
fn window(exponent: i32) -> String {
    let curve = Curve { element: ElementType::CPE4, variant: "surface to surface", sizes: vec![8] };
    let scene = HertzLine.scene(&curve, 8);
    let behavior = format!("*SURFACE BEHAVIOR, PENALTY\n,, 1e{exponent}\n");
    let cards = scene.cards.replace("*SURFACE BEHAVIOR, PENALTY\n", &behavior);
    deck::cards(&scene.mesh, &scene.elements, Order::AsMade) + &cards
}

/// Scenes of D02.
pub fn contrasts() -> Vec<Scene> {
    let mut scenes = gaps::springs();
    for ratio in [1e3, 1e6, 1e9, 1e12] {
        for (behavior, name) in [("DIRECT", "multipliers"), ("PENALTY", "penalty")] {
            scenes.push(Scene::new(format!("patch 3/4, lower block {ratio:e} times as stiff, {name}"), move |place| {
                let behavior = format!("*SURFACE BEHAVIOR, {behavior}\n");
                let patch = Patch { behavior, lower_factor: ratio, ..Patch::plane(3, 4) };
                let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
                // The penalty follows the softer side: ten times M / l, l = 1/2, M at most E (1 − ν)/((1 + ν)(1 − 2ν)).
                let softest = 10.0 * 2.0 * 2.0 * patch::YOUNG;
                Finding::converged(&run).measured(&run, |solved| {
                    let stiffness = if name == "penalty" { solved.stiffness(0) } else { 0.0 };
                    vec![
                        (from_value(PRESSURE, &solved.pressures()), 1e-8),
                        (if stiffness <= softest { 0.0 } else { stiffness }, ALGEBRAIC),
                    ]
                })
            }));
        }
    }
    scenes
}

/// D24: what closed never opens again.
pub fn no_separation() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (lower, upper) in [(4, 4), (3, 4)] {
        scenes.push(Scene::new(format!("patch {lower}/{upper} 1e-3 apart: pulled, pushed, pulled"), move |place| {
            let behavior = "*SURFACE BEHAVIOR, DIRECT, NO SEPARATION\n".into();
            let patch = Patch { behavior, overlap: -1e-3, ..Patch::plane(lower, upper) };
            let (mesh, depth) = (patch.mesh(), 2.0 * PRESSURE / patch.modulus());
            let to = |up: f64| patch.moved(&mesh, Order::AsMade, up);
            let (model, first) = split(&to(2e-3));
            // Apart; pressed by 10; pulled by 10.
            let courses = [vec![2e-3], vec![2e-3, -1e-3 - depth], vec![2e-3, -1e-3 - depth, -1e-3 + depth]];
            let expected = [0.0, PRESSURE, -PRESSURE];
            let mut found: Option<Finding> = None;
            for (i, (course, pressure)) in courses.iter().zip(expected).enumerate() {
                let later: String = course[1..].iter().map(|up| split(&to(*up)).1).collect();
                let run = place.run(&format!("course_{i}"), &format!("{model}{first}{later}"));
                let now = judge(&run, pressure);
                found = Some(match found {
                    Some(before) => before.and(now),
                    None => now,
                });
            }
            found.unwrap_or_default()
        }));
    }
    scenes
}

/// The model's cards and the step of a deck.
fn split(deck: &str) -> (String, String) {
    let at = deck.find("*STEP").unwrap_or(deck.len());
    (deck[..at].into(), deck[at..].into())
}

fn judge(run: &Run, pressure: f64) -> Finding {
    Finding::converged(run).measured(run, |solved| {
        let worst = solved.pressures().iter().fold(0.0f64, |m, p| m.max((p - pressure).abs()));
        vec![(worst / PRESSURE, ALGEBRAIC)]
    })
}
