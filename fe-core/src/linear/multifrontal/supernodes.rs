//! Supernodes: columns of (nearly) the same structure, eliminated together as one dense front.

use super::tree::{Columns, NONE, postorder};
use crate::linear::ordering::Graph;

/// A child is merged into its parent when the front then has at most so many columns [unknowns] and at most
/// such a part of its numbers are zeros. Dense kernels on a few wide fronts outrun exact ones on many narrow ones.
const RELAXED: [(u64, f64); 5] = [(24, 1.0), (48, 0.6), (96, 0.3), (192, 0.1), (u64::MAX, 0.03)];

/// The tree of supernodes, children before parents, subtrees together.
pub(super) struct Supernodes {
    /// Vertex of each column, supernode by supernode.
    pub order: Vec<u32>,
    /// First column of each supernode; one more at the end.
    pub first: Vec<u32>,
    /// Parent supernode or `NONE`.
    pub parent: Vec<u32>,
}

/// A supernode while supernodes are being merged; sizes in unknowns.
#[derive(Clone, Default)]
struct Merging {
    columns: u64,
    rows_below: u64,
    zeros: u64,
    children: Vec<u32>,
    /// The parent it was merged into, `NONE` while it stands for itself.
    merged_into: u32,
}

impl Merging {
    /// Zeros in the front that this and `child` would make.
    fn zeros_with(&self, child: &Merging) -> u64 {
        self.zeros + child.zeros + child.columns * (self.columns + self.rows_below).saturating_sub(child.rows_below)
    }

    fn accepts(&self, child: &Merging) -> bool {
        let zeros = self.zeros_with(child);
        let columns = self.columns + child.columns;
        let numbers = columns * (columns + 1) / 2 + columns * self.rows_below;
        zeros == self.zeros + child.zeros
            || RELAXED.iter().any(|&(width, part)| columns <= width && zeros as f64 <= part * numbers as f64)
    }
}

impl Supernodes {
    /// Of a graph's columns.
    pub fn new(graph: &Graph, columns: &Columns) -> Self {
        let first = fundamental(graph, columns);
        let parent = supernode_parents(columns, &first);
        let merging = merge(graph, columns, &first, &parent);
        arrange(columns, &first, &parent, &merging)
    }
}

/// First columns of the supernodes whose columns have exactly the same structure below.
fn fundamental(graph: &Graph, columns: &Columns) -> Vec<u32> {
    let n = columns.order.len();
    let mut first: Vec<u32> = (0..n.min(1) as u32).collect();
    for j in 1..n {
        let before = graph.weights[columns.order[j - 1] as usize] as u32;
        if columns.parent[j - 1] != j as u32 || columns.count[j - 1] != columns.count[j] + before {
            first.push(j as u32);
        }
    }
    first.push(n as u32);
    first
}

fn supernode_parents(columns: &Columns, first: &[u32]) -> Vec<u32> {
    let holder = |column: u32| first.partition_point(|&f| f <= column) as u32 - 1;
    first[1..]
        .iter()
        .map(|&end| match columns.parent[end as usize - 1] {
            NONE => NONE,
            p => holder(p),
        })
        .collect()
}

/// Merges children into parents from the leaves upwards, those first that add the fewest zeros.
fn merge(graph: &Graph, columns: &Columns, first: &[u32], parent: &[u32]) -> Vec<Merging> {
    let mut nodes = vec![Merging::default(); parent.len()];
    for (s, &p) in parent.iter().enumerate() {
        let own = first[s] as usize..first[s + 1] as usize;
        nodes[s].columns = columns.order[own.clone()].iter().map(|&v| graph.weights[v as usize] as u64).sum();
        nodes[s].rows_below = columns.count[own.start] as u64 - nodes[s].columns;
        nodes[s].merged_into = NONE;
        if p != NONE {
            nodes[p as usize].children.push(s as u32);
        }
    }
    for s in 0..nodes.len() {
        let mut node = std::mem::take(&mut nodes[s]);
        loop {
            let mut candidates = std::mem::take(&mut node.children);
            candidates.sort_by_key(|&c| (node.zeros_with(&nodes[c as usize]), c));
            let before = node.columns;
            for c in candidates {
                let child = &mut nodes[c as usize];
                if node.accepts(child) {
                    node.zeros = node.zeros_with(child);
                    node.columns += child.columns;
                    child.merged_into = s as u32;
                    let inherited = std::mem::take(&mut child.children);
                    node.children.extend(inherited);
                } else {
                    node.children.push(c);
                }
            }
            if node.columns == before {
                break;
            }
        }
        nodes[s] = node;
    }
    nodes
}

/// Numbers the merged supernodes so that brothers come in the order that needs the least memory (Liu 1986):
/// those first whose own elimination needs most beyond what it leaves behind.
fn arrange(columns: &Columns, first: &[u32], parent: &[u32], merging: &[Merging]) -> Supernodes {
    let mut top: Vec<u32> = (0..parent.len() as u32).collect();
    for s in (0..parent.len()).rev() {
        if merging[s].merged_into != NONE {
            top[s] = top[merging[s].merged_into as usize];
        }
    }
    let heads: Vec<u32> = (0..parent.len() as u32).filter(|&s| top[s as usize] == s).collect();
    let mut place = vec![NONE; parent.len()];
    heads.iter().enumerate().for_each(|(k, &s)| place[s as usize] = k as u32);
    let parent: Vec<u32> = heads
        .iter()
        .map(|&s| match parent[s as usize] {
            NONE => NONE,
            p => place[top[p as usize] as usize],
        })
        .collect();
    let mut members = vec![Vec::new(); heads.len()];
    (0..top.len()).for_each(|s| members[place[top[s] as usize] as usize].push(s));

    let below: Vec<i64> = heads.iter().map(|&s| merging[s as usize].rows_below as i64).collect();
    let excess = memory_excess(&parent, &below);
    let sequence = postorder(&parent, |s| -excess[s as usize]);
    let position = super::tree::places(&sequence);
    let mut arranged =
        Supernodes { order: Vec::with_capacity(columns.order.len()), first: vec![0], parent: Vec::new() };
    for &h in &sequence {
        for &s in &members[h as usize] {
            arranged.order.extend(&columns.order[first[s] as usize..first[s + 1] as usize]);
        }
        arranged.first.push(arranged.order.len() as u32);
        let p = parent[h as usize];
        arranged.parent.push(if p == NONE { NONE } else { position[p as usize] });
    }
    arranged
}

/// For each supernode the most numbers alive while its subtree is eliminated, less those it leaves behind.
fn memory_excess(parent: &[u32], below: &[i64]) -> Vec<i64> {
    let left = |s: usize| below[s] * (below[s] + 1) / 2;
    let mut children = vec![Vec::new(); parent.len()];
    let mut excess = vec![0; parent.len()];
    for s in 0..parent.len() {
        let mut brothers: Vec<usize> = std::mem::take(&mut children[s]);
        brothers.sort_by_key(|&c| -excess[c]);
        let (mut alive, mut most) = (0, 0);
        for c in brothers {
            most = most.max(alive + left(c) + excess[c]);
            alive += left(c);
        }
        excess[s] = most.max(alive + left(s)) - left(s);
        if parent[s] != NONE {
            children[parent[s] as usize].push(s);
        }
    }
    excess
}
