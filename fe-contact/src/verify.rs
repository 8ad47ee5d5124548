//! Whether a law is what it claims: pressure the slope of energy, stiffness that of pressure.

use crate::law::NormalLaw;
use std::ops::Range;

/// Where a law breaks its word.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum LawFault {
    /// p ≠ −dψ/dg.
    #[error("at a gap of {gap:e} the pressure is {pressure:e}, but the slope of the energy says {slope:e}")]
    Pressure {
        /// Gap [L].
        gap: f64,
        /// p.
        pressure: f64,
        /// −Δψ/Δg.
        slope: f64,
    },
    /// k ≠ −dp/dg.
    #[error("at a gap of {gap:e} the stiffness is {stiffness:e}, but the slope of the pressure says {slope:e}")]
    Stiffness {
        /// Gap [L].
        gap: f64,
        /// k.
        stiffness: f64,
        /// −Δp/Δg.
        slope: f64,
    },
    /// A number that is not finite, a negative pressure or energy.
    #[error("at a gap of {gap:e} energy or pressure is negative, or a number not finite")]
    Sign {
        /// Gap [L].
        gap: f64,
    },
    /// A negative stiffness.
    #[error("at a gap of {gap:e} the stiffness is negative: {stiffness:e}")]
    Softens {
        /// Gap [L].
        gap: f64,
        /// k.
        stiffness: f64,
    },
    /// Not zero beyond the reach.
    #[error("at a gap of {gap:e}, beyond the reach {reach:e}, the law is not zero")]
    Reach {
        /// Gap [L].
        gap: f64,
        /// Reach [L].
        reach: f64,
    },
}

/// Intervals that the range is cut into.
const INTERVALS: usize = 200;
/// Bound on |difference − slope|, of the largest slope in the range [-].
const BOUND: f64 = 1e-5;

/// Differences of a right law agree with its slopes at one of these parts of the first step at the latest: smaller ones meet
/// less of its curvature, and rounding is still below the bound [-].
const STEPS: [f64; 3] = [1.0, 1e-1, 1e-2];

/// Checks a law near its reach and down to an overclosure of `size` [L], > 0, that of a model: over ranges each a sixteenth
/// of the one before, so that the smallest lengths of a law count, too. Ranges where its numbers grow beyond all bounds are
/// left out.
pub fn at_all_scales(law: &dyn NormalLaw, size: f64) -> Result<(), LawFault> {
    for power in 0..5 {
        let depth = size * 16f64.powi(-power);
        let reach = law.reach();
        let deepest = law.respond(reach - depth);
        let bounded = [deepest.energy, deepest.pressure, deepest.stiffness].iter().all(|v| *v != f64::INFINITY);
        // Nearer than this the rounding of the reach itself shows in differences.
        if bounded && depth > 1e-3 * reach.abs() {
            self::law(law, reach - depth..reach + 0.1 * depth)?;
        }
    }
    Ok(())
}

/// Checks a law over a range of gaps [L] by central differences in the middle of 200 intervals, with a step of 1e-4 of
/// an interval: truncation is of order (step / curvature length)², round-off 1e-16 over the relative step 5e-7. Both
/// are below the bound of 1e-5 of the largest value. Intervals that hold the reach or a kink that the law names, and
/// their neighbours, are not compared by slope.
pub fn law(law: &dyn NormalLaw, range: Range<f64>) -> Result<(), LawFault> {
    let width = (range.end - range.start) / INTERVALS as f64;
    let step = 1e-4 * width;
    let gaps: Vec<f64> = (0..INTERVALS).map(|i| range.start + width * (i as f64 + 0.5)).collect();
    let largest = |of: fn(&crate::law::NormalResponse) -> f64| {
        gaps.iter().map(|&g| of(&law.respond(g)).abs()).fold(f64::MIN_POSITIVE, f64::max)
    };
    let (pressures, stiffnesses) = (largest(|r| r.pressure), largest(|r| r.stiffness));
    let reach = law.reach();
    let mut kinks = law.kinks(range);
    kinks.push(reach);
    for &gap in &gaps {
        let at = law.respond(gap);
        let numbers = [at.energy, at.pressure, at.stiffness];
        if numbers.iter().any(|&v| !v.is_finite()) || at.energy < 0.0 || at.pressure < 0.0 {
            return Err(LawFault::Sign { gap });
        }
        if at.stiffness < 0.0 {
            return Err(LawFault::Softens { gap, stiffness: at.stiffness });
        }
        if gap > reach && numbers != [0.0; 3] {
            return Err(LawFault::Reach { gap, reach });
        }
        if kinks.iter().any(|kink| (gap - kink).abs() <= width) {
            continue;
        }
        let slopes = STEPS.map(|part| slopes(law, gap, part * step));
        if slopes.iter().all(|[slope, _]| (slope - at.pressure).abs() > BOUND * pressures) {
            return Err(LawFault::Pressure { gap, pressure: at.pressure, slope: slopes[0][0] });
        }
        if slopes.iter().all(|[_, slope]| (slope - at.stiffness).abs() > BOUND * stiffnesses) {
            return Err(LawFault::Stiffness { gap, stiffness: at.stiffness, slope: slopes[0][1] });
        }
    }
    Ok(())
}

/// −Δψ/Δg and −Δp/Δg around a gap.
fn slopes(law: &dyn NormalLaw, gap: f64, step: f64) -> [f64; 2] {
    let (low, high) = (law.respond(gap - step), law.respond(gap + step));
    [low.energy - high.energy, low.pressure - high.pressure].map(|difference| difference / (2.0 * step))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::linear::Linear;
    use crate::law::{Laws, NormalResponse};

    #[test]
    fn every_law_keeps_its_word() {
        for definition in Laws::standard().0 {
            assert_eq!(definition.example.len() % definition.data.len(), 0, "{}", definition.keyword);
            let example = (definition.build)(definition.example).unwrap();
            law(&*example, -1.0..1.0).unwrap();
            // The part where it begins, which a stiff law hides in the whole.
            law(&*example, -0.1..example.reach() + 0.1).unwrap();
            for size in [1e-3, 1.0, 1e3, 1e6] {
                at_all_scales(&*example, size).unwrap();
            }
        }
        for clearance in [0.0, 0.25, -0.1] {
            law(&Linear { slope: 7e5, clearance }, -1.0..1.0).unwrap();
        }
    }

    #[derive(Debug)]
    struct Wrong(fn(f64) -> NormalResponse);

    impl NormalLaw for Wrong {
        fn respond(&self, gap: f64) -> NormalResponse {
            self.0(gap.min(0.0))
        }
    }

    #[test]
    fn broken_laws_are_found() {
        let twice = Wrong(|g| NormalResponse { energy: g * g, pressure: -g, stiffness: 1.0 });
        assert!(matches!(law(&twice, -1.0..0.5), Err(LawFault::Pressure { .. })));
        // A slip that only shows in the millionth part of a model.
        let slip = Wrong(|g| {
            let k = if g > -1e-6 { 1.0 } else { 2.0 };
            NormalResponse { energy: 0.5 * g * g, pressure: -g, stiffness: k }
        });
        assert!(matches!(at_all_scales(&slip, 1.0), Err(LawFault::Stiffness { .. })));
        let soft = Wrong(|g| NormalResponse { energy: 0.5 * g * g, pressure: -g, stiffness: 0.5 });
        assert!(matches!(law(&soft, -1.0..-0.1), Err(LawFault::Stiffness { .. })));
        let falling = Wrong(|g| NormalResponse { energy: -g, pressure: 1.0, stiffness: -1.0 });
        assert!(matches!(law(&falling, -1.0..0.5), Err(LawFault::Softens { .. })));
        let pulling = Wrong(|g| NormalResponse { energy: 0.0, pressure: g, stiffness: 0.0 });
        assert!(matches!(law(&pulling, -1.0..0.5), Err(LawFault::Sign { .. })));
        let far = Wrong(|_| NormalResponse { energy: 1.0, ..Default::default() });
        assert!(matches!(law(&far, -1.0..0.5), Err(LawFault::Reach { .. })));
    }
}
