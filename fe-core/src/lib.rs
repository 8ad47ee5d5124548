//! Terms of the virtual work, materials, linear systems and procedures.
//!
//! Everything that is ever assembled is a [`term::Term`]; a procedure takes the converged state and a time
//! increment and returns the next converged state or a typed [`reject::Reject`]. Nothing here opens a file,
//! prints, or knows of contact.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod amplitude;
pub mod bodies;
pub mod element;
pub mod explicit;
pub mod external;
pub mod freedoms;
pub mod increment;
mod lanes;
pub mod linear;
pub mod load;
pub mod material;
pub mod matrix;
pub mod member;
pub mod nodal_stiffness;
pub mod procedure;
pub mod ramp;
pub mod reject;
pub mod section;
pub mod solid;
pub mod step;
pub mod structure;
pub mod term;
pub mod verify;

pub use freedoms::Freedoms;
pub use matrix::{BlockMatrix, Couplings, Pattern, Scatter};
pub use reject::Reject;
pub use structure::{Section, Structure};
pub use term::{Assembly, Motion, Term};
