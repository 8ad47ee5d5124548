//! What a plan leaves out takes no memory: two runs on the same mesh, with and without unknowns.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use fe_mesh::generate::Block;
use fe_mesh::gmsh::{Encoding, write};

/// Cubes along each edge of the block.
const EDGE: usize = 16;

/// A block of cubes, its bottom held and the nodes of `pressed` moved down.
fn deck(pressed: &str) -> String {
    format!(
        "*MESH, INPUT=block.msh\nBLOCK, C3D8\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\n{pressed}\n\
         *OUTPUT, FIELD\n*NODE OUTPUT\nU\n*END STEP\n"
    )
}

/// The number before the first `MB` after some words.
fn megabytes(text: &str, words: &str) -> f64 {
    let after = text.split(words).nth(1).unwrap_or_else(|| panic!("no {words}: {text}"));
    after.split(" MB").next().unwrap().trim().parse().unwrap()
}

/// Matrix, pattern and factor of the plan are a lower bound of what the unknowns take (fronts and the places of the
/// elements in the matrix come on top); the scene without unknowns must be below by all of it. A tenth is left for
/// what the system's allocator keeps.
#[test]
fn a_scene_without_unknowns_takes_no_memory_for_them() {
    let scratch = Scratch::new("plan_memory");
    std::fs::write(scratch.path("block.msh"), write(&Block::hex8([EDGE; 3]).mesh(), Encoding::Binary)).unwrap();
    scratch.write("free.inp", &deck("ZMIN, 1, 3\nZMAX, 3, 3, -0.01"));
    scratch.write("held.inp", &deck("BLOCK, 1, 2\nBLOCK, 3, 3, -0.01"));
    let peak = |name: &str| {
        let run = scratch.fe(&["run", name, "--threads", "1"]);
        assert_eq!(run.status, 0, "{}", run.error);
        megabytes(&run.output, "peak memory")
    };
    let plan = scratch.fe(&["check", "free.inp"]).output;
    let planned = megabytes(&plan, "about");
    let (free, held) = (peak("free.inp"), peak("held.inp"));
    // A factor of some tens of megabytes stands out from a process of ten.
    assert!(planned > 30.0, "{plan}");
    assert!(free - held > 0.9 * planned, "{free} MB with, {held} MB without unknowns; planned {planned} MB");
}
