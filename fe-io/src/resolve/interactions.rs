//! `*SURFACE INTERACTION`, or the card of contact elements, with its `*SURFACE BEHAVIOR`, `*FRICTION` and
//! `*CONTACT DAMPING`.

use super::lines::fields;
use super::procedures::only_for;
use super::scene::Analysis;
use super::{contact_damping, formula, friction, hard};
use crate::deck::Deck;
use crate::deck::card::{Card, Line, normalized};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::{Entry, too_many_lines};
use crate::keyword::row::{Row, names, of_law};
use crate::keyword::{self, Field, Known, surface_behavior};
use fe_contact::interaction::{Enforcement, Interaction, NormalBehavior};
use fe_contact::law::scale_factor::Scaling;
use fe_contact::law::{Datum, LawDefinition, Laws, Lines, NormalLaw};
use fe_contact::verify::{self, LawFault};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What cards are read with.
#[derive(Clone, Copy, Debug)]
pub struct Given<'a> {
    /// The deck.
    pub deck: &'a Deck,
    /// The laws that it may name.
    pub laws: &'a Laws,
    /// Size [L] of the model.
    pub size: f64,
    /// Kind of its steps.
    pub analysis: Analysis,
}

/// The card that gives an interaction a name.
const NAMED: &str = "SURFACE INTERACTION";
/// The cards that describe contact.
const PARENTS: [&str; 3] = [NAMED, "GAP", "INTERFACE"];
/// The cards that follow them.
const DESCRIBING: [&str; 3] = ["SURFACE BEHAVIOR", "FRICTION", "CONTACT DAMPING"];
const PARENTS_IN_WORDS: &str = "`*SURFACE INTERACTION`, `*GAP` or `*INTERFACE`";

/// The interactions of a model.
#[derive(Debug, Default)]
pub struct Interactions {
    /// In the order of the deck.
    pub list: Vec<Interaction>,
    /// Keyword and place of each one's card.
    cards: Vec<(&'static str, Span)>,
    /// Steps in which they are defined, from 0.
    steps: Vec<Option<usize>>,
    /// Places of the cards that describe each one, by keyword.
    described: Vec<BTreeMap<&'static str, Span>>,
}

impl Interactions {
    /// Reads all of them.
    pub fn read(entries: &[Entry<'_>], given: Given<'_>, diagnostics: &mut Diagnostics) -> Self {
        let deck = given.deck;
        let mut all = Interactions::default();
        for entry in entries {
            if PARENTS.contains(&entry.keyword.name) {
                all.begin(entry, given, diagnostics);
                continue;
            }
            let of = parent(entry, deck);
            if of.is_none() {
                let title = format!("`*{}` stands under no {PARENTS_IN_WORDS}", entry.keyword.name);
                diagnostics
                    .push(Diagnostic::error(entry.card.span, title).help("it follows the card that it describes"));
            }
            let user = of.and_then(|card| card.parameters.iter().find(|p| keyword::same("USER", &p.name)));
            if let Some(user) = user.filter(|_| entry.keyword.name == "SURFACE BEHAVIOR") {
                let title = "`*SURFACE BEHAVIOR` cannot stand under a `*SURFACE INTERACTION` with `USER`";
                diagnostics
                    .push(Diagnostic::error(entry.card.span, title).related(user.span, "the law is all its own"));
            }
            let of = of.and_then(|parent| all.of_card(parent.span));
            of.into_iter().for_each(|i| all.once(i, entry, diagnostics));
            match entry.keyword.name {
                "FRICTION" => {
                    let friction = friction::of_interaction(entry, deck, given.analysis, diagnostics);
                    of.into_iter().for_each(|i| all.list[i].friction = friction.clone());
                }
                "CONTACT DAMPING" if given.analysis == Analysis::Explicit => {
                    let damping = contact_damping::explicit(entry, deck, diagnostics);
                    of.into_iter().for_each(|i| all.list[i].explicit_damping = damping);
                }
                "CONTACT DAMPING" => {
                    let damping = contact_damping::read(entry, deck, diagnostics);
                    of.into_iter().for_each(|i| all.list[i].damping = damping);
                }
                _ => {
                    let behavior = behavior(entry, given, diagnostics);
                    jump(entry, behavior.as_ref().map(|(normal, _)| normal), diagnostics);
                    of.into_iter().for_each(|i| all.describe(i, entry, behavior.clone()));
                }
            }
        }
        all
    }

    fn begin(&mut self, entry: &Entry<'_>, given: Given<'_>, diagnostics: &mut Diagnostics) {
        let named = entry.keyword.name == NAMED;
        let Some(value) = entry.value(if named { "NAME" } else { "ELSET" }) else { return };
        let name = normalized(&value.text);
        // A later step may define it anew.
        if let Some(first) = self.find(&name).filter(|&first| named && self.steps[first] == entry.step) {
            let fault = Diagnostic::error(value.span, format!("interaction `{name}` is there twice"));
            diagnostics.push(fault.related(self.cards[first].1, "first here"));
        }
        // What contact elements measure stands with them.
        let line = given.deck.lines(entry.card).next().filter(|_| named);
        let mut measure = line.and_then(|line| Row::read(line, fields(entry), diagnostics).number(0));
        if let (Some(line), Some(_), Analysis::Explicit) = (line, measure, given.analysis) {
            measure = None;
            let note = Diagnostic::note(line.span, "this line has no effect in explicit steps");
            diagnostics.push(note.label("laws of nodes give forces, and planes have the thickness of their elements"));
        }
        let normal = NormalBehavior::Hard(Enforcement::Usual);
        let (friction, damping) = (None, None);
        self.list.push(Interaction {
            name,
            normal,
            scale_factor: None,
            no_separation: false,
            friction,
            damping,
            explicit_damping: None,
            stabilized_along: false,
            measure,
        });
        self.cards.push((entry.keyword.name, entry.card.span));
        self.steps.push(entry.step);
        self.described.push(BTreeMap::new());
    }

    /// Refuses a second card of a kind for one interaction.
    fn once(&mut self, i: usize, entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
        if let Some(first) = self.described[i].insert(entry.keyword.name, entry.card.span) {
            let title = format!("interaction `{}` has two `*{}`", self.list[i].name, entry.keyword.name);
            diagnostics.push(Diagnostic::error(entry.card.span, title).related(first, "first here"));
        }
    }

    fn describe(&mut self, i: usize, entry: &Entry<'_>, behavior: Option<(NormalBehavior, Option<Scaling>)>) {
        if let Some((behavior, scaling)) = behavior {
            self.list[i].no_separation = entry.has("NO SEPARATION");
            (self.list[i].normal, self.list[i].scale_factor) = (behavior, scaling);
        }
    }

    /// Index of a `*SURFACE INTERACTION` by name: the last of them.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.find_in(name, usize::MAX)
    }

    /// Index of what a step, from 0, finds under a name: what it defines, or an earlier step, or the model.
    pub fn find_in(&self, name: &str, step: usize) -> Option<usize> {
        let known = self.list.iter().zip(&self.cards).zip(&self.steps);
        let named = |((i, card), of): ((&Interaction, &(&str, Span)), &Option<usize>)| {
            card.0 == NAMED && i.name == name && of.is_none_or(|of| of <= step)
        };
        let found: Vec<bool> = known.map(named).collect();
        found.iter().rposition(|found| *found)
    }

    /// Index of the `*SURFACE INTERACTION` that a card's `INTERACTION=` names; a missing one is told.
    pub fn of_parameter(&self, entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<usize> {
        let value = entry.value("INTERACTION")?;
        let name = normalized(&value.text);
        let found = self.find(&name);
        if found.is_none() {
            let fault = Diagnostic::error(value.span, format!("there is no interaction `{name}`"));
            diagnostics.push(fault.known(&name, self.names()).help("say `*SURFACE INTERACTION, NAME=…`"));
        }
        found
    }

    /// Index by the place of the card.
    pub fn of_card(&self, at: Span) -> Option<usize> {
        self.cards.iter().position(|card| card.1 == at)
    }

    /// Names of those that have one.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.list.iter().zip(&self.cards).filter(|(_, card)| card.0 == NAMED).map(|(i, _)| i.name.as_str())
    }
}

/// The card that one of these belongs to; others of them may stand between.
fn parent<'a>(entry: &Entry<'_>, deck: &'a Deck) -> Option<&'a Card> {
    let at = deck.cards.iter().position(|card| card.span == entry.card.span)?;
    for card in deck.cards[..at].iter().rev() {
        match keyword::find(&card.keyword) {
            Some(Known::Card(table)) if PARENTS.contains(&table.name) => return Some(card),
            Some(Known::Card(table)) if DESCRIBING.contains(&table.name) => {}
            Some(Known::NotYet(..)) => {}
            _ => return None,
        }
    }
    None
}

/// What the card says, with the numbers of a law by scale factors; `None` when it is refused, which was told.
fn behavior(
    entry: &Entry<'_>,
    given: Given<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<(NormalBehavior, Option<Scaling>)> {
    let Given { deck, laws, size, analysis } = given;
    let before = diagnostics.faults();
    let overclosure = entry.name("PRESSURE-OVERCLOSURE").filter(|word| word != "HARD");
    let law = overclosure.as_deref().and_then(|word| laws.0.iter().find(|law| keyword::same(law.keyword, word)));
    exclusions(entry, overclosure.as_deref(), analysis, diagnostics);
    let behavior = match (&overclosure, law) {
        (Some(word), None) if keyword::same(word, "FORMULA") => formula::read(entry, deck, size, diagnostics),
        (Some(word), None) => {
            let scaling =
                if keyword::same(word, "SCALE FACTOR") { scale_factor(entry, given, diagnostics) } else { None };
            return scaling.map(|scaling| (NormalBehavior::Hard(Enforcement::Usual), Some(scaling)));
        }
        (Some(_), Some(law)) => softened(entry, given, law, diagnostics),
        (None, _) => hard::read(entry, deck, diagnostics),
    };
    behavior.filter(|_| diagnostics.faults() == before).map(|behavior| (behavior, None))
}

/// Words that cannot stand beside each other.
fn exclusions(entry: &Entry<'_>, softened: Option<&str>, analysis: Analysis, diagnostics: &mut Diagnostics) {
    if analysis == Analysis::Explicit {
        only_for(entry, &["PENALTY", "AUGMENTED LAGRANGE", "DIRECT"], Analysis::Static, diagnostics);
        let straight = softened.is_none_or(|law| ["LINEAR", "TABULAR"].contains(&law));
        if let (Some(parameter), Some(law), false) = (entry.parameter("NO SEPARATION"), softened, straight) {
            let title = format!("`NO SEPARATION` cannot be used with `PRESSURE-OVERCLOSURE={law}`");
            let fault = Diagnostic::error(parameter.span, title);
            diagnostics.push(fault.help("hard contact, LINEAR and TABULAR go on into tension"));
        }
        return;
    }
    if let (Some(parameter), Some(law)) = (entry.parameter("NO SEPARATION"), softened) {
        let title = "`NO SEPARATION` cannot be used with a softened `PRESSURE-OVERCLOSURE` in static steps";
        let fault = Diagnostic::error(parameter.span, title).label(format!("the law is `{law}`"));
        diagnostics.push(fault.help("a softened law lets surfaces separate: leave `NO SEPARATION` out"));
    }
    for way in ["PENALTY", "AUGMENTED LAGRANGE"] {
        if let (Some(parameter), Some(law)) = (entry.parameter(way), softened) {
            let title = format!("`{way}` is for hard contact, not for `PRESSURE-OVERCLOSURE={law}`");
            diagnostics.push(Diagnostic::error(parameter.span, title).help("a softened law needs no enforcement"));
        }
    }
    let ways = ["PENALTY", "AUGMENTED LAGRANGE", "DIRECT"].into_iter().filter_map(|name| entry.parameter(name));
    let ways: Vec<_> = ways.collect();
    if let [first, second, ..] = ways[..] {
        let fault = Diagnostic::error(second.span, "only one way to enforce hard contact can be used");
        diagnostics.push(fault.related(first.span, "another one"));
    }
}

/// Where surfaces may not part, a law must go on into tension from a pressure of 0.
fn jump(entry: &Entry<'_>, behavior: Option<&NormalBehavior>, diagnostics: &mut Diagnostics) {
    let (Some(parameter), Some(NormalBehavior::Softened(law))) = (entry.parameter("NO SEPARATION"), behavior) else {
        return;
    };
    let first = law.respond(law.reach()).pressure;
    if first > 0.0 {
        let title = "`NO SEPARATION` needs a law that begins with a pressure of 0";
        let fault = Diagnostic::error(parameter.span, title).label(format!("this one begins with {first}"));
        diagnostics
            .push(fault.help("give the table a first point of pressure 0: its first slope goes on into tension"));
    }
}

fn softened(
    entry: &Entry<'_>,
    Given { deck, size, analysis, .. }: Given<'_>,
    law: &LawDefinition,
    diagnostics: &mut Diagnostics,
) -> Option<NormalBehavior> {
    let fields: Vec<Field> = law.data.iter().map(of_law).collect();
    let (least, most) = match law.lines {
        Lines::One => (usize::from(fields.iter().any(|field| field.required)), 1),
        Lines::AtLeast(least) => (least, usize::MAX),
    };
    let mut lines = deck.lines(entry.card);
    let rows: Vec<Row> = lines.by_ref().take(most).map(|line| Row::read(line, &fields, diagnostics)).collect();
    too_many(lines.next(), diagnostics);
    if rows.len() < least {
        let wanted = names(&fields);
        let (needs, wanted) = match law.lines {
            Lines::One => ("a data line".into(), wanted),
            Lines::AtLeast(_) => (format!("{least} data lines or more"), wanted + " in each"),
        };
        let fault = Diagnostic::error(entry.card.span, format!("law `{}` needs {needs}", law.keyword));
        diagnostics.push(fault.help(format!("write: {wanted}")));
        return None;
    }
    let mut data: Vec<f64> = Vec::new();
    for row in &rows {
        data.extend(numbers(row, law, analysis, diagnostics)?);
    }
    if rows.is_empty() {
        data.extend(law.data.iter().filter_map(|datum| datum.default).map(|(value, _)| value));
    }
    let built = (law.build)(&data).map_err(|fault| Diagnostic::error(entry.card.span, of_the(law, &fault)));
    let built = built.map_err(|fault| diagnostics.push(fault)).ok()?;
    verified(entry, law.keyword, (built, size), diagnostics)
}

/// A law that keeps its word; what a user should know of it is told.
pub(super) fn verified(
    entry: &Entry<'_>,
    keyword: &str,
    (law, size): (Arc<dyn NormalLaw>, f64),
    diagnostics: &mut Diagnostics,
) -> Option<NormalBehavior> {
    let mut remarks = law.remarks();
    match verify::at_all_scales(&*law, size) {
        Ok(()) => {}
        // Laws that know where their pressure falls have said so.
        Err(LawFault::Softens { gap, .. }) if remarks.is_empty() => {
            remarks.push(format!("the pressure falls at a gap of {gap:e}: there may be several equilibria, or none"));
        }
        Err(LawFault::Softens { .. }) => {}
        Err(fault) => {
            let fault = Diagnostic::error(entry.card.span, format!("law `{keyword}` breaks its word: {fault}"));
            diagnostics.push(fault.help("energy, pressure and stiffness must be each the slope of the one before"));
            return None;
        }
    }
    for remark in remarks {
        diagnostics.push(Diagnostic::warning(entry.card.span, format!("law `{keyword}`: {remark}")));
    }
    Some(NormalBehavior::Softened(law))
}

fn of_the(law: &LawDefinition, words: &str) -> String {
    format!("law `{}`: {words}", law.keyword)
}

/// The numbers of a line; those for Explicit alone are remarked in static steps, and left at their default.
fn numbers(row: &Row<'_>, law: &LawDefinition, analysis: Analysis, diagnostics: &mut Diagnostics) -> Option<Vec<f64>> {
    let number = |(i, datum): (usize, &Datum)| {
        let default = datum.default.map(|(value, _)| value);
        match row.token(i) {
            Some(token) if datum.explicit && analysis == Analysis::Static => {
                let title = format!("the {} of law `{}` has an effect in Explicit only", datum.name, law.keyword);
                diagnostics.push(Diagnostic::note(token.span, title).label("static steps leave it out"));
                default
            }
            _ => row.number(i).or(default),
        }
    };
    row.sound.then(|| law.data.iter().enumerate().map(number).collect())?
}

/// The law by scale factors; in static steps it is refused by its name, with what else is wrong with it.
fn scale_factor(
    entry: &Entry<'_>,
    Given { deck, analysis, .. }: Given<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<Scaling> {
    let before = diagnostics.faults();
    if let (Some(value), Analysis::Static) = (entry.value("PRESSURE-OVERCLOSURE"), analysis) {
        let fault = Diagnostic::error(value.span, "`SCALE FACTOR` is for general contact in Explicit only");
        diagnostics.push(fault.help("for a static step take one of the other laws, say `PRESSURE-OVERCLOSURE=LINEAR`"));
    }
    let mut lines = deck.lines(entry.card);
    let Some(line) = lines.next() else {
        diagnostics.push(Diagnostic::error(entry.card.span, "law `SCALE FACTOR` needs a data line"));
        return None;
    };
    let row = Row::read(line, surface_behavior::SCALE_FACTOR, diagnostics);
    too_many(lines.next(), diagnostics);
    if !row.sound {
        return None;
    }
    let scale = row.number(2).unwrap_or_default();
    let scaling = Scaling::new(row.number(0), row.number(1), scale, row.number(3).unwrap_or(1.0));
    let told = |fault: String| diagnostics.push(Diagnostic::error(row.span, format!("law `SCALE FACTOR`: {fault}")));
    let scaling = scaling.map_err(told).ok();
    scaling.filter(|_| diagnostics.faults() == before)
}

/// Tells a second data line.
pub(super) fn too_many(line: Option<Line<'_>>, diagnostics: &mut Diagnostics) {
    line.into_iter().for_each(|line| diagnostics.push(too_many_lines("SURFACE BEHAVIOR", 1, line.span)));
}
