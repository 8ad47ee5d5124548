//! Numbers on their way into a file.

/// Where numbers go, in either encoding.
pub(super) struct Out {
    bytes: Vec<u8>,
    binary: bool,
}

impl Out {
    pub fn new(binary: bool) -> Self {
        Out { bytes: Vec::new(), binary }
    }

    pub fn is_binary(&self) -> bool {
        self.binary
    }

    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    pub fn line(&mut self, line: &str) {
        self.bytes.extend_from_slice(line.as_bytes());
        self.bytes.push(b'\n');
    }

    fn text(&mut self, value: std::fmt::Arguments) {
        use std::io::Write;
        self.bytes.write_fmt(value).expect("a vector takes every byte");
        self.bytes.push(b' ');
    }

    pub fn size(&mut self, value: u64) {
        if self.binary {
            self.bytes.extend_from_slice(&value.to_le_bytes());
        } else {
            self.text(format_args!("{value}"));
        }
    }

    pub fn int(&mut self, value: i32) {
        if self.binary {
            self.bytes.extend_from_slice(&value.to_le_bytes());
        } else {
            self.text(format_args!("{value}"));
        }
    }

    pub fn float(&mut self, value: f64) {
        let plain = value == 0.0 || (1e-5..1e16).contains(&value.abs());
        match (self.binary, plain) {
            (true, _) => self.bytes.extend_from_slice(&value.to_le_bytes()),
            (false, true) => self.text(format_args!("{value}")),
            (false, false) => self.text(format_args!("{value:e}")),
        }
    }

    /// Ends the line, in binary too.
    pub fn end(&mut self) {
        self.bytes.push(b'\n');
    }

    /// Ends a record of text.
    pub fn end_of_text_line(&mut self) {
        if !self.binary {
            self.bytes.pop();
            self.end();
        }
    }

    /// Ends a section of binary.
    pub fn end_of_binary(&mut self) {
        if self.binary {
            self.end();
        }
    }
}
