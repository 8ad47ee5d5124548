//! The stiffness of the elements beneath a surface, from which the default penalty is taken.

use crate::facet::{Facet, Rules, Vec3};
use fe_core::Structure;
use fe_mesh::{CellId, Face};
use rayon::prelude::*;

/// The default penalty over the stiffness beneath [-], alone and with multipliers (Abaqus Analysis User's Manual, Contact
/// constraint enforcement methods).
pub const PENALTY_FACTOR: f64 = 10.0;
/// See [`PENALTY_FACTOR`].
pub const AUGMENTED_FACTOR: f64 = 1000.0;

/// Poisson's ratio beyond which a nearly incompressible element counts as no stiffer [-].
const LARGEST_POISSON: f64 = 0.45;

/// k_e = mean over the facets, weighted with their areas, of M / l [F/L³]: M = E (1 − ν) / ((1 + ν)(1 − 2ν)) the
/// constrained modulus, l the element's volume over the face's area. `None` without elastic elements.
pub fn beneath(structure: &Structure, facets: &[Facet]) -> Option<f64> {
    let rules = Rules::new(3);
    let each = |facet: &Facet| {
        let section = structure.section_of(facet.face.cell)?;
        let elastic = structure.materials[section.material].elastic;
        let nu = elastic.poisson.min(LARGEST_POISSON);
        let modulus = elastic.young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let length = volume(structure, facet.face.cell, &rules) / facet.area;
        (length > 0.0).then(|| (facet.area * modulus / length, facet.area))
    };
    let parts: Vec<Option<(f64, f64)>> = facets.par_iter().map(each).collect();
    let (sum, area) = parts.into_iter().flatten().fold((0.0, 0.0), |(s, a), part| (s + part.0, a + part.1));
    (area > 0.0).then(|| sum / area)
}

/// Volume [L³] of a cell, area [L²] of a plane one: (1/d) ∫ x·n over its faces, x from one of its nodes, so that
/// little cancels.
fn volume(structure: &Structure, cell: CellId, rules: &Rules) -> f64 {
    let faces = structure.mesh.kind(cell).faces();
    let origin = Vec3::from(structure.mesh.points[structure.mesh.cell(cell)[0] as usize]);
    let of_face = |face: usize| {
        let facet = Facet::new(structure, Face { cell, face: face as u8 }, Some(1.0), &origin);
        let flux = |(xi, w): &([f64; 3], f64)| {
            let xi = [xi[0], xi[1]];
            facet.position(xi).dot(&facet.area_vector(xi)) * w
        };
        let dimension = facet.kind.dimension() + 1;
        rules.of(&facet).iter().map(flux).sum::<f64>() / dimension as f64
    };
    (0..faces.len()).map(of_face).sum()
}
