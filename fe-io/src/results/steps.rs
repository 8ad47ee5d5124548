//! The temporal part of VTKHDF: where each frame's rows begin, and the commit of a frame.

use super::container::{Attribute, Container, Numbers, Owner, Series};
use super::error::ResultsError;
use super::fields::{FieldInfo, Location};
use super::grid::Grid;

const STEPS: &str = "VTKHDF/Steps";
const ZEROS: &str = "VTKHDF/Steps/PartOffsets";
const ONES: &str = "VTKHDF/Steps/NumberOfParts";
const VALUES: &str = "VTKHDF/Steps/Values";
/// One number a frame, never compressed, so that a chunk is filled in place; a new chunk is rarely needed.
const ONE_A_FRAME: Series = Series { columns: 1, chunk_rows: 1024, compressed: false };

impl Location {
    /// The group of the data, below `VTKHDF`.
    pub(crate) fn group(self) -> &'static str {
        match self {
            Location::Point => "PointData",
            Location::Cell => "CellData",
        }
    }
}

/// Creates the group and its arrays, without a frame. `Values` is the file's last array and the group has more than eight members:
/// so its members are listed elsewhere, `NSteps` stands in the first block of the group's header, that block is near the
/// header of `Values`, and both change in one write. Arrays that hold the same numbers are one array with
/// several names: all fields at points begin in the same row, and what never changes begins in row 0.
pub(crate) fn create(file: &impl Container, fields: &[FieldInfo], grid: &Grid) -> Result<(), ResultsError> {
    file.group(STEPS)?;
    file.attribute(Owner::Group(STEPS), "NSteps", Attribute::Integer(0))?;
    file.integer_series(ZEROS, ONE_A_FRAME)?;
    file.integer_series(ONES, ONE_A_FRAME)?;
    for name in ["PointOffsets", "CellOffsets", "ConnectivityIdOffsets"] {
        file.alias(&format!("{STEPS}/{name}"), ZEROS)?;
    }
    for location in [Location::Point, Location::Cell] {
        file.group(&format!("{STEPS}/{}Offsets", location.group()))?;
        let mut first: Option<String> = None;
        for field in fields.iter().filter(|f| f.location == location) {
            let path = format!("{STEPS}/{}Offsets/{}", location.group(), field.name);
            match &first {
                Some(first) => file.alias(&path, first)?,
                None => {
                    file.integer_series(&path, ONE_A_FRAME)?;
                    first = Some(path);
                }
            }
        }
    }
    file.group(&format!("{STEPS}/FieldDataOffsets"))?;
    for (name, group) in grid.constant_arrays() {
        file.alias(&format!("{STEPS}/{group}Offsets/{name}"), ZEROS)?;
    }
    file.real_series(VALUES, ONE_A_FRAME)
}

/// Adds the entries of a frame, all but its time. `first_row(location)`: row in which the frame's fields begin.
pub(crate) fn append(
    file: &impl Container,
    fields: &[FieldInfo],
    first_row: impl Fn(Location) -> usize,
) -> Result<(), ResultsError> {
    file.append(ZEROS, Numbers::Integer(&[0]))?;
    file.append(ONES, Numbers::Integer(&[1]))?;
    for location in [Location::Point, Location::Cell] {
        if let Some(field) = fields.iter().find(|f| f.location == location) {
            let path = format!("{STEPS}/{}Offsets/{}", location.group(), field.name);
            file.append(&path, Numbers::Integer(&[first_row(location) as i64]))?;
        }
    }
    Ok(())
}

/// Commits frame number `frames` at `time` [T]: readers look at `NSteps` frames and as many times.
pub(crate) fn commit(file: &impl Container, frames: usize, time: f64) -> Result<(), ResultsError> {
    file.append(VALUES, Numbers::Real(&[time]))?;
    file.attribute(Owner::Group(STEPS), "NSteps", Attribute::Integer(frames as i64))
}
