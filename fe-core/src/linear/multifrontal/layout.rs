//! Lays out the fronts: which unknowns stand where, and what enters from the matrix and from the children.

use super::supernodes::Supernodes;
use super::symbolic::{Entry, Run, Supernode};
use super::tree::{NONE, places};
use crate::linear::ordering::Graph;
use crate::matrix::Pattern;

/// The blocks of the matrix by the column in which they enter.
pub(super) struct Entering {
    start: Vec<u32>,
    blocks: Vec<Block>,
}

/// A block of the matrix, `later` being the column of the one of its nodes that is eliminated later.
#[derive(Clone, Copy, Default)]
struct Block {
    index: u32,
    row_node: u32,
    later: u32,
    transposed: bool,
}

impl Entering {
    /// Of all blocks between nodes with a free freedom; `order` holds the node of each column.
    pub fn new(pattern: &Pattern, masks: &[u8], order: &[u32]) -> Self {
        let mut place = vec![NONE; pattern.nodes()];
        order.iter().enumerate().for_each(|(k, &node)| place[node as usize] = k as u32);
        let rows = || (0..pattern.nodes()).filter(|&i| masks[i] != 0);
        let blocks = || {
            rows().flat_map(|i| (pattern.row_start[i]..pattern.row_start[i + 1]).map(move |k| (i, k))).filter_map(
                |(i, k)| {
                    let (row, column) = (place[i], place[pattern.columns[k] as usize]);
                    let block =
                        Block { index: k as u32, row_node: i as u32, later: row.max(column), transposed: column > row };
                    (column != NONE).then_some((row.min(column) as usize, block))
                },
            )
        };
        let mut start = vec![0u32; order.len() + 1];
        blocks().for_each(|(earlier, _)| start[earlier + 1] += 1);
        (0..order.len()).for_each(|k| start[k + 1] += start[k]);
        let mut next = start.clone();
        let mut sorted = vec![Block::default(); start[order.len()] as usize];
        for (earlier, block) in blocks() {
            sorted[next[earlier] as usize] = block;
            next[earlier] += 1;
        }
        Entering { start, blocks: sorted }
    }

    fn of(&self, column: u32) -> &[Block] {
        &self.blocks[self.start[column as usize] as usize..self.start[column as usize + 1] as usize]
    }
}

/// The fronts of all supernodes, children before parents.
pub(super) fn lay_out(graph: &Graph, tree: &Supernodes, entering: &Entering) -> Vec<Supernode> {
    let columns = tree.order.len();
    let mut fronts: Vec<Supernode> = Vec::with_capacity(tree.parent.len());
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); tree.parent.len()];
    let mut below: Vec<Vec<u32>> = Vec::with_capacity(tree.parent.len());
    let mut rows_below = RowsBelow { graph, tree, place: places(&tree.order), taken_by: vec![NONE; columns] };
    let size = |column: u32| graph.weights[tree.order[column as usize] as usize] as u32;
    let mut row = vec![0; columns]; // of each column's first unknown in the front at hand
    let mut unknown = 0;
    for s in 0..tree.parent.len() {
        let own = tree.first[s]..tree.first[s + 1];
        let later = rows_below.of(s, &children[s], &below);
        let mut rows = 0;
        let mut eliminated = 0;
        for column in own.clone().chain(later.iter().copied()) {
            row[column as usize] = rows;
            rows += size(column);
            if column < own.end {
                eliminated = rows;
            }
        }
        for c in std::mem::take(&mut children[s]) {
            fronts[c as usize].runs = runs(&std::mem::take(&mut below[c as usize]), &row, size);
        }
        let entries = own
            .flat_map(|column| entering.of(column).iter().map(move |b| (column, b)))
            .map(|(column, b)| Entry {
                block: b.index,
                row_node: b.row_node,
                row: row[b.later as usize],
                column: row[column as usize],
                transposed: b.transposed,
            })
            .collect();
        fronts.push(Supernode {
            unknown,
            columns: eliminated as usize,
            rows: rows as usize,
            subtree: s,
            entries,
            ..Supernode::default()
        });
        unknown += eliminated as usize;
        below.push(later);
        if tree.parent[s] != NONE {
            children[tree.parent[s] as usize].push(s as u32);
        }
    }
    fronts
}

struct RowsBelow<'a> {
    graph: &'a Graph,
    tree: &'a Supernodes,
    place: Vec<u32>,
    taken_by: Vec<u32>,
}

impl RowsBelow<'_> {
    /// The later columns that supernode `s` is coupled with, ascending: neighbours of its own columns and what
    /// its children leave behind.
    fn of(&mut self, s: usize, children: &[u32], below: &[Vec<u32>]) -> Vec<u32> {
        let own = self.tree.first[s]..self.tree.first[s + 1];
        let mut rows = Vec::new();
        let mut take = |column: u32| {
            if column >= own.end && std::mem::replace(&mut self.taken_by[column as usize], s as u32) != s as u32 {
                rows.push(column);
            }
        };
        for &c in children {
            below[c as usize].iter().for_each(|&column| take(column));
        }
        for column in own.clone() {
            let neighbours = self.graph.of(self.tree.order[column as usize] as usize);
            neighbours.iter().for_each(|&v| take(self.place[v as usize]));
        }
        rows.sort_unstable();
        rows
    }
}

/// Where the unknowns of `columns` stand in a front whose columns start at `row`.
fn runs(columns: &[u32], row: &[u32], size: impl Fn(u32) -> u32) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut from = 0;
    for &column in columns {
        let (to, length) = (row[column as usize], size(column));
        match runs.last_mut() {
            Some(last) if last.to + last.length == to => last.length += length,
            _ => runs.push(Run { from, to, length }),
        }
        from += length;
    }
    runs.shrink_to_fit();
    runs
}
