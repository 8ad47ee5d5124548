//! Results: the HDF5 file that viewers open, and the tables.

mod container;
mod error;
pub mod fields;
pub mod grid;
pub mod hdf5;
pub mod history;
pub mod read;
mod steps;
pub mod table;

pub use error::ResultsError;
pub use fields::{FieldInfo, Location};
pub use grid::{Grid, GridBlock};
pub use hdf5::{Frame, JobInfo, ResultsFile};
pub use history::{HistoryInfo, HistoryRow};
pub use table::{ContactRow, ElementRow, PairForce, Tables};
