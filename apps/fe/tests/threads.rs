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

/// Two blocks of tet10, meshes that do not match, pressed by a displacement: some thousand unknowns, so that element
/// loops, fronts and contact search have work for several threads.
#[test]
fn one_two_and_eight_threads_give_the_same_bits() {
    let scratch = Scratch::new("threads");
    let mut mesh = Block::tet10([6, 6, 3]).size([2.0, 2.0, 1.0]).mesh().prefixed("LOW_");
    mesh.append(&Block::tet10([5, 5, 3]).size([1.5, 1.5, 1.0]).origin([0.2, 0.3, 1.0]).mesh().prefixed("UP_"));
    std::fs::write(scratch.path("blocks.msh"), gmsh::write(&mesh, gmsh::Encoding::Binary)).unwrap();
    scratch.write("blocks.inp", DECK);
    let mut bits: Vec<Vec<u64>> = Vec::new();
    for threads in ["1", "2", "8"] {
        let run = scratch.fe(&["run", "blocks.inp", "--quiet", "--threads", threads]);
        assert_eq!(run.status, 0, "{}", run.error);
        let results = Results::open(&scratch.path("blocks.vtkhdf"));
        let last = results.times().len() - 1;
        let mut all = Vec::new();
        for (name, width) in [("U", 3), ("RF", 3), ("S", 6), ("CPRESS", 1), ("CNORMF", 3)] {
            all.extend(results.point_field(name, width, last).iter().map(|v| v.to_bits()));
        }
        bits.push(all);
    }
    assert!(bits[0] == bits[1] && bits[0] == bits[2]);
}
