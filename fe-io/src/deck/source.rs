//! Texts that were read, and places in them.

use crate::model::Place;
use std::sync::Arc;

/// One file as it was read.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// File as the user named it.
    pub name: Arc<str>,
    /// Its text; bytes that are no UTF-8 are replaced.
    pub text: String,
}

/// A piece of a source: file and byte range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Index into [`super::Deck::sources`].
    pub source: u32,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Source {
    /// Line of a byte, from 1.
    pub fn line(&self, at: u32) -> u32 {
        let before = &self.text.as_bytes()[..(at as usize).min(self.text.len())];
        1 + before.iter().filter(|&&b| b == b'\n').count() as u32
    }

    /// Byte range of the line that holds a byte, without its end.
    pub fn line_range(&self, at: u32) -> std::ops::Range<usize> {
        let at = (at as usize).min(self.text.len());
        let bytes = self.text.as_bytes();
        let start = bytes[..at].iter().rposition(|&b| b == b'\n').map_or(0, |p| p + 1);
        let end = bytes[at..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |p| at + p);
        start..if end > start && bytes[end - 1] == b'\r' { end - 1 } else { end }
    }

    /// Column of a byte, in characters from 1.
    pub fn column(&self, at: u32) -> usize {
        let range = self.line_range(at);
        1 + self.text[range.start..(at as usize).clamp(range.start, range.end)].chars().count()
    }

    /// File and line of a byte.
    pub fn place(&self, at: u32) -> Place {
        Place { file: self.name.clone(), line: self.line(at) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_count_from_one() {
        let source = Source { name: "a".into(), text: "ä,b\r\nc\n".into() };
        assert_eq!((source.line(0), source.line(3), source.line(6), source.line(99)), (1, 1, 2, 3));
        assert_eq!(source.column(3), 3);
        assert_eq!(&source.text[source.line_range(3)], "ä,b");
        assert_eq!(&source.text[source.line_range(6)], "c");
    }
}
