//! `*CONTACT DAMPING`.

use super::nodes::fields;
use crate::deck::Deck;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_contact::viscous::Damping;

/// What a card says; `None` when it is refused, which was told.
pub fn read(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Damping> {
    let fraction = entry.value("TANGENT FRACTION");
    let tangent_fraction = fraction.and_then(|value| number(&value.text)).unwrap_or(0.0);
    if let Some(value) = fraction.filter(|_| tangent_fraction < 0.0) {
        diagnostics.push(Diagnostic::error(value.span, "`TANGENT FRACTION` of `*CONTACT DAMPING` must be ≥ 0"));
    }
    let mut lines = deck.lines(entry.card);
    let Some(line) = lines.next() else {
        let fault = Diagnostic::error(entry.card.span, "`*CONTACT DAMPING` needs a data line");
        diagnostics.push(fault.help("write: coefficient, clearance from which on nothing acts, constant part"));
        return None;
    };
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(line) = lines.next() {
        let fault = Diagnostic::error(line.span, "this is one data line too many");
        diagnostics.push(fault.label("`*CONTACT DAMPING` has one"));
    }
    let (coefficient, clearance) = (row.number(0)?, row.number(1)?);
    row.sound.then(|| Damping { coefficient, clearance, constant_part: row.number(2).unwrap_or(0.0), tangent_fraction })
}
