//! D34: without friction the end does not depend on the way to it.

use super::lost;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, difference};
use crate::hard::patch::{EXACT, step};
use crate::hard::{Place, Scene};
use crate::windows::point_scene;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

/// Scenes of D34.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for behavior in ["DIRECT", "PENALTY", "AUGMENTED LAGRANGE"] {
        let words = behavior.to_lowercase();
        scenes.push(Scene::new(format!("window around an axis, {words}, 1, 3, 100 increments"), move |place| {
            in_increments(place, &window(behavior))
        }));
        scenes.push(Scene::new(format!("press fit, {words}, 1, 3, 100 increments"), move |place| {
            in_increments(place, &press_fit(behavior))
        }));
    }
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        let words = kind.to_lowercase();
        scenes.push(Scene::new(format!("receding layer, {words}, 1, 3, 100 increments"), move |place| {
            in_increments(place, &lost::layer(kind))
        }));
    }
    scenes
}

/// The same end to 1e-9.
fn in_increments(place: &Place, deck: &str) -> Finding {
    let runs = [1, 3, 100].map(|count: usize| {
        let sized = format!("*STATIC, DIRECT\n{:?}, 1.\n", 1.0 / count as f64);
        (count, place.run(&format!("in_{count}"), &deck.replace("*STATIC\n1., 1.\n", &sized)))
    });
    let first = &runs[0].1;
    let judged = runs.iter().map(|(count, run)| {
        let words = format!("{} increments instead of {count}", run.certificates.len());
        let found = Finding::converged(run).holds(run.certificates.len() == *count, words);
        found.within(difference(first.u(), run.u()), 1e-9)
    });
    judged.reduce(Finding::and).unwrap_or_default()
}

fn window(behavior: &str) -> String {
    let scene = point_scene(ElementType::CAX4, 4, &format!("*SURFACE BEHAVIOR, {behavior}\n"), "SURFACE TO SURFACE");
    let mesh = deck::cards(&scene.mesh, &[("BLOCK", ElementType::CAX4)], Order::AsMade);
    format!("{mesh}{}{}", scene.model, step(EXACT, &scene.load))
}

/// A25: rings 20/40 and 40/60 with a radial interference of 0.02 that is shrunk, held along the axis; three elements
/// through the one and four through the other, one and two high.
fn press_fit(behavior: &str) -> String {
    let ring = |[inner, through, high]: [usize; 3], name: &str| {
        Block::quad4([through, high]).size([20.0, 2.0, 0.0]).origin([inner as f64, 0.0, 0.0]).mesh().prefixed(name)
    };
    let mut mesh = ring([20, 3, 1], "IN_");
    mesh.append(&ring([40, 4, 2], "OUT_"));
    let sets = ["IN_BLOCK", "OUT_BLOCK"];
    format!(
        "{}{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, {behavior}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, SMALL SLIDING\nIN_XMAX, OUT_XMIN\n\
         *CLEARANCE, SECONDARY=IN_XMAX, MAIN=OUT_XMIN, VALUE=-0.02\n*BOUNDARY\nIN_BLOCK, 2\nOUT_BLOCK, 2\n{}",
        deck::cards(&mesh, &sets.map(|set| (set, ElementType::CAX4)), Order::AsMade),
        deck::material("STEEL", &sets[..1], 210e3, 0.3),
        deck::material("ALUMINIUM", &sets[1..], 70e3, 0.33),
        step(EXACT, "*CONTACT INTERFERENCE, SHRINK\nIN_XMAX, OUT_XMIN\n"),
    )
}
