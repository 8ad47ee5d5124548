//! C08: the movements without energy are the rigid ones.

use super::scene::{Scene, noise, straighten};
use crate::element::{ElementType, Space};

/// Eigenvalues of one element below 1e-10 of the largest are zero (round-off is 1e-15 of it, the least genuine
/// one of these shapes 1e-4).
fn zero_eigenvalues(scene: &Scene) -> usize {
    let values = scene.dense().symmetric_eigenvalues();
    let largest = values.amax();
    assert!(values.iter().all(|&v| v > -1e-12 * largest));
    let zero = values.iter().filter(|&&v| v < 1e-10 * largest).count();
    let least = values.iter().filter(|&&v| v > 1e-10 * largest).fold(largest, |m, &v| m.min(v));
    assert!(least > 1e-6 * largest, "{:?}: {least} of {largest}", scene.element());
    zero
}

/// One element, regular or distorted.
fn one(element: ElementType, distortion: f64) -> Scene {
    let grid = Scene::grid(element, [1, 1, 1], |x| {
        let low = if element.space() == Space::Axisymmetric { 1.0 } else { 0.0 };
        let z = if element.space() == Space::Solid { x[2] + distortion * noise(x, 2) } else { 0.0 };
        [x[0] + low + distortion * noise(x, 0), x[1] + distortion * noise(x, 1), z]
    });
    let nodes = grid.cell(0).to_vec();
    let points = nodes.iter().map(|&n| grid.structure.mesh.points[n as usize]).collect();
    let numbers = (0..nodes.len() as u32).collect();
    let mut scene = Scene::new(element, points, numbers);
    straighten(&mut scene);
    scene
}

#[test]
#[allow(non_snake_case)]
fn C08_ranks() {
    for element in ElementType::SOLIDS {
        let rigid = match element.space() {
            Space::Solid | Space::Plane | Space::Any => 6,
            Space::PlaneStrain | Space::PlaneStress => 3,
            Space::Axisymmetric => 1,
        };
        for distortion in [0.0, 0.15] {
            for poisson in [-0.5, 0.0, 0.3, 0.49] {
                let scene = one(element, distortion).with_material(1.0, poisson);
                assert_eq!(zero_eigenvalues(&scene), rigid, "{element:?} {distortion} {poisson}");
            }
        }
    }
}
