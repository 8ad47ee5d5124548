//! What a pair turned out to be: for the plan of a step.

use crate::pair::Discretization;
use crate::point::Measure;
use fe_core::element::ElementType;

/// What the law's number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureKind {
    /// A pressure [F/L²].
    Pressure,
    /// A force per length [F/L].
    ForcePerLength,
    /// A force [F].
    Force,
}

impl MeasureKind {
    /// Of a point.
    pub fn of(measure: Measure) -> Self {
        match measure {
            Measure::Area(_) => MeasureKind::Pressure,
            Measure::Length(_) => MeasureKind::ForcePerLength,
            Measure::Point => MeasureKind::Force,
        }
    }

    /// As messages say it.
    pub fn words(self) -> &'static str {
        match self {
            MeasureKind::Pressure => "pressure",
            MeasureKind::ForcePerLength => "force per length",
            MeasureKind::Force => "force",
        }
    }

    /// Its dimension.
    pub fn dimension(self) -> &'static str {
        match self {
            MeasureKind::Pressure => "F/L²",
            MeasureKind::ForcePerLength => "F/L",
            MeasureKind::Force => "F",
        }
    }

    /// Dimension of a damping coefficient.
    pub fn damping_dimension(self) -> &'static str {
        match self {
            MeasureKind::Pressure => "F T/L³",
            MeasureKind::ForcePerLength => "F T/L²",
            MeasureKind::Force => "F T/L",
        }
    }

    /// Dimension of a stiffness against the gap.
    pub fn stiffness_dimension(self) -> &'static str {
        match self {
            MeasureKind::Pressure => "F/L³",
            MeasureKind::ForcePerLength => "F/L²",
            MeasureKind::Force => "F/L",
        }
    }
}

/// What stands on a penalty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Means {
    /// A penalty alone.
    Penalty,
    /// A penalty alone that grows up to an overclosure of so much [L].
    NonlinearPenalty(f64),
    /// A penalty, and multipliers until the overclosure is at most so much [L].
    AugmentedLagrange(f64),
    /// Multipliers, until the overclosure is that of rounding.
    Multipliers,
    /// A softened law in series with the penalty, and multipliers that take it out again.
    Mixed,
}

impl Means {
    /// True without multipliers.
    pub fn is_bare(self) -> bool {
        matches!(self, Means::Penalty | Means::NonlinearPenalty(_))
    }
}

/// The penalty beneath a contact, resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PenaltySummary {
    /// What it is there for.
    pub means: Means,
    /// Slope f K of pressure against overclosure, the final one of a nonlinear penalty (dimension by [`Summary::measure`]).
    pub stiffness: f64,
    /// True when K is the default.
    pub by_default: bool,
    /// Factor f [-].
    pub scale: f64,
    /// Clearance [L] at which the pressure vanishes.
    pub clearance: f64,
}

/// Where points come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A pair of surfaces: how the constraint is spread, after what the surfaces allow.
    Pair(Discretization),
    /// Contact elements, a point each.
    Elements(ElementType),
}

/// What a contact turned out to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Where its points come from.
    pub origin: Origin,
    /// The penalty; `None` for a softened law as it stands.
    pub penalty: Option<PenaltySummary>,
    /// Stiffness k_e [F/L³] of the elements beneath; the least of both sides.
    pub beneath: Option<f64>,
    /// Facets of both sides that a search sorted into boxes; `None` where nothing was searched (a rigid main side).
    pub searched: Option<usize>,
    /// Number of points.
    pub points: usize,
    /// What the law's number is (points with and without areas in one pair: that of the first).
    pub measure: MeasureKind,
}
