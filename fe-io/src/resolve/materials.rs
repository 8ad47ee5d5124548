//! `*MATERIAL` with its cards.

use super::nodes::fields;
use super::scene::Scene;
use crate::deck::card::normalized;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::material::{Elastic, Material};
use std::collections::BTreeMap;

/// A material while it is read.
#[derive(Debug)]
struct Draft {
    name: String,
    at: Span,
    elastic: Option<(Elastic, Span)>,
    density: Option<f64>,
    faulty: bool,
}

/// Materials by name: index into the structure's, or `None` for one that is faulty, which was told.
pub type Materials = BTreeMap<String, Option<usize>>;

/// Reads materials, in the order of the deck.
pub fn read(entries: &[Entry<'_>], scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Materials {
    let mut drafts: Vec<Draft> = Vec::new();
    for entry in entries {
        if entry.keyword.name == "MATERIAL" {
            drafts.extend(begin(entry, &drafts, diagnostics));
            continue;
        }
        let before = diagnostics.faults();
        let row = one_line(entry, scene, diagnostics);
        let Some(draft) = drafts.last_mut() else {
            let title = format!("`*{}` stands under no `*MATERIAL`", entry.keyword.name);
            diagnostics.push(Diagnostic::error(entry.card.span, title));
            continue;
        };
        match (entry.keyword.name, row) {
            ("ELASTIC", Some(row)) => {
                let elastic = row.number(0).map(|young| Elastic { young, poisson: row.number(1).unwrap_or(0.0) });
                draft.elastic = elastic.map(|elastic| (elastic, row.span));
            }
            (_, Some(row)) => draft.density = row.number(0),
            (_, None) => {}
        }
        draft.faulty |= diagnostics.faults() > before;
    }
    drafts.into_iter().map(|draft| finish(draft, scene, diagnostics)).collect()
}

fn begin(entry: &Entry<'_>, drafts: &[Draft], diagnostics: &mut Diagnostics) -> Option<Draft> {
    let value = entry.value("NAME")?;
    let name = normalized(&value.text);
    if let Some(first) = drafts.iter().find(|draft| draft.name == name) {
        let fault = Diagnostic::error(value.span, format!("material `{name}` is there twice"));
        diagnostics.push(fault.related(first.at, "first here"));
    }
    Some(Draft { name, at: value.span, elastic: None, density: None, faulty: false })
}

/// The one data line of a material's card.
fn one_line<'a>(entry: &Entry<'a>, scene: &Scene<'a>, diagnostics: &mut Diagnostics) -> Option<Row<'a>> {
    let mut lines = scene.deck.lines(entry.card);
    let Some(line) = lines.next() else {
        let title = format!("`*{}` has no data line", entry.keyword.name);
        let wanted: Vec<&str> = fields(entry).iter().map(|field| field.name).collect();
        diagnostics.push(Diagnostic::error(entry.card.span, title).help(format!("write: {}", wanted.join(", "))));
        return None;
    };
    let row = Row::read(line, fields(entry), diagnostics);
    if let Some(more) = lines.next() {
        let title = format!("more than one line under `*{}` is not there yet", entry.keyword.name);
        diagnostics.push(Diagnostic::error(more.span, title).help("there are no temperatures: give one line"));
    }
    row.sound.then_some(row)
}

fn finish(draft: Draft, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> (String, Option<usize>) {
    if draft.faulty {
        return (draft.name, None);
    }
    let Some((elastic, _)) = draft.elastic else {
        let fault = Diagnostic::error(draft.at, format!("material `{}` has no `*ELASTIC`", draft.name));
        diagnostics.push(fault);
        return (draft.name, None);
    };
    scene.structure.materials.push(Material { name: draft.name.clone(), elastic, density: draft.density });
    (draft.name, Some(scene.structure.materials.len() - 1))
}
