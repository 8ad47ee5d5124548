//! D09: secondary nodes exactly above edges and vertices of the main cube, and as near to them as numbers go.

use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::{Place, Scene};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;

/// Gap at the start, overclosure at the end [L].
const GAP: f64 = 1e-3;
const OVERCLOSURE: f64 = 0.01;
/// Slope of the law [F/L³].
const SLOPE: f64 = 1000.0;
/// Area that the node stands for [L²].
const AREA: f64 = 0.25;
/// Edge of the secondary body [L].
const SIZE: f64 = 0.125;

/// How the secondary side is given.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    /// A set of one node with its area.
    Node,
    /// The lower face of a small brick, a corner at the place, each of its nodes against the main surface.
    Corners,
    /// The lower face of a small brick, its middle at the place, averaged.
    Face,
}

/// Places on the top of the cube [−1, 0]³, of 2 × 2 × 2 elements; the vertices of its facets lie at −1, −½, 0.
const PLACES: [(&str, [f64; 2]); 5] = [
    ("an inner edge", [-0.5, -0.3]),
    ("an inner vertex", [-0.5, -0.5]),
    ("a facet's middle", [-0.25, -0.75]),
    ("the rim", [0.0, -0.3]),
    ("the cube's vertex", [0.0, 0.0]),
];

/// Scenes of D09.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (side, words) in [(Side::Node, "node"), (Side::Corners, "brick's corner"), (Side::Face, "brick's face")] {
        for (what, at) in PLACES {
            // A face over the rim overlaps in part only: its answer is another one.
            if side != Side::Face || at[0] < 0.0 {
                scenes.push(Scene::new(format!("{words} above {what}, ± 0, 1e-16, 1e-12"), move |place| {
                    above(place, side, at)
                }));
            }
        }
    }
    scenes
}

/// Every distance, and main elements in three orders; the main surface is the top alone, or the whole skin.
fn above(place: &Place, side: Side, at: [f64; 2]) -> Finding {
    let mut runs: Vec<([f64; 2], Order)> = offsets().into_iter().map(|offset| (offset, Order::AsMade)).collect();
    runs.extend([Order::Backwards, Order::Strided(9973)].map(|order| ([0.0; 2], order)));
    let mut all: Option<Finding> = None;
    for (k, ([dx, dy], order)) in runs.into_iter().enumerate() {
        for main in ["CUBE_ZMAX", "CUBE_SKIN"] {
            let deck = deck(side, [at[0] + dx, at[1] + dy], (order, main));
            let run = place.run(&format!("{}_{k}", main.to_lowercase()), &deck);
            let found = Finding::converged(&run).measured(&run, |solved| {
                let force = solved.pairs.iter().map(|pair| pair.secondary.force[2]).sum::<f64>();
                vec![(from_value(expected(side), &[force]), 1e-10)]
            });
            all = Some(match all {
                Some(before) => before.and(found),
                None => found,
            });
        }
    }
    all.unwrap_or_default()
}

/// 0 and ± 1e-16, ± 1e-12 along x, and along x and y.
fn offsets() -> Vec<[f64; 2]> {
    let mut offsets = vec![[0.0, 0.0]];
    for d in [1e-16, -1e-16, 1e-12, -1e-12] {
        offsets.extend([[d, 0.0], [d, d]]);
    }
    offsets
}

/// Force [F] anywhere on the surface: a node's area, or that of the brick's face.
fn expected(side: Side) -> f64 {
    SLOPE * OVERCLOSURE * if side == Side::Node { AREA } else { SIZE * SIZE }
}

/// A small brick above the cube; all nodes are held, so that the force is that of the law alone.
fn deck(side: Side, at: [f64; 2], (order, main): (Order, &str)) -> String {
    let half = 0.5 * SIZE;
    // The corner at the place is the one that leaves the brick above the cube.
    let low = if side == Side::Face { at.map(|x| x - half) } else { at.map(|x| x - SIZE) };
    let mut mesh = Block::hex8([2, 2, 2]).origin([-1.0, -1.0, -1.0]).mesh().prefixed("CUBE_");
    let brick = |[x, y, z]: [f64; 3]| {
        let edge = |low: f64, end: f64, t: f64| if t == 1.0 { end } else { low };
        let end = if side == Side::Face { at.map(|x| x + half) } else { at };
        [edge(low[0], end[0], x), edge(low[1], end[1], y), GAP + SIZE * z]
    };
    mesh.append(&Block::hex8([1, 1, 1]).mapped(brick).prefixed("BRICK_"));
    let skin = ["XMIN", "XMAX", "YMIN", "YMAX", "ZMIN", "ZMAX"];
    let skin = skin.iter().flat_map(|side| mesh.surfaces[&format!("CUBE_{side}")].clone()).collect();
    mesh.surfaces.insert("CUBE_SKIN".into(), skin);
    let sets = ["CUBE_BLOCK", "BRICK_BLOCK"];
    let (secondary, kind) = match side {
        Side::Node => (format!("*SURFACE, NAME=SECONDARY, TYPE=NODE\n{}, {AREA}\n", corner(&mesh)), "NODE TO SURFACE"),
        Side::Corners => ("*SURFACE, NAME=SECONDARY\nBRICK_BLOCK, S1\n".into(), "NODE TO SURFACE"),
        Side::Face => ("*SURFACE, NAME=SECONDARY\nBRICK_BLOCK, S1\n".into(), "SURFACE TO SURFACE"),
    };
    format!(
        "{}{}{secondary}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{SLOPE}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nSECONDARY, {main}\n*BOUNDARY\nCUBE_BLOCK, 1, 3\nBRICK_BLOCK, 1, 2\n\
         *STEP\n*STATIC\n1., 1.\n*BOUNDARY\nBRICK_BLOCK, 3, 3, {:e}\n*END STEP\n",
        deck::cards(&mesh, &sets.map(|set| (set, ElementType::C3D8)), order),
        deck::elastic(&sets, 1000.0, 0.3),
        -(GAP + OVERCLOSURE),
    )
}

/// Label of the brick's corner at the place: the lower one with the greatest x and y.
fn corner(mesh: &Mesh) -> u64 {
    let far = |&&n: &&u32| {
        let [x, y, _] = mesh.points[n as usize];
        mesh.node_sets["BRICK_BLOCK"]
            .iter()
            .all(|&m| mesh.points[m as usize][0] <= x && mesh.points[m as usize][1] <= y)
    };
    mesh.node_sets["BRICK_ZMIN"].iter().find(far).map_or(0, |&n| mesh.point_labels[n as usize])
}
