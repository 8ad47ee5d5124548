//! Quadrature rules on the reference cells.
