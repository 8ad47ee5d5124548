//! Results do not depend on the number of threads, to the last bit.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use fe_mesh::generate::Block;
use fe_mesh::gmsh;

const DECK: &str = "\
*MESH, INPUT=blocks.msh
LOW_BLOCK, C3D10
UP_BLOCK, C3D10
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=LOW_BLOCK, MATERIAL=M
*SOLID SECTION, ELSET=UP_BLOCK, MATERIAL=M
*SURFACE INTERACTION, NAME=I
*SURFACE BEHAVIOR, PENALTY
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
UP_ZMIN, LOW_ZMAX
*BOUNDARY
LOW_ZMIN, 1, 3
UP_ZMAX, 1, 2
*STEP
*STATIC
0.5, 1.
*BOUNDARY
UP_ZMAX, 3, 3, -0.02
*END STEP
";

/// Then drawn along the surface, so that a part of it slips.
const FRICTION: &str = "\
*STEP
*STATIC
0.5, 1.
*BOUNDARY
UP_ZMAX, 1, 1, 0.015
*END STEP
";

/// The same bits of these fields of the last frame from one, two and eight threads; the last of the results.
fn compare(scratch: &Scratch, deck: &str, fields: &[(&str, usize)]) -> Results {
    let mut mesh = Block::tet10([6, 6, 3]).size([2.0, 2.0, 1.0]).mesh().prefixed("LOW_");
    mesh.append(&Block::tet10([5, 5, 3]).size([1.5, 1.5, 1.0]).origin([0.2, 0.3, 1.0]).mesh().prefixed("UP_"));
    std::fs::write(scratch.path("blocks.msh"), gmsh::write(&mesh, gmsh::Encoding::Binary)).unwrap();
    scratch.write("blocks.inp", deck);
    let bits = ["1", "2", "8"].map(|threads| {
        let run = scratch.fe(&["run", "blocks.inp", "--quiet", "--threads", threads]);
        assert_eq!(run.status, 0, "{}", run.error);
        let results = Results::open(&scratch.path("blocks.vtkhdf"));
        let last = results.times().len() - 1;
        let of_field = |&(name, width)| results.point_field(name, width, last).into_iter().map(f64::to_bits);
        fields.iter().flat_map(of_field).collect::<Vec<u64>>()
    });
    assert!(bits[0] == bits[1] && bits[0] == bits[2]);
    Results::open(&scratch.path("blocks.vtkhdf"))
}

/// Two blocks of tet10, meshes that do not match, pressed by a displacement: some thousand unknowns, so that element
/// loops, fronts and contact search have work for several threads.
#[test]
fn one_two_and_eight_threads_give_the_same_bits() {
    let scratch = Scratch::new("threads");
    compare(&scratch, DECK, &[("U", 3), ("RF", 3), ("S", 6), ("CPRESS", 1), ("CNORMF", 3)]);
}

/// With friction, where systems are not symmetric and some points stick, others slip.
#[test]
fn friction_gives_the_same_bits() {
    let scratch = Scratch::new("threads_friction");
    let deck = DECK.replace("*CONTACT PAIR", "*FRICTION\n0.3\n*CONTACT PAIR") + FRICTION;
    let fields = [("U", 3), ("RF", 3), ("CPRESS", 1), ("CSHEAR1", 1), ("CSHEAR2", 1), ("CSLIP1", 1), ("CSTATUS", 1)];
    let results = compare(&scratch, &deck, &fields);
    let statuses = results.point_field("CSTATUS", 1, results.times().len() - 1);
    assert!(statuses.contains(&1.0) && statuses.contains(&2.0), "all points stick, or all slip: {statuses:?}");
}
