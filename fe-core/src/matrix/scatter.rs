//! Where the blocks of many like elements stand in the matrix, looked up once a step.

use super::{BlockMatrix, Pattern};

/// How the block of an element stands in the lower triangle.
const STRAIGHT: u32 = 0;
const TRANSPOSED: u32 = 1;
/// Both ends are the same node (a collapsed edge): the block and its transpose fall on the diagonal block.
const BOTH: u32 = 2;

/// For each element the places of its n(n+1)/2 lower blocks (a, b ≤ a), a outer. Elements use the first
/// `components` freedoms of their nodes; a node may have more (the rotations of a rigid body's reference).
#[derive(Clone, Debug)]
pub struct Scatter {
    components: usize,
    blocks: usize,
    /// Block index in the pattern times 4, plus how it stands, `[elements × blocks]`.
    places: Vec<u32>,
}

impl Scatter {
    /// Of elements with `per_element` nodes each, side by side in `nodes`.
    ///
    /// # Panics
    /// When the nodes of an element were not coupled or a node has fewer than `components` freedoms.
    pub fn new(pattern: &Pattern, nodes: &[u32], per_element: usize, components: usize) -> Self {
        let blocks = per_element * (per_element + 1) / 2;
        let mut places = Vec::with_capacity(nodes.len() / per_element.max(1) * blocks);
        for element in nodes.chunks_exact(per_element.max(1)) {
            for (a, &i) in element.iter().enumerate() {
                assert!(pattern.freedoms.of_node(i as usize).len() >= components, "a node lacks freedoms");
                for (b, &j) in element[..=a].iter().enumerate() {
                    let block = pattern.block(i.max(j), i.min(j)).expect("the nodes of an element are coupled");
                    let standing = if i < j {
                        TRANSPOSED
                    } else if i == j && a != b {
                        BOTH
                    } else {
                        STRAIGHT
                    };
                    places.push(u32::try_from(block).expect("fewer than 2^30 blocks") * 4 + standing);
                }
            }
        }
        Scatter { components, blocks, places }
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.places.len().checked_div(self.blocks).unwrap_or(0)
    }
}

impl BlockMatrix {
    /// Adds one element's stiffness: `lower` holds its blocks (a, b ≤ a), a outer, each row-major
    /// `[components × components]`; diagonal blocks in full.
    pub fn scatter(&mut self, scatter: &Scatter, element: usize, lower: &[f64]) {
        let places = &scatter.places[element * scatter.blocks..(element + 1) * scatter.blocks];
        match scatter.components {
            2 => self.scatter_blocks::<2>(places, lower),
            3 => self.scatter_blocks::<3>(places, lower),
            1 => self.scatter_blocks::<1>(places, lower),
            n => self.scatter_any(places, lower, n),
        }
    }

    /// Blocks of `N × N`, the loops unrolled where the node has no further freedoms.
    fn scatter_blocks<const N: usize>(&mut self, places: &[u32], lower: &[f64]) {
        debug_assert_eq!(lower.len(), places.len() * N * N);
        for (&place, block) in places.iter().zip(lower.chunks_exact(N * N)) {
            let k = (place / 4) as usize;
            let start = self.pattern.value_start[k];
            let target = &mut self.values[start..self.pattern.value_start[k + 1]];
            if target.len() == N * N {
                add_square::<N>(target, N, block, place % 4);
            } else {
                let stride = self.pattern.freedoms.of_node(self.pattern.columns[k] as usize).len();
                add_square::<N>(target, stride, block, place % 4);
            }
        }
    }

    fn scatter_any(&mut self, places: &[u32], lower: &[f64], n: usize) {
        for (&place, block) in places.iter().zip(lower.chunks_exact(n * n)) {
            let k = (place / 4) as usize;
            let stride = self.pattern.freedoms.of_node(self.pattern.columns[k] as usize).len();
            add(&mut self.values[self.pattern.value_start[k]..], stride, block, n, place % 4);
        }
    }
}

#[inline(always)]
fn add_square<const N: usize>(target: &mut [f64], stride: usize, block: &[f64], standing: u32) {
    add(target, stride, block, N, standing);
}

/// Adds an `n × n` block to the leading rows and columns of `target`, whose rows are `stride` long.
#[inline(always)]
fn add(target: &mut [f64], stride: usize, block: &[f64], n: usize, standing: u32) {
    if standing != TRANSPOSED {
        for r in 0..n {
            for c in 0..n {
                target[r * stride + c] += block[r * n + c];
            }
        }
    }
    if standing != STRAIGHT {
        for r in 0..n {
            for c in 0..n {
                target[r * stride + c] += block[c * n + r];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::freedoms::Freedoms;
    use crate::matrix::Couplings;
    use std::sync::Arc;

    /// Scattered elements against the full matrices they stand for: all freedoms moved one after the other.
    fn compare(masks: &[u8], elements: &[u32], per_element: usize, components: usize) {
        let freedoms = Freedoms::new(masks);
        let mut couplings = Couplings::new(masks.len());
        couplings.add_all(elements, per_element);
        let pattern = Arc::new(Pattern::new(&freedoms, &couplings));
        let scatter = Scatter::new(&pattern, elements, per_element, components);
        assert_eq!(scatter.elements(), elements.len() / per_element);
        let n = freedoms.len();
        let (mut k, mut full) = (BlockMatrix::zero(pattern), vec![0.0; n * n]);
        let entry = |e: usize, r: usize, c: usize| (1 + e + 100 * (r + c) + 7 * r * c) as f64; // integers: exact sums
        for (e, nodes) in elements.chunks_exact(per_element).enumerate() {
            let mut lower = Vec::new();
            for a in 0..per_element {
                for b in 0..per_element {
                    for r in 0..components {
                        for c in 0..components {
                            let value = entry(e, a * components + r, b * components + c);
                            let row = freedoms.of_node(nodes[a] as usize).start + r;
                            let column = freedoms.of_node(nodes[b] as usize).start + c;
                            full[row * n + column] += value;
                            if b <= a {
                                lower.push(value);
                            }
                        }
                    }
                }
            }
            k.scatter(&scatter, e, &lower);
        }
        for j in 0..n {
            let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
            x[j] = 1.0;
            k.multiply_add(&x, &mut y);
            assert_eq!(y, (0..n).map(|i| full[i * n + j]).collect::<Vec<_>>());
        }
    }

    #[test]
    fn elements_land_in_both_orders_of_their_nodes() {
        compare(&[7; 5], &[0, 3, 1, 4, 1, 3, 2, 0], 4, 3);
        compare(&[3; 4], &[2, 1, 0, 3, 2, 1], 3, 2);
        compare(&[1; 4], &[2, 1, 3, 0], 2, 1);
    }

    #[test]
    fn further_freedoms_of_a_node_are_left_alone() {
        compare(&[0b111, 0b111111, 0b111, 0b111111], &[0, 3, 1, 2, 3, 1], 3, 3);
        compare(&[0b11, 0b100011, 0b11], &[1, 0, 2, 1], 2, 2);
        compare(&[0b111111, 0b111111], &[1, 0], 2, 6);
    }

    #[test]
    fn a_collapsed_edge_counts_both_ways() {
        compare(&[3; 3], &[0, 1, 2, 2, 1, 1, 0, 2], 4, 2);
    }
}
