//! What a contact pair of explicit steps is made of.

use super::target::MainSurface;
use crate::friction::Coulomb;
use crate::law::NormalLaw;
use crate::viscous::DampingAmount;
use std::sync::Arc;

/// The secondary side: each node with what the law's number is multiplied by, area [L²], length [L], or 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Secondary {
    /// Nodes and their measures.
    pub nodes: Vec<(u32, f64)>,
}

/// How surfaces answer in normal direction.
#[derive(Clone, Debug)]
pub enum Normal {
    /// No overclosure wanted.
    Hard,
    /// A softened law.
    Softened(Arc<dyn NormalLaw>),
}

/// How contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enforcement {
    /// Springs; those of hard contact times this factor.
    Penalty(f64),
    /// Impulses that correct the end of every increment: hard contact is kept exactly, and no increment is shortened.
    Kinematic,
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
    /// Normal behaviour.
    pub normal: Normal,
    /// Enforcement.
    pub enforcement: Enforcement,
    /// Friction. It sticks on springs as stiff as those of hard contact, on its own where no element has given them a stiffness.
    pub friction: Option<Coulomb>,
    /// Damping across the surface of closed points; along it nothing is damped.
    pub damping: Option<DampingAmount>,
}
