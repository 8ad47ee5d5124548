//! A mesh: points, blocks of like cells, named sets and surfaces.

use crate::cell::CellKind;
use std::collections::BTreeMap;

/// Cells of one kind, side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct CellBlock {
    /// Kind of every cell here.
    pub kind: CellKind,
    /// The labels the user knows the cells by.
    pub labels: Vec<u64>,
    /// Point indices, `[cells × kind.nodes()]`, in the decks' local order.
    pub nodes: Vec<u32>,
}

impl CellBlock {
    /// An empty block.
    pub fn new(kind: CellKind) -> Self {
        CellBlock { kind, labels: Vec::new(), nodes: Vec::new() }
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.labels.len()
    }

    /// True when there is no cell.
    pub fn is_empty(&self) -> bool {
        self.labels.is_empty()
    }

    /// Points of cell `i`.
    pub fn cell(&self, i: usize) -> &[u32] {
        let n = self.kind.nodes();
        &self.nodes[i * n..(i + 1) * n]
    }
}

/// One cell of a mesh: its block and its place there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CellId {
    /// Index into [`Mesh::blocks`].
    pub block: u32,
    /// Index into the block.
    pub cell: u32,
}

/// One face of a cell; `face` counts from 0 (the decks' S1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Face {
    /// The cell.
    pub cell: CellId,
    /// Index into [`CellKind::faces`].
    pub face: u8,
}

/// Points, cells, and what has a name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Coordinates [L], `[points]`; plane meshes have z = 0.
    pub points: Vec<[f64; 3]>,
    /// The labels the user knows the points by, `[points]`.
    pub point_labels: Vec<u64>,
    /// Blocks of like cells.
    pub blocks: Vec<CellBlock>,
    /// Node sets by name (capitals), ascending point indices.
    pub node_sets: BTreeMap<String, Vec<u32>>,
    /// Cell sets by name (capitals), ascending.
    pub cell_sets: BTreeMap<String, Vec<CellId>>,
    /// Surfaces by name (capitals): faces of cells, ascending.
    pub surfaces: BTreeMap<String, Vec<Face>>,
}

impl Mesh {
    /// Points of a cell.
    pub fn cell(&self, id: CellId) -> &[u32] {
        self.blocks[id.block as usize].cell(id.cell as usize)
    }

    /// Kind of a cell.
    pub fn kind(&self, id: CellId) -> CellKind {
        self.blocks[id.block as usize].kind
    }

    /// Label of a cell.
    pub fn cell_label(&self, id: CellId) -> u64 {
        self.blocks[id.block as usize].labels[id.cell as usize]
    }

    /// Kind and points of a face, normal outward.
    pub fn face(&self, face: Face) -> (CellKind, Vec<u32>) {
        let (kind, local) = self.kind(face.cell).faces()[face.face as usize];
        let cell = self.cell(face.cell);
        (kind, local.iter().map(|&i| cell[i]).collect())
    }

    /// All cells in order.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + '_ {
        self.blocks
            .iter()
            .enumerate()
            .flat_map(|(block, b)| (0..b.len()).map(move |cell| CellId { block: block as u32, cell: cell as u32 }))
    }

    /// Number of the first cell of each block when all cells are counted in order, `[blocks]`.
    pub fn first_cells(&self) -> Vec<usize> {
        let count = |next: &mut usize, block: &CellBlock| Some(std::mem::replace(next, *next + block.len()));
        self.blocks.iter().scan(0, count).collect()
    }

    /// Number of cells.
    pub fn cell_count(&self) -> usize {
        self.blocks.iter().map(CellBlock::len).sum()
    }
}
