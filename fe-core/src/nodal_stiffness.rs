//! How stiff the elements around single nodes are: the measure for penalties of contact elements.

use crate::element::Family;
use crate::freedoms::Freedoms;
use crate::matrix::{BlockMatrix, Couplings, Pattern};
use crate::member::Members;
use crate::solid::SolidBlock;
use crate::structure::{Discrete, LineSection, Section, Structure};
use crate::term::{Assembly, Motion, Term};
use fe_mesh::CellId;
use nalgebra::Matrix3;
use std::collections::BTreeSet;
use std::sync::Arc;

/// For each of a few nodes the stiffness [F/L] of its translations, of the solids, trusses, beams and springs at it, all
/// other nodes held; 0 where there are none, or where one of them has no stiffness.
pub fn nodal_stiffness(structure: &Structure, freedoms: &Freedoms, nodes: &[u32]) -> Vec<Matrix3<f64>> {
    let wanted: BTreeSet<u32> = nodes.iter().copied().collect();
    let terms = elements_at(structure, freedoms, &wanted);
    let mut couplings = Couplings::new(freedoms.nodes());
    terms.iter().for_each(|term| term.couplings(&mut couplings));
    let mut stiffness = BlockMatrix::zero(Arc::new(Pattern::new(freedoms, &couplings)));
    let (rest, mut residual) = (vec![0.0; freedoms.len()], vec![0.0; freedoms.len()]);
    let at = Motion { u: &rest, du: &rest, step_time: 0.0, total_time: 0.0, dt: 1.0 };
    for term in &terms {
        let mut out =
            Assembly { residual: &mut residual, stiffness: Some(&mut stiffness), energy: 0.0, status_changes: 0 };
        // At rest nothing is rejected.
        let _ = term.evaluate(at, &[], &mut [], &mut out);
    }
    let translations = |&node: &u32| {
        let (places, block) = (freedoms.of_node(node as usize), stiffness.of_node(node as usize));
        let count = places.len();
        let mut found = Matrix3::zeros();
        for (i, a) in places.clone().map(|f| freedoms.component(f)).enumerate().filter(|(_, a)| *a < 3) {
            for (j, b) in places.clone().map(|f| freedoms.component(f)).enumerate().filter(|(_, b)| *b < 3) {
                found[(a, b)] = block[i * count + j];
            }
        }
        found
    };
    nodes.iter().map(translations).collect()
}

/// The elements that have one of the nodes, as terms; bad ones are left out.
fn elements_at(structure: &Structure, freedoms: &Freedoms, nodes: &BTreeSet<u32>) -> Vec<Box<dyn Term>> {
    let around = |cells: &[CellId]| -> Vec<CellId> {
        let has = |cell: &&CellId| structure.mesh.cell(**cell).iter().any(|n| nodes.contains(n));
        cells.iter().filter(has).copied().collect()
    };
    let mut terms: Vec<Box<dyn Term>> = Vec::new();
    for section in &structure.sections {
        let part = Section { cells: around(&section.cells), ..section.clone() };
        terms.extend(SolidBlock::new(structure, &part, freedoms).map(|block| Box::new(block) as Box<dyn Term>).ok());
    }
    for section in &structure.lines {
        let part = LineSection { cells: around(&section.cells), ..section.clone() };
        terms.extend(Members::lines(structure, &part, freedoms).map(|part| Box::new(part) as Box<dyn Term>).ok());
    }
    for section in structure.discrete.iter().filter(|section| section.element.family() == Family::Spring) {
        let part = Discrete { cells: around(&section.cells), ..section.clone() };
        terms.extend(Members::springs(structure, &part, freedoms).map(|part| Box::new(part) as Box<dyn Term>).ok());
    }
    terms
}
