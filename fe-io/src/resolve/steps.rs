//! Steps.

use super::amplitudes::Amplitudes;
use super::explicit_pairs::ExplicitPairs;
use super::interactions::Interactions;
use super::requests::Requests;
use super::scene::{Analysis, Scene};
use super::supports::Supports;
use super::{conditions, controls, general_contact, loads, mass_scaling, procedures, which_pair};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::{self, Known};
use crate::model::{Changes, Place, Step};
use fe_contact::pair::{Bond, PairDefinition};
use fe_core::load::{Load, Support};
use fe_core::step::{Controls, Explicit, Procedure};

/// `*STEP, INC=` unless the deck says otherwise.
const MOST_INCREMENTS: usize = 100;

/// What steps hand on to later ones.
pub struct InForce {
    controls: Controls,
    bulk_viscosity: [f64; 2],
    /// Kind and place of the first procedure.
    first: Option<(Analysis, Span)>,
    requests: Requests,
    pub(super) explicit_pairs: ExplicitPairs,
    mass_scaling: mass_scaling::InForce,
    pub(super) general_contact: general_contact::InForce,
    pub(super) conditions: conditions::InForce,
}

impl Default for InForce {
    fn default() -> Self {
        InForce {
            controls: Controls::default(),
            bulk_viscosity: Explicit::BULK_VISCOSITY,
            first: None,
            requests: Requests::default(),
            explicit_pairs: ExplicitPairs::default(),
            mass_scaling: mass_scaling::InForce::default(),
            general_contact: general_contact::InForce::default(),
            conditions: conditions::InForce::default(),
        }
    }
}

/// What steps refer to.
pub struct Named<'a> {
    /// Amplitudes.
    pub amplitudes: &'a Amplitudes,
    /// Interactions.
    pub interactions: &'a Interactions,
    /// Contact pairs.
    pub pairs: &'a [(PairDefinition, Place)],
    /// Sets of contact elements and their interactions: gap elements, then tubes.
    pub elements: Vec<(&'a str, usize)>,
}

impl Named<'_> {
    /// The contacts that an interaction describes, indices into all of them; tied pairs have none but their own.
    pub fn contacts_of(&self, interaction: usize) -> impl Iterator<Item = usize> {
        let pairs = self.pairs.iter().map(|(pair, _)| (pair.bond == Bond::Contact).then_some(pair.interaction));
        let elements = self.elements.iter().map(|(_, interaction)| Some(*interaction));
        pairs.chain(elements).enumerate().filter(move |(_, of)| *of == Some(interaction)).map(|(i, _)| i)
    }
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
    in_force.explicit_pairs.begin_step();
    in_force.mass_scaling.begin_step();
    in_force.general_contact.begin_step();
    in_force.conditions.begin_step(replaces(rest, &["CONTACT INTERFERENCE"], diagnostics));
    if let Some(convert) = first.name("CONVERT SDI") {
        in_force.controls.convert_sdi = convert == "YES";
    }
    let mut procedure: Option<(Option<Procedure>, Span)> = None;
    let mut supports = Supports::default();
    let mut loads = [Vec::new(), Vec::new()];
    for (i, entry) in rest.iter().enumerate() {
        match entry.keyword.name {
            "STATIC" | "DYNAMIC" => {
                let read = in_force.procedure(first, entry, scene, diagnostics);
                if let Some((_, other)) = procedure.replace((read, entry.card.span)) {
                    let fault = Diagnostic::error(entry.card.span, "a step has one procedure");
                    diagnostics.push(fault.related(other, "the first one"));
                }
            }
            name if !suits(name, entry, scene.analysis, diagnostics) => {}
            "BULK VISCOSITY" => {
                procedures::bulk_viscosity(entry, scene.deck, &mut in_force.bulk_viscosity, diagnostics);
            }
            "CONTROLS" => controls::read(entry, scene.deck, &mut in_force.controls, diagnostics),
            "MODEL CHANGE" => in_force.conditions.change(entry, scene, named.pairs, diagnostics),
            "CONTACT INTERFERENCE" => in_force.conditions.interfere(entry, scene, named, diagnostics),
            "CHANGE FRICTION" => {
                in_force.conditions.change_friction((entry, rest.get(i + 1)), scene, named, diagnostics);
            }
            "FRICTION"
                if scene.analysis == Analysis::Static && (i == 0 || rest[i - 1].keyword.name != "CHANGE FRICTION") =>
            {
                let fault = Diagnostic::error(entry.card.span, "in a step `*FRICTION` follows `*CHANGE FRICTION`");
                diagnostics.push(
                    fault.help("say `*CHANGE FRICTION, INTERACTION=…` before it, or write it before the first step"),
                );
            }
            "FIXED MASS SCALING" | "VARIABLE MASS SCALING" => in_force.mass_scaling.read(entry, scene, diagnostics),
            name if general_contact::CARDS.contains(&name) => {
                in_force.general_contact.read(entry, scene, named.interactions, diagnostics);
            }
            "CONTACT PAIR" => in_force.explicit_pairs.read(entry, scene, named.interactions, diagnostics),
            "CONTACT CONTROLS" if scene.analysis == Analysis::Explicit => {
                in_force.explicit_pairs.control(entry, diagnostics);
            }
            "CONTACT CONTROLS" => in_force.conditions.control(entry, scene, named, diagnostics),
            "BOUNDARY" => supports.read(entry, scene, named.amplitudes, diagnostics),
            "CLOAD" => loads[0].extend(loads::read(entry, scene, named.amplitudes, diagnostics)),
            "DLOAD" | "DSLOAD" => loads[1].extend(loads::read(entry, scene, named.amplitudes, diagnostics)),
            name if name.ends_with("PRINT") || name.ends_with("OUTPUT") || name.ends_with("FILE") => {
                let pairs = match scene.analysis {
                    Analysis::Static => which_pair::names(named.pairs),
                    Analysis::Explicit => in_force.explicit_pairs.names(),
                };
                in_force.requests.read(entry, scene, &pairs, diagnostics);
            }
            _ => {}
        }
    }
    if procedure.is_none() && !other_procedure(first, scene) {
        let fault = Diagnostic::error(first.card.span, "this step has no procedure");
        diagnostics.push(fault.help("say `*STATIC` or `*DYNAMIC, EXPLICIT` after `*STEP`"));
    }
    let procedure = procedure.and_then(|(procedure, _)| procedure).map(|procedure| in_force.finish(procedure));
    if let Some(procedure) = &procedure {
        in_force.conditions.end_step(procedure.period());
    }
    let [nodal_loads, distributed_loads] = loads;
    Some(Step {
        place: scene.deck.sources[first.card.span.source as usize].place(first.card.span.start),
        procedure: procedure?,
        supports: Changes::<Support> { replace: replaces(rest, &["BOUNDARY"], diagnostics), items: supports.items },
        nodal_loads: Changes::<Load> { replace: replaces(rest, &["CLOAD"], diagnostics), items: nodal_loads },
        distributed_loads: Changes::<Load> {
            replace: replaces(rest, &["DLOAD", "DSLOAD"], diagnostics),
            items: distributed_loads,
        },
        conditions: in_force.conditions.conditions(),
        explicit_pairs: in_force.explicit_pairs.in_force(named.interactions),
        general_contact: in_force.general_contact.in_force(named.interactions, first.step?),
        mass_scaling: in_force.mass_scaling.in_force(),
        output: in_force.requests.in_force(scene.analysis),
    })
}

impl InForce {
    /// Reads `*STATIC` or `*DYNAMIC` of a step; `None` when it is refused, which was told.
    fn procedure(
        &mut self,
        step: &Entry<'_>,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<Procedure> {
        let most = step.whole("INC").map_or(MOST_INCREMENTS, |n| n as usize);
        if most == 0 {
            diagnostics.push(Diagnostic::error(step.card.span, "`INC` of `*STEP` must be at least 1"));
        }
        let at = entry.card.span;
        let kind = if entry.keyword.name == "DYNAMIC" { Analysis::Explicit } else { Analysis::Static };
        let (first, other) = *self.first.get_or_insert((kind, at));
        if first != kind {
            let words = |kind| if kind == Analysis::Static { "static" } else { "dynamic" };
            let fault = Diagnostic::error(at, "all steps of a job are of one kind");
            let fault = fault.label(format!("this step is {}", words(kind)));
            diagnostics.push(fault.related(other, format!("this one is {}", words(first))).help("write two jobs"));
        }
        if kind == Analysis::Explicit {
            return procedures::explicit(entry, step, scene.deck, diagnostics).map(Procedure::Explicit);
        }
        if let Some(large) = step.parameter("NLGEOM").filter(|_| !step.says("NLGEOM", "NO")) {
            let fault = Diagnostic::error(large.span, "`NLGEOM` of `*STEP` is not there yet in static steps");
            diagnostics.push(fault.help("displacements are small: say `NLGEOM=NO` or leave it out"));
        }
        let increments = controls::increments(entry, most, scene.deck, diagnostics)?;
        Some(Procedure::Static { increments, controls: self.controls })
    }

    /// The procedure with what the step's other cards say of it.
    fn finish(&self, procedure: Procedure) -> Procedure {
        match procedure {
            Procedure::Static { increments, .. } => Procedure::Static { increments, controls: self.controls },
            Procedure::Explicit(explicit) => {
                Procedure::Explicit(Explicit { bulk_viscosity: self.bulk_viscosity, ..explicit })
            }
        }
    }
}

/// Cards without effect in one kind of steps, and why.
const IDLE: &[(&str, Analysis, &str)] = &[
    ("CONTROLS", Analysis::Explicit, "explicit increments do not iterate"),
    ("BULK VISCOSITY", Analysis::Static, "nothing moves at a speed"),
    ("ENERGY OUTPUT", Analysis::Static, "energies are part of each increment's certificate"),
    ("FIXED MASS SCALING", Analysis::Static, "masses have no inertia"),
    ("VARIABLE MASS SCALING", Analysis::Static, "masses have no inertia"),
];

/// Cards for static steps alone, and what there is instead.
const STATIC: &[(&str, &str)] = &[
    ("MODEL CHANGE", "`*CONTACT PAIR, OP=DELETE` in the step takes a pair away"),
    ("CHANGE FRICTION", "write the `*SURFACE INTERACTION` anew in the step, with its `*FRICTION`"),
    ("CONTACT INTERFERENCE", "overlaps of the first step are taken out by moving nodes, without strain"),
];

/// True when a card has a meaning in steps of this kind; what has none is told.
fn suits(name: &str, entry: &Entry<'_>, analysis: Analysis, diagnostics: &mut Diagnostics) -> bool {
    if let Some((.., why)) = IDLE.iter().find(|(idle, kind, _)| *idle == name && *kind == analysis) {
        diagnostics.push(Diagnostic::note(entry.card.span, format!("`*{name}` has no effect")).label(*why));
        return false;
    }
    if let Some((_, instead)) = STATIC.iter().find(|(known, _)| *known == name && analysis == Analysis::Explicit) {
        let fault = Diagnostic::error(entry.card.span, format!("`*{name}` is for static steps"));
        diagnostics.push(fault.help(*instead));
        return false;
    }
    true
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
