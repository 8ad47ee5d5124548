//! `*CONTACT INTERFERENCE`.

use super::conditions::InForce;
use super::lines::{at_least_one, line_fields};
use super::scene::Scene;
use super::steps::Named;
use super::which_pair;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_contact::interference::{Allowed, Interference};
use fe_core::ramp::Ramp;
use std::sync::Arc;

impl InForce {
    /// Reads a card; what it says of a pair takes the place of what was said before.
    pub fn interfere(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        named: &Named<'_>,
        diagnostics: &mut Diagnostics,
    ) {
        let course = self.course(entry, named, diagnostics);
        let elements = entry.name("TYPE").is_some_and(|word| word == "ELEMENT");
        let missing = if elements {
            ("this card names no elements", "add a line: element set, overclosure")
        } else {
            ("this card names no pair", "add a line: secondary surface, main surface, overclosure")
        };
        let lines = at_least_one(scene.deck.lines(entry.card), entry, missing, diagnostics);
        for line in lines {
            let row = Row::read(line, line_fields(entry, usize::from(elements)), diagnostics);
            let (Some(first), true) = (row.token(0), row.sound) else { continue };
            let contact = match row.token(1) {
                _ if elements => which_pair::of_elements(first, named, scene, diagnostics),
                Some(main) => which_pair::named((first, main), named.pairs, scene, diagnostics),
                None => continue,
            };
            let mut tied = |contact: &usize| {
                named.pairs.get(*contact).is_some_and(|pair| which_pair::is_tied(entry, pair, diagnostics))
            };
            let contact = contact.filter(|contact| !tied(contact));
            let names = if elements { 1 } else { 2 };
            let allowed = if entry.has("SHRINK") {
                own(&row, names, diagnostics)
            } else {
                given(&row, names, scene.structure.is_plane(), diagnostics)
            };
            if let (Some(contact), Some(allowed), Some(course)) = (contact, allowed, &course) {
                self.of(contact).interference = Some(Interference { allowed, course: course.clone() });
            }
        }
    }

    fn course(&self, entry: &Entry<'_>, named: &Named<'_>, diagnostics: &mut Diagnostics) -> Option<Ramp> {
        let falling = Ramp { from: 1.0, to: 0.0, amplitude: None };
        if let Some(shrink) = entry.parameter("SHRINK") {
            if self.steps > 1 {
                let fault = Diagnostic::error(shrink.span, "`SHRINK` is for the first step");
                diagnostics.push(fault.help("in later steps say how much overclosure is let be"));
            }
            if let Some(amplitude) = entry.parameter("AMPLITUDE") {
                let note = Diagnostic::note(amplitude.span, "`AMPLITUDE` has no effect beside `SHRINK`");
                diagnostics.push(note.label("the overclosure ramps to 0 over the step"));
            }
            return Some(falling);
        }
        if !entry.has("AMPLITUDE") {
            return Some(falling);
        }
        let amplitude = Arc::new(named.amplitudes.list[named.amplitudes.of(entry, diagnostics)?].clone());
        Some(Ramp { from: 0.0, to: 1.0, amplitude: Some(amplitude) })
    }
}

/// SHRINK: numbers, which begin after the names, have no meaning.
fn own(row: &Row<'_>, names: usize, diagnostics: &mut Diagnostics) -> Option<Allowed> {
    if let Some(number) = (names..names + 4).find_map(|i| row.token(i)) {
        let note = Diagnostic::note(number.span, "numbers have no effect beside `SHRINK`");
        diagnostics.push(note.label("each point begins with its own overclosure"));
    }
    Some(Allowed::Own)
}

fn given(row: &Row<'_>, names: usize, plane: bool, diagnostics: &mut Diagnostics) -> Option<Allowed> {
    let Some(depth) = row.number(names) else {
        let fault = Diagnostic::error(row.span, "the overclosure is missing");
        diagnostics.push(fault.help("it follows the names; or say `SHRINK`"));
        return None;
    };
    match direction(row, names + 1, plane, diagnostics)? {
        None => Some(Allowed::Overclosure(depth)),
        Some(direction) => Some(Allowed::Shift(direction.map(|d| depth * d))),
    }
}

/// The unit direction that begins at a field; `Some(None)` where none is given, `None` where it is none, which was told.
#[allow(clippy::option_option)]
pub fn direction(row: &Row<'_>, first: usize, plane: bool, diagnostics: &mut Diagnostics) -> Option<Option<[f64; 3]>> {
    let Some(token) = (first..first + 3).find_map(|i| row.token(i)) else { return Some(None) };
    let d = [0, 1, 2].map(|i| row.number(first + i).unwrap_or(0.0));
    let length = d.iter().map(|x| x * x).sum::<f64>().sqrt();
    let wrong = match (length > 0.0, plane && d[2] != 0.0) {
        (false, _) => "this direction has no length",
        (_, true) => "this direction leaves the plane",
        _ => return Some(Some(d.map(|x| x / length))),
    };
    diagnostics.push(Diagnostic::error(token.span, wrong));
    None
}
