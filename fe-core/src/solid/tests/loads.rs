//! Loads: resultants, shares of faces, what is refused.

use super::scene::{Scene, jiggle, straighten};
use crate::element::ElementType::{self, *};
use crate::element::Space;
use crate::load::{LoadError, LoadKind, unit_forces};
use fe_mesh::{CellId, Face};

/// Sum of the forces in each direction.
fn resultant(scene: &Scene, load: &LoadKind) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (freedom, force) in unit_forces(load, &scene.structure, &scene.freedoms).unwrap() {
        sum[scene.freedoms.component(freedom)] += force;
    }
    sum
}

/// A square or cube from 1 to 2, so that a radius is never zero.
fn scene(element: ElementType) -> Scene {
    Scene::grid(element, [3, 2, 2], |x| [x[0] + 1.0, x[1], x[2]])
        .with_thickness(if element.space() == Space::PlaneStress { 0.5 } else { 1.0 })
}

/// Pressure on x = 2 pushes back with the area of the side; on all sides nothing remains, but the hoop's share
/// around an axis. Bounds: round-off of some tens of terms.
#[test]
fn pressure_adds_up_to_area() {
    for element in ElementType::SOLIDS {
        let scene = scene(element);
        let area = match element.space() {
            Space::Axisymmetric => std::f64::consts::TAU * 2.0,
            Space::PlaneStress => 0.5,
            _ => 1.0,
        };
        let faces = scene.faces(|x| x[0] == 2.0);
        let sum = resultant(&scene, &LoadKind::Pressure { faces });
        assert!((sum[0] + area).abs() < 1e-13 && sum[1].abs() < 1e-13 && sum[2].abs() < 1e-13, "{element:?} {sum:?}");
        let sides =
            |x: [f64; 3]| [(0, 1.0), (0, 2.0), (1, 0.0), (1, 1.0), (2, 0.0), (2, 1.0)].map(|(i, at)| x[i] == at);
        let planes = if element.space() == Space::Solid { 6 } else { 4 };
        let faces = (0..planes).flat_map(|side| scene.faces(|x| sides(x)[side])).collect();
        let sum = resultant(&scene, &LoadKind::Pressure { faces });
        let open = if element.space() == Space::Axisymmetric { -std::f64::consts::TAU } else { 0.0 };
        assert!((sum[0] - open).abs() < 1e-12 && sum[1].abs() < 1e-13 && sum[2].abs() < 1e-13, "{element:?} {sum:?}");
    }
}

/// A uniform pressure on a body of any shape is balanced by a uniform stress: K u of the field u = −x p/(3K) is
/// the load, node by node (class X).
#[test]
fn pressure_is_consistent_with_the_elements() {
    for element in ElementType::SOLIDS {
        let mut scene = Scene::grid(element, [2, 2, 2], |x| {
            let y = jiggle(x, 0.1);
            [y[0] + 0.2 * y[1] + 1.0, y[1] + 0.1 * y[0] * y[1], y[2] * (1.0 + 0.2 * y[0])]
        });
        straighten(&mut scene); // four points do not integrate curved tetrahedra exactly
        let boundary = {
            let mut count = std::collections::BTreeMap::new();
            let all = scene.faces(|_| true);
            let key = |f: Face| {
                let mut nodes = scene.structure.mesh.face(f).1;
                nodes.sort_unstable();
                nodes
            };
            all.iter().for_each(|&f| *count.entry(key(f)).or_insert(0) += 1);
            all.into_iter().filter(|&f| count[&key(f)] == 1).collect()
        };
        let (young, poisson) = (1000.0, 0.3);
        let (lambda, mu) = (young * poisson / (1.3 * 0.4), young / 2.6);
        let strain = match element.space() {
            Space::Solid | Space::Any | Space::Axisymmetric => 1.0 / (3.0 * lambda + 2.0 * mu),
            Space::PlaneStrain => 1.0 / (2.0 * lambda + 2.0 * mu),
            Space::PlaneStress | Space::Plane => (1.0 - poisson) / young,
        };
        let u = scene.field(|x| x.map(|x| -strain * x));
        let mut force = vec![0.0; u.len()];
        scene.stiffness().multiply_add(&u, &mut force);
        for (freedom, f) in
            unit_forces(&LoadKind::Pressure { faces: boundary }, &scene.structure, &scene.freedoms).unwrap()
        {
            force[freedom] -= f;
        }
        let worst = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        assert!(worst < 1e-12, "{element:?} {worst:e}");
    }
}

/// D13: a flat six-node triangle gives its mid nodes a third each, its corners nothing.
#[test]
#[allow(non_snake_case)]
fn D13_face_forces() {
    let scene = Scene::grid(C3D10, [1, 1, 1], |x| x);
    let face = Face { cell: CellId { block: 0, cell: 0 }, face: 0 };
    let nodes = scene.structure.mesh.face(face).1;
    let load = LoadKind::Pressure { faces: vec![face] };
    let forces = unit_forces(&load, &scene.structure, &scene.freedoms).unwrap();
    let along = |n: u32| -> f64 {
        let own = scene.freedoms.of_node(n as usize);
        forces.iter().filter(|f| own.contains(&f.0)).map(|f| f.1 * f.1).sum::<f64>().sqrt()
    };
    nodes[..3].iter().for_each(|&n| assert!(along(n) < 1e-16));
    nodes[3..].iter().for_each(|&n| assert!((along(n) - 0.5 / 3.0).abs() < 1e-15));
}

/// Weight is density times volume: both are integrated exactly.
#[test]
fn gravity_adds_up_to_weight() {
    for element in ElementType::SOLIDS {
        let scene = scene(element);
        let cells: Vec<_> = scene.structure.mesh.cells().collect();
        let weight = 2.0 * scene.block().volumes().iter().sum::<f64>();
        let sum = resultant(&scene, &LoadKind::Gravity { cells, direction: [0.0, -1.0, 0.0] });
        assert!((sum[1] + weight).abs() < 1e-13 * weight && sum[0] == 0.0, "{element:?} {sum:?} {weight}");
    }
}

#[test]
fn what_cannot_be_loaded_is_named() {
    let mut scene = scene(CAX4);
    let cells: Vec<_> = scene.structure.mesh.cells().collect();
    let of = |scene: &Scene, load: LoadKind| unit_forces(&load, &scene.structure, &scene.freedoms).unwrap_err();
    let error = of(&scene, LoadKind::Gravity { cells: cells.clone(), direction: [1.0, 0.0, 0.0] });
    assert_eq!(error, LoadError::AcrossAxis { label: "1".into() });
    assert_eq!(
        of(&scene, LoadKind::Nodal { nodes: vec![4], component: 2 }),
        LoadError::NoFreedom { label: "5".into(), component: 2 }
    );
    let faces = vec![Face { cell: cells[0], face: 4 }];
    assert_eq!(of(&scene, LoadKind::Pressure { faces }).to_string(), "element 1 has no face S5 to press on");
    scene.structure.materials[0].density = None;
    let error = of(&scene, LoadKind::Gravity { cells, direction: [0.0, 1.0, 0.0] });
    assert_eq!(error.to_string(), "gravity acts on element 1, whose material M has no *DENSITY");
}
