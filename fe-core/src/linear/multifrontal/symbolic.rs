//! All of a factorisation that depends only on which blocks exist and which freedoms are free.

use super::changing;
use super::layout::{Entering, lay_out};
use super::supernodes::Supernodes;
use super::trapezoid::Trapezoid;
use super::tree::NONE;
use crate::linear::ordering::Graph;
use crate::matrix::Pattern;

/// A supernode. Its front is a dense lower triangle of `rows` unknowns: first its own `columns`, which are
/// eliminated, then those of later supernodes that they are coupled with.
#[derive(Clone, Debug, Default)]
pub(super) struct Supernode {
    /// Its first unknown in the order of elimination.
    pub unknown: usize,
    /// Unknowns eliminated here.
    pub columns: usize,
    /// Unknowns in the front.
    pub rows: usize,
    /// Where its part of the factor starts.
    pub values: usize,
    /// First supernode of its subtree, which ends with itself.
    pub subtree: usize,
    /// Children in the tree, which stand before it in this order.
    pub children: Vec<u32>,
    /// Multiplications and additions in the whole subtree.
    pub flops: f64,
    /// True when a node eliminated here or below is a changing one.
    pub changes: bool,
    /// Where the unknowns it leaves behind stand in its parent's front.
    pub runs: Vec<Run>,
    /// Blocks of the matrix that enter here, by ascending column.
    pub entries: Vec<Entry>,
}

impl Supernode {
    /// The part of the front that becomes the factor.
    pub fn factor(&self) -> Trapezoid {
        Trapezoid { rows: self.rows, columns: self.columns }
    }

    /// The part of the front that is left for the parent.
    pub fn update(&self) -> Trapezoid {
        Trapezoid { rows: self.rows - self.columns, columns: self.rows - self.columns }
    }
}

/// Consecutive unknowns left behind that are consecutive in the parent's front, too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Run {
    /// First one among those left behind.
    pub from: u32,
    /// First one in the parent's front.
    pub to: u32,
    /// Number of unknowns.
    pub length: u32,
}

/// A block of the matrix and where its free rows and columns start in the front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    /// Index in the pattern.
    pub block: u32,
    /// Node of its rows.
    pub row_node: u32,
    /// First row in the front.
    pub row: u32,
    /// First column in the front.
    pub column: u32,
    /// True when the node of its columns is eliminated later.
    pub transposed: bool,
}

/// The symbolic factorisation.
#[derive(Debug, Default)]
pub(super) struct Symbolic {
    /// Freedom of each unknown, in the order of elimination.
    pub freedoms: Vec<u32>,
    /// Bit k of a node's mask: its k-th freedom is free.
    pub masks: Vec<u8>,
    /// Children before parents.
    pub supernodes: Vec<Supernode>,
    /// The supernodes without parent.
    pub roots: Vec<u32>,
    /// Numbers stored for the factor.
    pub values: usize,
    /// Numbers in the lower triangle of the factor.
    pub entries: usize,
    /// Multiplications and additions in the supernodes that change.
    flops_again: f64,
}

impl Symbolic {
    /// For the free freedoms of a pattern; `changing` tells the nodes among which blocks change.
    pub fn new(pattern: &Pattern, free: &[bool], changing: &[bool]) -> Self {
        let masks = free_masks(pattern, free);
        let (graph, nodes) = node_graph(pattern, &masks);
        let changing: Vec<bool> = nodes.iter().map(|&node| changing[node as usize]).collect();
        let columns = changing::columns(&graph, &changing);
        let supernodes = Supernodes::new(&graph, &columns);
        let order: Vec<u32> = supernodes.order.iter().map(|&v| nodes[v as usize]).collect();
        let freedoms = order
            .iter()
            .flat_map(|&node| pattern.freedoms.of_node(node as usize).filter(|&f| free[f]).map(|f| f as u32))
            .collect();
        let roots = (0..supernodes.parent.len() as u32).filter(|&s| supernodes.parent[s as usize] == NONE).collect();
        let entering = Entering::new(pattern, &masks, &order);
        let mut fronts = lay_out(&graph, &supernodes, &entering);
        for (front, own) in fronts.iter_mut().zip(supernodes.first.windows(2)) {
            front.changes = supernodes.order[own[0] as usize..own[1] as usize].iter().any(|&v| changing[v as usize]);
        }
        let mut symbolic = Symbolic { freedoms, masks, supernodes: fronts, roots, ..Symbolic::default() };
        symbolic.finish(&supernodes.parent);
        symbolic
    }

    /// Where the factor of supernode `s` starts; past the last one, where it ends.
    pub fn value_start(&self, s: usize) -> usize {
        self.supernodes.get(s).map_or(self.values, |node| node.values)
    }

    /// First unknown of supernode `s`, or their number past the last one.
    pub fn unknown_start(&self, s: usize) -> usize {
        self.supernodes.get(s).map_or(self.freedoms.len(), |node| node.unknown)
    }

    /// Multiplications and additions of one factorisation.
    pub fn flops(&self) -> f64 {
        self.roots.iter().map(|&s| self.supernodes[s as usize].flops).sum()
    }

    /// Multiplications and additions of a factorisation again.
    pub fn flops_again(&self) -> f64 {
        self.flops_again
    }

    /// Sums over the tree.
    fn finish(&mut self, parent: &[u32]) {
        for (s, &above) in parent.iter().enumerate() {
            let node = &mut self.supernodes[s];
            node.values = self.values;
            self.values += node.factor().len();
            self.entries += node.columns * (2 * node.rows - node.columns + 1) / 2;
            let own: f64 = (0..node.columns).map(|k| ((node.rows - k) as f64).powi(2)).sum();
            node.flops += own;
            self.flops_again += if node.changes { own } else { 0.0 };
            let (subtree, flops, changes) = (node.subtree, node.flops, node.changes);
            if above != NONE {
                let above = &mut self.supernodes[above as usize];
                above.flops += flops;
                above.changes |= changes;
                above.subtree = above.subtree.min(subtree);
                above.children.push(s as u32);
            }
        }
    }
}

fn free_masks(pattern: &Pattern, free: &[bool]) -> Vec<u8> {
    (0..pattern.nodes())
        .map(|node| pattern.freedoms.of_node(node).enumerate().fold(0, |mask, (k, f)| mask | (free[f] as u8) << k))
        .collect()
}

/// The graph among the nodes with a free freedom, and which nodes these are.
fn node_graph(pattern: &Pattern, masks: &[u8]) -> (Graph, Vec<u32>) {
    let nodes: Vec<u32> = (0..masks.len() as u32).filter(|&i| masks[i as usize] != 0).collect();
    let mut vertex = vec![NONE; masks.len()];
    nodes.iter().enumerate().for_each(|(k, &node)| vertex[node as usize] = k as u32);
    let edges = || {
        nodes.iter().flat_map(|&i| {
            let row = pattern.row_start[i as usize]..pattern.row_start[i as usize + 1];
            pattern.columns[row].iter().filter(move |&&j| j != i).map(move |&j| (i, j))
        })
    };
    let ends = || edges().map(|(i, j)| (vertex[i as usize], vertex[j as usize])).filter(|e| e.1 != NONE);
    let mut start = vec![0i32; nodes.len() + 1];
    for (a, b) in ends() {
        start[a as usize + 1] += 1;
        start[b as usize + 1] += 1;
    }
    for k in 0..nodes.len() {
        start[k + 1] += start[k];
    }
    let mut next = start.clone();
    let mut neighbours = vec![0; start[nodes.len()] as usize];
    for (a, b) in ends() {
        for (from, to) in [(a, b), (b, a)] {
            neighbours[next[from as usize] as usize] = to as i32;
            next[from as usize] += 1;
        }
    }
    let weights = nodes.iter().map(|&i| masks[i as usize].count_ones() as i32).collect();
    (Graph { start, neighbours, weights }, nodes)
}
