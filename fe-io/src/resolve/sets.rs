//! `*NSET` and `*ELSET`.

use super::labels::Labels;
use super::lines::line_fields;
use super::scene::Scene;
use crate::deck::card::{Line, Token};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_mesh::CellId;
use std::collections::BTreeMap;

/// Reads a node set.
pub fn nodes(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(name) = name(entry, scene, diagnostics) else { return };
    let mut members = of_elements(entry, scene, diagnostics);
    for line in scene.deck.lines(entry.card) {
        if entry.has("GENERATE") {
            members.extend(generated(entry, line, &scene.scopes[scene.inside].nodes, diagnostics));
        } else {
            let tokens = line.tokens().filter(|token| !token.text.is_empty());
            members.extend(tokens.filter_map(|token| node_or_set(token, scene, diagnostics)).flatten());
        }
    }
    add(entry, name, members, &mut scene.structure.mesh.node_sets, diagnostics);
}

/// Reads an element set.
pub fn cells(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(name) = name(entry, scene, diagnostics) else { return };
    let mut members = Vec::new();
    for line in scene.deck.lines(entry.card) {
        if entry.has("GENERATE") {
            let ordinals = generated(entry, line, &scene.scopes[scene.inside].elements, diagnostics);
            members.extend(ordinals.into_iter().map(|ordinal| scene.cells[ordinal as usize]));
        } else {
            let tokens = line.tokens().filter(|token| !token.text.is_empty());
            members.extend(tokens.filter_map(|token| scene.cells_of(token, diagnostics)).flatten());
        }
    }
    add(entry, name, members, &mut scene.structure.mesh.cell_sets, diagnostics);
}

/// Full name of a set; from here on its members are looked up in the instance that the card names.
fn name(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Option<String> {
    // `*NSET, NSET=` and `*ELSET, ELSET=`.
    let parameter = entry.keyword.name;
    let name = scene.new_name(entry.value(parameter)?, diagnostics)?;
    if let Some(value) = entry.value("INSTANCE") {
        let token = Token { text: &value.text, span: value.span };
        if scene.reading > 0 {
            let fault = Diagnostic::error(value.span, format!("`INSTANCE` of `*{parameter}` is for the assembly"));
            diagnostics.push(fault.label("this set belongs to the part or instance it stands in"));
            return None;
        }
        scene.inside = scene.instance(token, diagnostics)?;
    }
    Some(name)
}

/// Sets in ascending order, each member once.
pub fn sort(scene: &mut Scene<'_>) {
    let mesh = &mut scene.structure.mesh;
    for set in mesh.node_sets.values_mut() {
        set.sort_unstable();
        set.dedup();
    }
    for set in mesh.cell_sets.values_mut() {
        set.sort_unstable();
        set.dedup();
    }
}

/// One label stands for itself without a list of its own: sets of many labels are read quickly.
fn node_or_set(token: Token<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Members<u32>> {
    match scene.label(token.text) {
        Some(label) => scene.node(token, label, diagnostics).map(|node| Members { one: Some(node), more: Vec::new() }),
        None => scene.nodes_of(token, diagnostics).map(|more| Members { one: None, more }),
    }
}

struct Members<T> {
    one: Option<T>,
    more: Vec<T>,
}

impl<T> IntoIterator for Members<T> {
    type Item = T;
    type IntoIter = std::iter::Chain<std::option::IntoIter<T>, std::vec::IntoIter<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.one.into_iter().chain(self.more)
    }
}

/// `*NSET, ELSET=`: the nodes of the elements.
fn of_elements(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Vec<u32> {
    let Some(value) = entry.value("ELSET") else { return Vec::new() };
    let token = Token { text: &value.text, span: value.span };
    let cells: Vec<CellId> = scene.cells_of(token, diagnostics).unwrap_or_default();
    cells.iter().flat_map(|&cell| scene.structure.mesh.cell(cell)).copied().collect()
}

/// `GENERATE`: first, last, step; the indices of these labels. Labels that are not there are left out, which is
/// remarked.
pub fn generated(entry: &Entry<'_>, line: Line<'_>, labels: &Labels, diagnostics: &mut Diagnostics) -> Vec<u32> {
    let row = Row::read(line, line_fields(entry, 1), diagnostics);
    let (Some(first), Some(last), true) = (row.whole(0), row.whole(1), row.sound) else { return Vec::new() };
    let step = row.whole(2).unwrap_or(1);
    if last < first || step == 0 {
        let fault = Diagnostic::error(line.span, "nothing lies between these labels");
        diagnostics.push(fault.help("write: first label, last label, step (1 when blank)"));
        return Vec::new();
    }
    let wanted = (last - first) / step + 1;
    let found: Vec<u32> = if wanted > labels.count() as u64 {
        let asked = |label: &u64| (first..=last).contains(label) && (label - first).is_multiple_of(step);
        labels.ascending().into_iter().filter(asked).filter_map(|label| labels.get(label)).collect()
    } else {
        (0..wanted).filter_map(|i| labels.get(first + i * step)).collect()
    };
    if found.is_empty() {
        diagnostics.push(Diagnostic::error(line.span, "none of these labels is there"));
    } else if (found.len() as u64) < wanted {
        let missing = wanted - found.len() as u64;
        diagnostics.push(Diagnostic::warning(line.span, format!("{missing} of these labels are not there")));
    }
    found
}

fn add<T>(
    entry: &Entry<'_>,
    name: String,
    members: Vec<T>,
    sets: &mut BTreeMap<String, Vec<T>>,
    diagnostics: &mut Diagnostics,
) {
    let written = entry.name(entry.keyword.name).unwrap_or_default();
    if members.is_empty() && diagnostics.faults() == 0 {
        diagnostics.push(Diagnostic::warning(entry.card.span, format!("set `{written}` gets nothing from this card")));
    }
    if written.starts_with(|c: char| c.is_ascii_digit()) {
        let fault = Diagnostic::error(entry.card.span, format!("set name `{written}` begins with a digit"));
        diagnostics.push(fault.help("names of sets begin with a letter, so that labels can be told from them"));
    }
    sets.entry(name).or_default().extend(members);
}
