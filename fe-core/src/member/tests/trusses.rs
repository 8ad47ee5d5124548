//! Trusses against hand calculations.

use super::scene::{Scene, YOUNG, force, turned};
use crate::element::ElementType::*;
use crate::freedoms::Freedoms;
use crate::load::LoadKind;
use crate::structure::Profile;
use crate::verify;

/// Two bars at ±45° from a held width, the load on their joint: u = P L / (2 E A cos² 45°) along the symmetry line. One
/// element a bar; the bound is round-off.
#[test]
fn two_bars_carry_a_joint() {
    let (area, p) = (3.0, 500.0);
    for element in [T2D2, T3D2] {
        let points = [[0.0, -10.0, 0.0], [0.0, 10.0, 0.0], [10.0, 0.0, 0.0]];
        let scene = Scene::new(&points).lines(element, &[&[0, 2], &[2, 1]], Profile::bar(area), [0.0; 3]);
        let mut held = vec![(0, 0), (0, 1), (1, 0), (1, 1)];
        if element == T3D2 {
            held.extend([(0, 2), (1, 2), (2, 2)]);
        }
        let u = scene.solve(&held, &[(force(2, 0), p)]);
        let length = 200f64.sqrt();
        let exact = p * length / (2.0 * YOUNG * area * 0.5);
        assert!((scene.at(&u, 2, 0) - exact).abs() < 1e-13 * exact, "{element:?}");
        for state in scene.members()[0].uniaxial(&u) {
            let stress = p / (2.0 * 0.5f64.sqrt() * area);
            assert!(
                (state.stress - stress).abs() < 1e-12 * stress
                    && (state.strain * YOUNG - stress).abs() < 1e-12 * stress
            );
            assert!((state.direction[0].abs() - 0.5f64.sqrt()).abs() < 1e-15);
        }
    }
}

/// A three-node truss whose mid node is not in the middle: a linear displacement gives one strain at both points, and the
/// quadratic one of its own weight, u = ρ g (L x − x²/2) / E, is exact at the nodes with the mid node in the middle.
#[test]
fn three_nodes_carry_a_linear_strain() {
    let scene = |mid: f64| {
        let points = [[1.0, 0.0, 0.0], [9.0, 0.0, 0.0], [1.0 + 8.0 * mid, 0.0, 0.0]];
        Scene::new(&points).lines(T3D3, &[&[0, 1, 2]], Profile::bar(2.0), [0.0; 3])
    };
    let sides: Vec<(u32, usize)> = (0..3).flat_map(|n| [(n, 1), (n, 2)]).chain([(0, 0)]).collect();
    let uneven = scene(0.4);
    let u = uneven.solve(&sides, &[(force(1, 0), 84.0)]);
    for state in uneven.members()[0].uniaxial(&u) {
        assert!((state.stress - 42.0).abs() < 1e-12 * 42.0);
    }
    assert!((uneven.at(&u, 2, 0) - 42.0 / YOUNG * 3.2).abs() < 1e-13 * 1e-3);
    let even = scene(0.5);
    let cells = even.structure.lines[0].cells.clone();
    let weight = LoadKind::Gravity { cells, direction: [1.0, 0.0, 0.0] };
    let u = even.solve(&sides, &[(weight, 1e6)]);
    let exact = |x: f64| 2e-9 * 1e6 * (8.0 * x - 0.5 * x * x) / YOUNG;
    for (node, x) in [(1, 8.0), (2, 4.0)] {
        assert!((even.at(&u, node, 0) - exact(x)).abs() < 1e-12 * exact(8.0));
    }
}

/// Differences of a quadratic energy are exact but for round-off: ε |E| / step of the force, about 1e-12 / 1e-3 here.
#[test]
fn trusses_are_consistent() {
    let points = [[0.1, 0.2, 0.0], [4.0, -1.0, 3.0], [2.2, -0.5, 1.4]].map(turned);
    let scene = Scene::new(&points).lines(T3D2, &[&[0, 2], &[1, 2]], Profile::bar(2.0), [0.0; 3]).lines(
        T3D3,
        &[&[0, 1, 2]],
        Profile::bar(1.0),
        [0.0; 3],
    );
    let freedoms: Freedoms = scene.freedoms();
    let u: Vec<f64> = (0..freedoms.len()).map(|i| (i as f64).sin()).collect();
    for members in scene.members() {
        let found = verify::term(&members, &freedoms, &u, 1e-2).unwrap();
        assert!(found.force < 1e-9 && found.stiffness < 1e-9 && found.paths == 0.0, "{found:?}");
    }
}
