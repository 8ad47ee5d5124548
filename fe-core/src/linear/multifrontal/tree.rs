//! The elimination tree of a graph and how full each column of the factor gets.

use crate::linear::ordering::Graph;

/// No parent: a root.
pub(super) const NONE: u32 = u32::MAX;

/// Columns of the factor, one a vertex, in an order in which each child stands before its parent and each
/// subtree stands together.
pub(super) struct Columns {
    /// Vertex of each column.
    pub order: Vec<u32>,
    /// Column of each vertex.
    pub place: Vec<u32>,
    /// First column that needs this one, `NONE` for a root.
    pub parent: Vec<u32>,
    /// Unknowns in the column, from its own on downwards.
    pub count: Vec<u32>,
}

impl Columns {
    /// Of a graph eliminated in `order`, which is changed only where the factor stays as full.
    pub fn new(graph: &Graph, mut order: Vec<u32>) -> Self {
        let parent = elimination_tree(graph, &order, &places(&order));
        let sequence = postorder(&parent, |_| 0);
        let place = places(&sequence);
        let parent = sequence
            .iter()
            .map(|&v| if parent[v as usize] == NONE { NONE } else { place[parent[v as usize] as usize] })
            .collect();
        order = sequence.iter().map(|&v| order[v as usize]).collect();
        let place = places(&order);
        let mut columns = Columns { order, place, parent, count: Vec::new() };
        columns.count = columns.counts(graph);
        columns
    }

    /// Column counts without forming the columns (Gilbert, Ng & Peyton 1994), weighted by the unknowns a row holds.
    fn counts(&self, graph: &Graph) -> Vec<u32> {
        let n = self.order.len();
        let weight = |column: usize| graph.weights[self.order[column] as usize] as i64;
        let mut first = vec![NONE; n]; // first descendant
        let mut change = vec![0i64; n];
        for k in 0..n {
            if first[k] == NONE {
                change[k] = weight(k);
            }
            let mut j = k as u32;
            while j != NONE && first[j as usize] == NONE {
                first[j as usize] = k as u32;
                j = self.parent[j as usize];
            }
        }
        let mut latest_first = vec![NONE; n]; // of the row's leaves so far
        let mut latest_leaf = vec![NONE; n];
        let mut ancestor: Vec<u32> = (0..n as u32).collect();
        for j in 0..n {
            let parent = self.parent[j];
            if parent != NONE {
                change[parent as usize] -= weight(j);
            }
            for &neighbour in graph.of(self.order[j] as usize) {
                let i = self.place[neighbour as usize] as usize;
                if i <= j || (latest_first[i] != NONE && first[j] <= latest_first[i]) {
                    continue;
                }
                latest_first[i] = first[j];
                change[j] += weight(i);
                let before = std::mem::replace(&mut latest_leaf[i], j as u32);
                if before != NONE {
                    change[root_so_far(&mut ancestor, before) as usize] -= weight(i);
                }
            }
            if parent != NONE {
                ancestor[j] = parent;
            }
        }
        for j in 0..n {
            if self.parent[j] != NONE {
                change[self.parent[j] as usize] += change[j];
            }
        }
        change.into_iter().map(|c| c as u32).collect()
    }
}

/// Root of a vertex in the forest joined so far; shortens the paths on the way.
fn root_so_far(ancestor: &mut [u32], vertex: u32) -> u32 {
    let mut root = vertex;
    while ancestor[root as usize] != root {
        root = ancestor[root as usize];
    }
    let mut v = vertex;
    while v != root {
        v = std::mem::replace(&mut ancestor[v as usize], root);
    }
    root
}

/// `place[order[k]] = k`.
pub(super) fn places(order: &[u32]) -> Vec<u32> {
    let mut place = vec![0; order.len()];
    for (k, &v) in order.iter().enumerate() {
        place[v as usize] = k as u32;
    }
    place
}

/// Parent of each column (Liu 1986).
fn elimination_tree(graph: &Graph, order: &[u32], place: &[u32]) -> Vec<u32> {
    let n = order.len();
    let (mut parent, mut ancestor) = (vec![NONE; n], vec![NONE; n]);
    for j in 0..n as u32 {
        for &neighbour in graph.of(order[j as usize] as usize) {
            let mut i = place[neighbour as usize];
            while i < j {
                let next = std::mem::replace(&mut ancestor[i as usize], j);
                if next == NONE {
                    parent[i as usize] = j;
                    break;
                }
                i = next;
            }
        }
    }
    parent
}

/// The nodes of a forest, children before parents, subtrees together; among brothers those of small `rank` first.
pub(super) fn postorder(parent: &[u32], rank: impl Fn(u32) -> i64) -> Vec<u32> {
    let n = parent.len();
    let mut by_rank: Vec<u32> = (0..n as u32).collect();
    by_rank.sort_by_key(|&v| rank(v));
    let (mut first_child, mut next_brother) = (vec![NONE; n + 1], vec![NONE; n]);
    for &v in by_rank.iter().rev() {
        let p = (parent[v as usize] as usize).min(n); // the roots are brothers, too
        next_brother[v as usize] = std::mem::replace(&mut first_child[p], v);
    }
    let mut order = Vec::with_capacity(n);
    let mut path = vec![n as u32];
    while let Some(&v) = path.last() {
        let child = first_child[v as usize];
        if child == NONE {
            path.pop();
            order.push(v);
        } else {
            first_child[v as usize] = next_brother[child as usize];
            path.push(child);
        }
    }
    order.pop();
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against an elimination carried out on sets.
    #[test]
    fn counts_are_those_of_an_elimination() {
        let mut random = crate::linear::multifrontal::tests::Random(7);
        for n in [1, 2, 5, 30, 60] {
            for _ in 0..20 {
                let mut full = vec![vec![false; n]; n];
                for _ in 0..n + n / 2 {
                    let (a, b) = (random.below(n), random.below(n));
                    full[a][b] = a != b;
                    full[b][a] = a != b;
                }
                let mut graph = Graph { start: vec![0], neighbours: Vec::new(), weights: Vec::new() };
                for row in &full {
                    graph.neighbours.extend((0..n as i32).filter(|&j| row[j as usize]));
                    graph.start.push(graph.neighbours.len() as i32);
                    graph.weights.push(1 + random.below(6) as i32);
                }
                let mut order: Vec<u32> = (0..n as u32).collect();
                (1..n).for_each(|i| order.swap(i, random.below(i + 1)));
                let columns = Columns::new(&graph, order);
                for (k, &v) in columns.order.iter().enumerate() {
                    let later: Vec<usize> =
                        (k + 1..n).map(|c| columns.order[c] as usize).filter(|&w| full[v as usize][w]).collect();
                    let count = graph.weights[v as usize] + later.iter().map(|&w| graph.weights[w]).sum::<i32>();
                    assert_eq!(columns.count[k] as i32, count);
                    assert_eq!(columns.parent[k], later.first().map_or(NONE, |&w| columns.place[w]));
                    for &a in &later {
                        later.iter().filter(|&&b| b != a).for_each(|&b| full[a][b] = true);
                    }
                }
            }
        }
    }
}
