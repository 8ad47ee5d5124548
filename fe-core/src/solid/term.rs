//! The elements as a term of the virtual work.
//!
//! Chunks of elements are computed side by side and added in their order by one thread, while the next round
//! is being computed: the same bits for any number of threads.

use super::kernel::{Batches, Kernel};
use super::{SolidBlock, with_kernel};
use crate::lanes::LANES;
use crate::matrix::{Couplings, Pattern, Scatter};
use crate::reject::Reject;
use crate::term::{Assembly, Motion, Term};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// Elements of a chunk, a multiple of the lanes.
const CHUNK: usize = 16 * LANES;
/// Chunks computed in one round: few, so that they stay in the cache until they are added; more than four threads
/// would wait for the one that adds anyway.
const ROUND: usize = 4;

impl Term for SolidBlock {
    fn name(&self) -> &str {
        &self.name
    }

    fn couplings(&self, couplings: &mut Couplings) {
        couplings.add_all(&self.nodes, self.nodes_per_cell());
    }

    fn evaluate(&self, at: Motion, _old: &[f64], _new: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
        with_kernel!(self, kernel => self.assemble(&kernel, at.u, out))
    }

    fn is_linear(&self) -> bool {
        true
    }
}

impl SolidBlock {
    /// Stored energy ½ u·K u [F L].
    pub fn energy(&self, u: &[f64]) -> f64 {
        let mut residual = vec![0.0; self.freedoms];
        let mut out = Assembly { residual: &mut residual, stiffness: None, energy: 0.0, status_changes: 0 };
        let computed = with_kernel!(self, kernel => self.assemble(&kernel, u, &mut out));
        if computed.is_ok() { out.energy } else { f64::NAN }
    }

    fn assemble<K: Kernel>(&self, kernel: &K, u: &[f64], out: &mut Assembly) -> Result<(), Reject> {
        let scatter = out.stiffness.as_deref().map(|k| self.scatter(&k.pattern));
        let cells = self.cells.len();
        let rounds = cells.div_ceil(ROUND * CHUNK);
        let round = |r: usize| r * ROUND * CHUNK..cells.min((r + 1) * ROUND * CHUNK);
        let (mut ready, mut next) = (Vec::new(), Vec::new());
        if rounds > 0 {
            self.compute(kernel, round(0), u, &mut ready);
        }
        let mut energy = 0.0;
        for r in 0..rounds {
            let add = || energy += self.add::<K>(round(r), &ready, (u, scatter.as_deref()), out);
            let compute = || {
                if r + 1 < rounds {
                    self.compute(kernel, round(r + 1), u, &mut next);
                }
            };
            rayon::join(add, compute);
            std::mem::swap(&mut ready, &mut next);
        }
        out.energy += energy;
        if energy.is_finite() { Ok(()) } else { Err(Reject::NotFinite { place: self.name.clone(), node: None }) }
    }

    /// Stiffness and force of some cells, `[cells][K::STIFFNESS]`.
    fn compute<K: Kernel>(&self, kernel: &K, cells: Range<usize>, u: &[f64], results: &mut Vec<f64>) {
        results.resize(cells.len() * K::STIFFNESS, 0.0);
        results.par_chunks_mut(CHUNK * K::STIFFNESS).enumerate().for_each(|(c, place)| {
            let first = cells.start + c * CHUNK;
            let chunk = first..cells.end.min(first + CHUNK);
            self.with_batches(chunk, u, |batches| kernel.stiffness(batches, place));
        });
    }

    /// Hands coordinates and displacements of some cells, from a multiple of the lanes on, to `run`.
    pub(super) fn with_batches(&self, cells: Range<usize>, u: &[f64], run: impl FnOnce(Batches)) {
        let size = self.nodes_per_cell() * self.element.space().dimension();
        let batches = cells.start / LANES..cells.end.div_ceil(LANES);
        let coordinates = &self.coordinates[batches.start * size..batches.end * size];
        let displacements = self.displacements(cells, u);
        run(Batches { coordinates, displacements: &displacements });
    }

    /// Adds the results of some cells in their order; their energy.
    fn add<K: Kernel>(
        &self,
        cells: Range<usize>,
        results: &[f64],
        (u, scatter): (&[f64], Option<&Scatter>),
        out: &mut Assembly,
    ) -> f64 {
        let mut energy = 0.0;
        for (cell, result) in cells.zip(results.chunks_exact(K::STIFFNESS)) {
            let (lower, force) = result.split_at(K::STIFFNESS - K::NODES * K::DIRECTIONS);
            if let (Some(scatter), Some(matrix)) = (scatter, out.stiffness.as_deref_mut()) {
                matrix.scatter(scatter, cell, lower);
            }
            let starts = &self.starts[cell * K::NODES..(cell + 1) * K::NODES];
            for (&start, force) in starts.iter().zip(force.chunks_exact(K::DIRECTIONS)) {
                for (i, f) in force.iter().enumerate() {
                    out.residual[start as usize + i] += f;
                    energy += 0.5 * f * u[start as usize + i];
                }
            }
        }
        energy
    }

    /// Where the elements stand in matrices of this pattern.
    fn scatter(&self, pattern: &Arc<Pattern>) -> Arc<Scatter> {
        let mut kept = self.scatter.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some((of, scatter)) = &*kept
            && Arc::ptr_eq(of, pattern)
        {
            return scatter.clone();
        }
        let directions = self.element.space().dimension();
        let scatter = Arc::new(Scatter::new(pattern, &self.nodes, self.nodes_per_cell(), directions));
        *kept = Some((pattern.clone(), scatter.clone()));
        scatter
    }
}
