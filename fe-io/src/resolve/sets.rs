//! `*NSET` and `*ELSET`.

use super::nodes::line_fields;
use super::scene::Scene;
use crate::deck::card::{Line, Token};
use crate::deck::number::whole;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_mesh::CellId;
use std::collections::BTreeMap;

/// Reads a node set.
pub fn nodes(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(name) = entry.name("NSET") else { return };
    let mut members = of_elements(entry, scene, diagnostics);
    for line in scene.deck.lines(entry.card) {
        if entry.has("GENERATE") {
            let labels = &scene.structure.mesh.point_labels;
            let of_label = |label| scene.nodes.get(label);
            members.extend(generated(entry, line, labels.iter().copied(), of_label, diagnostics));
        } else {
            let tokens = line.tokens().filter(|token| !token.text.is_empty());
            members.extend(tokens.filter_map(|token| node_or_set(token, scene, diagnostics)).flatten());
        }
    }
    add(entry, name, members, &mut scene.structure.mesh.node_sets, diagnostics);
}

/// Reads an element set.
pub fn cells(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(name) = entry.name("ELSET") else { return };
    let mut members = Vec::new();
    for line in scene.deck.lines(entry.card) {
        if entry.has("GENERATE") {
            let mesh = &scene.structure.mesh;
            let of_label = |label| scene.elements.get(label).map(|i| scene.cells[i as usize]);
            let labels = mesh.blocks.iter().flat_map(|block| block.labels.iter().copied());
            members.extend(generated(entry, line, labels, of_label, diagnostics));
        } else {
            let tokens = line.tokens().filter(|token| !token.text.is_empty());
            members.extend(tokens.filter_map(|token| scene.cells_of(token, diagnostics)).flatten());
        }
    }
    add(entry, name, members, &mut scene.structure.mesh.cell_sets, diagnostics);
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
    match whole(token.text) {
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

/// `GENERATE`: first, last, step. Labels that are not there are left out, which is remarked.
fn generated<T>(
    entry: &Entry<'_>,
    line: Line<'_>,
    all: impl Iterator<Item = u64> + Clone,
    of_label: impl Fn(u64) -> Option<T>,
    diagnostics: &mut Diagnostics,
) -> Vec<T> {
    let row = Row::read(line, line_fields(entry, 1), diagnostics);
    let (Some(first), Some(last), true) = (row.whole(0), row.whole(1), row.sound) else { return Vec::new() };
    let step = row.whole(2).unwrap_or(1);
    if last < first || step == 0 {
        let fault = Diagnostic::error(line.span, "nothing lies between these labels");
        diagnostics.push(fault.help("write: first label, last label, step (1 when blank)"));
        return Vec::new();
    }
    let wanted = (last - first) / step + 1;
    let found: Vec<T> = if wanted as usize > all.clone().count() {
        let mut labels: Vec<u64> = all.filter(|l| (first..=last).contains(l) && (l - first) % step == 0).collect();
        labels.sort_unstable();
        labels.into_iter().filter_map(&of_label).collect()
    } else {
        (0..wanted).filter_map(|i| of_label(first + i * step)).collect()
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
    if members.is_empty() && diagnostics.faults() == 0 {
        diagnostics.push(Diagnostic::warning(entry.card.span, format!("set `{name}` gets nothing from this card")));
    }
    if name.starts_with(|c: char| c.is_ascii_digit()) {
        let fault = Diagnostic::error(entry.card.span, format!("set name `{name}` begins with a digit"));
        diagnostics.push(fault.help("names of sets begin with a letter, so that labels can be told from them"));
    }
    sets.entry(name).or_default().extend(members);
}
