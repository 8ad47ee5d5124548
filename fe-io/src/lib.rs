//! Decks, diagnostics and results files: the only crate that opens files.

pub mod deck;
pub mod diagnostic;
pub mod keyword;
pub mod manual;
pub mod model;
pub mod resolve;
pub mod results;

pub use model::Model;
