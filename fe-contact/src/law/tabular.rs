//! The piecewise linear law through points (pressure, overclosure).

use super::{Datum, LawDefinition, Lines, NormalLaw, NormalResponse};
use crate::summary::MeasureKind;
use std::ops::Range;
use std::sync::Arc;

/// Straight between points (pᵢ, hᵢ) of ascending overclosure, 0 below the first, on with the last slope beyond the
/// last.
#[derive(Clone, Debug, PartialEq)]
pub struct Tabular {
    /// From the last point that does not press yet, or the first point.
    points: Vec<Point>,
}

/// Where a straight piece of a law begins.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Point {
    /// h [L].
    overclosure: f64,
    /// p [F/L²].
    pressure: f64,
    /// dp/dh [F/L³] from here on.
    slope: f64,
    /// ∫p dh [F/L] up to here.
    energy: f64,
}

impl Tabular {
    /// From (pressure [F/L²] ≥ 0, overclosure [L]) in ascending order of overclosure; says what is wrong with them.
    pub fn new(rows: &[[f64; 2]]) -> Result<Self, String> {
        if rows.len() < 2 {
            return Err(format!("a table needs two points, this one has {}", rows.len()));
        }
        for (i, two) in rows.windows(2).enumerate() {
            let ([_, low], [_, high]) = (two[0], two[1]);
            if low >= high {
                let point = i + 2;
                return Err(format!("the overclosures must ascend: point {point} has {high} after {low}"));
            }
        }
        if rows.iter().all(|row| row[0] == 0.0) {
            return Err("no point of the table has a pressure".into());
        }
        let [before, last] = [rows[rows.len() - 2], rows[rows.len() - 1]];
        if last[0] < before[0] {
            let (from, to) = (before[0], last[0]);
            return Err(format!("the pressure falls from {from} to {to} at the end, and would go on into tension"));
        }
        // Points that do not press before the first that does say nothing.
        let silent = rows.iter().take_while(|row| row[0] == 0.0).count().saturating_sub(1);
        Self::pieces(&rows[silent..])
    }

    fn pieces(rows: &[[f64; 2]]) -> Result<Self, String> {
        let mut points: Vec<Point> = Vec::with_capacity(rows.len());
        for (i, &[pressure, overclosure]) in rows.iter().enumerate() {
            let last = points.last().copied();
            let slope = match rows.get(i + 1) {
                Some(next) => (next[0] - pressure) / (next[1] - overclosure),
                None => last.map_or(0.0, |p| p.slope),
            };
            if !slope.is_finite() {
                return Err(format!(
                    "the slope after the overclosure {overclosure} is no number that can be computed with"
                ));
            }
            let energy = last.map_or(0.0, |p| p.energy + 0.5 * (p.pressure + pressure) * (overclosure - p.overclosure));
            points.push(Point { overclosure, pressure, slope, energy });
        }
        Ok(Tabular { points })
    }
}

impl NormalLaw for Tabular {
    fn respond(&self, gap: f64) -> NormalResponse {
        let at = self.points.partition_point(|p| p.overclosure <= -gap);
        let Some(p) = at.checked_sub(1).map(|i| self.points[i]) else { return NormalResponse::default() };
        let beyond = -gap - p.overclosure;
        let pressure = p.pressure + p.slope * beyond;
        NormalResponse { energy: p.energy + 0.5 * (p.pressure + pressure) * beyond, pressure, stiffness: p.slope }
    }

    fn reach(&self) -> f64 {
        -self.points[0].overclosure
    }

    fn kinks(&self, range: Range<f64>) -> Vec<f64> {
        self.points[1..].iter().map(|p| -p.overclosure).filter(|g| range.contains(g)).collect()
    }

    /// The first slope by which the pressure rises.
    fn typical_stiffness(&self) -> f64 {
        self.points.iter().map(|p| p.slope).find(|slope| *slope > 0.0).unwrap_or(0.0)
    }

    fn steepest(&self) -> f64 {
        self.points.iter().fold(0.0, |most, p| p.slope.max(most))
    }

    fn words(&self, number: MeasureKind) -> String {
        let points: Vec<String> = self.points.iter().map(|p| format!("{} at {}", p.pressure, p.overclosure)).collect();
        let last = self.points[self.points.len() - 1].slope;
        let (pressure, stiffness) = (number.dimension(), number.stiffness_dimension());
        format!(
            "TABULAR, [{pressure}] at an overclosure [L]: {}, on with slope {last} [{stiffness}]",
            points.join(", ")
        )
    }

    fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        let first = self.points[0];
        if first.pressure > 0.0 {
            remarks.push(format!(
                "the pressure jumps from 0 to {} at the first overclosure {}: a load in between has no equilibrium; \
                 begin with a point of pressure 0",
                first.pressure, first.overclosure
            ));
        }
        for two in self.points.windows(2).filter(|two| two[0].slope < 0.0) {
            remarks.push(format!(
                "the pressure falls between the overclosures {} and {}: there may be several equilibria, or none that \
                 Newton's method reaches",
                two[0].overclosure, two[1].overclosure
            ));
        }
        remarks
    }
}

/// As decks name it.
pub const DEFINITION: LawDefinition = LawDefinition {
    keyword: "TABULAR",
    summary: "straight between points of ascending overclosure, 0 below the first, on with the last slope",
    source: "Abaqus Analysis User's Manual, Contact pressure-overclosure relationships",
    data: &[
        Datum::number("pressure", "F/L²", "pressure at this overclosure; that of the first line should be 0")
            .least(0.0),
        Datum::number("overclosure", "L", "overclosure, larger than that of the line before; negative: a clearance"),
    ],
    lines: Lines::AtLeast(2),
    example: &[0.0, -0.2, 10.0, 0.0, 10.0, 0.05, 200.0, 0.10, 260.0, 0.20],
    build: |data| {
        let rows: Vec<[f64; 2]> = data.chunks_exact(2).map(|row| [row[0], row[1]]).collect();
        Ok(Arc::new(Tabular::new(&rows)?))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::linear::Linear;
    use crate::law::work_by_quadrature;
    use crate::verify;

    const A05: [[f64; 2]; 5] = [[0.0, -0.02], [10.0, 0.0], [10.0, 0.05], [200.0, 0.10], [260.0, 0.20]];

    /// A few operations on numbers of size 1000, of which differences are taken.
    const ALGEBRAIC: f64 = 1e-12;

    #[test]
    fn a05_table() {
        let law = Tabular::new(&A05).unwrap();
        assert_eq!(law.reach(), 0.02);
        for (h, pressure, slope) in [
            (-0.03, 0.0, 0.0),
            (-0.02, 0.0, 500.0),
            (-0.02 + 1.0 / 150.0, 10.0 / 3.0, 500.0),
            (0.0, 10.0, 0.0),
            (0.03, 10.0, 0.0),
            (0.05, 10.0, 3800.0),
            (0.0791666666666667, 120.83333333333346, 3800.0),
            (0.15, 230.0, 600.0),
            (0.2, 260.0, 600.0),
            (1.2, 860.0, 600.0),
        ] {
            let at = law.respond(-h);
            assert!((at.pressure - pressure).abs() <= ALGEBRAIC * 1e3, "{h}: {at:?}");
            assert!((at.stiffness - slope).abs() <= ALGEBRAIC * 1e4, "{h}: {at:?}");
        }
        verify::law(&law, -0.4..0.1).unwrap();
    }

    #[test]
    fn energy_is_work() {
        let law = Tabular::new(&A05).unwrap();
        for h in [-0.01, 0.0, 0.02, 0.07, 0.1, 0.4] {
            let work = work_by_quadrature(&law, h, 1);
            assert!((law.respond(-h).energy - work).abs() <= ALGEBRAIC * work, "{h}: {work}");
        }
    }

    /// Two points through the origin are the linear law (A02).
    #[test]
    fn two_points_are_a_line() {
        let (table, line) =
            (Tabular::new(&[[0.0, 0.0], [4000.0, 1.0]]).unwrap(), Linear { slope: 4000.0, clearance: 0.0 });
        for gap in [-3.0, -0.08, 0.0, 0.1] {
            assert_eq!(table.respond(gap), line.respond(gap));
        }
    }

    #[test]
    fn points_without_pressure_before_contact_say_nothing() {
        let long = Tabular::new(&[[0.0, -2.0], [0.0, -1.0], [0.0, 0.5], [1.0, 1.0]]).unwrap();
        assert_eq!(long, Tabular::new(&[[0.0, 0.5], [1.0, 1.0]]).unwrap());
        assert_eq!(long.reach(), -0.5);
        verify::law(&long, -2.0..2.0).unwrap();
    }

    /// A jump and a falling piece are remarked, and the energy is still the work.
    #[test]
    fn odd_tables_are_remarked() {
        let jump = Tabular::new(&[[10.0, -0.01], [30.0, 0.1]]).unwrap();
        assert_eq!((jump.respond(0.010001).pressure, jump.respond(0.01).pressure), (0.0, 10.0));
        assert!(jump.remarks()[0].contains("jumps from 0 to 10"), "{:?}", jump.remarks());
        verify::law(&jump, -1.0..1.0).unwrap();
        let falling = Tabular::new(&[[0.0, 0.0], [10.0, 1.0], [4.0, 2.0], [6.0, 3.0]]).unwrap();
        assert!(falling.remarks()[0].contains("falls between the overclosures 1 and 2"));
        assert_eq!(falling.respond(-1.5).stiffness, -6.0);
        assert!((falling.respond(-4.0).energy - work_by_quadrature(&falling, 4.0, 1)).abs() < 1e-11);
        assert!(matches!(verify::law(&falling, -3.0..1.0), Err(verify::LawFault::Softens { .. })));
        assert!(Tabular::new(&A05).unwrap().remarks().is_empty());
    }

    #[test]
    fn wrong_tables_are_refused() {
        for (rows, words) in [
            (&[[0.0, 0.0]][..], "two points"),
            (&[[0.0, 0.0], [1.0, 0.0]], "point 2 has 0 after 0"),
            (&[[0.0, 0.0], [1.0, 2.0], [2.0, 1.0]], "point 3 has 1 after 2"),
            (&[[0.0, 0.0], [0.0, 1.0]], "no point"),
            (&[[0.0, 0.0], [2.0, 1.0], [1.0, 2.0]], "falls from 2 to 1"),
            (&[[0.0, 0.0], [1e300, 1e-300]], "slope after"),
        ] {
            let fault = Tabular::new(rows).unwrap_err();
            assert!(fault.contains(words), "{fault}");
        }
    }
}
