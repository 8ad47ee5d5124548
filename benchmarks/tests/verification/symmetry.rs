//! Half of a symmetric scene answers as the whole.

use crate::bodies::block;
use crate::deck::{Solution, exact_step, material_of, run_sets};
use fe_core::element::ElementType::{self, C3D8, CPE4};
use fe_mesh::Mesh;

/// Depth of the bodies and half their width [L].
const SIZE: f64 = 4.0;

/// How far the upper body is pressed down [L].
const WAY: f64 = 0.15;

/// A body with a round bottom, divided `above` times over half its width, on a stiffer flat one, divided `below` times; the
/// half x > 0 or the whole.
fn scene(element: ElementType, [above, below]: [usize; 2], whole: bool, friction: &str, kind: &str) -> Solution {
    let body = |prefix: &str, cells: usize, upper: bool| {
        let wide = if whole { 2 * cells } else { cells };
        let divisions = if element == C3D8 { [wide, 2, cells] } else { [wide, cells, 1] };
        let mesh = block(element, divisions).mapped(|[s, t, r]| {
            let x = SIZE * if whole { 2.0 * s - 1.0 } else { s };
            let (y, part) = if element == C3D8 { (2.0 * t, r) } else { (0.0, t) };
            let bottom = x * x / 50.0;
            let up = if upper { bottom + part * (SIZE - bottom) } else { SIZE * (part - 1.0) };
            if element == C3D8 { [x, y, up] } else { [x, up, 0.0] }
        });
        mesh.prefixed(prefix)
    };
    let mut mesh = body("UP_", above, true);
    mesh.append(&body("LOW_", below, false));
    let (side, axis) = if element == C3D8 { ("Z", 3) } else { ("Y", 2) };
    let level = if element == C3D8 { "UP_YMIN, 2, 2\nUP_YMAX, 2, 2\nLOW_YMIN, 2, 2\nLOW_YMAX, 2, 2\n" } else { "" };
    let plane = if whole { "" } else { "UP_XMIN, 1, 1\nLOW_XMIN, 1, 1\n" };
    let held = format!(
        "*BOUNDARY\nLOW_{side}MIN, 1, {axis}\nUP_{side}MAX, 1, 1\nUP_{side}MAX, {axis}, {axis}, -{WAY}\n{level}{plane}"
    );
    let cards = format!(
        "{}{}*SURFACE INTERACTION, NAME=RUB\n*SURFACE BEHAVIOR, DIRECT\n{friction}\
         *CONTACT PAIR, INTERACTION=RUB, TYPE={kind}, SMALL SLIDING\nUP_{side}MIN, LOW_{side}MAX\n{}",
        material_of("UP_BLOCK", 1000.0, 0.4),
        material_of("LOW_BLOCK", 5000.0, 0.2),
        exact_step(&held),
    );
    run_sets("symmetry", vec![("UP_BLOCK", element), ("LOW_BLOCK", element)], mesh, &cards)
}

/// Points of a mesh with x > 0 or 0, by place: round-off of coordinates aside.
fn points(mesh: &Mesh) -> Vec<(usize, [i64; 3])> {
    let place = |x: [f64; 3]| x.map(|c| (c * 1e9).round() as i64);
    let mut points: Vec<_> = mesh.points.iter().map(|&x| place(x)).enumerate().filter(|(_, x)| x[0] >= 0).collect();
    // Bodies that touch have points at one place: each mesh has the upper ones first.
    points.sort_by_key(|&(point, x)| (x, point));
    points
}

/// The whole scene has a mean of the slip around each node on the plane that is 0 by symmetry, whatever its multiplier: half of
/// it leaves that out, and has the same equations. What both are off by is what their iterations leave: 1e-12 of the largest
/// force and pressure, times what a matrix with multipliers on springs a thousand times as stiff as the elements makes of it.
#[test]
fn half_a_scene_sticks_and_slips_as_the_whole() {
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        for friction in ["*FRICTION\n0.1\n", "*FRICTION, LAGRANGE\n0.1\n", "*FRICTION, ROUGH\n"] {
            for (element, divisions) in [(CPE4, [8, 8]), (CPE4, [9, 5]), (CPE4, [5, 9]), (C3D8, [4, 6])] {
                let [whole, half] = [true, false].map(|whole| scene(element, divisions, whole, friction, kind));
                let [all, part] = [&whole, &half].map(|solution| points(&solution.terms.structure.mesh));
                assert_eq!(all.len(), part.len());
                let off = all.iter().zip(&part).map(|(&(a, x), &(b, y))| {
                    assert_eq!(x, y);
                    (0..3).map(|c| (whole.u[a][c] - half.u[b][c]).abs()).fold(0.0, f64::max)
                });
                let off = off.fold(0.0, f64::max) / WAY;
                eprintln!("{kind} {friction:?} {element:?} {divisions:?}: off by {off:.1e}");
                assert!(off < 1e-10, "{kind} {friction:?} {element:?} {divisions:?}: {off:e}");
            }
        }
    }
}
