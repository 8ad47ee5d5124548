//! Elements against what is known: patch, ranks, bending, incompressibility, rates.

mod beams;
mod incompressible;
mod loads;
mod norms;
mod patch;
mod ranks;
mod rates;
#[allow(dead_code)]
mod scene;
mod speed;
mod term;
