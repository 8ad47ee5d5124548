//! The nonlinear penalty: soft where surfaces begin to touch, stiff where they press.

use super::{NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::ops::Range;

/// With the overclosure x = h + c: p = K_i x up to x_e, a slope that grows straight from K_i to K_f between x_e and x_d, and
/// K_f from there on: p = p_e + K_i (x − x_e) + (K_f − K_i)(x − x_e)²/(2 (x_d − x_e)), p = p_d + K_f (x − x_d). Abaqus Analysis
/// User's Manual, Contact constraint enforcement methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NonlinearPenalty {
    /// Slopes K_i and K_f [F/L³], > 0.
    pub slopes: [f64; 2],
    /// Overclosures x_e ≤ x_d [L], ≥ 0, between which the slope grows.
    pub limits: [f64; 2],
    /// Clearance c [L] at which the pressure vanishes.
    pub clearance: f64,
}

impl NormalLaw for NonlinearPenalty {
    fn respond(&self, gap: f64) -> NormalResponse {
        let x = self.clearance - gap;
        if x < 0.0 {
            return NormalResponse::default();
        }
        let ([soft, stiff], [lower, upper]) = (self.slopes, self.limits);
        let width = upper - lower;
        // With a stiffness k at its start and a rate r of it, a piece of length s adds to energy and pressure.
        let piece = |from: NormalResponse, s: f64, rate: f64| NormalResponse {
            energy: from.energy + (from.pressure + (0.5 * from.stiffness + rate * s / 6.0) * s) * s,
            pressure: from.pressure + (from.stiffness + 0.5 * rate * s) * s,
            stiffness: from.stiffness + rate * s,
        };
        let start = NormalResponse { stiffness: soft, ..NormalResponse::default() };
        let before = piece(start, x.min(lower), 0.0);
        if x < lower {
            return before;
        }
        if x < upper {
            return piece(before, x - lower, (stiff - soft) / width);
        }
        let grown = if width > 0.0 { piece(before, width, (stiff - soft) / width) } else { before };
        piece(NormalResponse { stiffness: stiff, ..grown }, x - upper, 0.0)
    }

    fn reach(&self) -> f64 {
        self.clearance
    }

    /// The stiffness is continuous unless both limits are one.
    fn kinks(&self, range: Range<f64>) -> Vec<f64> {
        self.limits.iter().map(|x| self.clearance - x).filter(|gap| range.contains(gap)).collect()
    }

    fn steepest(&self) -> f64 {
        self.slopes[0].max(self.slopes[1])
    }

    fn words(&self, number: MeasureKind) -> String {
        let ([soft, stiff], [lower, upper]) = (self.slopes, self.limits);
        let dimension = number.stiffness_dimension();
        if upper == 0.0 {
            return format!("slope {stiff:.6e} [{dimension}] at once, as no facet gives a length");
        }
        format!(
            "slope {soft:.6e} [{dimension}] up to an overclosure of {lower:.3e} [L], growing to {stiff:.6e} [{dimension}] at \
             {upper:.3e} [L]"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::work_by_quadrature;
    use crate::verify;

    fn law(clearance: f64) -> NonlinearPenalty {
        NonlinearPenalty { slopes: [1.0, 100.0], limits: [0.01, 0.03], clearance }
    }

    /// The table, and the slopes K_i, K_i, the mean, K_f and K_f there.
    #[test]
    fn a01_nonlinear_penalty() {
        for clearance in [0.0, 0.02] {
            for (x, pressure, stiffness) in
                [(0.005, 0.005, 1.0), (0.01, 0.01, 1.0), (0.02, 0.2675, 50.5), (0.03, 1.02, 100.0), (0.04, 2.02, 100.0)]
            {
                let at = law(clearance).respond(clearance - x);
                assert!((at.pressure - pressure).abs() <= 1e-13 * pressure, "{x}: {at:?}");
                // Rounding of x, against the length over which the slope grows.
                assert!((at.stiffness - stiffness).abs() <= 1e-12 * 100.0, "{x}: {at:?}");
            }
            assert_eq!(law(clearance).respond(clearance + 1e-9), NormalResponse::default());
        }
    }

    #[test]
    fn it_keeps_its_word() {
        for law in [law(0.0), law(0.02), NonlinearPenalty { limits: [0.0, 0.03], ..law(0.0) }] {
            for h in [0.004, 0.012, 0.03, 0.07] {
                let work = work_by_quadrature(&law, h, 1);
                assert!((law.respond(-h).energy - work).abs() <= 1e-12 * work, "{h}: {work}");
            }
            verify::law(&law, -0.05..0.03).unwrap();
            verify::at_all_scales(&law, 1.0).unwrap();
        }
        // Without a length the slope is K_f at once.
        let at_once = NonlinearPenalty { limits: [0.0; 2], ..law(0.0) };
        verify::law(&at_once, -0.05..0.03).unwrap();
        assert_eq!(at_once.respond(-0.5).pressure, 50.0);
    }
}
