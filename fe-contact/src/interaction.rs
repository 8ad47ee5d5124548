//! What a `*SURFACE INTERACTION` says.

use crate::friction::Friction;
use crate::law::NormalLaw;
use crate::law::nonlinear_penalty::NonlinearPenalty;
use crate::law::scale_factor::Scaling;
use crate::viscous::{Damping, ExplicitDamping};
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
    /// By a penalty, and multipliers until the overclosure is at most a thousandth of the facets' length, a twentieth where
    /// surfaces may slide far; more where the penalty is scaled down.
    AugmentedLagrange(Penalty),
    /// By a penalty alone.
    Penalty(Penalty),
    /// By a penalty alone that grows with the overclosure.
    NonlinearPenalty(GrowingPenalty),
}

impl Enforcement {
    /// Its numbers, where it has any: of a nonlinear penalty those of the final slope.
    pub fn penalty(&self) -> Option<Penalty> {
        match *self {
            Enforcement::Usual | Enforcement::Direct => None,
            Enforcement::Penalty(penalty) | Enforcement::AugmentedLagrange(penalty) => Some(penalty),
            Enforcement::NonlinearPenalty(growing) => Some(growing.last),
        }
    }
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

/// A penalty that grows from K_i to K_f ([`crate::law::nonlinear_penalty`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrowingPenalty {
    /// With K = K_f.
    pub last: Penalty,
    /// Overclosure x_d from which on the slope is K_f, over the length of the facets [-], > 0.
    pub upper: f64,
    /// K_i/K_f [-], > 0.
    pub initial: f64,
    /// Overclosure x_e up to which the slope is K_i, over x_d [-], from 0 to 1.
    pub lower: f64,
}

impl Default for GrowingPenalty {
    fn default() -> Self {
        GrowingPenalty { last: Penalty::default(), upper: 0.03, initial: 0.01, lower: 1.0 / 3.0 }
    }
}

impl GrowingPenalty {
    /// The law with its final slope [F/L³], on facets of a length [L].
    pub fn over(&self, slope: f64, length: f64) -> NonlinearPenalty {
        let upper = self.upper * length;
        let (slopes, limits) = ([self.initial * slope, slope], [self.lower * upper, upper]);
        NonlinearPenalty { slopes, limits, clearance: self.last.clearance }
    }
}

/// A named interaction.
#[derive(Clone, Debug)]
pub struct Interaction {
    /// Name, capitals.
    pub name: String,
    /// Normal behaviour.
    pub normal: NormalBehavior,
    /// The law by scale factors over the penalty of hard contact, of general contact in explicit steps; `normal` is hard then.
    pub scale_factor: Option<Scaling>,
    /// `NO SEPARATION`: a point that closed stays closed, and may pull.
    pub no_separation: bool,
    /// `*FRICTION`; `None`: the surfaces slide freely.
    pub friction: Option<Friction>,
    /// `*CONTACT DAMPING`; `None`: the surfaces move freely.
    pub damping: Option<Damping>,
    /// `*CONTACT DAMPING` of explicit steps; `None`: [`ExplicitDamping::default`], none for hard kinematic contact.
    pub explicit_damping: Option<ExplicitDamping>,
    /// True where some step stabilises motions along the surfaces.
    pub stabilized_along: bool,
    /// The data line: out-of-plane thickness [L] (plane models) or the area [L²] of every node of a node-based
    /// surface.
    pub measure: Option<f64>,
}

impl Interaction {
    /// True where anything acts along the surfaces: points need their directions and rows there.
    pub fn acts_along(&self) -> bool {
        self.friction.is_some() || self.damping.is_some_and(|d| d.tangent_fraction > 0.0) || self.stabilized_along
    }
}
