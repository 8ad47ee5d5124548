//! D18 and D22: contact that opens, and contact that is never there.

use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, PRESSURE, Patch};
use crate::hard::run::Run;
use crate::problems::grading::Grading;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

/// Scenes of D18.
pub fn chattering() -> Vec<Scene> {
    let mut scenes = super::gaps::stops();
    for (at, left) in [(0.0, 0.5), (0.5, 0.25), (0.999, 0.0005), (1.0, 0.0)] {
        for behavior in ["DIRECT", "PENALTY"] {
            let name = format!("block on two supports, load at {at}, {}", behavior.to_lowercase());
            scenes.push(Scene::new(name, move |place| {
                let run = place.run("block", &on_supports(at, behavior));
                Finding::converged(&run).measured(&run, |solved| {
                    let force = |pair: usize| solved.pairs[pair].secondary.force[1];
                    vec![((force(0) - left).abs(), 1e-9), ((force(1) - (1.0 - left)).abs(), 1e-9)]
                })
            }));
        }
    }
    scenes.push(Scene::new("block on two supports, load at 1.001: tips over", |place| {
        let run = place.run("block", &on_supports(1.001, "PENALTY"));
        Finding::refused(&run, &["BLOCK", "about z"])
    }));
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        scenes.push(Scene::new(format!("receding layer from all closed, {}", kind.to_lowercase()), move |place| {
            let run = place.run("layer", &layer(kind));
            let words = format!("{} iterations instead of 15", run.iterations);
            Finding::converged(&run).holds(run.iterations <= 15 && run.cutbacks == 0, words)
        }));
    }
    scenes
}

/// A block [−1.25, 1.25]×[0, 0.5], free along y and about z, on two rigid points below x = ±1; a unit load above `at`. E is
/// so large that the block does not bend by more than round-off of the forces.
fn on_supports(at: f64, behavior: &str) -> String {
    // Columns of nodes at ±1.25, ±1, 0 and the load's place.
    let mut columns = vec![-1.25, -1.0, 0.0, 1.0, 1.25];
    if !columns.contains(&at) {
        columns.push(at);
        columns.sort_by(f64::total_cmp);
    }
    let count = columns.len() - 1;
    let mesh =
        Block::quad4([count, 1]).mapped(|[s, t, _]| [columns[(s * count as f64).round() as usize], 0.5 * t, 0.0]);
    let node = |x: f64, y: f64| {
        let found = mesh.points.iter().position(|p| p[0] == x && p[1] == y);
        found.map_or(0, |node| mesh.point_labels[node])
    };
    let (left, right, loaded) = (node(-1.0, 0.0), node(1.0, 0.0), node(at, 0.5));
    let [first, second] = [1, 2].map(|k| mesh.points.len() + k);
    let flat = |name: &str, x: f64, reference: usize| {
        format!(
            "*NODE\n{reference}, {x}, -1.\n*SURFACE, NAME={name}, TYPE=SEGMENTS\nSTART, {}, 0.\nLINE, {}, 0.\n\
             *RIGID BODY, ANALYTICAL SURFACE={name}, REF NODE={reference}\n",
            x - 0.1,
            x + 0.1
        )
    };
    format!(
        "{}{}{}{}*SURFACE, NAME=ONE, TYPE=NODE\n{left}, 1.\n*SURFACE, NAME=OTHER, TYPE=NODE\n{right}, 1.\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, {behavior}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nONE, LEFT\nOTHER, RIGHT\n\
         *BOUNDARY\n{first}, 1, 6\n{second}, 1, 6\n{middle}, 1\n{}",
        deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade),
        deck::elastic(&["BLOCK"], 1e3, 0.3),
        flat("LEFT", -1.0, first),
        flat("RIGHT", 1.0, second),
        patch::step(patch::EXACT, &format!("*CLOAD\n{loaded}, 2, -1.\n")),
        middle = node(0.0, 0.0),
    )
}

/// Half of an elastic layer on a rigid flat under a force in its middle, A31 at h = 1/16, edges growing beyond x = 1.5.
pub fn layer(kind: &str) -> String {
    let along = Grading::new(1.0 / 16.0, 1.5, 6.0, 1.25);
    let mesh = Block::quad4([along.cells(), 16]).mapped(|[s, t, _]| [along.at(s), t, 0.0]);
    let loaded = mesh.points.iter().position(|p| p[0] == 0.0 && p[1] == 1.0);
    let (label, reference) = (loaded.map_or(0, |node| mesh.point_labels[node]), mesh.points.len() + 1);
    format!(
        "{}{}*NODE\n{reference}, 0., -1.\n*SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, -1., 0.\nLINE, 7., 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE={reference}\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, DIRECT\n\
         *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nYMIN, FLAT\n\
         *BOUNDARY\nXMIN, 1\n{reference}, 1, 6\n{}",
        deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade),
        deck::elastic(&["BLOCK"], 1e3, 0.3),
        patch::step(patch::EXACT, &format!("*CLOAD\n{label}, 2, -0.5\n")),
    )
}

/// Scenes of D22.
pub fn none_or_lost() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        scenes.push(Scene::new(format!("apart all step, {}", kind.to_lowercase()), move |place| {
            let patch = Patch { overlap: -0.5, kind, ..Patch::plane(3, 4) };
            let run = place.run("apart", &patch.held(&patch.mesh(), Order::AsMade));
            Finding::warned(&run, &["no contact", "UP_YMIN"])
                .measured(&run, |solved| vec![(solved.u.iter().fold(0.0, |m: f64, u| m.max(u.abs())), 0.0)])
        }));
    }
    scenes.push(Scene::new("load reversed: the body comes free", |place| {
        let patch = Patch::plane(3, 4);
        let mesh = patch.mesh();
        // From 10 in compression to 10 in tension: nothing is left at half of the step.
        let turning = "*AMPLITUDE, NAME=TURNS\n0., 1., 1., -1.\n*STEP\n*STATIC\n0.1, 1.\n";
        let deck = patch.pressed(&mesh, Order::AsMade).replace("*STEP\n*STATIC\n1., 1.\n", turning);
        let run = place.run("reversed", &deck.replace("*DSLOAD\n", "*DSLOAD, AMPLITUDE=TURNS\n"));
        stopped(&run, &["UP_BLOCK", "step time"])
    }));
    scenes.push(Scene::new("surfaces that can never meet", |place| {
        let patch = Patch::plane(3, 4);
        let mesh = patch.mesh();
        // The lower side of the lower block looks away from the upper block.
        let deck = patch.held(&mesh, Order::AsMade).replace("UP_YMIN, LOW_YMAX\n", "UP_YMIN, LOW_YMIN\n");
        let run = place.run("away", &deck);
        Finding::warned(&run, &["UP_YMIN", "faces", "LOW_YMIN"])
            .measured(&run, |solved| vec![(solved.pairs[0].points.len() as f64, 0.0)])
    }));
    scenes
}

/// A run that must go on while the load presses, and end with these words.
fn stopped(run: &Run, words: &[&str]) -> Finding {
    let found = Finding::stopped(run, words);
    let last = run.certificates.last().map_or(f64::NAN, |certificate| certificate.applied[1]);
    // The first increment is a tenth of the step and presses by 0.8 of the load, 20.
    found
        .within(from_value(-0.8 * 2.0 * PRESSURE, &[run.certificates.first().map_or(f64::NAN, |c| c.applied[1])]), 1e-9)
        .holds(last <= 0.0, "it went on under tension")
}
