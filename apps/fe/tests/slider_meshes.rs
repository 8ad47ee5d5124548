//! A01: the slider as a cube of any solid element, hard on a rigid plane or on a plate that is all but rigid.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{ALGEBRAIC, Job, relative};
use common::slider::{DISTANCE, K};
use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use fe_mesh::gmsh;

/// The cube [0, 1]³ held above, and the stop below it.
fn run(element: ElementType, rigid: bool, kind: &str) -> Job {
    let cube = match element {
        ElementType::C3D4 => Block::tet4([2; 3]),
        ElementType::C3D10 => Block::tet10([1; 3]),
        _ => Block::hex8([2; 3]),
    };
    let mut mesh = cube.mesh().prefixed("CUBE_");
    mesh.append(
        &Block::hex8([1; 3]).size([3.0, 3.0, 1.0]).origin([-1.0, -1.0, -1.0 - DISTANCE]).mesh().prefixed("PLATE_"),
    );
    let stop = format!(
        "*SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., -{DISTANCE}, 1., 0., -{DISTANCE}\n0., 1., -{DISTANCE}\nSTART, -1., 0.\n\
         LINE, 2., 0.\n*NODE, NSET=REF\n999, 0., 0., -5.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=999\n*BOUNDARY\n\
         REF, 1, 6\n"
    );
    let (stop, main) = if rigid { (stop.as_str(), "FLOOR") } else { ("", "PLATE_ZMAX") };
    let name = element.name();
    let deck = format!(
        "*MESH, INPUT=blocks.msh\nCUBE_BLOCK, {name}\nPLATE_BLOCK, C3D8\n*MATERIAL, NAME=SOFT\n*ELASTIC\n{K}, 0.\n\
         *MATERIAL, NAME=STIFF\n*ELASTIC\n{}, 0.\n*SOLID SECTION, ELSET=CUBE_BLOCK, MATERIAL=SOFT\n\
         *SOLID SECTION, ELSET=PLATE_BLOCK, MATERIAL=STIFF\n{stop}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, DIRECT\n\
         *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nCUBE_ZMIN, {main}\n*BOUNDARY\nCUBE_ZMAX, 1, 3\nPLATE_ZMIN, 1, 3\n\
         *STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*DSLOAD\nCUBE_ZMIN, P, -500.\n*END STEP\n",
        1e12 * K
    );
    let scratch = Scratch::new("slider_meshes");
    std::fs::write(scratch.path("blocks.msh"), gmsh::write(&mesh, gmsh::Encoding::Binary)).unwrap();
    Job::run_in(scratch, &deck)
}

/// N = 400 and x = 0.1, on faces with middle nodes, too.
#[test]
fn a01_hard_slider_of_any_solid() {
    for element in [ElementType::C3D4, ElementType::C3D8, ElementType::C3D10] {
        // Faces with middle nodes have no contact at nodes.
        let kinds = if element == ElementType::C3D10 {
            &["SURFACE TO SURFACE"][..]
        } else {
            &["SURFACE TO SURFACE", "NODE TO SURFACE"]
        };
        for (rigid, kind) in kinds.iter().flat_map(|kind| [(true, *kind), (false, *kind)]) {
            let what = format!("{} {rigid} {kind}", element.name());
            let results = run(element, rigid, kind).results();
            let last = results.times().len() - 1;
            let near = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0]]
                .map(|place| results.point_field("U", 3, last)[3 * results.point_at(place) + 2]);
            relative(&what, near, [-DISTANCE; 2], ALGEBRAIC);
            let forces = results.point_field("CNORMF", 3, last);
            // The cube's points come first; what acts on the plate is the reverse.
            let force: f64 = forces.chunks_exact(3).map(|f| f[2]).filter(|f| *f > 0.0).sum();
            relative(&what, [force], [500.0 - K * DISTANCE], ALGEBRAIC);
        }
    }
}
