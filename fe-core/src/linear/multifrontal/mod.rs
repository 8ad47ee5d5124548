//! The multifrontal Cholesky factorisation (Duff & Reid 1983; Liu 1992).
//!
//! The node graph is ordered by nested dissection; columns of like structure are eliminated together as one dense
//! front, which leaves a dense update to its parent in the elimination tree. Subtrees run side by side, and near the
//! roots the tiles of a front; both are cut in a fixed way, so the bits do not depend on the number of threads.

mod dense;
mod front;
mod layout;
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
use front::{Fronts, Pool, Update};
use solve::Substitution;
use std::sync::Arc;
use symbolic::Symbolic;
use walk::Walk;

/// A pivot of at most this part of the matrix's own diagonal entry counts as vanished.
const VANISHED: f64 = 1e-14;

/// LLᵀ factor of K_ff, the free part of a positive definite matrix.
#[derive(Default)]
pub struct Multifrontal {
    symbolic: Symbolic,
    factor: Vec<f64>,
}

impl Multifrontal {
    /// Nothing analysed yet.
    pub fn new() -> Self {
        Multifrontal::default()
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
    fn analyse(&mut self, pattern: &Arc<Pattern>, free: &[bool]) {
        self.symbolic = Symbolic::new(pattern, free);
        self.factor = Vec::new();
    }

    fn factor(&mut self, matrix: &BlockMatrix) -> Result<(), Singular> {
        assert_eq!(self.symbolic.masks.len(), matrix.pattern.nodes(), "the pattern was analysed");
        let symbolic = &self.symbolic;
        if self.factor.len() != symbolic.values {
            self.factor = vec![0.0; symbolic.values];
        }
        let least = least_pivots(symbolic, matrix);
        let fronts = Fronts { symbolic, matrix, least: &least, pool: &Pool::default() };
        let visit = |s: usize, own: &mut [f64], stack: &mut Vec<Update>| fronts.visit(s, own, stack);
        Walk::new(symbolic, |s| symbolic.value_start(s))
            .up(&mut self.factor, &visit)
            .map_err(|unknown| Singular { freedom: symbolic.freedoms[unknown] as usize })
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
        Cost { unknowns: symbolic.freedoms.len(), factor_entries: symbolic.entries, flops: symbolic.flops() }
    }
}

/// Of each unknown, in the order of elimination, the pivot at or below which nothing holds it.
fn least_pivots(symbolic: &Symbolic, matrix: &BlockMatrix) -> Vec<f64> {
    let diagonal = matrix.diagonal();
    symbolic.freedoms.iter().map(|&freedom| VANISHED * diagonal[freedom as usize].max(0.0)).collect()
}
