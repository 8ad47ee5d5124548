//! Steps.

use super::amplitudes::Amplitudes;
use super::requests::Requests;
use super::scene::Scene;
use super::supports::Supports;
use super::{conditions, controls, loads};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::{self, Known};
use crate::model::{Changes, Place, Step};
use fe_contact::pair::PairDefinition;
use fe_core::load::{Load, Support};
use fe_core::step::{Controls, Increments};

/// `*STEP, INC=` unless the deck says otherwise.
const MOST_INCREMENTS: usize = 100;

/// What steps hand on to later ones.
#[derive(Default)]
pub struct InForce {
    controls: Controls,
    requests: Requests,
    conditions: conditions::InForce,
}

/// What steps refer to.
pub struct Named<'a> {
    /// Amplitudes.
    pub amplitudes: &'a Amplitudes,
    /// Contact pairs.
    pub pairs: &'a [(PairDefinition, Place)],
    /// Sets of contact elements: gap elements, then tubes.
    pub elements: Vec<&'a str>,
}

/// Reads one step, its `*STEP` first; `None` when it is refused, which was told.
pub fn read(
    entries: &[Entry<'_>],
    named: &Named<'_>,
    in_force: &mut InForce,
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Step> {
    let (first, rest) = entries.split_first()?;
    in_force.requests.begin_step();
    in_force.conditions.begin_step(replaces(rest, &["CONTACT INTERFERENCE"], diagnostics));
    if let Some(convert) = first.name("CONVERT SDI") {
        in_force.controls.convert_sdi = convert == "YES";
    }
    let most = first.whole("INC").map_or(MOST_INCREMENTS, |n| n as usize);
    if most == 0 {
        diagnostics.push(Diagnostic::error(first.card.span, "`INC` of `*STEP` must be at least 1"));
    }
    let mut increments: Option<(Option<Increments>, Span)> = None;
    let mut supports = Supports::default();
    let mut loads = [Vec::new(), Vec::new()];
    for entry in rest {
        match entry.keyword.name {
            "STATIC" => {
                let read = controls::increments(entry, most, scene.deck, diagnostics);
                if let Some((_, other)) = increments.replace((read, entry.card.span)) {
                    let fault = Diagnostic::error(entry.card.span, "a step has one `*STATIC`");
                    diagnostics.push(fault.related(other, "the first one"));
                }
            }
            "CONTROLS" => controls::read(entry, scene.deck, &mut in_force.controls, diagnostics),
            "MODEL CHANGE" => in_force.conditions.change(entry, scene, named.pairs, diagnostics),
            "CONTACT INTERFERENCE" => in_force.conditions.interfere(entry, scene, named, diagnostics),
            "CONTACT CONTROLS" => in_force.conditions.control(entry, scene, named, diagnostics),
            "BOUNDARY" => supports.read(entry, scene, named.amplitudes, diagnostics),
            "CLOAD" => loads[0].extend(loads::read(entry, scene, named.amplitudes, diagnostics)),
            "DLOAD" | "DSLOAD" => loads[1].extend(loads::read(entry, scene, named.amplitudes, diagnostics)),
            name if name.ends_with("PRINT") || name.ends_with("OUTPUT") || name.ends_with("FILE") => {
                in_force.requests.read(entry, scene, named.pairs, diagnostics);
            }
            _ => {}
        }
    }
    if increments.is_none() && !other_procedure(first, scene) {
        let fault = Diagnostic::error(first.card.span, "this step has no procedure");
        diagnostics.push(fault.help("say `*STATIC` after `*STEP`"));
    }
    if let Some((Some(increments), _)) = &increments {
        in_force.conditions.end_step(increments.period);
    }
    let [nodal_loads, distributed_loads] = loads;
    Some(Step {
        place: scene.deck.sources[first.card.span.source as usize].place(first.card.span.start),
        increments: increments?.0?,
        controls: in_force.controls,
        supports: Changes::<Support> { replace: replaces(rest, &["BOUNDARY"], diagnostics), items: supports.items },
        nodal_loads: Changes::<Load> { replace: replaces(rest, &["CLOAD"], diagnostics), items: nodal_loads },
        distributed_loads: Changes::<Load> {
            replace: replaces(rest, &["DLOAD", "DSLOAD"], diagnostics),
            items: distributed_loads,
        },
        conditions: in_force.conditions.conditions(),
        output: in_force.requests.in_force(),
    })
}

/// True when the cards of these names say `OP=NEW`: all of them or none.
fn replaces(entries: &[Entry<'_>], names: &[&str], diagnostics: &mut Diagnostics) -> bool {
    let cards: Vec<&Entry<'_>> = entries.iter().filter(|entry| names.contains(&entry.keyword.name)).collect();
    let new = cards.iter().find(|entry| entry.says("OP", "NEW"));
    let other = cards.iter().find(|entry| !entry.says("OP", "NEW"));
    if let (Some(new), Some(other)) = (new, other) {
        let title = format!("`OP=NEW` is said on all `*{}` of a step or on none", names.join("` and `*"));
        let fault = Diagnostic::error(other.card.span, title).label("not said here");
        diagnostics.push(fault.related(new.card.span, "said here"));
    }
    new.is_some()
}

/// True when the step has a procedure that is not there yet, which was told.
fn other_procedure(step: &Entry<'_>, scene: &Scene<'_>) -> bool {
    let cards = scene.deck.cards.iter().skip_while(|card| card.span != step.card.span).skip(1);
    let mut cards = cards.take_while(|card| card.keyword != "STEP");
    cards.any(|card| matches!(keyword::find(&card.keyword), Some(Known::NotYet(_, instead)) if instead == keyword::STATIC_INSTEAD))
}
