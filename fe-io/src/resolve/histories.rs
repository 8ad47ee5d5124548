//! Histories of explicit steps: `*OUTPUT, HISTORY` and the cards below it.

use super::requests::{intervals, set_name, unknown_key, without_marks};
use super::scene::{Analysis, Scene};
use super::which_pair;
use crate::deck::card::{Token, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::{Frames, History, HistoryOfSet, HistoryRequest};

/// Numbers that a row may hold: the names of the columns stand in the header of the array.
const MOST_COLUMNS: usize = 2000;

const ENERGIES: &[&str] =
    &["ALLKE", "ALLSE", "ALLPD", "ALLAE", "ALLIE", "ALLVD", "ALLFD", "ALLCW", "ALLWK", "DMASS", "ETOTAL"];
const RESULTANTS: &[&str] = &["CFN", "CFS", "CFT", "CMT", "CAREA"];
const NODAL: &[&str] = &["U", "U1", "U2", "U3", "V", "V1", "V2", "V3", "RF", "RF1", "RF2", "RF3"];
const OF_ELEMENTS: &[&str] = &["S", "S11", "S22", "S33", "S12", "S23", "S13", "MISES", "PEEQ"];
/// Components of a stress in the order of its fields.
const STRESS: &[&str] = &["11", "22", "33", "12", "23", "13"];

/// The requests in force: they hold until a step has an `*OUTPUT, HISTORY`.
#[derive(Clone, Debug, Default)]
pub struct Histories {
    /// `None` where no step has one yet.
    list: Option<Vec<HistoryRequest>>,
    when: Option<Frames>,
    /// Those at whose times increments end.
    marks: Vec<Frames>,
}

impl Histories {
    /// Reads an `*OUTPUT, HISTORY`, the `first` of its step or another.
    pub fn begin(&mut self, entry: &Entry<'_>, first: bool, diagnostics: &mut Diagnostics) {
        let when = intervals(entry, diagnostics).unwrap_or(Frames::HISTORY);
        self.when = Some(when);
        let list = self.list.get_or_insert_default();
        if first {
            list.clear();
            self.marks.clear();
        }
        without_marks(entry, when, diagnostics);
        self.marks.extend(Some(when).filter(|_| entry.says("TIME MARKS", "YES")));
        if entry.has("VARIABLE") {
            list.extend(USUAL.map(|of| HistoryRequest { of, when }));
        }
    }

    /// Reads a card that follows one, where it does.
    pub fn read(
        &mut self,
        entry: &Entry<'_>,
        follows: bool,
        (scene, pairs): (&mut Scene<'_>, &[[String; 2]]),
        diagnostics: &mut Diagnostics,
    ) {
        let star = entry.keyword.name;
        let (Some(when), true) = (self.when, follows) else {
            let fault = Diagnostic::error(entry.card.span, format!("`*{star}` follows `*OUTPUT, HISTORY`"));
            diagnostics.push(fault.help("write `*OUTPUT, HISTORY` before it"));
            return;
        };
        let before = diagnostics.faults();
        let known = match star {
            "NODE OUTPUT" => NODAL,
            "ELEMENT OUTPUT" => OF_ELEMENTS,
            "CONTACT OUTPUT" => RESULTANTS,
            _ => ENERGIES,
        };
        refuse_regions(entry, diagnostics);
        let when = entry.whole("FREQUENCY").map_or(when, |every| Frames::Increments(every as usize));
        let words = words(entry, known, scene, diagnostics);
        let of = match star {
            "ENERGY OUTPUT" => vec![History::Energies],
            "CONTACT OUTPUT" => {
                let pair = which_pair::surfaces(entry, diagnostics)
                    .and_then(|surfaces| which_pair::among(surfaces, pairs, scene, diagnostics));
                vec![History::Contact(pair.map(|at| pairs[at].clone()))]
            }
            _ => of_set(entry, &words, scene, diagnostics),
        };
        if diagnostics.faults() == before {
            self.list.get_or_insert_default().extend(of.into_iter().map(|of| HistoryRequest { of, when }));
        }
    }

    /// At the ends of these intervals increments end.
    pub fn marks(&self) -> &[Frames] {
        &self.marks
    }

    /// What holds in a step.
    pub fn in_force(&self, analysis: Analysis) -> Vec<HistoryRequest> {
        match analysis {
            Analysis::Static => Vec::new(),
            Analysis::Explicit => self
                .list
                .clone()
                .unwrap_or_else(|| USUAL.map(|of| HistoryRequest { of, when: Frames::HISTORY }).to_vec()),
        }
    }
}

/// Histories unless the deck says otherwise.
const USUAL: [History; 2] = [History::Energies, History::Contact(None)];

/// The words of a card; without one, or with `VARIABLE`, those that stand for all. Unknown ones are told.
fn words(
    entry: &Entry<'_>,
    known: &'static [&'static str],
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<&'static str> {
    let tokens = scene.deck.lines(entry.card).flat_map(|line| line.tokens());
    let tokens: Vec<Token<'_>> = tokens.filter(|token| !token.text.is_empty()).collect();
    if tokens.is_empty() && !entry.has("VARIABLE") {
        let fault = Diagnostic::error(entry.card.span, format!("this `*{}` asks for nothing", entry.keyword.name));
        diagnostics.push(fault.help(format!("add a line with {}", crate::diagnostic::listed(known))));
    }
    if entry.has("VARIABLE") {
        let whole = |word: &&&str| !word.ends_with(|c: char| c.is_ascii_digit());
        return known.iter().filter(whole).copied().collect();
    }
    let mut words = Vec::new();
    for token in tokens {
        let word = normalized(token.text);
        match known.iter().find(|known| **known == word) {
            Some(known) => words.push(*known),
            None => diagnostics.push(unknown_key(token, &word, entry, known)),
        }
    }
    words
}

/// Refuses regions that a card has no use for.
fn refuse_regions(entry: &Entry<'_>, diagnostics: &mut Diagnostics) {
    let own: &[&str] = match entry.keyword.name {
        "NODE OUTPUT" => &["NSET"],
        "ELEMENT OUTPUT" => &["ELSET"],
        _ => &["MAIN", "SECONDARY"],
    };
    let others = ["NSET", "ELSET", "MAIN", "SECONDARY"].into_iter().filter(|name| !own.contains(name));
    for other in others.filter_map(|name| entry.parameter(name)) {
        let title = format!("`{}` says nothing of a history by `*{}`", other.name, entry.keyword.name);
        let fault = Diagnostic::error(other.span, title);
        diagnostics.push(fault.help(format!("name what is meant by {}", crate::diagnostic::listed(own))));
    }
}

/// Histories of nodes or elements.
fn of_set(
    entry: &Entry<'_>,
    words: &[&'static str],
    scene: &mut Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<History> {
    let Some(set) = set_name(entry, scene, diagnostics) else { return Vec::new() };
    let is_nodal = entry.keyword.name == "NODE OUTPUT";
    let mesh = &scene.structure.mesh;
    let count = if is_nodal {
        mesh.node_sets.get(&set).map_or(0, Vec::len)
    } else {
        mesh.cell_sets.get(&set).map_or(0, Vec::len)
    };
    let mut all = Vec::new();
    for word in words {
        let field = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let component = Some(&word[field.len()..]).filter(|digits| !digits.is_empty());
        let place = |digits: &str| match is_nodal {
            true => digits.bytes().next().map_or(0, |digit| usize::from(digit - b'1')),
            false => STRESS.iter().position(|known| *known == digits).unwrap_or_default(),
        };
        let of = HistoryOfSet { set: set.clone(), field, component: component.map(place) };
        let width = match (field, of.component) {
            ("U" | "V" | "RF", None) => 3,
            ("S", None) => STRESS.len(),
            _ => 1,
        };
        if count * width > MOST_COLUMNS {
            let title = format!("a history of `{word}` here has {} numbers a row", count * width);
            let fault = Diagnostic::error(entry.card.span, title).label(format!("at most {MOST_COLUMNS} are there"));
            diagnostics.push(fault.help("name a smaller set, or store the field: `*OUTPUT, FIELD`"));
            return all;
        }
        all.push(if is_nodal { History::Nodes(of) } else { History::Elements(of) });
    }
    all
}
