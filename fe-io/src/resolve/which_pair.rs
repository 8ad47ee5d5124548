//! Which contact pair a card means.

use super::scene::Scene;
use super::steps::Named;
use crate::deck::card::Token;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::Place;
use fe_contact::pair::{Bond, PairDefinition};

/// The pair of `MAIN=` and `SECONDARY=`, an index into the model's pairs.
pub fn of_parameters(
    entry: &Entry<'_>,
    pairs: &[(PairDefinition, Place)],
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let (main, secondary) = (entry.value("MAIN"), entry.value("SECONDARY"));
    let (Some(main), Some(secondary)) = (main, secondary) else {
        // Where both are required, the missing one was told.
        let required = entry.keyword.parameters.iter().any(|parameter| parameter.name == "MAIN" && parameter.required);
        if let Some(one) = main.or(secondary).filter(|_| !required) {
            diagnostics.push(Diagnostic::error(one.span, "`MAIN` and `SECONDARY` are given both or not at all"));
        }
        return None;
    };
    let [secondary, main] = [secondary, main].map(|value| Token { text: &value.text, span: value.span });
    named((secondary, main), pairs, scene, diagnostics)
}

/// The contact elements of a set, an index into all contacts: they come after the pairs. A missing one is told, unless
/// faults of the deck explain it.
pub fn of_elements(
    set: Token<'_>,
    named: &Named<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let name = scene.full_name(set.text);
    let found = named.elements.iter().position(|(known, _)| *known == name);
    if found.is_none() && diagnostics.faults() == 0 {
        let fault = Diagnostic::error(set.span, format!("no `*GAP` or `*INTERFACE` has the elements `{name}`"));
        diagnostics.push(fault.known("", named.elements.iter().map(|(name, _)| *name)));
    }
    found.map(|at| named.pairs.len() + at)
}

/// Says that a card is not for a tied pair; true where it is one.
pub fn is_tied(entry: &Entry<'_>, (pair, place): &(PairDefinition, Place), diagnostics: &mut Diagnostics) -> bool {
    let tied = pair.bond == Bond::Tied;
    if tied {
        let title = format!("`*{}` is not for tied pairs: they neither part nor slide", entry.keyword.name);
        let fault = Diagnostic::error(entry.card.span, title);
        diagnostics.push(fault.help(format!("`TIED` stands on the `*CONTACT PAIR` of {}:{}", place.file, place.line)));
    }
    tied
}

/// The pair of two surfaces; a missing one is told, unless faults of the pairs explain it.
pub fn named(
    (secondary, main): (Token<'_>, Token<'_>),
    pairs: &[(PairDefinition, Place)],
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let names = [secondary, main].map(|token| scene.full_name(token.text));
    let found = pairs.iter().position(|(p, _)| p.secondary_name == names[0] && p.main_name == names[1]);
    if found.is_none() && diagnostics.faults() == 0 {
        let title = format!("there is no contact pair of `{}` and `{}`", names[0], names[1]);
        let there: Vec<String> =
            pairs.iter().map(|(p, _)| format!("SECONDARY={}, MAIN={}", p.secondary_name, p.main_name)).collect();
        let fault = Diagnostic::error(secondary.span, title);
        diagnostics.push(fault.known("", there.iter().map(String::as_str)));
    }
    found
}
