//! What resists the motion of the surfaces against each other: stabilisation, in proportion to the velocity.

use crate::contact::Contact;
use crate::facet::Vec3;
use crate::point::dot;
use crate::term::Blocks;
use fe_core::{Assembly, Motion};
use std::ops::Range;

/// `*CONTACT CONTROLS, STABILIZE` of one step: pressure and shear against the velocities of points that are closed or not
/// far open. Abaqus Analysis User's Manual, Adjusting contact controls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stabilization {
    /// How large the coefficient is.
    pub coefficient: Coefficient,
    /// Coefficient along the surface over that across it [-].
    pub tangent_fraction: f64,
    /// Factor at the end of the step [-], reached straight from 1 at its start.
    pub end: f64,
    /// Clearance [L] from which on nothing acts, falling from half of it on; `None`: the facets' length.
    pub range: Option<f64>,
}

/// A damping coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coefficient {
    /// So much [F T/L³].
    Given(f64),
    /// A multiple [-] of [`AUTOMATIC`] times the stiffness of the elements beneath times the step's period.
    Automatic(f64),
}

/// The automatic coefficient over k_e T [-]: at a constant velocity over the step the resistance is that part of what the
/// elements would do against the same displacement.
pub const AUTOMATIC: f64 = 1e-3;

/// A stabilisation at the points of a contact.
#[derive(Clone, Debug)]
pub(crate) struct Resistance {
    /// Coefficients [F T/L³] across and along the surface.
    pub coefficients: [f64; 2],
    /// Clearances [L] between which they fall to 0.
    pub fall: [f64; 2],
    /// Factor at the end of the step, and its period [T].
    pub course: (f64, f64),
    /// Derivatives of the motion along the surface by the freedoms of each point's nodes, in one or two directions.
    along: Vec<Vec<Vec<f64>>>,
    /// Where the energy it takes stands in the history.
    place: usize,
}

impl Resistance {
    /// For a step of so long a `period` [T]; `place` is its own in the history.
    pub fn new(contact: &Contact, stabilization: &Stabilization, period: f64, place: usize) -> Self {
        let coefficient = match stabilization.coefficient {
            Coefficient::Given(coefficient) => coefficient,
            Coefficient::Automatic(factor) => {
                let beneath = contact.summary.beneath.unwrap_or_else(|| contact.law.typical_stiffness());
                factor * AUTOMATIC * beneath * period
            }
        };
        let range = stabilization.range.or(Some(contact.length)).filter(|l| *l > 0.0).unwrap_or(f64::INFINITY);
        let along = (0..contact.points.len()).map(|i| along(contact, i)).collect();
        Resistance {
            coefficients: [coefficient, stabilization.tangent_fraction * coefficient],
            fall: [0.5 * range, range],
            course: (stabilization.end, period),
            along,
            place,
        }
    }

    /// Factor [-] at a clearance [L], of an increment: the mean over its time, so that the last one has some, too.
    fn factor(&self, clearance: f64, at: &Motion) -> f64 {
        let ([from, to], (end, period)) = (self.fall, self.course);
        let near = if clearance <= from { 1.0 } else { ((to - clearance) / (to - from)).max(0.0) };
        near * (1.0 + (end - 1.0) * ((at.step_time - 0.5 * at.dt) / period))
    }
}

/// Rows of a point in the directions along its surface. The nodes' weights are those of its gap.
fn along(contact: &Contact, point: usize) -> Vec<Vec<f64>> {
    let p = &contact.points[point];
    let normal = Vec3::from(p.normal);
    if normal == Vec3::zeros() {
        return Vec::new();
    }
    let first = normal.cross(&Vec3::ith(normal.iamin(), 1.0)).normalize();
    let in_direction = |t: Vec3| {
        let mut row = Vec::with_capacity(p.row.len());
        let mut start = 0;
        for place in &contact.places[point] {
            let of_node = &p.row[start..start + place.len()];
            start += place.len();
            let weight: f64 = of_node.iter().zip(normal.iter()).map(|(d, n)| d * n).sum();
            // Rotations, beyond the third, are left to the motion across.
            row.extend((0..place.len()).map(|c| if c < 3 { weight * t[c] } else { 0.0 }));
        }
        row
    };
    let rows = [first, normal.cross(&first)].map(in_direction);
    rows.into_iter().filter(|row| row.iter().any(|d| d.abs() > f64::EPSILON)).collect()
}

impl Contact {
    /// Energy [F L] that stabilisation has taken so far, by the history of an evaluation.
    pub(crate) fn stabilized(&self, history: &[f64]) -> f64 {
        self.spent + self.resistance.as_ref().map_or(0.0, |r| history[r.place])
    }

    /// Adds the resistance at all points, and keeps the energy that it takes in the increment.
    pub(crate) fn resist(
        &self,
        at: &Motion,
        (old, new): (&[f64], &mut [f64]),
        blocks: Option<&Blocks>,
        out: &mut Assembly,
    ) {
        let Some(resistance) = self.resistance.as_ref().filter(|_| at.dt > 0.0) else { return };
        let mut taken = 0.0;
        for (i, p) in self.points.iter().enumerate() {
            let here = self.at(i, at.u);
            let factor = resistance.factor(here.gap + self.allowed(i, new), at) * p.measure.value();
            if factor == 0.0 {
                continue;
            }
            let [across, along] = resistance.coefficients.map(|c| factor * c / at.dt);
            let sideways = resistance.along[i].iter().map(|row| (along, row.as_slice()));
            for (stiffness, row) in std::iter::once((across, &*here.row)).chain(sideways) {
                let moved = dot(row, at.du, &self.places[i]);
                taken += stiffness * moved * moved;
                add(row, stiffness * moved, &self.places[i], out.residual);
                if let (Some(blocks), Some(matrix)) = (blocks, out.stiffness.as_deref_mut()) {
                    self.add_stiffness(i, (stiffness, row), blocks, matrix);
                }
            }
        }
        new[resistance.place] = old[resistance.place] + taken;
    }
}

/// Adds a force along a row.
fn add(row: &[f64], force: f64, places: &[Range<usize>], residual: &mut [f64]) {
    row.iter().zip(places.iter().cloned().flatten()).for_each(|(d, f)| residual[f] += force * d);
}
