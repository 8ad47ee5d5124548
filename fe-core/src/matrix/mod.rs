//! The symmetric stiffness over all freedoms, in dense blocks of node by node.

mod pattern;
mod scatter;

pub use pattern::{Couplings, Pattern};
pub use scatter::Scatter;

use std::sync::Arc;

/// A symmetric matrix with a [`Pattern`]; only the lower triangle is stored (diagonal blocks in full).
#[derive(Clone, Debug)]
pub struct BlockMatrix {
    /// The pattern, shared by all matrices of a step.
    pub pattern: Arc<Pattern>,
    /// Values block by block.
    pub values: Vec<f64>,
}

impl BlockMatrix {
    /// All zero.
    pub fn zero(pattern: Arc<Pattern>) -> Self {
        let values = vec![0.0; pattern.values()];
        BlockMatrix { pattern, values }
    }

    /// Adds `block`, row-major `[freedoms of i × freedoms of j]`, to the place (i, j); where `i < j` its
    /// transpose goes to (j, i). Symmetric pairs are added once. Ignores nodes without freedoms.
    ///
    /// # Panics
    /// When the nodes were not coupled.
    pub fn add_block(&mut self, i: u32, j: u32, block: &[f64]) {
        if block.is_empty() {
            return;
        }
        let (row, column) = (i.max(j), i.min(j));
        let k = self.pattern.block(row, column).expect("the nodes of a stiffness block are coupled");
        let start = self.pattern.value_start[k];
        let target = &mut self.values[start..start + block.len()];
        if i >= j {
            target.iter_mut().zip(block).for_each(|(t, b)| *t += b);
        } else {
            let columns = self.pattern.freedoms.of_node(i as usize).len();
            let rows = block.len() / columns;
            for r in 0..rows {
                for c in 0..columns {
                    target[r * columns + c] += block[c * rows + r];
                }
            }
        }
    }

    /// `y += K x`.
    pub fn multiply_add(&self, x: &[f64], y: &mut [f64]) {
        self.accumulate(x, y, |v| v);
    }

    /// Σⱼ |Kᵢⱼ||xⱼ| for every i: what rounding errors of K x are measured by.
    pub fn absolute_product(&self, x: &[f64]) -> Vec<f64> {
        let x: Vec<f64> = x.iter().map(|v| v.abs()).collect();
        let mut y = vec![0.0; x.len()];
        self.accumulate(&x, &mut y, f64::abs);
        y
    }

    /// `y += f(K) x`, f entry by entry.
    #[inline(always)]
    fn accumulate(&self, x: &[f64], y: &mut [f64], f: impl Fn(f64) -> f64) {
        let p = &*self.pattern;
        for i in 0..p.nodes() {
            let rows = p.freedoms.of_node(i);
            for k in p.row_start[i]..p.row_start[i + 1] {
                let j = p.columns[k] as usize;
                let columns = p.freedoms.of_node(j);
                let block = &self.values[p.value_start[k]..p.value_start[k + 1]];
                for (r, values) in rows.clone().zip(block.chunks_exact(columns.len())) {
                    let xr = x[r];
                    let mut sum = 0.0;
                    for (c, v) in columns.clone().zip(values) {
                        let v = f(*v);
                        sum += v * x[c];
                        if j != i {
                            y[c] += v * xr;
                        }
                    }
                    y[r] += sum;
                }
            }
        }
    }

    /// The block of a node with itself, row-major over its freedoms; empty where it has none.
    pub fn of_node(&self, node: usize) -> &[f64] {
        let p = &*self.pattern;
        match p.freedoms.of_node(node).len() {
            0 => &[],
            n => &self.values[p.value_start[p.row_start[node + 1] - 1]..][..n * n],
        }
    }

    /// Diagonal entry of each freedom.
    pub fn diagonal(&self) -> Vec<f64> {
        let p = &*self.pattern;
        let entries = |i: usize| {
            let n = p.freedoms.of_node(i).len();
            (0..n).map(move |r| self.of_node(i)[r * n + r])
        };
        (0..p.nodes()).flat_map(entries).collect()
    }

    /// Largest diagonal entry.
    pub fn largest_diagonal(&self) -> f64 {
        self.diagonal().into_iter().fold(0.0, |largest, v| largest.max(v.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::freedoms::Freedoms;

    #[test]
    fn blocks_land_where_they_belong_and_the_product_is_symmetric() {
        let freedoms = Freedoms::new(&[0b11, 0, 0b1, 0b111]);
        let mut couplings = Couplings::new(4);
        couplings.add(&[3, 0, 1]);
        couplings.add(&[2]);
        let pattern = Arc::new(Pattern::new(&freedoms, &couplings));
        assert_eq!(pattern.columns, [0, 2, 0, 3]);
        let mut k = BlockMatrix::zero(pattern);
        let b = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        k.add_block(3, 0, &b); // 3 × 2
        k.add_block(0, 3, &[1.0, 3.0, 5.0, 2.0, 4.0, 6.0]); // its transpose
        let mut y = vec![0.0; 6];
        k.multiply_add(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0], &mut y);
        assert_eq!(y, [6.0, 8.0, 0.0, 2.0, 6.0, 10.0]);
        let flipped = BlockMatrix { pattern: k.pattern.clone(), values: k.values.iter().map(|v| -v).collect() };
        assert_eq!(flipped.absolute_product(&[-1.0, 0.0, 0.0, 0.0, 1.0, 0.0]), y);
    }
}
