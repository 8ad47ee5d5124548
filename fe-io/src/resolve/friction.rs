//! `*FRICTION`.

use super::procedures::only_for;
use super::scene::Analysis;
use crate::deck::Deck;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::{Entry, too_many_lines};
use crate::keyword::row::{Row, names};
use crate::keyword::{Field, friction};
use fe_contact::friction::{Coefficient, Friction, Stick, TOLERANCE};

/// What the card says under an interaction; `None` where nothing holds along the surface, which is told, or where it is refused.
pub fn of_interaction(
    entry: &Entry<'_>,
    deck: &Deck,
    analysis: Analysis,
    diagnostics: &mut Diagnostics,
) -> Option<Friction> {
    match analysis {
        Analysis::Explicit => only_static(entry, diagnostics),
        Analysis::Static => no_slope(entry, diagnostics),
    }
    let friction = read(entry, deck, diagnostics)?;
    if friction.is_none() {
        let note = Diagnostic::note(entry.card.span, "a friction coefficient of 0: the surfaces slide freely");
        diagnostics.push(note.label("nothing is spent on friction"));
        return None;
    }
    Some(friction)
}

/// Refuses the springs of explicit steps in static ones.
pub fn no_slope(entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
    only_for(entry, &["SHEAR TRACTION SLOPE"], Analysis::Explicit, diagnostics);
}

/// In explicit steps kinematic contact sticks exactly, and penalties on springs of their own.
fn only_static(entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
    only_for(entry, &["ELASTIC SLIP", "SLIP TOLERANCE", "LAGRANGE"], Analysis::Static, diagnostics);
    let largest = entry.value("TAUMAX").filter(|value| number(&value.text) == Some(0.0));
    if let Some(value) = largest {
        let fault = Diagnostic::error(value.span, "`TAUMAX` of `*FRICTION` must be > 0 in explicit steps");
        diagnostics.push(fault.help("for no limit leave it out"));
    }
}

/// What the card says; `None` where it is refused, which was told.
pub fn read(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Friction> {
    let before = diagnostics.faults();
    exclusions(entry, diagnostics);
    let largest = positive(entry, "TAUMAX", diagnostics).filter(|largest| *largest > 0.0);
    let elastic = positive(entry, "ELASTIC SLIP", diagnostics).map(Stick::ElasticSlip);
    let tolerance = positive(entry, "SLIP TOLERANCE", diagnostics).map(Stick::Tolerance);
    let slope = positive(entry, "SHEAR TRACTION SLOPE", diagnostics).map(Stick::Slope);
    let stick = if entry.has("LAGRANGE") { Some(Stick::Lagrange) } else { elastic.or(tolerance).or(slope) };
    let friction = if entry.has("ROUGH") {
        if let Some(line) = deck.lines(entry.card).next() {
            let fault = Diagnostic::error(line.span, "`*FRICTION, ROUGH` has no data line");
            diagnostics.push(fault.help("rough surfaces never slip; for a coefficient leave `ROUGH` out"));
        }
        Some(Friction::Rough)
    } else {
        let coefficient = coefficient(entry, deck, diagnostics)?;
        let stick = stick.unwrap_or(Stick::Tolerance(TOLERANCE));
        Some(Friction::Coulomb { coefficient, largest, stick })
    };
    friction.filter(|_| diagnostics.faults() == before)
}

/// A parameter's number, which must not be negative, and not zero but for `TAUMAX`.
fn positive(entry: &Entry<'_>, name: &str, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = entry.value(name)?;
    let found = number(&value.text)?;
    if found > 0.0 || (found == 0.0 && name == "TAUMAX") {
        return Some(found);
    }
    let bound = if name == "TAUMAX" { "≥ 0" } else { "> 0" };
    let fault = Diagnostic::error(value.span, format!("`{name}` of `*FRICTION` must be {bound}"));
    diagnostics.push(if name == "ELASTIC SLIP" { fault.help("for exact stick say `LAGRANGE`") } else { fault });
    None
}

/// Words that cannot stand beside each other.
fn exclusions(entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
    let groups: [&[&str]; 4] = [
        &["ELASTIC SLIP", "SLIP TOLERANCE", "LAGRANGE", "SHEAR TRACTION SLOPE", "ROUGH"],
        &["ROUGH", "TAUMAX"],
        &["ROUGH", "EXPONENTIAL DECAY"],
        &["EXPONENTIAL DECAY", "TAUMAX"],
    ];
    for group in groups {
        let there: Vec<_> = group.iter().filter_map(|name| Some((name, entry.parameter(name)?))).collect();
        if let [(one, first), (other, second), ..] = there[..] {
            let title = format!("`{other}` of `*FRICTION` cannot be used with `{one}`");
            diagnostics.push(Diagnostic::error(second.span, title).related(first.span, "the other one"));
        }
    }
    if let (Some(parameter), None) = (entry.parameter("TEST DATA"), entry.parameter("EXPONENTIAL DECAY")) {
        let fault = Diagnostic::error(parameter.span, "`TEST DATA` is for `EXPONENTIAL DECAY`");
        diagnostics.push(fault.help("say `*FRICTION, EXPONENTIAL DECAY, TEST DATA`"));
    }
}

fn coefficient(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Coefficient> {
    let (fields, least, most): (&[Field], usize, usize) = match (entry.has("EXPONENTIAL DECAY"), entry.has("TEST DATA"))
    {
        (true, true) => (friction::POINT, 2, 3),
        (true, false) => (friction::DECAY, 1, 1),
        _ => (friction::TABLE, 1, usize::MAX),
    };
    let mut lines = deck.lines(entry.card);
    let rows: Vec<Row> = lines.by_ref().take(most).map(|line| Row::read(line, fields, diagnostics)).collect();
    if let Some(line) = lines.next() {
        diagnostics.push(too_many_lines("FRICTION", most, line.span));
    }
    if rows.len() < least {
        let needs = if least == 1 { "a data line" } else { "two data lines or more" };
        let fault = Diagnostic::error(entry.card.span, format!("`*FRICTION` needs {needs}"));
        diagnostics.push(fault.help(format!("write: {}", names(fields))));
        return None;
    }
    if !rows.iter().all(|row| row.sound) {
        return None;
    }
    let value = |row: usize, i: usize| rows[row].number(i).unwrap_or(0.0);
    if entry.has("TEST DATA") {
        ends_of_test_data(&rows, diagnostics);
    }
    let built = match (entry.has("EXPONENTIAL DECAY"), entry.has("TEST DATA")) {
        (true, true) => {
            Coefficient::decay_through(value(0, 0), (value(1, 0), value(1, 1)), rows.get(2).map(|_| value(2, 0)))
        }
        (true, false) => Coefficient::decay(value(0, 0), value(0, 1), value(0, 2)),
        _ => {
            let each = |row: usize| (value(row, 0), value(row, 1), value(row, 2));
            Coefficient::table(&(0..rows.len()).map(each).collect::<Vec<_>>())
        }
    };
    let told = |fault| diagnostics.push(Diagnostic::error(entry.card.span, format!("`*FRICTION`: {fault}")));
    built.map_err(told).ok()
}

/// The first point of test data is at rest, the third one at a slip rate beyond all: only the second one has a rate.
fn ends_of_test_data(rows: &[Row], diagnostics: &mut Diagnostics) {
    let ends = [(0, "the first coefficient holds at rest"), (2, "the third coefficient holds at high slip rates")];
    for (row, title) in ends {
        let Some(row) = rows.get(row) else { continue };
        if let (Some(token), Some(rate)) = (row.token(1), row.number(1))
            && rate != 0.0
        {
            let fault = Diagnostic::error(token.span, title).label("no slip rate belongs here");
            diagnostics.push(fault.help("the second line has the slip rate at which its coefficient was measured"));
        }
    }
}
