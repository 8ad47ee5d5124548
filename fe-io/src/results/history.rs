//! Histories: rows of numbers in time, below `/Signorini`.

use super::container::{Attribute, Container, Numbers, Owner, Series};
use super::error::ResultsError;

/// Name of the history that certifies increments: it stands at `/Signorini/Certificate`, every other one at
/// `/Signorini/History/<name>`.
pub const CERTIFICATE: &str = "Certificate";
/// The history of the stored frames, kept by the file itself: row n belongs to frame n.
pub(crate) const FRAMES: &str = "Frames";
/// Rows a chunk: never compressed, so that a chunk is filled in place.
const CHUNK_ROWS: usize = 256;

/// A history: what its rows hold after time, step and increment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HistoryInfo {
    /// Name, such as `CF PUNCH-BLOCK`; [`CERTIFICATE`] for the certificate. No `/`, no `.`.
    pub name: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Dimension of each column (`F`, `L`, `1`), `[columns]`.
    pub units: Vec<String>,
    /// What it is, one line.
    pub meaning: String,
}

/// Values of one history at one increment.
#[derive(Clone, Copy, Debug)]
pub struct HistoryRow<'a> {
    /// Name of the history.
    pub name: &'a str,
    /// Values, `[columns]`.
    pub values: &'a [f64],
}

pub(crate) fn path(name: &str) -> String {
    if name == CERTIFICATE || name == FRAMES {
        format!("Signorini/{name}")
    } else {
        format!("Signorini/History/{name}")
    }
}

/// Checks the declarations, the certificate among them.
pub(crate) fn check(histories: &[HistoryInfo]) -> Result<(), ResultsError> {
    for (i, history) in histories.iter().enumerate() {
        let name = &history.name;
        let taken = name == FRAMES || histories[..i].iter().any(|h| h.name == *name);
        if name.is_empty() || name.contains(['/', '.']) || taken {
            return Err(ResultsError::Name(name.clone()));
        }
        ResultsError::length(format!("units of {name}"), history.columns.len(), history.units.len())?;
    }
    Ok(())
}

/// Creates the arrays of a history.
pub(crate) fn create(file: &impl Container, history: &HistoryInfo) -> Result<(), ResultsError> {
    let path = path(&history.name);
    let series = Series { columns: 3 + history.columns.len(), chunk_rows: CHUNK_ROWS, compressed: false };
    file.real_series(&path, series)?;
    let named = |first: [&'static str; 3], rest: &'_ [String]| -> Vec<String> {
        first.iter().map(|s| s.to_string()).chain(rest.iter().cloned()).collect()
    };
    for (attribute, texts) in [
        ("columns", named(["time", "step", "increment"], &history.columns)),
        ("unit", named(["T", "1", "1"], &history.units)),
    ] {
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        file.attribute(Owner::Array(&path), attribute, Attribute::Texts(&texts))?;
    }
    file.attribute(Owner::Array(&path), "meaning", Attribute::Text(&history.meaning))
}

/// Adds a row: `head` is time [T], step, increment.
pub(crate) fn append(file: &impl Container, head: [f64; 3], row: HistoryRow) -> Result<(), ResultsError> {
    let numbers: Vec<f64> = head.iter().chain(row.values).copied().collect();
    append_rows(file, row.name, &numbers)
}

/// Adds whole rows, each with its time, step, increment.
pub(crate) fn append_rows(file: &impl Container, name: &str, rows: &[f64]) -> Result<(), ResultsError> {
    file.append(&path(name), Numbers::Real(rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_checked() {
        let history = |name: &str, units: usize| HistoryInfo {
            name: name.into(),
            columns: vec!["x".into()],
            units: vec!["F".into(); units],
            meaning: String::new(),
        };
        assert!(check(&[history("A", 1), history(CERTIFICATE, 1)]).is_ok());
        assert!(matches!(check(&[history("A", 1), history("A", 1)]), Err(ResultsError::Name(_))));
        assert!(matches!(check(&[history("A.B", 1)]), Err(ResultsError::Name(_))));
        assert!(matches!(check(&[history(FRAMES, 1)]), Err(ResultsError::Name(_))));
        assert!(matches!(check(&[history("A", 0)]), Err(ResultsError::Length { .. })));
    }
}
