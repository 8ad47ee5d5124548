//! The work of a formula, ∫p dh from the reach on, to round-off.

/// ∫p at knots: between two knots Gauss's rule is exact to round-off.
#[derive(Clone, Debug)]
pub(super) struct Work {
    /// Overclosure beyond the reach [L] and work [F/L], ascending.
    knots: Vec<[f64; 2]>,
    /// Points in [−1, 1] and weights.
    rule: Vec<[f64; 2]>,
}

/// Points of the rule: on [a, 2a] its error for a power of x is below 6⁻²⁴ ≈ 1e-19 of the whole (its singularity, at 0,
/// lies on the Bernstein ellipse of sum 3 + √8).
const POINTS: usize = 12;
/// The pieces double in length, from 2⁻⁶⁰ to 2³ of the size.
const DOUBLINGS: std::ops::RangeInclusive<i32> = -60..=3;
/// A piece is halved so often at most (a kink or a jump inside is then met to round-off) ...
const HALVINGS: u32 = 50;
/// ... and into so many parts at most, where the rounding of p itself does not let halves and whole agree.
const PARTS: usize = 256;
/// Halves and whole agree to this part of the work so far [-].
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

impl Work {
    /// Of a pressure against the overclosure beyond the reach, with the size [L] of what it is asked for; it ends where the
    /// pressure is no number any more.
    pub fn new(pressure: impl Fn(f64) -> f64, size: f64) -> Self {
        let rule = fe_mesh::quadrature::Rule::line(POINTS).points.iter().map(|(x, w)| [x[0], *w]).collect();
        let mut work = Work { knots: vec![[0.0; 2]], rule };
        let mut from = 0.0;
        for power in DOUBLINGS {
            let to = size * 2f64.powi(power);
            let limit = work.knots.len() + PARTS;
            let whole = work.between(&pressure, [from, to]);
            if !whole.is_finite() {
                break;
            }
            work.refine(&pressure, ([from, to], whole), HALVINGS, limit);
            from = to;
        }
        work
    }

    /// The knots beyond the first.
    pub fn knots(&self) -> impl Iterator<Item = f64> {
        self.knots[1..].iter().map(|knot| knot[0])
    }

    /// ∫p from the reach to x ≥ 0 beyond it.
    pub fn until(&self, pressure: impl Fn(f64) -> f64, x: f64) -> f64 {
        let above = self.knots.partition_point(|knot| knot[0] <= x);
        let [from, work] = self.knots[above.saturating_sub(1)];
        work + self.between(&pressure, [from, x])
    }

    fn between(&self, pressure: &impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        half * self.rule.iter().map(|[x, weight]| weight * pressure(middle + half * x)).sum::<f64>()
    }

    fn refine(
        &mut self,
        pressure: &impl Fn(f64) -> f64,
        ([from, to], whole): ([f64; 2], f64),
        halvings: u32,
        limit: usize,
    ) {
        let middle = 0.5 * (from + to);
        let halves = [[from, middle], [middle, to]].map(|piece| (piece, self.between(pressure, piece)));
        let before = self.knots[self.knots.len() - 1][1];
        let sum = halves[0].1 + halves[1].1;
        let agree = (sum - whole).abs() <= ROUND_OFF * (before + sum).abs();
        if agree || halvings == 0 || self.knots.len() >= limit {
            for ([_, end], part) in halves {
                let so_far = self.knots[self.knots.len() - 1][1];
                self.knots.push([end, so_far + part]);
            }
            return;
        }
        for half in halves {
            self.refine(pressure, half, halvings - 1, limit);
        }
    }
}
