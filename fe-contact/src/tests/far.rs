//! Pairs far from the origin of coordinates.

use super::scene::*;
use crate::contact::Contact;
use crate::facet::Vec3;
use crate::pair::Discretization;
use crate::rigid::{Piece, RigidSurface, Sweep};
use crate::surface::Main;
use fe_core::element::ElementType::*;

/// A shift that rounds no coordinate of the scenes: they are multiples of 2⁻²⁰.
const SHIFT: f64 = 1_048_576.0;

fn dyadic(x: f64) -> f64 {
    (x * SHIFT).round() / SHIFT
}

/// Two blocks, 2 and 3 cells across, that overlap by about 1e-3, moved along all axes by so much.
fn stacked(by: f64) -> Scene {
    let mut scene = Scene::default();
    let moved = move |x: Vec3| x.map(|x| dyadic(x) + by);
    scene.block(C3D8, [2, 2, 1], moved);
    scene.block(C3D8, [3, 3, 1], move |r| moved(r + Vec3::z() * (1.0 - 1e-3)));
    scene
}

/// Largest difference of gaps, measures and rows, each of size 1 but for the gaps of 1e-3.
fn difference(a: &Contact, b: &Contact) -> f64 {
    assert_eq!(a.points.len(), b.points.len());
    let mut largest = 0.0f64;
    for (p, q) in a.points.iter().zip(&b.points) {
        assert_eq!(p.nodes, q.nodes);
        largest = largest.max((p.gap - q.gap).abs()).max((p.measure.value() - q.measure.value()).abs());
        largest = p.row.iter().zip(&q.row).map(|(x, y)| (x - y).abs()).fold(largest, f64::max);
    }
    largest
}

/// Against faces and against a rigid cylinder's arc, in both ways: the same to the round-off of numbers of size 1
/// (some ten operations of 2e-16), where differences of absolute coordinates would leave 1e-10.
#[test]
fn a_shift_changes_no_gap() {
    for discretization in [Discretization::SurfaceToSurface, Discretization::NodeToSurface] {
        let faces = |by: f64| {
            let scene = stacked(by);
            let (secondary, main) = (scene.faces(1, |r| r[2] == 0.0), scene.faces(0, |r| r[2] == 1.0));
            scene.pair(&surfaces(secondary, main, discretization), &linear())
        };
        assert!(difference(&faces(0.0), &faces(SHIFT)) < 1e-14);
        let rigid = |by: f64| {
            let mut scene = stacked(by);
            let reference = scene.node([by, by, by]);
            let arc = Piece::Arc { to: [4.0, 0.0], center: [0.0, -64.0] };
            let sweep = Sweep::Cylinder { origin: [by, by, by], x: [1.0, 0.0, 0.0], y: [0.0, 0.0, 1.0] };
            let surface = RigidSurface { name: "M".into(), sweep, start: [-4.0, 0.0], pieces: vec![arc] };
            let mut definition = surfaces(scene.faces(0, |r| r[2] == 0.0), Vec::new(), discretization);
            definition.main = Main::Rigid { surface, reference };
            let freedoms = scene.structure.freedoms(&[reference]);
            Contact::of_pair(&scene.structure, &freedoms, &definition, &linear()).unwrap()
        };
        // Distances are those of a radius of 64.
        assert!(difference(&rigid(0.0), &rigid(SHIFT)) < 64e-14);
    }
}
