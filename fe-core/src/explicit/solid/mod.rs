//! Solids in an explicit step: elements with one integration point and large displacements.
//!
//! Elements of one section are sorted along a space-filling curve and cut into chunks, each with its own copy of its nodes:
//! a chunk is one piece of work with everything in cache, threads never write to the same place, and as forces are summed
//! node by node in the order of the chunks the bits do not depend on the number of threads.

mod chunk;
mod curve;
#[allow(clippy::needless_range_loop)]
mod flow;
#[allow(clippy::needless_range_loop)]
mod hourglass;
#[allow(clippy::needless_range_loop)]
mod kernel;
#[allow(clippy::needless_range_loop)]
mod shape;

use super::{Advance, ExplicitTerm, Halt, Moving};
use crate::element::ElementType;
use crate::freedoms::Freedoms;
use crate::structure::Structure;
use chunk::Chunk;
use fe_mesh::CellId;
pub use flow::Flow;
pub use hourglass::Hourglass;
pub use kernel::Energies;
use kernel::{Common, Outcome};
use rayon::prelude::*;

/// Elements of a chunk: their state fills half of a core's second cache.
const CHUNK: usize = 1024;

/// Solids of one section and what they are made of.
#[derive(Clone, Debug)]
pub struct SolidSection<'a> {
    /// C3D8R or C3D4.
    pub element: ElementType,
    /// The cells.
    pub cells: &'a [CellId],
    /// Moduli and yield stress.
    pub flow: Flow,
    /// Density [M/L³].
    pub density: f64,
    /// What resists hourglass motion.
    pub hourglass: Hourglass,
    /// Linear and quadratic bulk viscosity [-].
    pub viscosity: [f64; 2],
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
    /// Internal forces of these nodes [F].
    sums: Vec<[f64; 3]>,
    energies: Energies,
}

impl Solids {
    /// At rest, free of stress.
    ///
    /// # Panics
    /// When a section is neither of C3D8R nor of C3D4, or a node has not three translations.
    pub fn new(structure: &Structure, freedoms: &Freedoms, sections: &[SolidSection]) -> Self {
        let mut chunks = Vec::new();
        for section in sections {
            let common =
                Common { flow: section.flow.clone(), hourglass: section.hourglass, viscosity: section.viscosity };
            let cells = curve::sorted(&structure.mesh, section.cells);
            let of = |cells: &[CellId]| Chunk::new((structure, freedoms), section, cells, common.clone());
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
        Solids { chunks, sums: vec![[0.0; 3]; nodes.len()], nodes, slots, energies: Energies::default() }
    }

    /// From now on with another linear and quadratic bulk viscosity [-].
    pub fn damp(&mut self, viscosity: [f64; 2]) {
        self.chunks.iter_mut().for_each(|chunk| chunk.damp(viscosity));
    }

    /// Energies put into the elements so far.
    pub fn energies(&self) -> Energies {
        self.energies
    }

    /// Elements.
    pub fn count(&self) -> usize {
        self.chunks.iter().map(Chunk::count).sum()
    }

    /// State of all elements, in the order of the chunks.
    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        self.chunks.iter().flat_map(Chunk::states)
    }

    /// Forces of all chunks on each node.
    fn sum(&mut self) {
        let (chunks, nodes, slots) = (&self.chunks, &self.nodes, &self.slots);
        let of_node = |(n, sum): (usize, &mut [f64; 3])| {
            let end = nodes.get(n + 1).map_or(slots.len(), |next| next.1 as usize);
            let mut total = [0.0; 3];
            for &(chunk, local) in &slots[nodes[n].1 as usize..end] {
                let force = chunks[chunk as usize].force(local);
                (0..3).for_each(|c| total[c] += force[c]);
            }
            *sum = total;
        };
        if chunks.len() == 1 {
            self.sums.iter_mut().enumerate().for_each(of_node);
        } else {
            self.sums.par_iter_mut().enumerate().with_min_len(4096).for_each(of_node);
        }
    }
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
        for (chunk, outcome) in self.chunks.iter().zip(outcomes) {
            if let Some(element) = outcome.inverted {
                return Err(Halt::Inverted { cell: chunk.cell(element) });
            }
            self.energies += outcome.energies;
            if outcome.stable.0 < advance.stable {
                (advance.stable, advance.element) = (outcome.stable.0, Some(chunk.cell(outcome.stable.1)));
            }
        }
        self.sum();
        for (&(first, _), sum) in self.nodes.iter().zip(&self.sums) {
            (0..3).for_each(|c| forces[first as usize + c] -= sum[c]);
        }
        Ok(advance)
    }

    fn stored(&self) -> f64 {
        let Energies { internal, hourglass, viscous, .. } = self.energies;
        internal + hourglass + viscous
    }
}

#[cfg(test)]
mod tests;
