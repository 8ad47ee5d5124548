//! Assembles a front from the matrix and from what the children left, and eliminates its columns.

use super::dense::{eliminate, share};
use super::extend::Child;
use super::pool::Pool;
use super::symbolic::{Entry, Supernode, Symbolic};
use super::trapezoid::Panel;
use crate::freedoms::COMPONENTS;
use crate::matrix::BlockMatrix;
use std::sync::OnceLock;

/// What a supernode left to its parent: the lower triangle of its [`Supernode::update`]. Empty where it is the one that
/// was kept.
pub(super) struct Update {
    supernode: usize,
    values: Vec<f64>,
}

/// What a supernode that does not change left to a parent that does.
pub(super) type Kept = OnceLock<Vec<f64>>;

/// What all fronts of a factorisation share.
pub(super) struct Fronts<'a> {
    pub symbolic: &'a Symbolic,
    pub matrix: &'a BlockMatrix,
    /// Of each unknown the pivot at or below which nothing holds it.
    pub least: &'a [f64],
    pub pool: &'a Pool,
    /// What is kept of each supernode.
    pub kept: &'a [Kept],
    /// True where fronts that do not change were eliminated before.
    pub again: bool,
    /// True where the factor holds zeros.
    pub fresh: bool,
}

impl Fronts<'_> {
    /// Eliminates supernode `s`: `factor` receives its part of the factor; what its children left is taken from the
    /// end of the stack. The error is the unknown whose pivot vanished.
    pub fn visit(&self, s: usize, factor: &mut [f64], stack: &mut Vec<Update>) -> Result<(), usize> {
        let node = &self.symbolic.supernodes[s];
        let children = stack.len() - node.children.len();
        if self.again && !node.changes {
            stack.truncate(children);
            stack.push(Update { supernode: s, values: Vec::new() });
            return Ok(());
        }
        let (front, rest) = (node.factor(), node.update());
        let (mut values, zero) = self.pool.take(rest.len());
        let update = &mut values[..rest.len()];
        let mut panels: Vec<(Panel, &mut [f64], bool)> =
            front.split(factor).into_iter().map(|(panel, numbers)| (panel, numbers, self.fresh)).collect();
        panels.extend(rest.split(update).into_iter().map(|(panel, numbers)| {
            let first = panel.first + node.columns;
            (Panel { first, ..panel }, numbers, zero)
        }));
        let brood: Vec<Child> = stack[children..].iter().map(|child| self.child(child)).collect();
        share(node.rows, panels, |(panel, numbers, zero)| {
            if !zero {
                numbers.fill(0.0);
            }
            self.enter(node, panel, numbers);
            brood.iter().for_each(|child| child.extend_add(panel, numbers));
        });
        drop(brood);
        stack.drain(children..).for_each(|child| self.release(node, child));
        let least = &self.least[node.unknown..node.unknown + node.columns];
        eliminate(front, factor, update, least).map_err(|column| node.unknown + column)?;
        stack.push(Update { supernode: s, values });
        Ok(())
    }

    /// A child as its parent takes it.
    fn child<'s>(&'s self, child: &'s Update) -> Child<'s> {
        let left = &self.symbolic.supernodes[child.supernode];
        let values = self.kept[child.supernode].get().unwrap_or(&child.values);
        Child::new(left, values)
    }

    /// Keeps what a child left where it will be wanted again, and gives its memory to the pool.
    fn release(&self, parent: &Supernode, child: Update) {
        let left = &self.symbolic.supernodes[child.supernode];
        if parent.changes && !left.changes {
            self.kept[child.supernode].get_or_init(|| child.values[..left.update().len()].to_vec());
        }
        self.pool.give(child.values);
    }

    /// Copies the blocks of the matrix that fall into a panel.
    fn enter(&self, node: &Supernode, panel: Panel, numbers: &mut [f64]) {
        let end = panel.first + panel.width;
        let from = node.entries.partition_point(|e| e.column as usize + COMPONENTS <= panel.first);
        for entry in node.entries[from..].iter().take_while(|e| (e.column as usize) < end) {
            self.enter_block(entry, panel, numbers);
        }
    }

    fn enter_block(&self, entry: &Entry, panel: Panel, numbers: &mut [f64]) {
        let pattern = &*self.matrix.pattern;
        let block = entry.block as usize;
        let (row_node, column_node) = (entry.row_node as usize, pattern.columns[block] as usize);
        let values = &self.matrix.values[pattern.value_start[block]..pattern.value_start[block + 1]];
        let stride = pattern.freedoms.of_node(column_node).len();
        let masks = (self.symbolic.masks[row_node], self.symbolic.masks[column_node]);
        let (row_mask, column_mask, down, right) =
            if entry.transposed { (masks.1, masks.0, 1, stride) } else { (masks.0, masks.1, stride, 1) };
        for (column, c) in (entry.column as usize..).zip(bits(column_mask)) {
            if column < panel.first || column >= panel.first + panel.width {
                continue;
            }
            for (row, r) in (entry.row as usize..).zip(bits(row_mask)) {
                if row >= column {
                    numbers[panel.below(row, column).start] = values[r * down + c * right];
                }
            }
        }
    }
}

/// Which bits of a mask are set, ascending.
fn bits(mask: u8) -> impl Iterator<Item = usize> {
    (0..u8::BITS as usize).filter(move |&k| mask >> k & 1 == 1)
}
