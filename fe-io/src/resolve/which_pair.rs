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
    named(surfaces(entry, diagnostics)?, pairs, scene, diagnostics)
}

/// `SECONDARY=` and `MAIN=`; one without the other is told.
pub fn surfaces<'a>(entry: &'a Entry<'_>, diagnostics: &mut Diagnostics) -> Option<(Token<'a>, Token<'a>)> {
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
    Some((secondary, main))
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
    surfaces: (Token<'_>, Token<'_>),
    pairs: &[(PairDefinition, Place)],
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    among(surfaces, &names(pairs), scene, diagnostics)
}

/// Names of the secondary and the main surface of each pair.
pub fn names(pairs: &[(PairDefinition, Place)]) -> Vec<[String; 2]> {
    pairs.iter().map(|(pair, _)| [pair.secondary_name.clone(), pair.main_name.clone()]).collect()
}

/// Where in a list of such names that of two surfaces stands; the same.
pub fn among(
    (secondary, main): (Token<'_>, Token<'_>),
    pairs: &[[String; 2]],
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let names = [secondary, main].map(|token| scene.full_name(token.text));
    let found = pairs.iter().position(|pair| *pair == names);
    if found.is_none() && diagnostics.faults() == 0 {
        let title = format!("there is no contact pair of `{}` and `{}`", names[0], names[1]);
        let there: Vec<String> =
            pairs.iter().map(|[secondary, main]| format!("SECONDARY={secondary}, MAIN={main}")).collect();
        let fault = Diagnostic::error(secondary.span, title);
        diagnostics.push(fault.known("", there.iter().map(String::as_str)));
    }
    found
}
