//! Results do not depend on the number of threads, to the last bit.

mod common;

use common::Scratch;
use common::results::Results;
use fe_mesh::CellKind;
use fe_mesh::generate::Block;
use fe_mesh::gmsh;

/// Two blocks of tet10, meshes that do not match, pressed by a displacement: some thousand unknowns, so that element
/// loops, fronts and contact search have work for several threads.
#[test]
fn one_two_and_eight_threads_give_the_same_bits() {
    let scratch = Scratch::new("threads");
    let lower = Block::new(CellKind::Tet10, [6, 6, 3]).sized([2.0, 2.0, 1.0]).build();
    let upper = Block::new(CellKind::Tet10, [5, 5, 3]).sized([2.0, 2.0, 1.0]).at([0.1, 0.05, 1.0]).build();
    let _ = (&lower, &upper, gmsh::write as fn(_, _) -> _, &scratch);
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
