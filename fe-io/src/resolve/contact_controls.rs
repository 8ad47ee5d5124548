//! `*CONTACT CONTROLS`.

use super::conditions::InForce;
use super::lines::fields;
use super::procedures::only_for;
use super::scene::{Analysis, Scene};
use super::steps::Named;
use super::which_pair;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_contact::conditions::{MultiplierUse, Overrides, Tolerance};
use fe_contact::viscous::{Coefficient, Stabilization};

impl InForce {
    /// Reads a card: it holds for one pair, or for all pairs that no card has named, and all contact elements.
    pub fn control(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, named: &Named<'_>, diagnostics: &mut Diagnostics) {
        let before = diagnostics.faults();
        only_for(entry, &["CPSET", "SCALE PENALTY"], Analysis::Explicit, diagnostics);
        let pair = which_pair::of_parameters(entry, named.pairs, scene, diagnostics);
        let tolerance = tolerance(entry, diagnostics);
        let scale = positive(entry, "STIFFNESS SCALE FACTOR", diagnostics);
        let stabilization = stabilization(entry, scene, diagnostics);
        if diagnostics.faults() > before {
            return;
        }
        // Contact elements come after the pairs.
        let contacts = named.pairs.len() + named.elements.len();
        let idle = match entry.parameter("STABILIZE") {
            _ if contacts == 0 => Some((entry.card.span, "*CONTACT CONTROLS")),
            Some(stabilize) if named.pairs.is_empty() => Some((stabilize.span, "STABILIZE")),
            _ => None,
        };
        if let Some((span, word)) = idle {
            let note = Diagnostic::note(span, format!("`{word}` has no effect"));
            diagnostics.push(note.label("there is no contact pair"));
        }
        let meant: Vec<usize> = match pair {
            Some(pair) => vec![pair],
            None => (0..contacts).filter(|contact| !self.own.contains(contact)).collect(),
        };
        for contact in meant {
            if entry.has("RESET") {
                self.own.remove(&contact);
                (self.of(contact).overrides, self.of(contact).stabilization) = (Overrides::default(), None);
            } else if entry.has("MAIN") {
                self.own.insert(contact);
            }
            let conditions = self.of(contact);
            let overrides = &mut conditions.overrides;
            overrides.stiffness_scale = scale.unwrap_or(overrides.stiffness_scale);
            overrides.tolerance = tolerance.or(overrides.tolerance);
            if let Some(word) = entry.name("LAGRANGE MULTIPLIER") {
                overrides.multipliers = if word == "YES" { MultiplierUse::Always } else { MultiplierUse::Never };
            }
            // Contact elements are not stabilised.
            if contact < named.pairs.len() {
                conditions.stabilization = stabilization.or(conditions.stabilization);
            }
        }
    }
}

/// A parameter's number, which must be above 0.
fn positive(entry: &Entry<'_>, name: &str, diagnostics: &mut Diagnostics) -> Option<f64> {
    at_least(entry, name, f64::MIN_POSITIVE, "> 0", diagnostics)
}

fn at_least(entry: &Entry<'_>, name: &str, least: f64, words: &str, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = entry.value(name)?;
    let read = number(&value.text)?;
    if read < least {
        let title = format!("`{name}` of `*CONTACT CONTROLS` must be {words}");
        diagnostics.push(Diagnostic::error(value.span, title));
        return None;
    }
    Some(read)
}

fn tolerance(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<Tolerance> {
    let absolute = positive(entry, "ABSOLUTE PENETRATION TOLERANCE", diagnostics).map(Tolerance::Absolute);
    let relative = positive(entry, "RELATIVE PENETRATION TOLERANCE", diagnostics).map(Tolerance::Relative);
    let words = [entry.parameter("ABSOLUTE PENETRATION TOLERANCE"), entry.parameter("RELATIVE PENETRATION TOLERANCE")];
    if let [Some(one), Some(other)] = words {
        let fault = Diagnostic::error(other.span, "one penetration tolerance is enough");
        diagnostics.push(fault.related(one.span, "the other one"));
    }
    absolute.or(relative)
}

fn stabilization(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Stabilization> {
    let line = scene.deck.lines(entry.card).next();
    let fraction = at_least(entry, "TANGENT FRACTION", 0.0, "≥ 0", diagnostics);
    let Some(parameter) = entry.parameter("STABILIZE") else {
        if let Some(line) = line {
            let fault = Diagnostic::error(line.span, "this line belongs to `STABILIZE`");
            diagnostics.push(fault.help("say `*CONTACT CONTROLS, STABILIZE`"));
        }
        if let Some(fraction) = entry.parameter("TANGENT FRACTION") {
            let note = Diagnostic::note(fraction.span, "`TANGENT FRACTION` has no effect without `STABILIZE`");
            diagnostics.push(note);
        }
        return None;
    };
    let factor = match parameter.value.as_ref().filter(|value| !value.text.is_empty()) {
        None => 1.0,
        Some(value) => match number(&value.text).filter(|factor| *factor > 0.0) {
            Some(factor) => factor,
            None => {
                let title = format!("`STABILIZE` cannot be `{}`: it is a factor > 0", value.text);
                diagnostics.push(Diagnostic::error(value.span, title));
                return None;
            }
        },
    };
    let row = line.map(|line| Row::read(line, fields(entry), diagnostics));
    let given = |i: usize| row.as_ref().and_then(|row| row.number(i));
    Some(Stabilization {
        coefficient: given(0).map_or(Coefficient::Automatic(factor), Coefficient::Given),
        tangent_fraction: fraction.unwrap_or(1.0),
        end: given(1).unwrap_or(0.0),
        range: given(2),
    })
}
