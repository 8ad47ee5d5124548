//! `*CONTACT DAMPING`.

use super::lines::{line_fields, one_line};
use crate::deck::Deck;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::{Entry, too_many_lines};
use crate::keyword::row::Row;
use fe_contact::viscous::{Damping, DampingAmount, ExplicitDamping};

/// What a card says; `None` when it is refused, which was told.
pub fn read(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Damping> {
    let fraction = entry.value("TANGENT FRACTION");
    let tangent_fraction = fraction.and_then(|value| number(&value.text)).unwrap_or(0.0);
    if let Some(value) = fraction.filter(|_| tangent_fraction < 0.0) {
        diagnostics.push(Diagnostic::error(value.span, "`TANGENT FRACTION` of `*CONTACT DAMPING` must be ≥ 0"));
    }
    only_fraction(entry, diagnostics);
    only_one_line(entry, deck, diagnostics);
    let row = one_line(entry, deck, diagnostics)?;
    let (coefficient, clearance) = (row.number(0)?, row.number(1)?);
    Some(Damping { coefficient, clearance, constant_part: row.number(2).unwrap_or(0.0), tangent_fraction })
}

/// Static steps have coefficients alone.
fn only_fraction(entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
    if let Some(value) = entry.value("DEFINITION").filter(|_| entry.says("DEFINITION", "CRITICAL DAMPING FRACTION")) {
        let title = "`DEFINITION=CRITICAL DAMPING FRACTION` of `*CONTACT DAMPING` is for explicit steps";
        diagnostics.push(Diagnostic::error(value.span, title).help("`DEFINITION=DAMPING COEFFICIENT` is there"));
    }
}

/// What a card says of explicit steps; `None` when it is refused, which was told.
pub fn explicit(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<ExplicitDamping> {
    let fraction = entry.value("TANGENT FRACTION");
    let tangent_fraction = fraction.and_then(|value| number(&value.text)).unwrap_or(1.0);
    if let Some(value) = fraction.filter(|_| tangent_fraction < 0.0) {
        diagnostics.push(Diagnostic::error(value.span, "`TANGENT FRACTION` of `*CONTACT DAMPING` must be ≥ 0"));
    }
    let Some(line) = deck.lines(entry.card).next() else {
        let fault = Diagnostic::error(entry.card.span, "`*CONTACT DAMPING` needs a data line");
        diagnostics.push(fault.help("write one number: the coefficient, or the fraction of critical damping"));
        return None;
    };
    let row = Row::read(line, line_fields(entry, 1), diagnostics);
    only_one_line(entry, deck, diagnostics);
    let value = row.number(0).filter(|_| row.sound)?;
    let amount = match entry.says("DEFINITION", "CRITICAL DAMPING FRACTION") {
        true => DampingAmount::CriticalFraction(value),
        false => DampingAmount::Coefficient(value),
    };
    Some(ExplicitDamping { amount, tangent_fraction })
}

/// The table has a line for each kind of steps, a card one.
fn only_one_line(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) {
    if let Some(line) = deck.lines(entry.card).nth(1) {
        diagnostics.push(too_many_lines(entry.keyword.name, 1, line.span));
    }
}
