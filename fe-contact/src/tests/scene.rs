//! Blocks of elements to put in contact.

use crate::contact::Contact;
use crate::facet::{Facet, Vec3};
use crate::interaction::{Interaction, NormalBehavior};
use crate::law::linear::Linear;
use crate::pair::{Discretization, PairDefinition};
use crate::surface::{Main, Secondary};
use fe_core::element::{ElementType, Space};
use fe_core::material::{Elastic, Material};
use fe_core::{Freedoms, Section, Structure};
use fe_mesh::quadrature::Rule;
use fe_mesh::{CellBlock, CellId, CellKind, Face};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Blocks of a unit cube (or square) mapped to where they belong.
#[derive(Default)]
pub struct Scene {
    pub structure: Structure,
    /// Where each node was in the unit cube of its block.
    unit: Vec<[f64; 3]>,
}

impl Scene {
    /// A block of n₀ n₁ n₂ cells (simplices: each cut into two or six), mapped from the unit cube.
    pub fn block(&mut self, element: ElementType, n: [usize; 3], map: impl Fn(Vec3) -> Vec3) -> u32 {
        let plane = element.space() != Space::Solid;
        let n = if plane { [n[0], n[1], 0] } else { n };
        let first = self.unit.len() as u32;
        let count = n.map(|c| c + 1);
        let id = |i: [usize; 3]| first + ((i[2] * count[1] + i[1]) * count[0] + i[0]) as u32;
        for z in 0..count[2] {
            for y in 0..count[1] {
                for x in 0..count[0] {
                    let unit = [(x, n[0]), (y, n[1]), (z, n[2])].map(|(i, n)| i as f64 / n.max(1) as f64);
                    self.point(unit, &map);
                }
            }
        }
        let mut block = CellBlock::new(element.kind());
        let mut middles = BTreeMap::new();
        for z in 0..n[2].max(1) {
            for y in 0..n[1] {
                for x in 0..n[0] {
                    let corner = |d: [usize; 3]| id([x + d[0], y + d[1], z + d[2]]);
                    for cell in cells(element.kind(), corner) {
                        self.push(&mut block, &cell, &mut middles, &map);
                    }
                }
            }
        }
        let index = self.structure.mesh.blocks.len() as u32;
        let all = (0..block.len() as u32).map(|cell| CellId { block: index, cell }).collect();
        self.structure.mesh.blocks.push(block);
        self.structure.elements.push(element);
        let elastic = Elastic { young: 1000.0, poisson: 0.3 };
        self.structure.materials.push(Material::elastic("M", elastic));
        self.structure.sections.push(Section {
            element,
            cells: all,
            material: index as usize,
            thickness: 1.0,
            hourglass: None,
        });
        index
    }

    /// A node that belongs to no cell.
    pub fn node(&mut self, at: [f64; 3]) -> u32 {
        self.point([f64::NAN; 3], &|_| Vec3::from(at))
    }

    fn point(&mut self, unit: [f64; 3], map: &impl Fn(Vec3) -> Vec3) -> u32 {
        self.unit.push(unit);
        self.structure.mesh.points.push(map(unit.into()).into());
        self.structure.mesh.point_labels.push(self.unit.len() as u64);
        self.unit.len() as u32 - 1
    }

    fn push(
        &mut self,
        block: &mut CellBlock,
        cell: &[u32],
        middles: &mut BTreeMap<(u32, u32), u32>,
        map: &impl Fn(Vec3) -> Vec3,
    ) {
        block.labels.push(block.labels.len() as u64 + 1);
        block.nodes.extend_from_slice(cell);
        if block.kind == CellKind::Tet10 {
            for (a, b) in [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)] {
                let ends = (cell[a].min(cell[b]), cell[a].max(cell[b]));
                let middle = (Vec3::from(self.unit[ends.0 as usize]) + Vec3::from(self.unit[ends.1 as usize])) * 0.5;
                let node = *middles.entry(ends).or_insert_with(|| self.point(middle.into(), map));
                block.nodes.push(node);
            }
        }
    }

    /// The faces of a block all of whose nodes are, in the unit cube, where `on` says.
    pub fn faces(&self, block: u32, on: impl Fn([f64; 3]) -> bool) -> Vec<Face> {
        let mesh = &self.structure.mesh;
        let cells = mesh.cells().filter(|c| c.block == block);
        let all = cells.flat_map(|cell| (0..mesh.kind(cell).faces().len() as u8).map(move |face| Face { cell, face }));
        all.filter(|&f| mesh.face(f).1.iter().all(|&n| on(self.unit[n as usize]))).collect()
    }

    /// The outer faces of a block.
    pub fn skin(&self, block: u32) -> Vec<Face> {
        let axes = if self.structure.is_plane() { 2 } else { 3 };
        (0..axes).flat_map(|i| [0.0, 1.0].map(|at| self.faces(block, |r| r[i] == at))).flatten().collect()
    }

    pub fn freedoms(&self) -> Freedoms {
        self.structure.freedoms(&[])
    }

    pub fn pair(&self, definition: &PairDefinition, interaction: &Interaction) -> Contact {
        Contact::of_pair(&self.structure, &self.freedoms(), definition, interaction).unwrap()
    }
}

/// The cells of one brick: itself, two triangles, or six tetrahedra around its diagonal (Kuhn).
fn cells(kind: CellKind, corner: impl Fn([usize; 3]) -> u32) -> Vec<Vec<u32>> {
    let square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map(&corner);
    let top = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]].map(&corner);
    match kind {
        CellKind::Quad4 => vec![square.to_vec()],
        CellKind::Tri3 => vec![vec![square[0], square[1], square[2]], vec![square[0], square[2], square[3]]],
        CellKind::Hex8 => vec![[square, top].concat()],
        _ => [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]]
            .iter()
            .enumerate()
            .map(|(i, order)| {
                let mut at = [0; 3];
                let mut path = vec![corner(at)];
                for &axis in order {
                    at[axis] = 1;
                    path.push(corner(at));
                }
                if i >= 3 {
                    path.swap(1, 2);
                }
                path
            })
            .collect(),
    }
}

/// LINEAR with k = 100.
pub fn linear() -> Interaction {
    let law = Linear { slope: 100.0, clearance: 0.0 };
    Interaction {
        name: "I".into(),
        normal: NormalBehavior::Softened(Arc::new(law)),
        no_separation: false,
        friction: None,
        damping: None,
        explicit_damping: None,
        scale_factor: None,
        stabilized_along: false,
        measure: None,
    }
}

pub fn surfaces(secondary: Vec<Face>, main: Vec<Face>, discretization: Discretization) -> PairDefinition {
    PairDefinition {
        secondary_name: "S".into(),
        main_name: "M".into(),
        secondary: Secondary::Faces(secondary),
        main: Main::Faces(main),
        interaction: 0,
        discretization,
        small_sliding: true,
        bond: Default::default(),
        adjust: None,
        clearance: None,
    }
}

/// Rotation by 37°, 53°, 71° about x, y, z.
pub fn turned(x: Vec3) -> Vec3 {
    let angles = [37f64, 53.0, 71.0].map(f64::to_radians);
    nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]) * x
}

/// ∫φ_j n f dΓ over faces by node, n out of the body: what a pressure field f passes to the nodes, reversed.
pub fn integrals(scene: &Scene, faces: &[Face], f: impl Fn(&Vec3) -> f64) -> BTreeMap<u32, Vec3> {
    let mut sums = BTreeMap::new();
    for &face in faces {
        let facet = Facet::new(&scene.structure, face, None, &Vec3::zeros());
        for (xi, w) in Rule::of(facet.kind, 10).points {
            let xi = [xi[0], xi[1]];
            let x = facet.position(xi);
            let vector = facet.area_vector(xi) * (w * facet.factor(&x) * f(&x));
            for (&n, value) in facet.nodes().iter().zip(facet.values(xi)) {
                *sums.entry(n).or_insert_with(Vec3::zeros) += vector * value;
            }
        }
    }
    sums
}

/// A fixed sequence of numbers in −1..1 (linear congruence).
pub fn numbers(mut seed: u64) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
