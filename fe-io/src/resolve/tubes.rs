//! `*INTERFACE` and `*SLIDE LINE`.

use super::contact_elements::{elements, place, refuse};
use super::interactions::Interactions;
use super::lines::one_line;
use super::scene::Scene;
use super::sets::generated;
use crate::deck::card::Token;
use crate::deck::number::number;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::Place;
use fe_contact::slide_line::{Segments, SlideLine};
use fe_contact::tube::TubeDefinition;
use fe_core::element::Family;
use fe_mesh::CellId;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// Part of the end segment that a slide line goes on by default [-].
const EXTENSION: f64 = 0.1;

/// The tube-to-tube elements of a model.
#[derive(Debug, Default)]
pub struct Tubes {
    /// In the order of the deck.
    pub list: Vec<(TubeDefinition, Place)>,
    /// Slide lines, each with its elements and its card; `None` for a faulty one, which was told.
    lines: Vec<(Option<SlideLine>, Vec<CellId>, Span)>,
}

impl Tubes {
    /// Reads a `*SLIDE LINE`.
    pub fn line(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        let Some((_, _, cells)) = elements(entry, Family::Tube, scene, diagnostics) else { return };
        let twice = self.lines.iter().find_map(|(_, others, at)| {
            cells.iter().find(|cell| others.binary_search(cell).is_ok()).map(|cell| (*cell, *at))
        });
        if let Some((cell, other)) = twice {
            let title = format!("element {} has two slide lines", scene.cell_name(cell));
            diagnostics.push(Diagnostic::error(entry.card.span, title).related(other, "the other one"));
        }
        let line = slide_line(entry, scene, diagnostics);
        self.lines.push((line, cells, entry.card.span));
    }

    /// Nodes of all slide lines, ascending.
    pub fn nodes(&self) -> Vec<u32> {
        let nodes: BTreeSet<u32> =
            self.lines.iter().flat_map(|(line, ..)| line).flat_map(|l| &l.nodes).copied().collect();
        nodes.into_iter().collect()
    }

    /// Reads an `*INTERFACE`, when all slide lines are there.
    pub fn elements(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        interactions: &Interactions,
        diagnostics: &mut Diagnostics,
    ) {
        let Some((name, element, cells)) = elements(entry, Family::Tube, scene, diagnostics) else { return };
        let Some(row) = one_line(entry, scene.deck, diagnostics) else { return };
        let of = |cell: &CellId| self.lines.iter().position(|(_, cells, _)| cells.binary_search(cell).is_ok());
        let Some(cell) = cells.iter().find(|cell| of(cell).is_none()) else {
            let first = of(&cells[0]);
            if let Some(cell) = cells.iter().find(|cell| of(cell) != first) {
                let title = format!("the elements of `{name}` follow more than one slide line");
                let fault = Diagnostic::error(entry.card.span, title);
                let fault = fault.label(format!("element {} follows another one", scene.cell_name(*cell)));
                diagnostics.push(fault.help("write an `*INTERFACE` for each line"));
                return;
            }
            let line = first.and_then(|i| self.lines[i].0.clone());
            let (Some(line), Some(interaction)) = (line, interactions.of_card(entry.card.span)) else { return };
            let clearance = row.number(0).unwrap_or_default();
            let tubes = TubeDefinition { name, element, cells, clearance, line, interaction };
            match tubes.check(&scene.structure) {
                Ok(()) => self.list.push((tubes, place(entry, scene))),
                Err(fault) => refuse(entry, fault, scene, diagnostics),
            }
            return;
        };
        let title = format!("element {} of `{name}` has no slide line", scene.cell_name(*cell));
        let fault = Diagnostic::error(entry.card.span, title);
        diagnostics.push(fault.help("write `*SLIDE LINE, ELSET=…, TYPE=LINEAR` and in the next line its nodes"));
    }
}

fn slide_line(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<SlideLine> {
    let before = diagnostics.faults();
    let mut nodes = Vec::new();
    for line in scene.deck.lines(entry.card) {
        if entry.has("GENERATE") {
            nodes.extend(generated(entry, line, &scene.scopes[scene.inside].nodes, diagnostics));
        } else {
            let tokens = line.tokens().filter(|token| !token.text.is_empty());
            nodes.extend(tokens.filter_map(|token: Token<'_>| scene.nodes_of(token, diagnostics)).flatten());
        }
    }
    let smooth = part(entry, "SMOOTH", 0.0..=0.5f64.next_down(), 0.0, diagnostics);
    let extension = part(entry, "EXTENSION ZONE", 0.0..=0.2, EXTENSION, diagnostics);
    if diagnostics.faults() > before {
        return None;
    }
    let parabolic = entry.says("TYPE", "PARABOLIC");
    let segments = if parabolic { Segments::Parabolic } else { Segments::Linear };
    let least = if parabolic { 3 } else { 2 };
    if nodes.len() < least {
        let title = format!("this slide line has {} nodes, it needs {least} at least", nodes.len());
        diagnostics.push(Diagnostic::error(entry.card.span, title).help("write the labels of its nodes, in order"));
        return None;
    }
    if parabolic && nodes.len().is_multiple_of(2) {
        let title = format!("this slide line has {} nodes, a parabolic one has an odd number", nodes.len());
        let fault = Diagnostic::error(entry.card.span, title);
        diagnostics.push(fault.help("segments are end, middle, end: they share their ends"));
        return None;
    }
    let line = SlideLine { nodes, segments, smooth, extension };
    if let Some((a, b)) = line.coincident(&scene.structure) {
        let [a, b] = [a, b].map(|node| scene.node_name(node));
        let title = format!("nodes {a} and {b} of this slide line follow each other at the same place");
        diagnostics.push(Diagnostic::error(entry.card.span, title).label("a segment needs a length"));
        return None;
    }
    Some(line)
}

/// A number in a range, the default without it.
fn part(entry: &Entry<'_>, name: &str, range: RangeInclusive<f64>, default: f64, diagnostics: &mut Diagnostics) -> f64 {
    let Some(value) = entry.value(name) else { return default };
    let part = number(&value.text).unwrap_or(default);
    if !range.contains(&part) {
        let most = if *range.end() < 0.5 && *range.end() > 0.4 { "below 0.5".into() } else { range.end().to_string() };
        let title = format!("`{name}` of `*SLIDE LINE` must be from 0 to {most}");
        diagnostics.push(Diagnostic::error(value.span, title));
    }
    part
}
