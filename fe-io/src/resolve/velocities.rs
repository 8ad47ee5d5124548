//! `*INITIAL CONDITIONS, TYPE=VELOCITY`.

use super::lines::{at_least_one, fields};
use super::scene::{Analysis, Scene};
use super::supports::without_freedom;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use std::collections::HashMap;

/// The velocities that a job begins with.
#[derive(Debug, Default)]
pub struct InitialVelocities {
    /// Node, freedom from 0, velocity; in the order of the deck, each freedom once.
    pub items: Vec<(u32, usize, f64)>,
    /// Value of each freedom of a node, and its line.
    of: HashMap<(u32, usize), (f64, Span)>,
}

impl InitialVelocities {
    /// Reads one more card.
    pub fn read(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        if !entry.says("TYPE", "VELOCITY") {
            return;
        }
        if scene.analysis == Analysis::Static {
            let note = Diagnostic::note(entry.card.span, "`*INITIAL CONDITIONS` has no effect in static steps");
            diagnostics.push(note.label("nothing has a velocity"));
        }
        let lines = at_least_one(
            scene.deck.lines(entry.card),
            entry,
            ("this card gives no velocity", "write: node or set, freedom, velocity"),
            diagnostics,
        );
        for line in lines {
            let row = Row::read(line, fields(entry), diagnostics);
            let (Some(token), Some(freedom), Some(value), true) =
                (row.token(0), row.whole(1), row.number(2), row.sound)
            else {
                continue;
            };
            let Some(nodes) = scene.nodes_of(token, diagnostics) else { continue };
            let component = freedom as u8 - 1;
            let there = |node: &u32| scene.masks.get(*node as usize).is_some_and(|mask| mask >> component & 1 == 1);
            if !nodes.iter().any(there) {
                diagnostics.push(without_freedom(token, &[component], &nodes, scene));
                continue;
            }
            for node in nodes.into_iter().filter(there) {
                self.add((node, component.into(), value), line.span, scene, diagnostics);
            }
        }
    }

    fn add(
        &mut self,
        (node, component, value): (u32, usize, f64),
        at: Span,
        scene: &Scene<'_>,
        diagnostics: &mut Diagnostics,
    ) {
        match self.of.insert((node, component), (value, at)) {
            None => self.items.push((node, component, value)),
            Some((first, other)) if first != value => {
                let label = scene.node_name(node);
                let title = format!("freedom {} of node {label} has two initial velocities", component + 1);
                let fault = Diagnostic::error(at, title).label(format!("{value}"));
                diagnostics.push(fault.related(other, format!("first here, {first}")));
            }
            Some(_) => {}
        }
    }
}
