//! Contact: laws, pairs of surfaces, projection and search. Everything passes through one
//! [`point::ContactPoint`], so that laws, enforcement and output are written once.

#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod adjust;
mod build;
mod carry;
pub mod closest;
pub mod conditions;
pub mod contact;
pub mod element;
mod enforce;
pub mod error;
pub mod explicit;
pub mod facet;
pub mod first_contact;
pub mod friction;
pub mod gap;
pub mod interaction;
pub mod interference;
pub mod law;
mod line;
pub mod node_to_surface;
pub mod overlap;
pub mod pair;
pub mod point;
pub mod polygon;
pub mod redundant;
pub mod rigid;
pub mod search;
pub mod share;
pub mod sides;
pub mod slide_line;
mod slip;
pub mod state;
pub mod stiffness;
pub mod summary;
pub mod surface;
pub mod surface_to_surface;
mod symmetry;
pub mod tangents;
mod term;
#[cfg(test)]
mod tests;
pub mod tube;
pub mod verify;
pub mod viscous;

pub use contact::Contact;
pub use error::PairError;
