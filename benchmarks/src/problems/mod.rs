//! Problems with known answers: geometry at any refinement, deck and mesh as a user would write them, and the answer.

pub mod cantilever;
