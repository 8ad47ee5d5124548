//! The coefficient of friction: a number, a table over slip rate and pressure, or one that decays with the slip rate.

/// μ [-].
#[derive(Clone, Debug, PartialEq)]
pub enum Coefficient {
    /// Everywhere the same.
    Constant(f64),
    /// Groups of like pressure, pressures ascending, each with its slip rates [L/T], ascending, and μ there: linear
    /// between, constant outside.
    Table(Vec<(f64, Vec<(f64, f64)>)>),
    /// μ = μ_k + (μ_s − μ_k) exp(−d γ̇).
    Decay {
        /// μ_s at rest.
        rest: f64,
        /// μ_k at high slip rates.
        kinetic: f64,
        /// d [T/L].
        decay: f64,
    },
    /// On the way from one to another.
    Between(Box<[Coefficient; 2]>, f64),
}

/// μ and its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Value {
    /// μ [-].
    pub value: f64,
    /// ∂μ/∂γ̇ [T/L].
    pub by_rate: f64,
    /// ∂μ/∂p, p in the law's unit.
    pub by_pressure: f64,
}

/// How near μ₂ of test data is to what it decays to: (μ₂ − μ_∞)/(μ₁ − μ_∞) where μ_∞ is not given [-] (Abaqus Analysis
/// User's Manual, Frictional behavior).
const DECAYED: f64 = 0.05;

impl Coefficient {
    /// A table from rows (μ, γ̇, p): rows of like pressure follow each other.
    pub fn table(rows: &[(f64, f64, f64)]) -> Result<Self, String> {
        if let [(value, ..)] = rows {
            return Ok(Coefficient::Constant(*value));
        }
        let mut groups: Vec<(f64, Vec<(f64, f64)>)> = Vec::new();
        for &(value, rate, pressure) in rows {
            match groups.last_mut() {
                Some((p, rates)) if *p == pressure => {
                    if rates.last().is_some_and(|last| last.0 >= rate) {
                        return Err(format!("slip rates at a pressure of {pressure} do not rise: {rate}"));
                    }
                    rates.push((rate, value));
                }
                Some((p, _)) if *p > pressure => return Err(format!("pressures do not rise: {pressure} after {p}")),
                _ => groups.push((pressure, vec![(rate, value)])),
            }
        }
        Ok(Coefficient::Table(groups))
    }

    /// A decay from μ_s at rest to μ_k, by d [T/L].
    pub fn decay(rest: f64, kinetic: f64, decay: f64) -> Result<Self, String> {
        if kinetic > rest {
            return Err(format!("the coefficient decays from {rest} at rest, and cannot rise to {kinetic}"));
        }
        Ok(Coefficient::Decay { rest, kinetic, decay })
    }

    /// A decay through μ₁ at rest and μ₂ at a slip rate [L/T]; `limit` is μ_∞, where it is known.
    pub fn decay_through(rest: f64, (second, rate): (f64, f64), limit: Option<f64>) -> Result<Self, String> {
        let kinetic = limit.unwrap_or((second - DECAYED * rest) / (1.0 - DECAYED));
        let part = (second - kinetic) / (rest - kinetic);
        if !(part > 0.0 && part < 1.0 && second < rest && rate > 0.0 && kinetic >= 0.0) {
            return Err("the coefficients do not fall from the first through the second to the last".into());
        }
        Ok(Coefficient::Decay { rest, kinetic, decay: -part.ln() / rate })
    }

    /// Part of the way [-] from one to another: μ = (1 − part) μ₀ + part μ₁ at every slip rate and pressure.
    pub fn between(from: &Self, to: &Self, part: f64) -> Self {
        match (from, to) {
            _ if part <= 0.0 => from.clone(),
            _ if part >= 1.0 => to.clone(),
            (Coefficient::Constant(from), Coefficient::Constant(to)) => Coefficient::Constant(mix(*from, *to, part)),
            _ => Coefficient::Between(Box::new([from.clone(), to.clone()]), part),
        }
    }

    /// At a slip rate γ̇ ≥ 0 [L/T] and a pressure.
    pub fn at(&self, rate: f64, pressure: f64) -> Value {
        match self {
            Coefficient::Constant(value) => Value { value: *value, ..Value::default() },
            Coefficient::Between(ends, part) => {
                let [from, to] = [&ends[0], &ends[1]].map(|end| end.at(rate, pressure));
                Value {
                    value: mix(from.value, to.value, *part),
                    by_rate: mix(from.by_rate, to.by_rate, *part),
                    by_pressure: mix(from.by_pressure, to.by_pressure, *part),
                }
            }
            Coefficient::Decay { rest, kinetic, decay } => {
                let excess = (rest - kinetic) * (-decay * rate).exp();
                Value { value: kinetic + excess, by_rate: -decay * excess, by_pressure: 0.0 }
            }
            Coefficient::Table(groups) => {
                let (low, high, part, width) = bracket(groups, pressure, |g| g.0);
                let of = |group: &(f64, Vec<(f64, f64)>)| {
                    let (a, b, part, width) = bracket(&group.1, rate, |r| r.0);
                    let slope = if width > 0.0 { (b.1 - a.1) / width } else { 0.0 };
                    (a.1 + part * (b.1 - a.1), slope)
                };
                let (one, other) = (of(low), of(high));
                Value {
                    value: one.0 + part * (other.0 - one.0),
                    by_rate: one.1 + part * (other.1 - one.1),
                    by_pressure: if width > 0.0 { (other.0 - one.0) / width } else { 0.0 },
                }
            }
        }
    }
}

/// Part of the way [-] from one number to another.
pub(super) fn mix(from: f64, to: f64, part: f64) -> f64 {
    (1.0 - part) * from + part * to
}

/// The rows around `x`, how far it is between them [-], and how far they are apart: 0 outside of the list.
fn bracket<T>(list: &[T], x: f64, of: impl Fn(&T) -> f64) -> (&T, &T, f64, f64) {
    let after = list.partition_point(|row| of(row) <= x);
    let (first, last) = (&list[0], &list[list.len() - 1]);
    match after {
        0 => (first, first, 0.0, 0.0),
        n if n == list.len() => (last, last, 0.0, 0.0),
        n => {
            let (a, b) = (&list[n - 1], &list[n]);
            let width = of(b) - of(a);
            (a, b, (x - of(a)) / width, width)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A34c: μ_s = 0.4, μ_k = 0.2, d = 0.01 at 100: 0.2 + 0.2/e.
    #[test]
    fn a34c_exponential_decay() {
        let decay = Coefficient::Decay { rest: 0.4, kinetic: 0.2, decay: 0.01 };
        assert!((decay.at(100.0, 1.0).value - 0.273575888234).abs() < 1e-12);
        assert_eq!(decay.at(0.0, 1.0).value, 0.4);
    }

    /// Through two points the curve passes; what is not given lies a twentieth beyond.
    #[test]
    fn a_decay_passes_through_its_test_data() {
        for limit in [None, Some(0.15)] {
            let decay = Coefficient::decay_through(0.4, (0.25, 7.0), limit).unwrap();
            assert!((decay.at(7.0, 0.0).value - 0.25).abs() < 1e-15 && decay.at(0.0, 0.0).value == 0.4);
            let Coefficient::Decay { kinetic, .. } = decay else { panic!() };
            let expected = limit.unwrap_or(0.25 - 0.05 * (0.4 - 0.25) / 0.95);
            assert!((kinetic - expected).abs() < 1e-15, "{kinetic}");
        }
        assert!(Coefficient::decay_through(0.2, (0.3, 1.0), None).is_err());
    }

    /// Between a table and a decay every number is between theirs; between two numbers it is a number.
    #[test]
    fn between_two_coefficients() {
        let table = Coefficient::table(&[(0.5, 0.0, 0.0), (0.3, 0.0, 10.0)]).unwrap();
        let decay = Coefficient::Decay { rest: 0.4, kinetic: 0.2, decay: 0.01 };
        let at = Coefficient::between(&table, &decay, 0.25).at(100.0, 5.0);
        let (fall, near) = (0.2 * (-1f64).exp(), |a: f64, b: f64| (a - b).abs() < 1e-15);
        assert!(near(at.value, 0.75 * 0.4 + 0.25 * (0.2 + fall)), "{at:?}");
        assert!(near(at.by_rate, -0.25 * 0.01 * fall) && near(at.by_pressure, -0.75 * 0.02), "{at:?}");
        let number = |value: f64| Coefficient::Constant(value);
        assert_eq!(Coefficient::between(&number(0.5), &number(0.25), 0.5), number(0.375));
        assert_eq!([0.0, 1.0].map(|part| Coefficient::between(&table, &decay, part)), [table, decay]);
    }

    /// Bilinear inside, constant outside; the derivatives are those of the planes.
    #[test]
    fn tables_are_bilinear() {
        let rows = [(0.5, 0.0, 10.0), (0.3, 2.0, 10.0), (0.4, 0.0, 20.0), (0.1, 2.0, 20.0)];
        let table = Coefficient::table(&rows).unwrap();
        let at = table.at(1.0, 15.0);
        let expected = Value { value: 0.325, by_rate: -0.125, by_pressure: -0.015 };
        assert!((at.value - expected.value).abs() < 1e-15 && (at.by_rate - expected.by_rate).abs() < 1e-15);
        assert!((at.by_pressure - expected.by_pressure).abs() < 1e-15);
        assert_eq!(table.at(9.0, 99.0), Value { value: 0.1, by_rate: 0.0, by_pressure: 0.0 });
        assert!(Coefficient::table(&[rows[2], rows[0]]).is_err());
        assert!(Coefficient::table(&[rows[1], rows[0]]).is_err());
        assert_eq!(Coefficient::table(&rows[..1]).unwrap(), Coefficient::Constant(0.5));
    }
}
