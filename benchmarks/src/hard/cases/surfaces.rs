//! D13 and D37: forces and pressures on faces with nodes in the middle of their edges.

use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, difference};
use crate::hard::patch::{self, Patch};
use crate::hard::run::Solved;
use crate::hard::{Place, Scene};
use crate::norm::nodal_areas;
use crate::windows::{point, point_scene};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use std::collections::BTreeMap;

const BOUND: f64 = 1e-10;
/// Pressure of the scenes of D13 [F/L²]: overclosure times the slope of the law.
const PRESSURE: f64 = 10.0;
const OVERCLOSURE: f64 = 0.01;

/// Scenes of D13.
pub fn face_forces() -> Vec<Scene> {
    let quadratic = "quadratic bricks and quadrilaterals";
    vec![
        Scene::new("uniform pressure on six-node faces", |place| {
            let patch = held_patch(0.0);
            let mesh = patch.mesh();
            let run = place.run("load", &held(&patch, &mesh, &format!("*DSLOAD\nUP_ZMAX, P, {PRESSURE}\n")));
            Finding::converged(&run).measured(&run, |solved| {
                // All nodes are held: reactions are the forces on the nodes, turned round.
                let force = |node: &u32| {
                    let freedom = solved.terms.freedoms.index(*node as usize, 2);
                    freedom.map_or(f64::NAN, |f| solved.forces[f])
                };
                shares(&mesh, "UP_ZMAX", &force)
            })
        }),
        Scene::new("uniform contact on six-node faces, 2/3", |place| {
            let patch = held_patch(OVERCLOSURE);
            let mesh = patch.mesh();
            let run = place.run("contact", &held(&patch, &mesh, ""));
            Finding::converged(&run).measured(&run, |solved| {
                let mut errors = Vec::new();
                for (side, name, sign) in
                    [(&solved.pairs[0].secondary, "UP_ZMIN", 1.0), (&solved.pairs[0].main, "LOW_ZMAX", -1.0)]
                {
                    let forces: BTreeMap<u32, f64> = side.nodes.iter().map(|(n, f)| (*n, sign * f[2])).collect();
                    errors.extend(shares(&mesh, name, &|node| forces.get(node).copied().unwrap_or_default()));
                }
                errors
            })
        }),
        pressed(ElementType::C3D10, [2, 3]),
        pressed(ElementType::C3D10, [3, 2]),
        Scene::waits("eight-node faces: corner −1/12, middle 1/3", quadratic),
        Scene::waits("nine-node faces: corner 1/36, middle 1/9, 4/9", quadratic),
    ]
}

/// The pressure that contact passes on between meshes that do not match is constant.
fn pressed(element: ElementType, across: [usize; 2]) -> Scene {
    let [lower, upper] = across;
    Scene::new(format!("patch {lower}/{upper} {}: constant pressure", element.name()), move |place| {
        let patch = Patch { element, across, ..Patch::default() };
        let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
        Finding::converged(&run).measured(&run, |solved| patch.errors_pressed(solved).map(|e| (e, BOUND)).to_vec())
    })
}

/// Blocks of quadratic tetrahedra under a linear law.
fn held_patch(overlap: f64) -> Patch {
    let behavior = format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{}\n", PRESSURE / OVERCLOSURE);
    Patch { element: ElementType::C3D10, across: [2, 3], overlap, behavior, ..Patch::default() }
}

/// All nodes held.
fn held(patch: &Patch, mesh: &Mesh, load: &str) -> String {
    let model = patch.model(mesh, Order::AsMade);
    format!("{model}*BOUNDARY\nLOW_BLOCK, 1, 3\nUP_BLOCK, 1, 3\n{}", patch::step(patch::EXACT, load))
}

/// Errors of nodal forces on a side under [`PRESSURE`], over the largest: corners bear nothing, nodes in the middle of
/// edges a third of each face's force.
fn shares(mesh: &Mesh, side: &str, force: &dyn Fn(&u32) -> f64) -> Vec<(f64, f64)> {
    let mut expected = BTreeMap::<u32, f64>::new();
    let areas = nodal_areas(mesh, &mesh.surfaces[side], false);
    for &face in &mesh.surfaces[side] {
        let nodes = mesh.face(face).1;
        let corners: Vec<[f64; 3]> = nodes[..3].iter().map(|&n| mesh.points[n as usize]).collect();
        let [a, b] = [1, 2].map(|i| [0, 1].map(|c| corners[i][c] - corners[0][c]));
        let area = 0.5 * (a[0] * b[1] - a[1] * b[0]).abs();
        nodes.iter().enumerate().for_each(|(i, &n)| {
            *expected.entry(n).or_default() += if i < 3 { 0.0 } else { PRESSURE * area / 3.0 };
        });
    }
    let found: Vec<f64> = expected.keys().map(force).collect();
    let whole: f64 = areas.values().sum::<f64>() * PRESSURE;
    let expected: Vec<f64> = expected.into_values().collect();
    let total = (found.iter().sum::<f64>() / whole - 1.0).abs();
    vec![(difference(&expected, &found), BOUND), (total, BOUND)]
}

/// Scenes of D37.
pub fn quadratic_pressure() -> Vec<Scene> {
    let quadratic = "quadratic elements of the plane";
    vec![
        Scene::new("window, octant of C3D10, a/h = 2", |place| smooth(place, 2)),
        Scene::new("window, octant of C3D10, a/h = 4", |place| smooth(place, 4)).slow(),
        Scene::new("window, octant of C3D10, a/h = 8", |place| smooth(place, 8)).slow(),
        Scene::waits("window of CPE6 and CPE8", quadratic),
    ]
}

/// Pressures of the exact window: the error in L2 within that of the first order, 4 · 0.7 h/a (means over the surface, in
/// space). Second differences along lines of corners inside 0.8a below a fifth of the peak, where that is a few elements
/// away from the edge: on the corner next to the edge the means put what its hat loses beyond, a quarter of the peak at
/// a/h = 4 (it falls with the pressure there, √(h/a)), and a part of that with the other sign on the next corner.
fn smooth(place: &Place, n: usize) -> Finding {
    let scene = point_scene(ElementType::C3D10, n, "*SURFACE BEHAVIOR, DIRECT\n", "SURFACE TO SURFACE");
    let mesh = deck::cards(&scene.mesh, &[("BLOCK", ElementType::C3D10)], Order::AsMade);
    let run = place.run("window", &format!("{mesh}{}{}", scene.model, patch::step(patch::EXACT, &scene.load)));
    let found = Finding::converged(&run);
    let Some(solved) = run.solved() else { return found };
    let grid = on_grid(&solved, n);
    let saw = saw_tooth(&grid, n);
    let [inner, edge] = [0.0..=INSIDE, INSIDE..=2.0].map(|range| worst(&grid, n, range));
    let square = |values: &dyn Fn(f64, f64) -> f64| -> f64 {
        let cells = grid.iter().map(|(at, p)| (radius(*at, n), *p));
        cells.map(|(r, p)| values(r, p).powi(2)).sum::<f64>().sqrt()
    };
    let error = square(&|r, p| p - exact(r)) / square(&|r, _| exact(r));
    let found = if (1.0 - INSIDE) * n as f64 > FEW { found.within(saw, 0.2) } else { found };
    found
        .within(error, 4.0 * 0.7 / n as f64)
        .say(format!("L2 {error:.3}, differences {saw:.3}, off by {inner:.3}, {edge:.3} at the edge"))
}

/// Pressures over the peak at corners of the floor, by their places in steps of 1/n.
type OnGrid = BTreeMap<[i64; 2], f64>;

fn on_grid(solved: &Solved, n: usize) -> OnGrid {
    let place = |node: u32| {
        let [x, y, _] = solved.terms.structure.mesh.points[node as usize];
        [x, y].map(|x| (x * n as f64).round() as i64)
    };
    solved.pairs[0].points.iter().map(|p| (place(p.node), p.pressure / point().peak)).collect()
}

fn radius(at: [i64; 2], n: usize) -> f64 {
    (at[0] as f64).hypot(at[1] as f64) / n as f64
}

/// Distance as far as which the pressure must be smooth.
const INSIDE: f64 = 0.8;
/// Elements between there and the edge from which on it must be.
const FEW: f64 = 1.5;

fn exact(r: f64) -> f64 {
    (1.0 - r * r).max(0.0).sqrt()
}

/// Largest error of the pressure over the peak at distances in a range.
fn worst(grid: &OnGrid, n: usize, range: std::ops::RangeInclusive<f64>) -> f64 {
    let within = grid.iter().map(|(at, p)| (radius(*at, n), p)).filter(|(r, _)| range.contains(r));
    within.map(|(r, p)| (p - exact(r)).abs()).fold(0.0, f64::max)
}

/// Largest second difference of the error along x and y of three corners inside: that of the exact pressure itself,
/// which grows towards the edge, is taken off.
fn saw_tooth(grid: &OnGrid, n: usize) -> f64 {
    let error = |at: [i64; 2]| {
        let r = radius(at, n);
        grid.get(&at).filter(|_| r <= INSIDE).map(|p| p - exact(r))
    };
    let along = |at: &[i64; 2], [x, y]: [i64; 2]| {
        let [before, here, after] = [[at[0] - x, at[1] - y], *at, [at[0] + x, at[1] + y]].map(error);
        Some((before? - 2.0 * here? + after?).abs())
    };
    let all = grid.keys().flat_map(|at| [along(at, [1, 0]), along(at, [0, 1])]);
    all.flatten().fold(0.0, f64::max)
}
