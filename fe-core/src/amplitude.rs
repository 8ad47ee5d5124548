//! How loads and prescribed displacements follow time.

/// What the time of an amplitude is counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeBase {
    /// The start of the step.
    Step,
    /// The start of the job.
    Total,
}

/// A table of (time, factor), linear in between, constant outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Amplitude {
    /// Name, capitals.
    pub name: String,
    /// Time base.
    pub base: TimeBase,
    /// (time [T], factor [-]), times ascending, at least one.
    pub points: Vec<(f64, f64)>,
}

impl Amplitude {
    /// The factor at a time.
    pub fn at(&self, step_time: f64, total_time: f64) -> f64 {
        let t = match self.base {
            TimeBase::Step => step_time,
            TimeBase::Total => total_time,
        };
        let next = self.points.partition_point(|p| p.0 <= t);
        match (next.checked_sub(1).map(|i| self.points[i]), self.points.get(next)) {
            (Some((t0, f0)), Some(&(t1, f1))) => f0 + (f1 - f0) * (t - t0) / (t1 - t0),
            (Some((_, f)), None) => f,
            (None, Some(&(_, f))) => f,
            (None, None) => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_inside_constant_outside() {
        let a = Amplitude { name: "A".into(), base: TimeBase::Step, points: vec![(0.0, 1.0), (2.0, 3.0)] };
        assert_eq!([-1.0, 0.0, 1.0, 2.0, 5.0].map(|t| a.at(t, 0.0)), [1.0, 1.0, 2.0, 3.0, 3.0]);
    }
}
