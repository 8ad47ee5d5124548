//! A law that a deck writes as a formula: `p = K * h^1.5`.
//!
//! The formula gives the pressure, for that is what is measured and drawn; its energy is integrated, to round-off, and its
//! stiffness is the exact derivative.

mod expression;
mod parse;
mod parser;
mod work;

use super::{NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use expression::{Dual, Node};
pub use parse::Fault;
use std::ops::Range;
use work::Work;

/// p(h) for h > −c, h the overclosure and c the reach, else 0.
#[derive(Clone, Debug)]
pub struct Formula {
    /// As written, line after line.
    text: String,
    pressure: Node,
    /// c [L].
    reach: f64,
    /// Size [L] of the model.
    size: f64,
    work: Work,
    /// Overclosures beyond the reach where one branch follows another, ascending.
    kinks: Vec<f64>,
    remarks: Vec<String>,
    /// See [`NormalLaw::typical_stiffness`].
    typical: f64,
    /// See [`NormalLaw::steepest`].
    steepest: f64,
}

/// Below this part of the model's size [-] a pressure may be that of rounding.
const SMALL: f64 = 1e-6;

impl Formula {
    /// From lines `name = expression`: `p` [F/L²] of the overclosure `h` [L] or the gap `g` = −h, `reach` [L] (0 when left
    /// out), and what they use. It is checked down to an overclosure of `size` [L], > 0, that of the model. Returns the law
    /// and the definitions that are used nowhere, or all that is wrong.
    pub fn new(lines: &[&str], size: f64) -> Result<(Self, Vec<Fault>), Vec<Fault>> {
        let parsed = parse::parse(lines)?;
        let (pressure, reach) = (parsed.pressure, parsed.reach);
        let work = Work::new(|x| pressure.at(x - reach).value, size);
        let text = lines.join("; ");
        let (kinks, remarks) = (Vec::new(), Vec::new());
        let mut law = Formula { text, pressure, reach, size, work, kinks, remarks, typical: 0.0, steepest: 0.0 };
        law.kinks = law.found_kinks();
        let (line, at) = parsed.place;
        law.soundness().map_err(|title| vec![Fault { line: Some(line), at, title, known: None }])?;
        law.remarks = [law.jump(), law.fall()].into_iter().flatten().collect();
        (law.typical, law.steepest) = (law.mean_slope(), law.largest_slope());
        Ok((law, parsed.unused))
    }

    /// Pressure and its slope at an overclosure beyond the reach.
    fn at(&self, x: f64) -> Dual {
        self.pressure.at(x - self.reach)
    }

    /// Overclosures beyond the reach from [`SMALL`] to the model's size, ascending.
    fn samples(&self) -> impl Iterator<Item = f64> {
        let range = SMALL * self.size..=self.size;
        let knots: Vec<f64> = self.work.knots().filter(|x| range.contains(x)).collect();
        let even = (1..=200).map(|i| self.size * f64::from(i) / 200.0);
        let mut all: Vec<f64> = knots.into_iter().chain(even).collect();
        all.sort_by(f64::total_cmp);
        all.into_iter()
    }

    /// A pressure that is no number, that pulls, or none at all; a pressure beyond all numbers is only very stiff.
    fn soundness(&self) -> Result<(), String> {
        for x in std::iter::once(0.0).chain(self.samples()) {
            let value = self.at(x).value;
            let h = x - self.reach;
            if value.is_nan() {
                return Err(format!("at the overclosure {h:.6e} [L] the pressure is no number"));
            }
            if value < 0.0 && (x > 0.0 || -value > SMALL * self.at(SMALL * self.size).value.abs()) {
                return Err(format!("at the overclosure {h:.6e} [L] the pressure is negative: {value:.6e}"));
            }
        }
        match self.samples().any(|x| self.at(x).value > 0.0) {
            true => Ok(()),
            false => Err(format!("there is no pressure down to the overclosure {:.6e} [L]", self.size - self.reach)),
        }
    }

    fn jump(&self) -> Option<String> {
        let (first, next) = (self.at(0.0).value, self.at(self.reach.max(SMALL * self.size)).value);
        // What rounding of −c leaves is no jump.
        (first > 1e-12 * next.min(f64::MAX)).then(|| {
            format!(
                "the pressure jumps from 0 to {first:.6e} at the clearance {:.6e} [L]: a load in between has no equilibrium",
                self.reach
            )
        })
    }

    fn fall(&self) -> Option<String> {
        let from = self.samples().find(|x| self.at(*x).slope < 0.0)? - self.reach;
        Some(format!(
            "the pressure falls at the overclosure {from:.6e} [L]: there may be several equilibria, or none that Newton's \
             method reaches"
        ))
    }

    /// The mean slope down to a thousandth of the model's size, or to where there is a pressure.
    fn mean_slope(&self) -> f64 {
        let mean = |x: f64| self.at(x).value / x;
        let depths = std::iter::once(1e-3 * self.size).chain(self.samples());
        depths.map(mean).find(|slope| *slope > 0.0 && slope.is_finite()).unwrap_or(0.0)
    }

    /// The largest slope down to the model's size.
    fn largest_slope(&self) -> f64 {
        std::iter::once(0.0).chain(self.samples()).fold(0.0, |most, x| self.at(x).slope.max(most))
    }

    /// Where one branch follows another: a sign changes between knots, and is halved down to round-off.
    fn found_kinks(&self) -> Vec<f64> {
        let mut kinks = Vec::new();
        for switch in self.pressure.switches().iter().filter(|switch| switch.number().is_none()) {
            let sign = |x: f64| switch.at(x - self.reach).value > 0.0;
            let mut low = 0.0;
            for high in self.work.knots() {
                if sign(low) != sign(high) {
                    kinks.push(halved(sign, [low, high]));
                }
                low = high;
            }
        }
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }
}

/// Where a sign changes in between, to round-off.
fn halved(sign: impl Fn(f64) -> bool, [mut low, mut high]: [f64; 2]) -> f64 {
    let below = sign(low);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        *(if sign(middle) == below { &mut low } else { &mut high }) = middle;
    }
}

impl NormalLaw for Formula {
    fn respond(&self, gap: f64) -> NormalResponse {
        let x = self.reach - gap;
        if x < 0.0 {
            return NormalResponse::default();
        }
        let Dual { value, slope } = self.at(x);
        // A pressure that rises vertically at first touch: its mean slope a little deeper.
        let small = SMALL * self.size;
        let stiffness = if slope.is_finite() { slope } else { self.at(x + small).slope };
        // p ≥ 0 was checked; less is rounding.
        let energy = self.work.until(|x| self.at(x).value, x).max(0.0);
        NormalResponse { energy, pressure: value.max(0.0), stiffness }
    }

    fn reach(&self) -> f64 {
        self.reach
    }

    fn kinks(&self, range: Range<f64>) -> Vec<f64> {
        self.kinks.iter().map(|x| self.reach - x).filter(|gap| range.contains(gap)).collect()
    }

    /// Its mean slope down to a thousandth of the model's size, or to where there is a pressure.
    fn typical_stiffness(&self) -> f64 {
        self.typical
    }

    /// Its largest slope down to the model's size.
    fn steepest(&self) -> f64 {
        self.steepest
    }

    fn words(&self, number: MeasureKind) -> String {
        let (reach, dimension) = (self.reach, number.dimension());
        format!(
            "FORMULA, [{dimension}] of the overclosure h [L]: {}; zero from the clearance {reach} [L] on",
            self.text
        )
    }

    fn remarks(&self) -> Vec<String> {
        self.remarks.clone()
    }
}

#[cfg(test)]
mod tests;
