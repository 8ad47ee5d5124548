//! Lines and springs on a few nodes, held and loaded, solved densely.

use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::load::{LoadKind, unit_forces};
use crate::material::Damping;
use crate::matrix::{BlockMatrix, Couplings, Pattern};
use crate::member::Members;
use crate::structure::{Discrete, LineSection, Profile, Structure};
use crate::term::{Assembly, Motion, Term};
use fe_mesh::{CellBlock, CellId, Mesh};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

pub(super) const YOUNG: f64 = 210e3;
pub(super) const POISSON: f64 = 0.3;
pub(super) const SHEAR: f64 = YOUNG / (2.0 * (1.0 + POISSON));

/// A structure that grows block by block.
pub(super) struct Scene {
    pub structure: Structure,
}

impl Scene {
    pub fn new(points: &[[f64; 3]]) -> Self {
        let labels = (1..=points.len() as u64).collect();
        let mesh = Mesh { points: points.to_vec(), point_labels: labels, ..Mesh::default() };
        Scene { structure: Structure { mesh, ..Structure::default() } }
    }

    fn block(&mut self, element: ElementType, cells: &[&[u32]]) -> Vec<CellId> {
        let block = self.structure.elements.len() as u32;
        self.structure.elements.push(element);
        self.structure.mesh.blocks.push(CellBlock {
            nodes: cells.concat(),
            labels: (1..=cells.len() as u64).collect(),
            ..CellBlock::new(element.kind())
        });
        (0..cells.len() as u32).map(|cell| CellId { block, cell }).collect()
    }

    pub fn lines(mut self, element: ElementType, cells: &[&[u32]], profile: Profile, first_axis: [f64; 3]) -> Self {
        let cells = self.block(element, cells);
        let (young, shear, density) = (YOUNG, SHEAR, Some(2e-9));
        self.structure.lines.push(LineSection {
            element,
            cells,
            name: "STEEL".into(),
            young,
            shear,
            density,
            damping: Damping::default(),
            profile,
            first_axis,
        });
        self
    }

    pub fn discrete(mut self, element: ElementType, cells: &[&[u32]], magnitude: f64, components: [u8; 2]) -> Self {
        let cells = self.block(element, cells);
        self.structure.discrete.push(Discrete { element, cells, magnitude, components });
        self
    }

    pub fn freedoms(&self) -> Freedoms {
        self.structure.freedoms(&[])
    }

    pub fn members(&self) -> Vec<Members> {
        let (structure, freedoms) = (&self.structure, self.freedoms());
        let lines = structure.lines.iter().map(|s| Members::lines(structure, s, &freedoms).unwrap());
        lines.chain(structure.discrete.iter().map(|s| Members::springs(structure, s, &freedoms).unwrap())).collect()
    }

    /// K over all freedoms.
    pub fn stiffness(&self) -> DMatrix<f64> {
        let (freedoms, members) = (self.freedoms(), self.members());
        let mut couplings = Couplings::new(freedoms.nodes());
        members.iter().for_each(|m| m.couplings(&mut couplings));
        let mut matrix = BlockMatrix::zero(Arc::new(Pattern::new(&freedoms, &couplings)));
        let n = freedoms.len();
        let (rest, mut residual) = (vec![0.0; n], vec![0.0; n]);
        let at = Motion { u: &rest, du: &rest, step_time: 1.0, total_time: 1.0, dt: 1.0 };
        for m in &members {
            let mut out =
                Assembly { residual: &mut residual, stiffness: Some(&mut matrix), energy: 0.0, status_changes: 0 };
            m.evaluate(at, &[], &mut [], &mut out).unwrap();
        }
        let mut dense = DMatrix::zeros(n, n);
        for j in 0..n {
            let (mut unit, mut column) = (vec![0.0; n], vec![0.0; n]);
            unit[j] = 1.0;
            matrix.multiply_add(&unit, &mut column);
            dense.set_column(j, &DVector::from_vec(column));
        }
        dense
    }

    /// Displacements with some (node, component) held and loads given.
    pub fn solve(&self, held: &[(u32, usize)], loads: &[(LoadKind, f64)]) -> Vec<f64> {
        let freedoms = self.freedoms();
        let mut k = self.stiffness();
        let mut f = DVector::zeros(freedoms.len());
        for (kind, magnitude) in loads {
            for (freedom, force) in unit_forces(kind, &self.structure, &freedoms).unwrap() {
                f[freedom] += magnitude * force;
            }
        }
        for &(node, component) in held {
            let h = freedoms.index(node as usize, component).unwrap();
            k.row_mut(h).fill(0.0);
            k.column_mut(h).fill(0.0);
            (k[(h, h)], f[h]) = (1.0, 0.0);
        }
        k.lu().solve(&f).unwrap().as_slice().to_vec()
    }

    /// Displacement or rotation of a node.
    pub fn at(&self, u: &[f64], node: u32, component: usize) -> f64 {
        u[self.freedoms().index(node as usize, component).unwrap()]
    }
}

pub(super) fn force(node: u32, component: u8) -> LoadKind {
    LoadKind::Nodal { nodes: vec![node], component }
}

/// All freedoms of a node.
pub(super) fn clamped(node: u32, components: &[usize]) -> Vec<(u32, usize)> {
    components.iter().map(|&c| (node, c)).collect()
}

/// A turn of space by a skew angle about a skew axis.
pub(super) fn turned(x: [f64; 3]) -> [f64; 3] {
    let axis = nalgebra::Unit::new_normalize(nalgebra::Vector3::new(1.0, -2.0, 0.5));
    (nalgebra::Rotation3::from_axis_angle(&axis, 1.1) * nalgebra::Vector3::from(x)).into()
}
