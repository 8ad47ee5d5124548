//! What acts along the surfaces: friction at points that are closed.
//!
//! Where points stick exactly, the shear has multipliers as the pressure has ([`crate::enforce`]): λ/K is kept as a shift of
//! the slip, so that the law sees λ/K + Δγ on springs K, and takes (τ − λ)/K for what the slip is off by.

use crate::contact::Contact;
use crate::enforce::{Answer, Multipliers, OPEN, SLIPPING};
use crate::friction::change::Changing;
use crate::friction::{Coulomb, Shear, Sliding};
use crate::point::{ContactPoint, ContactStatus, Slide};
use fe_core::Motion;
use fe_core::term::{Equilibrium, Overlap};
use std::borrow::Cow;
use std::ops::Range;

/// A law of friction and what stands on top of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tangential {
    /// The law, or the one that a change leads to.
    pub law: Coulomb,
    /// How the present step changes it.
    pub change: Option<Changing>,
    /// Multipliers, where sticking points do not move.
    pub multipliers: Option<Multipliers>,
}

/// Where the numbers of a point stand in its part of the history: elastic slip, slip while closed, shear, and the sum of
/// all shifts by multipliers.
pub(crate) const ELASTIC: usize = 0;
const SLIP: usize = 2;
const SHEAR: usize = 4;
const SHIFT: usize = 6;

impl Tangential {
    /// Numbers that a point keeps.
    pub fn history(&self) -> usize {
        if self.multipliers.is_some() { 8 } else { 6 }
    }
}

/// What acts along the surface at a point.
#[derive(Debug)]
pub(crate) struct Along<'a> {
    /// Its directions and rows.
    pub slide: Cow<'a, Slide>,
    /// Slip of the increment [L].
    pub slip: [f64; 2],
    /// What the law answers.
    pub answer: Shear,
}

impl Along<'_> {
    /// ∂τ/∂γ, symmetric, as factors of rows: D = Σ factor · row rowᵀ.
    pub fn stiffness(&self) -> Vec<(f64, Cow<'_, [f64]>)> {
        let [[a, b], [_, c]] = self.answer.stiffness;
        let [first, second] = &self.slide.rows;
        let mut parts: Vec<(f64, Cow<[f64]>)> = Vec::with_capacity(2);
        if second.is_empty() || b == 0.0 {
            parts.push((a, first.into()));
            parts.push((c, second.into()));
        } else {
            // D is positive semidefinite, and not diagonal: a > 0.
            let sum: Vec<f64> = first.iter().zip(second).map(|(x, y)| x + b / a * y).collect();
            parts.push((a, sum.into()));
            parts.push(((c - b * b / a).max(0.0), second.into()));
        }
        parts.retain(|part| part.0 != 0.0 && !part.1.is_empty());
        parts
    }

    /// What a motion changes of the shear beyond that: `pressing` is its change of the pressure.
    pub fn rest(&self, pressing: f64, slipping: [f64; 2]) -> [f64; 2] {
        let Shear { by_pressure, rest, .. } = self.answer;
        [0, 1].map(|i| by_pressure[i] * pressing + rest[i][0] * slipping[0] + rest[i][1] * slipping[1])
    }

    /// True where there is anything beyond.
    pub fn has_rest(&self) -> bool {
        self.answer.by_pressure != [0.0; 2] || self.answer.rest != [[0.0; 2]; 2]
    }
}

fn pair(history: &[f64], at: usize) -> [f64; 2] {
    [history[at], history[at + 1]]
}

impl Contact {
    /// Where a point's numbers begin.
    pub(crate) fn own(&self, point: usize) -> usize {
        let before = if self.multipliers.is_some() { 2 } else { 1 };
        before * self.points.len() + point * self.tangential.as_ref().map_or(0, Tangential::history)
    }

    /// All numbers of history that last from step to step.
    pub(crate) fn numbers(&self) -> usize {
        self.own(self.points.len())
    }

    /// Elastic slip that a point starts the increment with, or what multipliers have made of it.
    fn anchor(&self, point: usize, old: &[f64], new: &[f64]) -> [f64; 2] {
        let own = self.own(point);
        let exact = self.sticks_exactly();
        let shifted = |i: usize| if exact { new[own + SHIFT + i] - old[own + SHIFT + i] } else { 0.0 };
        let mut anchor = [0, 1].map(|i| old[own + ELASTIC + i] + shifted(i));
        self.mirrored_at(point).for_each(|i| anchor[i] = 0.0);
        anchor
    }

    /// The law of friction at a motion's time.
    pub(crate) fn friction_at(&self, at: &Motion) -> Option<Cow<'_, Coulomb>> {
        self.tangential.as_ref().map(|tangential| tangential.at(at))
    }

    /// What acts along the surface, by a law of friction, at a point that is pressed, or touches, where the law answers so.
    pub(crate) fn along(
        &self,
        point: usize,
        (at, law): (&Motion, Option<&Coulomb>),
        normal: &Answer,
        (old, new): (&[f64], &[f64]),
    ) -> Option<Along<'_>> {
        let law = law.filter(|_| normal.status != ContactStatus::Open)?;
        let pressure = normal.response.pressure;
        let places: &[Range<usize>] = &self.places[point];
        let slide = self.slide_at(point, (at.u, at.du))?;
        let slip = slide.slip(at.du, places);
        let elastic = self.anchor(point, old, new);
        let mut answer = law.respond(Sliding { pressure, elastic, slip, dt: at.dt });
        let held = pressure > 0.0 || slip == [0.0; 2];
        if normal.touches && held && !law.is_none() {
            // As the pressure does: a body that just touches is held, until it slips without any.
            let typical = self.law.typical_stiffness();
            for i in 0..2 {
                answer.stiffness[i][i] = answer.stiffness[i][i].max(typical);
            }
        }
        Some(Along { slide, slip, answer })
    }

    /// True where friction acts at a point.
    pub(crate) fn slides(&self, point: usize, u: &[f64]) -> bool {
        self.rubs() && self.points[point].slide_from(u, &self.places[point]).is_some()
    }

    /// How the slips [L] of a point change with a small motion `field` from a displacement.
    pub(crate) fn slip_rate(&self, point: usize, u: &[f64], field: &[f64]) -> [f64; 2] {
        let slide = self.tangential.as_ref().and_then(|_| self.slide_from(point, u));
        slide.map_or([0.0; 2], |slide| slide.slip(field, &self.places[point]))
    }

    /// Keeps what a point does along the surface; what is open has slipped no further, and forgets.
    pub(crate) fn keep(&self, point: usize, along: Option<&Along>, old: &[f64], new: &mut [f64]) {
        let Some(tangential) = &self.tangential else { return };
        let own = self.own(point);
        let (slip, none) = (pair(old, own + SLIP), [0.0; 2]);
        let (elastic, moved, shear) = along.map_or((none, none, none), |a| (a.answer.elastic, a.slip, a.answer.shear));
        for i in 0..2 {
            new[own + ELASTIC + i] = elastic[i];
            new[own + SLIP + i] = slip[i] + moved[i];
            new[own + SHEAR + i] = shear[i];
            if along.is_none() && tangential.multipliers.is_some() {
                new[own + SHIFT + i] = old[own + SHIFT + i];
            }
        }
    }

    /// Shear, in the pressure's unit, and slip [L] while closed, of a history.
    pub(crate) fn shear_and_slip(&self, point: usize, history: &[f64]) -> ([f64; 2], [f64; 2]) {
        let own = self.own(point);
        match self.tangential {
            Some(_) => (pair(history, own + SHEAR), pair(history, own + SLIP)),
            None => ([0.0; 2], [0.0; 2]),
        }
    }

    /// Work [F L] that friction took in an increment: Σ A τ · (Δγ − Δγ_elastic), never negative.
    pub(crate) fn rubbed(&self, old: &[f64], new: &[f64]) -> f64 {
        let Some(tangential) = &self.tangential else { return 0.0 };
        let each = |(i, p): (usize, &ContactPoint)| {
            let own = self.own(i);
            let shear = pair(new, own + SHEAR);
            let change = |at: usize, c: usize| new[own + at + c] - old[own + at + c];
            let elastic = |c: usize| if tangential.multipliers.is_none() { change(ELASTIC, c) } else { 0.0 };
            let work: f64 = (0..2).map(|c| shear[c] * (change(SLIP, c) - elastic(c))).sum();
            // A point that sticks loses nothing, but for rounding.
            if new[i] == SLIPPING { work.max(0.0) * p.measure.value() } else { 0.0 }
        };
        self.points.iter().enumerate().map(each).sum()
    }

    /// Takes the shears as multipliers; see [`Contact::take_multipliers`].
    pub(crate) fn take_shears(&self, at: Equilibrium, old: &[f64], new: &mut [f64]) -> Option<Overlap> {
        let multipliers = self.tangential.as_ref()?.multipliers?;
        let closed = |&i: &usize| new[i] != OPEN;
        let off = |i: usize| {
            let (elastic, anchor) = (pair(new, self.own(i) + ELASTIC), self.anchor(i, old, new));
            [0, 1].map(|c| elastic[c] - anchor[c])
        };
        let excesses: Vec<(usize, [f64; 2])> = (0..self.points.len()).filter(closed).map(|i| (i, off(i))).collect();
        let size = |v: [f64; 2]| v[0].hypot(v[1]);
        let largest = excesses.iter().map(|e| size(pair(new, self.own(e.0) + SHEAR))).fold(0.0, f64::max);
        let worst = self.worst(&multipliers, at, largest, excesses.iter().map(|&(i, off)| (i, size(off))));
        if worst.is_some() {
            for (i, off) in excesses {
                let shift = self.own(i) + SHIFT;
                (0..2).for_each(|c| new[shift + c] += off[c]);
            }
        }
        worst
    }

    /// Twice the energy [F/L] that sticking stores; multipliers store none.
    pub(crate) fn stored(&self, shear: [f64; 2], elastic: [f64; 2]) -> f64 {
        if self.sticks_exactly() { 0.0 } else { shear[0] * elastic[0] + shear[1] * elastic[1] }
    }

    /// A point's status: with friction it sticks or slips while it is closed.
    pub(crate) fn status_of(closed: ContactStatus, along: Option<&Along>) -> ContactStatus {
        if along.is_some_and(|a| a.answer.slips) { ContactStatus::Slipping } else { closed }
    }
}
