//! C07: thick cylinder, ν from 0.3 to 0.49999.

use super::scene::Scene;
use crate::element::ElementType::{self, *};
use crate::element::Space;
use crate::load::{LoadKind, unit_forces};
use nalgebra::{DMatrix, DVector};

const INNER: f64 = 3.0;
const OUTER: f64 = 9.0;

/// The cylinder around its axis, or as a wedge of 40°/`cells` in the plane or in space.
fn cylinder(element: ElementType, cells: usize, poisson: f64) -> Scene {
    let half = 20f64.to_radians() / cells as f64;
    Scene::grid(element, [cells, 1, 1], |[q, t, z]| {
        let (r, angle) = (INNER + q * (OUTER - INNER), half * (2.0 * t - 1.0));
        match element.space() {
            Space::Axisymmetric => [r, t, 0.0],
            _ => [r * angle.cos(), r * angle.sin(), z],
        }
    })
    .with_material(1000.0, poisson)
}

/// u(r_1)/exact − 1 under unit pressure inside, plane strain.
fn error(element: ElementType, cells: usize, poisson: f64) -> f64 {
    let scene = cylinder(element, cells, poisson);
    let axisymmetric = element.space() == Space::Axisymmetric;
    let radius = |x: [f64; 3]| if axisymmetric { x[0] } else { x[0].hypot(x[1]) };
    let faces = scene.faces(|x| (radius(x) - INNER).abs() < 1e-9);
    let mut force = vec![0.0; scene.freedoms.len()];
    unit_forces(&LoadKind::Pressure { faces }, &scene.structure, &scene.freedoms)
        .unwrap()
        .into_iter()
        .for_each(|(f, value)| force[f] += value);
    // Every node moves along its own radius: what symmetry leaves.
    let points = &scene.structure.mesh.points;
    let mut directions = DMatrix::zeros(scene.freedoms.len(), points.len());
    for (node, &x) in points.iter().enumerate() {
        let along = if axisymmetric { [1.0, 0.0] } else { [x[0] / radius(x), x[1] / radius(x)] };
        let start = scene.freedoms.of_node(node).start;
        (0..2).for_each(|i| directions[(start + i, node)] = along[i]);
    }
    let stiffness = directions.transpose() * scene.dense() * &directions;
    let outward = stiffness.cholesky().unwrap().solve(&(directions.transpose() * DVector::from_vec(force)));
    let node = scene.structure.mesh.points.iter().position(|&x| (radius(x) - INNER).abs() < 1e-9).unwrap();
    outward[node] / exact(poisson) - 1.0
}

/// Lamé: u(r_1) = (1+ν) r_1/(E (r_2² − r_1²)) [(1−2ν) r_1² + r_2²] under unit pressure, plane strain, E = 1000.
fn exact(poisson: f64) -> f64 {
    let (a, b) = (INNER * INNER, OUTER * OUTER);
    (1.0 + poisson) * INNER / (1000.0 * (b - a)) * ((1.0 - 2.0 * poisson) * a + b)
}

/// Sixteen elements through the wall: within 1 % for every ν, and the error the same within a factor 2.
#[test]
#[allow(non_snake_case)]
fn C07_thick_cylinder() {
    assert!((exact(0.3) - 0.0045825).abs() < 1e-12 && (exact(0.4999) - 0.0050622749925).abs() < 1e-12);
    for element in [CAX4, CPE4, C3D8] {
        let errors = [0.3, 0.49, 0.499, 0.4999, 0.49999].map(|nu| error(element, 16, nu).abs());
        assert!(errors.iter().all(|e| *e < 0.01), "{element:?} {errors:?}");
        let (least, most) = errors.iter().fold((f64::MAX, 0.0f64), |(l, m), e| (l.min(*e), m.max(*e)));
        assert!(most < 2.0 * least, "{element:?} {errors:?}");
    }
}

/// The error falls with the square of the size, near incompressibility too.
#[test]
#[allow(non_snake_case)]
fn C07_thick_cylinder_converges() {
    for element in [CAX4, CPE4, C3D8] {
        for poisson in [0.3, 0.4999] {
            let (coarse, fine) = (error(element, 8, poisson), error(element, 16, poisson));
            let rate = (coarse / fine).abs().log2();
            assert!(rate > 1.9, "{element:?} {poisson} {coarse} {fine} {rate}");
        }
    }
}
