//! Meshes: cells, sets, surfaces, shape functions, quadrature and the gmsh format.
//!
//! This crate knows geometry only: no freedoms, no materials, no files (the gmsh parser takes bytes).

#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod cell;
pub mod check;
mod exterior;
pub mod generate;
pub mod gmsh;
pub mod mesh;
pub mod quadrature;
pub mod shape;

pub use cell::CellKind;
pub use exterior::exterior;
pub use mesh::{CellBlock, CellId, Face, Instance, Mesh};
