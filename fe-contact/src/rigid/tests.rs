//! Distances, normals, and profiles that are refused.

use super::*;

fn surface(sweep: Sweep, start: [f64; 2], pieces: &[Piece]) -> RigidSurface {
    RigidSurface { name: "R".into(), sweep, start, pieces: pieces.to_vec() }
}

fn gap(s: &RigidSurface, x: [f64; 3]) -> f64 {
    s.distance(x).unwrap().gap
}

/// A line from x₀ to x₁ > x₀ faces +y; it reaches a tenth of its length past its ends and no further.
#[test]
fn a_line_faces_to_its_left_and_ends() {
    let s = surface(Sweep::Segments, [-1.0, 0.5], &[Piece::Line { to: [1.0, 0.5] }]);
    assert_eq!(s.distance([0.3, 0.75, 0.0]).unwrap(), Distance { gap: 0.25, normal: [0.0, 1.0, 0.0] });
    assert_eq!(gap(&s, [1.15, 0.25, 0.0]), -0.25);
    assert_eq!(s.distance([1.25, 0.6, 0.0]), None);
}

/// A box with its corner at the origin, bodies above and to the right of it: outside a convex corner the
/// distance is that to the corner, inside it is that to the nearer face; a concave corner the other way.
#[test]
fn corners_are_met_from_both_sides() {
    let convex =
        surface(Sweep::Segments, [-4.0, 0.0], &[Piece::Line { to: [0.0, 0.0] }, Piece::Line { to: [0.0, -4.0] }]);
    let at = convex.distance([0.3, 0.4, 0.0]).unwrap();
    assert!((at.gap - 0.5).abs() < 1e-15 && (at.normal[0] - 0.6).abs() < 1e-15 && (at.normal[1] - 0.8).abs() < 1e-15);
    assert_eq!(gap(&convex, [-0.1, -0.3, 0.0]), -0.1);
    let n = convex.distance([0.0, 0.0, 0.0]).unwrap().normal;
    assert!((n[0] * n[0] + n[1] * n[1] - 1.0).abs() < 1e-15);
    let concave =
        surface(Sweep::Segments, [0.0, 4.0], &[Piece::Line { to: [0.0, 0.0] }, Piece::Line { to: [4.0, 0.0] }]);
    assert_eq!(gap(&concave, [0.1, 0.3, 0.0]), 0.1);
    assert!((gap(&concave, [-0.3, -0.4, 0.0]) + 0.5).abs() < 1e-15);
}

/// Sphere of radius 2 about (1, 0, 3): |x − c| − R, normal from the centre, also on the axis.
#[test]
fn an_arc_revolved_is_a_sphere() {
    let sweep = Sweep::Revolution { origin: [1.0, 0.0, 3.0], axis: [0.0, 0.0, 1.0] };
    // Clockwise from the pole over the equator, so that the left is outside.
    let arcs = [Piece::Arc { to: [2.0, 0.0], center: [0.0, 0.0] }, Piece::Arc { to: [0.0, -2.0], center: [0.0, 0.0] }];
    let s = surface(sweep, [0.0, 2.0], &arcs);
    s.check().unwrap();
    for x in [[2.0, -1.0, 0.5], [1.0, 0.0, 0.4], [1.0, 0.0, 5.5], [1.5, 1.0, 3.0], [3.5, 1.0, 3.0]] {
        let r = Vector3::from(x) - Vector3::new(1.0, 0.0, 3.0);
        let at = s.distance(x).unwrap();
        assert!((at.gap - (r.norm() - 2.0)).abs() < 1e-14, "{x:?}");
        assert!((Vector3::from(at.normal) - r.normalize()).norm() < 1e-14, "{x:?}");
    }
}

/// A trough (arc travelled counter-clockwise, body inside) swept along a tilted generator.
#[test]
fn an_arc_swept_is_a_trough() {
    let (e1, e2) = ([0.6, 0.8, 0.0], [0.0, 0.0, 1.0]);
    let s = surface(
        Sweep::Cylinder { origin: [1.0, 2.0, 3.0], x: e1, y: e2 },
        [-1.0, 0.0],
        &[Piece::Arc { to: [0.0, -1.0], center: [0.0, 0.0] }, Piece::Arc { to: [1.0, 0.0], center: [0.0, 0.0] }],
    );
    // Local (0.3, −0.4), anywhere along the generator (0.8, −0.6, 0).
    let at = s.distance([1.0 + 0.18 + 1.6, 2.0 + 0.24 - 1.2, 3.0 - 0.4]).unwrap();
    assert!((at.gap - 0.5).abs() < 1e-14);
    let n = Vector3::new(-0.6 * 0.6, -0.6 * 0.8, 0.8);
    assert!((Vector3::from(at.normal) - n).norm() < 1e-14);
}

/// The normal is the gradient of the distance: central differences, error O(step²) with curvature ≤ 1/R.
#[test]
fn the_normal_is_the_gradient() {
    let s = surface(
        Sweep::Segments,
        [-3.0, 0.0],
        &[
            Piece::Line { to: [-1.0, 0.0] },
            Piece::Arc { to: [1.0, 0.0], center: [0.0, -1.0] },
            Piece::Line { to: [3.0, 1.0] },
        ],
    );
    for (i, j) in (0..20).flat_map(|i| (0..9).map(move |j| (i, j))) {
        let x = [-2.57 + 0.26 * f64::from(i), 0.031 + 0.17 * f64::from(j), 0.0];
        let at = s.distance(x).unwrap();
        let step = 1e-5;
        for k in 0..2 {
            let (mut a, mut b) = (x, x);
            a[k] -= step;
            b[k] += step;
            let slope = (gap(&s, b) - gap(&s, a)) / (2.0 * step);
            assert!((slope - at.normal[k]).abs() < 1e-8, "{x:?}");
        }
    }
}

#[test]
fn impossible_profiles_are_refused() {
    let bad = |start, pieces: &[Piece]| surface(Sweep::Segments, start, pieces).check().unwrap_err();
    assert_eq!(bad([0.0, 0.0], &[]), RigidFault::NoPieces);
    assert_eq!(bad([0.0, 0.0], &[Piece::Line { to: [0.0, 0.0] }]), RigidFault::NoLength(1));
    assert_eq!(
        bad([1.0, 0.0], &[Piece::Arc { to: [0.0, 2.0], center: [0.0, 0.0] }]),
        RigidFault::NoArc { piece: 1, start: 1.0, end: 2.0 }
    );
    assert_eq!(bad([1.0, 0.0], &[Piece::Arc { to: [-1.0, 0.0], center: [0.0, 0.0] }]), RigidFault::LongArc(1));
}
