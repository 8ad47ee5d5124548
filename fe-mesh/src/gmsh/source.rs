//! The numbers of a section, whichever way they are encoded.

use super::error::Fault;

/// A place in the file from which numbers are read, as text or as binary.
pub(super) trait Source {
    /// True for binary.
    const BINARY: bool;
    /// Offset of the next byte.
    fn at(&self) -> usize;
    /// Bytes from here to the end of the file.
    fn left(&self) -> usize;
    /// Goes to the next record: over line ends.
    fn begin(&mut self);
    /// Ends a record: nothing more may stand on the line.
    fn end(&mut self) -> Result<(), Fault>;
    /// The next count or tag (`size_t`).
    fn size(&mut self) -> Result<u64, Fault>;
    /// Reads many counts or tags at once, where the encoding allows it and they are there; else reads none.
    fn sizes(&mut self, _values: &mut [u64]) -> bool {
        false
    }
    /// The count that opens a section of format 2.2: text in binary files too.
    fn count_line(&mut self) -> Result<u64, Fault>;
    /// The next `int`.
    fn int(&mut self) -> Result<i32, Fault>;
    /// The next `double`, which may be anything.
    fn float(&mut self) -> Result<f64, Fault>;
    /// Skips ints.
    fn skip_ints(&mut self, many: usize) -> Result<(), Fault> {
        (0..many).try_for_each(|_| self.int().map(drop))
    }
    /// Skips counts or tags.
    fn skip_sizes(&mut self, many: usize) -> Result<(), Fault> {
        (0..many).try_for_each(|_| self.size().map(drop))
    }
    /// Skips doubles.
    fn skip_floats(&mut self, many: usize) -> Result<(), Fault> {
        (0..many).try_for_each(|_| self.float().map(drop))
    }
    /// Goes to a place where reading was before.
    fn go_to(&mut self, at: usize);
    /// Bytes of a count or tag in binary.
    fn size_bytes(&self) -> usize;
    /// Skips records, of `bytes` each in binary: finds the place of one of them again.
    fn skip_records(&mut self, records: usize, bytes: usize);
}

/// A count as announced, once the rest of the file is long enough for so many records of `values` numbers.
pub(super) fn count<S: Source>(source: &S, announced: u64, values: usize, what: &str) -> Result<usize, Fault> {
    let least = if S::BINARY { 4 * values } else { 2 * values - 1 };
    let possible = (source.left() / least) as u64;
    if announced > possible {
        let what = format!("{announced} {what} announced, but only {} bytes follow", source.left());
        return Err(Fault::new(source.at(), what).allow("a complete file: was it cut off?"));
    }
    Ok(announced as usize)
}

/// A count written as `size_t`, checked as [`count`] does.
pub(super) fn read_count<S: Source>(source: &mut S, values: usize, what: &str) -> Result<usize, Fault> {
    let announced = source.size()?;
    count(source, announced, values, what)
}
