//! Where a plane of symmetry leaves friction nothing to say.
//!
//! A node on such a plane is held across it, and so are the nodes of the main side there. Slip across the plane is odd, and its
//! mean around the node over both halves is 0 whatever the bodies do: there is no shear. Half a model has half of that mean,
//! which is not 0, and is left out. Where points stick exactly it would hold k nodes beside the plane with k + 1 multipliers,
//! the first node that is open with them; what that is off by would be met by multipliers of alternating signs, 2 + √3 times
//! larger from node to node towards the plane.

use crate::contact::Contact;
use crate::point::Slide;
use fe_core::ramp::Ramp;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

/// Part of the square of a direction that a held node may be free in [-]: means over half of a round surface tilt by parts of
/// the angle between its facets.
const TILT: f64 = 0.1;

/// A freedom that a node's motion along a row goes with, and what holds it.
type Motion<'a> = (usize, &'a Ramp);

/// Entries of a row that belong to one node.
struct Entries<'a> {
    row: &'a [f64],
    place: Range<usize>,
    /// Components of the freedoms, where they are not the first ones.
    components: Option<&'a Vec<usize>>,
}

impl Entries<'_> {
    fn each(&self) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let component = |k: usize| self.components.map_or(k, |components| components[k]);
        self.place.clone().zip(self.row).enumerate().map(move |(k, (f, d))| (f, component(k), *d))
    }

    /// Part of the square of the translations that is free [-]; `None` where it has none.
    fn free(&self, supports: &BTreeMap<usize, Ramp>) -> Option<f64> {
        let sum = |counts: &dyn Fn(usize) -> bool| -> f64 {
            self.each().filter(|&(f, c, _)| c < 3 && counts(f)).map(|(.., d)| d * d).sum()
        };
        let all = sum(&|_| true);
        (all > 0.0).then(|| sum(&|f| !supports.contains_key(&f)) / all)
    }

    /// How supports move it along the row; `None` where it is free to. What turns must not turn.
    fn held<'r>(&self, supports: &'r BTreeMap<usize, Ramp>) -> Option<Motion<'r>> {
        let still = |(f, ..): (usize, usize, f64)| supports.get(&f).is_some_and(Ramp::is_constant);
        if !self.each().filter(|&(_, c, d)| c >= 3 && d != 0.0).all(still) || self.free(supports)? > TILT {
            return None;
        }
        let translations = self.each().filter(|e| e.1 < 3);
        let (freedom, component, _) = translations.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))?;
        Some((component, supports.get(&freedom)?))
    }
}

impl Contact {
    /// For each point the directions along the surface that symmetry has the say in; empty where there are none.
    pub(crate) fn mirrored(&self, supports: &BTreeMap<usize, Ramp>) -> Vec<[bool; 2]> {
        if self.tangential.is_none() {
            return Vec::new();
        }
        let of_point = |i: usize| {
            let slide = self.points[i].slide.as_deref();
            slide.map_or([false; 2], |slide| [0, 1].map(|k| self.is_mirrored(i, &slide.rows[k], supports)))
        };
        let all: Vec<[bool; 2]> = (0..self.points.len()).map(of_point).collect();
        if all.iter().flatten().any(|mirrored| *mirrored) { all } else { Vec::new() }
    }

    /// True where the point's node is held along the row and free across the surface, a free node of its own side counts with
    /// it in the mean, and of the main side what is held that way moves as the node does.
    fn is_mirrored(&self, point: usize, row: &[f64], supports: &BTreeMap<usize, Ramp>) -> bool {
        let p = &self.points[point];
        let Some(own) = self.entries(point, row).find(|(n, _)| *n == p.node).map(|(_, entries)| entries) else {
            return false;
        };
        let across = self.entries(point, &p.row).find(|(n, _)| *n == p.node);
        let leaves = across.and_then(|(_, entries)| entries.free(supports)).is_some_and(|free| free > 0.5);
        let Some(motion) = own.held(supports).filter(|_| leaves) else { return false };
        let is_main = |n: &u32| self.sides.main_nodes.binary_search(n).is_ok();
        let others = self.entries(point, row).filter(|(n, _)| *n != p.node);
        let (main, beside): (Vec<_>, Vec<_>) = others.partition(|(n, _)| is_main(n));
        let mut held = main.iter().filter_map(|(_, entries)| entries.held(supports)).peekable();
        let means = beside.iter().any(|(_, entries)| entries.free(supports).is_some_and(|free| free > TILT));
        means && held.peek().is_some() && held.all(|other| other == motion)
    }

    fn entries<'a>(&'a self, point: usize, row: &'a [f64]) -> impl Iterator<Item = (u32, Entries<'a>)> {
        let mut rest = row;
        self.points[point].nodes.iter().zip(&self.places[point]).filter_map(move |(&n, place)| {
            let (row, others) = rest.split_at_checked(place.len())?;
            rest = others;
            Some((n, Entries { row, place: place.clone(), components: self.components.get(&n) }))
        })
    }

    /// How a point moves along the surface, without the directions that symmetry has the say in.
    pub(crate) fn slide_at(&self, point: usize, motion: (&[f64], &[f64])) -> Option<Cow<'_, Slide>> {
        let mut slide = self.points[point].slide_at(motion, &self.places[point])?;
        self.mirrored_at(point).for_each(|k| slide.to_mut().rows[k].clear());
        Some(slide)
    }

    /// The same for an increment that begins at `u`.
    pub(crate) fn slide_from(&self, point: usize, u: &[f64]) -> Option<Cow<'_, Slide>> {
        let mut slide = self.points[point].slide_from(u, &self.places[point])?;
        self.mirrored_at(point).for_each(|k| slide.to_mut().rows[k].clear());
        Some(slide)
    }

    /// The directions of a point that symmetry has the say in.
    pub(crate) fn mirrored_at(&self, point: usize) -> impl Iterator<Item = usize> {
        let mirrored = self.mirrored.get(point).copied().unwrap_or_default();
        [0, 1].into_iter().filter(move |&k| mirrored[k])
    }
}
