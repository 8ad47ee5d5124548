//! General contact where it could make energy, or let bodies through.

use super::bodies::{Bodies, Motion, cube, general};
use super::*;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;

/// Cubes that fly together from places an increment apart, so that one of them comes through the other's face in the very
/// increment of a search: all nodes touch at once, whenever they do.
#[test]
fn what_comes_in_the_increment_of_a_search_touches() {
    let speed = 2.0;
    let mut searched = 0;
    for start in 0..24 {
        let far = 1.05 + 0.01 * f64::from(start);
        let bodies = Bodies::new(&[cube(3, [0.0; 3]), cube(3, [0.0, 0.0, far])]);
        let velocity = |node: u32, _: Vec3| Vec3::z() * if bodies.body_of(node) == 0 { 0.0 } else { -speed };
        let mut cubes = Motion::new(&bodies, general(&bodies, bodies.definition(free(Normal::Hard), &[])), velocity);
        let dt = 0.8 * cubes.procedure.stable().increment();
        assert!(speed * dt > 0.01, "no increment is left out: {}", speed * dt);
        let mut before = 0;
        let first = loop {
            cubes.advance(dt);
            let count = cubes.contacts[0].count();
            if count.closed > 0 {
                break count;
            }
            before = count.searches;
        };
        searched += usize::from(first.searches > before);
        assert_eq!(first.closed, 32, "{start}");
    }
    assert!(searched > 0);
}

/// A heap of cubes, each turned a little.
fn heap() -> Vec<Mesh> {
    let one = |i: usize| {
        let at: [f64; 3] = std::array::from_fn(|c| 0.75 * (i >> c & 1) as f64 - [0.7, 0.65, -1.0][c]);
        let turn = 0.04 * (i as f64 - 3.5);
        let (sine, cosine) = turn.sin_cos();
        let turned = move |[x, y, z]: [f64; 3]| {
            [at[0] + cosine * x - sine * z, at[1] + y + 0.05 * x, at[2] + sine * x + cosine * z]
        };
        Block::hex8([2; 3]).size([0.6; 3]).mapped(turned)
    };
    (0..8).map(one).collect()
}

/// Cubes that fall into a box with a pyramid on its floor, onto its apex and its ridges, and onto each other.
fn pyramid() -> Bodies {
    let (b, w, top) = (0.8, 1.4, 3.0);
    let points = [
        [-b, -b, 0.0],
        [b, -b, 0.0],
        [b, b, 0.0],
        [-b, b, 0.0],
        [0.0, 0.0, 0.8],
        [-w, -w, 0.0],
        [w, -w, 0.0],
        [w, w, 0.0],
        [-w, w, 0.0],
        [-w, -w, top],
        [w, -w, top],
        [w, w, top],
        [-w, w, top],
    ];
    let facets: [&[u32]; 12] = [
        &[0, 1, 4],
        &[1, 2, 4],
        &[2, 3, 4],
        &[3, 0, 4],
        &[5, 6, 1, 0],
        &[6, 7, 2, 1],
        &[7, 8, 3, 2],
        &[8, 5, 0, 3],
        &[5, 9, 10, 6],
        &[6, 10, 11, 7],
        &[7, 11, 12, 8],
        &[8, 12, 9, 5],
    ];
    Bodies::new(&heap()).on_sheet(&points, &facets)
}

/// Contact gives no more than it has taken, and little energy is lost or comes from nowhere (both 1 %): nothing is pushed out of
/// what it has not come into. Around ridges of the pyramid nodes and edges come from the front of a facet to its back.
#[test]
fn a_pyramid_makes_no_energy() {
    let bodies = pyramid();
    let velocity = |node: u32, _: Vec3| Vec3::new(0.15, -0.1, -1.0) * (1.0 + 0.05 * (bodies.body_of(node) as f64));
    let mut heap = Motion::new(&bodies, general(&bodies, bodies.definition(free(Normal::Hard), &[])), velocity);
    let energy = heap.energy();
    let (mut time, mut closed) = (0.0, 0);
    while time < 2.0 {
        let dt = 0.9 * heap.procedure.stable().increment();
        heap.advance(dt);
        time += dt;
        let (all, given) = (heap.energy() / energy, -heap.contacts[0].stored() / energy);
        assert!((all - 1.0).abs() < 0.01 && given < 0.01, "{time}: {all} {given}");
        closed = closed.max(heap.contacts[0].count().closed);
    }
    assert!(closed > 20, "{closed}");
}

/// On springs a thousand times as stiff as the elements, with increments that grow by a twentieth each as those of the program do,
/// the balance holds as well (1 %). What contact gives by normals that turn over at corners is less than what the cubes came with;
/// a single touch that is as deep at once as all things may have moved gives many times that.
#[test]
fn stiff_springs_keep_the_balance() {
    let (young, length) = (1000.0, 0.3);
    let bodies = pyramid();
    let law = Arc::new(Linear { slope: 1000.0 * young / length, clearance: 0.0 });
    let behaviour = free(Normal::Softened(law));
    let velocity = |node: u32, _: Vec3| Vec3::new(0.15, -0.1, -1.0) * (1.0 + 0.05 * (bodies.body_of(node) as f64));
    let mut heap = Motion::new(&bodies, general(&bodies, bodies.definition(behaviour, &[])), velocity);
    let energy = heap.energy();
    let (mut time, mut last, mut closed) = (0.0, f64::INFINITY, 0);
    while time < 2.0 {
        let dt = (0.9 * heap.procedure.stable().increment()).min(1.05 * last);
        heap.advance(dt);
        (time, last) = (time + dt, dt);
        let (all, given) = (heap.energy() / energy, -heap.contacts[0].stored() / energy);
        assert!((all - 1.0).abs() < 0.01 && given < 1.0, "{time}: {all} {given}");
        closed = closed.max(heap.contacts[0].count().closed);
    }
    assert!(closed > 2, "{closed}");
}
