//! Errors on a family of meshes, and the rate at which they fall.

use benchmarks::fit;

/// (h, error), coarse to fine.
pub type Errors = Vec<(f64, f64)>;

/// Slope over the last three meshes by least squares.
pub fn last_three(errors: &[(f64, f64)]) -> f64 {
    fit::slope(&errors[errors.len() - 3..])
}

/// A line of a table: slope over the last three, and the errors.
pub fn line(errors: &[(f64, f64)]) -> String {
    let values: Vec<String> = errors.iter().map(|(_, e)| format!("{e:.3e}")).collect();
    format!("{:.3}: {}", last_three(errors), values.join(" "))
}
