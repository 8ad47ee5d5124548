//! The exponential law p = p₀/(e−1) z (eᶻ − 1), z = 1 + h/c₀.

use super::{Datum, LawDefinition, Lines, NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::f64::consts::E;
use std::sync::Arc;

/// The law is straight beyond an overclosure of so many c₀ [-]: Abaqus Theory Manual 5.2.1 has such a limit.
pub const STRAIGHT_BEYOND: f64 = 6.0;

/// p = p₀/(e−1) z (eᶻ − 1) with z = 1 + h/c₀ > 0, else 0: p(−c₀) = 0 without slope, p(0) = p₀. Beyond h = 6 c₀, or
/// where the slope reaches a largest one, it goes on straight with p and slope continuous.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// c₀ [L], > 0.
    clearance: f64,
    /// p₀ [F/L²], > 0.
    pressure: f64,
    /// Largest slope k_max [F/L³].
    stiffest: f64,
    /// z from which on the law is straight.
    end: f64,
}

/// eᶻ (z+1) − 1: the slope dp/dh in units of p₀/(c₀(e−1)). At z → 0 it is 2z.
fn slope(z: f64) -> f64 {
    z.exp_m1() * (z + 1.0) + z
}

/// ∫₀ᶻ t (eᵗ − 1) dt = eᶻ (z − 1) + 1 − z²/2, below 1 by its series Σ zⁿ⁺²/((n+2) n!), which does not cancel.
fn integral(z: f64) -> f64 {
    if z >= 1.0 {
        return z.exp_m1() * (z - 1.0) + z - 0.5 * z * z;
    }
    let (mut sum, mut power) = (0.0, z * z);
    // The 20th term is below 1e-19 of the first.
    for n in 1..20 {
        power *= z / n as f64;
        sum += power / (n + 2) as f64;
    }
    sum
}

impl Exponential {
    /// c₀ [L] and p₀ [F/L²], both > 0.
    pub fn new(clearance: f64, pressure: f64) -> Self {
        Exponential { clearance, pressure, stiffest: f64::INFINITY, end: 1.0 + STRAIGHT_BEYOND }
    }

    /// Straight from the overclosure on where the slope reaches `stiffest` [F/L³], > 0.
    pub fn limited(self, stiffest: f64) -> Self {
        let wanted = stiffest / self.unit_slope();
        let mut end = 1.0 + STRAIGHT_BEYOND;
        if wanted < slope(end) {
            // The slope is convex in z: Newton's method from above comes down without overshoot.
            loop {
                let next = end - (slope(end) - wanted) / (end.exp() * (end + 2.0));
                if next >= end {
                    break;
                }
                end = next;
            }
        }
        Exponential { stiffest, end: end.max(0.0), ..self }
    }

    /// p₀/(c₀(e−1)) [F/L³].
    fn unit_slope(&self) -> f64 {
        self.pressure / (self.clearance * (E - 1.0))
    }

    /// Overclosure [L] from which on the law is straight.
    pub fn straight_from(&self) -> f64 {
        (self.end - 1.0) * self.clearance
    }
}

impl NormalLaw for Exponential {
    fn respond(&self, gap: f64) -> NormalResponse {
        let z = 1.0 - gap / self.clearance;
        if z <= 0.0 {
            return NormalResponse::default();
        }
        let unit = self.pressure / (E - 1.0);
        let curved = z.min(self.end);
        let beyond = (z - curved) * self.clearance;
        let pressure = unit * curved * curved.exp_m1();
        let stiffness = self.unit_slope() * slope(curved);
        NormalResponse {
            energy: unit * self.clearance * integral(curved) + (pressure + 0.5 * stiffness * beyond) * beyond,
            pressure: pressure + stiffness * beyond,
            stiffness,
        }
    }

    fn reach(&self) -> f64 {
        self.clearance
    }

    /// p₀/c₀: its slope at first touch is 0.
    fn typical_stiffness(&self) -> f64 {
        self.pressure / self.clearance
    }

    fn steepest(&self) -> f64 {
        self.unit_slope() * slope(self.end)
    }

    fn words(&self, number: MeasureKind) -> String {
        let (c, p, from) = (self.clearance, self.pressure, self.straight_from());
        let limit =
            if self.stiffest.is_finite() { format!(", slope at most {}", self.stiffest) } else { String::new() };
        let (pressure, stiffness) = (number.dimension(), number.stiffness_dimension());
        let at_zero = self.respond(0.0).stiffness;
        format!(
            "EXPONENTIAL, {p} [{pressure}] at zero clearance with slope {at_zero:.6e} [{stiffness}], 0 at the clearance \
             {c} [L], straight beyond an overclosure of {from} [L]{limit}"
        )
    }
}

/// As decks name it.
pub const DEFINITION: LawDefinition = LawDefinition {
    keyword: "EXPONENTIAL",
    summary: "p = p0/(e-1) z (exp(z) - 1), z = 1 + h/c0 > 0; straight beyond h = 6 c0",
    source: "Abaqus Theory Manual 5.2.1, its limit taken as 6 c0",
    data: &[
        Datum::positive("clearance", "L", "clearance c0 at which the pressure vanishes"),
        Datum::positive("pressure", "F/L²", "pressure p0 at zero clearance"),
        Datum::positive("largest slope", "F/L³", "in Explicit: slope from which on the law is straight")
            .or(f64::INFINITY, "no limit")
            .explicit(),
    ],
    lines: Lines::One,
    example: &[0.3, 200.0, f64::INFINITY],
    build: |data| {
        let law = Exponential::new(data[0], data[1]).limited(data[2]);
        let steepest = law.respond(-law.straight_from()).stiffness;
        match steepest.is_finite() && steepest > 0.0 {
            true => Ok(Arc::new(law)),
            false => {
                Err(format!("the slope p0/c0 = {:e}/{:e} is no number that can be computed with", data[1], data[0]))
            }
        }
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::work_by_quadrature;
    use crate::verify;

    /// Of an algebraic value, against figures given to 16 digits.
    const ALGEBRAIC: f64 = 1e-12;

    fn close(what: &str, got: f64, expected: f64) {
        assert!((got - expected).abs() <= ALGEBRAIC * expected.abs(), "{what}: {got}, not {expected}");
    }

    /// A03, by mpmath with 50 digits.
    #[test]
    fn a03_exponential_law() {
        let law = Exponential::new(0.05, 200.0);
        for (h, pressure, slope) in [
            (-0.06, 0.0, 0.0),
            (-0.05, 0.0, 0.0),
            (-0.025, 37.75406687981455, 3429.197426527526),
            (0.0, 200.0, 10327.9068274773),
            (0.05, 1487.312731383618, 49275.19559646315),
            (0.1, 6664.402756433819, 184701.1273206671),
            (0.3, 892686.1684706457, 20420550.62712139),
            (0.4, 2934741.231182787, 20420550.62712139),
        ] {
            let at = law.respond(-h);
            close(&format!("p({h})"), at.pressure, pressure);
            close(&format!("k({h})"), at.stiffness, slope);
        }
    }

    /// A03 with k_max = 3e4.
    #[test]
    fn a03_largest_slope() {
        let law = Exponential::new(0.05, 200.0).limited(3e4);
        close("h*", law.straight_from(), 0.0327324462446657);
        for (h, pressure) in
            [(0.0327324462446657, 814.9095953929226), (0.05, 1332.936208052952), (0.1, 2832.936208052952)]
        {
            close(&format!("p({h})"), law.respond(-h).pressure, pressure);
        }
        close("k", law.respond(-0.2).stiffness, 3e4);
        // Never reached before 6 c₀: the law as it is; so small that the law is straight nearly at once.
        assert_eq!(Exponential::new(0.05, 200.0).limited(1e9).end, 7.0);
        let soft = Exponential::new(0.05, 200.0).limited(1e-9);
        close("soft", soft.respond(-1.0).stiffness, 1e-9);
    }

    /// The energy is the work of the pressure, from first touch to deep in the straight part.
    #[test]
    fn energy_is_work() {
        for law in [Exponential::new(0.05, 200.0), Exponential::new(0.05, 200.0).limited(3e4)] {
            for h in [-0.0499, -0.03, 0.0, 1e-3, 0.05, 0.2, 0.3, 0.7] {
                // The straight part begins at a jump of the curvature: pieces end there.
                let until = f64::min(h, law.straight_from());
                let beyond = h - until;
                let at = law.respond(-until);
                let work = work_by_quadrature(&law, until, 8) + (at.pressure + 0.5 * at.stiffness * beyond) * beyond;
                close(&format!("{h}"), law.respond(-h).energy, work);
            }
        }
    }

    /// Near first touch p → p₀ z²/(e−1), k → 2 p₀ z/(c₀ (e−1)), ψ → p₀ c₀ z³/(3 (e−1)), each with a relative error
    /// of order z; nothing cancels.
    #[test]
    fn first_touch_keeps_all_digits() {
        let law = Exponential::new(1.0, E - 1.0);
        for z in [1e-4f64, 1e-6, 2f64.powi(-40)] {
            let gap = 1.0 - z;
            let z = 1.0 - gap;
            let at = law.respond(gap);
            assert!((at.pressure / (z * z) - 1.0 - 0.5 * z).abs() <= z * z + 4.0 * f64::EPSILON);
            assert!((at.stiffness / (2.0 * z) - 1.0 - 0.75 * z).abs() <= z * z + 4.0 * f64::EPSILON);
            assert!((at.energy / (z * z * z / 3.0) - 1.0 - 0.375 * z).abs() <= z * z + 4.0 * f64::EPSILON);
        }
    }

    #[test]
    fn it_keeps_its_word() {
        for law in [Exponential::new(0.05, 200.0), Exponential::new(0.05, 200.0).limited(3e4)] {
            for range in [-0.06..0.06, -0.04..0.0, -0.4..0.1] {
                verify::law(&law, range).unwrap();
            }
        }
        verify::law(&Exponential::new(1e-11, 50.0), -1e-11..2e-11).unwrap();
    }

    #[test]
    fn slopes_beyond_numbers_are_refused() {
        assert!((DEFINITION.build)(&[1e-300, 1e300, f64::INFINITY]).is_err_and(|e| e.contains("p0/c0")));
        assert!((DEFINITION.build)(&[1e300, 1e-300, f64::INFINITY]).is_err());
        assert!((DEFINITION.build)(&[0.05, 200.0, 3e4]).is_ok());
    }
}
