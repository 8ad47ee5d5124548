//! `*RIGID BODY`.

use super::scene::{Scene, Surface};
use crate::deck::card::{Token, Value, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::RigidBody;
use fe_core::element::Family;
use fe_mesh::CellId;
use std::collections::BTreeMap;

/// Reads a body.
pub fn read(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let (surface, elset) = (entry.value("ANALYTICAL SURFACE"), entry.value("ELSET"));
    if surface.is_none() && elset.is_none() {
        let fault = Diagnostic::error(entry.card.span, "this rigid body is made of nothing");
        diagnostics.push(fault.help("say `ANALYTICAL SURFACE=…`, or `ELSET=…` for facets of explicit steps"));
    }
    let before = diagnostics.faults();
    let name = surface.and_then(|surface| analytical(surface, scene, diagnostics));
    let cells = elset.map_or(Vec::new(), |elset| facets(elset, scene, diagnostics));
    let Some(node) = entry.value("REF NODE") else { return };
    let token = Token { text: &node.text, span: node.span };
    let Some(nodes) = scene.nodes_of(token, diagnostics) else { return };
    let [reference] = nodes[..] else {
        let title = format!("a rigid body has one reference node, not {}", nodes.len());
        diagnostics.push(Diagnostic::error(node.span, title));
        return;
    };
    if diagnostics.faults() > before || (name.is_none() && cells.is_empty()) {
        return;
    }
    let at = surface.or(elset).map_or(entry.card.span, |value| value.span);
    scene.rigid_bodies.push((RigidBody { reference, cells, surface: name }, at));
}

/// Name of an analytical surface; one that is none, or is taken, is told.
fn analytical(surface: &Value, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<String> {
    let name = scene.full_name(&surface.text);
    match scene.surfaces.get(&name) {
        Some((Surface::Rigid(_) | Surface::Faulty, _)) => {}
        Some(_) => {
            let title = format!("surface `{}` is not an analytical one", normalized(&surface.text));
            diagnostics.push(Diagnostic::error(surface.span, title));
            return None;
        }
        None => {
            let rigid = scene.surfaces.iter().filter(|(_, (s, _))| matches!(s, Surface::Rigid(_)));
            let token = Token { text: &surface.text, span: surface.span };
            diagnostics.push(scene.unknown("surface", token, rigid.map(|(name, _)| name.as_str())));
            return None;
        }
    }
    if scene.reference_of(&name).is_some() {
        let title = format!("surface `{}` has a reference node already", normalized(&surface.text));
        diagnostics.push(Diagnostic::error(surface.span, title));
    }
    Some(name)
}

/// The facets of a set, ascending; elements that are none are told.
fn facets(elset: &Value, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Vec<CellId> {
    let token = Token { text: &elset.text, span: elset.span };
    let mut cells = scene.cell_set(token, diagnostics).unwrap_or_default().to_vec();
    cells.sort_unstable();
    cells.dedup();
    let soft = cells.iter().find(|cell| scene.element_of(**cell).family() != Family::Rigid);
    if let Some(&cell) = soft {
        let (label, element) = (scene.cell_name(cell), scene.element_of(cell).name());
        let title = format!("element {label} ({element}) is no facet of a rigid body");
        let fault = Diagnostic::error(elset.span, title);
        diagnostics.push(fault.help("rigid bodies are made of R2D2, R3D3 and R3D4 elements; others are not there yet"));
    }
    cells
}

/// Every facet belongs to one body, and its nodes to nothing else: what does not is told.
pub fn all_in_one(scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let mut of: BTreeMap<CellId, usize> = BTreeMap::new();
    for (number, (body, at)) in scene.rigid_bodies.iter().enumerate() {
        let twice = body.cells.iter().find_map(|cell| of.insert(*cell, number).map(|other| (*cell, other)));
        if let Some((cell, other)) = twice {
            let fault = Diagnostic::error(*at, format!("element {} is in two rigid bodies", scene.cell_name(cell)));
            diagnostics.push(fault.related(scene.rigid_bodies[other].1, "the other one"));
        }
    }
    let mesh = &scene.structure.mesh;
    let rigid = |cell: &CellId| scene.element_of(*cell).family() == Family::Rigid;
    let alone = mesh.cells().filter(rigid).find(|cell| !of.contains_key(cell));
    if let Some(cell) = alone.filter(|_| !scene.incomplete && diagnostics.faults() == 0)
        && let Some(at) = scene.place_of(cell)
    {
        let (label, element) = (scene.cell_name(cell), scene.element_of(cell).name());
        let fault = Diagnostic::error(at, format!("element {label} ({element}) belongs to no rigid body"));
        diagnostics.push(fault.help("say `*RIGID BODY, ELSET=…, REF NODE=…`"));
    }
    let mut owner: BTreeMap<u32, usize> = BTreeMap::new();
    for (cell, &number) in &of {
        for &node in mesh.cell(*cell) {
            let other = *owner.entry(node).or_insert(number);
            if other != number {
                let title = format!("node {} belongs to two rigid bodies", scene.node_name(node));
                let fault = Diagnostic::error(scene.rigid_bodies[number].1, title);
                diagnostics.push(fault.related(scene.rigid_bodies[other].1, "the other one"));
                return;
            }
        }
    }
    let masks = scene.structure.masks();
    let shared = |(node, number): &(&u32, &usize)| {
        masks[**node as usize] != 0 && scene.rigid_bodies[**number].0.reference != **node
    };
    if let Some((&node, &number)) = owner.iter().find(shared) {
        let title = format!("node {} belongs to a rigid facet and to other elements", scene.node_name(node));
        let fault = Diagnostic::error(scene.node_places[node as usize], title);
        let fault = fault.label("it would have to move with both").related(scene.rigid_bodies[number].1, "the body");
        diagnostics.push(fault.help("give the facet nodes of its own; masses belong to the reference node"));
    }
}
