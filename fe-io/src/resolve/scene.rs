//! What is known of the bodies while a deck is resolved.

use super::names::Scope;
use crate::deck::Deck;
use crate::deck::source::Span;
use crate::model::RigidBody;
use fe_contact::rigid::RigidSurface;
use fe_core::element::ElementType;
use fe_core::structure::{Hourglass, Structure};
use fe_mesh::{CellBlock, CellId};
use std::collections::{BTreeMap, BTreeSet};

/// What kind of steps a job has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Analysis {
    /// `*STATIC`.
    #[default]
    Static,
    /// `*DYNAMIC, EXPLICIT`.
    Explicit,
}

/// A surface by its name.
#[derive(Debug)]
pub enum Surface {
    /// Faces of elements; they stand in the mesh.
    Faces,
    /// Nodes, each with its area [L²] where one is given.
    Nodes(Vec<(u32, Option<f64>)>),
    /// Trusses and beams in space, ascending.
    Lines(Vec<CellId>),
    /// Analytical.
    Rigid(RigidSurface),
    /// Its lines are faulty, which was told.
    Faulty,
}

/// Bodies, labels and names.
pub struct Scene<'a> {
    /// The deck.
    pub deck: &'a Deck,
    /// Kind of its steps.
    pub analysis: Analysis,
    /// Bodies.
    pub structure: Structure,
    /// Labels and names: of the model itself first, then of each instance of the mesh.
    pub scopes: Vec<Scope>,
    /// Scope of the card that is read: what it defines belongs there.
    pub reading: usize,
    /// Scope in which labels and names are looked up: that of the card, unless it names an instance.
    pub inside: usize,
    /// Name of the assembly.
    pub assembly: Option<String>,
    /// Where each node's label stands, `[points]`.
    pub node_places: Vec<Span>,
    /// Elements in the order of the deck.
    pub cells: Vec<CellId>,
    /// Where each material's name stands.
    pub material_places: Vec<Span>,
    /// Where each element's label stands, by block.
    pub cell_places: Vec<Vec<Span>>,
    /// Surfaces, with the place of the name.
    pub surfaces: BTreeMap<String, (Surface, Span)>,
    /// Rigid bodies, each with the place of its card's name.
    pub rigid_bodies: Vec<(RigidBody, Span)>,
    /// `*SECTION CONTROLS` by name, each with its place.
    pub section_controls: BTreeMap<String, (Option<Hourglass>, Span)>,
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
            analysis: Analysis::default(),
            structure: Structure::default(),
            scopes: vec![Scope::default()],
            reading: 0,
            inside: 0,
            assembly: None,
            node_places: Vec::new(),
            cells: Vec::new(),
            material_places: Vec::new(),
            cell_places: Vec::new(),
            surfaces: BTreeMap::new(),
            rigid_bodies: Vec::new(),
            section_controls: BTreeMap::new(),
            faulty_sets: BTreeSet::new(),
            incomplete: false,
            unread: false,
            masks: Vec::new(),
        }
    }

    /// Reference node of a rigid surface.
    pub fn reference_of(&self, surface: &str) -> Option<u32> {
        let bodies = self.rigid_bodies.iter().map(|(body, _)| body);
        { bodies }.find(|body| body.surface.as_deref() == Some(surface)).map(|body| body.reference)
    }

    /// Index of the block of an element type.
    pub fn block_of(&mut self, element: ElementType) -> usize {
        let known = self.structure.elements.iter().position(|e| *e == element);
        known.unwrap_or_else(|| {
            self.structure.elements.push(element);
            self.structure.mesh.blocks.push(CellBlock::new(element.kind()));
            self.cell_places.push(Vec::new());
            self.structure.elements.len() - 1
        })
    }

    /// The element type of a cell.
    pub fn element_of(&self, cell: CellId) -> ElementType {
        self.structure.elements[cell.block as usize]
    }

    /// Where a cell's label stands.
    pub fn place_of(&self, cell: CellId) -> Option<Span> {
        self.cell_places.get(cell.block as usize)?.get(cell.cell as usize).copied()
    }
}
