//! Springs against closed forms, and the stiffness around a node.

use super::scene::{Scene, YOUNG, force, turned};
use crate::bodies::bodies;
use crate::element::ElementType::*;
use crate::nodal_stiffness::nodal_stiffness;
use crate::structure::Profile;
use crate::verify;
use nalgebra::Matrix3;

/// Springs to the ground and between freedoms: k₁ u₁ = P − k₂ (u₁ − u₂), k₂ (u₁ − u₂) = −(load of the second).
#[test]
fn springs_in_a_row() {
    let (k1, k2, p, q) = (100.0, 40.0, 7.0, -3.0);
    let scene = Scene::new(&[[0.0; 3], [5.0, 0.0, 0.0]]).discrete(SPRING1, &[&[0]], k1, [1, 0]).discrete(
        SPRING2,
        &[&[0, 1]],
        k2,
        [1, 2],
    );
    let freedoms = scene.freedoms();
    assert_eq!(freedoms.len(), 2, "springs give the freedoms that they name");
    let u = scene.solve(&[], &[(force(0, 1), p), (force(1, 2), q)]);
    let first = (p + q) / k1;
    assert!((scene.at(&u, 0, 1) - first).abs() < 1e-14);
    assert!((scene.at(&u, 1, 2) - (first + q / k2)).abs() < 1e-14);
    // What the springs resist with: that of the ground along y, that of the second freedom along z.
    let sums: Vec<[f64; 3]> = scene.members().iter().map(|m| m.resultant(&freedoms, &u)).collect();
    assert!((sums[0][1] - (p + q)).abs() < 1e-13 && (sums[1][1] + q).abs() < 1e-13 && (sums[1][2] - q).abs() < 1e-13);
}

/// A spring between nodes is a truss of EA / L = k in any direction.
#[test]
fn a_spring_along_its_line_is_a_truss() {
    let points = [[1.0, 2.0, 3.0], [4.0, 6.0, 3.0]].map(turned);
    let stiffness = |scene: Scene| scene.stiffness();
    let spring = stiffness(Scene::new(&points).discrete(SPRINGA, &[&[0, 1]], YOUNG / 5.0, [0, 0]));
    let truss = stiffness(Scene::new(&points).lines(T3D2, &[&[0, 1]], Profile::bar(1.0), [0.0; 3]));
    assert!((&spring - &truss).amax() < 1e-13 * truss.amax());
}

/// See the trusses for the bound.
#[test]
fn springs_are_consistent() {
    let scene = Scene::new(&[[0.0; 3], [5.0, 1.0, 2.0]])
        .discrete(SPRING1, &[&[0], &[1]], 3.0, [4, 0])
        .discrete(SPRING2, &[&[0, 1]], 7.0, [1, 2])
        .discrete(SPRINGA, &[&[0, 1]], 11.0, [0, 0]);
    let freedoms = scene.freedoms();
    let u: Vec<f64> = (0..freedoms.len()).map(|i| (i as f64).cos()).collect();
    for members in scene.members() {
        let found = verify::term(&members, &freedoms, &u, 1e-2).unwrap();
        assert!(found.force < 1e-9 && found.stiffness < 1e-9 && found.paths == 0.0, "{found:?}");
    }
}

/// A spring to the ground holds its freedom; what springs join is one body; a straight chain does not turn about itself.
#[test]
fn springs_hold_bodies() {
    let scene = Scene::new(&[[0.0; 3], [5.0, 0.0, 0.0], [9.0, 0.0, 0.0]])
        .discrete(SPRINGA, &[&[0, 1]], 1.0, [0, 0])
        .discrete(SPRING1, &[&[1]], 1.0, [0, 0])
        .discrete(MASS, &[&[2]], 1.0, [0, 0]);
    let found = bodies(&scene.structure, &[]);
    assert_eq!(found.iter().map(|b| b.nodes.clone()).collect::<Vec<_>>(), [vec![0, 1], vec![2]]);
    let freedoms = scene.freedoms();
    let mut fixed = vec![false; freedoms.len()];
    let free = found[0].free_motions(&scene.structure, &freedoms, &fixed);
    assert_eq!(free.len(), 4, "across in two directions, and about two axes");
    for (node, component) in [(0, 1), (0, 2), (1, 1), (1, 2)] {
        fixed[freedoms.index(node, component).unwrap()] = true;
    }
    assert!(found[0].free_motions(&scene.structure, &freedoms, &fixed).is_empty());
    assert_eq!(found[1].free_motions(&scene.structure, &freedoms, &fixed).len(), 3);
}

/// E A / L of two bars in line and 12 E I / L³ across them, a spring on top; nothing at a bare node.
#[test]
fn each_translation_has_its_stiffness() {
    let square = Profile::rectangle(2.0, 2.0);
    let points = [[0.0; 3], [10.0, 0.0, 0.0], [30.0, 0.0, 0.0], [40.0, 0.0, 0.0], [50.0, 0.0, 0.0]];
    let scene = Scene::new(&points)
        .lines(B33, &[&[0, 1], &[1, 2]], square, [0.0, 0.0, 1.0])
        .discrete(SPRING1, &[&[2]], 1e6, [2, 0])
        .discrete(MASS, &[&[3]], 5.0, [0, 0]);
    let found = nodal_stiffness(&scene.structure, &scene.freedoms(), &[1, 2, 3, 4]);
    let axial = YOUNG * square.area;
    let across = |length: f64| 12.0 * YOUNG * square.i11 / length.powi(3);
    let middle = across(10.0) + across(20.0);
    let exact = [
        [axial / 10.0 + axial / 20.0, middle, middle],
        [axial / 20.0, across(20.0), 1e6 + across(20.0)],
        [0.0; 3],
        [0.0; 3],
    ];
    for (found, exact) in found.iter().zip(exact) {
        let difference = found - Matrix3::from_diagonal(&exact.into());
        assert!(difference.amax() <= 1e-12 * found.amax(), "{found} {exact:?}");
    }
}
