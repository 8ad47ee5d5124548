//! A cantilever under an end shear: length 10, section 1 × 1, E = 210000, ν = 0.3, one end clamped.

use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use fe_mesh::{Mesh, gmsh};
use std::fmt::Write;

/// Shear force on the free end [F].
pub const SHEAR: f64 = 100.0;
const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const LENGTH: f64 = 10.0;

/// Tip deflection of Timoshenko's beam [L], PL³/3EI + PL/κGA with κ = 5/6. A clamped solid is stiffer, because its end
/// cannot contract: both elements tend to 0.7 % less.
pub fn reference() -> f64 {
    let inertia = 1.0 / 12.0;
    let shear_modulus = YOUNG / (2.0 * (1.0 + POISSON));
    SHEAR * LENGTH.powi(3) / (3.0 * YOUNG * inertia) + SHEAR * LENGTH / (5.0 / 6.0 * shear_modulus)
}

/// The mesh with `n` elements through the depth and 10 n along the beam.
pub fn mesh(element: ElementType, n: usize) -> Mesh {
    let divisions = [10 * n, n, n];
    let block = if element == ElementType::C3D8 { Block::hex8(divisions) } else { Block::tet10(divisions) };
    block.size([LENGTH, 1.0, 1.0]).mesh()
}

/// Deck and gmsh file, as a user would write them; `name` is that of both.
pub fn files(element: ElementType, mesh: &Mesh, name: &str) -> (String, Vec<u8>) {
    let deck = format!(
        "*HEADING\nCantilever, {element}\n*MESH, INPUT={name}.msh\nBLOCK, {element}\n\
         *MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG}, {POISSON}\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL\n\
         *BOUNDARY\nXMIN, 1, 3\n*STEP\n*STATIC\n1., 1.\n{loads}\
         *OUTPUT, FIELD\n*NODE OUTPUT\nU\n*END STEP\n",
        element = element.name(),
        loads = shear(mesh),
    );
    (deck, gmsh::write(mesh, gmsh::Encoding::Binary))
}

/// A uniform shear on the end face: each facet's share to its nodes (a quarter of a square each, a third of a
/// six-node triangle to each of its middles).
fn shear(mesh: &Mesh) -> String {
    let faces = &mesh.surfaces["XMAX"];
    let each = SHEAR / faces.len() as f64;
    let mut force = vec![0.0; mesh.points.len()];
    for &face in faces {
        let (_, nodes) = mesh.face(face);
        let loaded = if nodes.len() == 6 { &nodes[3..] } else { &nodes[..] };
        loaded.iter().for_each(|&n| force[n as usize] += each / loaded.len() as f64);
    }
    let mut cards = String::from("*CLOAD\n");
    for (n, f) in force.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        // Writing to a string does not fail.
        let _ = writeln!(cards, "{}, 3, {f:.17e}", mesh.point_labels[n]);
    }
    cards
}

/// Mean deflection of the free end [L].
pub fn tip(mesh: &Mesh, u: &[f64]) -> f64 {
    let end = &mesh.node_sets["XMAX"];
    end.iter().map(|&n| u[3 * n as usize + 2]).sum::<f64>() / end.len() as f64
}
