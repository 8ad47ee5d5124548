//! Cards to a model: names to indices, ranges checked. All faults of a deck are told in one run.

mod amplitudes;
mod asked;
mod beams;
mod change_friction;
mod clearances;
mod combine;
mod conditions;
mod contact_controls;
mod contact_damping;
mod contact_elements;
mod controls;
mod cracks;
mod discrete;
mod elements;
mod explicit_pairs;
mod faces;
mod formula;
mod friction;
mod general_contact;
mod hard;
mod histories;
mod interactions;
mod interferences;
mod labels;
mod lines;
mod loads;
mod mass_scaling;
mod materials;
mod mesh_file;
mod motion;
mod names;
mod nodes;
mod once;
mod pairs;
mod parts;
mod procedures;
mod quality;
mod requests;
mod rigid;
mod rigid_bodies;
mod scene;
mod sections;
mod sets;
mod steps;
mod supports;
mod surfaces;
mod tubes;
mod velocities;
mod which_pair;

use crate::deck::Deck;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics, Severity};
use crate::keyword::check::{Entry, check};
use crate::model::{Model, Step};
use amplitudes::Amplitudes;
use fe_contact::law::Laws;
use fe_contact::search::Bounds;
use fe_core::structure::Structure;
use interactions::{Given, Interactions};
use scene::{Analysis, Scene};
use std::sync::Arc;
use steps::{InForce, Named};
use supports::Supports;
use tubes::Tubes;

/// What decks may name beyond the cards.
#[derive(Clone, Debug)]
pub struct Library {
    /// Pressure-overclosure laws.
    pub laws: Laws,
}

impl Default for Library {
    fn default() -> Self {
        Library { laws: Laws::standard() }
    }
}

/// The model that a deck describes, or all that is wrong with the deck. Warnings become notes of the model.
pub fn resolve(deck: &Deck, library: &Library) -> Result<Model, Diagnostics> {
    let mut diagnostics = Diagnostics::new(deck.sources.clone());
    let written = check(deck, &library.laws, &mut diagnostics);
    let mut scene = Scene::new(deck);
    scene.analysis = procedures::analysis(&written);
    let entries = parts::placed(&written, &mut scene, &mut diagnostics);
    let mut tubes = Tubes::default();
    bodies(&entries, (&mut scene, &mut tubes), &mut diagnostics);
    let amplitudes = Amplitudes::read(&named(&entries, &["AMPLITUDE"]), deck, &mut diagnostics);
    // How surfaces act on each other belongs to the model wherever it is written: once, whatever a part's instances.
    let mut contact = named(
        &written,
        &["SURFACE INTERACTION", "GAP", "INTERFACE", "SURFACE BEHAVIOR", "FRICTION", "CONTACT DAMPING"],
    );
    // The friction of a static step belongs to its `*CHANGE FRICTION`.
    let explicit = scene.analysis == Analysis::Explicit;
    contact.retain(|entry| explicit || entry.step.is_none() || entry.keyword.name != "FRICTION");
    let given = Given { deck, laws: &library.laws, size: size(&scene.structure), analysis: scene.analysis };
    let mut interactions = Interactions::read(&contact, given, &mut diagnostics);
    if scene.unread {
        return Err(diagnostics);
    }
    let mut contact_pairs = Vec::new();
    for entry in named(&entries, &["CONTACT PAIR"]).iter().filter(|entry| !explicit || entry.step.is_none()) {
        if explicit {
            let fault = Diagnostic::error(entry.card.span, "in explicit dynamics a contact pair belongs into a step");
            diagnostics
                .push(fault.help("write it after the `*DYNAMIC, EXPLICIT` of the first step: it holds from there"));
            continue;
        }
        pairs::read(entry, &scene, &interactions, &mut contact_pairs, &mut diagnostics);
    }
    let mut gaps = Vec::new();
    each(&entries, &["GAP"], &mut scene, |entry, scene| {
        gaps.extend(contact_elements::gaps(entry, scene, &interactions, &mut diagnostics));
    });
    each(&entries, &["CLEARANCE"], &mut scene, |entry, scene| {
        clearances::read(entry, scene, &mut contact_pairs, &mut diagnostics);
    });
    each(&entries, &["INTERFACE"], &mut scene, |entry, scene| {
        tubes.elements(entry, scene, &interactions, &mut diagnostics);
    });
    let mut supports = Supports::default();
    for entry in entries.iter().filter(|entry| entry.step.is_none() && entry.keyword.name == "BOUNDARY") {
        supports.read(entry, &scene, &amplitudes, &mut diagnostics);
    }
    let mut velocities = velocities::InitialVelocities::default();
    each(&entries, &["INITIAL CONDITIONS"], &mut scene, |entry, scene| {
        velocities.read(entry, scene, &mut diagnostics);
    });
    let of_gaps = gaps.iter().map(|(gaps, _)| (gaps.name.as_str(), gaps.interaction));
    let of_tubes = tubes.list.iter().map(|(tubes, _)| (tubes.name.as_str(), tubes.interaction));
    let elements = of_gaps.chain(of_tubes).collect();
    let names = Named { amplitudes: &amplitudes, interactions: &interactions, pairs: &contact_pairs, elements };
    let (steps, in_force) = steps(&entries, &names, &mut scene, &mut diagnostics);
    in_force.conditions.frictions.begin_job(&mut interactions);
    if diagnostics.faults() == 0 {
        quality::twins(&scene, &mut diagnostics);
        if steps.iter().all(|step| step.general_contact.is_none()) {
            let explicit = in_force.explicit_pairs.list.iter().map(|(pair, _)| (&pair.secondary, &pair.main));
            let pairs = contact_pairs.iter().map(|(pair, _)| (&pair.secondary, &pair.main)).chain(explicit).collect();
            cracks::tell(&scene, pairs, &tubes.list, &mut diagnostics);
        }
        quality::elements(&scene, &mut diagnostics);
        quality::members(&scene, &mut diagnostics);
    }
    if diagnostics.faults() > 0 {
        return Err(diagnostics);
    }
    Ok(Model {
        heading: heading(&entries, deck),
        structure: Arc::new(scene.structure),
        amplitudes: amplitudes.list,
        interactions: interactions.list,
        pairs: contact_pairs,
        explicit_pairs: in_force.explicit_pairs.list,
        gaps,
        tubes: tubes.list,
        rigid_bodies: scene.rigid_bodies.into_iter().map(|(body, _)| body).collect(),
        supports: supports.items,
        initial_velocities: velocities.items,
        steps,
        notes: notes(&diagnostics),
    })
}

/// Diagonal [L] of the box around all nodes; 1 where they are in one place.
fn size(structure: &Structure) -> f64 {
    let boxes = structure.mesh.points.iter().map(|&point| Bounds::around(&[point.into()], 0.0));
    let diagonal = boxes.reduce(|a, b| a.union(&b)).map_or(0.0, |all| all.diagonal());
    if diagonal > 0.0 && diagonal.is_finite() { diagonal } else { 1.0 }
}

/// Cards of some names, those of steps included.
fn named<'a>(entries: &[Entry<'a>], names: &[&str]) -> Vec<Entry<'a>> {
    entries.iter().filter(|entry| names.contains(&entry.keyword.name)).copied().collect()
}

/// Reads the cards of some names in order, each with the labels and names of the instance that it stands in.
fn each<'a>(
    entries: &[Entry<'a>],
    names: &[&str],
    scene: &mut Scene<'a>,
    mut read: impl FnMut(&Entry<'a>, &mut Scene<'a>),
) {
    for entry in entries.iter().filter(|entry| names.contains(&entry.keyword.name)) {
        scene.enter(entry);
        read(entry, scene);
    }
    scene.leave();
}

/// Nodes, elements, sets, surfaces, materials, sections.
fn bodies<'a>(entries: &[Entry<'a>], (scene, tubes): (&mut Scene<'a>, &mut Tubes), diagnostics: &mut Diagnostics) {
    if scene.unread {
        return;
    }
    let before = diagnostics.faults();
    each(entries, &["NODE", "MESH"], scene, |entry, scene| match entry.keyword.name {
        "NODE" => nodes::read(entry, scene, diagnostics),
        _ => mesh_file::read(entry, scene, diagnostics),
    });
    if scene.unread {
        return;
    }
    each(entries, &["ELEMENT"], scene, |entry, scene| elements::read(entry, scene, diagnostics));
    scene.incomplete = diagnostics.faults() > before;
    each(entries, &["NSET", "ELSET"], scene, |entry, scene| match entry.keyword.name {
        "NSET" => sets::nodes(entry, scene, diagnostics),
        _ => sets::cells(entry, scene, diagnostics),
    });
    sets::sort(scene);
    if scene.cells.is_empty() && diagnostics.faults() == 0 {
        let fault = Diagnostic::error(START, "the deck has no elements");
        diagnostics.push(fault.help("write `*ELEMENT`, or read a mesh by `*MESH`"));
    }
    quality::spaces(scene, diagnostics);
    each(entries, &["SURFACE"], scene, |entry, scene| surfaces::read(entry, scene, diagnostics));
    each(entries, &["RIGID BODY"], scene, |entry, scene| rigid_bodies::read(entry, scene, diagnostics));
    rigid_bodies::all_in_one(scene, diagnostics);
    each(entries, &["SECTION CONTROLS"], scene, |entry, scene| sections::controls(entry, scene, diagnostics));
    let materials = materials::read(&named(entries, materials::CARDS), scene, diagnostics);
    let before = diagnostics.faults();
    let cards = sections::CARDS.iter().map(|(name, _)| *name).collect::<Vec<_>>();
    sections::read(&named(entries, &cards), &materials, scene, diagnostics);
    // Springs give their nodes freedoms by their sections.
    scene.incomplete |= diagnostics.faults() > before && !scene.structure.discrete.is_empty();
    each(entries, &["SLIDE LINE"], scene, |entry, scene| tubes.line(entry, scene, diagnostics));
    scene.structure.slide_nodes = tubes.nodes();
    quality::freedoms(scene, diagnostics);
}

/// Places of what a deck lacks.
const START: Span = Span { source: 0, start: 0, end: 0 };
const END: Span = Span { source: 0, start: u32::MAX, end: u32::MAX };

/// All steps, and what they make of friction.
fn steps(
    entries: &[Entry<'_>],
    names: &Named<'_>,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> (Vec<Step>, InForce) {
    let mut in_force = InForce::default();
    let mut steps = Vec::new();
    let general = |entry: &&Entry<'_>| entry.step.is_none() && general_contact::CARDS.contains(&entry.keyword.name);
    for entry in entries.iter().filter(general) {
        in_force.general_contact.read(entry, scene, names.interactions, diagnostics);
    }
    let of_steps: Vec<Entry<'_>> = entries.iter().filter(|entry| entry.step.is_some()).copied().collect();
    for step in of_steps.chunk_by(|a, b| a.step == b.step) {
        steps.extend(steps::read(step, names, &mut in_force, scene, diagnostics));
    }
    if of_steps.is_empty() {
        let fault = Diagnostic::error(END, "the deck has no step");
        diagnostics.push(fault.help("write `*STEP`, `*STATIC`, loads and requests, `*END STEP`"));
    }
    (steps, in_force)
}

fn heading(entries: &[Entry<'_>], deck: &Deck) -> String {
    let cards = entries.iter().filter(|entry| entry.keyword.name == "HEADING");
    let lines: Vec<&str> = cards.flat_map(|entry| deck.lines(entry.card)).map(|line| line.text).collect();
    lines.join("\n")
}

/// Warnings and remarks, a line each.
fn notes(diagnostics: &Diagnostics) -> Vec<String> {
    let remarks = diagnostics.list().filter(|diagnostic| diagnostic.severity != Severity::Error);
    remarks.map(|diagnostic| diagnostics.line(diagnostic)).collect()
}
