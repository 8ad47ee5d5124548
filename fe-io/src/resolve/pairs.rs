//! `*CONTACT PAIR`.

use super::interactions::Interactions;
use super::lines::{at_least_one, fields};
use super::once;
use super::procedures::only_for;
use super::scene::{Analysis, Scene, Surface};
use crate::deck::card::{Token, normalized};
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::model::Place;
use fe_contact::pair::{Adjust, Bond, Discretization, PairDefinition};
use fe_contact::surface::{Main, Secondary};
use fe_mesh::{CellKind, Face};

/// Reads the pairs of a card, a line each.
pub fn read(
    entry: &Entry<'_>,
    scene: &Scene<'_>,
    interactions: &Interactions,
    pairs: &mut Vec<(PairDefinition, Place)>,
    diagnostics: &mut Diagnostics,
) {
    only_for(entry, &["CPSET", "MECHANICAL CONSTRAINT", "OP", "WEIGHT"], Analysis::Explicit, diagnostics);
    if !entry.has("INTERACTION") {
        let fault = Diagnostic::error(entry.card.span, "`*CONTACT PAIR` needs `INTERACTION=`");
        diagnostics.push(fault.label("the *SURFACE INTERACTION"));
    }
    let interaction = interactions.of_parameter(entry, diagnostics);
    let bond = bond(entry, diagnostics);
    let lines = at_least_one(
        scene.deck.lines(entry.card),
        entry,
        ("this card names no surfaces", "add a line: secondary surface, main surface"),
        diagnostics,
    );
    for line in lines {
        let row = Row::read(line, fields(entry), diagnostics);
        let (Some(first), Some(second), true) = (row.token(0), row.token(1), row.sound) else { continue };
        let before = diagnostics.faults();
        let secondary = secondary(first, scene, diagnostics);
        let main = main(second, scene, diagnostics);
        let (Some(secondary), Some(main)) = (secondary, main) else { continue };
        let discretization = discretization(entry, first, &secondary, &main, scene, diagnostics);
        common_nodes(second, &secondary, &main, scene, diagnostics);
        let adjust = adjust(entry, &secondary, scene, diagnostics);
        let (Some(interaction), true) = (interaction, diagnostics.faults() == before) else { continue };
        let [secondary_name, main_name] = [first, second].map(|token| scene.full_name(token.text));
        let twin = pairs.iter().find(|(p, _)| p.secondary_name == secondary_name && p.main_name == main_name);
        if let Some((_, Place { file, line: number })) = twin {
            let fault = Diagnostic::error(line.span, "these surfaces are a contact pair already");
            diagnostics.push(fault.help(format!("the first one is at {file}:{number}; both would press")));
            continue;
        }
        let source = &scene.deck.sources[line.span.source as usize];
        let place = source.place(line.span.start);
        let small_sliding = entry.has("SMALL SLIDING");
        let pair = PairDefinition {
            secondary_name,
            main_name,
            secondary,
            main,
            interaction,
            discretization,
            small_sliding,
            bond,
            adjust,
            clearance: None,
        };
        pairs.extend(once::only_new(pair, pairs, line.span, diagnostics).map(|pair| (pair, place)));
    }
}

fn bond(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Bond {
    let Some(tied) = entry.parameter("TIED") else { return Bond::Contact };
    if !entry.has("ADJUST") {
        let fault = Diagnostic::error(tied.span, "`TIED` of `*CONTACT PAIR` needs `ADJUST`");
        diagnostics
            .push(fault.help("say which nodes are moved onto the main surface and tied: a distance, or a node set"));
    }
    Bond::Tied
}

/// A surface by name; a missing one is told.
fn surface<'s>(token: Token<'_>, scene: &'s Scene<'_>, diagnostics: &mut Diagnostics) -> Option<&'s Surface> {
    match scene.surfaces.get(&scene.full_name(token.text)) {
        Some((Surface::Faulty, _)) => None,
        Some((surface, _)) => Some(surface),
        None => {
            diagnostics.push(scene.unknown("surface", token, scene.surfaces.keys().map(String::as_str)));
            None
        }
    }
}

/// Faces of an element-based surface of the mesh.
pub fn faces_of(token: Token<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<Face>> {
    let name = scene.full_name(token.text);
    match surface(token, scene, diagnostics)? {
        Surface::Faces => scene.structure.mesh.surfaces.get(&name).cloned(),
        Surface::Nodes(_) | Surface::Lines(_) | Surface::Rigid(_) | Surface::Faulty => {
            diagnostics.push(Diagnostic::error(token.span, format!("surface `{name}` has no faces of elements")));
            None
        }
    }
}

pub fn secondary(token: Token<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Secondary> {
    match surface(token, scene, diagnostics)? {
        Surface::Faces => faces_of(token, scene, diagnostics).map(Secondary::Faces),
        Surface::Nodes(nodes) => Some(Secondary::Nodes(nodes.clone())),
        Surface::Lines(cells) => Some(Secondary::Lines(cells.clone())),
        Surface::Rigid(_) | Surface::Faulty => {
            let title = format!("the rigid surface `{}` can only be the main one", normalized(token.text));
            diagnostics.push(Diagnostic::error(token.span, title).help("write: secondary, main"));
            None
        }
    }
}

pub fn main(token: Token<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Main> {
    let name = scene.full_name(token.text);
    match surface(token, scene, diagnostics)? {
        Surface::Faces => faces_of(token, scene, diagnostics).map(Main::Faces),
        Surface::Rigid(rigid) => {
            let Some(reference) = scene.reference_of(&name) else {
                let fault = Diagnostic::error(token.span, format!("the rigid surface `{name}` has no reference node"));
                diagnostics.push(fault.help(format!("say `*RIGID BODY, ANALYTICAL SURFACE={name}, REF NODE=…`")));
                return None;
            };
            Some(Main::Rigid { surface: rigid.clone(), reference })
        }
        Surface::Lines(_) => {
            let title = format!("the surface `{name}` of lines in space can only be the secondary one");
            let fault = Diagnostic::error(token.span, title).label("it has no unique normal");
            diagnostics.push(fault.help("write: secondary, main"));
            None
        }
        Surface::Nodes(_) | Surface::Faulty => {
            let fault =
                Diagnostic::error(token.span, format!("the surface of nodes `{name}` can only be the secondary one"));
            diagnostics.push(fault.help("write: secondary, main"));
            None
        }
    }
}

fn discretization(
    entry: &Entry<'_>,
    at: Token<'_>,
    secondary: &Secondary,
    main: &Main,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Discretization {
    let wanted = entry.says("TYPE", "SURFACE TO SURFACE");
    let without_faces = match secondary {
        Secondary::Faces(_) => None,
        Secondary::Nodes(_) => Some("nodes"),
        Secondary::Lines(_) => Some("lines"),
    };
    if let (true, Some(what)) = (wanted, without_faces) {
        let note = Diagnostic::note(at.span, format!("a surface of {what} makes the pair node-to-surface"));
        diagnostics.push(note.label("it has no faces to average over"));
    } else if wanted {
        return Discretization::SurfaceToSurface;
    }
    let mesh = &scene.structure.mesh;
    let curved = |face: &Face| matches!(mesh.face(*face).0, CellKind::Line3 | CellKind::Tri6 | CellKind::Quad8);
    let sides = [
        if let Secondary::Faces(faces) = secondary { faces.as_slice() } else { &[] },
        if let Main::Faces(faces) = main { faces.as_slice() } else { &[] },
    ];
    if let Some(face) = sides.into_iter().flatten().find(|face| curved(face)) {
        let title = "node-to-surface contact of quadratic faces is not there";
        let fault = Diagnostic::error(at.span, title);
        let element = scene.element_of(face.cell).name();
        let fault = fault.label(format!("element {} is a {element}", scene.cell_name(face.cell)));
        diagnostics.push(
            fault.help("say `TYPE=SURFACE TO SURFACE`: corner nodes of quadratic faces carry no pressure of their own"),
        );
    }
    Discretization::NodeToSurface
}

/// Nodes of a side, marked.
fn marked(scene: &Scene<'_>, faces: &[Face]) -> Vec<bool> {
    let mut marks = vec![false; scene.structure.mesh.points.len()];
    for &face in faces {
        scene.structure.mesh.face(face).1.iter().for_each(|&node| marks[node as usize] = true);
    }
    marks
}

pub fn common_nodes(
    at: Token<'_>,
    secondary: &Secondary,
    main: &Main,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) {
    let Main::Faces(faces) = main else { return };
    let marks = marked(scene, faces);
    let common = secondary.nodes(&scene.structure.mesh).into_iter().find(|&node| marks[node as usize]);
    if let Some(node) = common {
        let title = format!("both surfaces of this pair hold node {}", scene.node_name(node));
        diagnostics.push(
            Diagnostic::error(at.span, title)
                .help("surfaces of a pair have no common nodes; self-contact is not there yet"),
        );
    }
}

fn adjust(
    entry: &Entry<'_>,
    secondary: &Secondary,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Adjust> {
    let value = entry.value("ADJUST")?;
    match number(&value.text) {
        Some(depth) if depth >= 0.0 => return Some(Adjust::Within(depth)),
        Some(_) => {
            diagnostics.push(Diagnostic::error(value.span, "`ADJUST` of `*CONTACT PAIR` must be ≥ 0, or a node set"));
            return None;
        }
        None => {}
    }
    let token = Token { text: &value.text, span: value.span };
    let nodes = scene.nodes_of(token, diagnostics)?;
    let own = secondary.nodes(&scene.structure.mesh);
    let on_surface: Vec<u32> = nodes.into_iter().filter(|node| own.binary_search(node).is_ok()).collect();
    if on_surface.is_empty() {
        let title = format!("no node of set `{}` is on the secondary surface", normalized(&value.text));
        diagnostics.push(Diagnostic::error(value.span, title));
    }
    Some(Adjust::Nodes(on_surface))
}
