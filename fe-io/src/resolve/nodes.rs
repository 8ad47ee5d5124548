//! `*NODE`.

use super::lines::fields;
use super::scene::Scene;
use crate::deck::card::Line;
use crate::deck::number::{number, whole};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;

/// Reads the nodes of a card.
pub fn read(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let first = scene.node_places.len() as u32;
    for line in scene.deck.lines(entry.card) {
        match node(line) {
            Some((label, at, point)) => add(scene, label, at, point, diagnostics),
            None => faulty(entry, line, scene, diagnostics),
        }
    }
    let last = scene.node_places.len() as u32;
    if let Some(name) = entry.name("NSET") {
        let name = scene.own_name(&name);
        scene.structure.mesh.node_sets.entry(name).or_default().extend(first..last);
    }
}

/// A sound line: label, its place, coordinates.
fn node(line: Line<'_>) -> Option<(u64, Span, [f64; 3])> {
    let mut tokens = line.tokens();
    let label = tokens.next()?;
    let mut point = [0.0; 3];
    for (i, token) in tokens.enumerate() {
        if !token.text.is_empty() {
            *point.get_mut(i)? = number(token.text)?;
        }
    }
    Some((whole(label.text)?, label.span, point))
}

/// Adds a node; a label that is taken is told.
pub fn add(scene: &mut Scene<'_>, label: u64, at: Span, point: [f64; 3], diagnostics: &mut Diagnostics) {
    let index = scene.node_places.len() as u32;
    match scene.scope_mut().nodes.insert(label, index) {
        Ok(()) => {
            let point = scene.scope().motion.point(point);
            scene.structure.mesh.points.push(point);
            scene.structure.mesh.point_labels.push(label);
            scene.node_places.push(at);
            scene.instance_mut().into_iter().for_each(|instance| instance.add_point(index));
        }
        Err(other) => {
            let fault = Diagnostic::error(at, format!("node {label} is there twice"));
            diagnostics.push(fault.related(scene.node_places[other as usize], "first here"));
        }
    }
}

fn faulty(entry: &Entry<'_>, line: Line<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(label) = row.whole(0) {
        scene.scope_mut().nodes.spoil(label);
    }
}
