//! Tests of trusses, beams and springs.

mod beams;
mod scene;
mod springs;
mod trusses;
