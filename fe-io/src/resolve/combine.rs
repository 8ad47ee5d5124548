//! `*SURFACE, COMBINE=`: unions, intersections and differences of surfaces of faces.

use super::lines::line_fields;
use super::pairs::faces_of;
use super::scene::Scene;
use crate::deck::card::Token;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_mesh::Face;

/// Where the surface names stand among the kinds of data lines of `*SURFACE`.
const NAMES: usize = 6;

/// The faces of a combination.
pub fn faces(entry: &Entry<'_>, how: &str, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<Face>> {
    let rows: Vec<Row<'_>> =
        scene.deck.lines(entry.card).map(|line| Row::read(line, line_fields(entry, NAMES), diagnostics)).collect();
    let names: Vec<Token<'_>> = rows.iter().flat_map(|row| (0..row.len()).filter_map(|i| row.token(i))).collect();
    if names.is_empty() || (how != "UNION" && names.len() != 2) {
        let title = format!("`COMBINE={how}` of {} surfaces", names.len());
        let at = names.get(2).map_or(entry.card.span, |third| third.span);
        diagnostics.push(Diagnostic::error(at, title).help(match how {
            "UNION" => "name one or more surfaces",
            "DIFFERENCE" => "name two surfaces: of the first the faces that the second does not have",
            _ => "name two surfaces: the faces that both have",
        }));
        return None;
    }
    let sides: Vec<Option<Vec<Face>>> = names.iter().map(|name| faces_of(*name, scene, diagnostics)).collect();
    let mut sides = sides.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
    let first = sides.next()?;
    if how == "UNION" {
        let mut all = sides.fold(first, |all, side| [all, side].concat());
        all.sort_unstable();
        all.dedup();
        return Some(all);
    }
    let (second, common) = (sides.next()?, how == "INTERSECTION");
    let both: Vec<Face> = first.into_iter().filter(|face| second.binary_search(face).is_ok() == common).collect();
    if both.is_empty() {
        let [a, b] = [names[0], names[1]].map(|name| name.text);
        let title = match common {
            true => format!("surfaces `{a}` and `{b}` have no face in common"),
            false => format!("surface `{b}` has all faces of `{a}`"),
        };
        diagnostics.push(Diagnostic::error(names[1].span, title).label("nothing is left"));
        return None;
    }
    Some(both)
}
