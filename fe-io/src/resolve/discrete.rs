//! `*SPRING`, `*DASHPOT`, `*MASS` and `*ROTARY INERTIA`.

use super::lines::{line_fields, one_line};
use super::scene::{Analysis, Scene};
use super::sections::ByType;
use crate::deck::card::Line;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::element::ElementType::{self, *};
use fe_core::structure::{Discrete, RotaryInertia};

/// Reads the magnitude of a card, and the freedoms where its elements name some.
pub fn read(entry: &Entry<'_>, of_type: ByType, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let name = entry.keyword.name;
    if name == "DASHPOT" && scene.analysis == Analysis::Static {
        let note = Diagnostic::note(entry.card.span, "dashpots have no force in static steps");
        diagnostics.push(note.label("there is no velocity"));
    }
    let named = |element: &ElementType| matches!(element, SPRING1 | SPRING2 | DASHPOT1 | DASHPOT2);
    let along = |element: &ElementType| matches!(element, SPRINGA | DASHPOTA);
    if let (Some(one), Some(other)) = (of_type.keys().find(|e| named(e)), of_type.keys().find(|e| along(e))) {
        let title = format!("{} and {} elements have no section in common", one.name(), other.name());
        let fault = Diagnostic::error(entry.card.span, title);
        diagnostics.push(fault.label("the one names a freedom, the other acts along its line"));
        return;
    }
    // Blank lines, which stand for freedoms that are not named, are left out.
    let lines: Vec<Line<'_>> = scene.deck.lines(entry.card).collect();
    let freedoms = of_type.keys().any(named);
    let wanted = if freedoms { 2 } else { 1 };
    if lines.len() != wanted {
        let words = if freedoms { "the freedom, then" } else { "one with" };
        let number = line_fields(entry, usize::from(name != "MASS"))[0].name;
        let title = format!("`*{name}` has {} data lines here, not {wanted}", lines.len());
        let at = lines.get(wanted).map_or(entry.card.span, |line| line.span);
        diagnostics.push(Diagnostic::error(at, title).help(format!("write: {words} the {number}")));
        return;
    }
    let components = if freedoms { components(entry, lines[0], scene, diagnostics) } else { Some([0; 2]) };
    let row = Row::read(lines[wanted - 1], line_fields(entry, usize::from(name != "MASS")), diagnostics);
    if let (Some(components), Some(magnitude), true) = (components, row.number(0), row.sound) {
        for (element, cells) in of_type {
            scene.structure.discrete.push(Discrete { element, cells, magnitude, components });
        }
    }
}

/// Reads a tensor of inertia, which a body must be able to have.
pub fn rotary(entry: &Entry<'_>, of_type: ByType, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    if scene.structure.is_axisymmetric() {
        let fault = Diagnostic::error(entry.card.span, "there are no rotations in an axisymmetric model");
        diagnostics.push(fault.label("nothing turns here: leave it out"));
        return;
    }
    let Some(row) = one_line(entry, scene.deck, diagnostics) else { return };
    let numbers = [0, 1, 2, 3, 4, 5].map(|i| row.number(i).unwrap_or(0.0));
    let [i11, i22, i33, i12, i13, i23] = numbers;
    let (moments, products) = ([i11, i22, i33], [i12, i13, i23]);
    let inertia = RotaryInertia { cells: of_type.into_values().flatten().collect(), moments, products };
    let principal = inertia.tensor().symmetric_eigenvalues();
    let (title, label) = if scene.structure.is_plane() && i33 == 0.0 {
        ("this rotary inertia is none", "in the plane I33 counts: the third number".to_owned())
    } else if principal.amax() == 0.0 {
        ("this rotary inertia is none", "a tensor with entries above 0".to_owned())
    } else if principal.min() < -1e-9 * principal.amax() {
        ("no body has this rotary inertia", format!("about one axis it would be {:.6e}", principal.min()))
    } else {
        scene.structure.rotary.push(inertia);
        return;
    };
    diagnostics.push(Diagnostic::error(row.span, title).label(label));
}

/// Freedoms of both nodes, from 0; `None` when they are faulty, which is told.
fn components(entry: &Entry<'_>, line: Line<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<[u8; 2]> {
    let row = Row::read(line, line_fields(entry, 0), diagnostics);
    if !row.sound {
        return None;
    }
    let first = row.whole(0)?;
    let components = [first, row.whole(1).unwrap_or(first)].map(|freedom| freedom as u8 - 1);
    let structure = &scene.structure;
    let space = structure.rigid_mask() | if structure.is_plane() { 0b11 } else { 0b111 };
    if let Some(missing) = components.iter().find(|&&component| space >> component & 1 == 0) {
        let fault = Diagnostic::error(line.span, format!("there is no freedom {} in this model", missing + 1));
        let there = if structure.is_axisymmetric() { "1 and 2" } else { "1, 2 and 6" };
        diagnostics.push(fault.label(format!("the plane has {there}")));
        return None;
    }
    Some(components)
}
