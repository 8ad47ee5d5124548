//! A contact pair as a model holds it.

use crate::surface::{Main, Secondary};

/// How the constraint is spread over the secondary surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Discretization {
    /// Each secondary node against its projection on the main surface.
    NodeToSurface,
    /// The gap averaged over the secondary surface around each of its nodes.
    SurfaceToSurface,
}

/// `ADJUST=` of a pair: secondary nodes are moved onto the main surface without strain before the first step.
#[derive(Clone, Debug, PartialEq)]
pub enum Adjust {
    /// Nodes that overlap, or are open by no more than this [L].
    Within(f64),
    /// The nodes of a set, whatever their distance, and those that overlap.
    Nodes(Vec<u32>),
}

/// A contact pair as a model holds it.
#[derive(Clone, Debug)]
pub struct PairDefinition {
    /// Name of the secondary surface.
    pub secondary_name: String,
    /// Name of the main surface.
    pub main_name: String,
    /// Secondary side.
    pub secondary: Secondary,
    /// Main side.
    pub main: Main,
    /// Index of the interaction.
    pub interaction: usize,
    /// Discretization.
    pub discretization: Discretization,
    /// True where the deck says that the surfaces hardly slide.
    pub small_sliding: bool,
    /// Strain-free adjustment.
    pub adjust: Option<Adjust>,
}
