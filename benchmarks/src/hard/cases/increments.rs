//! D34: without friction the end does not depend on the way to it.

use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, difference};
use crate::hard::{Place, Scene, patch};
use crate::windows::point_scene;
use fe_core::element::ElementType;

/// Scenes of D34.
pub fn scenes() -> Vec<Scene> {
    let behaviors = ["DIRECT", "PENALTY", "AUGMENTED LAGRANGE"];
    behaviors
        .into_iter()
        .map(|behavior| {
            let name = format!("window around an axis, {}, 1, 3, 100 increments", behavior.to_lowercase());
            Scene::new(name, move |place| window(place, behavior))
        })
        .collect()
}

/// The same end to 1e-9.
fn window(place: &Place, behavior: &str) -> Finding {
    let scene = point_scene(ElementType::CAX4, 4, &format!("*SURFACE BEHAVIOR, {behavior}\n"), "SURFACE TO SURFACE");
    let mesh = deck::cards(&scene.mesh, &[("BLOCK", ElementType::CAX4)], Order::AsMade);
    let step = patch::step(patch::EXACT, &scene.load);
    let runs = [1, 3, 100].map(|count: usize| {
        let sized = format!("*STATIC, DIRECT\n{:?}, 1.\n", 1.0 / count as f64);
        let deck = format!("{mesh}{}{}", scene.model, step.replace("*STATIC\n1., 1.\n", &sized));
        (count, place.run(&format!("in_{count}"), &deck))
    });
    let first = &runs[0].1;
    let judged = runs.iter().map(|(count, run)| {
        let words = format!("{} increments instead of {count}", run.certificates.len());
        let found = Finding::converged(run).holds(run.certificates.len() == *count, words);
        found.within(difference(first.u(), run.u()), 1e-9)
    });
    judged.reduce(Finding::and).unwrap_or_default()
}
