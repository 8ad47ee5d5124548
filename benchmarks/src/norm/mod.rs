//! Errors of a computed field against an exact one, integrated over the elements; and of a contact pressure.

mod cell;
mod parts;

use crate::exact::Exact;
use cell::{Sums, Task};
use fe_core::solid::{BadElement, SolidBlock};
use fe_core::{Freedoms, Structure};
use fe_mesh::{CellKind, Face, shape};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Relative errors in L2 over the volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeErrors {
    /// √ of ∫ (σ_h−σ):D⁻¹:(σ_h−σ) over ∫ σ:D⁻¹:σ.
    pub energy: f64,
    /// Of the displacement.
    pub displacement: f64,
    /// Of the stress less its mean.
    pub deviator: f64,
}

/// How errors are integrated.
#[derive(Clone, Copy)]
pub struct Quadrature<'a> {
    /// Gauss points a direction.
    pub points: usize,
    /// Distance [L] to where the exact field is singular.
    pub singular: Option<&'a (dyn Fn([f64; 3]) -> f64 + Sync)>,
    /// How often a cell is halved towards that place: its parts are smaller than their distance from it, until then.
    pub splits: usize,
}

impl Default for Quadrature<'_> {
    /// Eight points a direction, for smooth fields.
    fn default() -> Self {
        Quadrature { points: 8, singular: None, splits: 0 }
    }
}

/// Errors of `u`, the displacement [L] of each point of the mesh, over all sections. The stress is that of the
/// elements themselves, enhanced strains included: the (multi-)linear function through the integration points.
pub fn errors(
    structure: &Structure,
    u: &[[f64; 3]],
    exact: &(dyn Fn([f64; 3]) -> Exact + Sync),
    quadrature: &Quadrature,
) -> Result<VolumeErrors, BadElement> {
    let freedoms = structure.freedoms(&[]);
    let vector = over_freedoms(&freedoms, u);
    let mut sums = Sums::default();
    for section in &structure.sections {
        let block = SolidBlock::new(structure, section, &freedoms)?;
        let stress = block.nodal(&block.stresses(&vector).stress);
        let elastic = structure.materials[section.material].response.elastic();
        let task = Task { structure, block: &block, stress: &stress, u, exact, elastic, quadrature };
        // Cells in any order, their sums in that of the mesh: the same bits for any number of threads.
        let parts: Vec<Sums> = (0..block.cells().len()).into_par_iter().map(|cell| task.sums(cell)).collect();
        parts.iter().for_each(|part| sums.add(part));
    }
    Ok(sums.relative())
}

/// The displacement of each point as a vector over the freedoms.
fn over_freedoms(freedoms: &Freedoms, u: &[[f64; 3]]) -> Vec<f64> {
    let mut vector = vec![0.0; freedoms.len()];
    for (node, u) in u.iter().enumerate() {
        freedoms.of_node(node).for_each(|freedom| vector[freedom] = u[freedoms.component(freedom)]);
    }
    vector
}

/// Relative error of a contact pressure [F/L²] in L2, the integral as a sum over nodes with their areas [L²].
pub fn nodal_pressure(nodes: impl IntoIterator<Item = NodalPressure>) -> f64 {
    let mut sums = [0.0; 2];
    for node in nodes {
        sums[0] += node.area * (node.found - node.exact).powi(2);
        sums[1] += node.area * node.exact.powi(2);
    }
    (sums[0] / sums[1]).sqrt()
}

/// A node's part in [`nodal_pressure`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalPressure {
    /// Computed pressure [F/L²].
    pub found: f64,
    /// Exact pressure [F/L²].
    pub exact: f64,
    /// Area that the node stands for [L²].
    pub area: f64,
}

/// ∫ N_a dA of each node of a surface [L²], by node; of an edge with unit thickness, or, `around` an axis, of the full
/// circumference. Corners of six-node triangles have none.
pub fn nodal_areas(mesh: &fe_mesh::Mesh, faces: &[Face], around: bool) -> BTreeMap<u32, f64> {
    let mut areas = BTreeMap::new();
    for &face in faces {
        let (kind, nodes) = mesh.face(face);
        for (xi, weight) in fe_mesh::quadrature::Rule::of(kind, 4).points {
            let (mut values, mut gradients) = ([0.0; 8], [[0.0; 3]; 8]);
            shape::values(kind, &xi, &mut values);
            shape::gradients(kind, &xi, &mut gradients);
            let sum = |weights: &dyn Fn(usize) -> f64| -> [f64; 3] {
                let point = |i: usize| (0..nodes.len()).map(|a| weights(a) * mesh.points[nodes[a] as usize][i]).sum();
                [point(0), point(1), point(2)]
            };
            let [s, t] = [0, 1].map(|d| sum(&|a| gradients[a][d]));
            let stretch = if kind.dimension() == 1 { length(s) } else { length(cross(s, t)) };
            let way = if around { std::f64::consts::TAU * sum(&|a| values[a])[0] } else { 1.0 };
            nodes
                .iter()
                .zip(values)
                .for_each(|(&n, value)| *areas.entry(n).or_insert(0.0) += weight * value * stretch * way);
        }
    }
    areas
}

fn cross([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> [f64; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// The kind with the corners of a cell alone.
pub(crate) fn corners(kind: CellKind) -> CellKind {
    match kind {
        CellKind::Line3 => CellKind::Line2,
        CellKind::Tet10 => CellKind::Tet4,
        CellKind::Tri6 => CellKind::Tri3,
        CellKind::Quad8 => CellKind::Quad4,
        other => other,
    }
}

#[cfg(test)]
mod tests;
