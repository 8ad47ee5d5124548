//! The cards: one table each, from which reader, checks, messages and manual are made.

pub mod check;
pub mod row;

mod amplitude;
mod beam_section;
mod boundary;
mod change_friction;
mod clearance;
mod contact_controls;
mod contact_damping;
mod contact_interference;
mod contact_pair;
pub(crate) mod controls;
mod discrete;
mod element;
pub(crate) mod friction;
mod gap;
mod general_contact;
mod heading;
mod idle;
mod initial_conditions;
mod loads;
mod mass_scaling;
mod material;
mod mesh;
mod model_change;
mod node;
mod not_yet;
mod output;
pub(crate) mod parts;
mod place;
mod print;
mod procedure;
mod rigid_body;
mod solid_section;
mod step;
mod surface;
pub(crate) mod surface_behavior;
mod surface_interaction;
pub mod table;

pub(crate) use not_yet::STATIC as STATIC_INSTEAD;
pub use table::{Choice, Data, DataLine, Field, FieldKind, Keyword, Kind, Level, Parameter, Repeat, Standing};

/// The cards that are read, in the order of the manual.
pub const CARDS: &[&Keyword] = &[
    &heading::HEADING,
    &heading::INCLUDE,
    &parts::PART,
    &parts::END_PART,
    &parts::ASSEMBLY,
    &parts::INSTANCE,
    &parts::END_INSTANCE,
    &parts::END_ASSEMBLY,
    &mesh::MESH,
    &node::NODE,
    &node::NSET,
    &element::ELEMENT,
    &element::ELSET,
    &surface::SURFACE,
    &rigid_body::RIGID_BODY,
    &material::MATERIAL,
    &material::ELASTIC,
    &material::PLASTIC,
    &material::HYPERELASTIC,
    &material::DENSITY,
    &material::DAMPING,
    &solid_section::SOLID_SECTION,
    &solid_section::SECTION_CONTROLS,
    &beam_section::BEAM_SECTION,
    &beam_section::BEAM_GENERAL_SECTION,
    &discrete::SPRING,
    &discrete::DASHPOT,
    &discrete::MASS,
    &discrete::ROTARY_INERTIA,
    &amplitude::AMPLITUDE,
    &surface_interaction::SURFACE_INTERACTION,
    &surface_behavior::SURFACE_BEHAVIOR,
    &friction::FRICTION,
    &contact_damping::CONTACT_DAMPING,
    &contact_pair::CONTACT_PAIR,
    &general_contact::CONTACT,
    &general_contact::CONTACT_INCLUSIONS,
    &general_contact::CONTACT_EXCLUSIONS,
    &general_contact::CONTACT_PROPERTY_ASSIGNMENT,
    &general_contact::CONTACT_CONTROLS_ASSIGNMENT,
    &gap::GAP,
    &clearance::CLEARANCE,
    &gap::INTERFACE,
    &gap::SLIDE_LINE,
    &boundary::BOUNDARY,
    &initial_conditions::INITIAL_CONDITIONS,
    &step::STEP,
    &procedure::STATIC,
    &procedure::DYNAMIC,
    &procedure::BULK_VISCOSITY,
    &mass_scaling::FIXED_MASS_SCALING,
    &mass_scaling::VARIABLE_MASS_SCALING,
    &controls::CONTROLS,
    &model_change::MODEL_CHANGE,
    &contact_interference::CONTACT_INTERFERENCE,
    &contact_controls::CONTACT_CONTROLS,
    &change_friction::CHANGE_FRICTION,
    &loads::CLOAD,
    &loads::DLOAD,
    &loads::DSLOAD,
    &print::NODE_PRINT,
    &print::EL_PRINT,
    &print::CONTACT_PRINT,
    &output::OUTPUT,
    &output::NODE_OUTPUT,
    &output::ELEMENT_OUTPUT,
    &output::CONTACT_OUTPUT,
    &output::ENERGY_OUTPUT,
    &output::NODE_FILE,
    &output::EL_FILE,
    &output::CONTACT_FILE,
    &step::END_STEP,
];

/// What is known of a card's name.
#[derive(Clone, Copy, Debug)]
pub enum Known {
    /// It is read.
    Card(&'static Keyword),
    /// It is a card, but not there yet; what there is instead.
    NotYet(&'static str, &'static str),
    /// It has no effect here; why.
    Idle(&'static str, &'static str),
}

/// Blanks inside keywords do not count.
pub(crate) fn same(a: &str, b: &str) -> bool {
    a.bytes().filter(|b| *b != b' ').eq(b.bytes().filter(|b| *b != b' '))
}

/// By name, capitals, with or without inner blanks.
pub fn find(name: &str) -> Option<Known> {
    if let Some(card) = CARDS.iter().find(|card| same(card.name, name)) {
        return Some(Known::Card(card));
    }
    let not_yet = not_yet::CARDS.iter().flat_map(|(names, hint)| names.iter().map(move |n| (*n, *hint)));
    if let Some((name, hint)) = { not_yet }.find(|(known, _)| same(known, name)) {
        return Some(Known::NotYet(name, hint));
    }
    idle::CARDS.iter().find(|(known, _)| same(known, name)).map(|(name, why)| Known::Idle(name, why))
}

/// Names of all cards, those that are read first.
pub fn names() -> impl Iterator<Item = &'static str> {
    let not_yet = not_yet::CARDS.iter().flat_map(|(names, _)| names.iter().copied());
    CARDS.iter().map(|card| card.name).chain(not_yet).chain(idle::CARDS.iter().map(|(name, _)| *name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_name_is_there_once() {
        let mut seen = BTreeSet::new();
        for name in names() {
            assert!(seen.insert(name.replace(' ', "")), "{name}");
            assert_eq!(name, crate::deck::card::normalized(name));
        }
    }

    #[test]
    fn blanks_do_not_count_abbreviations_do() {
        assert!(matches!(find("SOLIDSECTION"), Some(Known::Card(card)) if card.name == "SOLID SECTION"));
        assert!(matches!(find("FREQUENCY"), Some(Known::NotYet(..))));
        assert!(matches!(find("PREPRINT"), Some(Known::Idle(..))));
        assert!(find("BOUN").is_none());
    }

    #[test]
    fn tables_hold_words_once() {
        for card in CARDS {
            let mut seen = BTreeSet::new();
            for parameter in card.parameters {
                assert!(seen.insert(parameter.name), "{} {}", card.name, parameter.name);
                assert!(!parameter.meaning.is_empty());
            }
            assert!(!card.summary.is_empty() && !card.source.is_empty(), "{}", card.name);
        }
    }
}
