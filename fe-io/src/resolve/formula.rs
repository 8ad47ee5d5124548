//! `*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=FORMULA`: each data line defines a quantity.

use super::interactions::verified;
use crate::deck::Deck;
use crate::deck::card::Line;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_contact::interaction::NormalBehavior;
use fe_contact::law::formula::{Fault, Formula};
use std::sync::Arc;

/// The law; `None` when it is refused, which was told. `size` [L] is that of the model.
pub fn read(entry: &Entry<'_>, deck: &Deck, size: f64, diagnostics: &mut Diagnostics) -> Option<NormalBehavior> {
    let lines: Vec<Line<'_>> = deck.lines(entry.card).collect();
    let texts: Vec<&str> = lines.iter().map(|line| line.text).collect();
    let place = |fault: &Fault| match fault.line.and_then(|line| lines.get(line)) {
        Some(line) => {
            let [start, end] = [fault.at.start, fault.at.end].map(|at| line.span.start + at as u32);
            Span { start, end, ..line.span }
        }
        None => entry.card.span,
    };
    match Formula::new(&texts, size) {
        Ok((law, unused)) => {
            for fault in unused {
                diagnostics.push(Diagnostic::warning(place(&fault), &*fault.title));
            }
            verified(entry, "FORMULA", (Arc::new(law), size), diagnostics)
        }
        Err(faults) => {
            for fault in faults {
                let message = Diagnostic::error(place(&fault), &*fault.title);
                diagnostics.push(match &fault.known {
                    Some((word, known)) => message.known(word, known.iter().map(String::as_str)),
                    None if fault.line.is_none() => message.help("say for example `p = K * h^1.5` and `K = 4.0e4`"),
                    None => message,
                });
            }
            None
        }
    }
}
