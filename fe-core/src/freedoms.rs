//! Which freedoms each node has, and where they stand in the vectors of the whole scene.

use std::ops::Range;

/// Freedom numbers of the decks, from 0: three translations, then three rotations.
pub const COMPONENTS: usize = 6;

/// The freedoms of all nodes. A vector of the scene holds them node by node; within a node by component.
#[derive(Clone, Debug, PartialEq)]
pub struct Freedoms {
    start: Vec<u32>,
    components: Vec<u8>,
}

impl Freedoms {
    /// From one bit mask a node: bit c set when the node has component c (0..3 translations, 3..6 rotations).
    /// A node without a bit set has no freedom and costs nothing.
    pub fn new(masks: &[u8]) -> Self {
        let mut start = Vec::with_capacity(masks.len() + 1);
        let mut components = Vec::new();
        start.push(0);
        for mask in masks {
            components.extend((0..COMPONENTS as u8).filter(|c| mask >> c & 1 == 1));
            start.push(components.len() as u32);
        }
        Freedoms { start, components }
    }

    /// Number of freedoms in all.
    pub fn len(&self) -> usize {
        self.components.len()
    }

    /// True when nothing can move.
    pub fn is_empty(&self) -> bool {
        self.components.is_empty()
    }

    /// Number of nodes, with or without freedoms.
    pub fn nodes(&self) -> usize {
        self.start.len() - 1
    }

    /// The freedoms of a node.
    pub fn of_node(&self, node: usize) -> Range<usize> {
        self.start[node] as usize..self.start[node + 1] as usize
    }

    /// The freedom of a node in direction `component`, if it has one.
    pub fn index(&self, node: usize, component: usize) -> Option<usize> {
        self.of_node(node).find(|&f| self.components[f] as usize == component)
    }

    /// First rotation of each node that has three of them.
    pub fn rotations(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.components.len().saturating_sub(2)).filter(|&f| self.components[f..f + 3] == [3, 4, 5])
    }

    /// Direction of a freedom, 0..6.
    pub fn component(&self, freedom: usize) -> usize {
        self.components[freedom] as usize
    }

    /// Node of a freedom.
    pub fn node(&self, freedom: usize) -> usize {
        self.start.partition_point(|&s| s as usize <= freedom) - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_hold_what_their_mask_says() {
        let f = Freedoms::new(&[0b111, 0, 0b100011, 0b11]);
        assert_eq!(f.len(), 8);
        assert_eq!(f.of_node(1), 3..3);
        assert_eq!(f.index(2, 5), Some(5));
        assert_eq!(f.index(2, 2), None);
        assert_eq!((f.node(5), f.component(5)), (2, 5));
        assert_eq!((f.node(2), f.node(6)), (0, 3));
    }
}
