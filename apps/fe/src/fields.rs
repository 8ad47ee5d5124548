//! Values of the stored fields.

use crate::contact_fields::{self, Shown};
use crate::terms::Terms;
use fe_contact::state::ContactState;
use fe_core::member::Uniaxial;
use fe_core::procedure::Converged;
use fe_core::solid::PointFields;
use fe_io::results::{FieldInfo, Location};
use std::cell::OnceCell;

/// Stresses and strains of all sections at their integration points; made only when something asks for them.
pub struct Recovered {
    /// One for each section.
    pub blocks: Vec<PointFields>,
    /// One for each section of trusses or beams and of springs: of trusses alone.
    pub trusses: Vec<Vec<Uniaxial>>,
    /// Stress at the nodes, which more than one field shows.
    nodal_stress: OnceCell<Vec<[f64; 6]>>,
}

impl Recovered {
    /// At a displacement.
    pub fn at(terms: &Terms, u: &[f64]) -> Self {
        let blocks = terms.solids.iter().map(|block| block.stresses(u)).collect();
        let trusses = terms.members.iter().map(|members| members.uniaxial(u)).collect();
        Recovered { blocks, trusses, nodal_stress: OnceCell::new() }
    }
}

/// Which tensor.
#[derive(Clone, Copy, PartialEq)]
enum Tensor {
    Stress,
    Strain,
}

/// A field needs stresses or strains.
pub fn needs_recovery(field: &FieldInfo) -> bool {
    matches!(field.name, "S" | "E" | "MISES")
}

/// What the fields of one frame are made of.
pub struct Source<'a> {
    /// Terms.
    pub terms: &'a Terms,
    /// State.
    pub at: &'a Converged,
    /// Prescribed freedoms.
    pub fixed: &'a [bool],
    /// States of the pairs.
    pub states: &'a [ContactState],
    /// The same with their results at nodes, where a frame is stored.
    pub contacts: &'a [Shown<'a>],
    /// Stresses, where a field needs them.
    pub recovered: Option<&'a Recovered>,
}

impl Source<'_> {
    /// The numbers of a field, `[rows × width]`, NaN where it is not defined.
    pub fn values(&self, field: &FieldInfo) -> Vec<f64> {
        match (field.name, field.location) {
            ("U", _) => self.vectors(|f| self.at.u[f]),
            ("RF", _) => self.vectors(|f| if self.fixed[f] { self.at.residual[f] } else { 0.0 }),
            ("S", Location::Point) => self.nodal_stress(<[_]>::concat),
            ("E", Location::Point) => self.nodal(Tensor::Strain).concat(),
            ("MISES", Location::Point) => self.nodal_stress(|stress| stress.iter().map(mises).collect()),
            ("S", Location::Cell) => self.cells(Tensor::Stress).concat(),
            ("E", Location::Cell) => self.cells(Tensor::Strain).concat(),
            ("MISES", Location::Cell) => self.cells(Tensor::Stress).iter().map(mises).collect(),
            ("SF", _) => self.section_forces(0),
            ("SM", _) => self.section_forces(3),
            (name, _) => contact_fields::values(field, self.terms.structure.mesh.points.len(), self.contacts)
                .unwrap_or_else(|| unreachable!("the list of fields has no {name}")),
        }
    }

    /// Translations of a vector over the freedoms, `[points × 3]`.
    fn vectors(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let freedoms = &self.terms.freedoms;
        let mut out = vec![0.0; 3 * freedoms.nodes()];
        for (node, place) in out.chunks_exact_mut(3).enumerate() {
            for f in freedoms.of_node(node).filter(|&f| freedoms.component(f) < 3) {
                place[freedoms.component(f)] = value(f);
            }
        }
        out
    }

    /// Mean over the solids around each node of what the integration points extrapolate to.
    fn nodal(&self, tensor: Tensor) -> Vec<[f64; 6]> {
        let points = self.terms.structure.mesh.points.len();
        let (mut sum, mut count) = (vec![[0.0; 6]; points], vec![0u32; points]);
        for (block, fields) in self.terms.solids.iter().zip(self.blocks()) {
            let corners = block.nodal(tensor_of(fields, tensor));
            for (node, value) in block.nodes().iter().zip(&corners) {
                let node = *node as usize;
                (0..6).for_each(|c| sum[node][c] += value[c]);
                count[node] += 1;
            }
        }
        sum.iter().zip(count).map(|(s, n)| s.map(|v| if n > 0 { v / f64::from(n) } else { f64::NAN })).collect()
    }

    /// What is made of the stress at the nodes, nothing where it was not recovered.
    fn nodal_stress(&self, make: impl Fn(&[[f64; 6]]) -> Vec<f64>) -> Vec<f64> {
        let stress = |recovered: &Recovered| make(recovered.nodal_stress.get_or_init(|| self.nodal(Tensor::Stress)));
        self.recovered.map(stress).unwrap_or_default()
    }

    /// Mean over the integration points of each solid and truss, in the mesh's order; of a truss what is along it.
    fn cells(&self, tensor: Tensor) -> Vec<[f64; 6]> {
        let mesh = &self.terms.structure.mesh;
        let first = mesh.first_cells();
        let mut out = vec![[f64::NAN; 6]; mesh.cell_count()];
        for (block, fields) in self.terms.solids.iter().zip(self.blocks()) {
            let n = block.points();
            for (cell, values) in block.cells().iter().zip(tensor_of(fields, tensor).chunks_exact(n)) {
                let mean = |c: usize| values.iter().map(|v| v[c]).sum::<f64>() / n as f64;
                out[first[cell.block as usize] + cell.cell as usize] = std::array::from_fn(mean);
            }
        }
        let trusses = self.recovered.map_or(&[][..], |r| &r.trusses);
        for (members, states) in self.terms.members.iter().zip(trusses).filter(|(_, states)| !states.is_empty()) {
            let n = members.points();
            for (cell, states) in members.cells().iter().zip(states.chunks_exact(n)) {
                let values: Vec<[f64; 6]> = states.iter().map(|state| along(state, tensor)).collect();
                let mean = |c: usize| values.iter().map(|v| v[c]).sum::<f64>() / n as f64;
                out[first[cell.block as usize] + cell.cell as usize] = std::array::from_fn(mean);
            }
        }
        out
    }

    /// Three of N, Q₁, Q₂, M₁, M₂, T of each truss and beam, in the mesh's order.
    fn section_forces(&self, from: usize) -> Vec<f64> {
        let mesh = &self.terms.structure.mesh;
        let first = mesh.first_cells();
        let mut out = vec![f64::NAN; 3 * mesh.cell_count()];
        for members in &self.terms.members {
            for (cell, forces) in members.cells().iter().zip(members.mean_section_forces(&self.at.u)) {
                let place = 3 * (first[cell.block as usize] + cell.cell as usize);
                out[place..place + 3].copy_from_slice(&forces[from..from + 3]);
            }
        }
        out
    }

    fn blocks(&self) -> &[PointFields] {
        self.recovered.map_or(&[], |r| &r.blocks)
    }
}

/// The tensor s t⊗t of a truss of direction t.
fn along(state: &Uniaxial, tensor: Tensor) -> [f64; 6] {
    let s = if tensor == Tensor::Stress { state.stress } else { state.strain };
    let [x, y, z] = state.direction;
    [x * x, y * y, z * z, x * y, y * z, x * z].map(|t| s * t)
}

fn tensor_of(fields: &PointFields, tensor: Tensor) -> &[[f64; 6]] {
    if tensor == Tensor::Stress { &fields.stress } else { &fields.strain }
}

/// Mises stress √(3/2 s:s) of a stress xx, yy, zz, xy, yz, xz.
pub fn mises(s: &[f64; 6]) -> f64 {
    let [x, y, z, xy, yz, xz] = *s;
    let normal = (x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mises_of_tension_and_shear() {
        assert_eq!(mises(&[5.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 5.0);
        assert_eq!(mises(&[2.0, 2.0, 2.0, 0.0, 0.0, 0.0]), 0.0);
        assert!((mises(&[0.0, 0.0, 0.0, 0.0, 3.0, 0.0]) - 27f64.sqrt()).abs() < 1e-15 * 6.0);
    }
}
