//! What elements have beside their nodes: `*SOLID SECTION`, `*BEAM SECTION`, `*SPRING` and their like.

use super::lines::fields;
use super::materials::Materials;
use super::scene::{Analysis, Scene};
use super::{beams, discrete};
use crate::deck::card::{Token, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::element::{ElementType, Family, Space};
use fe_core::material::{Material, Response};
use fe_core::structure::{Hourglass, HourglassControl, LineSection, Profile, Section};
use fe_mesh::CellId;
use std::collections::{BTreeMap, BTreeSet};

/// The cards, and the families of elements that each is for.
pub const CARDS: &[(&str, &[Family])] = &[
    ("SOLID SECTION", &[Family::Solid, Family::Truss]),
    ("BEAM SECTION", &[Family::Beam]),
    ("BEAM GENERAL SECTION", &[Family::Beam]),
    ("SPRING", &[Family::Spring]),
    ("DASHPOT", &[Family::Dashpot]),
    ("MASS", &[Family::Mass]),
    ("ROTARY INERTIA", &[Family::RotaryInertia]),
    ("GAP", &[Family::Gap]),
    ("INTERFACE", &[Family::Tube]),
];

/// Reads all of them; elements without one are told.
pub fn read(entries: &[Entry<'_>], materials: &Materials, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let before = diagnostics.faults();
    let blocks = &scene.structure.mesh.blocks;
    let mut taken: Vec<Vec<Option<u32>>> = blocks.iter().map(|block| vec![None; block.len()]).collect();
    for (number, entry) in entries.iter().enumerate() {
        let Some(elset) = entry.value("ELSET") else { continue };
        scene.enter(entry);
        let token = Token { text: &elset.text, span: elset.span };
        let cells: Vec<CellId> = scene.cell_set(token, diagnostics).unwrap_or_default().to_vec();
        let mut twice = None;
        for &cell in &cells {
            let other = &mut taken[cell.block as usize][cell.cell as usize];
            twice = twice.or(other.map(|other| (cell, other)));
            *other = Some(number as u32);
        }
        if let Some((cell, other)) = twice {
            let label = scene.cell_name(cell);
            let fault = Diagnostic::error(elset.span, format!("element {label} has two sections"));
            diagnostics.push(fault.related(entries[other as usize].card.span, "the other one"));
        }
        let of_type = by_type(&cells, scene);
        if suited(entry, token, &of_type, scene, diagnostics) {
            section(entry, of_type, materials, scene, diagnostics);
        }
    }
    scene.leave();
    // A faulty section may be the one that is missing.
    let incomplete = |entry: &Entry<'_>| entry.keyword.parameters.iter().any(|p| p.required && !entry.has(p.name));
    if diagnostics.faults() > before || entries.iter().any(incomplete) {
        return;
    }
    if scene.analysis == Analysis::Explicit {
        densities(entries, materials, scene, diagnostics);
    }
    // Facets of rigid bodies have none.
    let elements = scene.structure.elements.iter();
    let bodies = taken.iter().enumerate().zip(elements).filter(|(_, element)| element.family() != Family::Rigid);
    for ((block, taken), _) in bodies {
        missing(block, taken, scene, diagnostics);
    }
}

/// The cells of each element type.
pub type ByType = BTreeMap<ElementType, Vec<CellId>>;

fn by_type(cells: &[CellId], scene: &Scene<'_>) -> ByType {
    let mut of_type = ByType::new();
    for &cell in cells {
        of_type.entry(scene.element_of(cell)).or_default().push(cell);
    }
    of_type
}

/// True when the card is for these elements; the first that it is not for is told.
fn suited(
    entry: &Entry<'_>,
    elset: Token<'_>,
    of_type: &ByType,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> bool {
    let name = entry.keyword.name;
    let families = CARDS.iter().find(|(card, _)| *card == name).map_or(&[][..], |(_, families)| families);
    let Some((element, cells)) = of_type.iter().find(|(element, _)| !families.contains(&element.family())) else {
        return true;
    };
    diagnostics.push(unsuited(entry, elset, (*element, cells[0]), scene));
    false
}

/// The fault of a card that is not for an element.
pub fn unsuited(
    entry: &Entry<'_>,
    elset: Token<'_>,
    (element, cell): (ElementType, CellId),
    scene: &Scene<'_>,
) -> Diagnostic {
    let (star, label) = (entry.keyword.name, scene.cell_name(cell));
    let title = format!("`*{star}` is not for {} elements such as {label}", element.name());
    Diagnostic::error(elset.span, title).label(format!("they have `*{}`", card_of(element).0))
}

fn section(
    entry: &Entry<'_>,
    of_type: ByType,
    materials: &Materials,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) {
    match entry.keyword.name {
        "SOLID SECTION" => {
            let material = material(entry, materials, diagnostics);
            let material = material.filter(|&m| answers(entry, m, &of_type, scene, diagnostics));
            let measure = measure(entry, &of_type, scene, diagnostics);
            let hourglass = hourglass(entry, &of_type, scene, diagnostics);
            if let (Some(material), Some(measure)) = (material, measure) {
                add(material, (measure, hourglass), of_type, scene);
            }
        }
        "BEAM SECTION" => {
            let material = material(entry, materials, diagnostics);
            let material = material.filter(|&m| answers(entry, m, &of_type, scene, diagnostics));
            beams::read(entry, material, of_type, scene, diagnostics);
        }
        "BEAM GENERAL SECTION" => beams::read_general(entry, of_type, scene, diagnostics),
        // Read with the contact.
        "GAP" | "INTERFACE" => {}
        "ROTARY INERTIA" => discrete::rotary(entry, of_type, scene, diagnostics),
        _ => discrete::read(entry, of_type, scene, diagnostics),
    }
}

/// Index of the material of a card; `None` when it is not there, which is told, or faulty, which was told.
fn material(entry: &Entry<'_>, materials: &Materials, diagnostics: &mut Diagnostics) -> Option<usize> {
    let value = entry.value("MATERIAL")?;
    let name = normalized(&value.text);
    let known = materials.get(&name);
    if known.is_none() {
        let fault = Diagnostic::error(value.span, format!("there is no material `{name}`"));
        diagnostics.push(fault.known(&name, materials.keys().map(String::as_str)));
    }
    *known?
}

/// True when these elements can follow the response of a material; what they cannot is told.
fn answers(
    entry: &Entry<'_>,
    material: usize,
    of_type: &ByType,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> bool {
    let what = match scene.structure.materials[material].response {
        Response::Elastic(_) => return true,
        Response::Plastic { .. } => "plasticity",
        Response::NeoHooke(_) => "hyperelasticity",
    };
    let lines = of_type.keys().find(|element| element.family() != Family::Solid);
    let fault = match (scene.analysis, lines) {
        (_, Some(line)) => {
            let fault = format!("{what} of {} elements is not there yet", line.name());
            (fault, "trusses and beams are elastic: `*ELASTIC`")
        }
        (Analysis::Static, None) => {
            let fault = format!("{what} is not there yet in static steps");
            (fault, "`*ELASTIC` is; explicit steps, `*DYNAMIC, EXPLICIT`, have plasticity and hyperelasticity")
        }
        (Analysis::Explicit, None) => return true,
    };
    let at = entry.value("MATERIAL").map_or(entry.card.span, |value| value.span);
    let title = fault.0;
    let told = Diagnostic::error(at, title).related(scene.material_places[material], "the material");
    diagnostics.push(told.help(fault.1));
    false
}

/// Explicit steps move masses: materials of elements without a density are told, each once.
fn densities(entries: &[Entry<'_>], materials: &Materials, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let mut told = BTreeSet::new();
    for entry in entries {
        let density = entry.value("DENSITY");
        if entry.keyword.name == "BEAM GENERAL SECTION" && density.is_none() {
            let fault =
                Diagnostic::error(entry.card.span, "`*BEAM GENERAL SECTION` needs `DENSITY=` in explicit steps");
            diagnostics.push(fault.label("explicit steps move masses"));
        }
        let Some(material) = entry.name("MATERIAL").and_then(|name| *materials.get(&name)?) else { continue };
        let Material { name, density, .. } = &scene.structure.materials[material];
        if density.is_none() && told.insert(material) {
            let fault =
                Diagnostic::error(scene.material_places[material], format!("material `{name}` has no `*DENSITY`"));
            diagnostics
                .push(fault.label("explicit steps move masses").related(entry.card.span, "these elements need it"));
        }
    }
}

/// Thickness [L] or area [L²] of the data line; `None` when it is faulty.
fn measure(entry: &Entry<'_>, of_type: &ByType, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<f64> {
    let Some(line) = scene.deck.lines(entry.card).next() else { return Some(1.0) };
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(element) = of_type.keys().next()
        && row.sound
        && row.token(0).is_some()
        && !of_type.keys().any(|element| is_thick(*element) || element.family() == Family::Truss)
    {
        let note = Diagnostic::note(line.span, format!("{} elements have no thickness", element.name()));
        diagnostics.push(note.label("without effect"));
    }
    row.sound.then(|| row.number(0).unwrap_or(1.0))
}

/// The hourglass control of a section; one that is not there is told.
fn hourglass(
    entry: &Entry<'_>,
    of_type: &ByType,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Hourglass> {
    let value = entry.value("CONTROLS")?;
    let name = normalized(&value.text);
    let known = scene.section_controls.get(&name);
    if known.is_none() {
        let fault = Diagnostic::error(value.span, format!("there are no section controls `{name}`"));
        let fault = fault.known(&name, scene.section_controls.keys().map(String::as_str));
        diagnostics.push(fault.help("say `*SECTION CONTROLS, NAME=…`"));
    } else if let Some(full) = of_type.keys().find(|element| !ElementType::REDUCED.contains(element)) {
        let note = Diagnostic::note(value.span, format!("`CONTROLS` has no effect on {} elements", full.name()));
        diagnostics.push(note.label("they have no hourglass modes"));
    }
    known?.0
}

/// `*SECTION CONTROLS`.
pub fn controls(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(value) = entry.value("NAME") else { return };
    let name = normalized(&value.text);
    let row = scene.deck.all_lines(entry.card).next().map(|line| Row::read(line, fields(entry), diagnostics));
    let control = match entry.name("HOURGLASS").as_deref() {
        Some("ENHANCED") => Some(HourglassControl::Enhanced),
        Some("STIFFNESS") => Some(HourglassControl::Stiffness),
        Some("VISCOUS") => Some(HourglassControl::Viscous),
        _ => None,
    };
    let scale = row.as_ref().and_then(|row| row.number(0));
    if let (None, Some(_), Some(row)) = (control, scale, &row) {
        let fault = Diagnostic::error(row.span, "a hourglass scale needs `HOURGLASS=`");
        diagnostics.push(fault.help("say which control it is a factor on"));
    }
    let hourglass = control.map(|control| Hourglass { control, scale: scale.unwrap_or(1.0) });
    if let Some((_, first)) = scene.section_controls.insert(name.clone(), (hourglass, value.span)) {
        let fault = Diagnostic::error(value.span, format!("section controls `{name}` are there twice"));
        diagnostics.push(fault.related(first, "first here"));
    }
}

fn is_thick(element: ElementType) -> bool {
    matches!(element.space(), Space::PlaneStrain | Space::PlaneStress)
}

/// One section for each element type of a set.
fn add(material: usize, (measure, hourglass): (f64, Option<Hourglass>), of_type: ByType, scene: &mut Scene<'_>) {
    for (element, cells) in of_type {
        if element.family() == Family::Solid {
            let thickness = if is_thick(element) { measure } else { 1.0 };
            let hourglass = hourglass.filter(|_| ElementType::REDUCED.contains(&element));
            scene.structure.sections.push(Section { element, cells, material, thickness, hourglass });
        } else {
            let profile = Profile::bar(measure);
            scene.structure.lines.push(line_section(element, cells, material, profile, scene));
        }
    }
}

/// A section of trusses or beams of a material.
pub fn line_section(
    element: ElementType,
    cells: Vec<CellId>,
    material: usize,
    profile: Profile,
    scene: &Scene<'_>,
) -> LineSection {
    let material = &scene.structure.materials[material];
    let elastic = material.response.elastic();
    LineSection {
        element,
        cells,
        name: material.name.clone(),
        young: elastic.young,
        shear: elastic.mu(),
        density: material.density,
        damping: material.damping,
        profile,
        first_axis: beams::FIRST_AXIS,
    }
}

fn missing(block: usize, taken: &[Option<u32>], scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let bare: Vec<usize> = (0..taken.len()).filter(|&i| taken[i].is_none()).collect();
    let Some(&first) = bare.first() else { return };
    let cell = CellId { block: block as u32, cell: first as u32 };
    let (label, element) = (scene.cell_name(cell), scene.element_of(cell));
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
        Family::RotaryInertia => ("ROTARY INERTIA", "ELSET=…"),
        Family::Gap => ("GAP", "ELSET=…"),
        Family::Tube => ("INTERFACE", "ELSET=…"),
        Family::Rigid => ("RIGID BODY", "REF NODE=…, ELSET=…"),
    }
}
