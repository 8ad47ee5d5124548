//! Linear systems: what the procedures ask of a solver.

use crate::matrix::{BlockMatrix, Pattern};
use std::sync::Arc;

/// Nothing holds a freedom: a pivot vanished.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singular {
    /// Index of the freedom.
    pub freedom: usize,
}

/// What a factorisation cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Unknowns after the prescribed freedoms are left out.
    pub unknowns: usize,
    /// Numbers in the factor.
    pub factor_entries: usize,
    /// Multiplications and additions of a factorisation.
    pub flops: f64,
    /// Those of a factorisation again, after blocks between changing nodes have changed.
    pub flops_again: f64,
}

/// A solver of K_ff x_f = b_f, f being the free freedoms.
pub trait LinearSolver: Send {
    /// The symbolic part, kept while pattern and free freedoms stay. Nodes are `changing` when blocks between two of
    /// them differ from one factorisation to the next, `[nodes]`.
    fn analyse(&mut self, pattern: &Arc<Pattern>, free: &[bool], changing: &[bool]);

    /// The numerical factor. Same bits for any number of threads.
    fn factor(&mut self, matrix: &BlockMatrix) -> Result<(), Singular>;

    /// The same after a factorisation that did not fail, of a matrix that differs from that one only in blocks between
    /// two changing nodes. Same bits as [`LinearSolver::factor`].
    fn factor_again(&mut self, matrix: &BlockMatrix) -> Result<(), Singular>;

    /// Solves in place: `x` holds the right-hand side over all freedoms and receives the answer; entries of
    /// freedoms that are not free are ignored and set to zero.
    fn solve(&self, x: &mut [f64]);

    /// What the factorisation costs.
    fn cost(&self) -> Cost;
}

pub mod gmres;
pub mod multifrontal;
pub mod ordering;

pub use multifrontal::Multifrontal;
