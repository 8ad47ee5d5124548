//! Small scenes: one section on a regular grid, moved as a test asks, and its solution.

use crate::element::{ElementType, Space};
use crate::linear::LinearSolver;
use crate::linear::multifrontal::Multifrontal;
use crate::material::{Elastic, Material, Response};
use crate::matrix::{BlockMatrix, Couplings, Pattern};
use crate::solid::SolidBlock;
use crate::structure::{Section, Structure};
use crate::term::{Assembly, Motion, Term};
use crate::{Freedoms, element};
use fe_mesh::{CellBlock, CellId, CellKind, Face, Mesh};
use nalgebra::DMatrix;
use std::collections::BTreeMap;
use std::sync::Arc;

/// One block of elements.
pub struct Scene {
    pub structure: Structure,
    pub freedoms: Freedoms,
}

/// The six tetrahedra about the diagonal 0–6 of a hexahedron.
const KUHN: [[usize; 4]; 6] = [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]];

impl Scene {
    /// `counts` cells (each cut into triangles or tetrahedra where the type asks for it) of the unit square or
    /// cube, every point sent through `map`. Mid nodes lie on `map` too.
    pub fn grid(element: ElementType, counts: [usize; 3], map: impl Fn([f64; 3]) -> [f64; 3]) -> Scene {
        let counts = if element.space() == Space::Solid { counts } else { [counts[0], counts[1], 0] };
        let place = |i: usize, n: usize| if n == 0 { 0.0 } else { i as f64 / n as f64 };
        let mut points = Vec::new();
        for k in 0..=counts[2] {
            for j in 0..=counts[1] {
                for i in 0..=counts[0] {
                    points.push([place(i, counts[0]), place(j, counts[1]), place(k, counts[2])]);
                }
            }
        }
        let (row, layer) = (counts[0] + 1, (counts[0] + 1) * (counts[1] + 1));
        let mut nodes: Vec<u32> = Vec::new();
        for k in 0..counts[2].max(1) {
            for j in 0..counts[1] {
                for i in 0..counts[0] {
                    let at = |o: [usize; 3]| (i + o[0] + (j + o[1]) * row + (k + o[2]) * layer) as u32;
                    let square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map(at);
                    let cube = [square, [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]].map(at)].concat();
                    match element.kind() {
                        CellKind::Tri3 => nodes.extend([0, 1, 2, 0, 2, 3].map(|c: usize| square[c])),
                        CellKind::Quad4 => nodes.extend(square),
                        CellKind::Hex8 => nodes.extend(cube),
                        _ => nodes.extend(KUHN.as_flattened().iter().map(|&c| cube[c])),
                    }
                }
            }
        }
        if element.kind() == CellKind::Tet10 {
            nodes = with_mid_nodes(&nodes, &mut points);
        }
        Scene::new(element, points.into_iter().map(map).collect(), nodes)
    }

    /// From points and cells; steel-like E = 1000, ν = 0.3, thickness 1.
    pub fn new(element: ElementType, points: Vec<[f64; 3]>, nodes: Vec<u32>) -> Scene {
        let count = nodes.len() / element.kind().nodes();
        let block = CellBlock { kind: element.kind(), labels: (1..=count as u64).collect(), nodes };
        let mesh = Mesh {
            point_labels: (1..=points.len() as u64).collect(),
            points,
            blocks: vec![block],
            ..Default::default()
        };
        let material =
            Material { density: Some(2.0), ..Material::elastic("M", Elastic { young: 1000.0, poisson: 0.3 }) };
        let cells = mesh.cells().collect();
        let section = Section { element, cells, material: 0, thickness: 1.0, hourglass: None };
        let structure = Structure {
            mesh,
            elements: vec![element],
            materials: vec![material],
            sections: vec![section],
            ..Structure::default()
        };
        let freedoms = structure.freedoms(&[]);
        Scene { structure, freedoms }
    }

    pub fn with_material(mut self, young: f64, poisson: f64) -> Scene {
        self.structure.materials[0].response = Response::Elastic(Elastic { young, poisson });
        self
    }

    pub fn with_thickness(mut self, thickness: f64) -> Scene {
        self.structure.sections[0].thickness = thickness;
        self
    }

    pub fn element(&self) -> element::ElementType {
        self.structure.sections[0].element
    }

    pub fn block(&self) -> SolidBlock {
        SolidBlock::new(&self.structure, &self.structure.sections[0], &self.freedoms).unwrap()
    }

    /// Stiffness of all elements.
    pub fn stiffness(&self) -> BlockMatrix {
        let block = self.block();
        let mut matrix = self.zero_stiffness(&block);
        let u = vec![0.0; self.freedoms.len()];
        let mut residual = u.clone();
        let at = Motion { u: &u, du: &u, step_time: 0.0, total_time: 0.0, dt: 1.0 };
        let mut out =
            Assembly { residual: &mut residual, stiffness: Some(&mut matrix), energy: 0.0, status_changes: 0 };
        block.evaluate(at, &[], &mut [], &mut out).unwrap();
        matrix
    }

    /// A matrix with room for a block's stiffness.
    pub fn zero_stiffness(&self, block: &SolidBlock) -> BlockMatrix {
        let mut couplings = Couplings::new(self.freedoms.nodes());
        block.couplings(&mut couplings);
        BlockMatrix::zero(Arc::new(Pattern::new(&self.freedoms, &couplings)))
    }

    /// The stiffness as a full matrix.
    pub fn dense(&self) -> DMatrix<f64> {
        let (matrix, n) = (self.stiffness(), self.freedoms.len());
        let mut full = DMatrix::zeros(n, n);
        for j in 0..n {
            let (mut unit, mut column) = (vec![0.0; n], vec![0.0; n]);
            unit[j] = 1.0;
            matrix.multiply_add(&unit, &mut column);
            full.column_mut(j).copy_from_slice(&column);
        }
        full
    }

    /// A field of displacements at the nodes.
    pub fn field(&self, of: impl Fn([f64; 3]) -> [f64; 3]) -> Vec<f64> {
        (0..self.freedoms.len())
            .map(|f| of(self.structure.mesh.points[self.freedoms.node(f)])[self.freedoms.component(f)])
            .collect()
    }

    /// Displacements under nodal forces, where `held` gives a value it is prescribed.
    pub fn solve(&self, force: &[f64], held: impl Fn([f64; 3], usize) -> Option<f64>) -> Vec<f64> {
        let stiffness = self.stiffness();
        let value = |f: usize| held(self.structure.mesh.points[self.freedoms.node(f)], self.freedoms.component(f));
        let mut u: Vec<f64> = (0..self.freedoms.len()).map(|f| value(f).unwrap_or(0.0)).collect();
        let free: Vec<bool> = (0..self.freedoms.len()).map(|f| value(f).is_none()).collect();
        let mut rest = vec![0.0; u.len()];
        stiffness.multiply_add(&u, &mut rest);
        rest.iter_mut().zip(force).for_each(|(r, f)| *r = f - *r);
        let mut solver = Multifrontal::new();
        solver.analyse(&stiffness.pattern, &free, &vec![false; stiffness.pattern.nodes()]);
        solver.factor(&stiffness).unwrap();
        solver.solve(&mut rest);
        u.iter_mut().zip(&rest).for_each(|(u, d)| *u += d);
        u
    }

    /// Faces whose nodes all satisfy a condition.
    pub fn faces(&self, on: impl Fn([f64; 3]) -> bool) -> Vec<Face> {
        let mesh = &self.structure.mesh;
        let mut faces = Vec::new();
        for cell in mesh.cells() {
            for face in 0..mesh.kind(cell).faces().len() as u8 {
                let face = Face { cell, face };
                if mesh.face(face).1.iter().all(|&n| on(mesh.points[n as usize])) {
                    faces.push(face);
                }
            }
        }
        faces
    }

    pub fn cell(&self, cell: usize) -> &[u32] {
        self.structure.mesh.cell(CellId { block: 0, cell: cell as u32 })
    }

    /// The node at a place, within 1e-9.
    pub fn node_at(&self, x: [f64; 3]) -> usize {
        let near = |p: &[f64; 3]| (0..3).all(|i| (p[i] - x[i]).abs() < 1e-9);
        self.structure.mesh.points.iter().position(near).unwrap()
    }
}

/// Ten-node tetrahedra from four-node ones, the mid nodes appended to the points.
fn with_mid_nodes(nodes: &[u32], points: &mut Vec<[f64; 3]>) -> Vec<u32> {
    let mut mids = BTreeMap::new();
    let mut out = Vec::new();
    for tet in nodes.chunks_exact(4) {
        out.extend_from_slice(tet);
        for (a, b) in [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)] {
            let (a, b) = (tet[a].min(tet[b]), tet[a].max(tet[b]));
            let mid = *mids.entry((a, b)).or_insert_with(|| {
                let (p, q) = (points[a as usize], points[b as usize]);
                points.push(std::array::from_fn(|i| 0.5 * (p[i] + q[i])));
                points.len() as u32 - 1
            });
            out.push(mid);
        }
    }
    out
}

/// A number in [−1, 1] that depends on a place only, erratically.
pub fn noise(x: [f64; 3], salt: usize) -> f64 {
    let s = (x[0] * 127.1 + x[1] * 311.7 + x[2] * 74.7 + salt as f64 * 53.9).sin() * 43758.5453;
    2.0 * (s - s.floor()) - 1.0
}

/// Points inside the unit square or cube moved by up to `amount`; the mid nodes of a straight-edged mesh must
/// be set afterwards with [`straighten`].
pub fn jiggle(x: [f64; 3], amount: f64) -> [f64; 3] {
    let inside = |x: f64| x > 1e-9 && x < 1.0 - 1e-9;
    let plane = x[2] == 0.0;
    if !inside(x[0]) || !inside(x[1]) || !(plane || inside(x[2])) {
        return x;
    }
    let moved = |i: usize| x[i] + amount * noise(x, i);
    [moved(0), moved(1), if plane { 0.0 } else { moved(2) }]
}

/// The distortion of a grid of `cells` cells by up to `amount` of a cell, (multi-)linear inside each: refined grids
/// follow the same pattern.
pub fn pattern(x: [f64; 3], cells: usize, amount: f64) -> [f64; 3] {
    let n = cells as f64;
    let low = x.map(|x| ((x * n).floor().min(n - 1.0)) / n);
    let mut moved = [0.0; 3];
    for corner in 0..8 {
        let high = [corner & 1, corner >> 1 & 1, corner >> 2];
        let mut weight = 1.0;
        let mut at = [0.0; 3];
        for i in 0..3 {
            let part = (x[i] - low[i]) * n;
            weight *= if high[i] == 1 { part } else { 1.0 - part };
            at[i] = ((low[i] * n).round() + high[i] as f64) / n;
        }
        if weight != 0.0 {
            let corner = jiggle(at, amount / n);
            (0..3).for_each(|i| moved[i] += weight * corner[i]);
        }
    }
    moved
}

/// Puts mid nodes halfway between their corners.
pub fn straighten(scene: &mut Scene) {
    let mesh = &mut scene.structure.mesh;
    if mesh.blocks[0].kind == CellKind::Tet10 {
        for cell in mesh.blocks[0].nodes.chunks_exact(10) {
            for (m, (a, b)) in [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)].into_iter().enumerate() {
                let (p, q) = (mesh.points[cell[a] as usize], mesh.points[cell[b] as usize]);
                mesh.points[cell[4 + m] as usize] = std::array::from_fn(|i| 0.5 * (p[i] + q[i]));
            }
        }
    }
}
