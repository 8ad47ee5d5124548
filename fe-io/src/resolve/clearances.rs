//! `*CLEARANCE`.

use super::interferences::direction;
use super::lines::{at_least_one, fields};
use super::scene::Scene;
use super::which_pair;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::model::Place;
use fe_contact::pair::{Clearance, NodeClearance, PairDefinition};
use fe_contact::surface::Main;
use std::collections::BTreeMap;

/// Reads a card into the pair that it names.
pub fn read(
    entry: &Entry<'_>,
    scene: &Scene<'_>,
    pairs: &mut [(PairDefinition, Place)],
    diagnostics: &mut Diagnostics,
) {
    let Some(k) = which_pair::of_parameters(entry, pairs, scene, diagnostics) else { return };
    if which_pair::is_tied(entry, &pairs[k], diagnostics) {
        return;
    }
    let pair = &pairs[k].0;
    if pair.clearance.is_some() {
        diagnostics.push(Diagnostic::error(entry.card.span, "this pair has a `*CLEARANCE` already"));
        return;
    }
    if !pair.small_sliding {
        let fault = Diagnostic::error(entry.card.span, "`*CLEARANCE` is for pairs with `SMALL SLIDING`");
        let (file, line) = (&pairs[k].1.file, pairs[k].1.line);
        diagnostics.push(fault.help(format!("say `SMALL SLIDING` on the `*CONTACT PAIR` of {file}:{line}")));
    }
    pairs[k].0.clearance = match (entry.value("VALUE"), entry.parameter("TABULAR")) {
        (Some(value), None) => number(&value.text).map(Clearance::Everywhere),
        (None, Some(_)) => Some(Clearance::Nodes(table(entry, scene, pair, diagnostics))),
        (Some(_), Some(table)) => {
            diagnostics.push(Diagnostic::error(table.span, "`VALUE` and `TABULAR` exclude each other"));
            return;
        }
        (None, None) => {
            diagnostics.push(Diagnostic::error(entry.card.span, "`*CLEARANCE` needs `VALUE=` or `TABULAR`"));
            return;
        }
    };
    if let (None, Some(line)) = (entry.parameter("TABULAR"), scene.deck.lines(entry.card).next()) {
        diagnostics.push(Diagnostic::error(line.span, "with `VALUE=` this card has no data lines"));
    }
}

/// The gaps of the nodes; a later line counts more.
fn table(
    entry: &Entry<'_>,
    scene: &Scene<'_>,
    pair: &PairDefinition,
    diagnostics: &mut Diagnostics,
) -> Vec<NodeClearance> {
    let on_surface = pair.secondary.nodes(&scene.structure.mesh);
    let mut all = BTreeMap::new();
    let lines = at_least_one(
        scene.deck.lines(entry.card),
        entry,
        ("`TABULAR` needs data lines", "add lines: node or node set, gap"),
        diagnostics,
    );
    for line in lines {
        let row = Row::read(line, fields(entry), diagnostics);
        let (Some(token), Some(value), true) = (row.token(0), row.number(1), row.sound) else { continue };
        let Some(normal) = direction(&row, 2, scene.structure.is_plane(), diagnostics) else { continue };
        if let (Some(at), Some(_), Main::Rigid { .. }) = (row.token(2), normal, &pair.main) {
            diagnostics.push(Diagnostic::error(at.span, "a rigid main surface has normals of its own"));
            continue;
        }
        let Some(nodes) = scene.nodes_of(token, diagnostics) else { continue };
        let of_pair: Vec<u32> = nodes.into_iter().filter(|node| on_surface.binary_search(node).is_ok()).collect();
        if of_pair.is_empty() {
            let title = format!("no node of `{}` is on the secondary surface", token.text);
            diagnostics.push(Diagnostic::error(token.span, title));
        }
        all.extend(of_pair.into_iter().map(|node| (node, NodeClearance { node, value, normal })));
    }
    all.into_values().collect()
}
