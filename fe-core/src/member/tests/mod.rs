//! Tests of trusses, beams and springs.

mod beams;
mod scene;
mod springs;
mod trusses;

use crate::element::ElementType::*;
use crate::structure::Profile;
use nalgebra::DMatrix;
use scene::{Scene, turned};

/// The stiffness of a scene that is turned as a whole, cross-sections with it, is the turned stiffness.
#[test]
fn turning_the_scene_turns_the_stiffness() {
    let points = [[0.0; 3], [40.0, 10.0, 5.0], [20.0, 6.0, 2.5], [-3.0, 8.0, 20.0]];
    let profile = Profile { i12: 1e3, ..Profile::rectangle(10.0, 30.0) };
    let stiffness = |turn: fn([f64; 3]) -> [f64; 3]| {
        let across = turn([0.1, 0.2, 1.0]);
        Scene::new(&points.map(turn))
            .lines(B33, &[&[0, 1], &[1, 3]], profile, across)
            .lines(B31, &[&[0, 2], &[2, 3]], profile, across)
            .lines(T3D3, &[&[0, 1, 2]], Profile::bar(7.0), [0.0; 3])
            .lines(T3D2, &[&[0, 3]], Profile::bar(3.0), [0.0; 3])
            .discrete(SPRINGA, &[&[2, 3]], 5e3, [0, 0])
            .stiffness()
    };
    let straight = stiffness(|x| x);
    // Translations and rotations of every node turn alike.
    let mut turn = DMatrix::zeros(straight.nrows(), straight.ncols());
    for c in 0..3 {
        let mut unit = [0.0; 3];
        unit[c] = 1.0;
        let image = turned(unit);
        for part in (0..straight.nrows()).step_by(3) {
            (0..3).for_each(|r| turn[(part + r, part + c)] = image[r]);
        }
    }
    let expected = &turn * &straight * turn.transpose();
    // Entries are sums of about ten products: 1e-12 leaves room for their rounding.
    assert!((stiffness(turned) - &expected).amax() < 1e-12 * expected.amax());
}
