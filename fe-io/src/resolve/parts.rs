//! `*PART`, `*INSTANCE` and `*ASSEMBLY`: the cards of a part are read once for each of its instances.

use super::motion::{Motion, Rotation};
use super::scene::Scene;
use crate::deck::card::{Card, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::Level;
use crate::keyword::check::Entry;
use crate::keyword::parts::{ROTATION, TRANSLATION};
use crate::keyword::row::Row;
use std::collections::BTreeMap;

/// Parts by name: the card, and how many instances there are.
type Parts<'a> = BTreeMap<String, (&'a Card, usize)>;

/// The cards with those of the parts in the places of their instances. Decks without parts stay as they are.
pub fn placed<'a>(entries: &[Entry<'a>], scene: &mut Scene<'a>, diagnostics: &mut Diagnostics) -> Vec<Entry<'a>> {
    let before = diagnostics.faults();
    let mut parts = parts(entries, diagnostics);
    let mut placed = Vec::with_capacity(entries.len());
    let mut scope = 0;
    for entry in entries {
        match entry.keyword.name {
            "ASSEMBLY" => assembly(entry, scene, diagnostics),
            "INSTANCE" => {
                let part = part_of(entry, &mut parts, diagnostics);
                scope = instance(entry, scene, diagnostics).unwrap_or(0);
                let cards =
                    entries.iter().filter(|of| part.is_some() && of.block.map(|b| b.span) == part.map(|p| p.span));
                placed.extend(cards.filter(|of| of.keyword.level == Level::Part).map(|of| Entry { scope, ..*of }));
            }
            _ => match (entry.block, entry.keyword.level) {
                (Some(block), Level::Part) if block.keyword == "PART" => {}
                (Some(_), Level::Part) => placed.push(Entry { scope, ..*entry }),
                // In a wrong place, which was told; a material is known there, too.
                (None, _) | (_, Level::Model) => placed.push(*entry),
                _ => {}
            },
        }
    }
    for (name, (card, _)) in parts.iter().filter(|(_, (_, instances))| *instances == 0) {
        let title = format!("part `{name}` has no instance");
        diagnostics.push(Diagnostic::warning(card.span, title).label("it is left out"));
    }
    let nameless = |entry: &Entry<'_>| entry.keyword.name == "INSTANCE" && !(entry.has("NAME") && entry.has("PART"));
    scene.unread |= diagnostics.faults() > before || entries.iter().any(nameless);
    placed
}

fn parts<'a>(entries: &[Entry<'a>], diagnostics: &mut Diagnostics) -> Parts<'a> {
    let mut parts = Parts::new();
    for entry in entries.iter().filter(|entry| entry.keyword.name == "PART") {
        let Some(value) = entry.value("NAME") else { continue };
        let name = normalized(&value.text);
        if let Some((first, _)) = parts.get(&name) {
            let fault = Diagnostic::error(value.span, format!("part `{name}` is there twice"));
            diagnostics.push(fault.related(first.span, "first here"));
            continue;
        }
        parts.insert(name, (entry.card, 0));
    }
    parts
}

fn assembly(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    if scene.assembly.is_some() {
        let fault = Diagnostic::error(entry.card.span, "a deck has one assembly, this is another one");
        diagnostics.push(fault.help("write all instances into the first one"));
    }
    scene.assembly = entry.name("NAME");
}

/// The part of an instance; a missing one is told.
fn part_of<'a>(entry: &Entry<'a>, parts: &mut Parts<'a>, diagnostics: &mut Diagnostics) -> Option<&'a Card> {
    let value = entry.value("PART")?;
    let name = normalized(&value.text);
    if let Some((card, instances)) = parts.get_mut(&name) {
        *instances += 1;
        return Some(card);
    }
    let fault = Diagnostic::error(value.span, format!("there is no part `{name}`"));
    let fault = fault.known(&name, parts.keys().map(String::as_str));
    diagnostics.push(if parts.is_empty() { fault.help("write `*PART, NAME=…` before the assembly") } else { fault });
    None
}

/// Adds the scope of an instance; a name that is taken, and faulty data lines, are told.
fn instance(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Option<usize> {
    let motion = motion(entry, scene, diagnostics).unwrap_or_default();
    let value = entry.value("NAME")?;
    let name = normalized(&value.text);
    if name.contains('.') {
        let fault = Diagnostic::error(value.span, format!("the name `{name}` of an instance holds a point"));
        diagnostics.push(fault.help("points stand between an instance and what it holds: INSTANCE.SET"));
    }
    if scene.structure.mesh.instances.iter().any(|instance| instance.name == name) {
        diagnostics.push(Diagnostic::error(value.span, format!("instance `{name}` is there twice")));
    }
    Some(scene.add_instance(&name, motion))
}

fn motion(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Motion> {
    // A blank line stands for no translation.
    let mut lines = scene.deck.all_lines(entry.card);
    let mut row = |fields| {
        let line = lines.next().filter(|line| !line.text.is_empty());
        line.map(|line| Row::read(line, fields, &mut *diagnostics)).filter(|row| row.sound)
    };
    let (first, second) = (row(TRANSLATION), row(ROTATION));
    let number = |row: &Row<'_>, i: usize| row.number(i).unwrap_or(0.0);
    let point = |row: &Row<'_>, from: usize| std::array::from_fn(|c| number(row, from + c));
    let mut motion = Motion::default();
    if let Some(row) = first {
        motion.translation = point(&row, 0);
    }
    if let Some(row) = second {
        let angle = row.number(6)?;
        motion.rotation = Rotation::new(point(&row, 0), point(&row, 3), angle);
        if motion.rotation.is_none() {
            let fault = Diagnostic::error(row.span, "the axis of this rotation has no length: both points are one");
            diagnostics.push(fault.help("write: point a, point b (three coordinates each), angle in degrees"));
        }
    }
    Some(motion)
}
