//! Two meshes in one.

use crate::cell::CellKind;
use crate::mesh::{CellBlock, CellId, Face, Mesh};
use std::collections::BTreeMap;

impl Mesh {
    /// Puts a prefix before the name of every set and surface.
    pub fn prefixed(mut self, prefix: &str) -> Mesh {
        fn rename<T>(named: &mut BTreeMap<String, T>, prefix: &str) {
            *named = std::mem::take(named).into_iter().map(|(name, what)| (format!("{prefix}{name}"), what)).collect();
        }
        rename(&mut self.node_sets, prefix);
        rename(&mut self.cell_sets, prefix);
        rename(&mut self.surfaces, prefix);
        self
    }

    /// Adds another body. Its labels go on from the highest ones here, no points are merged, cells join the block of
    /// their kind, sets and surfaces of the same name become one.
    pub fn append(&mut self, other: &Mesh) {
        let first_point = self.points.len() as u32;
        let point_labels = self.point_labels.iter().max().copied().unwrap_or(0);
        let cell_labels = self.blocks.iter().flat_map(|block| &block.labels).max().copied().unwrap_or(0);
        self.points.extend_from_slice(&other.points);
        self.point_labels.extend(other.point_labels.iter().map(|label| label + point_labels));
        let mut places = Vec::new();
        for block in &other.blocks {
            let place = self.block_of(block.kind);
            let target = &mut self.blocks[place];
            places.push((place as u32, target.len() as u32));
            target.labels.extend(block.labels.iter().map(|label| label + cell_labels));
            target.nodes.extend(block.nodes.iter().map(|node| node + first_point));
        }
        let moved = |id: CellId| {
            let (block, first) = places[id.block as usize];
            CellId { block, cell: id.cell + first }
        };
        join(&mut self.node_sets, &other.node_sets, |node| node + first_point);
        join(&mut self.cell_sets, &other.cell_sets, moved);
        join(&mut self.surfaces, &other.surfaces, |face| Face { cell: moved(face.cell), face: face.face });
    }

    /// Index of the last block of a kind, made where there is none.
    fn block_of(&mut self, kind: CellKind) -> usize {
        self.blocks.iter().rposition(|block| block.kind == kind).unwrap_or_else(|| {
            self.blocks.push(CellBlock::new(kind));
            self.blocks.len() - 1
        })
    }
}

/// Adds what has a name there to what has it here.
fn join<T: Ord + Copy>(here: &mut BTreeMap<String, Vec<T>>, there: &BTreeMap<String, Vec<T>>, moved: impl Fn(T) -> T) {
    for (name, items) in there {
        let joined = here.entry(name.clone()).or_default();
        joined.extend(items.iter().map(|&item| moved(item)));
        joined.sort_unstable();
        joined.dedup();
    }
}

#[cfg(test)]
mod tests {
    use crate::generate::Block;

    /// Points, labels and sets of the second body follow the first; a common name holds both.
    #[test]
    fn two_bodies() {
        let mut mesh = Block::hex8([1, 1, 2]).mesh().prefixed("LOWER_");
        let upper = Block::hex8([2, 1, 1]).origin([0.0, 0.0, 1.0]).mesh().prefixed("UPPER_");
        let triangles = Block::tri3([1, 1]).mesh().prefixed("LOWER_");
        mesh.append(&upper);
        mesh.append(&triangles);
        assert_eq!((mesh.points.len(), mesh.cell_count(), mesh.blocks.len()), (12 + 12 + 4, 4 + 2, 2));
        assert_eq!(mesh.point_labels, (1..=28).collect::<Vec<u64>>());
        assert_eq!(mesh.blocks[0].labels, [1, 2, 3, 4]);
        assert_eq!(mesh.blocks[1].labels, [5, 6]);
        let side = mesh.surfaces["UPPER_ZMIN"].clone();
        assert_eq!(side.iter().map(|face| mesh.cell_label(face.cell)).collect::<Vec<_>>(), [3, 4]);
        assert!(side.iter().all(|&face| mesh.face(face).1.iter().all(|&node| mesh.points[node as usize][2] == 1.0)));
        let block: Vec<u64> = mesh.cell_sets["LOWER_BLOCK"].iter().map(|&id| mesh.cell_label(id)).collect();
        assert_eq!(block, [1, 2, 5, 6]);
        assert_eq!(mesh.node_sets["LOWER_XMIN"].len(), 6 + 2);
        assert_eq!(mesh.node_sets["UPPER_XMIN"], [12, 15, 18, 21]);
    }
}
