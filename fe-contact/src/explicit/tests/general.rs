//! General contact: what a pair answers, ridges that cross, bodies that fold, laws, exclusions, threads.

use super::bodies::{Bodies, DENSITY, Motion, cube, general};
use super::*;
use crate::explicit::general::{GeneralFace, adjust};
use crate::law::scale_factor::{Piece as Part, Scaling};
use fe_mesh::generate::Block;

/// Two cubes of equal meshes that meet head on: the same motion as under two pairs of the faces that meet, each by halves.
#[test]
fn cubes_meet_as_pairs_do() {
    let bodies = Bodies::new(&[cube(3, [0.0; 3]), cube(3, [0.0, 0.0, 1.005])]);
    let velocity = |node: u32, _: Vec3| Vec3::z() * if bodies.body_of(node) == 0 { 0.0 } else { -0.2 };
    let definition = bodies.definition(free(Normal::Hard), &[]);
    let mut all = Motion::new(&bodies, general(&bodies, definition), velocity);
    let faces = |z: f64| -> Vec<GeneralFace> {
        let at = |node: &u32| (bodies.structure.mesh.points[*node as usize][2] - z).abs() < 1e-9;
        bodies.faces().into_iter().filter(|face| face.nodes.iter().all(at)).collect()
    };
    let half = |nodes: &[GeneralFace], main: &[GeneralFace], freedoms: &Freedoms| {
        let mut own: Vec<u32> = nodes.iter().flat_map(|face| face.nodes.clone()).collect();
        own.sort_unstable();
        own.dedup();
        let main = MainSurface::Faces(main.iter().map(|face| face.nodes.clone()).collect());
        let pair = Definition {
            enforcement: Enforcement::Penalty(0.5),
            behaviour: free(Normal::Hard),
            ..definition_of(&own, main)
        };
        ContactPair::new(&bodies.structure, freedoms, pair, &[])
    };
    let (lower, upper) = (faces(1.0), faces(1.005));
    let both = |freedoms: &Freedoms| vec![half(&lower, &upper, freedoms), half(&upper, &lower, freedoms)];
    let mut pairs = Motion::new(&bodies, both, velocity);
    let (before, energy) = (all.momentum(&bodies, 1), all.energy());
    let dt = 0.8 * all.procedure.stable().increment();
    let mut deepest = 0.0f64;
    for _ in 0..300 {
        all.advance(dt);
        pairs.advance(dt);
        deepest = deepest.max(all.contacts[0].state().points.iter().map(|p| -p.opening).fold(0.0, f64::max));
    }
    assert!(deepest > 1e-3, "they met: {deepest}");
    let size = pairs.state.u.iter().fold(0.0f64, |a, b| a.max(b.abs()));
    for (a, b) in all.state.u.iter().zip(&pairs.state.u) {
        // A node whose foot leaves its twin by a part s of an edge, here some 1e-4, has a penalty that is less by as much.
        assert!((a - b).abs() < 1e-4 * size, "{a} {b}");
    }
    let after = [0, 1].map(|body| all.momentum(&bodies, body));
    assert!((after[0] + after[1] - before).norm() < 1e-12 * before.norm(), "{after:?}");
    // Nearly all of it is handed over; elastic contact keeps the energy but for (ωΔt)²/4 at touch and release.
    assert!(after[0].z < 0.9 * before.z && all.contacts[0].count().closed == 0, "{after:?}");
    assert!((all.energy() / energy - 1.0).abs() < 5e-3, "{} {energy}", all.energy());
}

fn definition_of(nodes: &[u32], main: MainSurface) -> Definition {
    definition(nodes, main, Arc::new(Linear { slope: 1.0, clearance: 0.0 }))
}

/// A bar along x under one along y, of which no node comes over a face of the other: only ridges hold them, with equal and
/// opposite forces, and they part again as fast as they came.
#[test]
fn bars_cross_on_their_ridges() {
    let lower = Block::hex8([3, 1, 1]).size([6.0, 1.0, 1.0]).origin([-3.0, -0.5, 0.0]).mesh();
    let upper = Block::hex8([1, 3, 1]).size([1.0, 6.0, 1.0]).origin([-0.5, -3.0, 1.01]).mesh();
    let bodies = Bodies::new(&[lower, upper]);
    let velocity = |node: u32, _: Vec3| Vec3::z() * if bodies.body_of(node) == 0 { 0.1 } else { -0.1 };
    let definition = bodies.definition(free(Normal::Hard), &[]);
    let mut bars = Motion::new(&bodies, general(&bodies, definition), velocity);
    let before = [0, 1].map(|body| bars.momentum(&bodies, body));
    let energy = bars.energy();
    let dt = 0.8 * bars.procedure.stable().increment();
    let (mut most, mut least) = (0, f64::INFINITY);
    for _ in 0..400 {
        bars.advance(dt);
        let count = bars.contacts[0].count();
        most = most.max(count.closed);
        assert!(bars.contacts[0].state().points.iter().all(|point| point.status == ContactStatus::Open));
        let height = |body: usize| bars.x(&bodies, bodies.first[body] + 1).z;
        least = least.min(height(1) - height(0));
    }
    assert_eq!(most, 4, "four ridges cross four");
    let after = [0, 1].map(|body| bars.momentum(&bodies, body));
    assert!((after[0] + after[1]).norm() < 1e-12 * before[0].norm(), "{after:?}");
    // They part, and swing.
    assert!(after[0].z < 0.0 && after[1].z > 0.0, "{after:?}");
    assert!(least > -0.1, "they did not pass: {least}");
    assert!((bars.energy() / energy - 1.0).abs() < 5e-3, "{} {energy}", bars.energy());
}

/// The arms of a U, which fly together and apart again: nothing touches before they meet, and they do not pass.
#[test]
fn a_strip_folds_onto_itself() {
    let (arm, radius) = (2.0, 0.4);
    let length = 2.0 * arm + std::f64::consts::PI * radius;
    let bent = |[s, n, z]: [f64; 3]| match s * length {
        s if s < arm => [arm - s, -radius - n, z],
        s if s > length - arm => [s - length + arm, radius + n, z],
        s => {
            let angle = -std::f64::consts::FRAC_PI_2 - (s - arm) / radius;
            [(radius + n) * angle.cos(), (radius + n) * angle.sin(), z]
        }
    };
    let strip = Block::hex8([30, 2, 3]).size([1.0, 0.2, 0.5]).origin([0.0, -0.1, 0.0]);
    let bodies = Bodies::new(&[strip.mapped(bent)]);
    let velocity = |_: u32, x: Vec3| Vec3::y() * (-x.y.signum() * (x.x / arm).max(0.0));
    let definition = bodies.definition(free(Normal::Hard), &[]);
    let mut strip = Motion::new(&bodies, general(&bodies, definition), velocity);
    let energy = strip.energy();
    let dt = 0.5 * strip.procedure.stable().increment();
    let nodes = 0..bodies.structure.mesh.points.len() as u32;
    let start = |n: u32| bodies.structure.mesh.points[n as usize];
    let inner =
        |sign: f64| nodes.clone().filter(move |&n| (start(n)[1] - sign * 0.3).abs() < 1e-9 && start(n)[0] > 1.0);
    let (upper, lower): (Vec<u32>, Vec<u32>) = (inner(1.0).collect(), inner(-1.0).collect());
    let (mut first, mut least, mut most) = (None, f64::INFINITY, 0);
    for increment in 0..2500 {
        strip.advance(dt);
        let height = |n: &u32| strip.x(&bodies, *n).y;
        let open =
            upper.iter().map(height).fold(f64::INFINITY, f64::min) - lower.iter().map(height).fold(f64::MIN, f64::max);
        least = least.min(open);
        let closed = strip.contacts[0].count().closed;
        most = most.max(closed);
        if closed > 0 && first.is_none() {
            first = Some((increment, open));
        }
    }
    let (increment, open) = first.expect("they meet");
    // An increment takes them 2 dt together.
    assert!(increment > 100 && open < 0.0 && open > -2.0 * dt, "{increment} {open} {dt}");
    // Half a facet deep they would lose each other.
    assert!(least > -0.25 * 0.17 && most >= 4, "{least} {most}");
    let p = strip.momentum(&bodies, 0);
    assert!(p.norm() < 1e-10, "{p}");
    assert!((strip.energy() / energy - 1.0).abs() < 1e-2, "{} {energy}", strip.energy());
    let height = |n: &u32| strip.x(&bodies, *n).y;
    assert!(upper.iter().map(height).sum::<f64>() > lower.iter().map(height).sum::<f64>());
}

/// The law by scale factors over the penalty 0.1 m/Δt² of a node and the area with which it faces the floor; a rigid facet is
/// touched on both sides alike.
#[test]
fn a04_scale_factor_law() {
    let meshes = [cube(1, [0.0, 0.0, 0.01]), cube(1, [1.5, 0.0, -1.01])];
    let bodies =
        Bodies::new(&meshes).on_facet([[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [3.0, 2.0, 0.0], [-1.0, 2.0, 0.0]]);
    let velocity = |_: u32, x: Vec3| Vec3::z() * (-x.z.signum() * 2.0);
    let (d, s, initial) = (0.01, 2.0, 0.5);
    let scaling = Scaling { piece: Part::OfElement(d), scale: s, initial };
    let law = Normal::ScaleFactor { scaling, smallest: 1.0 };
    let mut cubes = Motion::new(&bodies, general(&bodies, bodies.definition(free(law), &[])), velocity);
    let increment = cubes.procedure.stable().stable;
    let (mass, area) = (DENSITY / 8.0, 0.25);
    let k = 0.1 * mass / (increment * increment) / area;
    let dt = 0.2 * increment;
    let mut pieces = std::collections::BTreeSet::new();
    for _ in 0..400 {
        cubes.advance(dt);
        for point in cubes.contacts[0].state().points.iter().filter(|point| point.status == ContactStatus::Closed) {
            let h = -point.opening;
            let m = (h / d).floor();
            let p = initial * k * (d * (s.powf(m) - 1.0) / (s - 1.0) + s.powf(m) * (h - m * d));
            // The foot widens by the strain, some 1e-2: the area follows the shape, the force does not depend on it.
            let force = point.pressure * point.measure.value();
            assert!((force - p * area).abs() < 1e-9 * p * area, "{h}: {force} {}", p * area);
            assert!((point.measure.value() / area - 1.0).abs() < 0.1, "{:?}", point.measure);
            pieces.insert(m as usize);
        }
    }
    assert!(pieces.len() >= 3, "{pieces:?}");
    let [upper, lower] = [0, 1].map(|body| cubes.momentum(&bodies, body));
    assert!(upper.z > 0.0 && (upper.z + lower.z).abs() < 1e-12 * upper.z, "{upper} {lower}");
}

/// What is excluded passes through, untouched.
#[test]
fn excluded_bodies_pass() {
    let bodies = Bodies::new(&[cube(2, [0.0; 3]), cube(2, [0.1, 0.0, 1.05])]);
    let velocity = |node: u32, _: Vec3| Vec3::z() * if bodies.body_of(node) == 0 { 0.0 } else { -1.0 };
    let definition = bodies.definition(free(Normal::Hard), &[[0, 1]]);
    let mut cubes = Motion::new(&bodies, general(&bodies, definition), velocity);
    let dt = 0.8 * cubes.procedure.stable().increment();
    for _ in 0..100 {
        cubes.advance(dt);
        assert_eq!(cubes.contacts[0].count().closed, 0);
    }
    assert!((cubes.momentum(&bodies, 1).z + 1.0).abs() < 1e-12 && cubes.momentum(&bodies, 0).norm() < 1e-12);
}

/// Two cubes that meet askew, on so many threads, with the faces in this order or the other way round.
fn askew(threads: usize, backwards: bool) -> Vec<f64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let turned = |[x, y, z]: [f64; 3]| [x + 0.1 * z, y - 0.2 * z, z + 0.15 * x + 0.1 * y];
        let upper = Block::hex8([6, 6, 6]).origin([0.3, 0.2, 1.0]).mapped(turned);
        let bodies = Bodies::new(&[cube(7, [0.0; 3]), upper]);
        let velocity = |node: u32, _: Vec3| Vec3::z() * if bodies.body_of(node) == 0 { 0.5 } else { -0.5 };
        let friction =
            Some(Coulomb { limit: Some((Coefficient::Constant(0.3), None)), spring: Spring::Stiffness(1.0) });
        let mut definition = bodies.definition(Behaviour { friction, ..free(Normal::Hard) }, &[]);
        if backwards {
            definition.faces.reverse();
        }
        let mut cubes = Motion::new(&bodies, general(&bodies, definition), velocity);
        let dt = 0.7 * cubes.procedure.stable().increment();
        let mut most = 0;
        for _ in 0..150 {
            cubes.advance(dt);
            most = most.max(cubes.contacts[0].count().closed);
        }
        assert!(most > 40, "{most}");
        cubes.state.u
    })
}

#[test]
fn threads_do_not_matter() {
    assert!(askew(1, false) == askew(2, false));
}

#[test]
fn the_order_of_faces_does_not_matter() {
    let (one, other) = (askew(1, false), askew(1, true));
    // Rounding of sums in another order.
    let size = one.iter().fold(0.0f64, |a, b| a.max(b.abs()));
    let most = one.iter().zip(&other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(most < 1e-9 * size, "{most} {size}");
}

/// Overlapping cubes, and one that stands in a facet, are moved apart before anything is strained: by halves, and all of it.
#[test]
fn overclosures_of_the_start_are_adjusted() {
    let meshes = [cube(2, [0.0, 0.0, -0.02]), cube(2, [0.0, 0.0, 0.92])];
    let corners = [[-1.0, -1.0, 0.0], [2.0, -1.0, 0.0], [2.0, 2.0, 0.0], [-1.0, 2.0, 0.0]];
    let mut bodies = Bodies::new(&meshes).on_facet(corners);
    let definition = bodies.definition(free(Normal::Hard), &[]);
    let references: Vec<u32> = bodies.rigid.iter().map(|body| body.reference).collect();
    let freedoms = bodies.structure.freedoms(&references);
    let rigid = bodies.rigid.clone();
    let adjusted = adjust(&mut bodies.structure, &freedoms, &definition, &rigid).unwrap();
    assert!((adjusted.deepest[0] - 0.06).abs() < 1e-12 && adjusted.deepest[1] < 1e-6, "{adjusted:?}");
    assert!(adjusted.nodes == 27 && (adjusted.farthest - 0.03).abs() < 1e-6, "{adjusted:?}");
    let z = |node: u32| bodies.structure.mesh.points[node as usize][2];
    // The foot on the facet; the faces that overlapped in their middle.
    assert!(
        z(0).abs() < 1e-6 && (z(18) - 0.95).abs() < 1e-6 && (z(27) - 0.95).abs() < 1e-6,
        "{} {} {}",
        z(0),
        z(18),
        z(27)
    );
    let motion = Motion::new(&bodies, general(&bodies, definition), |_, _| Vec3::zeros());
    assert!(motion.state.force.iter().all(|force| force.abs() < 1e-3), "at rest");
}
