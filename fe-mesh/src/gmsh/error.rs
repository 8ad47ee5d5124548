//! Why a mesh is not read, and where it says so.

use std::fmt;

/// A mesh that cannot be read: what is wrong, where, and what would be allowed there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GmshError {
    /// What is wrong.
    pub what: String,
    /// Where.
    pub place: Place,
    /// What is allowed instead, where that helps.
    pub allowed: Option<String>,
}

/// A place in a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of a text file, from 1.
    Line(usize),
    /// A byte of a binary file, from 0, and the section that holds it.
    Byte {
        /// Byte of the file, from 0.
        offset: usize,
        /// Name of the section, without `$`.
        section: String,
        /// Line on which the section starts, from 1, line ends counted as an editor does.
        line: usize,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Place::Line(line) => write!(f, "line {line}"),
            Place::Byte { offset, section, line } => write!(f, "byte {offset}, in ${section} (from line {line})"),
        }
    }
}

impl fmt::Display for GmshError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.what)?;
        match &self.allowed {
            Some(allowed) => write!(f, "; allowed: {allowed}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for GmshError {}

/// An error on its way up: the offset becomes a line only where the error is handed out.
#[derive(Debug)]
pub(super) struct Fault(Box<(usize, String, Option<String>)>);

impl Fault {
    #[cold]
    pub fn new(offset: usize, what: impl Into<String>) -> Self {
        Fault(Box::new((offset, what.into(), None)))
    }

    /// Adds what is allowed instead.
    pub fn allow(mut self, allowed: impl Into<String>) -> Self {
        self.0.2 = Some(allowed.into());
        self
    }

    /// Adds words in front: whose number was wrong.
    pub fn within(mut self, context: impl fmt::Display) -> Self {
        self.0.1 = format!("{context}: {}", self.0.1);
        self
    }

    /// The error with its place: a line of text, or a byte of a section that starts at `section.1`.
    pub fn placed(self, bytes: &[u8], section: Option<(&str, usize)>) -> GmshError {
        let (offset, what, allowed) = *self.0;
        let line_of = |offset: usize| 1 + bytes[..offset.min(bytes.len())].iter().filter(|&&b| b == b'\n').count();
        let place = match section {
            Some((name, start)) => Place::Byte { offset, section: name.to_string(), line: line_of(start) },
            None => Place::Line(line_of(offset)),
        };
        GmshError { what, place, allowed }
    }
}
