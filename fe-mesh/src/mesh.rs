//! A mesh: points, blocks of like cells, named sets and surfaces.

use crate::cell::CellKind;
use std::collections::BTreeMap;
use std::ops::Range;

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

/// A copy of a part. Labels of points and cells are unique in an instance, not in the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Name (capitals).
    pub name: String,
    /// Its points.
    pub points: Range<u32>,
    /// Its cells: a block, and the range in it.
    pub cells: Vec<(u32, Range<u32>)>,
}

impl Instance {
    /// An instance without points and cells.
    pub fn new(name: String) -> Self {
        Instance { name, points: 0..0, cells: Vec::new() }
    }

    /// Takes one more point; the points of an instance follow one another.
    pub fn add_point(&mut self, point: u32) {
        let start = if self.points.is_empty() { point } else { self.points.start };
        self.points = start..point + 1;
    }

    /// Takes one more cell; the cells of an instance in a block follow one another.
    pub fn add_cell(&mut self, id: CellId) {
        match self.cells.iter_mut().find(|(block, _)| *block == id.block) {
            Some((_, cells)) => cells.end = id.cell + 1,
            None => self.cells.push((id.block, id.cell..id.cell + 1)),
        }
    }
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
    /// Copies of parts; none in most meshes. What has a name in one is called `INSTANCE.NAME`.
    pub instances: Vec<Instance>,
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

    /// The instance that a point belongs to, an index into [`Mesh::instances`].
    pub fn instance_of_point(&self, point: u32) -> Option<usize> {
        self.instances.iter().position(|instance| instance.points.contains(&point))
    }

    /// The instance that a cell belongs to, an index into [`Mesh::instances`].
    pub fn instance_of_cell(&self, id: CellId) -> Option<usize> {
        let holds = |(block, cells): &(u32, Range<u32>)| *block == id.block && cells.contains(&id.cell);
        self.instances.iter().position(|instance| instance.cells.iter().any(holds))
    }

    /// What the user calls a point: its label, or `INSTANCE.label`.
    pub fn point_name(&self, point: u32) -> String {
        self.within(self.instance_of_point(point), self.point_labels[point as usize])
    }

    /// What the user calls a cell: its label, or `INSTANCE.label`.
    pub fn cell_name(&self, id: CellId) -> String {
        self.within(self.instance_of_cell(id), self.cell_label(id))
    }

    fn within(&self, instance: Option<usize>, label: u64) -> String {
        instance.map_or(label.to_string(), |i| format!("{}.{label}", self.instances[i].name))
    }

    /// Kind and points of a face, normal outward.
    pub fn face(&self, face: Face) -> (CellKind, Vec<u32>) {
        let (kind, local) = self.kind(face.cell).face(face.face);
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
