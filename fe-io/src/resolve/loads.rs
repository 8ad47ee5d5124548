//! `*CLOAD`, `*DLOAD` and `*DSLOAD`.

use super::amplitudes::Amplitudes;
use super::lines::{line_fields, set_or_taken_away};
use super::pairs::faces_of;
use super::rigid::unit;
use super::scene::Scene;
use crate::deck::card::{Line, Token};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::element::Family;
use fe_core::load::{Load, LoadKind};
use fe_mesh::{CellId, Face};

/// Reads the loads of a card, one a line.
pub fn read(entry: &Entry<'_>, scene: &Scene<'_>, amplitudes: &Amplitudes, diagnostics: &mut Diagnostics) -> Vec<Load> {
    let amplitude = amplitudes.of(entry, diagnostics);
    let mut loads = Vec::new();
    let words = ("this card loads nothing", "add a line, or say `OP=NEW` to take away earlier loads");
    let lines = set_or_taken_away(scene.deck.lines(entry.card), entry, words, diagnostics);
    for line in lines {
        let read = match entry.keyword.name {
            "CLOAD" => nodal(entry, line, scene, diagnostics),
            "DSLOAD" => on_surface(entry, line, scene, diagnostics),
            _ => on_elements(entry, line, scene, diagnostics),
        };
        loads.extend(read.map(|(kind, magnitude)| Load { kind, magnitude, amplitude }));
    }
    loads
}

fn nodal(
    entry: &Entry<'_>,
    line: Line<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(LoadKind, f64)> {
    let row = Row::read(line, line_fields(entry, 0), diagnostics);
    let (token, freedom, magnitude) = (row.token(0)?, row.whole(1)?, row.number(2)?);
    if !row.sound {
        return None;
    }
    let nodes = scene.nodes_of(token, diagnostics)?;
    let component = freedom as u8 - 1;
    if let Some(&node) = nodes.iter().find(|&&node| scene.masks[node as usize] >> component & 1 == 0) {
        let title = format!("node {} has no freedom {freedom} to load", scene.node_name(node));
        let fault = Diagnostic::error(line.span, title);
        let bare = scene.masks[node as usize] == 0;
        diagnostics.push(if bare { fault.label("it belongs to no element") } else { fault });
        return None;
    }
    Some((LoadKind::Nodal { nodes, component }, magnitude))
}

fn on_surface(
    entry: &Entry<'_>,
    line: Line<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(LoadKind, f64)> {
    let row = Row::read(line, line_fields(entry, 0), diagnostics);
    let (token, kind, magnitude) = (row.token(0)?, row.token(1)?, row.number(2)?);
    let word = kind.text.to_ascii_uppercase();
    if word != "P" {
        diagnostics.push(unknown(kind, &word, "DSLOAD", &["P"]));
        return None;
    }
    let faces = faces_of(token, scene, diagnostics)?;
    if let Some(face) = faces.iter().find(|face| scene.element_of(face.cell).family() != Family::Solid) {
        let title = format!("a pressure acts on faces of solids, element {} is none", scene.cell_name(face.cell));
        let fault = Diagnostic::error(token.span, title);
        diagnostics.push(fault.help("forces per length on trusses and beams: `*DLOAD`, PX, PY or PZ"));
        return None;
    }
    row.sound.then_some((LoadKind::Pressure { faces }, magnitude))
}

/// Kinds of distributed load that decks know and this program does not, by their beginnings.
const NOT_YET: &[&str] =
    &["HP", "BX", "BY", "BZ", "CENT", "CORIO", "ROTA", "TRVEC", "TRSHR", "EDLD", "NEWTON", "VBF", "SBF"];

fn unknown(kind: Token<'_>, word: &str, star: &str, known: &[&str]) -> Diagnostic {
    let user = word.ends_with("NU") && word.starts_with(['P', 'B']);
    if user || NOT_YET.iter().any(|name| word.starts_with(name)) {
        let fault = Diagnostic::error(kind.span, format!("loads of kind `{word}` are not there yet"));
        return fault.help(format!("there is {}", crate::diagnostic::listed(known)));
    }
    let fault = Diagnostic::error(kind.span, format!("`*{star}` has no load of kind `{word}`"));
    fault.known(word, known.iter().copied())
}

fn on_elements(
    entry: &Entry<'_>,
    line: Line<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(LoadKind, f64)> {
    let word = line.tokens().nth(1).map(|token| token.text.to_ascii_uppercase()).unwrap_or_default();
    if word == "GRAV" {
        return gravity(entry, line, scene, diagnostics);
    }
    let row = Row::read(line, line_fields(entry, 0), diagnostics);
    let (token, kind, magnitude) = (row.token(0)?, row.token(1)?, row.number(2)?);
    if let "PX" | "PY" | "PZ" = word.as_str() {
        return on_lines((token, kind), word.as_bytes()[1] - b'X', magnitude, scene, diagnostics);
    }
    let face = match word.strip_prefix('P').map(str::parse::<u8>) {
        Some(Ok(n @ 1..=6)) => n - 1,
        Some(_) if word == "P" => {
            let fault = Diagnostic::error(kind.span, "a pressure on elements names their face");
            diagnostics.push(fault.label("say P1 to P6, or use `*DSLOAD` with a surface"));
            return None;
        }
        _ => {
            diagnostics.push(unknown(
                kind,
                &word,
                "DLOAD",
                &["P1", "P2", "P3", "P4", "P5", "P6", "PX", "PY", "PZ", "GRAV"],
            ));
            return None;
        }
    };
    let cells = scene.cells_of(token, diagnostics)?;
    let count = |cell: CellId| match scene.element_of(cell).family() {
        Family::Solid => scene.structure.mesh.kind(cell).faces().len(),
        _ => 0,
    };
    if let Some(&cell) = cells.iter().find(|&&cell| usize::from(face) >= count(cell)) {
        let label = scene.cell_name(cell);
        let fault = Diagnostic::error(kind.span, format!("element {label} has no face for `{word}`"));
        let (element, faces) = (scene.element_of(cell), count(cell));
        diagnostics.push(match element.family() {
            Family::Truss | Family::Beam => fault.label("PX, PY and PZ are forces per length on trusses and beams"),
            _ if faces == 0 => fault.label(format!("{} has no faces", element.name())),
            _ => fault.label(format!("{} has P1 to P{faces}", element.name())),
        });
        return None;
    }
    let faces = cells.into_iter().map(|cell| Face { cell, face }).collect();
    row.sound.then_some((LoadKind::Pressure { faces }, magnitude))
}

/// A force per length on trusses and beams.
fn on_lines(
    (token, kind): (Token<'_>, Token<'_>),
    component: u8,
    magnitude: f64,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(LoadKind, f64)> {
    let cells = scene.cells_of(token, diagnostics)?;
    let line = |cell: &CellId| matches!(scene.element_of(*cell).family(), Family::Truss | Family::Beam);
    let title = if let Some(&cell) = cells.iter().find(|cell| !line(cell)) {
        let label = scene.cell_name(cell);
        format!("element {label} ({}) is neither truss nor beam", scene.element_of(cell).name())
    } else if component == 2 && scene.structure.is_plane() {
        "a force on lines of a plane model lies in its plane".into()
    } else {
        return Some((LoadKind::Line { cells, component }, magnitude));
    };
    diagnostics.push(Diagnostic::error(kind.span, title).label("a force per length"));
    None
}

fn gravity(
    entry: &Entry<'_>,
    line: Line<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(LoadKind, f64)> {
    let row = Row::read(line, line_fields(entry, 2), diagnostics);
    let magnitude = row.number(2).filter(|_| row.sound)?;
    let direction = [3, 4, 5].map(|i| row.number(i).unwrap_or(0.0));
    let Some(direction) = unit(direction) else {
        diagnostics.push(
            Diagnostic::error(line.span, "gravity has no direction").help("write: set, GRAV, magnitude, x, y, z"),
        );
        return None;
    };
    if scene.structure.is_plane() && direction[2] != 0.0 {
        diagnostics.push(Diagnostic::error(line.span, "gravity of a plane model lies in its plane"));
        return None;
    }
    let cells = match row.token(0) {
        Some(token) => scene.cells_of(token, diagnostics)?,
        None => scene.structure.mesh.cells().collect(),
    };
    let pulled = |own: &[CellId]| own.iter().any(|cell| cells.binary_search(cell).is_ok());
    let structure = &scene.structure;
    let light = structure.sections.iter().find_map(|section| {
        let material = &structure.materials[section.material];
        (material.density.is_none() && pulled(&section.cells)).then_some(&material.name)
    });
    let light_line = structure.lines.iter().find(|section| section.density.is_none() && pulled(&section.cells));
    if let Some(name) = light.or(light_line.map(|section| &section.name)) {
        let title = match structure.materials.iter().any(|material| material.name == *name) {
            true => format!("material `{name}` has no `*DENSITY`"),
            false => format!("the section of `{name}` has no `DENSITY=`"),
        };
        diagnostics.push(Diagnostic::error(line.span, title).label("gravity needs it"));
        return None;
    }
    Some((LoadKind::Gravity { cells, direction }, magnitude))
}
