//! `*CONTACT DAMPING`.

use super::lines::one_line;
use crate::deck::Deck;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_contact::viscous::Damping;

/// What a card says; `None` when it is refused, which was told.
pub fn read(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) -> Option<Damping> {
    let fraction = entry.value("TANGENT FRACTION");
    let tangent_fraction = fraction.and_then(|value| number(&value.text)).unwrap_or(0.0);
    if let Some(value) = fraction.filter(|_| tangent_fraction < 0.0) {
        diagnostics.push(Diagnostic::error(value.span, "`TANGENT FRACTION` of `*CONTACT DAMPING` must be ≥ 0"));
    }
    let row = one_line(entry, deck, diagnostics)?;
    let (coefficient, clearance) = (row.number(0)?, row.number(1)?);
    Some(Damping { coefficient, clearance, constant_part: row.number(2).unwrap_or(0.0), tangent_fraction })
}
