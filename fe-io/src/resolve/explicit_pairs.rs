//! `*CONTACT PAIR` of explicit steps, and their `*CONTACT CONTROLS`.

use super::interactions::Interactions;
use super::lines::{at_least_one, fields};
use super::pairs::{common_nodes, main, secondary};
use super::procedures::only_for;
use super::scene::{Analysis, Scene};
use crate::deck::card::{Token, normalized};
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use crate::model::{ActivePair, Place};
use fe_contact::pair::{ExplicitPair, MechanicalConstraint, Sliding};
use fe_contact::surface::{Main, Secondary};
use fe_core::element::Family;
use fe_mesh::Face;

/// The pairs of all steps, and those in force.
#[derive(Debug, Default)]
pub struct ExplicitPairs {
    /// In the order of the deck.
    pub list: Vec<(ExplicitPair, Place)>,
    /// Those in force, ascending.
    active: Vec<Active>,
    /// Steps begun so far.
    steps: usize,
}

/// A pair in force.
#[derive(Clone, Debug)]
struct Active {
    pair: usize,
    /// Step that defined it, from 1.
    since: usize,
    /// Name of its interaction.
    interaction: Option<String>,
    scale_penalty: f64,
}

impl ExplicitPairs {
    /// A step begins.
    pub fn begin_step(&mut self) {
        self.steps += 1;
    }

    /// What holds after the cards of a step; interactions are those that the step finds under their names.
    pub fn in_force(&self, interactions: &Interactions) -> Vec<ActivePair> {
        let found = |name: &str| interactions.find_in(name, self.steps - 1);
        let active = self.active.iter().map(|active| ActivePair {
            pair: active.pair,
            interaction: active.interaction.as_deref().and_then(found),
            scale_penalty: active.scale_penalty,
        });
        active.collect()
    }

    /// Names of the secondary and the main surface of each pair so far.
    pub fn names(&self) -> Vec<[String; 2]> {
        self.list.iter().map(|(pair, _)| [pair.secondary_name.clone(), pair.main_name.clone()]).collect()
    }

    /// Reads a `*CONTACT PAIR`.
    pub fn read(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        interactions: &Interactions,
        diagnostics: &mut Diagnostics,
    ) {
        let before = diagnostics.faults();
        only_for(entry, &["TYPE", "ADJUST", "TIED"], Analysis::Static, diagnostics);
        without_scale_factors(entry, interactions, diagnostics);
        let later = entry.name("INTERACTION").filter(|name| interactions.find_in(name, self.steps - 1).is_none());
        if let (Some(_), Some(name), Some(value)) =
            (interactions.of_parameter(entry, diagnostics), later, entry.value("INTERACTION"))
        {
            let fault = Diagnostic::error(value.span, format!("a later step defines interaction `{name}`"));
            diagnostics.push(fault.help("define it before this step, or in it"));
        }
        let card = Common {
            constraint: match entry.says("MECHANICAL CONSTRAINT", "PENALTY") {
                true => MechanicalConstraint::Penalty,
                false => MechanicalConstraint::Kinematic,
            },
            sliding: self.sliding(entry, diagnostics),
            weight: weight(entry, diagnostics),
        };
        let sound = diagnostics.faults() == before;
        let lines = at_least_one(
            scene.deck.lines(entry.card),
            entry,
            ("this card names no surfaces", "add a line: secondary surface, main surface"),
            diagnostics,
        );
        for line in lines {
            let row = Row::read(line, fields(entry), diagnostics);
            let (Some(first), Some(second), true) = (row.token(0), row.token(1), row.sound) else { continue };
            if entry.says("OP", "DELETE") {
                self.delete((first, second), scene, diagnostics);
                continue;
            }
            let Some(pair) = card.pair((first, second), entry, scene, diagnostics) else { continue };
            self.replace((first, [&pair.secondary_name, &pair.main_name]), diagnostics);
            if sound {
                let place = scene.deck.sources[line.span.source as usize].place(line.span.start);
                let interaction = entry.name("INTERACTION");
                self.active.push(Active { pair: self.list.len(), since: self.steps, interaction, scale_penalty: 1.0 });
                self.list.push((pair, place));
            }
        }
    }

    fn position(&self, names: [&str; 2]) -> Option<usize> {
        self.active.iter().position(|active| {
            let pair = &self.list[active.pair].0;
            [pair.secondary_name.as_str(), pair.main_name.as_str()] == names
        })
    }

    /// A pair of an earlier step is defined anew; one of this step is told.
    fn replace(&mut self, (at, names): (Token<'_>, [&str; 2]), diagnostics: &mut Diagnostics) {
        let Some(known) = self.position(names) else { return };
        if self.active[known].since < self.steps {
            self.active.remove(known);
            return;
        }
        let Place { file, line } = &self.list[self.active[known].pair].1;
        let fault = Diagnostic::error(at.span, "these surfaces are a contact pair already");
        diagnostics.push(fault.help(format!("the first one is at {file}:{line}; both would press")));
    }

    fn delete(&mut self, (first, second): (Token<'_>, Token<'_>), scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        let names = [first, second].map(|token| scene.full_name(token.text));
        match self.position([&names[0], &names[1]]) {
            Some(known) => {
                self.active.remove(known);
            }
            None => {
                let title = format!("no contact pair of `{}` and `{}` acts here", names[0], names[1]);
                let pairs = self.active.iter().map(|active| &self.list[active.pair].0);
                let there: Vec<String> = pairs.map(|p| format!("{}, {}", p.secondary_name, p.main_name)).collect();
                let fault = Diagnostic::error(first.span, title);
                diagnostics.push(fault.known("", there.iter().map(String::as_str)));
            }
        }
    }

    fn sliding(&self, entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Sliding {
        let Some(small) = entry.parameter("SMALL SLIDING") else { return Sliding::Finite };
        let title = match (self.steps, entry.says("MECHANICAL CONSTRAINT", "PENALTY")) {
            (1, false) => {
                let note = Diagnostic::note(small.span, "`SMALL SLIDING` has no effect in explicit steps");
                diagnostics.push(note.label("places on the main surface are found anew in every increment"));
                return Sliding::Small;
            }
            (_, true) => "`SMALL SLIDING` is for kinematic pairs",
            (_, false) => "`SMALL SLIDING` is for the first step: places on the main surface are those of its start",
        };
        diagnostics.push(Diagnostic::error(small.span, title).help("leave it out: the surfaces then slide as they do"));
        Sliding::Small
    }

    /// Reads a `*CONTACT CONTROLS`.
    pub fn control(&mut self, entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
        only_for(entry, STATIC_CONTROLS, Analysis::Static, diagnostics);
        let Some(value) = entry.value("CPSET") else {
            let fault = Diagnostic::error(entry.card.span, "`*CONTACT CONTROLS` needs `CPSET=` in explicit steps");
            diagnostics.push(fault.help("give the pairs a `CPSET` on `*CONTACT PAIR`"));
            return;
        };
        let scale = entry.value("SCALE PENALTY").and_then(|value| Some((value, number(&value.text)?)));
        if let Some((value, _)) = scale.filter(|(_, scale)| *scale <= 0.0) {
            let title = "`SCALE PENALTY` of `*CONTACT CONTROLS` must be > 0";
            diagnostics.push(Diagnostic::error(value.span, title));
        }
        let (name, list) = (normalized(&value.text), &self.list);
        let of_set = |active: &&mut Active| list[active.pair].0.set.as_ref() == Some(&name);
        let mut found = self.active.iter_mut().filter(of_set).peekable();
        if found.peek().is_none() {
            let fault = Diagnostic::error(value.span, format!("no contact pair has `CPSET={name}`"));
            let mut sets: Vec<&str> = list.iter().filter_map(|(pair, _)| pair.set.as_deref()).collect();
            sets.sort_unstable();
            sets.dedup();
            diagnostics.push(fault.known(&name, sets));
        }
        for active in found {
            if entry.has("RESET") {
                active.scale_penalty = 1.0;
            }
            active.scale_penalty = scale.map_or(active.scale_penalty, |(_, scale)| scale);
        }
    }
}

/// Contact controls of static steps.
const STATIC_CONTROLS: &[&str] = &[
    "SECONDARY",
    "MAIN",
    "ABSOLUTE PENETRATION TOLERANCE",
    "RELATIVE PENETRATION TOLERANCE",
    "STIFFNESS SCALE FACTOR",
    "STABILIZE",
    "TANGENT FRACTION",
    "LAGRANGE MULTIPLIER",
];

/// What all pairs of a card have in common.
struct Common {
    constraint: MechanicalConstraint,
    sliding: Sliding,
    weight: Option<f64>,
}

impl Common {
    /// The pair of a line; `None` when it is refused, which was told.
    fn pair(
        &self,
        (first, second): (Token<'_>, Token<'_>),
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<ExplicitPair> {
        let before = diagnostics.faults();
        let (secondary, main) = (secondary(first, scene, diagnostics), main(second, scene, diagnostics));
        let (secondary, main) = (secondary?, main?);
        common_nodes(second, &secondary, &main, scene, diagnostics);
        if self.constraint == MechanicalConstraint::Kinematic {
            rigid_side(first, (&secondary, &main), scene, diagnostics);
        }
        self.idle_weight((&secondary, &main), entry, scene, diagnostics);
        let pair = ExplicitPair {
            secondary_name: scene.full_name(first.text),
            main_name: scene.full_name(second.text),
            secondary: without_areas(first, secondary, diagnostics),
            main,
            set: entry.name("CPSET"),
            constraint: self.constraint,
            sliding: self.sliding,
            weight: self.weight,
        };
        (diagnostics.faults() == before).then_some(pair)
    }
}

impl Common {
    /// Tells a weight where the first surface alone can be the secondary one.
    fn idle_weight(
        &self,
        sides: (&Secondary, &Main),
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        diagnostics: &mut Diagnostics,
    ) {
        let Some(value) = entry.value("WEIGHT").filter(|_| self.weight != Some(0.0)) else { return };
        let is_rigid = |face: &Face| scene.element_of(face.cell).family() == Family::Rigid;
        let why = match sides {
            (Secondary::Faces(_), Main::Faces(faces)) => {
                let kinematic = self.constraint == MechanicalConstraint::Kinematic;
                (kinematic && faces.iter().any(is_rigid))
                    .then_some("what is rigid is the main side of kinematic contact")
            }
            (_, Main::Rigid { .. }) => Some("an analytical surface is the main side"),
            _ => Some("nodes and lines are the secondary side"),
        };
        if let Some(why) = why {
            diagnostics.push(Diagnostic::note(value.span, "`WEIGHT` has no effect here").label(why));
        }
    }
}

/// The law by scale factors is for general contact.
fn without_scale_factors(entry: &Entry<'_>, interactions: &Interactions, diagnostics: &mut Diagnostics) {
    let Some(value) = entry.value("INTERACTION") else { return };
    let name = normalized(&value.text);
    if interactions.find(&name).is_some_and(|found| interactions.list[found].scale_factor.is_some()) {
        let title = format!("the law of interaction `{name}`, `SCALE FACTOR`, is for general contact");
        let fault = Diagnostic::error(value.span, title);
        diagnostics.push(fault.help("say `*CONTACT`, or take another law, say `PRESSURE-OVERCLOSURE=LINEAR`"));
    }
}

fn weight(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = entry.value("WEIGHT")?;
    let weight = number(&value.text)?;
    if !(0.0..=1.0).contains(&weight) {
        diagnostics.push(Diagnostic::error(value.span, "`WEIGHT` of `*CONTACT PAIR` must be ≥ 0, ≤ 1"));
    }
    Some(weight)
}

/// Rigid facets are the main side of kinematic contact: what presses on them gives way.
fn rigid_side(at: Token<'_>, (secondary, main): (&Secondary, &Main), scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let is_rigid = |face: &Face| scene.element_of(face.cell).family() == Family::Rigid;
    let Secondary::Faces(faces) = secondary else { return };
    let Some(face) = faces.iter().find(|face| is_rigid(face)) else { return };
    let title = format!("the surface `{}` has rigid facets and cannot be secondary here", normalized(at.text));
    let fault = Diagnostic::error(at.span, title).label(format!("element {} is one", scene.cell_name(face.cell)));
    let both = match main {
        Main::Faces(others) => others.iter().any(is_rigid),
        Main::Rigid { .. } => true,
    };
    let instead = if both { "for two rigid bodies say" } else { "write it second, or say" };
    diagnostics.push(fault.help(format!("{instead} `MECHANICAL CONSTRAINT=PENALTY`")));
}

/// In explicit pairs the law of a node gives a force, whatever area the surface has.
fn without_areas(at: Token<'_>, secondary: Secondary, diagnostics: &mut Diagnostics) -> Secondary {
    let Secondary::Nodes(nodes) = secondary else { return secondary };
    if nodes.iter().any(|(_, area)| area.is_some()) {
        let note = Diagnostic::note(at.span, "areas of nodes have no effect in explicit steps");
        diagnostics.push(note.label("the law gives the force of a node"));
    }
    Secondary::Nodes(nodes.into_iter().map(|(node, _)| (node, None)).collect())
}
