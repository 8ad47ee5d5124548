//! Forward elimination and back substitution over the tree.

use super::symbolic::{Supernode, Symbolic};
use super::trapezoid::Panel;
use super::walk::Walk;
use faer::linalg::{matmul, triangular_solve};
use faer::{Accum, MatMut, MatRef, Par};

/// A factor, and right-hand sides side by side: `right` numbers an unknown.
pub(super) struct Substitution<'a> {
    pub symbolic: &'a Symbolic,
    pub factor: &'a [f64],
    pub right: usize,
}

impl Substitution<'_> {
    /// Solves in place; `x` is `[unknowns × right]`, in the order of elimination.
    pub fn solve(&self, x: &mut [f64]) {
        let tree = self.symbolic;
        let walk = Walk::new(tree, |s| self.right * tree.unknown_start(s));
        let up: Result<(), std::convert::Infallible> = walk.up(x, &|s, own: &mut [f64], stack| {
            self.forward(s, own, stack);
            Ok(())
        });
        match up {
            Ok(()) => walk.down(x, &|s, own: &mut [f64], above| self.backward(s, own, above)),
        }
    }

    fn panels(&self, node: &Supernode) -> impl DoubleEndedIterator<Item = (Panel, &[f64])> {
        let values = &self.factor[node.values..];
        node.factor().panels().map(move |panel| (panel, &values[panel.start..panel.start + panel.len()]))
    }

    /// Leaves the sum that the later unknowns have to be corrected by.
    fn forward(&self, s: usize, own: &mut [f64], stack: &mut Vec<Vec<f64>>) {
        let (node, k) = (&self.symbolic.supernodes[s], self.right);
        let mut front = vec![0.0; node.rows * k];
        front[..own.len()].copy_from_slice(own);
        for (&child, left) in node.children.iter().zip(stack.drain(stack.len() - node.children.len()..)) {
            for run in &self.symbolic.supernodes[child as usize].runs {
                let (from, to, length) = (run.from as usize * k, run.to as usize * k, run.length as usize * k);
                front[to..to + length].iter_mut().zip(&left[from..from + length]).for_each(|(t, s)| *t += s);
            }
        }
        for (panel, values) in self.panels(node) {
            let part = &mut front[panel.first * k..];
            if k == 1 { forward_one(panel, values, part) } else { forward_many(panel, values, part, k) }
        }
        own.copy_from_slice(&front[..own.len()]);
        front.drain(..own.len());
        stack.push(front);
    }

    /// Leaves the answer at all unknowns of the front.
    fn backward(&self, s: usize, own: &mut [f64], above: Option<&Vec<f64>>) -> Vec<f64> {
        let (node, k) = (&self.symbolic.supernodes[s], self.right);
        let mut front = Vec::with_capacity(node.rows * k);
        front.extend_from_slice(own);
        for run in &node.runs {
            let above = above.expect("only a supernode with a parent leaves unknowns behind");
            front.extend_from_slice(&above[run.to as usize * k..(run.to + run.length) as usize * k]);
        }
        for (panel, values) in self.panels(node).rev() {
            let part = &mut front[panel.first * k..];
            if k == 1 { backward_one(panel, values, part) } else { backward_many(panel, values, part, k) }
        }
        own.copy_from_slice(&front[..own.len()]);
        front
    }
}

/// `x₁ ← L₁⁻¹ x₁`, `x₂ ← x₂ − L₂ x₁`.
fn forward_one(panel: Panel, values: &[f64], x: &mut [f64]) {
    pulp::Arch::new().dispatch(|| {
        for (j, column) in values.chunks_exact(panel.height).enumerate() {
            let answer = x[j] / column[j];
            x[j] = answer;
            x[j + 1..].iter_mut().zip(&column[j + 1..]).for_each(|(t, l)| *t -= l * answer);
        }
    });
}

/// `x₁ ← L₁⁻ᵀ (x₁ − L₂ᵀ x₂)`.
fn backward_one(panel: Panel, values: &[f64], x: &mut [f64]) {
    pulp::Arch::new().dispatch(|| {
        for (j, column) in values.chunks_exact(panel.height).enumerate().rev() {
            x[j] = (x[j] - dot(&column[j + 1..], &x[j + 1..])) / column[j];
        }
    });
}

/// Eight partial sums, so that the compiler may keep them in vector registers.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let b = &b[..a.len()];
    let (mut sums, whole) = ([0.0; LANES], a.len() - a.len() % LANES);
    for (a, b) in a[..whole].chunks_exact(LANES).zip(b[..whole].chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = a[whole..].iter().zip(&b[whole..]).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// [`forward_one`] for `k` right-hand sides, row-major.
fn forward_many(panel: Panel, values: &[f64], x: &mut [f64], k: usize) {
    let (diagonal, below) =
        MatRef::from_column_major_slice(values, panel.height, panel.width).split_at_row(panel.width);
    let (mut top, bottom) = MatMut::from_row_major_slice_mut(x, panel.height, k).split_at_row_mut(panel.width);
    triangular_solve::solve_lower_triangular_in_place(diagonal, top.as_mut(), Par::Seq);
    matmul::matmul(bottom, Accum::Add, below, top.as_ref(), -1.0, Par::Seq);
}

/// [`backward_one`] for `k` right-hand sides, row-major.
fn backward_many(panel: Panel, values: &[f64], x: &mut [f64], k: usize) {
    let (diagonal, below) =
        MatRef::from_column_major_slice(values, panel.height, panel.width).split_at_row(panel.width);
    let (mut top, bottom) = MatMut::from_row_major_slice_mut(x, panel.height, k).split_at_row_mut(panel.width);
    matmul::matmul(top.as_mut(), Accum::Add, below.transpose(), bottom.as_ref(), -1.0, Par::Seq);
    triangular_solve::solve_upper_triangular_in_place(diagonal.transpose(), top, Par::Seq);
}
