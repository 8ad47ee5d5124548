//! What is known of the bodies while a deck is resolved.

use super::labels::Labels;
use crate::deck::Deck;
use crate::deck::card::{Token, normalized};
use crate::deck::number::whole;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use fe_contact::rigid::RigidSurface;
use fe_core::element::ElementType;
use fe_core::structure::Structure;
use fe_mesh::{CellBlock, CellId};
use std::collections::{BTreeMap, BTreeSet};

/// A surface by its name.
#[derive(Debug)]
pub enum Surface {
    /// Faces of elements; they stand in the mesh.
    Faces,
    /// Nodes, each with its area [L²] where one is given.
    Nodes(Vec<(u32, Option<f64>)>),
    /// Analytical.
    Rigid(RigidSurface),
    /// Its lines are faulty, which was told.
    Faulty,
}

/// Bodies, labels and names.
pub struct Scene<'a> {
    /// The deck.
    pub deck: &'a Deck,
    /// Bodies.
    pub structure: Structure,
    /// Node labels.
    pub nodes: Labels,
    /// Where each node's label stands, `[points]`.
    pub node_places: Vec<Span>,
    /// Element labels, to indices into `cells`.
    pub elements: Labels,
    /// Elements in the order of the deck.
    pub cells: Vec<CellId>,
    /// Where each element's label stands, as `cells`.
    pub cell_places: Vec<Span>,
    /// Surfaces, with the place of the name.
    pub surfaces: BTreeMap<String, (Surface, Span)>,
    /// Reference node of each rigid surface.
    pub references: BTreeMap<String, u32>,
    /// Element sets of which nothing is left because their elements are faulty, which was told.
    pub faulty_sets: BTreeSet<String>,
    /// True when elements are missing because their lines are faulty, which was told.
    pub incomplete: bool,
    /// True when a mesh file could not be read, which was told: no name is known then.
    pub unread: bool,
    /// Freedoms of each node, a bit each, `[points]`; filled when all bodies are read.
    pub masks: Vec<u8>,
}

impl<'a> Scene<'a> {
    /// Nothing yet.
    pub fn new(deck: &'a Deck) -> Self {
        Scene {
            deck,
            structure: Structure::default(),
            nodes: Labels::default(),
            node_places: Vec::new(),
            elements: Labels::default(),
            cells: Vec::new(),
            cell_places: Vec::new(),
            surfaces: BTreeMap::new(),
            references: BTreeMap::new(),
            faulty_sets: BTreeSet::new(),
            incomplete: false,
            unread: false,
            masks: Vec::new(),
        }
    }

    /// Index of the block of an element type.
    pub fn block_of(&mut self, element: ElementType) -> usize {
        let known = self.structure.elements.iter().position(|e| *e == element);
        known.unwrap_or_else(|| {
            self.structure.elements.push(element);
            self.structure.mesh.blocks.push(CellBlock::new(element.kind()));
            self.structure.elements.len() - 1
        })
    }

    /// The element type of a cell.
    pub fn element_of(&self, cell: CellId) -> ElementType {
        self.structure.elements[cell.block as usize]
    }

    /// Where a cell's label stands.
    pub fn place_of(&self, cell: CellId) -> Option<Span> {
        let ordinal = self.elements.get(self.structure.mesh.cell_label(cell))?;
        self.cell_places.get(ordinal as usize).copied()
    }

    /// The node with a label; a missing one is told.
    pub fn node(&self, token: Token<'_>, label: u64, diagnostics: &mut Diagnostics) -> Option<u32> {
        let node = self.nodes.get(label);
        if node.is_none() && !self.nodes.is_faulty(label) {
            diagnostics.push(Diagnostic::error(token.span, format!("node {label} is not there")));
        }
        node
    }

    /// The element with a label; a missing one is told.
    pub fn cell(&self, token: Token<'_>, label: u64, diagnostics: &mut Diagnostics) -> Option<CellId> {
        let ordinal = self.elements.get(label);
        if ordinal.is_none() && !self.elements.is_faulty(label) {
            diagnostics.push(Diagnostic::error(token.span, format!("element {label} is not there")));
        }
        self.cells.get(ordinal? as usize).copied()
    }

    /// The nodes that a label or the name of a set means; `None` when it means nothing, which is told.
    pub fn nodes_of(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<u32>> {
        match whole(token.text) {
            Some(label) => self.node(token, label, diagnostics).map(|node| vec![node]),
            None => set(&self.structure.mesh.node_sets, "node set", token, diagnostics).map(<[u32]>::to_vec),
        }
    }

    /// The elements that a label or the name of a set means; `None` when it means nothing, which is told.
    pub fn cells_of(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<CellId>> {
        match whole(token.text) {
            Some(label) => self.cell(token, label, diagnostics).map(|cell| vec![cell]),
            None => self.cell_set(token, diagnostics).map(<[CellId]>::to_vec),
        }
    }

    /// An element set by name; `None` when it is missing or empty, which is told.
    pub fn cell_set(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<&[CellId]> {
        let sets = &self.structure.mesh.cell_sets;
        let name = normalized(token.text);
        if self.faulty_sets.contains(&name) && sets.get(&name).is_none_or(Vec::is_empty) {
            return None;
        }
        set(sets, "element set", token, diagnostics)
    }

    /// Label of a node.
    pub fn node_label(&self, node: u32) -> u64 {
        self.structure.mesh.point_labels[node as usize]
    }
}

/// A set by name; a missing or an empty one is told.
pub fn set<'m, T>(
    sets: &'m BTreeMap<String, Vec<T>>,
    kind: &str,
    token: Token<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<&'m [T]> {
    let name = normalized(token.text);
    match sets.get(&name) {
        Some(set) if !set.is_empty() => Some(set),
        Some(_) => {
            let filled = sets.iter().filter(|(_, set)| !set.is_empty()).map(|(name, _)| name.as_str());
            diagnostics.push(Diagnostic::error(token.span, format!("{kind} `{name}` is empty")).known(&name, filled));
            None
        }
        None => {
            let fault = Diagnostic::error(token.span, format!("there is no {kind} `{name}`"));
            diagnostics.push(fault.known(&name, sets.keys().map(String::as_str)));
            None
        }
    }
}
