//! Solids in an explicit step: large displacements, elements with one integration point or several.
//!
//! Elements of one section are sorted along a space-filling curve and cut into chunks, each with its own copy of its nodes:
//! a chunk is one piece of work with everything in cache, threads never write to the same place, and as forces are summed
//! node by node in the order of the chunks the bits do not depend on the number of threads.

#[allow(clippy::needless_range_loop)]
mod batch;
mod chunk;
mod curve;
#[allow(clippy::needless_range_loop)]
mod hourglass;
#[allow(clippy::needless_range_loop)]
mod integrated;
#[allow(clippy::needless_range_loop)]
mod kernel;
#[allow(clippy::needless_range_loop)]
mod motion;
#[allow(clippy::needless_range_loop)]
mod neo_hooke;
mod one_point;
mod plane;
#[allow(clippy::needless_range_loop)]
mod response;
#[allow(clippy::needless_range_loop)]
mod shape;
#[allow(clippy::needless_range_loop)]
mod viscosity;

use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::material::{Damping, Response};
use crate::structure::Structure;
use batch::{Common, Outcome};
use chunk::Chunk;
use fe_mesh::CellId;
pub use hourglass::Hourglass;
use rayon::prelude::*;
use response::Answer;

/// Elements of a chunk: their state fills half of a core's second cache.
const CHUNK: usize = 1024;

/// Solids of one section and what they are made of.
#[derive(Clone, Debug)]
pub struct SolidSection<'a> {
    /// One that [`has`] says yes to.
    pub element: ElementType,
    /// The cells.
    pub cells: &'a [CellId],
    /// Stress from strain.
    pub response: &'a Response,
    /// Density [M/L³].
    pub density: f64,
    /// Thickness [L] of plane elements; 1 otherwise.
    pub thickness: f64,
    /// Rayleigh damping: α on the mass, which [`super::mass_damping::MassDamping`] does, β on the elastic stiffness of small
    /// strains.
    pub damping: Damping,
    /// What resists hourglass motion.
    pub hourglass: Hourglass,
    /// Linear and quadratic bulk viscosity [-].
    pub viscosity: [f64; 2],
}

/// True where explicit steps have solids of this type.
pub fn has(element: ElementType) -> bool {
    chunk::has(element)
}

/// Energies [F L] that an increment put into the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Work of the stress: recoverable and plastic.
    pub internal: f64,
    /// Of that, dissipated by plastic flow.
    pub plastic: f64,
    /// Into the resistance to hourglass motion.
    pub hourglass: f64,
    /// Dissipated by bulk viscosity, and by damping proportional to the stiffness.
    pub viscous: f64,
}

impl std::ops::AddAssign for Energies {
    fn add_assign(&mut self, other: Self) {
        self.internal += other.internal;
        self.plastic += other.plastic;
        self.hourglass += other.hourglass;
        self.viscous += other.viscous;
    }
}

/// State of one element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// The element.
    pub cell: CellId,
    /// Cauchy stress xx, yy, zz, xy, yz, xz [F/L²].
    pub stress: [f64; 6],
    /// Equivalent plastic strain [-].
    pub plastic: f64,
}

/// All solids of a scene.
#[derive(Debug)]
pub struct Solids {
    chunks: Vec<Chunk>,
    /// First freedom of each node of a solid, ascending, and where its places in the chunks begin in `slots`.
    nodes: Vec<(u32, u32)>,
    /// Chunk and local node, node after node.
    slots: Vec<(u32, u32)>,
    /// Internal forces of these nodes [F], and their elements' stiffness [F/L].
    sums: Vec<[f64; 4]>,
    /// 1 over the masses [1/M] that they have of solids.
    inverse_mass: Vec<f64>,
    /// True where the stable increment is that of all elements together.
    together: bool,
    energies: Energies,
    /// Translations of a node.
    dimension: usize,
}

impl Solids {
    /// At rest, free of stress.
    ///
    /// # Panics
    /// When a section is of elements that are not there, or a node lacks a translation.
    pub fn new(structure: &Structure, freedoms: &Freedoms, sections: &[SolidSection]) -> Self {
        let mut chunks = Vec::new();
        for section in sections {
            let Damping { alpha, beta } = section.damping;
            let common = Common {
                answer: Answer::new(section.response),
                density: section.density,
                thickness: section.thickness,
                hourglass: section.hourglass,
                viscosity: section.viscosity,
                beta,
            };
            let cells = curve::sorted(&structure.mesh, section.cells);
            let of =
                |cells: &[CellId]| Chunk::new((structure, freedoms), section.element, cells, (common.clone(), alpha));
            chunks.extend(cells.chunks(CHUNK).map(of));
        }
        let mut places: Vec<(u32, u32, u32)> = Vec::new();
        for (c, chunk) in chunks.iter().enumerate() {
            places.extend(chunk.nodes().enumerate().map(|(local, first)| (first, c as u32, local as u32)));
        }
        places.sort_unstable();
        let mut nodes: Vec<(u32, u32)> = Vec::new();
        for (slot, place) in places.iter().enumerate() {
            if nodes.last().is_none_or(|last| last.0 != place.0) {
                nodes.push((place.0, slot as u32));
            }
        }
        let slots = places.into_iter().map(|(_, chunk, local)| (chunk, local)).collect();
        let (sums, inverse_mass) = (vec![[0.0; 4]; nodes.len()], vec![0.0; nodes.len()]);
        let (energies, dimension) = (Energies::default(), structure.dimension());
        let mut solids = Solids { chunks, sums, inverse_mass, together: false, nodes, slots, energies, dimension };
        solids.weigh_nodes();
        solids
    }

    fn weigh_nodes(&mut self) {
        for (n, inverse) in self.inverse_mass.iter_mut().enumerate() {
            let own = places_of(&self.nodes, &self.slots, n);
            *inverse = 1.0 / own.iter().map(|&(chunk, local)| self.chunks[chunk as usize].mass(local)).sum::<f64>();
        }
    }

    /// From now on with another linear and quadratic bulk viscosity [-].
    pub fn damp(&mut self, viscosity: [f64; 2]) {
        self.chunks.iter_mut().for_each(|chunk| chunk.damp(viscosity));
    }

    /// Energies put into the elements so far.
    pub fn energies(&self) -> Energies {
        self.energies
    }

    /// Adds the damping α m [M/T] of materials to the freedoms.
    pub fn add_mass_damping(&self, damping: &mut [f64]) {
        self.chunks.iter().for_each(|chunk| chunk.add_mass_damping(damping));
    }

    /// From now on with so many times its mass in each element.
    pub fn scale(&mut self, factor: &dyn Fn(CellId) -> f64) {
        self.chunks.iter_mut().for_each(|chunk| chunk.scale(factor));
        self.weigh_nodes();
    }

    /// From now on with the stable increment that all elements bear together, where that is longer, or with that of the fastest
    /// by itself. With K ≤ κ on the nodes of each element, v·K v ≤ Σ_a v_a² Σ κ of the elements at a: no ω² is above the largest
    /// Σ κ/m_a, a mean of what the elements at a node have. Damping is at most the largest of an element.
    pub fn together(&mut self, wanted: bool) {
        self.together = wanted;
    }

    /// From now on with the stable increments of all elements, or without.
    pub fn measure(&mut self, wanted: bool) {
        self.chunks.iter_mut().for_each(|chunk| chunk.measure(wanted));
    }

    /// Stable increments [T] that the elements have by themselves, without their factors, as of the last increment.
    pub fn increments(&self) -> impl Iterator<Item = (CellId, f64)> + '_ {
        self.chunks.iter().flat_map(Chunk::increments)
    }

    /// Elements.
    pub fn count(&self) -> usize {
        self.chunks.iter().map(Chunk::count).sum()
    }

    /// Memory [bytes] that an increment passes through once, besides the vectors of the motion: elements, their state and their
    /// copies of nodes.
    pub fn bytes(&self) -> usize {
        self.chunks.iter().map(Chunk::bytes).sum()
    }

    /// State of all elements, in the order of the chunks.
    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        self.chunks.iter().flat_map(Chunk::states)
    }

    /// What all elements bear together, where that is longer than what the fastest bears by itself.
    fn bounded(&self, by_element: Advance, damping: f64) -> Advance {
        let of_node = |(sum, inverse): (&[f64; 4], &f64)| sum[3] * inverse;
        let square = self.sums.iter().zip(&self.inverse_mass).map(of_node).fold(0.0, f64::max);
        let together = Advance { stable: 2.0 / square.sqrt(), damping, ..by_element };
        if together.increment() > by_element.increment() { together } else { by_element }
    }

    /// Forces and stiffness of all chunks at each node.
    fn sum(&mut self) {
        let (chunks, nodes, slots) = (&self.chunks, &self.nodes, &self.slots);
        let of_node = |(n, sum): (usize, &mut [f64; 4])| {
            *sum = [0.0; 4];
            for &(chunk, local) in places_of(nodes, slots, n) {
                let own = chunks[chunk as usize].force(local);
                (0..4).for_each(|c| sum[c] += own[c]);
            }
        };
        if chunks.len() == 1 {
            self.sums.iter_mut().enumerate().for_each(of_node);
        } else {
            self.sums.par_iter_mut().enumerate().with_min_len(4096).for_each(of_node);
        }
    }
}

/// Chunk and local node of each place of a node.
fn places_of<'a>(nodes: &[(u32, u32)], slots: &'a [(u32, u32)], n: usize) -> &'a [(u32, u32)] {
    let end = nodes.get(n + 1).map_or(slots.len(), |next| next.1 as usize);
    &slots[nodes[n].1 as usize..end]
}

impl ExplicitTerm for Solids {
    fn name(&self) -> &str {
        "solids"
    }

    fn add_mass(&self, mass: &mut [f64]) {
        self.chunks.iter().for_each(|chunk| chunk.add_mass(mass));
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        let outcomes: Vec<Outcome> = if self.chunks.len() == 1 {
            self.chunks.iter_mut().map(|chunk| chunk.advance(at)).collect()
        } else {
            self.chunks.par_iter_mut().map(|chunk| chunk.advance(at)).collect()
        };
        let mut advance = Advance::default();
        let mut damping: f64 = 0.0;
        for (chunk, outcome) in self.chunks.iter().zip(outcomes) {
            if let Some(element) = outcome.inverted {
                return Err(Halt::Inverted { cell: chunk.cell(element) });
            }
            self.energies += outcome.energies;
            damping = damping.max(outcome.damping);
            if outcome.stable.0 < advance.stable {
                (advance.stable, advance.element) = (outcome.stable.0, Some(chunk.cell(outcome.stable.1)));
            }
        }
        self.sum();
        for (&(first, _), sum) in self.nodes.iter().zip(&self.sums) {
            (0..self.dimension).for_each(|c| forces[first as usize + c] -= sum[c]);
        }
        Ok(if self.together { self.bounded(advance, damping) } else { advance })
    }

    fn stored(&self) -> f64 {
        let Energies { internal, hourglass, viscous, .. } = self.energies;
        internal + hourglass + viscous
    }
}

#[cfg(test)]
mod tests;
