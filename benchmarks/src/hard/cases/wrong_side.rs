//! D36: which side of a body is meant.

use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, PRESSURE, Patch, YOUNG};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;

/// Thickness of the plate over the height of the bodies, 1 [-].
const THICKNESS: f64 = 0.01;

/// Scenes of D36.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        let words = kind.to_lowercase();
        scenes.push(Scene::new(format!("plate between two bodies, its skin one surface, {words}"), move |place| {
            let run = place.run("plate", &plate(kind, 0.0));
            Finding::converged(&run).measured(&run, |solved| vec![(from_value(PRESSURE, &solved.pressures()), 1e-10)])
        }));
        // 0.4 of the plate's thickness deep: nearer to the side that it came in by than to the other one.
        scenes.push(Scene::new(format!("body begins 0.4 of the plate inside it, {words}"), move |place| {
            let run = place.run("plate", &plate(kind, 0.4 * THICKNESS));
            Finding::warned(&run, &["begin inside", "UP_YMIN", "SKIN"])
                .measured(&run, |solved| vec![(from_value(PRESSURE, &solved.pressures()), 1e-10)])
        }));
    }
    scenes.push(Scene::new("a node already behind the main face, half a facet deep at most", |place| {
        let patch = Patch { kind: "NODE TO SURFACE", ..Patch::plane(4, 4) };
        let mut mesh = patch.mesh();
        let label = lower_one(&mut mesh, 0.1);
        let run = place.run("behind", &patch.held(&mesh, Order::AsMade));
        Finding::warned(&run, &["begin inside", "LOW_YMAX", &format!("node {label}")]).measured(&run, |solved| {
            let behind = solved.pairs[0].points.iter().map(|p| p.pressure).fold(0.0, f64::max);
            // It is pressed out upward, through the face that it came in by.
            let up = solved.displacement(label).map_or(f64::NAN, |u| u[1]);
            vec![(if behind > 0.0 && up > 0.0 { 0.0 } else { 1.0 }, 0.0)]
        })
    }));
    for kind in ["SURFACE TO SURFACE", "NODE TO SURFACE"] {
        scenes.push(Scene::new(
            format!("rigid profile drawn the wrong way round, {}", kind.to_lowercase()),
            move |place| {
                let run = place.run("flat", &on_flat(kind, ["-3", "3"]));
                let right = place.run("right", &on_flat(kind, ["3", "-3"]));
                Finding::converged(&right)
                    .measured(&right, |solved| vec![(from_value(0.01 * YOUNG / 0.91, &solved.pressures()), 1e-10)])
                    .and(Finding::warned(&run, &["BLOCK_TOP", "FLAT", "no part"]))
            },
        ));
    }
    scenes
}

/// The inner node of the secondary surface moved down [L]; its label.
fn lower_one(mesh: &mut Mesh, depth: f64) -> u64 {
    let side = &mesh.node_sets["UP_YMIN"];
    let node = side.iter().copied().find(|&n| mesh.points[n as usize][0] == 1.0).unwrap_or(side[0]) as usize;
    mesh.points[node][1] -= depth;
    mesh.point_labels[node]
}

/// A plate of thickness [`THICKNESS`] between two blocks, both its sides one surface, the main one of both pairs; the upper
/// block begins so far inside it [L]. Pressed by [`PRESSURE`].
fn plate(kind: &str, inside: f64) -> String {
    let block = |divisions: [usize; 2], height: f64, y: f64| {
        Block::quad4(divisions).size([2.0, height, 0.0]).origin([0.0, y, 0.0]).mesh()
    };
    let mut mesh = block([4, 2], 1.0, 0.0).prefixed("LOW_");
    mesh.append(&block([4, 1], THICKNESS, 1.0).prefixed("PLATE_"));
    mesh.append(&block([4, 2], 1.0, 1.0 + THICKNESS - inside).prefixed("UP_"));
    let both = ["PLATE_YMIN", "PLATE_YMAX"].iter().flat_map(|side| mesh.surfaces[*side].clone()).collect();
    mesh.surfaces.insert("SKIN".into(), both);
    let sets = ["LOW_BLOCK", "PLATE_BLOCK", "UP_BLOCK"];
    let load = format!("*DSLOAD\nUP_YMAX, P, {PRESSURE}\n");
    format!(
        "{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\n\
         UP_YMIN, SKIN\nLOW_YMAX, SKIN\n*BOUNDARY\nLOW_YMIN, 2\nLOW_XMIN, 1\nPLATE_XMIN, 1\nUP_XMIN, 1\n{}",
        deck::cards(&mesh, &sets.map(|set| (set, ElementType::CPE4)), Order::AsMade),
        deck::elastic(&sets, YOUNG, 0.3),
        patch::step(patch::EXACT, &load),
    )
}

/// A block whose lower side is held touches a rigid flat above it, which comes down by a hundredth of its height. The
/// flat's normal points to the left of the way from its start to its end.
fn on_flat(kind: &str, [start, end]: [&str; 2]) -> String {
    let mut mesh = Block::quad4([3, 2]).size([2.0, 1.0, 0.0]).mesh();
    mesh.surfaces = [("BLOCK_TOP".to_string(), mesh.surfaces["YMAX"].clone())].into();
    let reference = mesh.points.len() + 1;
    format!(
        "{}{}*NODE\n{reference}, 0., 2.\n*SURFACE, NAME=FLAT, TYPE=SEGMENTS\nSTART, {start}., 1.\nLINE, {end}., 1.\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE={reference}\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, DIRECT\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nBLOCK_TOP, FLAT\n\
         *BOUNDARY\nYMIN, 2\nXMIN, 1\n{reference}, 1\n{reference}, 6\n{}",
        deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade),
        deck::elastic(&["BLOCK"], YOUNG, 0.3),
        patch::step(patch::EXACT, &format!("*BOUNDARY\n{reference}, 2, 2, -0.01\n")),
    )
}
