//! Elements of the plane and around an axis.

use super::*;

/// Stretched alike along x and y without stress across, beyond yield: σ = E/(1 − ν)(ε − p/2) = σ_y(p), and the thickness follows
/// ln λ_z = −2 ν σ/E − p.
#[test]
fn plane_stress_yields_under_equal_tension() {
    for element in [CPS4R, CPS3] {
        let mut setup = Setup::plastic(element, vec![(0.0, 300.0), (0.01, 340.0), (1.0, 400.0)]);
        setup.thickness = 2.0;
        let mut scene = setup.block(1, |x| x);
        let strain = 0.05;
        scene.follow(400, 1.0, |x, t| x * (strain * t).exp());
        let PointState { stress, plastic, .. } = scene.state();
        let yielded = 340.0 + (plastic - 0.01) * 60.0 / 0.99;
        let elastic = STEEL.young / (1.0 - STEEL.poisson) * (strain - 0.5 * plastic);
        // Strains of the midpoint rule: (ε/400)²/12 of ε off, which E magnifies to 1e-6 of the stress.
        assert!((stress[0] - yielded).abs() < 1e-9 * yielded && (elastic - yielded).abs() < 1e-5 * yielded);
        assert!(stress[2].abs() < 1e-9 && (stress[0] - stress[1]).abs() < 1e-9, "{stress:?}");
        let thickness = 2.0 * (-2.0 * STEEL.poisson * yielded / STEEL.young - plastic).exp();
        let force = scene.held(0, |x| x[0] > 0.5);
        assert!((force / (stress[0] * thickness * strain.exp()) - 1.0).abs() < 1e-6, "{force}");
    }
}

/// Any path in the plane, with the table's corners on the way: no stress across, and never beyond the yield surface.
#[test]
fn plane_stress_stays_plane() {
    let mut scene =
        Setup::plastic(CPS4R, vec![(0.0, 300.0), (0.003, 500.0), (0.02, 500.0), (0.1, 900.0)]).block(1, |x| x);
    for step in 0..300 {
        let a = 0.1 * f64::from(step);
        let to = |x: Vector3<f64>| {
            let e = [0.02 * a.sin(), 0.03 * (1.3 * a).cos() - 0.03, 0.02 * (0.7 * a).sin()];
            Vector3::new(x.x * (1.0 + e[0]) + e[2] * x.y, x.y * (1.0 + e[1]), 0.0)
        };
        scene.go(1.0, to);
        let PointState { stress: s, plastic, .. } = scene.state();
        let q = (s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3.0 * s[3] * s[3]).sqrt();
        let (limit, _) =
            Hardening { points: vec![(0.0, 300.0), (0.003, 500.0), (0.02, 500.0), (0.1, 900.0)] }.at(plastic);
        // Rounding of strains of 1e-2 times the moduli.
        assert!(s[2].abs() < 1e-9 * STEEL.young * 1e-2 && q < limit * (1.0 + 1e-10), "{step}: {s:?} {q} {limit}");
    }
    assert!(scene.state().plastic > 0.1);
}

/// A row of square elements, a square high, bends as a beam should: M = E′ I κ at any number of elements along it, E′ that of the
/// plane.
#[test]
fn one_row_of_squares_bends() {
    for (element, modulus) in [(CPS4R, STEEL.young), (CPE4R, STEEL.young / (1.0 - STEEL.poisson * STEEL.poisson))] {
        let mut scene = Setup::elastic(element).scene(Block::quad4([4, 1]).size([4.0, 1.0, 0.0]).mesh());
        let curvature = 1e-6;
        // Circles with the in-plane Poisson's ratio of the element.
        let nu = if element == CPE4R { STEEL.poisson / (1.0 - STEEL.poisson) } else { STEEL.poisson };
        scene.go(1.0, |x| {
            let (s, y) = (x.x - 2.0, x.y - 0.5);
            x + Vector3::new(-s * y, 0.5 * s * s + 0.5 * nu * y * y, 0.0) * curvature
        });
        let top = scene.held(0, |x| x[0] > 3.9 && x[1] > 0.5);
        let expected = -modulus * curvature / 12.0;
        assert!((top / expected - 1.0).abs() < 1e-4, "{}: {top} {expected}", element.name());
    }
}

/// A thick ring under a uniform widening u = c r: σ_rr = σ_θθ, and the outer face is held by σ 2π r h.
#[test]
fn ring_pushes_back() {
    for element in [CAX4R, CAX3] {
        let mut scene = Setup::elastic(element).block(3, flat);
        scene.go(1.0, |x| Vector3::new(x.x * 1.0001, x.y, 0.0));
        let force = scene.held(0, |x| x[0] > 1.49);
        let stress = scene.state().stress;
        // Rounding of places over displacements of 1e-4.
        let expected = stress[0] * 2.0 * std::f64::consts::PI * 1.5 * 1.0001;
        assert!((force / expected - 1.0).abs() < 1e-10 && (stress[0] - stress[2]).abs() < 1e-10 * stress[0]);
    }
}
