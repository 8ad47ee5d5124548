//! D19: faces that lie on each other exactly, or but for the last bit.

use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, PRESSURE, Patch, YOUNG};
use crate::hard::run::{Place, Run};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::fmt::Write;

const BOUND: f64 = 1e-10;
/// Residual asked for, of the mean force [-]: with a gap of a bit, 2e-16, the pressure of the penalty, 1e5 of the gap,
/// is uncertain by some 1e-11 of 10, and points that touch may be taken as open by as much for one iteration.
const ROUNDED: f64 = 1e-10;
/// Blocks in the stack.
const BLOCKS: usize = 8;

/// Scenes of D19.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let kinds =
        [(ElementType::CPE4, 4, 4), (ElementType::CPE4, 3, 4), (ElementType::C3D8, 2, 3), (ElementType::C3D10, 2, 2)];
    for (element, lower, upper) in kinds {
        for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
            // Node to surface does not pass a constant pressure between meshes that do not match, and has no
            // constraint on faces with mid-side nodes.
            let passes = lower == upper && element != ElementType::C3D10;
            if kind == "SURFACE TO SURFACE" || passes {
                let name = format!("patch {lower}/{upper} {}, {}, noise 1e-16", element.name(), kind.to_lowercase());
                scenes.push(Scene::new(name, move |place| {
                    let patch = Patch { element, kind, residual: ROUNDED, ..Patch::plane(lower, upper) };
                    let judge = |run: &Run| {
                        Finding::converged(run)
                            .measured(run, |solved| patch.errors_pressed(solved).map(|error| (error, BOUND)).to_vec())
                    };
                    with_noise(place, &patch.mesh(), &|mesh| patch.pressed(mesh, Order::AsMade), &judge)
                }));
            }
        }
    }
    scenes.push(Scene::new("8 blocks stacked, noise 1e-16", |place| {
        with_noise(place, &stack(), &stack_deck, &|run| {
            Finding::converged(run).measured(run, |solved| vec![(from_value(PRESSURE, &solved.pressures()), BOUND)])
        })
    }));
    scenes.push(Scene::new("4 blocks side by side, ν = 0, noise 1e-16", |place| {
        with_noise(place, &row(), &row_deck, &|run| {
            Finding::converged(run).measured(run, |solved| {
                // The faces at the sides carry nothing but round-off of the load; displacements are those of columns.
                let side = solved.pressures().iter().fold(0.0f64, |m, p| m.max(p.abs())) / PRESSURE;
                let mesh = &solved.terms.structure.mesh;
                let top: Vec<f64> = (0..mesh.points.len())
                    .filter(|&n| (mesh.points[n][1] - 1.0).abs() < 1e-9)
                    .filter_map(|n| Some(solved.u[solved.terms.freedoms.index(n, 1)?]))
                    .collect();
                vec![(side, BOUND), (from_value(-PRESSURE / YOUNG, &top), BOUND)]
            })
        })
    }));
    scenes
}

/// Judges the exact mesh and three noisy ones; iterations must be the same.
fn with_noise(place: &Place, mesh: &Mesh, deck: &dyn Fn(&Mesh) -> String, judge: &dyn Fn(&Run) -> Finding) -> Finding {
    let exact = place.run("exact", &deck(mesh));
    let mut found = judge(&exact).holds(exact.cutbacks == 0, "it chatters: an increment was cut back");
    for seed in 1..=3 {
        let mut noisy = mesh.clone();
        noise(&mut noisy, seed);
        let run = place.run(&format!("noise_{seed}"), &deck(&noisy));
        let same = run.iterations == exact.iterations && run.cutbacks == exact.cutbacks;
        let words = format!("with noise {} iterations instead of {}", run.iterations, exact.iterations);
        found = found.and(judge(&run).holds(same, words));
    }
    found
}

/// Adds up to ± 1e-16 to every coordinate, or a bit where that is less than one.
fn noise(mesh: &mut Mesh, seed: u64) {
    let plane = mesh.points.iter().all(|p| p[2] == 0.0);
    let mut state = seed;
    for point in &mut mesh.points {
        for x in point.iter_mut().take(if plane { 2 } else { 3 }) {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let sign = [-1.0, 0.0, 1.0][(state >> 33) as usize % 3];
            let moved = *x + sign * 1e-16;
            *x = if moved != *x || sign == 0.0 {
                moved
            } else if sign > 0.0 {
                x.next_up()
            } else {
                x.next_down()
            };
        }
    }
}

/// Eight blocks on each other, 3 or 4 elements across by turns, one element high.
fn stack() -> Mesh {
    let block = |k: usize| Block::quad4([3 + k % 2, 1]).origin([0.0, k as f64, 0.0]).mesh().prefixed(&format!("B{k}_"));
    (1..BLOCKS).fold(block(0), |mut mesh, k| {
        mesh.append(&block(k));
        mesh
    })
}

fn stack_deck(mesh: &Mesh) -> String {
    let (mut text, mut sides) = (blocks(mesh, 0.3), String::from("*BOUNDARY\nB0_YMIN, 2\n"));
    for k in 0..BLOCKS {
        // Writing to a string does not fail.
        let _ = writeln!(sides, "B{k}_XMIN, 1");
        if k > 0 {
            let _ = writeln!(text, "B{k}_YMIN, B{}_YMAX", k - 1);
        }
    }
    format!("{text}{sides}{}", patch::step(ROUNDED, &format!("*DSLOAD\nB{}_YMAX, P, {PRESSURE}\n", BLOCKS - 1)))
}

/// Four blocks beside each other, 2 or 3 elements high by turns.
fn row() -> Mesh {
    let block = |k: usize| Block::quad4([1, 2 + k % 2]).origin([k as f64, 0.0, 0.0]).mesh().prefixed(&format!("B{k}_"));
    (1..4).fold(block(0), |mut mesh, k| {
        mesh.append(&block(k));
        mesh
    })
}

fn row_deck(mesh: &Mesh) -> String {
    let (mut text, mut supports, mut load) =
        (blocks(mesh, 0.0), String::from("*BOUNDARY\n"), String::from("*DSLOAD\n"));
    for k in 0..4 {
        // Writing to a string does not fail.
        let _ = writeln!(supports, "B{k}_YMIN, 1, 2");
        let _ = writeln!(load, "B{k}_YMAX, P, {PRESSURE}");
        if k > 0 {
            let _ = writeln!(text, "B{k}_XMIN, B{}_XMAX", k - 1);
        }
    }
    format!("{text}{supports}{}", patch::step(ROUNDED, &load))
}

/// Mesh, material and the head of the pairs.
fn blocks(mesh: &Mesh, poisson: f64) -> String {
    let sets: Vec<&str> = mesh.cell_sets.keys().map(String::as_str).collect();
    let elements: Vec<(&str, ElementType)> = sets.iter().map(|set| (*set, ElementType::CPE4)).collect();
    format!(
        "{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n",
        deck::cards(mesh, &elements, Order::AsMade),
        deck::elastic(&sets, YOUNG, poisson),
    )
}
