//! The order of elimination: nested dissection of the node graph (Karypis & Kumar 1998, METIS).

use std::sync::Mutex;

/// An undirected graph: the neighbours of vertex `v` are `neighbours[start[v]..start[v + 1]]`, itself left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    /// Where each vertex's neighbours start; one more at the end.
    pub start: Vec<i32>,
    /// Neighbours, each edge in both directions.
    pub neighbours: Vec<i32>,
    /// Unknowns a vertex stands for.
    pub weights: Vec<i32>,
}

impl Graph {
    /// Number of vertices.
    pub fn vertices(&self) -> usize {
        self.weights.len()
    }

    /// Neighbours of a vertex.
    pub fn of(&self, vertex: usize) -> &[i32] {
        &self.neighbours[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }
}

/// The vertices in the order in which they are eliminated. Same graph, same order.
pub fn nested_dissection(graph: &Graph) -> Vec<u32> {
    let (alone, joined): (Vec<u32>, Vec<u32>) =
        (0..graph.vertices() as u32).partition(|&v| graph.of(v as usize).is_empty());
    if joined.len() < 3 {
        return (0..graph.vertices() as u32).collect();
    }
    if alone.is_empty() {
        return metis_node_dissection(graph);
    }
    let inner = metis_node_dissection(&restrict(graph, &joined));
    alone.into_iter().chain(inner.into_iter().map(|v| joined[v as usize])).collect()
}

/// The graph among `kept` vertices, whose neighbours are all kept.
fn restrict(graph: &Graph, kept: &[u32]) -> Graph {
    let mut place = vec![0; graph.vertices()];
    for (k, &v) in kept.iter().enumerate() {
        place[v as usize] = k as i32;
    }
    let mut inner =
        Graph { start: vec![0], neighbours: Vec::with_capacity(graph.neighbours.len()), weights: Vec::new() };
    for &v in kept {
        inner.neighbours.extend(graph.of(v as usize).iter().map(|&w| place[w as usize]));
        inner.start.push(inner.neighbours.len() as i32);
        inner.weights.push(graph.weights[v as usize]);
    }
    inner
}

/// METIS draws from the C library's one random sequence, which it seeds anew at each call: one call at a time,
/// so that the same graph is always ordered the same way.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// The only unsafe place of the crate: the safe wrapper of METIS knows partitions but not orderings.
#[allow(unsafe_code)]
fn metis_node_dissection(graph: &Graph) -> Vec<u32> {
    use metis_sys as m;
    const SEED: i32 = 1;
    let mut vertices = graph.vertices() as i32;
    assert_eq!(graph.start.len(), graph.vertices() + 1);
    assert_eq!(graph.start[graph.vertices()] as usize, graph.neighbours.len());
    debug_assert!(graph.neighbours.iter().all(|&v| (0..vertices).contains(&v)));
    let uniform = graph.weights.iter().all(|&w| w == graph.weights[0]);
    let (mut start, mut neighbours) = (graph.start.clone(), graph.neighbours.clone());
    let mut weights = if uniform { Vec::new() } else { graph.weights.clone() };
    let mut order = vec![0i32; graph.vertices()];
    let mut place = vec![0i32; graph.vertices()];
    let mut options = [0i32; m::METIS_NOPTIONS as usize];
    let guard = ONE_AT_A_TIME.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    // SAFETY: start, neighbours and weights describe a graph whose indices lie in 0..vertices (asserted above and
    // by construction); order and place hold `vertices` numbers, options METIS_NOPTIONS; METIS keeps no pointer.
    let status = unsafe {
        m::METIS_SetDefaultOptions(options.as_mut_ptr());
        options[m::moptions_et_METIS_OPTION_SEED as usize] = SEED;
        m::METIS_NodeND(
            &mut vertices,
            start.as_mut_ptr(),
            neighbours.as_mut_ptr(),
            if uniform { std::ptr::null_mut() } else { weights.as_mut_ptr() },
            options.as_mut_ptr(),
            order.as_mut_ptr(),
            place.as_mut_ptr(),
        )
    };
    drop(guard);
    assert_eq!(status, m::rstatus_et_METIS_OK, "METIS orders any graph unless memory runs out");
    order.into_iter().map(|v| v as u32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(vertices: usize, edges: &[(usize, usize)], weights: Vec<i32>) -> Graph {
        let mut lists = vec![Vec::new(); vertices];
        for &(a, b) in edges {
            lists[a].push(b as i32);
            lists[b].push(a as i32);
        }
        let mut g = Graph { start: vec![0], neighbours: Vec::new(), weights };
        for list in lists {
            g.neighbours.extend(list);
            g.start.push(g.neighbours.len() as i32);
        }
        g
    }

    fn assert_permutation(order: &[u32], vertices: usize) {
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..vertices as u32).collect::<Vec<_>>());
    }

    #[test]
    fn every_graph_has_an_order() {
        for (vertices, edges) in [
            (0, vec![]),
            (1, vec![]),
            (2, vec![(0, 1)]),
            (5, vec![]),
            (4, vec![(1, 3)]),
            (7, vec![(0, 6), (6, 2), (4, 5)]),
            (400, (0..200).map(|i| (i, i + 200)).collect()),
            (301, (0..300).map(|i| (i, 300)).collect()),
        ] {
            let weights = (0..vertices as i32).map(|i| 1 + i % 6).collect();
            assert_permutation(&nested_dissection(&graph(vertices, &edges, weights)), vertices);
            assert_permutation(&nested_dissection(&graph(vertices, &edges, vec![3; vertices])), vertices);
        }
    }

    /// The last vertices of a square grid separate it: without them no part has more than about two thirds.
    #[test]
    fn a_grid_is_dissected_alike_each_time() {
        let side = 30;
        let edges: Vec<_> = (0..side * side)
            .flat_map(|v| {
                [(v % side + 1 < side).then_some((v, v + 1)), (v + side < side * side).then_some((v, v + side))]
            })
            .flatten()
            .collect();
        let g = graph(side * side, &edges, vec![1; side * side]);
        let order = nested_dissection(&g);
        assert_permutation(&order, side * side);
        assert!((0..4).all(|_| nested_dissection(&g) == order));
        let mut reached = vec![false; side * side];
        order[side * side - 2 * side..].iter().for_each(|&v| reached[v as usize] = true);
        let mut largest = 0;
        for v in 0..side * side {
            let (mut open, mut size) = (vec![v], 0);
            while let Some(v) = open.pop() {
                if !std::mem::replace(&mut reached[v], true) {
                    size += 1;
                    open.extend(g.of(v).iter().map(|&w| w as usize));
                }
            }
            largest = largest.max(size);
        }
        assert!(largest < side * side * 2 / 3, "{largest}");
    }
}
