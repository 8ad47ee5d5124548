//! A law in series with a spring, as multipliers need it: softer than either, with the same pressure through both.

use super::{NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::ops::Range;
use std::sync::Arc;

/// The law asked at the gap x that its own pressure leaves of g: p(x) = K (x − g). Its slope is k K/(k + K).
/// It is the proximal regularisation of the law's energy (Moreau 1965): convex wherever the law is.
#[derive(Clone, Debug)]
pub struct InSeries {
    /// The law.
    pub law: Arc<dyn NormalLaw>,
    /// K [F/L³].
    pub spring: f64,
}

/// Most iterations for x: Newton's method takes one or two for each piece of a law, bisection halves the rest.
const ITERATIONS: usize = 200;

impl InSeries {
    /// x, and the law's answer there.
    fn within(&self, gap: f64) -> (f64, NormalResponse) {
        // p(x) − K (x − g) falls from p(g) ≥ 0 on; it is 0 at the reach at the latest, or where the spring takes p(g).
        let first = self.law.respond(gap);
        let (mut low, mut high) = (gap, self.law.reach().min(gap + first.pressure / self.spring).max(gap));
        let (mut x, mut answer) = (gap, first);
        for _ in 0..ITERATIONS {
            let lacking = answer.pressure - self.spring * (x - gap);
            *(if lacking > 0.0 { &mut low } else { &mut high }) = x;
            let newton = x + lacking / (answer.stiffness + self.spring);
            let round_off = f64::EPSILON * low.abs().max(high.abs());
            if (newton - x).abs() <= f64::EPSILON * x.abs() || high - low <= round_off {
                break;
            }
            x = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
            answer = self.law.respond(x);
        }
        (x, answer)
    }
}

impl NormalLaw for InSeries {
    fn respond(&self, gap: f64) -> NormalResponse {
        if gap > self.law.reach() {
            return self.law.respond(gap);
        }
        let (x, answer) = self.within(gap);
        // Of both pressures the one that the rounding of x disturbs less.
        let pressure = if answer.stiffness > self.spring { self.spring * (x - gap).max(0.0) } else { answer.pressure };
        NormalResponse {
            energy: answer.energy + 0.5 * pressure * pressure / self.spring,
            pressure,
            stiffness: answer.stiffness * self.spring / (answer.stiffness + self.spring),
        }
    }

    fn reach(&self) -> f64 {
        self.law.reach()
    }

    fn kinks(&self, range: Range<f64>) -> Vec<f64> {
        // Where the law has a kink at x, the series has it at g = x − p(x)/K; x lies between g and the reach.
        let kinks = self.law.kinks(range.start..self.reach());
        let shifted = kinks.into_iter().map(|x| x - self.law.respond(x).pressure / self.spring);
        shifted.filter(|g| range.contains(g)).collect()
    }

    fn typical_stiffness(&self) -> f64 {
        let stiffness = self.law.typical_stiffness();
        stiffness * self.spring / (stiffness + self.spring)
    }

    fn steepest(&self) -> f64 {
        self.spring.min(self.law.steepest())
    }

    fn words(&self, number: MeasureKind) -> String {
        self.law.words(number)
    }

    fn remarks(&self) -> Vec<String> {
        self.law.remarks()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Laws;
    use crate::verify::law;

    /// Every law in series with springs from far softer to far stiffer than itself: the pressure passes through both, and
    /// the series keeps a law's word.
    #[test]
    fn the_same_pressure_passes_through_both() {
        for definition in Laws::standard().0 {
            let inner = (definition.build)(definition.example).unwrap();
            for part in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
                let series = InSeries { law: inner.clone(), spring: part * inner.typical_stiffness() };
                law(&series, -1.0..2.0 * inner.reach().max(0.5)).unwrap();
                for gap in [-1.0, -0.1, -1e-3, -1e-9, 0.5 * inner.reach()] {
                    let answer = series.respond(gap);
                    let x = gap + answer.pressure / series.spring;
                    let again = inner.respond(x);
                    // x is known to an ε of itself and of g.
                    let error = f64::EPSILON * (gap.abs() + x.abs()) * (again.stiffness + series.spring);
                    let bound = 8.0 * (error + f64::EPSILON * answer.pressure);
                    assert!((again.pressure - answer.pressure).abs() <= bound, "{definition:?} {part} {gap}");
                }
            }
        }
    }
}
