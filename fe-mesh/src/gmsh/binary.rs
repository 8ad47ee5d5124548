//! Numbers written as binary.

use super::error::Fault;
use super::source::Source;
use super::text::Text;

/// Reads numbers from binary.
pub(super) struct Binary<'a> {
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
}

/// How binary numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Encoding {
    /// Written by a machine of the other byte order than little-endian.
    pub big_endian: bool,
    /// Bytes of a count or tag: 4 or 8.
    pub size_bytes: usize,
}

impl<'a> Binary<'a> {
    pub fn new(bytes: &'a [u8], at: usize, encoding: Encoding) -> Self {
        Binary { bytes, at, encoding }
    }

    #[inline]
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        match self.bytes[self.at..].first_chunk::<N>() {
            Some(chunk) => {
                self.at += N;
                let mut chunk = *chunk;
                if self.encoding.big_endian {
                    chunk.reverse();
                }
                Ok(chunk)
            }
            None => Err(Fault::new(self.at, "the file ends in the middle of the section")
                .allow("a complete file: was it cut off?")),
        }
    }
}

impl Source for Binary<'_> {
    const BINARY: bool = true;

    fn at(&self) -> usize {
        self.at
    }

    fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn begin(&mut self) {}

    fn end(&mut self) -> Result<(), Fault> {
        Ok(())
    }

    #[inline]
    fn size(&mut self) -> Result<u64, Fault> {
        if self.encoding.size_bytes == 8 {
            self.take().map(u64::from_le_bytes)
        } else {
            self.take().map(|bytes| u32::from_le_bytes(bytes) as u64)
        }
    }

    #[inline]
    fn sizes(&mut self, values: &mut [u64]) -> bool {
        let Encoding { big_endian: false, size_bytes: 8 } = self.encoding else { return false };
        let Some(bytes) = self.bytes[self.at..].get(..8 * values.len()) else { return false };
        for (value, bytes) in values.iter_mut().zip(bytes.as_chunks::<8>().0) {
            *value = u64::from_le_bytes(*bytes);
        }
        self.at += bytes.len();
        true
    }

    fn count_line(&mut self) -> Result<u64, Fault> {
        let mut text = Text::new(self.bytes, self.at);
        let value = text.size()?;
        text.end()?;
        self.at = (text.at() + 1).min(self.bytes.len());
        Ok(value)
    }

    #[inline]
    fn int(&mut self) -> Result<i32, Fault> {
        self.take().map(i32::from_le_bytes)
    }

    #[inline]
    fn float(&mut self) -> Result<f64, Fault> {
        self.take().map(f64::from_le_bytes)
    }

    fn go_to(&mut self, at: usize) {
        self.at = at;
    }

    fn size_bytes(&self) -> usize {
        self.encoding.size_bytes
    }

    fn skip_records(&mut self, records: usize, bytes: usize) {
        self.at = self.at.saturating_add(records.saturating_mul(bytes)).min(self.bytes.len());
    }
}
