//! D07: surfaces that lie in each other at the start.

use crate::hard::Scene;
use crate::hard::deck::Order;
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{Patch, YOUNG};
use fe_mesh::Mesh;

/// The patch 4/4 with an overlap.
fn overlapping(overlap: f64) -> Patch {
    Patch { overlap, ..Patch::plane(4, 4) }
}

/// Elements are half a unit wide and high.
const ELEMENT: f64 = 0.5;

/// Scenes of D07.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for overlap in [1e-14, 1e-9] {
        scenes.push(tiny(overlap));
        scenes.push(tiny_under_load(overlap));
    }
    scenes.push(resolved(1e-3, false));
    scenes.push(resolved(0.5 * ELEMENT, true));
    scenes.push(too_deep("SURFACE TO SURFACE"));
    scenes.push(too_deep("NODE TO SURFACE"));
    scenes.push(ever_deeper());
    scenes.push(one_node("NODE TO SURFACE"));
    scenes.push(one_node("SURFACE TO SURFACE"));
    scenes.push(ramped("1e-3", "UP_YMIN, LOW_YMAX, 1e-3\n"));
    scenes.push(ramped("SHRINK", "UP_YMIN, LOW_YMAX\n"));
    scenes.push(Scene::waits("one node beyond HCRIT=", "HCRIT on CONTACT CONTROLS; now it is half a facet"));
    scenes
}

/// Held at both ends, a tiny overlap presses as tinily: noise below 1e-10 of E, nothing said.
fn tiny(overlap: f64) -> Scene {
    Scene::new(format!("patch 4/4, ends held, overlap {overlap:.0e}"), move |place| {
        let patch = overlapping(overlap);
        let run = place.run("patch", &patch.held(&patch.mesh(), Order::AsMade));
        let found = Finding::converged(&run).measured(&run, |solved| {
            let expected = patch.pressure_held(solved);
            let noise = solved.pressures().iter().fold(0.0, |m: f64, p| m.max((p - expected).abs()));
            vec![(noise / YOUNG, 1e-10)]
        });
        found.holds(!run.told(&["overlap"]), format!("round-off is no overlap: {:?}", run.notes))
    })
}

/// Under load a tiny overlap is as touching; the displacement of the top lacks what the overlap gives way.
fn tiny_under_load(overlap: f64) -> Scene {
    Scene::new(format!("patch 4/4, pressed, overlap {overlap:.0e}"), move |place| {
        let patch = overlapping(overlap);
        let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
        let touching = |e: f64| (e, 1e-10 + overlap / 0.0182);
        Finding::converged(&run).measured(&run, |solved| patch.errors_pressed(solved).map(touching).to_vec())
    })
}

/// Held at both ends, the pressure is that of the strain overlap/height; with a warning where it is large.
fn resolved(overlap: f64, large: bool) -> Scene {
    Scene::new(format!("patch 4/4, ends held, overlap {overlap}"), move |place| {
        let patch = overlapping(overlap);
        let run = place.run("patch", &patch.held(&patch.mesh(), Order::AsMade));
        let kind = if large { "warning: " } else { "" };
        Finding::warned(&run, &[kind, "UP_YMIN", "overlap"])
            .measured(&run, |solved| vec![(from_value(patch.pressure_held(solved), &solved.pressures()), 1e-10)])
    })
}

/// Let be at first, and taken out over ten increments: the force grows evenly to that of the whole overlap.
fn ramped(how: &'static str, line: &'static str) -> Scene {
    Scene::new(format!("patch 4/4, ends held, overlap 0.001 ramped to 0, {how}"), move |place| {
        let patch = overlapping(1e-3);
        let shrink = if how == "SHRINK" { ", SHRINK" } else { "" };
        let card = format!("*CONTACT INTERFERENCE{shrink}\n{line}*END STEP\n");
        let deck = patch.held(&patch.mesh(), Order::AsMade).replace("*STATIC\n1., 1.\n", "*STATIC, DIRECT\n0.1, 1.\n");
        let run = place.run("patch", &deck.replace("*END STEP\n", &card));
        let forces: Vec<f64> = run.certificates.iter().map(|c| c.resultants[0][1]).collect();
        let last = forces.last().copied().unwrap_or(f64::NAN);
        let uneven = |(i, force): (usize, &f64)| (force / last - 0.1 * (i + 1) as f64).abs();
        let worst = forces.iter().enumerate().map(uneven).fold(0.0, f64::max);
        Finding::converged(&run)
            .holds(forces.len() == 10, format!("{} increments", forces.len()))
            .within(worst, 1e-10)
            .measured(&run, |solved| vec![(from_value(patch.pressure_held(solved), &solved.pressures()), 1e-10)])
    })
}

/// One and a half elements deep: which side is meant cannot be told.
fn too_deep(kind: &'static str) -> Scene {
    Scene::new(format!("patch 4/4, 1.5 elements deep, {}", kind.to_lowercase()), move |place| {
        let patch = Patch { kind, ..overlapping(1.5 * ELEMENT) };
        let run = place.run("patch", &patch.held(&patch.mesh(), Order::AsMade));
        Finding::refused(&run, &["node ", "7.5", "UP_YMIN", "LOW_YMAX"])
    })
}

/// Past the believed half element, through the whole lower block, and out of it below: refused at every depth.
fn ever_deeper() -> Scene {
    Scene::new("patch 4/4, 0.26 to 2.5 deep, both kinds", |place| {
        let depths = [0.26, 0.5, 0.999, 1.0, 1.001, 1.5, 2.0, 2.5];
        let kinds = ["SURFACE TO SURFACE", "NODE TO SURFACE"];
        let each = depths.iter().enumerate().flat_map(|(i, &depth)| kinds.map(|kind| (i, depth, kind)));
        let judged = each.map(|(i, depth, kind)| {
            let patch = Patch { kind, ..overlapping(depth) };
            let name = format!("{}_{i}", kind.split(' ').next().unwrap_or_default().to_lowercase());
            let run = place.run(&name, &patch.held(&patch.mesh(), Order::AsMade));
            Finding::refused(&run, &["node ", "UP_YMIN", "LOW_YMAX", "deep"])
        });
        judged.reduce(Finding::and).unwrap_or_default()
    })
}

/// The inner node of the secondary surface that is moved down, and its label.
fn moved_node(mesh: &mut Mesh, depth: f64) -> u64 {
    let side = &mesh.node_sets["UP_YMIN"];
    let node = side.iter().copied().find(|&n| mesh.points[n as usize][0] == 1.0);
    let node = node.unwrap_or(side[0]) as usize;
    mesh.points[node][1] -= depth;
    mesh.point_labels[node]
}

/// A single node 0.3 deep, more than half a facet: refused by its name. Along the normal of its facets, tilted by
/// atan(0.3/0.5), it is √(1 + 0.36) as deep.
fn one_node(kind: &'static str) -> Scene {
    Scene::new(format!("patch 4/4, one node 0.3 deep, {}", kind.to_lowercase()), move |place| {
        let patch = Patch { kind, ..overlapping(0.0) };
        let mut mesh = patch.mesh();
        let label = format!("node {label} ", label = moved_node(&mut mesh, 0.3));
        let run = place.run("patch", &patch.held(&mesh, Order::AsMade));
        let depth = if kind == "NODE TO SURFACE" { "3.000000e-1" } else { "3.498571e-1" };
        Finding::refused(&run, &[&label, depth, "LOW_YMAX"])
    })
}
