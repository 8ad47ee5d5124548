//! The stable increment of all elements together.

use super::*;
use crate::explicit::central_difference::{CentralDifference, State};

/// A block whose middle third is thin, moved out of square.
fn graded([x, y, z]: [f64; 3]) -> [f64; 3] {
    let x = 1.35 * x.min(1.0 / 3.0)
        + 0.3 * (x.clamp(1.0 / 3.0, 2.0 / 3.0) - 1.0 / 3.0)
        + 1.35 * (x.max(2.0 / 3.0) - 2.0 / 3.0);
    [x + 0.5, y + 0.1 * x * (1.0 - x), z]
}

/// A block of it, asked for what all elements bear together.
fn scene(setup: &Setup) -> Scene {
    let mut scene = setup.block(3, graded);
    scene.solids.together(true);
    scene
}

/// Not above the exact one of the whole mesh, nor below that of the fastest element; masses four times as large double it. C3D10
/// gains nothing: its corners have so little mass that the bound there is above that of the elements.
#[test]
fn all_elements_bear_more_than_the_fastest() {
    for element in all() {
        let setup = Setup::elastic(element);
        let together = scene(&setup).stable();
        let by_element = setup.block(3, graded).stable();
        let exact = exact(|| scene(&setup), |x| x);
        assert!(by_element <= together && (element == C3D10 || 1.3 * by_element < together), "{}", element.name());
        assert!(together <= exact * (1.0 + 1e-6), "{}", element.name());
        let mut heavy = scene(&setup);
        heavy.solids.scale(&|_| 4.0);
        assert!((heavy.stable() / together - 2.0).abs() < 1e-13, "{}", element.name());
    }
}

/// Any motion that increments as long as that begin with dies away by damping, which all elements have.
#[test]
fn damped_motion_dies_away() {
    // ξ = ½ β ω of the thin elements: about 0.2, and 10.
    for (element, beta) in all().flat_map(|element| [(element, 2e-9), (element, 1e-7)]) {
        let mut setup = Setup::elastic(element);
        setup.damping.beta = beta;
        let mut scene = scene(&setup);
        scene.solids.damp([0.06, 1.2]);
        let mut state = State::rest(&scene.freedoms);
        state.v.iter_mut().enumerate().for_each(|(f, v)| *v = ((f * 7919 + 13) % 1000) as f64 * 1e-3 - 0.5);
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut scene.solids];
        let mut procedure = CentralDifference::new(terms, Vec::new(), (1.0, f64::INFINITY), &mut state).unwrap();
        let all = procedure.kinetic(&state);
        for _ in 0..500 {
            let dt = procedure.stable().increment();
            procedure.advance(terms, &mut state, dt).unwrap();
        }
        let left = procedure.kinetic(&state) / all;
        assert!(left < 1.0, "{} {beta}: {left}", element.name());
    }
}
