//! Elements against what is known: patch, ranks, bending, incompressibility, rates.

mod patch;
mod ranks;
#[allow(dead_code)]
mod scene;
