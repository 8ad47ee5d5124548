//! `*BOUNDARY`.

use super::amplitudes::Amplitudes;
use super::lines::{line_fields, set_or_taken_away};
use super::scene::{Analysis, Scene};
use crate::deck::card::{Token, normalized};
use crate::deck::number::whole;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::keyword::{Field, table};
use fe_core::load::{Prescribed, Support};
use std::collections::HashMap;

/// Named supports and the freedoms that they hold, from 0.
const NAMED: &[(&str, &[u8])] = &[
    ("ENCASTRE", &[0, 1, 2, 3, 4, 5]),
    ("PINNED", &[0, 1, 2]),
    ("XSYMM", &[0, 4, 5]),
    ("YSYMM", &[1, 3, 5]),
    ("ZSYMM", &[2, 3, 4]),
    ("XASYMM", &[1, 2, 3]),
    ("YASYMM", &[0, 2, 4]),
    ("ZASYMM", &[0, 1, 5]),
];

const BY_NAME: &[Field] = &[table::Field::word("node or set", "a node or a node set"), table::Field::word("name", "")];

/// The supports of the model data or of one step.
#[derive(Debug, Default)]
pub struct Supports {
    /// In the order of the deck, each freedom once.
    pub items: Vec<Support>,
    /// Where each one's line stands.
    places: Vec<Span>,
    /// Where each freedom of a node stands in `items`.
    of: HashMap<(u32, u8), u32>,
}

/// What a line prescribes.
struct Line<'a> {
    at: Span,
    nodes: Token<'a>,
    freedoms: Vec<u8>,
    named: bool,
    value: f64,
}

impl Supports {
    /// Reads one more card.
    pub fn read(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        amplitudes: &Amplitudes,
        diagnostics: &mut Diagnostics,
    ) {
        let amplitude = amplitudes.of(entry, diagnostics);
        let Some(prescribed) = prescribed(entry, scene, diagnostics) else { return };
        let words = ("this card holds nothing", "add a line, or say `OP=NEW` to take away earlier supports");
        for line in set_or_taken_away(scene.deck.lines(entry.card), entry, words, diagnostics) {
            let Some(line) = read_line(entry, line, diagnostics) else { continue };
            if entry.step.is_none() && line.value != 0.0 {
                let fault = Diagnostic::error(line.at, "outside steps all prescribed values are zero");
                diagnostics.push(fault.help("write this `*BOUNDARY` into a step: there the value grows over the step"));
                continue;
            }
            if scene.analysis == Analysis::Explicit
                && (prescribed, amplitude, entry.has("AMPLITUDE")) == (Prescribed::Displacement, None, false)
                && line.value != 0.0
            {
                let fault = Diagnostic::error(line.at, "a displacement cannot jump at the start of an explicit step");
                diagnostics.push(fault.help("give it an `AMPLITUDE`, or say `TYPE=VELOCITY`"));
                continue;
            }
            let Some(nodes) = scene.nodes_of(line.nodes, diagnostics) else { continue };
            existing(&line, &nodes, scene, diagnostics);
            for node in nodes {
                for &component in line.freedoms.iter().filter(|&&c| scene.masks[node as usize] >> c & 1 == 1) {
                    let support = Support { node, component, prescribed, value: line.value, amplitude };
                    self.add(support, line.at, scene, diagnostics);
                }
            }
        }
    }

    fn add(&mut self, support: Support, at: Span, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        let key = (support.node, support.component);
        let Some(&other) = self.of.get(&key) else {
            self.of.insert(key, self.items.len() as u32);
            self.items.push(support);
            self.places.push(at);
            return;
        };
        let other = other as usize;
        if self.items[other] != support {
            let (label, freedom) = (scene.node_name(support.node), support.component + 1);
            let fault = Diagnostic::error(at, format!("freedom {freedom} of node {label} is prescribed twice"));
            let first = format!("first here, {}", self.items[other].value);
            let fault = fault.label(format!("{}", support.value));
            diagnostics.push(if self.places[other] == at { fault } else { fault.related(self.places[other], first) });
        }
    }
}

/// What the values are of; `None` where the steps have no such thing, which is told.
fn prescribed(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Prescribed> {
    let Some(value) = entry.value("TYPE") else { return Some(Prescribed::Displacement) };
    let prescribed = match normalized(&value.text).as_str() {
        "VELOCITY" => Prescribed::Velocity,
        "ACCELERATION" => Prescribed::Acceleration,
        "DISPLACEMENT" => Prescribed::Displacement,
        _ => return None,
    };
    if prescribed != Prescribed::Displacement && scene.analysis == Analysis::Static {
        let title = format!("`TYPE={}` of `*BOUNDARY` is for explicit steps", normalized(&value.text));
        let fault = Diagnostic::error(value.span, title);
        diagnostics.push(fault.help("in a static step prescribe the displacement at its end"));
        return None;
    }
    Some(prescribed)
}

fn read_line<'a>(
    entry: &Entry<'_>,
    line: crate::deck::card::Line<'a>,
    diagnostics: &mut Diagnostics,
) -> Option<Line<'a>> {
    let second = line.tokens().nth(1).filter(|token| !token.text.is_empty());
    if let Some(word) = second.filter(|token| token.text.starts_with(|c: char| c.is_alphabetic())) {
        let row = Row::read(line, BY_NAME, diagnostics);
        let name = normalized(word.text);
        let named = NAMED.iter().find(|(known, _)| *known == name);
        if named.is_none() {
            let fault = Diagnostic::error(word.span, format!("there is no support `{name}`"));
            diagnostics.push(fault.known(&name, NAMED.iter().map(|(known, _)| *known)));
        }
        let (nodes, (_, freedoms)) = (row.token(0)?, named?);
        let freedoms = freedoms.to_vec();
        return row.sound.then_some(Line { at: line.span, nodes, freedoms, named: true, value: 0.0 });
    }
    let first = second.and_then(|token| whole(token.text));
    if let (Some(token), Some(8 | 9 | 11..)) = (second, first) {
        let title = format!("freedom `{}` is not there: nodes have displacements and rotations", token.text);
        diagnostics.push(Diagnostic::error(token.span, title).label("1 to 3 translations, 4 to 6 rotations"));
        return None;
    }
    let row = Row::read(line, line_fields(entry, 0), diagnostics);
    if !row.sound {
        return None;
    }
    let (first, nodes) = (row.whole(1)?, row.token(0)?);
    let last = row.whole(2).unwrap_or(first);
    if last < first {
        diagnostics
            .push(Diagnostic::error(line.span, format!("the last freedom {last} comes before the first {first}")));
        return None;
    }
    let freedoms = (first..=last).map(|c| c as u8 - 1).collect();
    Some(Line { at: line.span, nodes, freedoms, named: false, value: row.number(3).unwrap_or(0.0) })
}

/// Freedoms that none of the nodes has: a fault when that holds for all of the line's freedoms, else a remark, so
/// that `REF, 1, 6` holds a reference node in plane models too. Named supports take what exists.
fn existing(line: &Line<'_>, nodes: &[u32], scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let all = nodes.iter().fold(0u8, |mask, &node| mask | scene.masks[node as usize]);
    let missing: Vec<String> =
        line.freedoms.iter().filter(|&&c| all >> c & 1 == 0).map(|c| (c + 1).to_string()).collect();
    if missing.is_empty() || (line.named && missing.len() < line.freedoms.len()) {
        return;
    }
    // Decks for other programs hold what a rigid body around an axis does not have.
    let rigid_rings = scene.structure.is_axisymmetric() && all == scene.structure.rigid_mask();
    if missing.len() < line.freedoms.len() || (rigid_rings && line.value == 0.0) {
        let title = format!("no node of `{}` has freedom {}", normalized(line.nodes.text), missing.join(", "));
        diagnostics.push(Diagnostic::note(line.at, title).label("left out"));
        return;
    }
    diagnostics.push(without_freedom(line.nodes, &line.freedoms, nodes, scene));
}

/// Says that none of some nodes has any of these freedoms, from 0, and which they have.
pub fn without_freedom(named: Token<'_>, freedoms: &[u8], nodes: &[u32], scene: &Scene<'_>) -> Diagnostic {
    let all = nodes.iter().fold(0u8, |mask, &node| mask | scene.masks.get(node as usize).copied().unwrap_or(0));
    let rigid_rings = scene.structure.is_axisymmetric() && all == scene.structure.rigid_mask();
    let missing: Vec<String> = freedoms.iter().map(|c| (c + 1).to_string()).collect();
    let title = format!("no node of `{}` has freedom {}", normalized(named.text), missing.join(", "));
    let fault = Diagnostic::error(named.span, title);
    let translations = if scene.structure.is_plane() { 0b11 } else { 0b111 };
    match all {
        0 => fault.label("they belong to no element"),
        _ if rigid_rings => fault.label("a rigid body around an axis moves along it only: freedom 2"),
        _ if all != translations => fault.label(format!("they have freedom {}", listed_freedoms(all))),
        _ if scene.structure.is_plane() => {
            fault.label("solids and trusses of the plane move in x and y: freedoms 1 and 2")
        }
        _ => fault.label("solids and trusses have translations only: freedoms 1 to 3"),
    }
}

/// The freedoms of a mask as decks number them.
fn listed_freedoms(mask: u8) -> String {
    let freedoms: Vec<String> = (0..6).filter(|c| mask >> c & 1 == 1).map(|c| (c + 1).to_string()).collect();
    freedoms.join(", ")
}
