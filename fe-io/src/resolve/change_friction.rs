//! `*CHANGE FRICTION` with the `*FRICTION` that follows it.

use super::conditions::InForce;
use super::friction;
use super::interactions::Interactions;
use super::scene::Scene;
use super::steps::Named;
use super::which_pair;
use crate::deck::card::Token;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_contact::friction::change::Change;
use fe_contact::friction::{Friction, Stick, TOLERANCE};
use fe_core::ramp::Ramp;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The changes of friction that steps have made so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Frictions {
    /// By interaction what it begins the job with, where that is not what the model data say.
    begin: BTreeMap<usize, Friction>,
    /// By interaction what points do that stick.
    stick: BTreeMap<usize, Stick>,
    /// Places of the present step's cards by interaction.
    cards: BTreeMap<usize, Span>,
}

impl Frictions {
    /// Begins a step.
    pub fn begin_step(&mut self) {
        self.cards.clear();
    }

    /// Gives interactions the friction that they begin with.
    pub fn begin_job(&self, interactions: &mut Interactions) {
        for (&i, friction) in &self.begin {
            interactions.list[i].friction = Some(friction.clone());
        }
    }
}

impl InForce {
    /// Reads a card; `next` is the one after it.
    pub fn change_friction(
        &mut self,
        (entry, next): (&Entry<'_>, Option<&Entry<'_>>),
        scene: &Scene<'_>,
        named: &Named<'_>,
        diagnostics: &mut Diagnostics,
    ) {
        let before = diagnostics.faults();
        let interaction = interaction(entry, scene, named, diagnostics);
        let course = course(entry, named, diagnostics);
        let card = next.filter(|next| next.keyword.name == "FRICTION");
        card.into_iter().for_each(|card| friction::no_slope(card, diagnostics));
        let friction = card.and_then(|card| friction::read(card, scene.deck, diagnostics));
        match (entry.parameter("RESET"), card) {
            (Some(reset), Some(card)) => {
                let fault = Diagnostic::error(card.card.span, "`*CHANGE FRICTION, RESET` has no `*FRICTION`");
                diagnostics.push(fault.related(reset.span, "back to the friction of the model data"));
            }
            (None, None) => {
                let fault = Diagnostic::error(entry.card.span, "`*CHANGE FRICTION` needs a `*FRICTION` after it");
                diagnostics.push(fault.help("for the friction of the model data say `RESET`"));
            }
            _ => {}
        }
        let Some(interaction) = interaction else { return };
        if let Some(first) = self.frictions.cards.insert(interaction, entry.card.span) {
            let fault = Diagnostic::error(entry.card.span, "this friction changes twice in one step");
            diagnostics.push(fault.related(first, "first here"));
        }
        let (Some(course), true) = (course, diagnostics.faults() == before) else { return };
        let own = named.interactions.list[interaction].friction.clone();
        let stick = *self.frictions.stick.get(&interaction).unwrap_or(&Stick::Tolerance(TOLERANCE));
        let to = friction.or(own.clone()).unwrap_or(Friction::none(stick));
        if let Friction::Coulomb { stick, .. } = to {
            self.frictions.stick.insert(interaction, stick);
        }
        if own.is_none() || self.steps == 1 {
            let stick = *self.frictions.stick.get(&interaction).unwrap_or(&stick);
            self.frictions.begin.entry(interaction).or_insert(Friction::none(stick));
        }
        let contacts: Vec<usize> = named.contacts_of(interaction).collect();
        if contacts.is_empty() {
            let note = Diagnostic::warning(entry.card.span, "this card has no effect");
            diagnostics.push(note.label("no contact pair that is not tied has this interaction"));
        }
        for contact in contacts {
            self.of(contact).friction = Some(Change { to: to.clone(), course: course.clone() });
        }
    }
}

/// The interaction that the card means, an index; a missing one is told.
fn interaction(
    entry: &Entry<'_>,
    scene: &Scene<'_>,
    named: &Named<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    match (entry.parameter("INTERACTION"), entry.parameter("ELSET")) {
        (Some(_), None) => named.interactions.of_parameter(entry, diagnostics),
        (None, Some(_)) => {
            let value = entry.value("ELSET")?;
            let set = Token { text: &value.text, span: value.span };
            which_pair::of_elements(set, named, scene, diagnostics)
                .map(|contact| named.elements[contact - named.pairs.len()].1)
        }
        (Some(one), Some(other)) => {
            let fault = Diagnostic::error(other.span, "this card means an interaction or contact elements, not both");
            diagnostics.push(fault.related(one.span, "the other one"));
            None
        }
        (None, None) => {
            let fault = Diagnostic::error(entry.card.span, "`*CHANGE FRICTION` needs `INTERACTION=` or `ELSET=`");
            diagnostics.push(fault);
            None
        }
    }
}

/// Part of the way over the step.
fn course(entry: &Entry<'_>, named: &Named<'_>, diagnostics: &mut Diagnostics) -> Option<Ramp> {
    let Some(value) = entry.value("AMPLITUDE") else { return Some(Ramp { from: 0.0, to: 1.0, amplitude: None }) };
    let amplitude = &named.amplitudes.list[named.amplitudes.of(entry, diagnostics)?];
    let parts: Vec<f64> = amplitude.points.iter().map(|point| point.1).collect();
    if !parts.is_sorted() || parts.iter().any(|part| !(0.0..=1.0).contains(part)) {
        let title = format!("amplitude `{}` is no part of the way", amplitude.name);
        let fault = Diagnostic::error(value.span, title).label("`AMPLITUDE` of `*CHANGE FRICTION`");
        diagnostics
            .push(fault.help("its factors lie between 0, the old friction, and 1, the new one, and do not fall"));
        return None;
    }
    Some(Ramp { from: 0.0, to: 1.0, amplitude: Some(Arc::new(amplitude.clone())) })
}
