//! The manual, printed from the keyword tables.
