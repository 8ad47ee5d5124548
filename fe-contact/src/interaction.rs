//! What a `*SURFACE INTERACTION` says.

use crate::friction::Friction;
use crate::law::NormalLaw;
use std::sync::Arc;

/// How the surfaces answer in normal direction.
#[derive(Clone, Debug)]
pub enum NormalBehavior {
    /// No overclosure allowed, enforced one way or another.
    Hard(Enforcement),
    /// A softened law.
    Softened(Arc<dyn NormalLaw>),
}

/// How hard contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enforcement {
    /// By what is usual for the pair: a penalty from surface to surface with finite sliding, multipliers otherwise (Abaqus
    /// Analysis User's Manual, Contact constraint enforcement methods).
    Usual,
    /// By multipliers: no overclosure but that of rounding.
    Direct,
    /// By a penalty, and multipliers until the overclosure is at most a thousandth of the facets' length.
    AugmentedLagrange(Penalty),
    /// By a penalty alone.
    Penalty(Penalty),
}

/// p = f K (h + c).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// K [F/L³]; `None`: a multiple of the stiffness of the elements beneath.
    pub stiffness: Option<f64>,
    /// Clearance c [L] at which the pressure vanishes.
    pub clearance: f64,
    /// Factor f on K.
    pub scale: f64,
}

impl Default for Penalty {
    fn default() -> Self {
        Penalty { stiffness: None, clearance: 0.0, scale: 1.0 }
    }
}

/// A named interaction.
#[derive(Clone, Debug)]
pub struct Interaction {
    /// Name, capitals.
    pub name: String,
    /// Normal behaviour.
    pub normal: NormalBehavior,
    /// `NO SEPARATION`: a point that closed stays closed, and may pull.
    pub no_separation: bool,
    /// `*FRICTION`; `None`: the surfaces slide freely.
    pub friction: Option<Friction>,
    /// The data line: out-of-plane thickness [L] (plane models) or the area [L²] of every node of a node-based
    /// surface.
    pub measure: Option<f64>,
}
