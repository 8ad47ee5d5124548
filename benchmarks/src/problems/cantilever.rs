//! A cantilever under an end shear: length 10, section 1 × 1, E = 210000, ν = 0.3, one end clamped.
//!
//! The answer is that of the three-dimensional body, clamped as it is, by extrapolation: see [`TIP`].

use crate::norm::nodal_areas;
use crate::problem::{Answer, Curve, Norm, Problem, Scene};
use fe_core::element::ElementType;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Shear force on the free end [F].
const SHEAR: f64 = 100.0;
const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const LENGTH: f64 = 10.0;

/// Deflection of the free end [L] of the clamped body, the mean that the load does work on: twice the energy over the
/// force. C3D10 on 10 n × n × n bricks gives 1.904119, 1.905594, 1.906044, 1.906301 for n = 4, 7, 10, 14; the last three
/// tend to 1.906712 at their own rate of 1.44, and to 1.906719 at 1.42, twice the exponent 0.711 of the singularity
/// along the clamped edges (Williams 1952, ν = 0.3). C3D8 with n = 8, 14, 20 tends to 1.906745.
pub const TIP: f64 = 1.906_72;

/// Tip deflection of Timoshenko's beam [L], PL³/3EI + PL/κGA with κ = 5/6. The clamped body is stiffer, because its
/// end cannot contract.
pub fn beam() -> f64 {
    let inertia = 1.0 / 12.0;
    let shear_modulus = YOUNG / (2.0 * (1.0 + POISSON));
    SHEAR * LENGTH.powi(3) / (3.0 * YOUNG * inertia) + SHEAR * LENGTH / (5.0 / 6.0 * shear_modulus)
}

/// The problem.
pub struct Cantilever;

impl Problem for Cantilever {
    fn name(&self) -> &'static str {
        "cantilever"
    }

    fn about(&self) -> &'static str {
        "10 x 1 x 1, clamped, end shear; tip deflection against the extrapolated limit"
    }

    fn norms(&self) -> &'static [Norm] {
        &[Norm { name: "tip deflection", floor: 1e-5 }]
    }

    fn curves(&self) -> Vec<Curve> {
        [
            (ElementType::C3D4, vec![2, 4, 8, 14, 20]),
            (ElementType::C3D8, vec![2, 4, 8, 14, 20]),
            (ElementType::C3D10, vec![1, 2, 4, 7, 10]),
        ]
        .map(|(element, sizes)| Curve { element, variant: "", sizes })
        .to_vec()
    }

    fn compared(&self) -> Vec<(Curve, usize)> {
        let curve = |element| Curve { element, variant: "", sizes: Vec::new() };
        [(ElementType::C3D8, 8), (ElementType::C3D8, 14), (ElementType::C3D10, 4), (ElementType::C3D10, 7)]
            .map(|(element, n)| (curve(element), n))
            .to_vec()
    }

    /// The mesh with `n` elements through the depth and 10 n along the beam.
    fn scene(&self, curve: &Curve, n: usize) -> Scene {
        let (element, divisions) = (curve.element, [10 * n, n, n]);
        let block = match element {
            ElementType::C3D8 => Block::hex8(divisions),
            ElementType::C3D4 => Block::tet4(divisions),
            _ => Block::tet10(divisions),
        };
        let mesh = block.size([LENGTH, 1.0, 1.0]).mesh();
        let cards = format!(
            "*MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG}, {POISSON}\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL\n\
             *BOUNDARY\nXMIN, 1, 3\n*STEP\n*STATIC\n1., 1.\n{loads}*NODE PRINT, NSET=XMAX\nU\n*END STEP\n",
            loads = load_cards(&mesh),
        );
        let name = format!("cantilever_{}_{n}", element.name().to_lowercase());
        let unknowns = 3 * (mesh.points.len() - mesh.node_sets["XMIN"].len());
        Scene { name, mesh, elements: vec![("BLOCK", element)], cards, unknowns }
    }

    fn errors(&self, scene: &Scene, answer: &Answer) -> Result<Vec<f64>, String> {
        let force = shear(&scene.mesh);
        let end = answer.displacements_of(&scene.mesh, "XMAX")?;
        let tip = end.iter().filter_map(|(point, u)| Some(force.get(&(*point as u32))? * u[2])).sum::<f64>() / SHEAR;
        Ok(vec![tip / TIP - 1.0])
    }
}

/// Nodal forces [F] of a uniform shear on the end face, of area 1, by point.
fn shear(mesh: &Mesh) -> BTreeMap<u32, f64> {
    let mut forces = nodal_areas(mesh, &mesh.surfaces["XMAX"], false);
    forces.values_mut().for_each(|force| *force *= SHEAR);
    // Corners of six-node triangles carry round-off.
    forces.retain(|_, force| force.abs() > 1e-12 * SHEAR);
    forces
}

fn load_cards(mesh: &Mesh) -> String {
    let mut cards = String::from("*CLOAD\n");
    for (node, force) in shear(mesh) {
        // Writing to a string does not fail.
        let _ = writeln!(cards, "{}, 3, {force:.12e}", mesh.point_labels[node as usize]);
    }
    cards
}
