//! `*STATIC` and `*CONTROLS`.

use super::lines::fields;
use crate::deck::Deck;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::{Entry, too_many_lines};
use crate::keyword::row::Row;
use crate::keyword::{Field, controls};
use fe_core::step::{Controls, Increments};

/// The smallest increment, as part of the step time, unless the deck says otherwise (or begins smaller).
const SMALLEST_PART: f64 = 1e-5;

/// `*STATIC`; `most` increments come from `*STEP, INC=`.
pub fn increments(entry: &Entry<'_>, most: usize, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Increments> {
    let row = deck.lines(entry.card).next().map(|line| Row::read(line, fields(entry), diagnostics));
    if row.as_ref().is_some_and(|row| !row.sound) {
        return None;
    }
    let given = |i: usize| row.as_ref().and_then(|row| row.number(i));
    // A zero for the smallest or the largest increment stands for a blank.
    let positive = |i: usize| given(i).filter(|value| *value > 0.0);
    let period = given(1).unwrap_or(1.0);
    let initial = given(0).unwrap_or(period);
    let minimum = positive(2).unwrap_or(initial.min(SMALLEST_PART * period));
    let maximum = positive(3).unwrap_or(period);
    let at = |i: usize| row.as_ref().and_then(|row| row.token(i)).map_or(entry.card.span, |token| token.span);
    let told = [
        (initial > period, 0, format!("the first increment {initial} is longer than the step, {period}")),
        (minimum > initial, 2, format!("the smallest increment {minimum} is longer than the first, {initial}")),
        (
            maximum < initial && positive(3).is_some(),
            3,
            format!("the largest increment {maximum} is shorter than the first, {initial}"),
        ),
    ];
    let mut sound = true;
    for (_, i, title) in told.into_iter().filter(|(wrong, ..)| *wrong) {
        sound = false;
        diagnostics.push(Diagnostic::error(at(i), title).help("write: first increment, step time, smallest, largest"));
    }
    sound.then(|| Increments { initial, period, minimum, maximum, fixed: entry.has("DIRECT"), most })
}

/// Changes the controls in force as a card says.
pub fn read(entry: &Entry<'_>, deck: &Deck, controls: &mut Controls, diagnostics: &mut Diagnostics) {
    if entry.has("RESET") {
        *controls = Controls { convert_sdi: controls.convert_sdi, ..Controls::default() };
    }
    if entry.has("ANALYSIS") {
        (controls.i_0, controls.i_r) = (8, 10);
    }
    // A blank line stands for the defaults of that line.
    let mut lines = deck.all_lines(entry.card);
    let mut row = |fields: &[Field], diagnostics: &mut Diagnostics| {
        let row = lines.next().map(|line| Row::read(line, fields, diagnostics)).filter(|row| row.sound)?;
        idle(&row, fields, diagnostics);
        Some(row)
    };
    match entry.name("PARAMETERS").as_deref() {
        Some("FIELD") => {
            if let Some(row) = row(controls::FIELD, diagnostics) {
                set(&mut controls.residual, row.number(0));
                set(&mut controls.correction, row.number(1));
                set(&mut controls.late_residual, row.number(4));
            }
        }
        Some("TIME INCREMENTATION") => {
            if let Some(row) = row(controls::COUNTS, diagnostics) {
                counts(&row, controls);
            }
            if let Some(row) = row(controls::FACTORS, diagnostics) {
                factors(&row, controls);
            }
        }
        Some("BALANCE") => match row(controls::BALANCE, diagnostics) {
            Some(row) => set(&mut controls.balance, row.number(0)),
            None => missing(entry.card.span, diagnostics),
        },
        Some(_) => return,
        None => {}
    }
    if let Some(more) = lines.find(|line| !line.text.is_empty()) {
        let most =
            if entry.says("PARAMETERS", "TIME INCREMENTATION") { 2 } else { usize::from(entry.has("PARAMETERS")) };
        diagnostics.push(too_many_lines("CONTROLS", most, more.span));
    }
}

fn missing(at: Span, diagnostics: &mut Diagnostics) {
    if diagnostics.faults() == 0 {
        diagnostics.push(Diagnostic::error(at, "`PARAMETERS=BALANCE` needs a data line with one number"));
    }
}

/// Numbers given for what has no effect here.
fn idle(row: &Row<'_>, fields: &[Field], diagnostics: &mut Diagnostics) {
    let without = fields.iter().enumerate().filter(|(i, field)| field.blank == "any" && row.token(*i).is_some());
    let names: Vec<&str> = without.map(|(_, field)| field.name).collect();
    if !names.is_empty() {
        let title = format!("{} of `*CONTROLS` has no effect", names.join(", "));
        diagnostics.push(Diagnostic::note(row.span, title));
    }
}

fn set<T>(control: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *control = value;
    }
}

fn counts(row: &Row<'_>, controls: &mut Controls) {
    let count = |i: usize| row.whole(i).map(|n| n as usize);
    set(&mut controls.i_0, count(0));
    set(&mut controls.i_r, count(1));
    set(&mut controls.i_p, count(2));
    set(&mut controls.i_c, count(3));
    set(&mut controls.i_l, count(4));
    set(&mut controls.i_g, count(5));
    set(&mut controls.i_s, count(6));
    set(&mut controls.i_a, count(7));
    set(&mut controls.i_s_converted, count(10));
}

fn factors(row: &Row<'_>, controls: &mut Controls) {
    set(&mut controls.d_f, row.number(0));
    set(&mut controls.d_c, row.number(1));
    set(&mut controls.d_b, row.number(2));
    set(&mut controls.d_s, row.number(4));
    set(&mut controls.d_d, row.number(6));
}
