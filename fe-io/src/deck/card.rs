//! Cards as they are written: keyword, parameters, data lines. Nothing is interpreted here.

use super::source::{Source, Span};

/// One card.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Card {
    /// Keyword without the star: capitals, inner blanks single.
    pub keyword: String,
    /// Star and keyword.
    pub span: Span,
    /// Line of the star, from 1.
    pub line: u32,
    /// Parameters in order.
    pub parameters: Vec<Parameter>,
    /// Data lines, comments among them; more than one piece where a file was included.
    pub data: Vec<Span>,
}

/// `NAME` or `NAME=value` on a keyword line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Name: capitals, inner blanks single.
    pub name: String,
    /// Where the name stands.
    pub span: Span,
    /// What follows `=`.
    pub value: Option<Value>,
}

/// A parameter's value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// As written, without quotes and outer blanks.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A data line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line<'a> {
    /// Without line end and outer blanks.
    pub text: &'a str,
    /// Where it stands.
    pub span: Span,
}

/// One entry of a data line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token<'a> {
    /// Without quotes and outer blanks; empty when left blank.
    pub text: &'a str,
    /// Where it stands.
    pub span: Span,
}

/// Capitals, single blanks.
pub fn normalized(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for word in text.split_ascii_whitespace() {
        if !out.is_empty() {
            out.push(' ');
        }
        out.push_str(&word.to_uppercase());
    }
    out
}

/// A part of `text`, which begins at byte `base` of a source, without outer blanks.
pub(super) fn trimmed(text: &str, source: u32, base: u32) -> Token<'_> {
    let start = text.len() - text.trim_ascii_start().len();
    let text = text.trim_ascii();
    let start = base + start as u32;
    Token { text, span: Span { source, start, end: start + text.len() as u32 } }
}

/// A token without its quotes.
pub(super) fn unquoted(token: Token<'_>) -> Token<'_> {
    match token.text.strip_prefix('"').and_then(|t| t.strip_suffix('"')) {
        Some(text) => Token { text, span: token.span },
        None => token,
    }
}

/// Splits at commas outside quotes.
#[derive(Clone, Debug)]
pub struct Tokens<'a> {
    rest: Option<&'a str>,
    source: u32,
    base: u32,
}

impl<'a> Tokens<'a> {
    pub(super) fn raw(text: &'a str, source: u32, base: u32) -> Self {
        Tokens { rest: Some(text), source, base }
    }

    pub(super) fn next_raw(&mut self) -> Option<Token<'a>> {
        let rest = self.rest?;
        let mut quoted = false;
        let comma = rest.bytes().position(|b| {
            quoted ^= b == b'"';
            b == b',' && !quoted
        });
        let (piece, after) = match comma {
            Some(at) => (&rest[..at], Some(&rest[at + 1..])),
            // An opened quote that never closes binds nothing.
            None if quoted => match rest.find(',') {
                Some(at) => (&rest[..at], Some(&rest[at + 1..])),
                None => (rest, None),
            },
            None => (rest, None),
        };
        let token = trimmed(piece, self.source, self.base);
        self.base += piece.len() as u32 + 1;
        self.rest = after;
        Some(token)
    }
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        self.next_raw().map(unquoted)
    }
}

impl<'a> Line<'a> {
    /// The entries. A comma at the end adds no entry.
    pub fn tokens(&self) -> Tokens<'a> {
        let text = self.text.strip_suffix(',').unwrap_or(self.text);
        Tokens::raw(text, self.span.source, self.span.start)
    }

    /// True when the line ends with a comma.
    pub fn goes_on(&self) -> bool {
        self.text.ends_with(',')
    }
}

/// Data lines of one piece.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    text: &'a str,
    source: u32,
    at: u32,
}

impl<'a> Lines<'a> {
    pub(super) fn new(source: &'a Source, piece: Span) -> Self {
        Lines { text: &source.text[piece.start as usize..piece.end as usize], source: piece.source, at: piece.start }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    /// The next line that is no comment; blank ones included.
    fn next(&mut self) -> Option<Line<'a>> {
        while !self.text.is_empty() {
            let (line, next) = match self.text.find('\n') {
                Some(end) => (&self.text[..end], &self.text[end + 1..]),
                None => (self.text, ""),
            };
            let token = trimmed(line, self.source, self.at);
            self.at += (self.text.len() - next.len()) as u32;
            self.text = next;
            if !token.text.starts_with("**") {
                return Some(Line { text: token.text, span: token.span });
            }
        }
        None
    }
}
