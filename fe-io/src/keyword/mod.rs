//! The cards that decks may hold: one table a card, for reader, messages and manual.
