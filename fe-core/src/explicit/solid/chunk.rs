//! A chunk of elements with copies of their nodes.

use super::kernel::{Common, MASS, Of, Outcome, PLASTIC, Place, Run, numbers};
use super::shape::{Hexahedron, Tetrahedron};
use super::{Moving, PointState, SolidSection};
use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::lanes::{LANES, Lanes};
use crate::structure::Structure;
use fe_mesh::CellId;
use std::collections::HashMap;
use std::marker::PhantomData;

/// Local nodes of the elements, eight side by side.
#[derive(Debug)]
enum Batches {
    Hexahedra(Vec<[[u32; LANES]; 8]>),
    Tetrahedra(Vec<[[u32; LANES]; 4]>),
}

#[derive(Debug)]
pub(super) struct Chunk {
    common: Common,
    cells: Vec<CellId>,
    batches: Batches,
    /// First freedom and reference coordinates [L] of each local node.
    nodes: Vec<(u32, [f64; 3])>,
    places: Vec<Place>,
    forces: Vec<[f64; 4]>,
    state: Vec<Lanes>,
}

/// Eight elements at a time; the last one fills up the last batch.
fn batches<const N: usize>(elements: &[Vec<u32>]) -> Vec<[[u32; LANES]; N]> {
    let of = |b: usize| {
        std::array::from_fn(|a| std::array::from_fn(|lane| elements[(b * LANES + lane).min(elements.len() - 1)][a]))
    };
    (0..elements.len().div_ceil(LANES)).map(of).collect()
}

impl Chunk {
    pub fn new(
        (structure, freedoms): (&Structure, &Freedoms),
        section: &SolidSection,
        cells: &[CellId],
        common: Common,
    ) -> Self {
        let mesh = &structure.mesh;
        let mut local: HashMap<u32, u32> = HashMap::new();
        let mut nodes = Vec::new();
        let mut elements: Vec<Vec<u32>> = Vec::with_capacity(cells.len());
        for &cell in cells {
            let of = |&n: &u32| {
                *local.entry(n).or_insert_with(|| {
                    let place = freedoms.of_node(n as usize);
                    assert!(place.len() >= 3, "a node of a solid has three translations");
                    nodes.push((place.start as u32, mesh.points[n as usize]));
                    nodes.len() as u32 - 1
                })
            };
            elements.push(mesh.cell(cell).iter().map(of).collect());
        }
        let (batches, hourglass) = match section.element {
            ElementType::C3D4 => (Batches::Tetrahedra(batches(&elements)), 0),
            ElementType::C3D8R => (Batches::Hexahedra(batches(&elements)), 4),
            other => panic!("{} is no element of explicit steps", other.name()),
        };
        let count = elements.len().div_ceil(LANES) * numbers(hourglass);
        let places = vec![Place::default(); nodes.len()];
        let forces = vec![[0.0; 4]; nodes.len()];
        let mut chunk =
            Chunk { common, cells: cells.to_vec(), batches, nodes, places, forces, state: vec![Lanes::ZERO; count] };
        chunk.weigh(section.density);
        chunk
    }

    /// Gives each element its mass: density times volume, found by the kernel's own gradients.
    fn weigh(&mut self, density: f64) {
        use super::shape::Shape;
        fn volumes<S: Shape<N, H>, const N: usize, const H: usize>(
            batches: &[[[u32; LANES]; N]],
            nodes: &[(u32, [f64; 3])],
        ) -> Vec<Lanes> {
            let of = |batch: &[[u32; LANES]; N]| {
                let x = batch.map(|n| std::array::from_fn(|c| Lanes(n.map(|n| nodes[n as usize].1[c]))));
                let mut volume = Lanes::ZERO;
                for (gradient, x) in S::gradients::<false>(&x).iter().zip(&x) {
                    (0..3).for_each(|c| volume += gradient[c] * x[c]);
                }
                volume * (1.0 / 3.0)
            };
            batches.iter().map(of).collect()
        }
        let (volumes, each) = match &self.batches {
            Batches::Hexahedra(batches) => (volumes::<Hexahedron, 8, 4>(batches, &self.nodes), numbers(4)),
            Batches::Tetrahedra(batches) => (volumes::<Tetrahedron, 4, 0>(batches, &self.nodes), numbers(0)),
        };
        for (state, volume) in self.state.chunks_exact_mut(each).zip(volumes) {
            state[MASS] = volume * density;
        }
    }

    /// From now on with another bulk viscosity.
    pub fn damp(&mut self, viscosity: [f64; 2]) {
        self.common.viscosity = viscosity;
    }

    pub fn count(&self) -> usize {
        self.cells.len()
    }

    pub fn cell(&self, element: usize) -> CellId {
        self.cells[element]
    }

    /// First freedoms of the local nodes.
    pub fn nodes(&self) -> impl Iterator<Item = u32> + '_ {
        self.nodes.iter().map(|node| node.0)
    }

    pub fn force(&self, local: u32) -> &[f64; 4] {
        &self.forces[local as usize]
    }

    fn numbers(&self) -> usize {
        match self.batches {
            Batches::Hexahedra(_) => numbers(4),
            Batches::Tetrahedra(_) => numbers(0),
        }
    }

    /// Adds an equal share of each element's mass to the freedoms of its nodes.
    pub fn add_mass(&self, mass: &mut [f64]) {
        let state = self.state.chunks_exact(self.numbers());
        let mut add = |nodes: &[[u32; LANES]], state: &[Lanes], real: usize| {
            for of in nodes {
                for (&node, whole) in of.iter().zip(&state[MASS].0).take(real) {
                    let first = self.nodes[node as usize].0 as usize;
                    let share = whole / nodes.len() as f64;
                    mass[first..first + 3].iter_mut().for_each(|m| *m += share);
                }
            }
        };
        let real = |b: usize| (self.cells.len() - b * LANES).min(LANES);
        match &self.batches {
            Batches::Hexahedra(all) => {
                all.iter().zip(state).enumerate().for_each(|(b, (nodes, state))| add(nodes, state, real(b)));
            }
            Batches::Tetrahedra(all) => {
                all.iter().zip(state).enumerate().for_each(|(b, (nodes, state))| add(nodes, state, real(b)));
            }
        }
    }

    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        let each = self.numbers();
        self.cells.iter().enumerate().map(move |(e, &cell)| {
            let state = &self.state[e / LANES * each..];
            let [xx, yy, zz, xy, yz, zx] = [0, 1, 2, 3, 4, 5].map(|i| state[i].0[e % LANES]);
            PointState { cell, stress: [xx, yy, zz, xy, yz, zx], plastic: state[PLASTIC].0[e % LANES] }
        })
    }

    /// Moves the elements on; their internal forces stand in [`Chunk::force`].
    pub fn advance(&mut self, at: &Moving) -> Outcome {
        for (place, (first, x)) in self.places.iter_mut().zip(&self.nodes) {
            let first = *first as usize;
            let (u, v) = (&at.u[first..first + 3], &at.v[first..first + 3]);
            for c in 0..3 {
                place.x[c] = x[c] + u[c];
                place.du[c] = at.dt * v[c];
            }
        }
        self.forces.fill([0.0; 4]);
        let (common, count, places) = (&self.common, self.cells.len(), self.places.as_slice());
        let (state, forces, dt) = (self.state.as_mut_slice(), self.forces.as_mut_slice(), at.dt);
        match &self.batches {
            Batches::Hexahedra(batches) => {
                let run = Run { common, dt, count, batches, places, state, forces };
                Of::<Hexahedron, 8, 4>(run, PhantomData).go()
            }
            Batches::Tetrahedra(batches) => {
                let run = Run { common, dt, count, batches, places, state, forces };
                Of::<Tetrahedron, 4, 0>(run, PhantomData).go()
            }
        }
    }
}
