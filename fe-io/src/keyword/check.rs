//! Keyword lines against their tables: names, parameters, values, levels.

use super::place::Places;
use super::table::{Choice, Keyword, Kind, Standing};
use super::{Known, find, names, same};
use crate::deck::Deck;
use crate::deck::card::{Card, Parameter, Value, normalized};
use crate::deck::number::{number, whole};
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use fe_contact::law::Laws;

/// A card that is known and in its place.
#[derive(Clone, Copy, Debug)]
pub struct Entry<'a> {
    /// As written.
    pub card: &'a Card,
    /// Its table.
    pub keyword: &'static Keyword,
    /// Number of the step it stands in, from 0.
    pub step: Option<usize>,
    /// The `*PART` or the `*INSTANCE` that it stands in.
    pub block: Option<&'a Card>,
    /// Whose labels and names it means: an index into the scopes of the scene, the model's first.
    pub scope: usize,
}

impl<'a> Entry<'a> {
    /// A parameter by its name in the table.
    pub fn parameter(&self, name: &str) -> Option<&'a Parameter> {
        let alias = self.keyword.parameters.iter().find(|p| p.name == name).and_then(|p| p.alias);
        let named = |p: &&Parameter| same(&p.name, name) || alias.is_some_and(|alias| same(&p.name, alias));
        self.card.parameters.iter().find(named)
    }

    /// True when the parameter is there.
    pub fn has(&self, name: &str) -> bool {
        self.parameter(name).is_some()
    }

    /// A parameter's value as written.
    pub fn value(&self, name: &str) -> Option<&'a Value> {
        self.parameter(name)?.value.as_ref()
    }

    /// A parameter's value, capitals.
    pub fn name(&self, name: &str) -> Option<String> {
        self.value(name).map(|value| normalized(&value.text))
    }

    /// True when a parameter has this word.
    pub fn says(&self, name: &str, word: &str) -> bool {
        self.name(name).is_some_and(|value| same(&value, word))
    }

    /// A parameter's whole number.
    pub fn whole(&self, name: &str) -> Option<u64> {
        whole(&self.value(name)?.text)
    }
}

/// All cards that are read, in order; what is wrong with the others and with their parameters is told.
pub fn check<'a>(deck: &'a Deck, laws: &Laws, diagnostics: &mut Diagnostics) -> Vec<Entry<'a>> {
    let mut entries = Vec::new();
    let mut places = Places::of(deck);
    for card in &deck.cards {
        match find(&card.keyword) {
            None => {
                let fault = Diagnostic::error(card.span, format!("`*{}` is not a known card", card.keyword));
                let fault = fault.known(&card.keyword, names());
                diagnostics.push(fault.help("`fe keywords` lists the cards; abbreviations are not taken"));
            }
            Some(Known::NotYet(name, instead)) => {
                diagnostics.push(Diagnostic::error(card.span, format!("`*{name}` is not there yet")).help(instead));
            }
            Some(Known::Idle(name, why)) => {
                diagnostics.push(Diagnostic::note(card.span, format!("`*{name}` has no effect")).label(why));
            }
            Some(Known::Card(keyword)) => {
                let place = places.enter(card, keyword, diagnostics);
                let entry = Entry { card, keyword, step: place.step, block: place.block, scope: 0 };
                parameters(&entry, laws, diagnostics);
                surplus(&entry, deck, diagnostics);
                entries.push(entry);
            }
        }
    }
    places.end(diagnostics);
    entries
}

fn parameters(entry: &Entry<'_>, laws: &Laws, diagnostics: &mut Diagnostics) {
    let star = entry.keyword.name;
    let mut seen: Vec<&Parameter> = Vec::new();
    for written in &entry.card.parameters {
        let table = entry.keyword.parameters;
        let known =
            table.iter().find(|p| same(p.name, &written.name) || p.alias.is_some_and(|a| same(a, &written.name)));
        let Some(known) = known else {
            diagnostics.push(unknown_parameter(entry, written));
            continue;
        };
        if let Some(first) = seen.iter().find(|first| same(&first.name, &written.name)) {
            let fault = Diagnostic::error(written.span, format!("`{}` is given twice on `*{star}`", known.name));
            diagnostics.push(fault.related(first.span, "first here"));
        }
        seen.push(written);
        match known.standing {
            Standing::NotYet(instead) => {
                let fault = Diagnostic::error(written.span, format!("`{}` of `*{star}` is not there yet", known.name));
                diagnostics.push(fault.help(instead));
            }
            Standing::Idle(why) => {
                let note = Diagnostic::note(written.span, format!("`{}` of `*{star}` has no effect", known.name));
                diagnostics.push(note.label(why));
            }
            Standing::Silent => {}
            Standing::There => value(star, known.name, known.kind, written, laws, diagnostics),
        }
    }
    for missing in entry.keyword.parameters.iter().filter(|p| p.required && !entry.has(p.name)) {
        let fault = Diagnostic::error(entry.card.span, format!("`*{star}` needs `{}=`", missing.name));
        diagnostics.push(fault.label(missing.meaning));
    }
}

/// Tells a data line that the card cannot have, whatever its parameters say.
fn surplus(entry: &Entry<'_>, deck: &Deck, diagnostics: &mut Diagnostics) {
    let Some(most) = entry.keyword.data.most() else { return };
    let Some(line) = deck.lines(entry.card).nth(most) else { return };
    diagnostics.push(too_many_lines(entry.keyword.name, most, line.span));
}

/// The fault of a data line beyond those that a card has.
pub fn too_many_lines(star: &str, most: usize, at: Span) -> Diagnostic {
    let has = match most {
        0 => "no data lines".into(),
        1 => "one data line".into(),
        n => format!("{n} data lines at most"),
    };
    Diagnostic::error(at, format!("`*{star}` has {has} here")).label("one too many")
}

fn unknown_parameter(entry: &Entry<'_>, written: &Parameter) -> Diagnostic {
    let star = entry.keyword.name;
    let fault = Diagnostic::error(written.span, format!("`*{star}` has no parameter `{}`", written.name));
    let there = entry.keyword.parameters.iter().filter(|p| p.standing == Standing::There).map(|p| p.name);
    let fault = match crate::deck::nearest::nearest(&written.name, entry.keyword.parameters.iter().map(|p| p.name)) {
        Some(near) => fault.label(format!("did you mean `{near}`?")),
        None => fault.known("", there),
    };
    match written.span.source == entry.card.span.source && written.span.start > entry.card.span.end {
        true if written.value.is_none() && entry.card.parameters.len() > 1 => {
            fault.help("a keyword line that ends with a comma goes on in the next line")
        }
        _ => fault,
    }
}

fn value(star: &str, name: &str, kind: Kind, written: &Parameter, laws: &Laws, diagnostics: &mut Diagnostics) {
    let Some(value) = written.value.as_ref().filter(|v| !v.text.is_empty()) else {
        if !matches!(kind, Kind::Flag | Kind::Any | Kind::OptionalChoice(_)) {
            let fault = Diagnostic::error(written.span, format!("`{name}` of `*{star}` needs a value: `{name}=…`"));
            diagnostics.push(fault);
        }
        if let Kind::OptionalChoice([Choice { standing: Standing::NotYet(instead), .. }, ..]) = kind {
            let fault = Diagnostic::error(written.span, format!("`{name}` of `*{star}` is not there yet"));
            diagnostics.push(fault.help(*instead));
        }
        return;
    };
    let wrong = |what: &str| {
        Diagnostic::error(value.span, format!("`{}` is not {what}", value.text)).label(format!("`{name}` of `*{star}`"))
    };
    match kind {
        Kind::Flag => diagnostics.push(Diagnostic::error(value.span, format!("`{name}` of `*{star}` takes no value"))),
        Kind::Number if number(&value.text).is_none() => diagnostics.push(wrong("a number")),
        Kind::Whole if whole(&value.text).is_none() => diagnostics.push(wrong("a whole number")),
        Kind::Choice(words) | Kind::OptionalChoice(words) => choice(star, name, words, &[], value, diagnostics),
        Kind::Law(words) => {
            let mut there = vec!["HARD"];
            there.extend(laws.0.iter().map(|law| law.keyword));
            choice(star, name, words, &there, value, diagnostics);
        }
        Kind::Any | Kind::Name | Kind::Text | Kind::Number | Kind::Whole => {}
    }
}

/// One of some words; those of `there` come first.
fn choice(star: &str, name: &str, words: &[Choice], there: &[&str], value: &Value, diagnostics: &mut Diagnostics) {
    let word = normalized(&value.text);
    if there.iter().any(|t| same(t, &word)) {
        return;
    }
    match words.iter().find(|choice| same(choice.word, &word)) {
        Some(Choice { standing: Standing::NotYet(instead), word }) => {
            let fault = Diagnostic::error(value.span, format!("`{name}={word}` of `*{star}` is not there yet"));
            diagnostics.push(fault.help(*instead));
        }
        Some(_) => {}
        None => {
            let known = words.iter().filter(|c| c.standing == Standing::There).map(|c| c.word);
            let known: Vec<&str> = there.iter().copied().chain(known).collect();
            let fault = Diagnostic::error(value.span, format!("`{name}` of `*{star}` cannot be `{}`", value.text));
            diagnostics.push(fault.known(&word, known));
        }
    }
}
