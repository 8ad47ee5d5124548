//! The stiffness of the elements beneath a surface, from which the default penalty is taken.

use crate::facet::{Facet, Rules, Vec3};
use crate::point::ContactPoint;
use fe_core::nodal_stiffness::nodal_stiffness;
use fe_core::{Freedoms, Structure};
use fe_mesh::{CellId, Face};
use nalgebra::Matrix3;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The default penalty over the stiffness beneath [-], alone and with multipliers (Abaqus Analysis User's Manual, Contact
/// constraint enforcement methods).
pub const PENALTY_FACTOR: f64 = 10.0;
/// See [`PENALTY_FACTOR`].
pub const AUGMENTED_FACTOR: f64 = 1000.0;
/// Of the final slope of a nonlinear penalty. See [`PENALTY_FACTOR`].
pub const NONLINEAR_FACTOR: f64 = 100.0;

/// What rounding leaves of no stiffness, of the largest [-].
const ROUND_OFF: f64 = 1e-12;

/// Poisson's ratio beyond which a nearly incompressible element counts as no stiffer [-].
const LARGEST_POISSON: f64 = 0.45;

/// k_e = mean over the facets, weighted with their areas, of M / l [F/L³]: M = E (1 − ν) / ((1 + ν)(1 − 2ν)) the
/// constrained modulus, l the element's volume over the face's area. `None` without elastic elements.
pub fn beneath(structure: &Structure, facets: &[Facet]) -> Option<f64> {
    let rules = Rules::new(3);
    let each = |facet: &Facet| {
        let section = structure.section_of(facet.face.cell)?;
        let elastic = structure.materials[section.material].response.elastic();
        let nu = elastic.poisson.min(LARGEST_POISSON);
        let modulus = elastic.young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let length = volume(structure, facet.face.cell, &rules) / facet.area;
        (length > 0.0).then(|| (facet.area * modulus / length, facet.area))
    };
    let parts: Vec<Option<(f64, f64)>> = facets.par_iter().map(each).collect();
    let (sum, area) = parts.into_iter().flatten().fold((0.0, 0.0), |(s, a), part| (s + part.0, a + part.1));
    (area > 0.0).then(|| sum / area)
}

/// What stands for k_e where points have no facets: the mean over the points of the largest stiffness [F/L] of a node of
/// theirs along the normal over their measure, of the softer side; a side without stiffness is rigid. `None` where no
/// node has any.
pub fn at_points((structure, freedoms): (&Structure, &Freedoms), points: &[ContactPoint]) -> Option<f64> {
    let mut of_node: BTreeMap<u32, Matrix3<f64>> =
        points.iter().flat_map(|p| &p.nodes).map(|&n| (n, Matrix3::zeros())).collect();
    let nodes: Vec<u32> = of_node.keys().copied().collect();
    of_node.values_mut().zip(nodal_stiffness(structure, freedoms, &nodes)).for_each(|(k, found)| *k = found);
    let each = points.iter().filter_map(|point| {
        let normal = Vec3::from(point.normal);
        let side = |main: bool| {
            let nodes = point.nodes.iter().filter(|n| (**n != point.node) == main);
            nodes.map(|n| along(&of_node[n], &normal)).reduce(f64::max).filter(|k| *k > 0.0)
        };
        let softer = [side(false), side(true)].into_iter().flatten().reduce(f64::min)?;
        Some(softer / point.measure.value())
    });
    mean(each)
}

/// The same; where no node of theirs has a stiffness, the mean of all nodes of the model, or 1, which is said.
pub fn at_points_or_chosen(
    bodies: (&Structure, &Freedoms),
    points: &[ContactPoint],
    (name, notes): (&str, &mut Vec<String>),
) -> f64 {
    at_points(bodies, points).unwrap_or_else(|| {
        let chosen = anywhere(bodies).unwrap_or(1.0);
        if !points.is_empty() {
            notes.push(format!(
                "no element gives the nodes of {name} a stiffness: {chosen:.6e} F/L stands for it in the penalty of hard \
                 contact"
            ));
        }
        chosen
    })
}

/// Stiffness of a node along a normal; that of its stiffest axis for a round point, which has no normal, and where there is
/// none along it (beyond round-off), as across trusses.
fn along(stiffness: &Matrix3<f64>, normal: &Vec3) -> f64 {
    let (found, largest) = (normal.dot(&(stiffness * normal)), stiffness.diagonal().max());
    if found > ROUND_OFF * largest { found } else { largest }
}

/// The largest of all nodes of a model, on average, without measure.
fn anywhere((structure, freedoms): (&Structure, &Freedoms)) -> Option<f64> {
    let nodes: Vec<u32> = (0..structure.mesh.points.len() as u32).collect();
    let all = nodal_stiffness(structure, freedoms, &nodes).into_iter().map(|k| k.diagonal().max());
    mean(all.filter(|k| *k > 0.0))
}

/// `None` of nothing.
fn mean(of: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = of.fold((0.0, 0), |(sum, count), k| (sum + k, count + 1));
    (count > 0).then(|| sum / f64::from(count))
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
