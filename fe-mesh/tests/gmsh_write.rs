//! What is written reads back the same.
#![allow(clippy::unwrap_used)]

use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use fe_mesh::gmsh::{Encoding, Kept, parse, write};

fn read(bytes: &[u8]) -> Mesh {
    parse(bytes).unwrap_or_else(|error| panic!("{error}")).into_mesh(Kept::HighestDimension).0
}

/// Generated bodies, also two with unlike cells and numbers that no short decimal holds: every bit, label, set and
/// surface returns from both encodings.
#[test]
fn generated_meshes_return() {
    let bend = |[x, y, z]: [f64; 3]| [x / 3.0 + 1e-7 * z, y * 1e20, z + x * x / 7.0 - 1e-300];
    let mut two = Block::hex8([2, 3, 1]).mesh().prefixed("Lower ".to_uppercase().as_str());
    two.append(&Block::tet10([1, 2, 2]).origin([0.0, 0.0, 1.0]).mapped(bend).prefixed("UPPER_"));
    two.node_sets.insert("CORNERS".to_string(), vec![0, 11, 17]);
    two.node_sets.insert("REFERENCE".to_string(), vec![11]);
    for mesh in [
        Block::hex8([3, 2, 1]).mapped(bend),
        Block::tet4([1, 1, 2]).mesh(),
        Block::quad4([3, 2]).mesh(),
        Block::tri3([2, 2]).mesh(),
        two,
    ] {
        for encoding in [Encoding::Text, Encoding::Binary] {
            assert_eq!(read(&write(&mesh, encoding)), mesh, "{encoding:?}");
        }
    }
    assert_eq!(read(&write(&Mesh::default(), Encoding::Text)), Mesh::default());
}

/// Meshes that gmsh made return too, labels with gaps and an interface inside included.
#[test]
fn files_return() {
    for name in ["tetrahedra_2", "hexahedra_2", "plane", "sparse", "every_kind"] {
        let path = format!("{}/tests/data/{name}_41b.msh", env!("CARGO_MANIFEST_DIR"));
        let mesh = read(&std::fs::read(path).unwrap());
        for encoding in [Encoding::Text, Encoding::Binary] {
            assert_eq!(read(&write(&mesh, encoding)), mesh, "{name}");
        }
    }
}
