//! D16 and D17: scenes far from the origin, and scenes that are turned.

use super::tubes::{self, Pipes};
use crate::hard::Scene;
use crate::hard::ball::{self, Ball};
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, difference, from_value};
use crate::hard::patch::{self, Patch};
use crate::hard::run::{Place, Solved};
use fe_core::element::{ElementType, Space};
use fe_mesh::Mesh;
use fe_mesh::generate::Block;

/// 2²⁰: moves coordinates that are multiples of 2⁻²⁰ without rounding.
const EXACT_SHIFT: f64 = 1_048_576.0;

/// Overlap of the held patches, a multiple of 2⁻²⁰ near 1e-3 [L]: the gap that answers follow from.
const OVERLAP: f64 = 1049.0 / EXACT_SHIFT;

fn dyadic(x: f64) -> f64 {
    (x * EXACT_SHIFT).round() / EXACT_SHIFT
}

/// Scenes of D16.
pub fn offset() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let rounded = 4.0 * f64::EPSILON * 1e6 / OVERLAP;
    for (shift, bound, words) in [(EXACT_SHIFT, 1e-9, "2^20"), (1e6, rounded, "1e6")] {
        for (lower, upper) in [(4, 4), (3, 4)] {
            scenes.push(Scene::new(format!("patch {lower}/{upper}, overlap 1e-3, moved by {words}"), move |place| {
                let patch = Patch { overlap: OVERLAP, ..Patch::plane(lower, upper) };
                moved(place, (shift, bound), &|by| held(&patch, by, shift == EXACT_SHIFT))
            }));
        }
        scenes.push(Scene::new(format!("patch 2/3 in space, overlap 1e-3, moved by {words}"), move |place| {
            let patch = Patch { element: ElementType::C3D8, overlap: OVERLAP, ..Patch::plane(2, 3) };
            moved(place, (shift, bound), &|by| held(&patch, by, shift == EXACT_SHIFT))
        }));
        // The answer of the window follows from its depth, 5e-4 at x = 1.
        let bound = if shift == EXACT_SHIFT { bound } else { 4.0 * f64::EPSILON * 1e6 / 5e-4 };
        scenes.push(Scene::new(format!("window on an arc, moved by {words}"), move |place| {
            moved(place, (shift, bound), &|by| window(by, shift == EXACT_SHIFT))
        }));
    }
    for (element, lower, upper) in [(ElementType::CPE4, 3, 4), (ElementType::C3D10, 2, 2)] {
        let name = format!("patch {lower}/{upper} {}, held by contact alone, moved by 2^20", element.name());
        scenes.push(Scene::new(name, move |place| {
            let patch = Patch { element, ..Patch::plane(lower, upper) };
            moved(place, (EXACT_SHIFT, 1e-9), &|by| patch.pressed(&shifted(&patch, by, true), Order::AsMade))
        }));
    }
    scenes.push(Scene::new("A07 pipe in pipe, moved by 2^20", |place| {
        moved(place, (EXACT_SHIFT, 1e-9), &|by| tubes::pipes(&Pipes { by, ..Pipes::default() }))
    }));
    scenes
}

/// The held patch moved by so much.
fn held(patch: &Patch, by: f64, exact: bool) -> String {
    patch.held(&shifted(patch, by, exact), Order::AsMade)
}

/// Its mesh; `exact`: with coordinates rounded to multiples of 2⁻²⁰ before.
fn shifted(patch: &Patch, by: f64, exact: bool) -> Mesh {
    let mut mesh = patch.mesh();
    let axes = if patch.element.space() == Space::Solid { 3 } else { 2 };
    let rounded = |x: f64| if exact { dyadic(x) } else { x };
    mesh.points.iter_mut().for_each(|p| (0..axes).for_each(|c| p[c] = rounded(p[c]) + by));
    mesh
}

/// The window [0, 2]² of a half plane pressed onto an arc of radius 1000 that it lies on at x = 0: sides and top are
/// held, pushed down by 5e-4, so that about half of the lower side is in contact; `exact`: all coordinates are multiples
/// of 2⁻²⁰.
fn window(by: f64, exact: bool) -> String {
    let n = if exact { 16 } else { 17 };
    let mut mesh = Block::quad4([n, n]).size([2.0, 2.0, 0.0]).mesh();
    mesh.points.iter_mut().for_each(|p| (0..2).for_each(|c| p[c] += by));
    // Height of the arc at x = ±8, a multiple of 2⁻²⁰.
    let low = 1000.0 - (1000.0f64 * 1000.0 - 64.0).sqrt();
    let low = if exact { dyadic(low) } else { low };
    let [left, right, end, centre] = [by - 8.0, by + 8.0, by - low, by - 1000.0];
    let middle = by;
    format!(
        "{}{}*NODE\n999999, {middle:e}, {centre:e}\n*SURFACE, NAME=ARC, TYPE=SEGMENTS\nSTART, {left:e}, {end:e}\n\
         CIRCL, {right:e}, {end:e}, {middle:e}, {centre:e}\n*RIGID BODY, ANALYTICAL SURFACE=ARC, REF NODE=999999\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nYMIN, ARC\n\
         *BOUNDARY\n999999, 1, 2\n999999, 6\nXMIN, 1\nXMAX, 1\nYMAX, 1\n{}",
        deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade),
        deck::elastic(&["BLOCK"], 1000.0, 0.3),
        patch::step(patch::EXACT, "*BOUNDARY\nYMAX, 2, 2, -5e-4\nXMAX, 2, 2, -5e-4\n"),
    )
}

fn moved(place: &Place, (by, bound): (f64, f64), deck: &dyn Fn(f64) -> String) -> Finding {
    let (reference, run) = (place.run("reference", &deck(0.0)), place.run("moved", &deck(by)));
    let found = Finding::converged(&run).and(Finding::converged(&reference));
    let found = found.holds(run.iterations == reference.iterations, "other iterations than at the origin");
    let Some(expected) = reference.solved() else { return found };
    let u = |solved: &Solved| solved.displacements().into_iter().flatten().collect::<Vec<f64>>();
    found.measured(&run, |solved| {
        let pressure = difference(&expected.pressures(), &solved.pressures());
        vec![(difference(&u(&expected), &u(solved)), bound), (pressure, bound)]
    })
}

/// Takes points to where they are.
type Turn = fn([f64; 3]) -> [f64; 3];

/// Turned by 37° about x, then 53° about y, then 71° about z.
fn turn([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [(sx, cx), (sy, cy), (sz, cz)] = [37.0f64, 53.0, 71.0].map(|a| a.to_radians().sin_cos());
    let (y, z) = (cx * y - sx * z, sx * y + cx * z);
    let (x, z) = (cy * x + sy * z, -sy * x + cy * z);
    [cz * x - sz * y, sz * x + cz * y, z]
}

/// Bound of D17 on turned answers.
const TURNED: f64 = 1e-10;

/// Scenes of D17.
pub fn rotation() -> Vec<Scene> {
    let compared = |name: &str, deck: fn(Turn) -> String| Scene::new(name, move |place| turned(place, &deck));
    vec![
        compared("patch 3/2 in space, both ends held, turned", solid_patch),
        Scene::new("A18 unit rule, 2 x 2 faces, turned", |place| {
            let run = place.run("unit_rule", &unit_rule(turn));
            Finding::converged(&run).measured(&run, |solved| {
                let force = solved.pairs[0].secondary.force;
                let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
                let along = difference(&turn([0.0, 0.0, 4.0]), &force);
                vec![(from_value(4.0, &[size]), TURNED), (along, TURNED)]
            })
        }),
        compared("ball, turned", |turn| {
            let mut mesh = ball::mesh();
            ball::lower_skin(&mut mesh, -5.0);
            Ball { turn, ..Ball::default() }.deck(&mesh)
        })
        .slow(),
        compared("patch 3/2 under NO SEPARATION, pushed, then pulled, turned", held_patch),
    ]
}

fn turned(place: &Place, deck: &dyn Fn(Turn) -> String) -> Finding {
    let (reference, run) = (place.run("reference", &deck(|p| p)), place.run("turned", &deck(turn)));
    let found = Finding::converged(&run).and(Finding::converged(&reference)).holds(
        run.iterations == reference.iterations,
        format!("{} iterations instead of {}", run.iterations, reference.iterations),
    );
    let Some(expected) = reference.solved() else { return found };
    let flat = |vectors: Vec<[f64; 3]>| vectors.into_iter().flatten().collect::<Vec<f64>>();
    found.measured(&run, |solved| {
        let u = flat(expected.displacements().into_iter().map(turn).collect());
        let forces = flat(expected.contact_forces().into_iter().map(|(_, force)| turn(force)).collect());
        let now = flat(solved.contact_forces().into_iter().map(|(_, force)| force).collect());
        let pressure = difference(&expected.pressures(), &solved.pressures());
        vec![
            (difference(&u, &flat(solved.displacements())), TURNED),
            (difference(&forces, &now), TURNED),
            (pressure, TURNED),
        ]
    })
}

/// Two blocks of bricks, both ends clamped, the upper one pushed by 0.02.
fn solid_patch(turn: Turn) -> String {
    let patch = Patch { element: ElementType::C3D8, across: [3, 2], ..Patch::default() };
    let mut mesh = patch.mesh();
    mesh.points.iter_mut().for_each(|p| *p = turn(*p));
    format!("{}{}", patch.model(&mesh, Order::AsMade), pushed(&mesh, ("LOW_ZMIN", "UP_ZMAX"), turn([0.0, 0.0, -0.02])))
}

/// The same blocks under NO SEPARATION, pushed by 0.02, then pulled by as much.
fn held_patch(turn: Turn) -> String {
    let behavior = "*SURFACE BEHAVIOR, PENALTY, NO SEPARATION\n".to_owned();
    let patch = Patch { element: ElementType::C3D8, across: [3, 2], behavior, ..Patch::default() };
    let mut mesh = patch.mesh();
    mesh.points.iter_mut().for_each(|p| *p = turn(*p));
    let to = |z: f64| pushed(&mesh, ("LOW_ZMIN", "UP_ZMAX"), turn([0.0, 0.0, z]));
    let pull = to(0.02);
    let second = pull.find("*STEP").map_or("", |at| &pull[at..]);
    format!("{}{}{second}", patch.model(&mesh, Order::AsMade), to(-0.02))
}

/// Law LINEAR 100, overclosure 0.01 everywhere over 2 × 2: both blocks are held as they are, force 4.
fn unit_rule(turn: Turn) -> String {
    let behavior = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.\n".to_owned();
    let patch = Patch { element: ElementType::C3D8, across: [3, 2], behavior, ..Patch::default() };
    let mut mesh = patch.mesh();
    mesh.points.iter_mut().for_each(|p| *p = turn(*p));
    let push = turn([0.0, 0.0, -0.01]);
    format!("{}{}", patch.model(&mesh, Order::AsMade), pushed(&mesh, ("LOW_BLOCK", "UP_BLOCK"), push))
}

/// Supports and step: one node set held, another one pushed.
fn pushed(mesh: &Mesh, (held, pushed): (&str, &str), by: [f64; 3]) -> String {
    let nodes = mesh.node_sets.get(pushed).map_or(&[][..], Vec::as_slice);
    let push: String = nodes.iter().map(|&n| deck::prescribed(mesh.point_labels[n as usize], &by)).collect();
    format!("*BOUNDARY\n{held}, 1, 3\n{}", patch::step(patch::EXACT, &format!("*BOUNDARY\n{push}")))
}
