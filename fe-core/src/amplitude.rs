//! How loads and prescribed displacements follow time.

/// What the time of an amplitude is counted from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeBase {
    /// The start of the step.
    Step,
    /// The start of the job.
    Total,
}

/// How an amplitude goes from one point of its table to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Straight.
    Linear,
    /// f₀ + (f₁ − f₀) τ³ (10 − 15 τ + 6 τ²), τ from 0 to 1: at rest and without acceleration in every point.
    SmoothStep,
}

/// A table of (time, factor), constant outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Amplitude {
    /// Name, capitals.
    pub name: String,
    /// Time base.
    pub base: TimeBase,
    /// Between the points.
    pub course: Course,
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
            (Some((t0, f0)), Some(&(t1, f1))) => {
                let part = (t - t0) / (t1 - t0);
                f0 + (f1 - f0)
                    * match self.course {
                        Course::Linear => part,
                        Course::SmoothStep => part.powi(3) * (10.0 - 15.0 * part + 6.0 * part * part),
                    }
            }
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
        let points = vec![(0.0, 1.0), (2.0, 3.0)];
        let a = Amplitude { name: "A".into(), base: TimeBase::Step, course: Course::Linear, points };
        assert_eq!([-1.0, 0.0, 1.0, 2.0, 5.0].map(|t| a.at(t, 0.0)), [1.0, 1.0, 2.0, 3.0, 3.0]);
    }

    /// Values of 10 τ³ − 15 τ⁴ + 6 τ⁵, which is even about the middle, and no slope at the points.
    #[test]
    fn a_smooth_step_rests_at_its_points() {
        let points = vec![(0.0, 1.0), (2.0, 3.0), (3.0, 0.0)];
        let a = Amplitude { name: "A".into(), base: TimeBase::Step, course: Course::SmoothStep, points };
        assert_eq!([-1.0, 0.0, 1.0, 2.0, 2.5, 3.0].map(|t| a.at(t, 0.0)), [1.0, 1.0, 2.0, 3.0, 1.5, 0.0]);
        assert!((a.at(0.5, 0.0) - (1.0 + 2.0 * 0.103515625)).abs() < 1e-15);
        // To third order in the distance, whose factor is 10 (f₁ − f₀).
        let d = 1e-4;
        assert!((a.at(2.0 + d, 0.0) - 3.0).abs() <= 30.0 * d * d * d * 1.001 + 1e-15);
    }
}
