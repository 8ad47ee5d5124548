//! Data lines against the fields of their tables.

use super::table::{Field, FieldKind};
use crate::deck::card::{Line, Token};
use crate::deck::number::{number, whole};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use fe_contact::law::Datum;

/// A data line, read and checked.
#[derive(Clone, Debug)]
pub struct Row<'a> {
    /// The whole line.
    pub span: Span,
    tokens: Vec<Token<'a>>,
    /// False when something is wrong with it, which was told.
    pub sound: bool,
}

impl<'a> Row<'a> {
    /// Reads a line; what is wrong is told.
    pub fn read(line: Line<'a>, fields: &[Field], diagnostics: &mut Diagnostics) -> Row<'a> {
        let tokens: Vec<Token<'a>> = line.tokens().collect();
        let mut row = Row { span: line.span, tokens, sound: true };
        let repeating = fields.last().filter(|field| field.repeats);
        for (i, token) in row.tokens.iter().enumerate() {
            let fault = match fields.get(i).or(repeating) {
                Some(field) => wrong(field, *token),
                None if token.text.is_empty() => None,
                None => Some(surplus(fields, *token)),
            };
            if let Some(fault) = fault {
                row.sound = false;
                diagnostics.push(fault);
                break;
            }
        }
        if let Some(missing) = fields.iter().skip(row.tokens.len()).find(|field| field.required) {
            row.sound = false;
            let last = line.text.chars().next_back().map_or(0, char::len_utf8) as u32;
            let end = Span { start: line.span.end - last, ..line.span };
            let fault = Diagnostic::error(end, format!("{} is missing", missing.name)).label(described(missing));
            diagnostics.push(fault);
        }
        row
    }

    /// A token that is not blank.
    pub fn token(&self, i: usize) -> Option<Token<'a>> {
        self.tokens.get(i).copied().filter(|token| !token.text.is_empty())
    }

    /// A number, where one is given.
    pub fn number(&self, i: usize) -> Option<f64> {
        number(self.token(i)?.text)
    }

    /// A whole number, where one is given.
    pub fn whole(&self, i: usize) -> Option<u64> {
        whole(self.token(i)?.text)
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.tokens.len()
    }

    /// True when there is no entry.
    pub fn is_empty(&self) -> bool {
        self.tokens.is_empty()
    }
}

/// What a line holds, in its order.
pub fn names(fields: &[Field]) -> String {
    fields.iter().map(|field| field.name).collect::<Vec<_>>().join(", ")
}

/// What a field is, in a message.
pub fn described(field: &Field) -> String {
    let dimension = match field.dimension {
        "" | "-" => String::new(),
        dimension => format!(" [{dimension}]"),
    };
    format!("{}{dimension}", field.meaning)
}

fn surplus(fields: &[Field], token: Token<'_>) -> Diagnostic {
    let fault = Diagnostic::error(token.span, format!("`{}` is one entry too many", token.text));
    match fields.len() {
        0 => fault.label("this card has no data lines"),
        n => fault.help(format!("the line has {n}: {}", names(fields))),
    }
}

fn wrong(field: &Field, token: Token<'_>) -> Option<Diagnostic> {
    if token.text.is_empty() {
        let missing = || Diagnostic::error(token.span, format!("{} is missing", field.name)).label(described(field));
        return field.required.then(missing);
    }
    let value = match field.kind {
        FieldKind::Word => return None,
        FieldKind::Number => number(token.text),
        FieldKind::Whole => whole(token.text).map(|n| n as f64),
    };
    match value {
        None => {
            let kind = if field.kind == FieldKind::Whole { "a whole number" } else { "a number" };
            let fault = Diagnostic::error(token.span, format!("`{}` is not {kind}", token.text));
            Some(fault.label(format!("{}: {}", field.name, described(field))))
        }
        Some(value) if !field.holds(value) => {
            let title = format!("{} `{}` is out of range: it must be {}", field.name, token.text, field.range());
            Some(Diagnostic::error(token.span, title).label(described(field)))
        }
        Some(_) => None,
    }
}

/// The field of a law's number.
pub fn of_law(datum: &Datum) -> Field {
    let field = Field::number(datum.name, datum.dimension, datum.meaning).above(datum.above).least(datum.least);
    datum.default.map_or(field, |(_, blank)| field.or(blank))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deck::Deck;

    const FIELDS: &[Field] = &[
        Field::word("name", "a name"),
        Field::number("slope", "F/L³", "slope").above(0.0),
        Field::whole("count", "count").or("1").least(1.0).below(7.0),
    ];

    fn read(text: &str) -> (bool, String) {
        let deck = Deck::from_text("a.inp", &format!("*HEADING\n{text}\n")).unwrap();
        let mut diagnostics = Diagnostics::new(deck.sources.clone());
        let line = deck.lines(&deck.cards[0]).next().unwrap();
        let row = Row::read(line, FIELDS, &mut diagnostics);
        (row.sound, diagnostics.to_string())
    }

    #[test]
    fn sound_lines_say_nothing() {
        for text in ["A, 1.", "A, 1., 3", "A , 1.0D0 ,", "\"A, B\", 2e3, ,", "A,1,,"] {
            assert_eq!(read(text), (true, String::new()), "{text}");
        }
    }

    #[test]
    fn faults_are_named() {
        for (text, words) in [
            ("A", "slope is missing"),
            ("A, , 1", "slope is missing"),
            ("A, x", "`x` is not a number"),
            ("A, -1.", "must be > 0"),
            ("A, nan", "not a number"),
            ("A, 1., 7", "must be ≥ 1, < 7"),
            ("A, 1., 1.5", "not a whole number"),
            ("A, 1., 1, 9", "one entry too many"),
        ] {
            let (sound, message) = read(text);
            assert!(!sound && message.contains(words), "{text}: {message}");
        }
    }
}
