//! What a contact pair of explicit steps is made of.

use super::behaviour::Behaviour;
use super::target::MainSurface;
use crate::summary::MeasureKind;

/// The secondary side: each node with what the law's number is multiplied by, area [L²], length [L], or 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Secondary {
    /// Nodes and their measures.
    pub nodes: Vec<(u32, f64)>,
    /// What the law's number is.
    pub kind: MeasureKind,
}

/// How contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enforcement {
    /// Springs; those of hard contact times this factor.
    Penalty(f64),
    /// Impulses that correct the end of every increment: hard contact is kept exactly, and no increment is shortened. Where both
    /// sides are secondary, this one has a part [-] of them, else 1.
    Kinematic(f64),
}

/// A pair.
#[derive(Clone, Debug)]
pub struct Definition {
    /// `SECONDARY on MAIN`.
    pub name: String,
    /// Secondary side.
    pub secondary: Secondary,
    /// Main side.
    pub main: MainSurface,
    /// What acts between them.
    pub behaviour: Behaviour,
    /// Enforcement.
    pub enforcement: Enforcement,
}
