//! What a `*SURFACE INTERACTION` says.

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
    /// p = f K (h + c).
    Penalty {
        /// K [F/L³]; `None`: ten times the stiffness of the elements beneath.
        stiffness: Option<f64>,
        /// Clearance c [L] at which the pressure vanishes.
        clearance: f64,
        /// Factor f on K.
        scale: f64,
    },
}

/// A named interaction.
#[derive(Clone, Debug)]
pub struct Interaction {
    /// Name, capitals.
    pub name: String,
    /// Normal behaviour.
    pub normal: NormalBehavior,
    /// The data line: out-of-plane thickness [L] (plane models) or the area [L²] of every node of a node-based
    /// surface.
    pub measure: Option<f64>,
}
