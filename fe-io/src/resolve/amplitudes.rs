//! `*AMPLITUDE`.

use super::lines::fields;
use crate::deck::Deck;
use crate::deck::card::normalized;
use crate::deck::number::number;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::amplitude::{Amplitude, Course, TimeBase};

/// The amplitudes, with the places of their names. Faulty ones are there without points.
#[derive(Debug, Default)]
pub struct Amplitudes {
    /// In the order of the deck.
    pub list: Vec<Amplitude>,
    places: Vec<Span>,
}

impl Amplitudes {
    /// Reads all of them.
    pub fn read(entries: &[Entry<'_>], deck: &Deck, diagnostics: &mut Diagnostics) -> Self {
        let mut all = Amplitudes::default();
        for entry in entries {
            let Some(value) = entry.value("NAME") else { continue };
            let name = normalized(&value.text);
            if let Some(first) = all.list.iter().position(|a| a.name == name) {
                let fault = Diagnostic::error(value.span, format!("amplitude `{name}` is there twice"));
                diagnostics.push(fault.related(all.places[first], "first here"));
                continue;
            }
            let base = if entry.says("TIME", "TOTAL TIME") { TimeBase::Total } else { TimeBase::Step };
            let course = if entry.says("DEFINITION", "SMOOTH STEP") { Course::SmoothStep } else { Course::Linear };
            all.list.push(Amplitude { name, base, course, points: points(entry, deck, diagnostics) });
            all.places.push(value.span);
        }
        all
    }

    /// The amplitude that a card's `AMPLITUDE=` names; a missing one is told.
    pub fn of(&self, entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<usize> {
        let value = entry.value("AMPLITUDE")?;
        let name = normalized(&value.text);
        let found = self.list.iter().position(|a| a.name == name);
        if found.is_none() {
            let fault = Diagnostic::error(value.span, format!("there is no amplitude `{name}`"));
            diagnostics.push(fault.known(&name, self.list.iter().map(|a| a.name.as_str())));
        }
        found
    }
}

fn points(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Vec<(f64, f64)> {
    let before = diagnostics.faults();
    let mut tokens = Vec::new();
    for line in deck.lines(entry.card) {
        // Times and factors may be split between lines anywhere: of each line only the numbers are checked.
        let row = Row::read(line, &fields(entry)[1..], diagnostics);
        tokens.extend((0..row.len()).filter_map(|i| row.token(i)));
    }
    if diagnostics.faults() > before {
        return Vec::new();
    }
    if tokens.is_empty() || tokens.len() % 2 == 1 {
        let at = tokens.last().map_or(entry.card.span, |token| token.span);
        let fault = Diagnostic::error(at, "an amplitude has pairs of time and factor");
        diagnostics.push(fault.label(format!("{} numbers", tokens.len())));
        return Vec::new();
    }
    let mut points: Vec<(f64, f64)> = Vec::with_capacity(tokens.len() / 2);
    for pair in tokens.chunks_exact(2) {
        let (Some(time), Some(factor)) = (number(pair[0].text), number(pair[1].text)) else { continue };
        if points.last().is_some_and(|last| time <= last.0) {
            let fault = Diagnostic::error(pair[0].span, format!("times ascend: `{}` is not later", pair[0].text));
            diagnostics.push(fault);
            return Vec::new();
        }
        points.push((time, factor));
    }
    points
}
