//! The multifrontal Cholesky factorisation (Duff & Reid 1983; Liu 1992).
//!
//! The node graph is ordered by nested dissection; columns of like structure are eliminated together as one dense
//! front, which leaves a dense update to its parent in the elimination tree. Subtrees run side by side, and near the
//! roots the tiles of a front; both are cut in a fixed way, so the bits do not depend on the number of threads.
//!
//! Where a few blocks change from one factorisation to the next, as in contact, only their fronts and those above are
//! eliminated again; the others leave what they left before, which is kept where it enters a front that changes.

mod changing;
mod dense;
mod extend;
mod front;
mod layout;
mod pool;
mod solve;
mod supernodes;
mod symbolic;
#[cfg(test)]
mod tests;
mod trapezoid;
mod tree;
mod walk;

use super::{Cost, LinearSolver, Singular};
use crate::matrix::{BlockMatrix, Pattern};
use front::{Fronts, Kept, Update};
use pool::Pool;
use solve::Substitution;
use std::sync::Arc;
use symbolic::Symbolic;
use walk::Walk;

/// LLᵀ factor of K_ff, the free part of a positive definite matrix.
#[derive(Default)]
pub struct Multifrontal {
    symbolic: Symbolic,
    factor: Vec<f64>,
    kept: Vec<Kept>,
}

impl Multifrontal {
    /// Nothing analysed yet.
    pub fn new() -> Self {
        Multifrontal::default()
    }

    /// The least held freedom after a factorisation of `matrix`, and its pivot as a part of its own diagonal entry: how
    /// much of its stiffness is left once all that was eliminated before has given way.
    pub fn least_held(&self, matrix: &BlockMatrix) -> Option<(usize, f64)> {
        let diagonal = matrix.diagonal();
        let pivots = self.symbolic.supernodes.iter().flat_map(|node| {
            let values = &self.factor[node.values..];
            (0..node.columns).map(|column| {
                let panel = node.factor().panel_of(column);
                (node.unknown + column, values[panel.start + panel.below(column, column).start].powi(2))
            })
        });
        let parts = pivots.map(|(unknown, pivot)| {
            let freedom = self.symbolic.freedoms[unknown] as usize;
            (freedom, pivot / diagonal[freedom])
        });
        parts.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Eliminates front by front; where it is done `again`, only the fronts that have changed. A `fresh` factor holds
    /// zeros.
    fn eliminate(&mut self, matrix: &BlockMatrix, again: bool, fresh: bool) -> Result<(), Singular> {
        let symbolic = &self.symbolic;
        let least = least_pivots(symbolic, matrix);
        let fronts = Fronts { symbolic, matrix, least: &least, pool: &Pool::default(), kept: &self.kept, again, fresh };
        let visit = |s: usize, own: &mut [f64], stack: &mut Vec<Update>| fronts.visit(s, own, stack);
        Walk::new(symbolic, |s| symbolic.value_start(s))
            .up(&mut self.factor, &visit)
            .map_err(|unknown| Singular { freedom: symbolic.freedoms[unknown] as usize })
    }

    /// Solves for several right-hand sides in place, each over all freedoms as in [`LinearSolver::solve`].
    pub fn solve_all(&self, sides: &mut [Vec<f64>]) {
        let right = sides.len();
        let mut x = vec![0.0; self.symbolic.freedoms.len() * right];
        for (k, side) in sides.iter().enumerate() {
            for (row, &freedom) in x.chunks_exact_mut(right).zip(&self.symbolic.freedoms) {
                row[k] = side[freedom as usize];
            }
        }
        Substitution { symbolic: &self.symbolic, factor: &self.factor, right }.solve(&mut x);
        for (k, side) in sides.iter_mut().enumerate() {
            side.fill(0.0);
            for (row, &freedom) in x.chunks_exact(right).zip(&self.symbolic.freedoms) {
                side[freedom as usize] = row[k];
            }
        }
    }
}

impl LinearSolver for Multifrontal {
    fn analyse(&mut self, pattern: &Arc<Pattern>, free: &[bool], changing: &[bool]) {
        self.symbolic = Symbolic::new(pattern, free, changing);
        (self.factor, self.kept) = (Vec::new(), Vec::new());
    }

    fn factor(&mut self, matrix: &BlockMatrix) -> Result<(), Singular> {
        assert_eq!(self.symbolic.masks.len(), matrix.pattern.nodes(), "the pattern was analysed");
        let fresh = self.factor.len() != self.symbolic.values;
        if fresh {
            self.factor = vec![0.0; self.symbolic.values];
        }
        self.kept = self.symbolic.supernodes.iter().map(|_| Kept::new()).collect();
        self.eliminate(matrix, false, fresh)
    }

    fn factor_again(&mut self, matrix: &BlockMatrix) -> Result<(), Singular> {
        self.eliminate(matrix, true, false)
    }

    fn solve(&self, x: &mut [f64]) {
        let mut inner: Vec<f64> = self.symbolic.freedoms.iter().map(|&freedom| x[freedom as usize]).collect();
        Substitution { symbolic: &self.symbolic, factor: &self.factor, right: 1 }.solve(&mut inner);
        x.fill(0.0);
        for (value, &freedom) in inner.into_iter().zip(&self.symbolic.freedoms) {
            x[freedom as usize] = value;
        }
    }

    fn cost(&self) -> Cost {
        let symbolic = &self.symbolic;
        let (flops, flops_again) = (symbolic.flops(), symbolic.flops_again());
        Cost { unknowns: symbolic.freedoms.len(), factor_entries: symbolic.entries, flops, flops_again }
    }
}

/// Of each unknown, in the order of elimination, the pivot at or below which nothing holds it: what rounding may leave
/// of its diagonal entry. The bound is (n + 1) u Kⱼⱼ (Higham 2002, theorem 10.3); bodies without supports of 10³ to
/// 3·10⁴ unknowns were seen to leave 0.1 to 0.3 of it, a beam 1000 times as long as thick 8·10⁻⁹ Kⱼⱼ.
fn least_pivots(symbolic: &Symbolic, matrix: &BlockMatrix) -> Vec<f64> {
    const MARGIN: f64 = 4.0;
    const FEWEST: usize = 100; // unknowns, where the bound leaves no room for error in the entries themselves
    let unit = f64::EPSILON / 2.0;
    let part = MARGIN * unit * symbolic.freedoms.len().max(FEWEST) as f64;
    let diagonal = matrix.diagonal();
    symbolic.freedoms.iter().map(|&freedom| part * diagonal[freedom as usize].max(0.0)).collect()
}
