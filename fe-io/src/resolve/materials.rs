//! `*MATERIAL` with its cards.

use super::lines::{fields, one_line};
use super::scene::{Analysis, Scene};
use crate::deck::card::normalized;
use crate::deck::number::number;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_core::material::{Damping, Elastic, Hardening, Material, NeoHooke, Response};
use std::collections::BTreeMap;

/// The cards: the material, and what describes it.
pub const CARDS: &[&str] = &["MATERIAL", "ELASTIC", "PLASTIC", "HYPERELASTIC", "DENSITY", "DAMPING"];

/// Bulk over shear modulus of a hyperelastic material without D1: as Abaqus/Explicit, Analysis User's Guide,
/// Hyperelastic behavior of rubberlike materials.
const BULK_OVER_SHEAR: f64 = 20.0;

/// A material while it is read.
#[derive(Debug)]
struct Draft {
    name: String,
    at: Span,
    elastic: Option<Elastic>,
    hardening: Option<Hardening>,
    hyperelastic: Option<NeoHooke>,
    density: Option<f64>,
    damping: Damping,
    /// Places of its cards, by keyword.
    cards: BTreeMap<&'static str, Span>,
    faulty: bool,
}

/// Materials by name: index into the structure's, or `None` for one that is faulty, which was told.
pub type Materials = BTreeMap<String, Option<usize>>;

/// Reads materials, in the order of the deck.
pub fn read(entries: &[Entry<'_>], scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> Materials {
    let mut drafts: Vec<Draft> = Vec::new();
    for entry in entries {
        let keyword = entry.keyword.name;
        if keyword == "MATERIAL" {
            drafts.extend(begin(entry, &drafts, diagnostics));
            continue;
        }
        let Some(draft) = drafts.last_mut() else {
            let title = format!("`*{keyword}` stands under no `*MATERIAL`");
            diagnostics.push(Diagnostic::error(entry.card.span, title));
            continue;
        };
        let before = diagnostics.faults();
        if let Some(first) = draft.cards.insert(keyword, entry.card.span) {
            let title = format!("material `{}` has two `*{keyword}`", draft.name);
            diagnostics.push(Diagnostic::error(entry.card.span, title).related(first, "first here"));
        }
        describe(entry, draft, scene, diagnostics);
        draft.faulty |= diagnostics.faults() > before;
    }
    drafts.into_iter().map(|draft| finish(draft, scene, diagnostics)).collect()
}

/// Adds what a card says.
fn describe(entry: &Entry<'_>, draft: &mut Draft, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    match entry.keyword.name {
        "PLASTIC" => draft.hardening = hardening(entry, scene, diagnostics),
        "DAMPING" => draft.damping = damping(entry, scene, diagnostics),
        "HYPERELASTIC" => draft.hyperelastic = hyperelastic(entry, scene, diagnostics),
        name => {
            let Some(row) = one_line(entry, scene.deck, diagnostics) else { return };
            let (first, second) = (row.number(0), row.number(1));
            match name {
                "ELASTIC" => {
                    draft.elastic = first.map(|young| Elastic { young, poisson: second.unwrap_or(0.0) });
                }
                _ => draft.density = first,
            }
        }
    }
}

fn begin(entry: &Entry<'_>, drafts: &[Draft], diagnostics: &mut Diagnostics) -> Option<Draft> {
    let value = entry.value("NAME")?;
    let name = normalized(&value.text);
    if let Some(first) = drafts.iter().find(|draft| draft.name == name) {
        let fault = Diagnostic::error(value.span, format!("material `{name}` is there twice"));
        diagnostics.push(fault.related(first.at, "first here"));
    }
    Some(Draft {
        name,
        at: value.span,
        elastic: None,
        hardening: None,
        hyperelastic: None,
        density: None,
        damping: Damping::default(),
        cards: BTreeMap::new(),
        faulty: false,
    })
}

fn hyperelastic(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<NeoHooke> {
    if !entry.has("NEO HOOKE") {
        let fault = Diagnostic::error(entry.card.span, "`*HYPERELASTIC` does not say which energy");
        diagnostics.push(fault.help("`*HYPERELASTIC, NEO HOOKE` is there"));
    }
    let row = one_line(entry, scene.deck, diagnostics)?;
    let c10 = row.number(0)?;
    let d1 = row.number(1).filter(|d1| *d1 > 0.0).unwrap_or_else(|| {
        let d1 = 2.0 / (BULK_OVER_SHEAR * 2.0 * c10);
        let note = Diagnostic::note(row.span, format!("without D1 the bulk modulus is {BULK_OVER_SHEAR} shear moduli"));
        diagnostics.push(note.label(format!("D1 = {d1:e}")));
        d1
    });
    Some(NeoHooke { c10, d1 })
}

fn damping(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Damping {
    let mut factor = |name: &str| {
        let Some(value) = entry.value(name) else { return 0.0 };
        let factor = number(&value.text).unwrap_or(0.0);
        if factor < 0.0 {
            diagnostics.push(Diagnostic::error(value.span, format!("`{name}` of `*DAMPING` must be ≥ 0")));
        }
        factor
    };
    let damping = Damping { alpha: factor("ALPHA"), beta: factor("BETA") };
    if !entry.has("ALPHA") && !entry.has("BETA") {
        let fault = Diagnostic::error(entry.card.span, "`*DAMPING` needs `ALPHA=` or `BETA=`");
        diagnostics.push(fault);
    } else if scene.analysis == Analysis::Static {
        let note = Diagnostic::note(entry.card.span, "`*DAMPING` has no effect in static steps");
        diagnostics.push(note.label("there is no velocity"));
    }
    damping
}

fn hardening(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Hardening> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for line in scene.deck.lines(entry.card) {
        let row = Row::read(line, fields(entry), diagnostics);
        let (Some(stress), true) = (row.number(0), row.sound) else { return None };
        let strain = row.number(1).unwrap_or(0.0);
        let title = match points.last() {
            None if strain != 0.0 => format!("the first plastic strain is 0, not {strain}"),
            Some(last) if strain <= last.0 => format!("plastic strains ascend: {strain} does not follow {}", last.0),
            Some(last) if stress < last.1 => format!("the yield stress falls from {} to {stress}", last.1),
            _ => {
                points.push((strain, stress));
                continue;
            }
        };
        let fault = Diagnostic::error(line.span, title);
        diagnostics.push(fault.help("write: yield stress, plastic strain; strains ascend from 0, stresses never fall"));
        return None;
    }
    if points.is_empty() {
        let fault = Diagnostic::error(entry.card.span, "`*PLASTIC` has no data line");
        diagnostics.push(fault.help("write: yield stress, plastic strain"));
        return None;
    }
    Some(Hardening { points })
}

fn finish(draft: Draft, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) -> (String, Option<usize>) {
    if draft.faulty {
        return (draft.name, None);
    }
    let Draft { name, at, elastic, hardening, hyperelastic, cards, .. } = draft;
    let response = match (elastic, hardening, hyperelastic) {
        (Some(elastic), None, None) => Response::Elastic(elastic),
        (Some(elastic), Some(hardening), None) => Response::Plastic { elastic, hardening },
        (None, None, Some(hyperelastic)) => Response::NeoHooke(hyperelastic),
        (None, _, None) => {
            let fault = Diagnostic::error(at, format!("material `{name}` has no `*ELASTIC`"));
            diagnostics.push(match cards.get("PLASTIC") {
                Some(plastic) => fault.related(*plastic, "what yields is elastic before"),
                None => fault,
            });
            return (name, None);
        }
        (_, _, Some(_)) => {
            let other = cards.iter().find(|(card, _)| ["ELASTIC", "PLASTIC"].contains(card));
            let fault = Diagnostic::error(cards["HYPERELASTIC"], "a hyperelastic material has no other response");
            diagnostics.push(other.into_iter().fold(fault, |fault, (_, other)| fault.related(*other, "the other one")));
            return (name, None);
        }
    };
    let material = Material { name: name.clone(), response, density: draft.density, damping: draft.damping };
    scene.structure.materials.push(material);
    scene.material_places.push(at);
    (name, Some(scene.structure.materials.len() - 1))
}
