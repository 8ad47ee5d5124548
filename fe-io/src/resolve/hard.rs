//! `*SURFACE BEHAVIOR` of hard contact: what enforces it.

use super::interactions::too_many;
use crate::deck::Deck;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::keyword::{self, surface_behavior};
use fe_contact::interaction::{Enforcement, GrowingPenalty, NormalBehavior, Penalty};

/// What the card says; `None` when it is refused, which was told.
pub fn read(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<NormalBehavior> {
    let grows = entry.name("PENALTY").is_some_and(|word| keyword::same(&word, "NONLINEAR"));
    let usual = match entry {
        _ if grows => Enforcement::NonlinearPenalty(GrowingPenalty::default()),
        _ if entry.has("PENALTY") => Enforcement::Penalty(Penalty::default()),
        _ if entry.has("AUGMENTED LAGRANGE") => Enforcement::AugmentedLagrange(Penalty::default()),
        _ if entry.has("DIRECT") => Enforcement::Direct,
        _ => Enforcement::Usual,
    };
    let mut lines = deck.lines(entry.card);
    let Some(line) = lines.next() else { return Some(NormalBehavior::Hard(usual)) };
    if usual.penalty().is_none() {
        let fault = Diagnostic::error(line.span, "hard contact has no data line");
        diagnostics.push(fault.help(
            "for a penalty stiffness say `*SURFACE BEHAVIOR, PENALTY`; for a slope `PRESSURE-OVERCLOSURE=LINEAR`",
        ));
        return None;
    }
    let fields = if grows { surface_behavior::NONLINEAR_PENALTY } else { surface_behavior::PENALTY };
    let row = Row::read(line, fields, diagnostics);
    too_many(lines.next(), diagnostics);
    row.sound.then(|| NormalBehavior::Hard(with_numbers(usual, &row)))
}

/// An enforcement with the numbers that are given of it.
fn with_numbers(usual: Enforcement, row: &Row<'_>) -> Enforcement {
    let (clearance, scale) = (row.number(1).unwrap_or(0.0), row.number(2).unwrap_or(1.0));
    let penalty = Penalty { stiffness: row.number(0), clearance, scale };
    match usual {
        Enforcement::Usual | Enforcement::Direct => usual,
        Enforcement::Penalty(_) => Enforcement::Penalty(penalty),
        Enforcement::AugmentedLagrange(_) => Enforcement::AugmentedLagrange(penalty),
        Enforcement::NonlinearPenalty(growing) => Enforcement::NonlinearPenalty(GrowingPenalty {
            last: penalty,
            upper: row.number(3).unwrap_or(growing.upper),
            initial: row.number(4).unwrap_or(growing.initial),
            lower: row.number(5).unwrap_or(growing.lower),
        }),
    }
}
