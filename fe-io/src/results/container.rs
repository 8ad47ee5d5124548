//! What the results file needs of a hierarchical container, and the container in use.

use super::error::ResultsError;
use rust_hdf5::types::VarLenUnicode;
use rust_hdf5::{DatatypeMessage, FileLocking, H5Dataset, H5File, H5Group, H5Type};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Numbers of an array, row after row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Numbers<'a> {
    Real(&'a [f64]),
    Integer(&'a [i64]),
    Byte(&'a [u8]),
}

/// Value of an attribute.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Attribute<'a> {
    Text(&'a str),
    /// Fixed-length ASCII, as VTK writes its own type names.
    Ascii(&'a str),
    Texts(&'a [&'a str]),
    Integer(i64),
    Integers(&'a [i64]),
}

/// What an attribute hangs on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Owner<'a> {
    Group(&'a str),
    Array(&'a str),
}

/// An array that grows by rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series {
    /// Numbers a row; 1: an array of rank one.
    pub(crate) columns: usize,
    /// Rows a chunk.
    pub(crate) chunk_rows: usize,
    /// Shuffle and deflate. Only for series whose appends are whole chunks: a compressed chunk that is
    /// rewritten moves, and a process that dies meanwhile leaves the chunk lost.
    pub(crate) compressed: bool,
}

/// A file of groups, arrays and attributes. Paths are absolute, `Group/array`, without a leading slash.
/// What is written is in the file after [`Container::close`], and only then.
pub(crate) trait Container: Sized {
    fn create(path: &Path) -> Result<Self, ResultsError>;
    fn open(path: &Path) -> Result<Self, ResultsError>;
    /// `durable`: wait until the disk has it.
    fn close(self, durable: bool) -> Result<(), ResultsError>;
    fn group(&self, path: &str) -> Result<(), ResultsError>;
    fn attribute(&self, owner: Owner, name: &str, value: Attribute) -> Result<(), ResultsError>;
    /// An array that never changes, `[rows × columns]`, rank one when `columns` is 1.
    fn array(&self, path: &str, columns: usize, numbers: Numbers) -> Result<(), ResultsError>;
    fn real_series(&self, path: &str, series: Series) -> Result<(), ResultsError>;
    fn integer_series(&self, path: &str, series: Series) -> Result<(), ResultsError>;
    fn append(&self, path: &str, numbers: Numbers) -> Result<(), ResultsError>;
    /// A second name of an array.
    fn alias(&self, path: &str, of: &str) -> Result<(), ResultsError>;
}

/// The container in use: HDF5 in Rust alone. No lock is held, so that a viewer can look at a running job.
pub(crate) struct RustHdf5 {
    file: H5File,
    path: PathBuf,
}

impl RustHdf5 {
    fn said<T, E: Display>(&self, result: Result<T, E>) -> Result<T, ResultsError> {
        said(&self.path, result)
    }

    fn open_group(&self, path: &str) -> Result<H5Group, ResultsError> {
        let root = self.file.root_group();
        if path.is_empty() { Ok(root) } else { self.said(root.group(path)) }
    }

    fn parent<'p>(&self, path: &'p str) -> Result<(H5Group, &'p str), ResultsError> {
        let (group, name) = path.rsplit_once('/').unwrap_or(("", path));
        Ok((self.open_group(group)?, name))
    }

    fn dataset(&self, path: &str) -> Result<H5Dataset, ResultsError> {
        self.said(self.file.dataset_writer(path))
    }

    fn fixed<T: H5Type>(&self, path: &str, columns: usize, numbers: &[T]) -> Result<(), ResultsError> {
        let (group, name) = self.parent(path)?;
        let rows = numbers.len() / columns;
        let shape = if columns == 1 { vec![rows] } else { vec![rows, columns] };
        let mut builder = group.new_dataset::<T>().shape(&shape);
        if rows > 0 {
            let mut chunk = shape;
            chunk[0] = aligned_chunk(rows).rows;
            builder = builder.chunk(&chunk).shuffle_deflate(DEFLATE_LEVEL);
        }
        let dataset = self.said(builder.create(name))?;
        if rows > 0 { self.said(dataset.write_raw(numbers)) } else { Ok(()) }
    }

    fn growing<T: H5Type>(&self, path: &str, series: Series) -> Result<(), ResultsError> {
        let (group, name) = self.parent(path)?;
        let (shape, chunk, most) = if series.columns == 1 {
            (vec![0], vec![series.chunk_rows], vec![None])
        } else {
            (vec![0, series.columns], vec![series.chunk_rows, series.columns], vec![None, Some(series.columns)])
        };
        let mut builder = group.new_dataset::<T>().shape(&shape).chunk(&chunk).max_shape(&most);
        if series.compressed {
            builder = builder.shuffle_deflate(DEFLATE_LEVEL);
        }
        self.said(builder.create(name)).map(|_| ())
    }
}

/// 5 % larger than level 4 on smooth fields at a third of the time.
const DEFLATE_LEVEL: u32 = 1;

fn said<T, E: Display>(path: &Path, result: Result<T, E>) -> Result<T, ResultsError> {
    result.map_err(|e| ResultsError::Storage { path: path.into(), cause: e.to_string() })
}

/// How the rows of one frame are cut into chunks of equal length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AlignedChunk {
    /// Rows a chunk, at least 1.
    pub(crate) rows: usize,
    /// Rows a frame takes in the file: `rows × chunks`, at most `chunks − 1` more than it has.
    pub(crate) frame_rows: usize,
}

/// Chunks of at most 16384 rows, so that a frame begins with a chunk.
pub(crate) fn aligned_chunk(rows: usize) -> AlignedChunk {
    let chunks = rows.div_ceil(16384).max(1);
    let chunk = rows.div_ceil(chunks).max(1);
    AlignedChunk { rows: chunk, frame_rows: if rows == 0 { 0 } else { chunk * chunks } }
}

impl Container for RustHdf5 {
    fn create(path: &Path) -> Result<Self, ResultsError> {
        let file = said(path, H5File::options().locking(FileLocking::Disabled).create(path))?;
        Ok(RustHdf5 { file, path: path.into() })
    }

    fn open(path: &Path) -> Result<Self, ResultsError> {
        let file = said(path, H5File::options().locking(FileLocking::Disabled).open_rw(path))?;
        Ok(RustHdf5 { file, path: path.into() })
    }

    fn close(self, durable: bool) -> Result<(), ResultsError> {
        said(&self.path, if durable { self.file.close() } else { self.file.close_no_sync() })
    }

    fn group(&self, path: &str) -> Result<(), ResultsError> {
        let (group, name) = self.parent(path)?;
        self.said(group.create_group(name)).map(|_| ())
    }

    fn attribute(&self, owner: Owner, name: &str, value: Attribute) -> Result<(), ResultsError> {
        match owner {
            Owner::Group(path) => {
                let group = self.open_group(path)?;
                self.said(match value {
                    Attribute::Text(text) => group.set_attr_string(name, text),
                    Attribute::Ascii(text) => {
                        let kind = DatatypeMessage::fixed_string(text.len() as u32);
                        group.set_attr_typed(name, kind, text.as_bytes().to_vec())
                    }
                    Attribute::Texts(texts) => group.set_attr_string_array(name, texts),
                    Attribute::Integer(value) => group.set_attr_numeric(name, &value),
                    Attribute::Integers(values) => group.set_attr_array_numeric(name, values),
                })
            }
            Owner::Array(path) => {
                let dataset = self.dataset(path)?;
                let text = dataset.new_attr::<VarLenUnicode>();
                let number = dataset.new_attr::<i64>();
                self.said(match value {
                    Attribute::Text(value) | Attribute::Ascii(value) => {
                        text.shape(()).create(name).and_then(|a| a.write_string(value))
                    }
                    Attribute::Texts(values) => {
                        text.shape([values.len()]).create(name).and_then(|a| a.write_string_array(values))
                    }
                    Attribute::Integer(value) => number.shape(()).create(name).and_then(|a| a.write_numeric(&value)),
                    Attribute::Integers(values) => {
                        number.shape([values.len()]).create(name).and_then(|a| a.write_array(values))
                    }
                })
            }
        }
    }

    fn array(&self, path: &str, columns: usize, numbers: Numbers) -> Result<(), ResultsError> {
        match numbers {
            Numbers::Real(values) => self.fixed(path, columns, values),
            Numbers::Integer(values) => self.fixed(path, columns, values),
            Numbers::Byte(values) => self.fixed(path, columns, values),
        }
    }

    fn real_series(&self, path: &str, series: Series) -> Result<(), ResultsError> {
        self.growing::<f64>(path, series)
    }

    fn integer_series(&self, path: &str, series: Series) -> Result<(), ResultsError> {
        self.growing::<i64>(path, series)
    }

    fn append(&self, path: &str, numbers: Numbers) -> Result<(), ResultsError> {
        let dataset = self.dataset(path)?;
        self.said(match numbers {
            Numbers::Real(values) => dataset.append(values),
            Numbers::Integer(values) => dataset.append(values),
            Numbers::Byte(values) => dataset.append(values),
        })
    }

    fn alias(&self, path: &str, of: &str) -> Result<(), ResultsError> {
        let (group, name) = self.parent(path)?;
        self.said(group.link(name, of))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A frame is whole chunks, padded by less than a row a chunk.
    #[test]
    fn frames_are_whole_chunks() {
        for rows in [1, 2, 16383, 16384, 16385, 32769, 100_001, 1_000_003] {
            let chunk = aligned_chunk(rows);
            let chunks = chunk.frame_rows / chunk.rows;
            assert_eq!(chunk.frame_rows % chunk.rows, 0);
            assert!(chunk.rows <= 16384 && chunk.frame_rows >= rows && chunk.frame_rows < rows + chunks.max(2));
        }
        assert_eq!(aligned_chunk(0), AlignedChunk { rows: 1, frame_rows: 0 });
    }
}
