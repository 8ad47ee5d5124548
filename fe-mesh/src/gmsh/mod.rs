//! The gmsh format, 4.1 and 2.2, text and binary: bytes in, mesh out; and back as 4.1.
//!
//! Sections that carry no mesh (`$Periodic`, `$NodeData`, unknown ones) are skipped. Partitioned files read as if they
//! were whole. Source of the format: gmsh reference manual, "MSH file format".

mod binary;
mod convert;
mod error;
mod facets;
mod header;
mod kind;
mod merge;
mod number;
mod out;
mod reader;
mod source;
mod tags;
mod text;
mod version_2;
mod version_4;
mod write;

use crate::cell::CellKind;

pub use convert::{Kept, Note};
pub use error::{GmshError, Place};
pub use write::{Encoding, write};

/// A gmsh file as it stands: nodes, elements, physical groups.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GmshMesh {
    /// Coordinates [L], `[points]`.
    pub points: Vec<[f64; 3]>,
    /// Node tags, `[points]`.
    pub tags: Vec<u64>,
    /// Elements, in the file's order as far as entities go.
    pub blocks: Vec<ElementBlock>,
    /// Physical groups, ascending by dimension and tag.
    pub groups: Vec<PhysicalGroup>,
}

/// Elements of one kind on one entity, all in the same physical groups.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementBlock {
    /// Kind of every element here.
    pub kind: CellKind,
    /// Tag of the entity (of that of the partition in partitioned files).
    pub entity: i32,
    /// Indices into [`GmshMesh::groups`], ascending.
    pub groups: Vec<u32>,
    /// Element tags, `[elements]`.
    pub tags: Vec<u64>,
    /// Point indices in the decks' local order, `[elements × kind.nodes()]`.
    pub nodes: Vec<u32>,
}

/// A physical group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PhysicalGroup {
    /// Dimension of its elements.
    pub dimension: usize,
    /// Its number.
    pub tag: i32,
    /// Its name as written, if it has one.
    pub name: Option<String>,
}

impl PhysicalGroup {
    /// Name of the sets that it becomes: capitals; `PHYSICAL_2_5` for surface group 5 without name.
    pub fn set_name(&self) -> String {
        match &self.name {
            Some(name) => name.trim().to_uppercase(),
            None => format!("PHYSICAL_{}_{}", self.dimension, self.tag),
        }
    }
}

impl GmshMesh {
    /// Highest dimension of an element of the file; 0 without elements.
    pub fn dimension(&self) -> usize {
        self.blocks.iter().map(|block| block.kind.dimension()).max().unwrap_or(0)
    }

    /// Indices of the groups with this name in whatever case, those of the highest dimension first.
    pub fn groups_named(&self, name: &str) -> Vec<usize> {
        let name = name.trim().to_uppercase();
        (0..self.groups.len()).rev().filter(|&group| self.groups[group].set_name() == name).collect()
    }
}

/// Reads a gmsh file of format 4.1 or 2.2, text or binary.
pub fn parse(bytes: &[u8]) -> Result<GmshMesh, GmshError> {
    reader::read(bytes)
}
