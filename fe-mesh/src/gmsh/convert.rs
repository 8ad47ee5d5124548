//! From a gmsh file to a mesh: elements to cells, physical groups to sets and surfaces.

use super::facets::Facets;
use super::{ElementBlock, GmshMesh};
use crate::cell::CellKind;
use crate::mesh::{CellBlock, CellId, Mesh};
use std::collections::BTreeMap;
use std::fmt;

/// Which elements become cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept<'a> {
    /// Those of the highest dimension in the file.
    HighestDimension,
    /// Those of these groups (indices into [`GmshMesh::groups`]).
    Groups(&'a [usize]),
}

/// What a user may want to know of how groups became sets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Note {
    /// Faces of this surface lie between two cells; labels of the cell that was taken (the lower one) and of the other.
    SharedFaces {
        /// Name of the surface.
        surface: String,
        /// Labels `[taken, other]` of each such face.
        cells: Vec<[u64; 2]>,
    },
    /// Elements of this group are faces of no cell: the surface lacks them, the node set has their nodes.
    LooseFacets {
        /// Name of the surface.
        surface: String,
        /// Labels of the elements.
        elements: Vec<u64>,
    },
    /// The file names this group, but holds no element of it: its node set is empty.
    EmptyGroup {
        /// Name of the node set.
        name: String,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Note::SharedFaces { surface, cells } => {
                let [taken, other] = cells.first().copied().unwrap_or_default();
                let many = cells.len();
                write!(f, "surface {surface}: {many} of its faces lie between two elements, the lower one has them ")?;
                write!(f, "(first: element {taken}, not {other})")
            }
            Note::LooseFacets { surface, elements } => {
                let first = elements.first().copied().unwrap_or_default();
                let many = elements.len();
                write!(f, "surface {surface}: {many} of its elements are faces of no kept element (first: {first}); ")?;
                write!(f, "the node set {surface} has their nodes")
            }
            Note::EmptyGroup { name } => write!(f, "physical group {name}: the file holds no element of it"),
        }
    }
}

impl GmshMesh {
    /// The mesh: kept elements become cells (labels: element tags) and each of their groups a cell set; every group
    /// becomes a node set; groups one dimension below the cells become surfaces too, of the faces with the same
    /// corners. Nodes of no cell stay.
    pub fn into_mesh(self, kept: Kept) -> (Mesh, Vec<Note>) {
        let dimension = self.dimension();
        let is_kept = |block: &ElementBlock| match kept {
            Kept::HighestDimension => block.kind.dimension() == dimension,
            Kept::Groups(groups) => block.groups.iter().any(|&group| groups.contains(&(group as usize))),
        };
        let (cells, others): (Vec<&ElementBlock>, Vec<&ElementBlock>) =
            self.blocks.iter().partition(|&block| is_kept(block));
        let names: Vec<String> = self.groups.iter().map(|group| group.set_name()).collect();
        let mut notes = Vec::new();
        let mut mesh = Mesh { node_sets: self.node_sets(&names, &mut notes), ..Mesh::default() };
        add_cells(&mut mesh, &cells, &names);
        mesh.points = self.points;
        mesh.point_labels = self.tags;
        add_surfaces(&mut mesh, &others, &names, &mut notes);
        (mesh, notes)
    }

    /// The nodes of every group by name.
    fn node_sets(&self, names: &[String], notes: &mut Vec<Note>) -> BTreeMap<String, Vec<u32>> {
        let mut blocks_of: BTreeMap<&str, Vec<&ElementBlock>> = BTreeMap::new();
        for name in names {
            blocks_of.insert(name, Vec::new());
        }
        for block in &self.blocks {
            for &group in &block.groups {
                blocks_of.entry(&names[group as usize]).or_default().push(block);
            }
        }
        let mut last_set = vec![u32::MAX; self.points.len()];
        let mut sets = BTreeMap::new();
        for (number, (name, blocks)) in blocks_of.into_iter().enumerate() {
            let mut nodes = Vec::new();
            for &node in blocks.iter().flat_map(|block| &block.nodes) {
                if std::mem::replace(&mut last_set[node as usize], number as u32) != number as u32 {
                    nodes.push(node);
                }
            }
            if nodes.is_empty() {
                notes.push(Note::EmptyGroup { name: name.to_string() });
            }
            nodes.sort_unstable();
            sets.insert(name.to_string(), nodes);
        }
        sets
    }
}

/// Adds the cells, a block for each kind, and their sets.
fn add_cells(mesh: &mut Mesh, cells: &[&ElementBlock], names: &[String]) {
    let mut place_of: BTreeMap<CellKind, usize> = BTreeMap::new();
    for block in cells {
        let place = *place_of.entry(block.kind).or_insert_with(|| {
            mesh.blocks.push(CellBlock::new(block.kind));
            mesh.blocks.len() - 1
        });
        let target = &mut mesh.blocks[place];
        let first = target.len();
        target.labels.extend_from_slice(&block.tags);
        target.nodes.extend_from_slice(&block.nodes);
        let ids = (first..target.len()).map(|cell| CellId { block: place as u32, cell: cell as u32 });
        for &group in &block.groups {
            mesh.cell_sets.entry(names[group as usize].clone()).or_default().extend(ids.clone());
        }
    }
    for set in mesh.cell_sets.values_mut() {
        set.sort_unstable();
        set.dedup();
    }
}

/// Adds the surfaces: groups of elements one dimension below the cells.
fn add_surfaces(mesh: &mut Mesh, others: &[&ElementBlock], names: &[String], notes: &mut Vec<Note>) {
    let dimension = mesh.blocks.iter().map(|block| block.kind.dimension()).max().unwrap_or(0);
    let sides: Vec<&ElementBlock> = others
        .iter()
        .copied()
        .filter(|block| block.kind.dimension() + 1 == dimension && !block.groups.is_empty())
        .collect();
    if dimension < 2 || sides.is_empty() {
        return;
    }
    let facets = Facets::on(mesh, &sides);
    let mut sides_of: BTreeMap<&str, Vec<&ElementBlock>> = BTreeMap::new();
    for side in sides {
        for &group in &side.groups {
            sides_of.entry(&names[group as usize]).or_default().push(side);
        }
    }
    for (name, sides) in sides_of {
        let (mut faces, mut shared, mut loose) = (Vec::new(), Vec::new(), Vec::new());
        for side in sides {
            for (element, &tag) in side.nodes.chunks_exact(side.kind.nodes()).zip(&side.tags) {
                let found = facets.cells_at(side.kind, element);
                match *found {
                    [] => loose.push(tag),
                    [face] => faces.push(face),
                    [face, other, ..] => {
                        faces.push(face);
                        shared.push([mesh.cell_label(face.cell), mesh.cell_label(other.cell)]);
                    }
                }
            }
        }
        faces.sort_unstable();
        faces.dedup();
        if !shared.is_empty() {
            notes.push(Note::SharedFaces { surface: name.to_string(), cells: shared });
        }
        if !loose.is_empty() {
            notes.push(Note::LooseFacets { surface: name.to_string(), elements: loose });
        }
        if !faces.is_empty() {
            mesh.surfaces.insert(name.to_string(), faces);
        }
    }
}
