//! A face under two names presses once.

use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Place;
use fe_contact::pair::PairDefinition;
use fe_contact::surface::{Main, Secondary};
use std::collections::HashSet;
use std::hash::Hash;

/// A pair without the faces (or nodes) that earlier pairs press onto the same main surface already, which is warned of;
/// `None` where nothing is left.
pub fn only_new(
    mut pair: PairDefinition,
    earlier: &[(PairDefinition, Place)],
    at: Span,
    diagnostics: &mut Diagnostics,
) -> Option<PairDefinition> {
    for (other, Place { file, line }) in earlier.iter().filter(|(other, _)| is_within(&pair.main, &other.main)) {
        let (kind, (again, left)) = match (&mut pair.secondary, &other.secondary) {
            (Secondary::Faces(faces), Secondary::Faces(before)) => ("faces", remove(faces, before, |face| *face)),
            (Secondary::Nodes(nodes), Secondary::Nodes(before)) => ("nodes", remove(nodes, before, |node| node.0)),
            (Secondary::Lines(lines), Secondary::Lines(before)) => ("lines", remove(lines, before, |cell| *cell)),
            _ => continue,
        };
        if again > 0 {
            let (name, main, first) = (&pair.secondary_name, &pair.main_name, &other.secondary_name);
            let title = format!("{again} {kind} of surface `{name}` are on `{main}` already, in surface `{first}`");
            let what = if left == 0 { "this pair is left out" } else { "each counts once" };
            let warning = Diagnostic::warning(at, title).label(what);
            diagnostics.push(warning.help(format!("the first pair is at {file}:{line}")));
        }
        if left == 0 {
            return None;
        }
    }
    Some(pair)
}

/// True when all of a main surface belongs to another one.
fn is_within(main: &Main, other: &Main) -> bool {
    match (main, other) {
        (Main::Rigid { surface, .. }, Main::Rigid { surface: other, .. }) => surface.name == other.name,
        (Main::Faces(faces), Main::Faces(other)) => {
            let other: HashSet<_> = other.iter().collect();
            faces.iter().all(|face| other.contains(face))
        }
        _ => false,
    }
}

/// Removes what was there before; how many were, and how many are left.
fn remove<T, K: Hash + Eq>(items: &mut Vec<T>, before: &[T], key: impl Fn(&T) -> K) -> (usize, usize) {
    let before: HashSet<K> = before.iter().map(&key).collect();
    let listed = items.len();
    items.retain(|item| !before.contains(&key(item)));
    (listed - items.len(), items.len())
}
