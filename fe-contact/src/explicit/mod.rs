//! Contact in explicit steps: where surfaces are is found anew in every increment, and the laws are those of static steps.

mod behaviour;
mod border;
mod carriers;
mod definition;
mod foot;
mod general;
mod impulse;
mod kinematic;
mod pair;
mod penalty;
mod row;
mod sides;
mod state;
mod target;

pub use behaviour::{Behaviour, Normal, Separation};
pub use carriers::RigidFollower;
pub use definition::{Definition, Enforcement, Secondary};
pub use general::{
    Acting, Adjusted, Between, GeneralContact, GeneralCount, GeneralDefinition, GeneralFace, Sides, adjust,
};
pub use pair::{ContactPair, Unsettled};
pub use sides::PairSides;
pub use state::{NodeForce, Side, Tally};
pub use target::MainSurface;

#[cfg(test)]
mod tests;
