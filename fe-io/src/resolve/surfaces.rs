//! `*SURFACE` of faces and of nodes.

use super::combine;
use super::faces::Shared;
use super::nodes::line_fields;
use super::rigid;
use super::scene::{Scene, Surface};
use crate::deck::card::{Token, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_mesh::{CellId, Face};

/// Reads a surface.
pub fn read(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(value) = entry.value("NAME") else { return };
    let Some(name) = scene.new_name(value, diagnostics) else { return };
    let written = normalized(&value.text);
    if let Some((_, first)) = scene.surfaces.get(&name) {
        let fault = Diagnostic::error(value.span, format!("surface `{written}` is there twice"));
        diagnostics.push(fault.related(*first, "first here"));
        return;
    }
    let before = diagnostics.faults();
    let surface = match entry.name("TYPE").unwrap_or_default().as_str() {
        "NODE" | "SEGMENTS" | "CYLINDER" | "REVOLUTION" if entry.has("COMBINE") => {
            let fault = Diagnostic::error(entry.card.span, "`COMBINE` is for surfaces of faces");
            diagnostics.push(fault.help("leave `TYPE` out, and name surfaces of faces"));
            None
        }
        "" | "ELEMENT" => {
            let faces = match entry.name("COMBINE") {
                Some(how) => combine::faces(entry, &how, scene, diagnostics),
                None => faces(entry, &written, scene, diagnostics),
            };
            faces.and_then(|faces| finish(entry, &written, faces, diagnostics)).map(|f| in_mesh(&name, f, scene))
        }
        "NODE" => nodes(entry, &written, scene, diagnostics).map(Surface::Nodes),
        kind => rigid::surface(entry, &name, kind, scene, diagnostics).map(Surface::Rigid),
    };
    let surface = match surface {
        Some(surface) if diagnostics.faults() == before => surface,
        _ => Surface::Faulty,
    };
    scene.surfaces.insert(name, (surface, value.span));
}

/// Faces of elements stand in the mesh.
fn in_mesh(name: &str, faces: Vec<Face>, scene: &mut Scene<'_>) -> Surface {
    scene.structure.mesh.surfaces.insert(name.to_owned(), faces);
    Surface::Faces
}

/// What a line of faces asks for.
enum Asked {
    Face(u8),
    Free,
}

/// The faces of the data lines, in their order.
fn faces(entry: &Entry<'_>, name: &str, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<Face>> {
    let mut faces: Vec<(Face, Token<'_>)> = Vec::new();
    let mut free: Vec<(Vec<CellId>, Token<'_>)> = Vec::new();
    let mut sound = true;
    for line in scene.deck.lines(entry.card) {
        let row = Row::read(line, line_fields(entry, 0), diagnostics);
        let (Some(token), true) = (row.token(0), row.sound) else { continue };
        let asked = match row.token(1) {
            None => Some(Asked::Free),
            Some(face) => face_number(face, diagnostics).map(Asked::Face),
        };
        let Some(cells) = scene.cells_of(token, diagnostics) else {
            sound = false;
            continue;
        };
        match asked {
            None => sound = false,
            Some(Asked::Free) => free.push((cells, token)),
            Some(Asked::Face(face)) => {
                let told = row.token(1).unwrap_or(token);
                with_face(&cells, face, told, scene, diagnostics).for_each(|f| faces.push((f, told)));
            }
        }
    }
    if !sound {
        return None;
    }
    let mesh = &scene.structure.mesh;
    let of_free = free.iter().flat_map(|(cells, _)| cells.iter().flat_map(|&cell| all_faces(scene, cell)));
    let shared = Shared::of(mesh, faces.iter().map(|(face, _)| *face).chain(of_free));
    let inside = faces.iter().filter(|(face, _)| !shared.is_free(*face)).count();
    if let Some((face, at)) = faces.iter().find(|(face, _)| !shared.is_free(*face)) {
        let label = scene.cell_name(face.cell);
        let title = format!("{inside} faces of surface `{name}` lie between two elements");
        diagnostics
            .push(Diagnostic::warning(at.span, title).label(format!("first: S{} of element {label}", face.face + 1)));
    }
    for (cells, token) in &free {
        let outer = cells.iter().flat_map(|&cell| all_faces(scene, cell)).filter(|face| shared.is_free(*face));
        faces.extend(outer.map(|face| (face, *token)));
    }
    Some(faces.into_iter().map(|(face, _)| face).collect())
}

/// Faces in ascending order, each once; none at all is a fault.
fn finish(entry: &Entry<'_>, name: &str, mut faces: Vec<Face>, diagnostics: &mut Diagnostics) -> Option<Vec<Face>> {
    let listed = faces.len();
    faces.sort_unstable();
    faces.dedup();
    if faces.is_empty() {
        diagnostics.push(Diagnostic::error(entry.card.span, format!("surface `{name}` has no faces")));
        return None;
    }
    if faces.len() < listed {
        let title = format!("{} faces of surface `{name}` are listed twice", listed - faces.len());
        diagnostics.push(Diagnostic::warning(entry.card.span, title).label("each counts once"));
    }
    Some(faces)
}

fn all_faces<'s>(scene: &'s Scene<'_>, cell: CellId) -> impl Iterator<Item = Face> + use<'s> {
    let count = scene.structure.mesh.kind(cell).faces().len();
    (0..count).map(move |face| Face { cell, face: face as u8 })
}

/// The same face of some elements; elements that lack it are told.
fn with_face<'s>(
    cells: &'s [CellId],
    face: u8,
    told: Token<'_>,
    scene: &'s Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> impl Iterator<Item = Face> + use<'s> {
    let has = move |cell: &CellId| (face as usize) < scene.structure.mesh.kind(*cell).faces().len();
    if let Some(&cell) = cells.iter().find(|cell| !has(cell)) {
        let (element, label) = (scene.element_of(cell), scene.cell_name(cell));
        let count = element.kind().faces().len();
        let title = format!("element {label} has no face `{}`", told.text);
        let fault = Diagnostic::error(told.span, title);
        diagnostics.push(fault.label(format!("{} has S1 to S{count}", element.name())));
    }
    cells.iter().filter(move |cell| has(cell)).map(move |&cell| Face { cell, face })
}

/// `S1` to `S6`; other identifiers are told.
fn face_number(token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<u8> {
    let word = token.text.to_ascii_uppercase();
    match word.strip_prefix('S').and_then(|n| n.parse::<u8>().ok()) {
        Some(n @ 1..=6) => return Some(n - 1),
        _ if matches!(word.as_str(), "SPOS" | "SNEG" | "EDGE" | "END1" | "END2" | "E1" | "E2" | "E3" | "E4") => {
            let fault = Diagnostic::error(token.span, format!("face `{word}` is not there yet"));
            diagnostics.push(fault.label("shells, beams and edges are not there; solids have S1 to S6"));
        }
        _ => {
            let fault = Diagnostic::error(token.span, format!("there is no face `{word}`"));
            diagnostics.push(fault.label("faces are S1 to S6, or blank for the free ones"));
        }
    }
    None
}

/// Nodes, each with its area [L²] where one is given.
fn nodes(
    entry: &Entry<'_>,
    name: &str,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Vec<(u32, Option<f64>)>> {
    let mut nodes: Vec<(u32, Option<f64>)> = Vec::new();
    let before = diagnostics.faults();
    for line in scene.deck.lines(entry.card) {
        let row = Row::read(line, line_fields(entry, 1), diagnostics);
        let (Some(token), true) = (row.token(0), row.sound) else { continue };
        let members = scene.nodes_of(token, diagnostics).unwrap_or_default();
        nodes.extend(members.into_iter().map(|node| (node, row.number(1))));
    }
    let listed = nodes.len();
    nodes.sort_by_key(|(node, _)| *node);
    nodes.dedup_by_key(|(node, _)| *node);
    if nodes.is_empty() {
        // An empty or a missing set was told already.
        if diagnostics.faults() == before {
            diagnostics.push(Diagnostic::error(entry.card.span, format!("surface `{name}` has no nodes")));
        }
        return None;
    } else if nodes.len() < listed {
        let title = format!("{} nodes of surface `{name}` are listed twice", listed - nodes.len());
        diagnostics.push(Diagnostic::warning(entry.card.span, title).label("each counts once, with its first area"));
    }
    Some(nodes)
}
