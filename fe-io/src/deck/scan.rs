//! Files to cards.

use super::Deck;
use super::card::{Card, Parameter, Token, Tokens, Value, normalized, trimmed, unquoted};
use super::source::{Source, Span};
use crate::diagnostic::{Diagnostic, Diagnostics};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Included files may include others, so deep.
const DEEPEST_INCLUDE: usize = 20;

pub(super) fn read(path: &Path) -> Result<Deck, Diagnostics> {
    let name = path.to_string_lossy();
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    match text_of(path) {
        Ok(text) => Scan::default().deck(&name, text, folder),
        Err(why) => {
            let mut diagnostics = Diagnostics::default();
            let title = format!("`{name}` cannot be read: {why}");
            diagnostics
                .push(Diagnostic { primary: None, ..Diagnostic::error(Span { source: 0, start: 0, end: 0 }, title) });
            Err(diagnostics)
        }
    }
}

pub(super) fn from_text(name: &str, text: &str) -> Result<Deck, Diagnostics> {
    Scan::default().deck(name, text.to_owned(), PathBuf::new())
}

/// A whole file; bytes that are no UTF-8 (comments in older alphabets) are replaced.
pub(crate) fn bytes_of(path: &Path) -> Result<Vec<u8>, String> {
    let what = std::fs::metadata(path).map_err(|e| match e.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => e.to_string(),
    })?;
    if !what.is_file() {
        return Err("it is no file".to_owned());
    }
    if what.len() > u64::from(u32::MAX) {
        return Err("it is larger than 4 GiB".to_owned());
    }
    std::fs::read(path).map_err(|e| e.to_string())
}

fn text_of(path: &Path) -> Result<String, String> {
    let text =
        String::from_utf8(bytes_of(path)?).unwrap_or_else(|e| String::from_utf8_lossy(e.as_bytes()).into_owned());
    if text.len() > u32::MAX as usize {
        return Err("it is larger than 4 GiB".to_owned());
    }
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

#[derive(Default)]
struct Scan {
    sources: Vec<Arc<Source>>,
    folders: Vec<PathBuf>,
    open: Vec<PathBuf>,
    cards: Vec<Card>,
    faults: Vec<Diagnostic>,
}

impl Scan {
    fn deck(mut self, name: &str, text: String, folder: PathBuf) -> Result<Deck, Diagnostics> {
        self.file(name, text, folder);
        if self.faults.is_empty() {
            return Ok(Deck { sources: self.sources, folders: self.folders, cards: self.cards });
        }
        let mut diagnostics = Diagnostics::new(self.sources);
        self.faults.into_iter().for_each(|fault| diagnostics.push(fault));
        Err(diagnostics)
    }

    fn file(&mut self, name: &str, text: String, folder: PathBuf) {
        let index = self.sources.len() as u32;
        let source = Arc::new(Source { name: name.into(), text });
        self.sources.push(source.clone());
        self.folders.push(folder);
        let text = source.text.as_str();
        let (mut at, mut line, mut data_from) = (0usize, 1u32, 0usize);
        while at < text.len() {
            let end = text[at..].find('\n').map_or(text.len(), |n| at + n + 1);
            let written = trimmed(&text[at..end], index, at as u32);
            if !is_keyword(written.text) {
                self.stray(written);
                (at, line) = (end, line + 1);
                continue;
            }
            self.data(index, data_from, at);
            let (card, end, lines) = keyword_line(text, index, at, line);
            (at, line, data_from) = (end, line + lines, end);
            if card.keyword == "INCLUDE" {
                self.include(&card);
            } else {
                self.cards.push(card);
            }
        }
        self.data(index, data_from, at);
    }

    /// Lines between two keyword lines belong to the last card.
    fn data(&mut self, source: u32, from: usize, to: usize) {
        if let Some(card) = self.cards.last_mut()
            && from < to
        {
            card.data.push(Span { source, start: from as u32, end: to as u32 });
        }
    }

    /// A data line before any card.
    fn stray(&mut self, written: Token<'_>) {
        let meant = !written.text.is_empty() && !written.text.starts_with("**");
        if meant && self.cards.is_empty() && self.faults.is_empty() {
            let fault = Diagnostic::error(written.span, "a line that belongs to no card");
            self.faults.push(fault.help("cards begin with a star, say `*HEADING`; comments with two"));
        }
    }

    fn include(&mut self, card: &Card) {
        for parameter in card.parameters.iter().filter(|p| p.name != "INPUT") {
            let title = format!("`*INCLUDE` has no parameter `{}`", parameter.name);
            self.faults.push(Diagnostic::error(parameter.span, title).known(&parameter.name, ["INPUT"]));
        }
        let input = card.parameters.iter().find(|p| p.name == "INPUT").and_then(|p| p.value.as_ref());
        let Some(input) = input else {
            let fault = Diagnostic::error(card.span, "`*INCLUDE` needs `INPUT=`");
            self.faults.push(fault.help("say `*INCLUDE, INPUT=file.inp`"));
            return;
        };
        let path = self.folders[card.span.source as usize].join(&input.text);
        if let Err(why) = self.included(&path) {
            let title = format!("`{}` cannot be included: {why}", input.text);
            self.faults.push(Diagnostic::error(input.span, title));
        }
    }

    fn included(&mut self, path: &Path) -> Result<(), String> {
        if self.open.len() >= DEEPEST_INCLUDE {
            return Err(format!("files include each other more than {DEEPEST_INCLUDE} deep"));
        }
        let text = text_of(path)?;
        self.open.push(path.to_path_buf());
        let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
        self.file(&path.to_string_lossy(), text, folder);
        self.open.pop();
        Ok(())
    }
}

fn is_keyword(line: &str) -> bool {
    line.starts_with('*') && !line.starts_with("**")
}

/// A keyword line with the lines that continue it: the card, the byte after it, and how many lines it takes.
/// A line that ends with a comma goes on in the next one, unless that is no parameter: a keyword line, or
/// data, which begin with a digit, a sign or a point.
fn keyword_line(text: &str, source: u32, at: usize, line: u32) -> (Card, usize, u32) {
    let (mut from, mut lines) = (at, 0);
    let mut card = None;
    loop {
        let end = text[from..].find('\n').map_or(text.len(), |n| from + n + 1);
        lines += 1;
        let written = trimmed(&text[from..end], source, from as u32);
        let mut tokens = Tokens::raw(written.text, source, written.span.start);
        let card = card.get_or_insert_with(|| keyword(&mut tokens, written, line));
        while let Some(token) = tokens.next_raw() {
            if !token.text.is_empty() {
                card.parameters.push(parameter(token));
            }
        }
        let next = text[end..].split('\n').next().unwrap_or("").trim_ascii();
        let begins_word = next.starts_with(|c: char| c.is_alphabetic());
        if !(written.text.ends_with(',') && begins_word) {
            return (card.clone(), end, lines);
        }
        from = end;
    }
}

fn keyword(tokens: &mut Tokens<'_>, written: Token<'_>, line: u32) -> Card {
    let word = tokens.next_raw().unwrap_or(written);
    let keyword = normalized(word.text.trim_start_matches('*'));
    Card { keyword, span: word.span, line, parameters: Vec::new(), data: Vec::new() }
}

fn parameter(token: Token<'_>) -> Parameter {
    let Some((name, value)) = token.text.split_once('=') else {
        return Parameter { name: normalized(token.text), span: token.span, value: None };
    };
    let (source, start) = (token.span.source, token.span.start);
    let value = unquoted(trimmed(value, source, start + name.len() as u32 + 1));
    let name = trimmed(name, source, start);
    let value = Value { text: value.text.to_owned(), span: value.span };
    Parameter { name: normalized(name.text), span: name.span, value: Some(value) }
}
