//! Decks, diagnostics and results files: the only crate that opens files.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod deck;
pub mod diagnostic;
pub mod keyword;
pub mod manual;
pub mod memory;
pub mod model;
pub mod resolve;
pub mod results;

pub use deck::Deck;
pub use diagnostic::{Diagnostic, Diagnostics, Severity};
pub use model::Model;
pub use resolve::{Library, resolve};
