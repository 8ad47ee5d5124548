//! What a step prints and stores.

use super::histories::Histories;
use super::procedures::only_for;
use super::scene::{Analysis, Scene};
use super::which_pair;
use crate::deck::card::{Token, normalized};
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::model::{ForcePart, Frames, Output, Quantity, Table, Totals};
use fe_core::element::Family;
use fe_mesh::CellId;
use std::collections::BTreeMap;

/// Set of all nodes, for requests without `NSET`.
const ALL_NODES: &str = "ALL NODES";
/// Set of all elements, for requests without `ELSET`.
const ALL_ELEMENTS: &str = "ALL ELEMENTS";

/// The requests in force. Those of one kind of card hold until a step has such a card.
#[derive(Clone, Debug, Default)]
pub struct Requests {
    /// Tables by kind of card, each with its turn in the deck.
    tables: BTreeMap<&'static str, Vec<(usize, Table)>>,
    /// Fields by kind of card.
    fields: BTreeMap<&'static str, Vec<String>>,
    /// True when the fields are not the usual ones.
    chosen: bool,
    frames: Option<Frames>,
    /// True when increments end at the times of frames.
    on_marks: bool,
    turn: usize,
    /// Kinds of cards seen in this step.
    seen: Vec<&'static str>,
    /// True after `*OUTPUT, HISTORY`.
    history: bool,
    histories: Histories,
    /// True after `*OUTPUT, VARIABLE=`: the cards below it add to these fields.
    preselected: bool,
}

impl Requests {
    /// A step begins.
    pub fn begin_step(&mut self) {
        self.seen.clear();
        self.history = false;
        self.preselected = false;
    }

    /// Reads one more card.
    pub fn read(
        &mut self,
        entry: &Entry<'_>,
        scene: &mut Scene<'_>,
        pairs: &[[String; 2]],
        diagnostics: &mut Diagnostics,
    ) {
        let kind = entry.keyword.name;
        if kind.ends_with("PRINT") {
            let first = self.first(kind);
            let tables = self.tables.entry(kind).or_default();
            if first {
                tables.clear();
            }
            for table in tables_of(entry, scene, pairs, diagnostics) {
                tables.push((self.turn, table));
                self.turn += 1;
            }
        } else if kind == "OUTPUT" {
            self.output(entry, scene, diagnostics);
        } else if (self.history || kind == "ENERGY OUTPUT") && kind.ends_with("OUTPUT") {
            if scene.analysis == Analysis::Explicit {
                self.histories.read(entry, self.history, (scene, pairs), diagnostics);
            }
        } else {
            self.fields(entry, scene, diagnostics);
        }
    }

    fn first(&mut self, kind: &'static str) -> bool {
        let first = !self.seen.contains(&kind);
        self.seen.push(kind);
        first
    }

    /// `*OUTPUT`.
    fn output(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        self.history = entry.has("HISTORY");
        if self.history && scene.analysis == Analysis::Explicit {
            let first = self.first("OUTPUT, HISTORY");
            return self.histories.begin(entry, first, diagnostics);
        }
        if self.history {
            let note = Diagnostic::note(entry.card.span, "`*OUTPUT, HISTORY` has no effect");
            diagnostics.push(note.label("`*NODE PRINT` and `*CONTACT PRINT` give curves"));
            return;
        }
        if self.first("OUTPUT") {
            self.fields.clear();
            self.chosen = false;
            self.frames = None;
            self.on_marks = false;
        }
        self.common(entry, KINDS, scene.analysis);
        if scene.analysis == Analysis::Static {
            only_for(entry, &["NUMBER INTERVAL", "TIME INTERVAL"], Analysis::Explicit, diagnostics);
        }
        self.frames = intervals(entry, diagnostics).or(self.frames);
        self.on_marks |= entry.says("TIME MARKS", "YES");
        let usual = usual(scene.analysis);
        without_marks(entry, self.frames.unwrap_or(usual), diagnostics);
        self.preselected = entry.has("VARIABLE");
    }

    /// `FREQUENCY` and `VARIABLE`: all fields of some kinds of cards.
    fn common(&mut self, entry: &Entry<'_>, kinds: &[&'static str], analysis: Analysis) {
        if let Some(every) = entry.whole("FREQUENCY") {
            self.frames = Some(Frames::Increments(every as usize));
        }
        if entry.has("VARIABLE") {
            for &kind in kinds {
                self.fields.insert(kind, known_fields(kind, analysis).iter().map(|f| (*f).to_owned()).collect());
            }
            self.chosen = true;
        }
    }

    fn fields(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        for region in ["NSET", "ELSET", "SECONDARY", "MAIN"].into_iter().filter_map(|name| entry.parameter(name)) {
            let title = format!("`{}` of `*{}` has no effect", region.name, entry.keyword.name);
            diagnostics.push(Diagnostic::note(region.span, title).label("fields are stored for the whole model"));
        }
        let kind = match entry.keyword.name {
            "NODE OUTPUT" | "NODE FILE" => "NODE",
            "ELEMENT OUTPUT" | "EL FILE" => "ELEMENT",
            _ => "CONTACT",
        };
        if self.first(kind) && !self.preselected {
            self.fields.remove(kind);
        }
        self.common(entry, &[kind], scene.analysis);
        let known = known_fields(kind, scene.analysis);
        for token in scene.deck.lines(entry.card).flat_map(|line| line.tokens()).filter(|t| !t.text.is_empty()) {
            let word = normalized(token.text);
            let word = full_name(&word);
            if known.contains(&word) {
                let fields = self.fields.entry(kind).or_default();
                if !fields.iter().any(|field| field == word) {
                    fields.push(word.to_owned());
                }
                self.chosen = true;
            } else {
                diagnostics.push(unknown_key(token, word, entry, known));
            }
        }
    }

    /// What the step prints and stores.
    pub fn in_force(&self, analysis: Analysis) -> Output {
        let mut tables: Vec<(usize, Table)> = self.tables.values().flatten().cloned().collect();
        tables.sort_by_key(|(turn, _)| *turn);
        let tables = tables.into_iter().map(|(_, table)| table).collect();
        let fields =
            self.chosen.then(|| KINDS.iter().filter_map(|kind| self.fields.get(kind)).flatten().cloned().collect());
        let frames = self.frames.unwrap_or(usual(analysis));
        let marks = self.histories.marks().iter().chain(self.on_marks.then_some(&frames)).copied().collect();
        Output { tables, fields, frames, marks, histories: self.histories.in_force(analysis) }
    }
}

/// Frames unless the deck says otherwise.
fn usual(analysis: Analysis) -> Frames {
    if analysis == Analysis::Explicit { Frames::EXPLICIT } else { Frames::Increments(1) }
}

/// Remarks on `TIME MARKS=YES` where increments are counted.
pub fn without_marks(entry: &Entry<'_>, when: Frames, diagnostics: &mut Diagnostics) {
    let given = entry.parameter("TIME MARKS").filter(|_| entry.says("TIME MARKS", "YES"));
    if let (Some(given), Frames::Increments(_)) = (given, when) {
        let note = Diagnostic::note(given.span, "`TIME MARKS=YES` of `*OUTPUT` has no effect");
        diagnostics.push(note.label("of use with NUMBER INTERVAL and TIME INTERVAL; here increments are counted"));
    }
}

/// `FREQUENCY`, `NUMBER INTERVAL` or `TIME INTERVAL` of an `*OUTPUT`.
pub fn intervals(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<Frames> {
    let names = ["FREQUENCY", "NUMBER INTERVAL", "TIME INTERVAL"];
    let given: Vec<_> = names.iter().filter_map(|name| Some((name, entry.parameter(name)?))).collect();
    if let [(one, first), (other, second), ..] = given[..] {
        let title = format!("`{other}` of `*OUTPUT` cannot be used with `{one}`");
        diagnostics.push(Diagnostic::error(second.span, title).related(first.span, "the other one"));
    }
    let mut positive = |name: &str| {
        let value = entry.value(name)?;
        let found = number(&value.text)?;
        if found <= 0.0 {
            diagnostics.push(Diagnostic::error(value.span, format!("`{name}` of `*OUTPUT` must be > 0")));
        }
        (found > 0.0).then_some(found)
    };
    let parts = positive("NUMBER INTERVAL").map(|parts| Frames::Parts(parts as usize));
    let times = positive("TIME INTERVAL").map(Frames::Time);
    times.or(parts).or(entry.whole("FREQUENCY").map(|every| Frames::Increments(every as usize)))
}

/// Kinds of cards that choose fields.
const KINDS: &[&str] = &["NODE", "ELEMENT", "CONTACT"];

/// Fields of the results file by the kind of card that asks for them.
fn known_fields(kind: &str, analysis: Analysis) -> &'static [&'static str] {
    match (kind, analysis) {
        ("NODE", Analysis::Static) => &["U", "RF"],
        ("NODE", Analysis::Explicit) => &["U", "V", "RF"],
        ("ELEMENT", Analysis::Static) => &["S", "E", "MISES", "SF", "SM"],
        ("ELEMENT", Analysis::Explicit) => &["S", "MISES", "PEEQ"],
        _ => &["CSTRESS", "CDISP", "CSTATUS", "CFORCE", "CNAREA"],
    }
}

/// Other spellings.
fn full_name(word: &str) -> &str {
    match word {
        "CSTR" | "CSTRE" => "CSTRESS",
        "CDIS" => "CDISP",
        other => other,
    }
}

/// Keys that decks know and this program does not.
const NOT_YET: &[&str] = &[
    "V", "A", "E", "SF", "SM", "NT", "NT11", "RFL", "RFL11", "TSF", "TF", "RM", "UR", "UT", "COORD", "POR", "PEEQ",
    "PE", "LE", "EE", "NE", "ME", "THE", "SDV", "ENER", "EVOL", "ELSE", "ELKE", "EMAS", "EBHE", "SENER", "HFL", "SINV",
    "SP", "EP", "PEMAG", "PEQC", "CELS", "CNUM", "CAREA", "CDSTRESS", "PCON", "PHS", "MAXE", "ZZS", "ERR", "KEQ",
    "CFT", "CM", "CMN", "CMS", "CMT", "XN", "XS", "XT", "CTRQ", "ALLCD", "ALLCCDW", "ALLDC", "ALLDMD", "ALLEE",
    "ALLHF", "ALLIHE", "ALLMW", "ALLPW", "SOF", "SOM", "SOAREA", "STATUS", "VOLC", "SDEG", "ZZSERR",
];

pub fn unknown_key(token: Token<'_>, word: &str, entry: &Entry<'_>, known: &[&str]) -> Diagnostic {
    let star = entry.keyword.name;
    if NOT_YET.contains(&word) {
        let fault = Diagnostic::error(token.span, format!("`{word}` of `*{star}` is not there yet"));
        return fault.help(format!("there is {}", crate::diagnostic::listed(known)));
    }
    Diagnostic::error(token.span, format!("`*{star}` knows no `{word}`")).known(word, known.iter().copied())
}

/// The quantity of a key.
fn quantity(star: &str, word: &str, pair: Option<[String; 2]>) -> Option<Quantity> {
    Some(match (star, word) {
        ("NODE PRINT", "U") => Quantity::Displacement,
        ("NODE PRINT", "V") => Quantity::Velocity,
        ("NODE PRINT", "RF") => Quantity::Reaction,
        ("EL PRINT", "S") => Quantity::Stress,
        ("EL PRINT", "E") => Quantity::Strain,
        ("CONTACT PRINT", "CSTRESS") => Quantity::ContactStress,
        ("CONTACT PRINT", "CDISP") => Quantity::ContactDisplacement,
        ("CONTACT PRINT", "CF") => Quantity::ContactForce { pair, part: ForcePart::Total },
        ("CONTACT PRINT", "CFN") => Quantity::ContactForce { pair, part: ForcePart::Normal },
        ("CONTACT PRINT", "CFS") => Quantity::ContactForce { pair, part: ForcePart::Shear },
        _ => return None,
    })
}

fn tables_of(
    entry: &Entry<'_>,
    scene: &mut Scene<'_>,
    pairs: &[[String; 2]],
    diagnostics: &mut Diagnostics,
) -> Vec<Table> {
    let star = entry.keyword.name;
    let known: &[&str] = match star {
        "NODE PRINT" if scene.analysis == Analysis::Explicit => &["U", "V", "RF"],
        "NODE PRINT" => &["U", "RF"],
        "EL PRINT" if scene.analysis == Analysis::Explicit => &["S"],
        "EL PRINT" => &["S", "E"],
        _ => &["CSTRESS", "CDISP", "CF", "CFN", "CFS"],
    };
    let Some(set) = set_name(entry, scene, diagnostics) else { return Vec::new() };
    let surfaces = which_pair::surfaces(entry, diagnostics);
    let pair = surfaces.and_then(|surfaces| which_pair::among(surfaces, pairs, scene, diagnostics));
    let pair = pair.map(|at| pairs[at].clone());
    // Explicit steps have too many increments for a table of each.
    let usual = if scene.analysis == Analysis::Explicit { Frames::LAST } else { Frames::Increments(1) };
    let when = entry.whole("FREQUENCY").map_or(usual, |n| Frames::Increments(n as usize));
    if entry.whole("FREQUENCY") == Some(0) {
        return Vec::new();
    }
    let totals = match entry.name("TOTALS").as_deref() {
        Some("YES") => Totals::Yes,
        Some("ONLY") => Totals::Only,
        _ => Totals::No,
    };
    let mut tables = Vec::new();
    let tokens = scene.deck.lines(entry.card).flat_map(|line| line.tokens());
    for token in tokens.filter(|token| !token.text.is_empty()) {
        let word = normalized(token.text);
        let word = full_name(&word);
        let Some(quantity) = quantity(star, word, pair.clone()).filter(|_| known.contains(&word)) else {
            diagnostics.push(unknown_key(token, word, entry, known));
            continue;
        };
        let totals = if quantity == Quantity::Reaction { totals } else { Totals::No };
        tables.push(Table { quantity, set: set.clone(), when, totals });
    }
    if !tables.is_empty() {
        without_effect(entry, &tables, diagnostics);
    }
    let bare = |cell: &&CellId| scene.element_of(**cell).family() == Family::Beam;
    if star == "EL PRINT"
        && let Some(beam) = scene.structure.mesh.cell_sets.get(&set).and_then(|cells| cells.iter().find(bare))
    {
        let title = format!("{} elements print no stresses", scene.element_of(*beam).name());
        let note = Diagnostic::note(entry.card.span, title).label("left out of this table");
        diagnostics.push(note.help("section forces SF and SM stand in the results file"));
    }
    let elements = scene.structure.elements.iter().any(|e| matches!(e.family(), Family::Gap | Family::Tube));
    let without = pairs.is_empty() && scene.analysis == Analysis::Static;
    if star == "CONTACT PRINT" && without && !elements && diagnostics.faults() == 0 {
        let warning = Diagnostic::warning(entry.card.span, "the deck has no contact pair");
        diagnostics.push(warning.label("these tables stay empty"));
    }
    if tables.is_empty() && diagnostics.faults() == 0 {
        let fault = Diagnostic::error(entry.card.span, format!("this `*{star}` asks for nothing"));
        diagnostics.push(fault.help(format!("add a line with {}", crate::diagnostic::listed(known))));
    }
    tables
}

/// Parameters that change none of the tables: only reactions have a sum that means something, contact forces are sums
/// already, and only these are told pair by pair.
fn without_effect(entry: &Entry<'_>, tables: &[Table], diagnostics: &mut Diagnostics) {
    let star = entry.keyword.name;
    let mut note = |parameter: &str, why: &str| {
        let note = Diagnostic::note(entry.card.span, format!("`{parameter}` of this `*{star}` has no effect"));
        diagnostics.push(note.label(why));
    };
    let totals = entry.has("TOTALS") && !entry.says("TOTALS", "NO");
    if totals && !tables.iter().any(|table| table.quantity == Quantity::Reaction) {
        note("TOTALS", if star == "NODE PRINT" { "only reactions are summed" } else { "CF is a sum already" });
    }
    let of_one_pair = |table: &Table| matches!(table.quantity, Quantity::ContactForce { .. });
    if entry.has("MAIN") && !tables.iter().any(of_one_pair) {
        note("MAIN", "CSTRESS and CDISP hold the nodes of all pairs");
    }
}

/// Name of the set of a table; empty for contact; `None` when it is not there, which is told.
pub fn set_name(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Option<String> {
    let parameter = match entry.keyword.name {
        "NODE PRINT" | "NODE OUTPUT" => "NSET",
        "EL PRINT" | "ELEMENT OUTPUT" => "ELSET",
        _ => return Some(String::new()),
    };
    let Some(value) = entry.value(parameter) else {
        let mesh = &mut scene.structure.mesh;
        if parameter == "NSET" {
            let all = (0..mesh.points.len() as u32).collect();
            mesh.node_sets.entry(ALL_NODES.to_owned()).or_insert(all);
            return Some(ALL_NODES.to_owned());
        }
        let all = mesh.cells().collect();
        mesh.cell_sets.entry(ALL_ELEMENTS.to_owned()).or_insert(all);
        return Some(ALL_ELEMENTS.to_owned());
    };
    let token = Token { text: &value.text, span: value.span };
    let there = match parameter {
        "NSET" => scene.set(&scene.structure.mesh.node_sets, "node set", token, diagnostics).is_some(),
        _ => scene.cell_set(token, diagnostics).is_some(),
    };
    there.then(|| scene.full_name(&value.text))
}
