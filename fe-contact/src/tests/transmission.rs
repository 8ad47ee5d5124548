//! Surface to surface passes a constant pressure exactly: the contact part of the patch test, without a solver.

use super::scene::*;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::pair::{Discretization, PairDefinition};
use fe_core::Term;
use fe_core::element::ElementType::{self, *};
use fe_mesh::Face;

/// Overclosure of the two blocks [L].
const OVERLAP: f64 = 0.01;

struct Interface {
    scene: Scene,
    secondary: Vec<Face>,
    main: Vec<Face>,
}

/// Upper block on lower block, each 2 × 1 (× 2), overlapping in the direction of the interface's normal; the map
/// takes both to their places.
fn interface(
    upper: (ElementType, [usize; 3]),
    lower: (ElementType, [usize; 3]),
    map: impl Fn(Vec3) -> Vec3,
) -> Interface {
    let mut scene = Scene::default();
    let at = |r: Vec3, y: f64| Vec3::new(2.0 * r.x, r.y + y, 2.0 * r.z);
    let u = scene.block(upper.0, upper.1, |r| map(at(r, 1.0 - OVERLAP)));
    let l = scene.block(lower.0, lower.1, |r| map(at(r, 0.0)));
    let secondary = scene.faces(u, |r| r[1] == 0.0);
    let main = scene.faces(l, |r| r[1] == 1.0);
    Interface { scene, secondary, main }
}

impl Interface {
    fn pair(&self, definition: &PairDefinition) -> Contact {
        self.scene.pair(definition, &linear())
    }

    /// Forces at p = 100 · 0.01 = 1 against −∫φ n on both sides; gap, areas and balance.
    fn check(&self, bound: f64, what: &str) {
        let pair = self.pair(&surfaces(self.secondary.clone(), self.main.clone(), Discretization::SurfaceToSurface));
        let state = pair.state(&vec![0.0; self.scene.freedoms().len()], &vec![0.0; pair.history()]);
        for p in &state.points {
            assert!((p.opening + OVERLAP).abs() < 1e-2 * bound && (p.pressure - 1.0).abs() < bound, "{what}: {p:?}");
        }
        for (side, faces) in [(&state.secondary, &self.secondary), (&state.main, &self.main)] {
            let expected = integrals(&self.scene, faces, |_| 1.0);
            let scale = expected.values().map(|f| f.norm()).fold(0.0, f64::max);
            assert_eq!(side.nodes.len(), expected.len());
            for (n, f) in &side.nodes {
                let error = (Vec3::from(*f) + expected[n]).norm() / scale;
                assert!(error < bound, "{what}, node {n}: {error:e}");
            }
        }
        let sum = |a: [f64; 3], b: [f64; 3]| (Vec3::from(a) + Vec3::from(b)).norm();
        assert!(sum(state.secondary.force, state.main.force) < bound, "{what}");
        assert!(sum(state.secondary.moment, state.main.moment) < 4.0 * bound, "{what}");
    }
}

const STRAIGHT: fn(Vec3) -> Vec3 = |x| x;
/// The plane scene turned by 37°.
const INCLINED: fn(Vec3) -> Vec3 = |x| nalgebra::Rotation3::from_axis_angle(&Vec3::z_axis(), 37f64.to_radians()) * x;

/// Bounds are round-off: a thousand operations of 1e-15; at ratio 100 the least overlaps are a hundredth of a
/// facet and lose two digits more.
#[test]
fn plane_meshes_that_do_not_match() {
    for (upper, lower) in [(4, 4), (3, 4), (5, 4), (4, 3), (97, 89), (1, 100), (100, 1)] {
        let bound = if upper.max(lower) < 90 { 1e-12 } else { 1e-11 };
        for (a, b) in [(CPE4, CPE4), (CPE3, CPE4), (CPE4, CPE3)] {
            for map in [STRAIGHT, INCLINED] {
                interface((a, [upper, 2, 0]), (b, [lower, 2, 0]), map)
                    .check(bound, &format!("{upper}/{lower} {a:?} on {b:?}"));
            }
        }
    }
}

/// In axisymmetric models the strip weighs 2πr: one more degree.
#[test]
fn axisymmetric_meshes_that_do_not_match() {
    for (upper, lower) in [(3, 4), (5, 4), (1, 100)] {
        let bound = if lower < 90 { 1e-12 } else { 1e-11 };
        interface((CAX4, [upper, 2, 0]), (CAX3, [lower, 1, 0]), |x| x).check(bound, "axisymmetric");
    }
}

#[test]
fn faces_in_space_that_do_not_match() {
    let kinds = [(C3D8, C3D8), (C3D4, C3D8), (C3D10, C3D8), (C3D8, C3D10), (C3D10, C3D4), (C3D10, C3D10)];
    for (a, b) in kinds {
        for (upper, lower) in [([3, 1, 2], [4, 1, 3]), ([4, 1, 4], [5, 1, 4]), ([2, 1, 2], [2, 1, 2])] {
            for map in [STRAIGHT, turned] {
                interface((a, upper), (b, lower), map).check(1e-12, &format!("{a:?} {upper:?} on {b:?} {lower:?}"));
            }
        }
    }
}

#[test]
fn contrasts_of_a_hundred_in_space() {
    interface((C3D8, [1, 1, 1]), (C3D4, [100, 1, 2]), turned).check(1e-11, "1 on 100");
    interface((C3D10, [97, 1, 2]), (C3D8, [89, 1, 1]), turned).check(1e-11, "97 on 89");
}

/// A warped map keeps the interface flat but makes its faces no parallelograms: the maps are rational then, and the
/// rule of degree 8 leaves an error of order (corner shift / size)⁹; the sums stay exact.
#[test]
fn faces_that_are_no_parallelograms() {
    let warp = |x: Vec3| {
        let bump = (x.x * (2.0 - x.x) * x.z * (2.0 - x.z)) * 0.15;
        turned(Vec3::new(x.x + bump, x.y, x.z - 0.7 * bump))
    };
    interface((C3D8, [3, 1, 3]), (C3D8, [4, 1, 4]), warp).check(1e-7, "warped");
}

/// A linear separation: the constraint's gap is the mean with the hat function, g_s = ∫ψ_s g / ∫ψ_s.
#[test]
fn a_linear_separation_gives_mean_gaps() {
    let case = interface((C3D8, [3, 1, 2]), (C3D4, [4, 1, 3]), |x| x);
    let pair = case.pair(&surfaces(case.secondary.clone(), case.main.clone(), Discretization::SurfaceToSurface));
    let (freedoms, mesh) = (case.scene.freedoms(), &case.scene.structure.mesh);
    let lift = |x: &Vec3| 0.02 + 0.3 * x.x - 0.2 * x.z;
    let mut u = vec![0.0; freedoms.len()];
    for &n in pair.secondary_nodes() {
        u[freedoms.index(n as usize, 1).unwrap()] = lift(&Vec3::from(mesh.points[n as usize]));
    }
    let weights = integrals(&case.scene, &case.secondary, |_| -1.0);
    let gaps = integrals(&case.scene, &case.secondary, |x| OVERLAP - lift(x));
    for p in pair.state(&u, &vec![0.0; pair.history()]).points {
        let expected = gaps[&p.node].y / weights[&p.node].y;
        assert!((p.opening - expected).abs() < 1e-13 && (p.measure.value() - weights[&p.node].y).abs() < 1e-13);
    }
}
