//! Shape functions on the reference cells.
