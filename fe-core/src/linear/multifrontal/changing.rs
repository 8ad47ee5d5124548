//! Where the nodes that change between factorisations stand in the order of elimination.

use super::tree::{Columns, NONE};
use crate::linear::ordering::{Graph, nested_dissection};

/// Factorisations again that a step is expected to make for one from the start: what the order is chosen for. Contact
/// of Hertz's kind took 4 to 12 from meshes of 5,000 to 200,000 unknowns.
const AGAIN: f64 = 6.0;

/// The columns in an order of nested dissection; with its `changing` vertices moved to the end, where less is then
/// eliminated in all.
pub(super) fn columns(graph: &Graph, changing: &[bool]) -> Columns {
    let order = nested_dissection(graph);
    let (last, first): (Vec<u32>, Vec<u32>) = order.iter().partition(|&&v| changing[v as usize]);
    let plain = Columns::new(graph, order);
    if last.is_empty() || first.is_empty() {
        return plain;
    }
    let moved = Columns::new(graph, first.into_iter().chain(last).collect());
    if work(graph, &moved, changing) < work(graph, &plain, changing) { moved } else { plain }
}

/// Multiplications and additions of a factorisation and those that follow.
fn work(graph: &Graph, columns: &Columns, changing: &[bool]) -> f64 {
    let mut changes: Vec<bool> = columns.order.iter().map(|&v| changing[v as usize]).collect();
    let mut sum = 0.0;
    for (j, &vertex) in columns.order.iter().enumerate() {
        let flops = graph.weights[vertex as usize] as f64 * (columns.count[j] as f64).powi(2);
        sum += if changes[j] { (1.0 + AGAIN) * flops } else { flops };
        let parent = columns.parent[j];
        if changes[j] && parent != NONE {
            changes[parent as usize] = true;
        }
    }
    sum
}
