//! From cards to a model: names become indices, ranges are checked.
