//! The linear law p = k h, h = −g > 0; also a penalty with a clearance.

use super::{Datum, LawDefinition, Lines, NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::sync::Arc;

/// p = k (c − g) for g < c, else 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// Slope k [F/L³], > 0.
    pub slope: f64,
    /// Clearance c [L] at which the pressure vanishes.
    pub clearance: f64,
}

impl NormalLaw for Linear {
    fn respond(&self, gap: f64) -> NormalResponse {
        let h = self.clearance - gap;
        if h < 0.0 {
            return NormalResponse::default();
        }
        NormalResponse { energy: 0.5 * self.slope * h * h, pressure: self.slope * h, stiffness: self.slope }
    }

    fn reach(&self) -> f64 {
        self.clearance
    }

    fn steepest(&self) -> f64 {
        self.slope
    }

    fn words(&self, number: MeasureKind) -> String {
        format!("LINEAR, slope {} [{}]", self.slope, number.stiffness_dimension())
    }
}

/// As decks name it.
pub const DEFINITION: LawDefinition = LawDefinition {
    keyword: "LINEAR",
    summary: "p = k h for an overclosure h > 0",
    source: "Abaqus Analysis User's Manual, Contact pressure-overclosure relationships",
    data: &[Datum::positive("slope", "F/L³", "slope k of the pressure-overclosure curve")],
    lines: Lines::One,
    example: &[4000.0],
    build: |data| Ok(Arc::new(Linear { slope: data[0], clearance: 0.0 })),
};
