//! Numbers written as text.

use super::error::Fault;
use super::number;
use super::source::Source;

/// Reads numbers from text; those of a record stand on one line.
pub(super) struct Text<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Text<'a> {
    pub fn new(bytes: &'a [u8], at: usize) -> Self {
        Text { bytes, at }
    }

    /// Skips blanks, but no line end.
    fn skip_blanks(&mut self) {
        while matches!(self.bytes.get(self.at), Some(b' ' | b'\t' | b'\r')) {
            self.at += 1;
        }
    }

    /// The next word of this line, to be shown; empty at its end.
    fn word(&self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        &rest[..end]
    }

    #[cold]
    fn unexpected(&self, wanted: &str) -> Fault {
        let word = self.word();
        if self.at >= self.bytes.len() {
            Fault::new(self.at, format!("the file ends where {wanted} should stand"))
                .allow("a complete file: was it cut off?")
        } else if word.is_empty() {
            Fault::new(self.at, format!("the line ends where {wanted} should stand"))
        } else {
            let shown = String::from_utf8_lossy(&word[..word.len().min(32)]).into_owned();
            Fault::new(self.at, format!("`{shown}` stands where {wanted} should"))
        }
    }

    /// Digits from here on, as long as they fit; the number must end with a blank, a line end or the file.
    fn digits(&mut self, wanted: &str) -> Result<u64, Fault> {
        let start = self.at;
        let mut value = 0u64;
        let mut at = start;
        while let Some(digit) = self.bytes.get(at).map(|b| b.wrapping_sub(b'0')).filter(|&d| d < 10) {
            match value.checked_mul(10).and_then(|v| v.checked_add(digit as u64)) {
                Some(next) => value = next,
                None => return Err(self.unexpected(wanted)),
            }
            at += 1;
        }
        let ended = self.bytes.get(at).is_none_or(u8::is_ascii_whitespace);
        if at == start || !ended {
            return Err(self.unexpected(wanted));
        }
        self.at = at;
        Ok(value)
    }
}

impl Source for Text<'_> {
    const BINARY: bool = false;

    fn at(&self) -> usize {
        self.at
    }

    fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn begin(&mut self) {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    fn end(&mut self) -> Result<(), Fault> {
        self.skip_blanks();
        match self.bytes.get(self.at) {
            None | Some(b'\n') => Ok(()),
            Some(_) => Err(self.unexpected("the end of the line")),
        }
    }

    fn size(&mut self) -> Result<u64, Fault> {
        self.skip_blanks();
        self.digits("a count or tag")
    }

    fn count_line(&mut self) -> Result<u64, Fault> {
        self.size()
    }

    fn int(&mut self) -> Result<i32, Fault> {
        self.skip_blanks();
        let start = self.at;
        let negative = self.bytes.get(start) == Some(&b'-');
        self.at += negative as usize;
        let value = self.digits("an integer").ok().and_then(|v| i32::try_from(v).ok());
        match value {
            Some(value) => Ok(if negative { -value } else { value }),
            None => {
                self.at = start;
                Err(self.unexpected("an integer"))
            }
        }
    }

    fn float(&mut self) -> Result<f64, Fault> {
        self.skip_blanks();
        match number::float(&self.bytes[self.at..]) {
            Some((value, length)) => {
                self.at += length;
                Ok(value)
            }
            None => Err(self.unexpected("a number")),
        }
    }

    fn go_to(&mut self, at: usize) {
        self.at = at;
    }

    fn size_bytes(&self) -> usize {
        0
    }

    fn skip_records(&mut self, records: usize, _bytes: usize) {
        for _ in 0..records {
            self.begin();
            let rest = &self.bytes[self.at..];
            self.at += rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
        }
        self.begin();
    }
}
