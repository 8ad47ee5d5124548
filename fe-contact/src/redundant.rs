//! Constraints that say what supports or other constraints say already. Multipliers share their force, which is then not
//! determined point by point; that is told.

use crate::contact::Contact;
use crate::summary::Means;
use std::collections::{BTreeMap, BTreeSet};

/// What elimination leaves of a row that depends on others [-], of its size: between round-off and the least angle between
/// constraints that meshes bring about.
const NOTHING: f64 = 1e-10;

/// A multiplier of a touching point whose constraint depends on those before it and on the supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Redundant {
    /// Index of the contact.
    pub contact: usize,
    /// The secondary node.
    pub node: u32,
}

/// The redundant multipliers of the points that touch at `u`; `fixed` tells the prescribed freedoms. Only points can be redundant
/// that have a prescribed freedom, or a node that is secondary in another contact, too; means over faces that depend on each
/// other far from a support are not looked for.
pub fn redundant(contacts: &[Contact], u: &[f64], fixed: &[bool]) -> Vec<Redundant> {
    let mut secondary: BTreeMap<u32, BTreeSet<usize>> = BTreeMap::new();
    // The overclosure of a softened law says how much each point presses.
    let shares = |c: &Contact| c.acts() && c.multipliers.is_some() && c.bare.is_none();
    for (k, contact) in contacts.iter().enumerate().filter(|(_, contact)| shares(contact)) {
        contact.points.iter().for_each(|p| _ = secondary.entry(p.node).or_default().insert(k));
    }
    let mut eliminated = Eliminated::default();
    let mut found = Vec::new();
    for (k, contact) in contacts.iter().enumerate().filter(|(_, contact)| shares(contact)) {
        let elsewhere = |n: &u32| secondary.get(n).is_some_and(|of| of.iter().any(|&other| other != k));
        for (i, point) in contact.points.iter().enumerate() {
            if contact.opening_at_start(i, u) > contact.law.reach() + contact.touch {
                continue;
            }
            let shared = point.nodes.iter().any(elsewhere);
            for row in contact.rows_of_multipliers(i, u) {
                let suspect = shared || row.iter().any(|d| fixed[d.0]);
                if suspect && !eliminated.takes(row, fixed) {
                    found.push(Redundant { contact: k, node: point.node });
                }
            }
        }
    }
    found
}

impl Contact {
    /// What the multipliers of a touching point hold, each with its freedoms: the gap, and what is tied along the surface.
    fn rows_of_multipliers(&self, point: usize, u: &[f64]) -> Vec<Vec<(usize, f64)>> {
        let places = &self.places[point];
        let slide = self.slide_from(point, u).filter(|_| self.is_tied());
        let normal = self.at(point, u).row;
        let rows =
            std::iter::once(&normal[..]).chain(slide.iter().flat_map(|slide| slide.rows.iter().map(Vec::as_slice)));
        let with_freedoms = |row: &[f64]| {
            let freedoms = places.iter().cloned().flatten();
            freedoms.zip(row.iter().copied()).filter(|d| d.1 != 0.0).collect::<Vec<_>>()
        };
        rows.map(with_freedoms).filter(|row| !row.is_empty()).collect()
    }
}

/// A point with a multiplier that supports hold inside the other body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contradiction {
    /// Index of the contact.
    pub contact: usize,
    /// The secondary node.
    pub node: u32,
    /// Overclosure [L].
    pub overclosure: f64,
}

/// The deepest point that no free freedom can move and that overlaps at `u`.
pub fn contradiction(contacts: &[Contact], u: &[f64], fixed: &[bool]) -> Option<Contradiction> {
    let mut deepest: Option<Contradiction> = None;
    let hard = |c: &Contact| c.acts() && c.summary.penalty.is_some_and(|p| p.means == Means::Multipliers);
    for (k, contact) in contacts.iter().enumerate().filter(|(_, contact)| hard(contact)) {
        let reach = contact.law.reach();
        for (i, point) in contact.points.iter().enumerate() {
            let overclosure = reach - contact.opening_at_start(i, u);
            let contradicts = overclosure > contact.touch && !point.moves_with(&contact.places[i], |f| !fixed[f]);
            if contradicts && deepest.is_none_or(|d| overclosure > d.overclosure) {
                deepest = Some(Contradiction { contact: k, node: point.node, overclosure });
            }
        }
    }
    deepest
}

/// Rows by Gaussian elimination, each with the freedom of its largest entry as pivot.
#[derive(Debug, Default)]
struct Eliminated {
    rows: Vec<BTreeMap<usize, f64>>,
    /// The row whose pivot a freedom is.
    of_pivot: BTreeMap<usize, usize>,
}

impl Eliminated {
    /// Takes a row in; false where it depends on the rows taken in before.
    fn takes(&mut self, row: Vec<(usize, f64)>, fixed: &[bool]) -> bool {
        let size = row.iter().fold(0.0, |m: f64, d| m.max(d.1.abs()));
        let mut rest: BTreeMap<usize, f64> = row.into_iter().filter(|d| !fixed[d.0]).collect();
        // A row is free of the pivots of earlier ones, so that ascending order meets each once.
        while let Some((row, pivot)) = rest.keys().filter_map(|f| Some((*self.of_pivot.get(f)?, *f))).min() {
            let factor = rest[&pivot] / self.rows[row][&pivot];
            for (f, d) in &self.rows[row] {
                *rest.entry(*f).or_insert(0.0) -= factor * d;
            }
            rest.remove(&pivot);
        }
        let largest = rest.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        match largest {
            Some((&pivot, d)) if d.abs() > NOTHING * size => {
                self.of_pivot.insert(pivot, self.rows.len());
                self.rows.push(rest);
                true
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(rows: &[&[(usize, f64)]], fixed: &[bool]) -> usize {
        let mut eliminated = Eliminated::default();
        rows.iter().filter(|row| !eliminated.takes(row.to_vec(), fixed)).count()
    }

    #[test]
    fn dependent_rows_are_found() {
        let free = [false; 4];
        let (a, b): (&[_], &[_]) = (&[(0, 1.0), (1, -1.0)], &[(1, 1.0), (2, -1.0)]);
        assert_eq!(count(&[a, b], &free), 0);
        assert_eq!(count(&[a, b, &[(0, 2.0), (2, -2.0)]], &free), 1);
        assert_eq!(count(&[a, &[(0, -1.0), (1, 1.0)], b], &free), 1);
        assert_eq!(count(&[a, b], &[true, true, false, false]), 1);
    }

    /// Node constraints both ways on a straight interface of m and n nodes: the gap has m + n freedoms, but one side's nodes
    /// between matching ones repeat nothing (D08).
    #[test]
    fn d08_redundancy_of_two_passes() {
        for (m, n, expected) in [(4, 4, 4), (5, 4, 2), (6, 5, 2), (9, 5, 5)] {
            let free = vec![false; m + n];
            // Heights of m nodes on one side, then of n on the other.
            let side = |from: (usize, usize), to: (usize, usize)| -> Vec<Vec<(usize, f64)>> {
                let row = |i: usize| {
                    let x = i as f64 * (to.0 - 1) as f64 / (from.0 - 1) as f64;
                    let (j, part) = (x.floor(), x - x.floor());
                    let near = [(to.1 + j as usize, part - 1.0), (to.1 + j as usize + 1, -part)];
                    let rest = near.into_iter().filter(|d| d.1 != 0.0);
                    std::iter::once((from.1 + i, 1.0)).chain(rest).collect()
                };
                (0..from.0).map(row).collect()
            };
            let (upper, lower) = ((m, 0), (n, m));
            let rows: Vec<_> = side(upper, lower).into_iter().chain(side(lower, upper)).collect();
            let mut eliminated = Eliminated::default();
            let dependent = rows.into_iter().filter(|row| !eliminated.takes(row.clone(), &free)).count();
            assert_eq!(dependent, expected, "{m} and {n} nodes");
        }
    }
}
