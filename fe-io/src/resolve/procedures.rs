//! `*DYNAMIC` and what belongs to it.

use super::lines::fields;
use super::scene::Analysis;
use crate::deck::Deck;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::step::{Explicit, IncrementChoice};

/// The kind of steps that a deck has: explicit where any step is.
pub fn analysis(entries: &[Entry<'_>]) -> Analysis {
    let explicit = |entry: &Entry<'_>| entry.keyword.name == "DYNAMIC" && entry.has("EXPLICIT");
    if entries.iter().any(explicit) { Analysis::Explicit } else { Analysis::Static }
}

/// `*DYNAMIC`; the bulk viscosity is what holds at the end of the step.
pub fn explicit(entry: &Entry<'_>, step: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Explicit> {
    if !entry.has("EXPLICIT") {
        let fault = Diagnostic::error(entry.card.span, "`*DYNAMIC` without `EXPLICIT` is not there yet");
        diagnostics.push(fault.help("explicit steps, `*DYNAMIC, EXPLICIT`, and static ones, `*STATIC`, are there"));
        return None;
    }
    let before = diagnostics.faults();
    let Some(line) = deck.all_lines(entry.card).next() else {
        let fault = Diagnostic::error(entry.card.span, "`*DYNAMIC, EXPLICIT` needs a data line");
        diagnostics.push(fault.help("write: a blank, step time; with `DIRECT USER CONTROL`: increment, step time"));
        return None;
    };
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(token) = row.token(2) {
        let fault = Diagnostic::error(token.span, format!("`{}` stands in a field that is always blank", token.text));
        diagnostics.push(fault.help("write: a blank, step time, a blank, largest increment"));
    }
    let increment = increment(entry, &row, diagnostics);
    let scale = scale(entry, diagnostics);
    if entry.has("DIRECT USER CONTROL") {
        without_effect(entry, &row, diagnostics);
    }
    if let Some(small) = step.parameter("NLGEOM").filter(|_| step.says("NLGEOM", "NO")) {
        let fault = Diagnostic::error(small.span, "`NLGEOM=NO` of `*STEP` is not there in explicit steps");
        diagnostics.push(fault.help("forces are those of the current geometry: leave it out"));
    }
    if diagnostics.faults() > before {
        return None;
    }
    Some(Explicit {
        period: row.number(1)?,
        increment: increment?,
        scale,
        largest: row.number(3).filter(|_| !entry.has("DIRECT USER CONTROL")),
        bulk_viscosity: Explicit::BULK_VISCOSITY,
    })
}

/// Refuses parameters that are for steps of one kind alone.
pub fn only_for(entry: &Entry<'_>, names: &[&str], kind: Analysis, diagnostics: &mut Diagnostics) {
    let steps = if kind == Analysis::Static { "static" } else { "explicit" };
    for (name, parameter) in names.iter().filter_map(|name| Some((name, entry.parameter(name)?))) {
        let title = format!("`{name}` of `*{}` is for {steps} steps", entry.keyword.name);
        diagnostics.push(Diagnostic::error(parameter.span, title));
    }
}

/// Where the increment comes from; `None` where that is faulty, which is told.
fn increment(entry: &Entry<'_>, row: &Row<'_>, diagnostics: &mut Diagnostics) -> Option<IncrementChoice> {
    let direct = entry.parameter("DIRECT USER CONTROL");
    let given = row.token(0).zip(row.number(0));
    if let (Some(direct), Some(by_element)) = (direct, entry.parameter("ELEMENT BY ELEMENT")) {
        let title = "`ELEMENT BY ELEMENT` of `*DYNAMIC` cannot be used with `DIRECT USER CONTROL`";
        diagnostics.push(Diagnostic::error(by_element.span, title).related(direct.span, "the other one"));
    }
    match (direct, given) {
        (Some(_), Some((token, size))) => {
            if let Some(period) = row.number(1).filter(|period| size > *period) {
                let title = format!("the increment {size} is longer than the step, {period}");
                diagnostics.push(Diagnostic::error(token.span, title).help("write: increment, step time"));
            }
            Some(IncrementChoice::Fixed(size))
        }
        (Some(direct), None) => {
            let fault = Diagnostic::error(direct.span, "`DIRECT USER CONTROL` needs an increment");
            diagnostics.push(fault.related(row.span, "write: increment, step time"));
            None
        }
        (None, Some((token, _))) => {
            let fault = Diagnostic::error(token.span, "an increment is for `DIRECT USER CONTROL`");
            diagnostics.push(fault.help("leave the field blank: `, step time`, or say `DIRECT USER CONTROL`"));
            None
        }
        (None, None) if entry.has("ELEMENT BY ELEMENT") => Some(IncrementChoice::ElementByElement),
        (None, None) => Some(IncrementChoice::Global),
    }
}

fn scale(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> f64 {
    let Some(value) = entry.value("SCALE FACTOR") else { return 1.0 };
    let scale = number(&value.text).unwrap_or(1.0);
    if scale <= 0.0 {
        diagnostics.push(Diagnostic::error(value.span, "`SCALE FACTOR` of `*DYNAMIC` must be > 0"));
    }
    scale
}

/// What an increment that is given leaves without meaning.
fn without_effect(entry: &Entry<'_>, row: &Row<'_>, diagnostics: &mut Diagnostics) {
    let mut note = |at, what: &str| {
        let note = Diagnostic::note(at, format!("{what} has no effect with `DIRECT USER CONTROL`"));
        diagnostics.push(note.label("the increment is that of the data line"));
    };
    if let Some(scale) = entry.parameter("SCALE FACTOR") {
        note(scale.span, "`SCALE FACTOR` of `*DYNAMIC`");
    }
    if let Some(token) = row.token(3) {
        note(token.span, "the largest increment");
    }
}

/// `*BULK VISCOSITY`: changes what is in force.
pub fn bulk_viscosity(entry: &Entry<'_>, deck: &Deck, in_force: &mut [f64; 2], diagnostics: &mut Diagnostics) {
    let row = deck.all_lines(entry.card).next().map(|line| Row::read(line, fields(entry), diagnostics));
    if row.as_ref().is_none_or(|row| row.sound) {
        let given = |i: usize| row.as_ref().and_then(|row| row.number(i)).unwrap_or(Explicit::BULK_VISCOSITY[i]);
        *in_force = [given(0), given(1)];
    }
}
