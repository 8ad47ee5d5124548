//! Which blocks of the stiffness exist.

use crate::freedoms::Freedoms;

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

    /// True for each node that is in a group.
    pub fn touched(&self) -> Vec<bool> {
        let mut touched = vec![false; self.nodes];
        self.groups.iter().for_each(|&node| touched[node as usize] = true);
        touched
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

    /// Numbers that a matrix of this pattern holds.
    pub fn values(&self) -> usize {
        self.value_start[self.columns.len()]
    }

    /// Memory of the pattern itself [bytes]; the freedoms, which the scene has in any case, are left out.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.row_start) + size_of_val(&*self.columns) + size_of_val(&*self.value_start)
    }

    /// Index of block (i, j), `j ≤ i`, if it exists.
    pub fn block(&self, i: u32, j: u32) -> Option<usize> {
        let row = self.row_start[i as usize]..self.row_start[i as usize + 1];
        self.columns[row.clone()].binary_search(&j).ok().map(|k| row.start + k)
    }
}
