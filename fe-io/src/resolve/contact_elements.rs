//! `*GAP`, and what it has in common with `*INTERFACE`.

use super::interactions::Interactions;
use super::lines::one_line;
use super::scene::Scene;
use super::sections;
use crate::deck::card::Token;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::Place;
use fe_contact::element::ElementFault;
use fe_contact::gap::GapDefinition;
use fe_core::element::{ElementType, Family};
use fe_mesh::CellId;

/// Reads the gap elements of a card.
pub fn gaps(
    entry: &Entry<'_>,
    scene: &Scene<'_>,
    interactions: &Interactions,
    diagnostics: &mut Diagnostics,
) -> Option<(GapDefinition, Place)> {
    let (name, element, cells) = elements(entry, Family::Gap, scene, diagnostics)?;
    let row = one_line(entry, scene.deck, diagnostics)?;
    let distance = row.number(0).unwrap_or(0.0);
    let direction = [1, 2, 3].map(|i| row.number(i).unwrap_or(0.0));
    // An instance turns the directions of its part.
    let direction = direction.iter().any(|c| *c != 0.0).then(|| scene.scope().motion.direction(direction));
    if element != ElementType::GAPUNI && distance == 0.0 {
        let fault = Diagnostic::error(row.span, format!("the distance of {} elements is missing or 0", element.name()));
        diagnostics.push(fault.help("positive: the largest distance of the nodes; negative: the least one"));
        return None;
    }
    match (element, direction) {
        (ElementType::GAPCYL, None) => {
            let fault = Diagnostic::error(row.span, "the axis of GAPCYL elements is missing or 0");
            diagnostics.push(fault.help("write: distance, x, y, z of the axis, area"));
            return None;
        }
        (ElementType::GAPSPHER, Some(_)) => {
            let note = Diagnostic::note(row.span, "the direction of GAPSPHER elements has no effect");
            diagnostics.push(note.label("it is that of the line between the nodes"));
        }
        _ => {}
    }
    let interaction = interactions.of_card(entry.card.span)?;
    let gaps = GapDefinition { name, element, cells, distance, direction, area: row.number(4), interaction };
    gaps.check(&scene.structure).map_err(|fault| refuse(entry, fault, scene, diagnostics)).ok()?;
    Some((gaps, place(entry, scene)))
}

/// An element that stands for no constraint, at its own line.
pub fn refuse(
    entry: &Entry<'_>,
    (cell, fault): (CellId, ElementFault),
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) {
    let at = scene.place_of(cell).unwrap_or(entry.card.span);
    let fault = Diagnostic::error(at, fault.to_string());
    diagnostics.push(fault.related(entry.card.span, "what is given for it"));
}

pub fn place(entry: &Entry<'_>, scene: &Scene<'_>) -> Place {
    scene.deck.sources[entry.card.span.source as usize].place(entry.card.span.start)
}

/// Name, type and elements of the set, all of one type and family.
pub fn elements(
    entry: &Entry<'_>,
    family: Family,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(String, ElementType, Vec<CellId>)> {
    let value = entry.value("ELSET")?;
    let token = Token { text: &value.text, span: value.span };
    let cells = scene.cell_set(token, diagnostics)?.to_vec();
    let name = scene.full_name(&value.text);
    let element = scene.element_of(*cells.first()?);
    if let Some(&cell) = cells.iter().find(|&&cell| scene.element_of(cell).family() != family) {
        // Those of sections were told with them.
        if !sections::CARDS.iter().any(|(card, _)| *card == entry.keyword.name) {
            diagnostics.push(sections::unsuited(entry, token, (scene.element_of(cell), cell), scene));
        }
        return None;
    }
    if let Some(other) = cells.iter().map(|&cell| scene.element_of(cell)).find(|e| *e != element) {
        let title = format!("set `{name}` holds {} and {} elements", element.name(), other.name());
        let star = entry.keyword.name;
        let fault = Diagnostic::error(value.span, title);
        diagnostics.push(fault.help(format!("give each type a `*{star}` of its own")));
        return None;
    }
    Some((name, element, cells))
}
