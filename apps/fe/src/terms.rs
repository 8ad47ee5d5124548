//! From a model to the terms that are assembled.

use fe_contact::Contact;
use fe_contact::adjust::{Moved, adjust};
use fe_contact::conditions::{Activity, Conditions};
use fe_contact::friction::slip;
use fe_contact::pair::PairDefinition;
use fe_contact::state::ContactState;
use fe_core::Freedoms;
use fe_core::bodies::{Body, bodies};
use fe_core::element::Family;
use fe_core::member::{BadMember, Members};
use fe_core::procedure::Converged;
use fe_core::ramp::Ramp;
use fe_core::solid::SolidBlock;
use fe_core::structure::{LineSection, Structure};
use fe_core::term::Term;
use fe_io::Model;
use fe_io::model::Step;
use fe_mesh::CellId;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

/// The terms of a job, and the structure they act on.
pub struct Terms {
    /// Bodies as they are after strain-free adjustment: the model's own where nothing was moved.
    pub structure: Arc<Structure>,
    /// Freedoms of all nodes.
    pub freedoms: Freedoms,
    /// One block for each section.
    pub solids: Vec<SolidBlock>,
    /// Trusses and beams, one for each section, then springs.
    pub members: Vec<Members>,
    /// Contact pairs, then gap and tube elements, each in the deck's order.
    pub contacts: Vec<Contact>,
    /// Connected bodies.
    pub bodies: Vec<Body>,
    /// What slip tolerances are parts of, where there is friction.
    slip: Option<slip::Reference>,
    /// Remarks, a line each.
    pub notes: Vec<String>,
    /// Seconds for contact search and integration.
    pub search_seconds: f64,
}

impl Terms {
    /// Builds them; a fault is told with its place in the deck.
    pub fn new(model: &Model) -> Result<Self, String> {
        let start = Instant::now();
        let mut structure = Arc::clone(&model.structure);
        let mut notes = Vec::new();
        let place = |k: usize| format!("{}:{}", model.pairs[k].1.file, model.pairs[k].1.line);
        let definitions: Vec<PairDefinition> = model.pairs.iter().map(|(d, _)| d.clone()).collect();
        let moves = adjust(&structure, &definitions, &model.interactions).map_err(|e| e.to_string())?;
        notes.extend(adjustments(&moves, &definitions));
        if !moves.is_empty() {
            let points = &mut Arc::make_mut(&mut structure).mesh.points;
            moves.iter().for_each(|m| points[m.node as usize] = m.to);
        }
        let freedoms = structure.freedoms(&model.references());
        let mut interactions = model.interactions.clone();
        let rubs = interactions.iter().any(|interaction| interaction.friction.is_some());
        let slip = rubs.then(|| slip::Reference::of(&structure, &definitions));
        stabilized_along(model).for_each(|interaction| interactions[interaction].stabilized_along = true);
        for interaction in &mut interactions {
            let whose = format!("interaction {}", interaction.name);
            let settled = slip.zip(interaction.friction.as_mut()).map(|(slip, friction)| slip.settle(friction, &whose));
            notes.extend(settled.flatten());
        }
        let mut contacts = Vec::new();
        for (k, (definition, _)) in model.pairs.iter().enumerate() {
            let interaction = &interactions[definition.interaction];
            let pair = Contact::of_pair(&structure, &freedoms, definition, interaction)
                .map_err(|e| format!("{}: {e}", place(k)))?;
            notes.extend(pair.notes().iter().map(|note| placed(note, &place(k))));
            contacts.push(pair);
        }
        for (definition, place) in &model.gaps {
            let interaction = &interactions[definition.interaction];
            let gaps = Contact::of_gaps((&structure, &freedoms), definition, interaction)
                .map_err(|e| format!("{}:{}: {e}", place.file, place.line))?;
            notes.extend(gaps.notes().iter().cloned());
            contacts.push(gaps);
        }
        for (definition, place) in &model.tubes {
            let interaction = &interactions[definition.interaction];
            let at = format!("{}:{}", place.file, place.line);
            let tubes = Contact::of_tubes((&structure, &freedoms), definition, interaction);
            let tubes = tubes.map_err(|e| format!("{at}: {e}"))?;
            notes.extend(tubes.notes().iter().map(|note| placed(note, &at)));
            contacts.push(tubes);
        }
        let search_seconds = start.elapsed().as_secs_f64();
        let mut solids = Vec::new();
        for section in &structure.sections {
            solids.push(SolidBlock::new(&structure, section, &freedoms).map_err(|e| e.to_string())?);
        }
        let members = members(&structure, &freedoms).map_err(|e| e.to_string())?;
        let bodies = bodies(&structure, &model.references());
        notes.extend(thin_beams(&structure, &bodies));
        Ok(Terms { structure, freedoms, solids, members, contacts, bodies, slip, notes, search_seconds })
    }

    /// The state before the first step.
    pub fn rest(&self) -> Converged {
        let n = self.freedoms.len();
        let history = self.all().iter().map(|term| vec![0.0; term.history()]).collect();
        Converged { u: vec![0.0; n], residual: vec![0.0; n], external: vec![0.0; n], history, ..Converged::default() }
    }

    /// Enters a step: what it says of each contact holds from now on. The forces [F] of contacts that it removes come back,
    /// by freedom, as they act in the state `at`.
    pub fn enter(&mut self, step: &Step, at: &mut Converged) -> Vec<(usize, f64)> {
        let mut released = Vec::new();
        let histories = &mut at.history[self.solids.len() + self.members.len()..];
        for (k, (contact, history)) in self.contacts.iter_mut().zip(histories).enumerate() {
            let mut conditions = step.conditions.get(k).cloned().unwrap_or_default();
            if let (Some(change), Some(slip)) = (&mut conditions.friction, self.slip) {
                slip.settle(&mut change.to, contact.name());
            }
            if contact.acts() && conditions.activity == Activity::Removed {
                released.extend(contact.force(&at.u, history));
            }
            contact.enter(&conditions, (at.total_time, step.procedure.period()), &at.u, history);
        }
        released
    }

    /// Is told the freedoms that the step prescribes, and their courses.
    pub fn hold(&mut self, supports: &BTreeMap<usize, Ramp>) {
        self.contacts.iter_mut().for_each(|contact| contact.hold(supports));
    }

    /// All terms.
    pub fn all(&self) -> Vec<&dyn Term> {
        let solids = self.solids.iter().map(|block| block as &dyn Term);
        let members = self.members.iter().map(|members| members as &dyn Term);
        solids.chain(members).chain(self.contacts.iter().map(|pair| pair as &dyn Term)).collect()
    }

    /// The states of all pairs.
    pub fn states(&self, at: &Converged) -> Vec<ContactState> {
        let histories = &at.history[self.solids.len() + self.members.len()..];
        self.contacts.iter().zip(histories).map(|(pair, history)| pair.state(&at.u, history)).collect()
    }

    /// What the user may know a body by: the largest element set inside it, or one of its nodes.
    pub fn body_name(&self, body: &Body) -> String {
        let mesh = &self.structure.mesh;
        let inside = |n: &u32| body.nodes.binary_search(n).is_ok();
        let mut best: Option<(&String, usize)> = None;
        for (name, cells) in &mesh.cell_sets {
            let whole = !cells.is_empty() && cells.iter().all(|&c| mesh.cell(c).iter().all(inside));
            if whole && best.is_none_or(|(_, count)| cells.len() > count) {
                best = Some((name, cells.len()));
            }
        }
        match best {
            Some((name, _)) => format!("body {name}"),
            None => format!("the body of node {}", mesh.point_name(body.nodes[0])),
        }
    }
}

/// The interactions of contacts that some step stabilises along their surfaces.
fn stabilized_along(model: &Model) -> impl Iterator<Item = usize> {
    let pairs = model.pairs.iter().map(|(pair, _)| pair.interaction);
    let gaps = model.gaps.iter().map(|(gaps, _)| gaps.interaction);
    let of_contact: Vec<usize> =
        pairs.chain(gaps).chain(model.tubes.iter().map(|(tubes, _)| tubes.interaction)).collect();
    let along = |conditions: &Conditions| conditions.stabilization.is_some_and(|s| s.tangent_fraction > 0.0);
    let contacts = model.steps.iter().flat_map(move |step| {
        step.conditions.iter().enumerate().filter(move |(_, conditions)| along(conditions)).map(|(k, _)| k)
    });
    contacts.map(move |k| of_contact[k])
}

/// Relative error of deflections that is told.
const TOLD: f64 = 1e-6;

/// Beams so thin that rounding shows, a line for each section.
fn thin_beams(structure: &Structure, bodies: &[Body]) -> Vec<String> {
    let mesh = &structure.mesh;
    let told = |section: &LineSection| {
        let along = |cell: CellId| {
            let [p, q] = [0, 1].map(|i| mesh.points[mesh.cell(cell)[i] as usize]);
            let offset = [0, 1, 2].map(|c| q[c] - p[c]);
            (offset, offset.iter().map(|d| d * d).sum::<f64>().sqrt())
        };
        let first = *section.cells.first()?;
        let body = bodies.iter().find(|body| body.nodes.binary_search(&mesh.cell(first)[0]).is_ok())?;
        let length = 2.0 * body.size;
        let tangents = section.cells.iter().map(|&cell| {
            let (offset, element) = along(cell);
            offset.map(|d| d / element)
        });
        let rounding = section.rounding(tangents, length, length / along(first).1).filter(|part| *part > TOLD)?;
        let (name, of) = (section.element.name(), &section.name);
        Some(format!(
            "warning: {name} elements of {of} are so thin that rounding may cost {rounding:.0e} of their deflection; B23 and B33 along an axis lose nothing"
        ))
    };
    structure.lines.iter().filter_map(told).collect()
}

/// Trusses and beams, then springs. Dashpots and masses do nothing in a static step.
fn members(structure: &Structure, freedoms: &Freedoms) -> Result<Vec<Members>, BadMember> {
    let lines = structure.lines.iter().map(|section| Members::lines(structure, section, freedoms));
    let springs = structure.discrete.iter().filter(|section| section.element.family() == Family::Spring);
    lines.chain(springs.map(|section| Members::springs(structure, section, freedoms))).collect()
}

/// A warning with the line of the pair that it is about; remarks go as they are.
fn placed(note: &str, place: &str) -> String {
    if note.starts_with("warning: ") { format!("{place}: {note}") } else { note.to_owned() }
}

/// What `ADJUST` did, a line for each pair that it moved nodes of.
fn adjustments(moves: &[Moved], definitions: &[PairDefinition]) -> Vec<String> {
    let mut notes = Vec::new();
    for (k, pair) in definitions.iter().enumerate() {
        let gaps: Vec<f64> = moves.iter().filter(|m| m.pair == k).map(|m| m.gap.abs()).collect();
        if let Some(largest) = gaps.iter().copied().reduce(f64::max) {
            let (secondary, main, count) = (&pair.secondary_name, &pair.main_name, gaps.len());
            notes.push(format!(
                "ADJUST moved {count} nodes of {secondary} onto {main} without strain, by {largest:.6e} at most"
            ));
        }
    }
    notes
}
