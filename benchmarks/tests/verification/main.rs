//! Verification: problems with known answers, run as a user runs them, deck and mesh through the program's entry.
//! Each test bears the name of its case.
//! Its figures are told as it goes (`--nocapture` shows them all).
#![allow(clippy::unwrap_used, clippy::print_stderr, non_snake_case)]

mod beams;
mod beams_on_rigid;
mod bending;
mod bodies;
mod cattaneo;
mod cattaneo_bodies;
mod contact_patch;
mod deck;
mod hertz;
mod lines;
mod patch;
mod punch;
mod rates;
mod receding;
mod smooth;
mod sphere;
mod sphere_window;
mod symmetry;
mod vessel;
mod window;
