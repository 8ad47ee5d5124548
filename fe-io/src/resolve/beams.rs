//! `*BEAM SECTION` and `*BEAM GENERAL SECTION`.

use super::lines::line_fields;
use super::rigid::unit;
use super::scene::Scene;
use super::sections::{ByType, line_section};
use crate::deck::card::Line;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::{Entry, too_many_lines};
use crate::keyword::row::{Row, names};
use fe_core::element::Space;
use fe_core::material::Damping;
use fe_core::structure::{LineSection, Profile};

/// Axis 1 of cross-sections without a direction, and of those in the plane: Abaqus Analysis User's Guide, Beam element
/// cross-section orientation.
pub const FIRST_AXIS: [f64; 3] = [0.0, 0.0, -1.0];

/// Kinds of data lines in the tables.
const RECTANGLE: usize = 0;
const CIRCLE: usize = 1;
const PIPE: usize = 2;
const AXIS: usize = 3;
const POINTS: usize = 4;
const GENERAL: usize = 4;
const MODULI: usize = 5;

/// So many data lines has a section.
const MOST: usize = 3;

/// Reads a section of a shape and a material; `None` stands for one that is faulty, which was told.
pub fn read(
    entry: &Entry<'_>,
    material: Option<usize>,
    of_type: ByType,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) {
    let lines = lines(entry, scene);
    let profile = profile(entry, lines.first(), diagnostics);
    let axis = axis(entry, lines.get(1), diagnostics);
    if let Some(&line) = lines.get(2) {
        Row::read(line, line_fields(entry, POINTS), diagnostics);
    }
    surplus(entry, &lines, diagnostics);
    if let (Some(material), Some(profile), Some(axis)) = (material, profile, axis) {
        for (element, cells) in of_type {
            let section = line_section(element, cells, material, profile, scene);
            add(section, axis, scene);
        }
    }
}

/// Reads a section that brings its moduli.
pub fn read_general(entry: &Entry<'_>, of_type: ByType, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let lines = lines(entry, scene);
    let profile = profile(entry, lines.first(), diagnostics);
    let axis = axis(entry, lines.get(1), diagnostics);
    surplus(entry, &lines, diagnostics);
    let density = entry.value("DENSITY").and_then(|value| number(&value.text));
    let Some(&line) = lines.get(2) else {
        let fault = Diagnostic::error(entry.card.span, "`*BEAM GENERAL SECTION` has no moduli");
        diagnostics.push(fault.help("write three lines: the section, n1 (it may be blank), and E, G"));
        return;
    };
    let row = Row::read(line, line_fields(entry, MODULI), diagnostics);
    let (Some(profile), Some(axis), Some(young), true) = (profile, axis, row.number(0), row.sound) else { return };
    let (shear, name) = (row.number(1).unwrap_or(0.0), entry.name("ELSET").unwrap_or_default());
    for (element, cells) in of_type {
        let first_axis = FIRST_AXIS;
        let (name, damping) = (name.clone(), Damping::default());
        let section = LineSection { element, cells, name, young, shear, density, damping, profile, first_axis };
        if complete(&section, entry, diagnostics) {
            add(section, axis, scene);
        }
    }
}

/// Beams in space bend about both axes and twist, shear-flexible ones shear: a section without is told.
fn complete(section: &LineSection, entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> bool {
    use fe_core::element::ElementType::{B21, B31};
    let (p, element) = (&section.profile, section.element);
    let lacks = if element.space() == Space::Solid && p.i22 == 0.0 {
        "I22"
    } else if element.space() == Space::Solid && p.torsion == 0.0 {
        "J"
    } else if section.shear == 0.0 && (element.space() == Space::Solid || matches!(element, B21 | B31)) {
        "G"
    } else if p.i11 * p.i22 <= p.i12 * p.i12 && element.space() == Space::Solid {
        let title = "I11 I22 must be larger than I12²: no cross-section has such moments";
        diagnostics.push(Diagnostic::error(entry.card.span, title));
        return false;
    } else {
        return true;
    };
    let fault = Diagnostic::error(entry.card.span, format!("{lacks} is missing, or 0"));
    diagnostics.push(fault.label(format!("{} elements need it", element.name())));
    false
}

fn add(mut section: LineSection, axis: [f64; 3], scene: &mut Scene<'_>) {
    if section.element.space() == Space::Solid {
        section.first_axis = scene.scope().motion.direction(axis);
    }
    scene.structure.lines.push(section);
}

/// The cross-section; `None` when it is faulty or missing, which is told.
fn profile(entry: &Entry<'_>, line: Option<&Line<'_>>, diagnostics: &mut Diagnostics) -> Option<Profile> {
    let shape = entry.name("SECTION").unwrap_or_else(|| "GENERAL".into());
    let kind = match shape.as_str() {
        "RECT" => RECTANGLE,
        "CIRC" => CIRCLE,
        "PIPE" => PIPE,
        "GENERAL" => GENERAL,
        // Refused by name.
        _ => return None,
    };
    let Some(&line) = line else {
        let title = format!("`*{}` has no data line", entry.keyword.name);
        let wanted = names(line_fields(entry, kind));
        diagnostics.push(Diagnostic::error(entry.card.span, title).help(format!("write: {wanted}")));
        return None;
    };
    let row = Row::read(line, line_fields(entry, kind), diagnostics);
    if !row.sound {
        return None;
    }
    let (first, second) = (row.number(0)?, row.number(1));
    match kind {
        RECTANGLE => Some(Profile::rectangle(first, second?)),
        CIRCLE => Some(Profile::circle(first)),
        PIPE if second? > first => {
            let fault = Diagnostic::error(line.span, "the wall of the pipe is thicker than its radius");
            diagnostics.push(fault.help("write: outer radius, thickness of the wall"));
            None
        }
        PIPE => Some(Profile::pipe(first, second?)),
        _ => {
            let [i12, i22, torsion] = [2, 3, 4].map(|i| row.number(i).unwrap_or(0.0));
            Some(Profile { area: first, i11: second?, i12, i22, torsion, shear_factor: 1.0 })
        }
    }
}

/// Direction of axis 1; `None` when it is faulty, which is told.
fn axis(entry: &Entry<'_>, line: Option<&Line<'_>>, diagnostics: &mut Diagnostics) -> Option<[f64; 3]> {
    let Some(&line) = line.filter(|line| line.tokens().any(|token| !token.text.is_empty())) else {
        return Some(FIRST_AXIS);
    };
    let row = Row::read(line, line_fields(entry, AXIS), diagnostics);
    if !row.sound {
        return None;
    }
    let axis = unit([0, 1, 2].map(|i| row.number(i).unwrap_or(0.0)));
    if axis.is_none() {
        let fault = Diagnostic::error(line.span, "the direction n1 is zero");
        diagnostics.push(fault.help("write three components, or leave the line blank for (0, 0, −1)"));
    }
    axis
}

/// All data lines but blank ones at the end: a blank line before stands for axis 1.
fn lines<'a>(entry: &Entry<'a>, scene: &Scene<'a>) -> Vec<Line<'a>> {
    let mut lines: Vec<Line<'a>> = scene.deck.all_lines(entry.card).collect();
    while lines.last().is_some_and(|line| line.text.is_empty()) {
        lines.pop();
    }
    lines
}

/// Tells a fourth line.
fn surplus(entry: &Entry<'_>, lines: &[Line<'_>], diagnostics: &mut Diagnostics) {
    if let Some(line) = lines.get(MOST).filter(|line| !line.text.is_empty()) {
        diagnostics.push(too_many_lines(entry.keyword.name, MOST, line.span));
    }
}
