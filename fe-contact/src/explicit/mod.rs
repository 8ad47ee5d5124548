//! Contact in explicit steps: where surfaces are is found anew in every increment, and the laws are those of static steps.

mod carriers;
mod kinematic;
mod pair;
mod target;

pub use carriers::RigidFollower;
pub use pair::{ContactPair, Definition, Enforcement, Normal, PointState, Secondary, Viscosity};
pub use target::MainSurface;

#[cfg(test)]
mod tests;
