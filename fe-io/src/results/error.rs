//! What can go wrong in writing results.

use std::path::{Path, PathBuf};

/// Why results could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// The file system refused.
    #[error("{path}: {source}")]
    File {
        /// The file meant.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The HDF5 layer refused.
    #[error("{path}: {cause}")]
    Storage {
        /// The file meant.
        path: PathBuf,
        /// What it said.
        cause: String,
    },
    /// An array does not have the length its declaration says.
    #[error("{what}: {expected} numbers belong here, {found} were given")]
    Length {
        /// The array.
        what: String,
        /// Numbers declared.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// A cell names a point that the grid does not have.
    #[error("cell {label} names point {point} of {points}")]
    Point {
        /// Label of the cell.
        label: u64,
        /// Index it names.
        point: u32,
        /// Number of points.
        points: usize,
    },
    /// A name that cannot stand in the file: empty, used twice, or with `/` or `.` in it.
    #[error("`{0}` cannot name an array of the results file")]
    Name(String),
    /// A history that was not declared when the file was created.
    #[error("no history `{0}` was declared")]
    UnknownHistory(String),
    /// An earlier increment was only partly written; what was complete before it is safe.
    #[error("{0}: an earlier increment could not be written, nothing more is added")]
    Halted(PathBuf),
}

impl ResultsError {
    pub(crate) fn file(path: &Path, source: std::io::Error) -> Self {
        ResultsError::File { path: path.into(), source }
    }

    pub(crate) fn length(what: impl Into<String>, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(ResultsError::Length { what: what.into(), expected, found }) }
    }
}
