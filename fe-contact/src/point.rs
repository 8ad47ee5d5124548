//! One constraint point of contact: where it sits, how much surface it stands for, what it presses on.

use crate::facet::Vec3;
use crate::tangents::{Space, tangents};
use nalgebra::Matrix3;
use std::borrow::Cow;
use std::ops::Range;

/// The unit rule: the law's number times the measure is the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// An area [L²]: the law's number is a pressure.
    Area(f64),
    /// A length [L]: the law's number is a force per length.
    Length(f64),
    /// A point: the law's number is a force.
    Point,
}

impl Measure {
    /// Area, length, or 1.
    pub fn value(self) -> f64 {
        match self {
            Measure::Area(v) | Measure::Length(v) => v,
            Measure::Point => 1.0,
        }
    }
}

/// Open or closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactStatus {
    /// No pressure.
    #[default]
    Open,
    /// Pressed, not slipping: with friction it sticks.
    Closed,
    /// Pressed and slipping.
    Slipping,
}

/// One constraint. With infinitesimal sliding its gap is linear in the displacement:
/// g = g₀ + Σ d·u over the nodes of both sides, and a force N = p A on it acts on the nodes as −N d
/// (residual: internal minus external force). A round point has a gap of its own, see [`Round`].
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPoint {
    /// The secondary node that it stands for.
    pub node: u32,
    /// Gap g₀ [L] at zero displacement, positive when open.
    pub gap: f64,
    /// Unit normal of the main side, pointing at the secondary; 0 for a round point.
    pub normal: [f64; 3],
    /// How much surface it stands for.
    pub measure: Measure,
    /// Nodes of both sides, ascending, each with its derivatives ∂g/∂u by freedom of the node: `row` holds,
    /// node after node, as many numbers as the node has freedoms.
    pub nodes: Vec<u32>,
    /// The derivatives [-] (translations) and [L] (rotations); zeros for a round point.
    pub row: Vec<f64>,
    /// Where the gap is not linear.
    pub round: Option<Box<Round>>,
    /// Where something acts along the surface; a round point has its directions from its offset.
    pub slide: Option<Box<Slide>>,
}

/// How a point moves along the surface: slips γᵢ = tᵢ · (motion of the secondary side − motion of the main one).
#[derive(Clone, Debug, PartialEq)]
pub struct Slide {
    /// Unit directions t₁, t₂; see [`tangents`].
    pub directions: [[f64; 3]; 2],
    /// ∂γᵢ/∂u, as [`ContactPoint::row`]; the second one empty in plane models.
    pub rows: [Vec<f64>; 2],
}

/// A gap between two circles or balls, one in the other or side by side, whose direction is that of the offset
/// w = w₀ + P Σ rows·u of the second centre from the first, P taking out an axis: g = d − |w| for d > 0 (d the largest distance of the centres),
/// g = |w| − |d| for d < 0 (|d| the least one). Abaqus Analysis User's Manual, Gap contact elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Round {
    /// w₀ [L].
    pub start: [f64; 3],
    /// Derivatives of the components of the second centre's motion against the first by the freedoms of the point's nodes,
    /// as [`ContactPoint::row`].
    pub rows: [Vec<f64>; 3],
    /// P.
    pub across: Matrix3<f64>,
    /// The two directions in which it slides, along the axis too.
    pub space: Space,
    /// d [L].
    pub distance: f64,
}

/// A point at a displacement.
#[derive(Clone, Debug)]
pub struct Kinematics<'a> {
    /// Gap g [L].
    pub gap: f64,
    /// Direction in which a pressure acts on the secondary; 0 where there is none (concentric circles).
    pub normal: [f64; 3],
    /// ∂g/∂u.
    pub row: Cow<'a, [f64]>,
    /// ∂²g/∂u² = Σ factor · row rowᵀ [1/L].
    pub bending: Vec<(f64, Vec<f64>)>,
}

impl ContactPoint {
    /// Where it stands; `u` over all freedoms, of which those of its nodes are at `places`.
    pub fn at(&self, u: &[f64], places: &[Range<usize>]) -> Kinematics<'_> {
        match &self.round {
            None => {
                let gap = self.gap + dot(&self.row, u, places);
                Kinematics { gap, normal: self.normal, row: Cow::Borrowed(&self.row), bending: Vec::new() }
            }
            Some(round) => round.at(u, places),
        }
    }

    /// True when its gap changes with a freedom that `counts`.
    pub(crate) fn moves_with(&self, places: &[Range<usize>], counts: impl Fn(usize) -> bool) -> bool {
        let rows = self.round.iter().flat_map(|round| &round.rows).chain(std::iter::once(&self.row));
        rows.into_iter()
            .any(|row| row.iter().zip(places.iter().cloned().flatten()).any(|(d, f)| *d != 0.0 && counts(f)))
    }

    /// Its gap [L] alone.
    pub fn opening(&self, u: &[f64], places: &[Range<usize>]) -> f64 {
        match &self.round {
            None => self.gap + dot(&self.row, u, places),
            Some(round) => round.gap(round.offset(u, places).norm()),
        }
    }
}

impl ContactPoint {
    /// How it moves along the surface at `u`, `du` from the start of the increment, where something acts so. A round point
    /// keeps the directions that it has at the start of an increment.
    pub fn slide_at(&self, (u, du): (&[f64], &[f64]), places: &[Range<usize>]) -> Option<Cow<'_, Slide>> {
        match &self.round {
            None => self.slide.as_deref().map(Cow::Borrowed),
            Some(round) => {
                let now = round.offset(u, places);
                let start = now - round.moved(du, places);
                round.slide([start, now]).map(Cow::Owned)
            }
        }
    }

    /// The same for an increment that begins at `u`.
    pub fn slide_from(&self, u: &[f64], places: &[Range<usize>]) -> Option<Cow<'_, Slide>> {
        match &self.round {
            None => self.slide.as_deref().map(Cow::Borrowed),
            Some(round) => round.slide([round.offset(u, places); 2]).map(Cow::Owned),
        }
    }
}

impl Slide {
    /// Slip [L] of a motion.
    pub fn slip(&self, motion: &[f64], places: &[Range<usize>]) -> [f64; 2] {
        [0, 1].map(|i| dot(&self.rows[i], motion, places))
    }
}

impl Round {
    /// Along the circles or balls where one of these offsets has a direction, the first one first.
    fn slide(&self, offsets: [Vec3; 2]) -> Option<Slide> {
        let m = offsets.into_iter().find_map(|offset| offset.try_normalize(0.0))?;
        let sign = if self.distance > 0.0 { -1.0 } else { 1.0 };
        let directions = tangents(&(m * sign), self.space);
        Some(Slide { directions: directions.map(Into::into), rows: directions.map(|t| self.along(&t)) })
    }

    fn offset(&self, u: &[f64], places: &[Range<usize>]) -> Vec3 {
        Vec3::from(self.start) + self.moved(u, places)
    }

    /// What a motion changes of the offset.
    fn moved(&self, motion: &[f64], places: &[Range<usize>]) -> Vec3 {
        self.across * Vec3::from_fn(|c, _| dot(&self.rows[c], motion, places))
    }

    /// g at |w|.
    fn gap(&self, distance: f64) -> f64 {
        if self.distance > 0.0 { self.distance - distance } else { distance + self.distance }
    }

    fn at(&self, u: &[f64], places: &[Range<usize>]) -> Kinematics<'_> {
        let offset = self.offset(u, places);
        let distance = offset.norm();
        let gap = self.gap(distance);
        let sign = if self.distance > 0.0 { -1.0 } else { 1.0 };
        let Some(m) = offset.try_normalize(0.0) else {
            let row = Cow::Owned(vec![0.0; self.rows[0].len()]);
            return Kinematics { gap, normal: [0.0; 3], row, bending: Vec::new() };
        };
        // ∂²|w|/∂w² = (I − m mᵀ)/|w| = Σ b bᵀ/|w| over two directions across m; ∂w/∂x = P.
        let first = m.cross(&Vec3::ith(m.iamin(), 1.0)).normalize();
        let across = [first, m.cross(&first)];
        let bending = across.map(|b| (sign / distance, self.along(&(self.across * b)))).into();
        Kinematics { gap, normal: (m * sign).into(), row: Cow::Owned(self.along(&(m * sign))), bending }
    }

    /// Derivatives of the motion in a direction.
    fn along(&self, direction: &Vec3) -> Vec<f64> {
        let [x, y, z] = &self.rows;
        x.iter().zip(y).zip(z).map(|((x, y), z)| direction.dot(&Vec3::new(*x, *y, *z))).collect()
    }
}

/// Σ row·u.
pub(crate) fn dot(row: &[f64], u: &[f64], places: &[Range<usize>]) -> f64 {
    row.iter().zip(places.iter().cloned().flatten()).map(|(d, f)| d * u[f]).sum()
}
