//! Raw rows: one for each run, with machine, command, versions and commit.

use crate::machine::Origin;
use crate::measure::Cost;
use crate::problem::Norm;
use std::fmt::Write as _;
use std::io;
use std::path::Path;

/// What was run, and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Element and enforcement.
    pub curve: String,
    /// Refinement.
    pub n: usize,
    /// Free unknowns.
    pub unknowns: usize,
    /// Program and version.
    pub version: String,
    /// Threads.
    pub threads: usize,
    /// Number of the run, from 1.
    pub run: usize,
    /// What it took.
    pub cost: Cost,
    /// Relative errors, one for each norm of the problem.
    pub errors: Vec<f64>,
    /// The command, without folders.
    pub command: String,
}

/// Writes the rows of a problem as a table of comma-separated values.
pub fn write(path: &Path, origin: &Origin, norms: &[Norm], rows: &[Row]) -> io::Result<()> {
    let mut text = String::from("curve,n,unknowns,version,commit,machine,threads,run,wall_s,cpu_s,peak_bytes");
    norms.iter().for_each(|norm| text.push_str(&format!(",\"{}\"", norm.name)));
    text.push_str(",command\n");
    for row in rows {
        let Row { curve, n, unknowns, version, threads, run, cost, errors, command } = row;
        // Writing to a string does not fail.
        let _ = write!(
            text,
            "\"{curve}\",{n},{unknowns},{version},{},\"{}\",{threads},{run},{:.4},{:.4},{:.0}",
            origin.commit, origin.machine, cost.wall, cost.cpu, cost.memory
        );
        errors.iter().for_each(|error| text.push_str(&format!(",{error:.6e}")));
        let _ = writeln!(text, ",{command}");
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    std::fs::write(path, text)
}

/// The middle of the values, the mean of the two in the middle of an even number; NaN of none.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    quantile(values, 0.5)
}

/// The value below which this part of the values lies, linear between neighbours; NaN of none.
pub fn quantile(values: impl IntoIterator<Item = f64>, part: f64) -> f64 {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = part * last as f64;
    let (low, high) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    low + (high - low) * place.fract()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_lie_between_neighbours() {
        assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median([4.0, 1.0, 2.0, 3.0]), 2.5);
        assert_eq!(quantile([0.0, 1.0, 2.0, 3.0, 4.0], 0.25), 1.0);
        assert!(median([]).is_nan());
    }
}
