//! The exact window of Hertz's point contact as a deck: E = 1000, ν = 0.3, a = 1, around the axis on [0, 2]² or in space
//! on [0, 2]³, with exact displacements on the outer sides and a rigid ball of radius 1e5 for the paraboloid. Between
//! the tilt of its normals and cancellation in the gap 1e-5 of the answer stays open.

use crate::exact::point_window::PointWindow;
use fe_core::element::{ElementType, Space};
use fe_core::material::Elastic;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Material of the window.
pub const ELASTIC: Elastic = Elastic { young: 1000.0, poisson: 0.3 };
const RADIUS: f64 = 1e5;

/// A window at a refinement.
pub struct PointScene {
    /// The mesh: set `BLOCK`.
    pub mesh: Mesh,
    /// Cards of the model but for the mesh, with supports.
    pub model: String,
    /// Cards of the step: displacements on the outer sides.
    pub load: String,
}

/// The exact field.
pub fn point() -> PointWindow {
    PointWindow::under_paraboloid(ELASTIC, RADIUS)
}

/// Elements of edge 1/n; `behavior` is the interaction's card, `kind` the type of the pair.
pub fn point_scene(element: ElementType, n: usize, behavior: &str, kind: &str) -> PointScene {
    let around = element.space() == Space::Axisymmetric;
    let block = match element {
        ElementType::CAX3 => Block::tri3([2 * n; 2]),
        ElementType::CAX4 => Block::quad4([2 * n; 2]),
        ElementType::C3D4 => Block::tet4([2 * n; 3]),
        ElementType::C3D10 => Block::tet10([2 * n; 3]),
        _ => Block::hex8([2 * n; 3]),
    };
    let mesh = block.size([2.0; 3]).mesh();
    let load = outside(&mesh, around);
    let reference = mesh.points.len() + 1;
    // The arc to r = 3, its top in the origin.
    let end = -9.0 / (RADIUS + (RADIUS * RADIUS - 9.0).sqrt());
    let (frame, start, side, supports) = if around {
        ("SEGMENTS", format!("-3., {end:e}"), "YMIN", "XMIN, 1, 1\n")
    } else {
        ("REVOLUTION\n0., 0., 0., 0., 0., 1.", "0., 0.".into(), "ZMIN", "XMIN, 1, 1\nYMIN, 2, 2\n")
    };
    let model = format!(
        "*NODE\n{reference}, 0., 0., -1.\n*MATERIAL, NAME=M\n*ELASTIC\n{young:e}, {poisson:e}\n\
         *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n\
         *SURFACE, NAME=FLOOR, TYPE={frame}\nSTART, {start}\nCIRCL, 3., {end:e}, 0., -{RADIUS:e}\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE={reference}\n*SURFACE INTERACTION, NAME=HARD\n{behavior}\
         *CONTACT PAIR, INTERACTION=HARD, TYPE={kind}, SMALL SLIDING\n{side}, FLOOR\n\
         *BOUNDARY\n{reference}, 1, 6\n{supports}",
        young = ELASTIC.young,
        poisson = ELASTIC.poisson,
    );
    PointScene { mesh, model, load }
}

/// `*BOUNDARY` of the outer sides: the field against the top of the ball, where that lies at first.
fn outside(mesh: &Mesh, around: bool) -> String {
    let window = point();
    let sides = if around { &["XMAX", "YMAX"][..] } else { &["XMAX", "YMAX", "ZMAX"] };
    let nodes: BTreeSet<u32> = sides.iter().flat_map(|side| mesh.node_sets[*side].iter().copied()).collect();
    let mut cards = String::from("*BOUNDARY\n");
    for node in nodes {
        let ([x, y, z], label) = (mesh.points[node as usize], mesh.point_labels[node as usize]);
        let (r, depth) = if around { (x, y) } else { (x.hypot(y), z) };
        let [outward, up] = window.at(r, depth);
        let part = |x: f64| if r > 0.0 { outward * x / r } else { 0.0 };
        let up = up - window.approach;
        let u = if around { vec![outward, up] } else { vec![part(x), part(y), up] };
        for (component, u) in (1..).zip(u) {
            // Writing to a string does not fail.
            let _ = writeln!(cards, "{label}, {component}, {component}, {u:e}");
        }
    }
    cards
}
