//! The scale-factor law: straight pieces, each stiffer than the one before by the same factor.

use super::{NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::ops::Range;

/// Where a piece ends: over so much overclosure the slope grows by the factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// The overclosure measure d [L], > 0.
    Measure(f64),
    /// d as this part [-] of the smallest element in the contact region, > 0.
    OfElement(f64),
}

/// What a deck says of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// Length of a piece.
    pub piece: Piece,
    /// Factor s [-] from one slope to the next, > 1.
    pub scale: f64,
    /// Factor s₀ [-] on the default stiffness for the first slope, > 0.
    pub initial: f64,
}

impl Scaling {
    /// From the fields of the data line: the overclosure factor or the overclosure measure, then s and s₀; each in its
    /// range.
    pub fn new(factor: Option<f64>, measure: Option<f64>, scale: f64, initial: f64) -> Result<Self, String> {
        let piece = match (factor, measure) {
            (Some(factor), None) => Piece::OfElement(factor),
            (None, Some(measure)) => Piece::Measure(measure),
            (Some(_), Some(_)) => return Err("overclosure factor and overclosure measure exclude each other".into()),
            (None, None) => return Err("overclosure factor or overclosure measure must be given".into()),
        };
        Ok(Scaling { piece, scale, initial })
    }

    /// The law over a default contact stiffness [F/L³], with the length [L] of the smallest element of the contact
    /// region.
    pub fn over(self, stiffness: f64, smallest_element: f64) -> ScaleFactor {
        let piece = match self.piece {
            Piece::Measure(d) => d,
            Piece::OfElement(r) => r * smallest_element,
        };
        ScaleFactor { piece, scale: self.scale, slope: self.initial * stiffness }
    }
}

/// p = k [d (sᵐ − 1)/(s − 1) + sᵐ (h − m d)] with m = ⌊h/d⌋ for h > 0, k the first slope: slope k sᵐ between m d and
/// (m + 1) d. Abaqus Analysis User's Manual, Contact pressure-overclosure relationships; general contact in Explicit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleFactor {
    /// d [L].
    piece: f64,
    /// s [-].
    scale: f64,
    /// k [F/L³].
    slope: f64,
}

impl NormalLaw for ScaleFactor {
    fn respond(&self, gap: f64) -> NormalResponse {
        if gap > 0.0 {
            return NormalResponse::default();
        }
        let (d, s, k) = (self.piece, self.scale, self.slope);
        let m = (-gap / d).floor();
        let grown = s.powf(m);
        let beyond = -gap - m * d;
        let sum = (grown - 1.0) / (s - 1.0);
        let (start, stiffness) = (k * d * sum, k * grown);
        // ∫p up to m d: the pieces' k d² [(sⁱ − 1)/(s − 1) + sⁱ/2] for i < m.
        let passed = k * d * d * ((sum - m) / (s - 1.0) + 0.5 * sum);
        NormalResponse {
            energy: passed + (start + 0.5 * stiffness * beyond) * beyond,
            pressure: start + stiffness * beyond,
            stiffness,
        }
    }

    fn kinks(&self, range: Range<f64>) -> Vec<f64> {
        let deepest = (-range.start / self.piece).floor().max(0.0) as usize;
        (1..=deepest).map(|i| -(i as f64) * self.piece).filter(|g| range.contains(g)).collect()
    }

    fn words(&self, number: MeasureKind) -> String {
        let (d, s, k) = (self.piece, self.scale, self.slope);
        format!("SCALE FACTOR, first slope {k} [{}], times {s} after every {d} [L]", number.stiffness_dimension())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::work_by_quadrature;
    use crate::verify;

    fn law() -> ScaleFactor {
        Scaling::new(None, Some(0.02), 2.0, 1.0).unwrap().over(2000.0, 7.0)
    }

    #[test]
    fn a04_scale_factor_law() {
        for (h, pressure) in [(0.0, 0.0), (0.01, 20.0), (0.02, 40.0), (0.03, 80.0), (0.05, 200.0), (0.1, 1240.0)] {
            let at = law().respond(-h);
            assert!((at.pressure - pressure).abs() <= 1e-12 * pressure, "{h}: {at:?}");
        }
        assert_eq!(law().respond(1e-9), NormalResponse::default());
        // Another set: k = 10, s₀ = 1, s = 2, d = 0.1.
        let other = Scaling::new(Some(0.05), None, 2.0, 0.5).unwrap().over(20.0, 2.0);
        for (h, pressure) in [(0.05, 0.5), (0.1, 1.0), (0.15, 2.0), (0.2, 3.0), (0.25, 5.0), (0.3, 7.0)] {
            assert!((other.respond(-h).pressure - pressure).abs() <= 1e-12 * pressure, "{h}");
        }
    }

    #[test]
    fn energy_is_work() {
        for h in [0.005, 0.02, 0.031, 0.1, 0.153] {
            let work = work_by_quadrature(&law(), h, 1);
            assert!((law().respond(-h).energy - work).abs() <= 1e-12 * work, "{h}: {work}");
        }
        verify::law(&law(), -0.11..0.03).unwrap();
    }

    #[test]
    fn one_of_factor_and_measure() {
        assert!(Scaling::new(Some(0.1), Some(0.1), 2.0, 1.0).is_err_and(|e| e.contains("exclude")));
        assert!(Scaling::new(None, None, 2.0, 1.0).is_err_and(|e| e.contains("must be given")));
    }
}
