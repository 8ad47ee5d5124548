//! `*SURFACE` of elements and of nodes.

use super::asked::{self, Asked};
use super::combine;
use super::faces::Shared;
use super::lines::line_fields;
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
        "" | "ELEMENT" => match entry.name("COMBINE") {
            Some(how) => {
                let faces = combine::faces(entry, &how, scene, diagnostics);
                let faces = faces.and_then(|faces| finish(entry, &written, faces, diagnostics));
                faces.map(|faces| in_mesh(&name, faces, scene))
            }
            None => elements(entry, (&written, &name), scene, diagnostics),
        },
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

/// What data lines name.
#[derive(Default)]
struct Listed<'a> {
    /// Faces, each with the word that names it.
    faces: Vec<(Face, Token<'a>)>,
    /// Solids of which the free faces are meant.
    free: Vec<CellId>,
    /// Trusses and beams in space.
    lines: Vec<CellId>,
}

/// A surface of elements: faces, or lines in space.
fn elements(
    entry: &Entry<'_>,
    (written, name): (&str, &str),
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Surface> {
    let Listed { mut faces, free, mut lines } = listed(entry, scene, diagnostics)?;
    if let (Some(&line), false) = (lines.first(), faces.is_empty() && free.is_empty()) {
        let title = format!("surface `{written}` has faces, and lines such as element {}", scene.cell_name(line));
        diagnostics.push(Diagnostic::error(entry.card.span, title).help("write two surfaces"));
        return None;
    }
    if !lines.is_empty() {
        lines.sort_unstable();
        lines.dedup();
        return Some(Surface::Lines(lines));
    }
    let of_free = free.iter().flat_map(|&cell| all_faces(scene, cell));
    let shared = Shared::of(&scene.structure.mesh, faces.iter().map(|(face, _)| *face).chain(of_free));
    let inside = faces.iter().filter(|(face, _)| !shared.is_free(*face)).count();
    if let Some((face, at)) = faces.iter().find(|(face, _)| !shared.is_free(*face)) {
        let label = scene.cell_name(face.cell);
        let title = format!("{inside} faces of surface `{written}` lie between two elements");
        diagnostics
            .push(Diagnostic::warning(at.span, title).label(format!("first: S{} of element {label}", face.face + 1)));
    }
    one_side(&mut faces, scene, diagnostics)?;
    let outer = free.iter().flat_map(|&cell| all_faces(scene, cell)).filter(|face| shared.is_free(*face));
    let faces = faces.iter().map(|(face, _)| *face).chain(outer).collect();
    finish(entry, written, faces, diagnostics).map(|faces| in_mesh(name, faces, scene))
}

/// What the data lines name, in their order; `None` when some line names nothing, which was told.
fn listed<'a>(entry: &Entry<'a>, scene: &Scene<'a>, diagnostics: &mut Diagnostics) -> Option<Listed<'a>> {
    let (mut listed, mut sound) = (Listed::default(), true);
    for line in scene.deck.lines(entry.card) {
        let row = Row::read(line, line_fields(entry, 0), diagnostics);
        let (Some(token), true) = (row.token(0), row.sound) else { continue };
        let asked = row.token(1).map_or(Some(Asked::Free), |face| asked::face(face, diagnostics));
        let (Some(cells), Some(asked)) = (scene.cells_of(token, diagnostics), asked) else {
            sound = false;
            continue;
        };
        let (count, told) = (cells.len(), row.token(1).unwrap_or(token));
        let cells = asked::with(cells, asked, told, scene, diagnostics);
        sound &= cells.len() == count;
        for cell in cells {
            match asked {
                Asked::Face(face) => listed.faces.push((Face { cell, face }, told)),
                Asked::Side(side) => listed.faces.push((Face { cell, face: first_side(cell, scene) + side }, told)),
                Asked::Free if asked::is_line(scene.element_of(cell)) => listed.lines.push(cell),
                Asked::Free => listed.free.push(cell),
            }
        }
    }
    sound.then_some(listed)
}

/// Number of the face SPOS of a line in the plane or a facet in space.
fn first_side(cell: CellId, scene: &Scene<'_>) -> u8 {
    let kind = scene.structure.mesh.kind(cell);
    if kind.sides().is_empty() { 0 } else { kind.faces().len() as u8 }
}

/// A line in the plane or a rigid facet may press with either side, not with both in one surface; `None` where it does, which is told.
fn one_side(faces: &mut [(Face, Token<'_>)], scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<()> {
    faces.sort_by_key(|(face, _)| *face);
    let thin = |cell: CellId| scene.structure.mesh.kind(cell).dimension() < scene.structure.dimension();
    let both =
        faces.windows(2).find(|two| two[0].0.cell == two[1].0.cell && two[0].0 != two[1].0 && thin(two[0].0.cell));
    let Some([_, (face, at)]) = both else { return Some(()) };
    let title = format!("this surface has both sides of element {}", scene.cell_name(face.cell));
    diagnostics.push(Diagnostic::error(at.span, title).help("write two surfaces, one of SPOS and one of SNEG"));
    None
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
