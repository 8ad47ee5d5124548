//! Decks as written: cards, parameters and data, each with its place.
