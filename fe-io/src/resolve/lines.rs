//! Data lines of cards.

use crate::deck::Deck;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::{Row, names};
use crate::keyword::{Data, Field};
use std::iter::Peekable;

/// Fields of a card's first kind of data line.
pub fn fields(entry: &Entry<'_>) -> &'static [Field] {
    line_fields(entry, 0)
}

/// Fields of one kind of a card's data lines.
pub fn line_fields(entry: &Entry<'_>, kind: usize) -> &'static [Field] {
    match entry.keyword.data {
        Data::Lines(lines) => lines.get(kind).map_or(&[], |line| line.fields),
        Data::None | Data::Text(_) => &[],
    }
}

/// The one data line of a card; `None` where it is faulty or missing, which is told.
pub fn one_line<'a>(entry: &Entry<'a>, deck: &'a Deck, diagnostics: &mut Diagnostics) -> Option<Row<'a>> {
    let Some(line) = deck.lines(entry.card).next() else {
        let fault = Diagnostic::error(entry.card.span, format!("`*{}` has no data line", entry.keyword.name));
        diagnostics.push(fault.help(format!("write: {}", names(fields(entry)))));
        return None;
    };
    let row = Row::read(line, fields(entry), diagnostics);
    row.sound.then_some(row)
}

/// The data lines of a card that sets something; none are needed where `OP=NEW` takes away what there was.
pub fn set_or_taken_away<I: Iterator>(
    lines: I,
    entry: &Entry<'_>,
    (missing, help): (&str, &str),
    diagnostics: &mut Diagnostics,
) -> Peekable<I> {
    match entry.says("OP", "NEW") {
        true => lines.peekable(),
        false => at_least_one(lines, entry, (missing, help), diagnostics),
    }
}

/// The data lines of a card that needs some; where there are none, what is missing and what to add is told.
pub fn at_least_one<I: Iterator>(
    lines: I,
    entry: &Entry<'_>,
    (missing, help): (&str, &str),
    diagnostics: &mut Diagnostics,
) -> Peekable<I> {
    let mut lines = lines.peekable();
    if lines.peek().is_none() {
        diagnostics.push(Diagnostic::error(entry.card.span, missing).help(help));
    }
    lines
}
