//! `*MATERIAL` with its cards, and `*SOLID SECTION`.

use super::nodes::fields;
use super::scene::Scene;
use crate::deck::card::{Token, normalized};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::element::{ElementType, Family, Space};
use fe_core::material::{Elastic, Material};
use fe_core::structure::Section;
use fe_mesh::CellId;
use std::collections::BTreeMap;

/// A material while it is read.
#[derive(Debug)]
struct Draft {
    name: String,
    at: Span,
    elastic: Option<(Elastic, Span)>,
    density: Option<f64>,
    faulty: bool,
}

/// Materials by name: index into the structure's, or `None` for one that is faulty, which was told.
pub type Materials = BTreeMap<String, Option<usize>>;

/// Reads materials, in the order of the deck.
pub fn read(entries: &[Entry<'_>], scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Materials {
    let mut drafts: Vec<Draft> = Vec::new();
    for entry in entries {
        if entry.keyword.name == "MATERIAL" {
            drafts.extend(begin(entry, &drafts, diagnostics));
            continue;
        }
        let before = diagnostics.faults();
        let row = one_line(entry, scene, diagnostics);
        let Some(draft) = drafts.last_mut() else {
            let title = format!("`*{}` stands under no `*MATERIAL`", entry.keyword.name);
            diagnostics.push(Diagnostic::error(entry.card.span, title));
            continue;
        };
        match (entry.keyword.name, row) {
            ("ELASTIC", Some(row)) => {
                let elastic = row.number(0).map(|young| Elastic { young, poisson: row.number(1).unwrap_or(0.0) });
                draft.elastic = elastic.map(|elastic| (elastic, row.span));
            }
            (_, Some(row)) => draft.density = row.number(0),
            (_, None) => {}
        }
        draft.faulty |= diagnostics.faults() > before;
    }
    drafts.into_iter().map(|draft| finish(draft, scene, diagnostics)).collect()
}

fn begin(entry: &Entry<'_>, drafts: &[Draft], diagnostics: &mut Diagnostics) -> Option<Draft> {
    let value = entry.value("NAME")?;
    let name = normalized(&value.text);
    if let Some(first) = drafts.iter().find(|draft| draft.name == name) {
        let fault = Diagnostic::error(value.span, format!("material `{name}` is there twice"));
        diagnostics.push(fault.related(first.at, "first here"));
    }
    Some(Draft { name, at: value.span, elastic: None, density: None, faulty: false })
}

/// The one data line of a material's card.
fn one_line<'a>(entry: &Entry<'a>, scene: &Scene<'a>, diagnostics: &mut Diagnostics) -> Option<Row<'a>> {
    let mut lines = scene.deck.lines(entry.card);
    let Some(line) = lines.next() else {
        let title = format!("`*{}` has no data line", entry.keyword.name);
        let wanted: Vec<&str> = fields(entry).iter().map(|field| field.name).collect();
        diagnostics.push(Diagnostic::error(entry.card.span, title).help(format!("write: {}", wanted.join(", "))));
        return None;
    };
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(more) = lines.next() {
        let title = format!("more than one line under `*{}` is not there yet", entry.keyword.name);
        diagnostics.push(Diagnostic::error(more.span, title).help("there are no temperatures: give one line"));
    }
    row.sound.then_some(row)
}

fn finish(draft: Draft, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> (String, Option<usize>) {
    if draft.faulty {
        return (draft.name, None);
    }
    let Some((elastic, _)) = draft.elastic else {
        let fault = Diagnostic::error(draft.at, format!("material `{}` has no `*ELASTIC`", draft.name));
        diagnostics.push(fault);
        return (draft.name, None);
    };
    scene.structure.materials.push(Material { name: draft.name.clone(), elastic, density: draft.density });
    (draft.name, Some(scene.structure.materials.len() - 1))
}

/// Reads sections; elements without one are told.
pub fn sections(entries: &[Entry<'_>], materials: &Materials, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let before = diagnostics.faults();
    let blocks = &scene.structure.mesh.blocks;
    let mut taken: Vec<Vec<Option<u32>>> = blocks.iter().map(|block| vec![None; block.len()]).collect();
    for (number, entry) in entries.iter().enumerate() {
        let (Some(elset), Some(material)) = (entry.value("ELSET"), entry.value("MATERIAL")) else { continue };
        let token = Token { text: &elset.text, span: elset.span };
        let cells: Vec<CellId> = scene.cell_set(token, diagnostics).unwrap_or_default().to_vec();
        let name = normalized(&material.text);
        let known = materials.get(&name);
        if known.is_none() {
            let fault = Diagnostic::error(material.span, format!("there is no material `{name}`"));
            diagnostics.push(fault.known(&name, materials.keys().map(String::as_str)));
        }
        let mut twice = None;
        for &cell in &cells {
            let other = &mut taken[cell.block as usize][cell.cell as usize];
            twice = twice.or(other.map(|other| (cell, other)));
            *other = Some(number as u32);
        }
        if let Some((cell, other)) = twice {
            let label = scene.structure.mesh.cell_label(cell);
            let fault = Diagnostic::error(elset.span, format!("element {label} has two sections"));
            diagnostics.push(fault.related(entries[other as usize].card.span, "the other one"));
        }
        if let Some(other) = cells.iter().map(|&cell| scene.element_of(cell)).find(|e| e.family() != Family::Solid) {
            let title = format!("`*SOLID SECTION` is for solids, {} elements are none", other.name());
            diagnostics.push(Diagnostic::error(elset.span, title));
            continue;
        }
        let thickness = thickness(entry, &cells, scene, diagnostics);
        if let (Some(Some(material)), Some(thickness)) = (known, thickness) {
            add(*material, thickness, &cells, scene);
        }
    }
    // A faulty section may be the one that is missing.
    if diagnostics.faults() > before || entries.iter().any(|entry| !entry.has("ELSET") || !entry.has("MATERIAL")) {
        return;
    }
    for (block, taken) in taken.iter().enumerate() {
        missing(block, taken, scene, diagnostics);
    }
}

/// Thickness [L] of the data line; `None` when it is faulty.
fn thickness(entry: &Entry<'_>, cells: &[CellId], scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<f64> {
    let Some(line) = scene.deck.lines(entry.card).next() else { return Some(1.0) };
    let row = Row::read(line, fields(entry), diagnostics);
    let thick = |cell: &CellId| matches!(scene.element_of(*cell).space(), Space::PlaneStrain | Space::PlaneStress);
    if row.sound && !cells.is_empty() && row.token(0).is_some() && !cells.iter().any(thick) {
        let element = scene.element_of(cells[0]).name();
        let note = Diagnostic::note(line.span, format!("{element} elements have no thickness"));
        diagnostics.push(note.label("without effect"));
    }
    row.sound.then(|| row.number(0).unwrap_or(1.0))
}

/// One section for each element type of a set.
fn add(material: usize, thickness: f64, cells: &[CellId], scene: &mut Scene<'_>) {
    let mut of_type: BTreeMap<ElementType, Vec<CellId>> = BTreeMap::new();
    for &cell in cells {
        of_type.entry(scene.element_of(cell)).or_default().push(cell);
    }
    for (element, cells) in of_type {
        let plane = matches!(element.space(), Space::PlaneStrain | Space::PlaneStress);
        let thickness = if plane { thickness } else { 1.0 };
        scene.structure.sections.push(Section { element, cells, material, thickness });
    }
}

fn missing(block: usize, taken: &[Option<u32>], scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let bare: Vec<usize> = (0..taken.len()).filter(|&i| taken[i].is_none()).collect();
    let Some(&first) = bare.first() else { return };
    let cell = CellId { block: block as u32, cell: first as u32 };
    let (label, element) = (scene.structure.mesh.cell_label(cell), scene.element_of(cell));
    let (name, (card, parameters)) = (element.name(), card_of(element));
    let title = match bare.len() {
        1 => format!("element {label} ({name}) has no `*{card}`"),
        n => format!("{n} elements ({name}) have no `*{card}`, the first is {label}"),
    };
    if let Some(at) = scene.place_of(cell) {
        let fault = Diagnostic::error(at, title);
        diagnostics.push(fault.help(format!("write `*{card}, {parameters}` for a set that holds them")));
    }
}

/// The card that gives elements of a type what they need beside their nodes, and its parameters.
fn card_of(element: ElementType) -> (&'static str, &'static str) {
    match element.family() {
        Family::Solid | Family::Truss => ("SOLID SECTION", "ELSET=…, MATERIAL=…"),
        Family::Beam => ("BEAM SECTION", "ELSET=…, MATERIAL=…, SECTION=…"),
        Family::Spring => ("SPRING", "ELSET=…"),
        Family::Dashpot => ("DASHPOT", "ELSET=…"),
        Family::Mass => ("MASS", "ELSET=…"),
        Family::Gap => ("GAP", "ELSET=…"),
        Family::Tube => ("INTERFACE", "ELSET=…"),
    }
}
