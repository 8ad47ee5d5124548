//! `*MESH`: the only place that knows of gmsh files.

use super::elements::{element_type, register, suits};
use super::lines::fields;
use super::nodes;
use super::scene::{Scene, Surface};
use crate::deck::bytes_of;
use crate::deck::card::{Token, normalized};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::element::ElementType;
use fe_mesh::gmsh::{self, GmshError, GmshMesh, Kept, Note};
use fe_mesh::{CellId, Face, Mesh};

/// Reads a mesh file into the scene.
pub fn read(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(input) = entry.value("INPUT") else { return };
    let path = scene.deck.folders[input.span.source as usize].join(&input.text);
    let bytes = match bytes_of(&path) {
        Ok(bytes) => bytes,
        Err(why) => {
            let title = format!("the mesh `{}` cannot be read: {why}", input.text);
            diagnostics.push(Diagnostic::error(input.span, title));
            scene.unread = true;
            return;
        }
    };
    let file = match gmsh::parse(&bytes) {
        Ok(file) => file,
        Err(GmshError { what, place, allowed }) => {
            let fault = Diagnostic::error(input.span, format!("the mesh `{}`, {place}: {what}", input.text));
            let allowed = allowed.map(|allowed| format!("allowed: {allowed}"));
            diagnostics.push(allowed.into_iter().fold(fault, Diagnostic::help));
            scene.unread = true;
            return;
        }
    };
    drop(bytes);
    let types = element_types(entry, &file, scene, diagnostics);
    let groups: Vec<usize> = types.iter().map(|(group, ..)| *group).collect();
    let names: Vec<(String, ElementType, Span)> =
        types.iter().map(|(group, element, at)| (file.groups[*group].set_name(), *element, *at)).collect();
    let (mesh, notes) = file.into_mesh(Kept::Groups(&groups));
    for note in notes {
        let severity = match note {
            Note::SharedFaces { .. } | Note::EmptyGroup { .. } => Diagnostic::warning(input.span, note.to_string()),
            Note::LooseFacets { .. } => Diagnostic::note(input.span, note.to_string()),
        };
        diagnostics.push(severity);
    }
    add(mesh, &names, input.span, scene, diagnostics);
}

/// The data lines: group, element type and place of each.
fn element_types(
    entry: &Entry<'_>,
    file: &GmshMesh,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<(usize, ElementType, Span)> {
    let mut types = Vec::new();
    for line in scene.deck.lines(entry.card) {
        let row = Row::read(line, fields(entry), diagnostics);
        let (Some(group), Some(word), true) = (row.token(0), row.token(1), row.sound) else { continue };
        let element = element_type(&normalized(word.text), word.span, diagnostics);
        element.into_iter().for_each(|element| suits(element, word.span, scene, diagnostics));
        let Some(element) = element else { continue };
        let found = file
            .groups_named(group.text)
            .into_iter()
            .find(|&g| file.groups[g].dimension == element.space().dimension());
        match found {
            Some(found) => types.push((found, element, group.span)),
            None => diagnostics.push(no_group(file, group, element)),
        }
    }
    if types.is_empty() && diagnostics.faults() == 0 {
        let fault = Diagnostic::error(entry.card.span, "this card names no elements of the mesh");
        diagnostics.push(fault.help("add a line for each group of elements: `physical name, element type`"));
    }
    types
}

fn no_group(file: &GmshMesh, group: Token<'_>, element: ElementType) -> Diagnostic {
    let dimension = element.space().dimension();
    let names: Vec<String> = file.groups.iter().filter(|g| g.dimension == dimension).map(|g| g.set_name()).collect();
    let kind = if dimension == 3 { "volumes" } else { "areas" };
    let title = format!("the mesh has no physical group `{}` of {kind}", normalized(group.text));
    Diagnostic::error(group.span, title).known(&normalized(group.text), names.iter().map(String::as_str))
}

/// Adds points, cells, sets and surfaces.
fn add(
    mesh: Mesh,
    types: &[(String, ElementType, Span)],
    at: Span,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) {
    let before = diagnostics.faults();
    let first = scene.node_places.len() as u32;
    for (point, label) in mesh.points.iter().zip(&mesh.point_labels) {
        nodes::add(scene, *label, at, *point, diagnostics);
    }
    if diagnostics.faults() > before {
        return;
    }
    let ids = cells(&mesh, types, first, at, scene, diagnostics);
    let moved = |cell: CellId| ids[cell.block as usize][cell.cell as usize];
    for (name, set) in mesh.node_sets {
        let name = scene.own_name(&name);
        scene.structure.mesh.node_sets.entry(name).or_default().extend(set.iter().map(|n| n + first));
    }
    for (name, set) in &mesh.cell_sets {
        let (name, set) = (scene.own_name(name), set.iter().filter_map(|&cell| moved(cell)));
        scene.structure.mesh.cell_sets.entry(name).or_default().extend(set);
    }
    for (name, faces) in mesh.surfaces {
        let name = scene.own_name(&name);
        let faces = faces.iter().filter_map(|f| Some(Face { cell: moved(f.cell)?, face: f.face })).collect();
        scene.surfaces.insert(name.clone(), (Surface::Faces, at));
        scene.structure.mesh.surfaces.insert(name, faces);
    }
}

/// Adds the cells; for each cell of the mesh, by block, the cell that it became.
fn cells(
    mesh: &Mesh,
    types: &[(String, ElementType, Span)],
    first: u32,
    at: Span,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<Vec<Option<CellId>>> {
    let mut ids: Vec<Vec<Option<CellId>>> = mesh.blocks.iter().map(|block| vec![None; block.len()]).collect();
    for (name, element, line) in types {
        let block = scene.block_of(*element);
        for &cell in mesh.cell_sets.get(name).map_or(&[][..], Vec::as_slice) {
            if ids[cell.block as usize][cell.cell as usize].is_some() {
                let title = format!("element {} of group `{name}` has a type already", mesh.cell_label(cell));
                diagnostics.push(Diagnostic::error(*line, title));
                continue;
            }
            if mesh.kind(cell) != element.kind() {
                let title = format!("group `{name}` holds cells of kind {:?}, not {}", mesh.kind(cell), element.name());
                diagnostics.push(Diagnostic::error(*line, title).help(fitting(mesh, cell)));
                break;
            }
            let nodes = mesh.cell(cell).iter().map(|n| n + first);
            scene.structure.mesh.blocks[block].nodes.extend(nodes);
            match register(scene, block, mesh.cell_label(cell), at, diagnostics) {
                Some(()) => ids[cell.block as usize][cell.cell as usize] = scene.cells.last().copied(),
                None => {
                    let keep = scene.structure.mesh.blocks[block].labels.len() * element.kind().nodes();
                    scene.structure.mesh.blocks[block].nodes.truncate(keep);
                }
            }
        }
    }
    ids
}

fn fitting(mesh: &Mesh, cell: CellId) -> String {
    let types = ElementType::ALL.into_iter().filter(|e| e.kind() == mesh.kind(cell)).map(ElementType::name);
    let types: Vec<&str> = types.collect();
    match types.as_slice() {
        [] => "there is no element type for these cells".to_owned(),
        types => format!("for these cells there is {}", crate::diagnostic::listed(types)),
    }
}
