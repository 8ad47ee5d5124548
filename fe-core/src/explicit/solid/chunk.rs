//! A chunk of elements with copies of their nodes.

use super::batch::{Common, Outcome, Place, Run};
use super::integrated::Integrated;
use super::one_point::OnePoint;
use super::plane::{Plane, Ring};
use super::shape::{Hexahedron, Tetrahedron};
use super::{Moving, PointState};
use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::structure::Structure;
use fe_mesh::CellId;
use std::collections::HashMap;
use std::fmt::Debug;

/// The elements of a chunk.
pub(super) trait Elements: Debug + Send + Sync {
    /// Finds masses, of so many elements with nodes that are at `reference`, and adds those of the nodes, times a factor of each
    /// element.
    fn weigh(&mut self, common: &Common, of: (usize, &[[f64; 3]]), factor: &dyn Fn(usize) -> f64, masses: &mut [f64]);

    /// Moves them on.
    fn advance(&mut self, run: Run) -> Outcome;

    /// Memory [bytes] of their nodes and state.
    fn bytes(&self) -> usize;

    /// Stress and plastic strain of an element, means over its points.
    fn point(&self, element: usize) -> ([f64; 6], f64);
}

/// Those of a type, by their local nodes; `None` where explicit steps do not have it.
fn elements(element: ElementType, nodes: &[Vec<u32>]) -> Option<Box<dyn Elements>> {
    use ElementType::*;
    Some(match element {
        C3D8R => Box::new(OnePoint::<Hexahedron, 8, 4>::new(nodes)),
        C3D4 => Box::new(OnePoint::<Tetrahedron, 4, 0>::new(nodes)),
        CPE4R => Box::new(OnePoint::<Plane<false>, 4, 1>::new(nodes)),
        CPE3 => Box::new(OnePoint::<Plane<false>, 3, 0>::new(nodes)),
        CPS4R => Box::new(OnePoint::<Plane<true>, 4, 1>::new(nodes)),
        CPS3 => Box::new(OnePoint::<Plane<true>, 3, 0>::new(nodes)),
        CAX4R => Box::new(OnePoint::<Ring, 4, 1>::new(nodes)),
        CAX3 => Box::new(OnePoint::<Ring, 3, 0>::new(nodes)),
        C3D8 => Box::new(Integrated::<8, 8>::new(element, nodes)),
        C3D10 => Box::new(Integrated::<10, 4>::new(element, nodes)),
        CPE4 | CAX4 => Box::new(Integrated::<4, 4>::new(element, nodes)),
        _ => return None,
    })
}

/// True where explicit steps have solids of this type.
pub(super) fn has(element: ElementType) -> bool {
    elements(element, &[]).is_some()
}

#[derive(Debug)]
pub(super) struct Chunk {
    common: Common,
    /// Damping by mass [1/T].
    alpha: f64,
    cells: Vec<CellId>,
    elements: Box<dyn Elements>,
    /// Translations of a node: 3 or 2.
    dimension: usize,
    /// Of each local node: first freedom, coordinates [L] at the start, what it has of the elements' masses [M].
    nodes: Vec<u32>,
    reference: Vec<[f64; 3]>,
    masses: Vec<f64>,
    /// Factors on the elements' masses, where they are scaled; their stable increments [T] by themselves, where they are asked
    /// for.
    factors: Option<Vec<f64>>,
    increments: Option<Vec<f64>>,
    places: Vec<Place>,
    forces: Vec<[f64; 4]>,
}

impl Chunk {
    pub fn new(
        (structure, freedoms): (&Structure, &Freedoms),
        element: ElementType,
        cells: &[CellId],
        (common, alpha): (Common, f64),
    ) -> Self {
        let mesh = &structure.mesh;
        let dimension = element.space().dimension();
        let mut local: HashMap<u32, u32> = HashMap::new();
        let (mut nodes, mut reference) = (Vec::new(), Vec::new());
        let mut of_cells: Vec<Vec<u32>> = Vec::with_capacity(cells.len());
        for &cell in cells {
            let of = |&n: &u32| {
                *local.entry(n).or_insert_with(|| {
                    let place = freedoms.of_node(n as usize);
                    assert!(place.len() >= dimension, "a node of a solid has all translations");
                    nodes.push(place.start as u32);
                    reference.push(mesh.points[n as usize]);
                    nodes.len() as u32 - 1
                })
            };
            of_cells.push(mesh.cell(cell).iter().map(of).collect());
        }
        let Some(mut elements) = elements(element, &of_cells) else {
            panic!("{} is no element of explicit steps", element.name());
        };
        let mut masses = vec![0.0; nodes.len()];
        elements.weigh(&common, (cells.len(), &reference), &|_| 1.0, &mut masses);
        let (places, forces) = (vec![Place::default(); nodes.len()], vec![[0.0; 4]; nodes.len()]);
        let (factors, increments, cells) = (None, None, cells.to_vec());
        Chunk {
            common,
            alpha,
            cells,
            elements,
            dimension,
            nodes,
            reference,
            masses,
            factors,
            increments,
            places,
            forces,
        }
    }

    /// From now on with another bulk viscosity.
    pub fn damp(&mut self, viscosity: [f64; 2]) {
        self.common.viscosity = viscosity;
    }

    /// From now on with so many times its mass in each element.
    pub fn scale(&mut self, factor: &dyn Fn(CellId) -> f64) {
        let factors: Vec<f64> = self.cells.iter().map(|&cell| factor(cell)).collect();
        self.masses.fill(0.0);
        let of = (self.cells.len(), self.reference.as_slice());
        self.elements.weigh(&self.common, of, &|element| factors[element], &mut self.masses);
        self.factors = factors.iter().any(|f| *f != 1.0).then_some(factors);
    }

    /// From now on with the stable increments of all elements, or without.
    pub fn measure(&mut self, wanted: bool) {
        self.increments = wanted.then(|| vec![f64::INFINITY; self.cells.len()]);
    }

    /// Stable increments [T] that the elements have by themselves, as of the last increment; none where they are not asked for.
    pub fn increments(&self) -> impl Iterator<Item = (CellId, f64)> + '_ {
        self.cells.iter().copied().zip(self.increments.iter().flatten().copied())
    }

    pub fn count(&self) -> usize {
        self.cells.len()
    }

    /// Memory [bytes] that an increment passes through.
    pub fn bytes(&self) -> usize {
        let of_nodes = self.nodes.len() * (size_of::<u32>() + size_of::<[f64; 3]>());
        self.elements.bytes() + of_nodes + size_of_val(&self.places[..]) + size_of_val(&self.forces[..])
    }

    pub fn cell(&self, element: usize) -> CellId {
        self.cells[element]
    }

    /// First freedoms of the local nodes.
    pub fn nodes(&self) -> impl Iterator<Item = u32> + '_ {
        self.nodes.iter().copied()
    }

    /// Internal force [F] on a local node, and its elements' stiffness [F/L].
    pub fn force(&self, local: u32) -> &[f64; 4] {
        &self.forces[local as usize]
    }

    /// Mass [M] of a local node.
    pub fn mass(&self, local: u32) -> f64 {
        self.masses[local as usize]
    }

    /// Adds the masses of the nodes to their freedoms.
    pub fn add_mass(&self, mass: &mut [f64]) {
        self.add(mass, 1.0);
    }

    /// Adds their damping α m.
    pub fn add_mass_damping(&self, damping: &mut [f64]) {
        if self.alpha > 0.0 {
            self.add(damping, self.alpha);
        }
    }

    fn add(&self, to: &mut [f64], factor: f64) {
        for (&first, own) in self.nodes.iter().zip(&self.masses) {
            to[first as usize..first as usize + self.dimension].iter_mut().for_each(|m| *m += factor * own);
        }
    }

    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        self.cells.iter().enumerate().map(|(e, &cell)| {
            let (stress, plastic) = self.elements.point(e);
            PointState { cell, stress, plastic }
        })
    }

    /// Moves the elements on; their internal forces stand in [`Chunk::force`].
    pub fn advance(&mut self, at: &Moving) -> Outcome {
        for ((place, &first), x) in self.places.iter_mut().zip(&self.nodes).zip(&self.reference) {
            let first = first as usize;
            let (u, v) = (&at.u[first..first + self.dimension], &at.v[first..first + self.dimension]);
            for c in 0..self.dimension {
                place.x[c] = x[c] + u[c];
                place.du[c] = at.dt * v[c];
            }
        }
        self.forces.fill([0.0; 4]);
        self.elements.advance(Run {
            common: &self.common,
            dt: at.dt,
            count: self.cells.len(),
            places: &self.places,
            reference: &self.reference,
            factors: self.factors.as_deref(),
            increments: self.increments.as_deref_mut(),
            forces: &mut self.forces,
        })
    }
}
