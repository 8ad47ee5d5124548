//! C03: beams against closed solutions, turned at will.

use super::scene::{SHEAR, Scene, YOUNG, clamped, force, turned};
use crate::element::ElementType::{self, *};
use crate::load::LoadKind;
use crate::structure::Profile;
use crate::verify;

const LENGTH: f64 = 1000.0;
const LOAD: f64 = 1000.0;
const SIDE: f64 = 20.0;

/// n equal elements along x.
fn cantilever(element: ElementType, n: u32, profile: Profile) -> Scene {
    let points: Vec<[f64; 3]> = (0..=n).map(|i| [LENGTH * f64::from(i) / f64::from(n), 0.0, 0.0]).collect();
    let cells: Vec<[u32; 2]> = (0..n).map(|i| [i, i + 1]).collect();
    let cells: Vec<&[u32]> = cells.iter().map(|c| c.as_slice()).collect();
    Scene::new(&points).lines(element, &cells, profile, [0.0, 0.0, -1.0])
}

/// Tip deflection along y of a square cantilever.
fn tip(element: ElementType, n: u32) -> f64 {
    let scene = cantilever(element, n, Profile::rectangle(SIDE, SIDE));
    let components: &[usize] = if matches!(element, B21 | B23) { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
    let u = scene.solve(&clamped(0, components), &[(force(n, 1), LOAD)]);
    scene.at(&u, n, 1)
}

/// P L³ / 3 E I. The condition of n cubic beams is of order n⁴, at n = 16 7e4 ε.
#[test]
fn c03_slender_beams_are_exact() {
    for element in [B23, B33] {
        for n in [1, 2, 4, 8, 16] {
            let found = tip(element, n);
            assert!((found - 119.047619048).abs() < 1e-9 * found, "{element:?} {n} {found}");
        }
    }
}

/// P L³ / 3 E I (1 − 1/4n²) + P L / κ G A, in the ten figures of the case.
#[test]
fn c03_linear_beams_converge_from_below() {
    let exact = [(1, 89.3221288515), (2, 111.643557423), (4, 117.223914566), (8, 118.619003852), (16, 118.967776173)];
    for element in [B21, B31] {
        for (n, exact) in exact {
            let found = tip(element, n);
            assert!((found / exact - 1.0).abs() < 1e-10, "{element:?} {n} {found}");
        }
    }
}

/// An L-shaped crank, the load out of its plane: bending of both arms and torsion of the first. The same in any frame, with
/// the load and the cross-section turned along.
#[test]
fn c03_a_crank_bends_and_twists() {
    let (a, b) = (600.0, 400.0);
    let square = Profile { torsion: 0.1406 * SIDE.powi(4), ..Profile::rectangle(SIDE, SIDE) };
    let corners = [[0.0; 3], [a, 0.0, 0.0], [a, b, 0.0]];
    let deflection = |turn: fn([f64; 3]) -> [f64; 3]| {
        let load = turn([0.0, 0.0, LOAD]);
        let scene = Scene::new(&corners.map(turn)).lines(B33, &[&[0, 1], &[1, 2]], square, turn([0.0, 0.0, 1.0]));
        let loads: Vec<_> = (0..3).map(|c| (force(2, c), load[usize::from(c)])).collect();
        let u = scene.solve(&clamped(0, &[0, 1, 2, 3, 4, 5]), &loads);
        (0..3).map(|c| scene.at(&u, 2, c) * load[c] / LOAD).sum::<f64>()
    };
    let i = SIDE.powi(4) / 12.0;
    let formula = LOAD * ((a.powi(3) + b.powi(3)) / (3.0 * YOUNG * i) + b * b * a / (SHEAR * square.torsion));
    assert!((formula - 86.1681230102).abs() < 1e-9, "{formula}");
    let (straight, turned) = (deflection(|x| x), deflection(turned));
    assert!((straight / formula - 1.0).abs() < 1e-12, "{straight}");
    assert!((turned / straight - 1.0).abs() < 1e-12, "{turned}");
}

/// An unsymmetric cross-section bends aside: with moduli E I the curvature of the moment M about axis 1 is that of the
/// inverse, w'' = M I₂₂ / E Δ, v'' = −M I₁₂ / E Δ, Δ = I₁₁ I₂₂ − I₁₂²; tip = w'' L² / 2.
#[test]
fn unsymmetric_sections_bend_aside() {
    let profile = Profile { i11: 4e4, i12: 1.5e4, i22: 2e4, ..Profile::rectangle(SIDE, SIDE) };
    let scene = cantilever(B33, 1, profile);
    // Axis 1 is −z, axis 2 is y: a moment about z bends along y.
    let u = scene.solve(&clamped(0, &[0, 1, 2, 3, 4, 5]), &[(force(1, 5), 2e6)]);
    let delta = profile.i11 * profile.i22 - profile.i12 * profile.i12;
    let half = 0.5 * 2e6 * LENGTH * LENGTH / (YOUNG * delta);
    let (along_2, along_1) = (half * profile.i22, -half * profile.i12);
    assert!((scene.at(&u, 1, 1) / along_2 - 1.0).abs() < 1e-12);
    assert!((scene.at(&u, 1, 2) / -along_1 - 1.0).abs() < 1e-12);
}

/// A13's upper beam by itself: q L⁴ · 5/384 E I at the middle, by the consistent moments exact with two elements.
#[test]
fn a_load_per_length_is_consistent() {
    let (q, i) = (4.0, 2e4);
    let scene = cantilever(B23, 2, Profile { i11: i, ..Profile::rectangle(SIDE, SIDE) });
    let cells = scene.structure.lines[0].cells.clone();
    let held = [(0, 0), (0, 1), (2, 1)];
    let u = scene.solve(&held, &[(LoadKind::Line { cells: cells.clone(), component: 1 }, -q)]);
    let exact = -5.0 * q * LENGTH.powi(4) / (384.0 * YOUNG * i);
    assert!((scene.at(&u, 1, 1) / exact - 1.0).abs() < 1e-12);
    let weight = LoadKind::Gravity { cells, direction: [0.0, -1.0, 0.0] };
    let v = scene.solve(&held, &[(weight, q / (2e-9 * SIDE * SIDE))]);
    assert!((scene.at(&v, 1, 1) / exact - 1.0).abs() < 1e-12);
}

/// The moments at the Gauss points of a cantilever are P (L − x).
#[test]
fn section_forces_of_a_cantilever() {
    let scene = cantilever(B33, 1, Profile::rectangle(SIDE, SIDE));
    let u = scene.solve(&clamped(0, &[0, 1, 2, 3, 4, 5]), &[(force(1, 1), LOAD), (force(1, 0), 50.0)]);
    let forces = scene.members()[0].section_forces(&u);
    for ((_, forces), sign) in forces.iter().zip([-1.0, 1.0]) {
        let x = 0.5 * LENGTH * (1.0 + sign / 3f64.sqrt());
        // Axis 1 is −z: a deflection along y that grows bends about −z with negative κ₁.
        assert!((forces[1] + LOAD * (LENGTH - x)).abs() < 1e-9 * LOAD * LENGTH, "{forces:?}");
        assert!((forces[0] - 50.0).abs() < 1e-9 && forces[2].abs() < 1e-6 && forces[3].abs() < 1e-6);
    }
    // The shear along axis 2 is the load, in both kinds of beam.
    for element in [B33, B31] {
        let scene = cantilever(element, 1, Profile::rectangle(SIDE, SIDE));
        let u = scene.solve(&clamped(0, &[0, 1, 2, 3, 4, 5]), &[(force(1, 1), LOAD), (force(1, 0), 50.0)]);
        let [n, q1, q2, m1, m2, t] = scene.members()[0].mean_section_forces(&u)[0];
        assert!((n - 50.0).abs() < 1e-9 && (q2 - LOAD).abs() < 1e-6 && (m1 + 0.5 * LOAD * LENGTH).abs() < 1e-5);
        assert!(q1.abs() < 1e-6 && m2.abs() < 1e-5 && t.abs() < 1e-5, "{q1} {m2} {t}");
    }
}

/// See the trusses for the bound; six rigid motions are free of force.
#[test]
fn beams_are_consistent_and_free_of_strain_in_rigid_motions() {
    let profile = Profile { i12: 1e3, ..Profile::rectangle(10.0, 30.0) };
    for element in [B31, B33] {
        let points = [[0.0; 3], [40.0, 10.0, 5.0], [70.0, 30.0, -5.0]];
        let scene = Scene::new(&points).lines(element, &[&[0, 1], &[2, 1]], profile, [0.1, 0.2, 1.0]);
        let (freedoms, members) = (scene.freedoms(), scene.members());
        let u: Vec<f64> = (0..freedoms.len()).map(|i| (i as f64).sin()).collect();
        let found = verify::term(&members[0], &freedoms, &u, 1e-2).unwrap();
        assert!(found.force < 1e-8 && found.stiffness < 1e-8 && found.paths == 0.0, "{element:?} {found:?}");
        let stiffness = scene.stiffness();
        let body = &crate::bodies::bodies(&scene.structure, &[])[0];
        let free = body.free_motions(&scene.structure, &freedoms, &vec![false; freedoms.len()]);
        assert_eq!(free.len(), 6);
        for motion in free {
            let field = nalgebra::DVector::from_vec(body.field(&scene.structure, &freedoms, &motion));
            assert!((&stiffness * &field).amax() < 1e-12 * stiffness.amax() * field.amax());
        }
    }
}

/// Slender beams up to L / t = 1e6: the tip is exact to what the condition of one element, 12 E I / L against E A L, leaves.
#[test]
fn d28_thin_beams_keep_their_digits() {
    for slenderness in [1e2, 1e3, 1e4, 1e5, 1e6] {
        let t = LENGTH / slenderness;
        for (element, n) in [(B21, 1), (B31, 1), (B23, 1), (B33, 1)] {
            let profile = Profile::rectangle(t, t);
            let scene = cantilever(element, n, profile);
            let components: &[usize] = if matches!(element, B21 | B23) { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
            let u = scene.solve(&clamped(0, components), &[(force(n, 1), 1.0)]);
            let slender = LENGTH.powi(3) / (3.0 * YOUNG * profile.i11);
            let exact = match element {
                B21 | B31 => 0.75 * slender + LENGTH / (0.85 * SHEAR * profile.area),
                _ => slender,
            };
            let error = (scene.at(&u, n, 1) / exact - 1.0).abs();
            // Of the linear beam the stiffness across is κ G A / L, larger by (L/t)² than that of bending: cond · ε.
            let condition = if matches!(element, B21 | B31) { slenderness * slenderness } else { 1.0 };
            assert!(error < 1e-13 + 20.0 * condition * f64::EPSILON, "{element:?} {slenderness} {error:e}");
        }
    }
}
