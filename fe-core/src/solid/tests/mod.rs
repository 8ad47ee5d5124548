//! Elements against what is known: patch, ranks, bending, incompressibility, rates.

mod loads;
mod patch;
mod ranks;
#[allow(dead_code)]
mod scene;
mod term;
