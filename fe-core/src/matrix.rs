//! The symmetric stiffness over all freedoms, in dense blocks of node by node.

use crate::freedoms::Freedoms;
use std::sync::Arc;

/// Collects which nodes are coupled with which, term by term.
pub struct Couplings {
    nodes: usize,
    groups: Vec<u32>,
    starts: Vec<u32>,
}

impl Couplings {
    /// None yet, among `nodes` nodes.
    pub fn new(nodes: usize) -> Self {
        Couplings { nodes, groups: Vec::new(), starts: vec![0] }
    }

    /// Every node of `group` is coupled with every other (an element, a contact point with its neighbours).
    pub fn add(&mut self, group: &[u32]) {
        self.groups.extend_from_slice(group);
        self.starts.push(self.groups.len() as u32);
    }

    /// Adds many groups of `size` nodes each, side by side in `nodes`.
    pub fn add_all(&mut self, nodes: &[u32], size: usize) {
        for group in nodes.chunks_exact(size) {
            self.add(group);
        }
    }

    fn group(&self, g: u32) -> &[u32] {
        &self.groups[self.starts[g as usize] as usize..self.starts[g as usize + 1] as usize]
    }
}

/// Which blocks of the lower triangle exist: for each node the nodes `j ≤ i` it is coupled with, ascending,
/// itself last.
#[derive(Debug, PartialEq)]
pub struct Pattern {
    /// The freedoms that the rows are.
    pub freedoms: Freedoms,
    /// Row `i` holds the blocks `row_start[i]..row_start[i + 1]`.
    pub row_start: Vec<usize>,
    /// Column node of each block.
    pub columns: Vec<u32>,
    /// Where each block's values start, row-major `[freedoms of i × freedoms of j]`; one more at the end.
    pub value_start: Vec<usize>,
}

impl Pattern {
    /// From the couplings of all terms. A node with freedoms always has its diagonal block.
    pub fn new(freedoms: &Freedoms, couplings: &Couplings) -> Self {
        let n = couplings.nodes;
        let mut count = vec![0u32; n + 1];
        for &v in &couplings.groups {
            count[v as usize + 1] += 1;
        }
        for i in 0..n {
            count[i + 1] += count[i];
        }
        let mut groups_of = vec![0u32; couplings.groups.len()];
        let mut next = count.clone();
        for g in 0..couplings.starts.len() as u32 - 1 {
            for &v in couplings.group(g) {
                groups_of[next[v as usize] as usize] = g;
                next[v as usize] += 1;
            }
        }
        let (mut row_start, mut columns, mut value_start) = (vec![0], Vec::new(), vec![0]);
        let mut seen = vec![u32::MAX; n];
        for i in 0..n {
            let rows = freedoms.of_node(i).len();
            let first = columns.len();
            if rows > 0 {
                columns.push(i as u32);
                seen[i] = i as u32;
                for &g in &groups_of[count[i] as usize..count[i + 1] as usize] {
                    for &j in couplings.group(g) {
                        if j < i as u32 && seen[j as usize] != i as u32 && !freedoms.of_node(j as usize).is_empty() {
                            seen[j as usize] = i as u32;
                            columns.push(j);
                        }
                    }
                }
                columns[first..].sort_unstable();
            }
            for &j in &columns[first..] {
                value_start.push(value_start[value_start.len() - 1] + rows * freedoms.of_node(j as usize).len());
            }
            row_start.push(columns.len());
        }
        Pattern { freedoms: freedoms.clone(), row_start, columns, value_start }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.row_start.len() - 1
    }

    /// Index of block (i, j), `j ≤ i`, if it exists.
    pub fn block(&self, i: u32, j: u32) -> Option<usize> {
        let row = self.row_start[i as usize]..self.row_start[i as usize + 1];
        self.columns[row.clone()].binary_search(&j).ok().map(|k| row.start + k)
    }
}

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
        let values = vec![0.0; pattern.value_start[pattern.columns.len()]];
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

    /// Largest diagonal entry.
    pub fn largest_diagonal(&self) -> f64 {
        let p = &*self.pattern;
        let mut largest: f64 = 0.0;
        for i in 0..p.nodes() {
            let n = p.freedoms.of_node(i).len();
            if n > 0 {
                let block = &self.values[p.value_start[p.row_start[i + 1] - 1]..];
                (0..n).for_each(|r| largest = largest.max(block[r * n + r].abs()));
            }
        }
        largest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    }
}
