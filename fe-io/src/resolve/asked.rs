//! What a data line of `*SURFACE` asks of its elements: a face, a side, or what is free.

use super::scene::Scene;
use crate::deck::card::Token;
use crate::diagnostic::{Diagnostic, Diagnostics};
use fe_core::element::{ElementType, Family, Space};
use fe_mesh::CellId;

/// The second entry of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// `S1` to `S6` of solids, from 0.
    Face(u8),
    /// `SPOS` (0) or `SNEG` (1) of trusses and beams in the plane, and of rigid facets.
    Side(u8),
    /// Blank: free faces of solids, all of a truss or beam in space.
    Free,
}

/// Reads an identifier; one that is none is told.
pub fn face(token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<Asked> {
    let word = token.text.to_ascii_uppercase();
    match word.strip_prefix('S').and_then(|n| n.parse::<u8>().ok()) {
        Some(n @ 1..=6) => return Some(Asked::Face(n - 1)),
        _ if word == "SPOS" => return Some(Asked::Side(0)),
        _ if word == "SNEG" => return Some(Asked::Side(1)),
        _ if matches!(word.as_str(), "EDGE" | "END1" | "END2" | "E1" | "E2" | "E3" | "E4") => {
            let fault = Diagnostic::error(token.span, format!("face `{word}` is not there yet"));
            diagnostics.push(fault.label("edges and ends are not there; solids have S1 to S6"));
        }
        _ => {
            let fault = Diagnostic::error(token.span, format!("there is no face `{word}`"));
            diagnostics.push(fault.label("faces are S1 to S6, or blank for the free ones"));
        }
    }
    None
}

/// True for trusses and beams in space: as a surface they are lines.
pub fn is_line(element: ElementType) -> bool {
    matches!(element.family(), Family::Truss | Family::Beam) && element.space() == Space::Solid
}

/// Those of some elements that have what is asked for; the first that has not is told.
pub fn with(
    cells: Vec<CellId>,
    asked: Asked,
    told: Token<'_>,
    scene: &Scene<'_>,
    diagnostics: &mut Diagnostics,
) -> Vec<CellId> {
    let (with, without): (Vec<CellId>, Vec<CellId>) =
        cells.into_iter().partition(|&cell| has(scene.element_of(cell), asked));
    if let Some(&cell) = without.first() {
        let (element, label) = (scene.element_of(cell), scene.cell_name(cell));
        let title = match asked {
            Asked::Free => format!("element {label} has no free faces"),
            _ => format!("element {label} has no face `{}`", told.text),
        };
        diagnostics.push(Diagnostic::error(told.span, title).label(offer(element)));
    }
    with
}

fn has(element: ElementType, asked: Asked) -> bool {
    match (element.family(), asked) {
        (Family::Solid, Asked::Free) => true,
        (Family::Solid, Asked::Face(face)) => usize::from(face) < element.kind().faces().len(),
        (Family::Truss | Family::Beam, Asked::Free) => is_line(element),
        (Family::Truss | Family::Beam, Asked::Side(_)) => !is_line(element),
        (Family::Rigid, Asked::Side(_)) => true,
        _ => false,
    }
}

fn offer(element: ElementType) -> String {
    let name = element.name();
    match element.family() {
        Family::Solid => format!("{name} has S1 to S{}", element.kind().faces().len()),
        Family::Truss | Family::Beam if is_line(element) => format!("{name} is a line: leave the face blank"),
        Family::Truss | Family::Beam | Family::Rigid => format!("{name} has SPOS and SNEG"),
        _ => format!("{name} makes no surface"),
    }
}
