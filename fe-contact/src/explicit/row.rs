//! A direction in which a point and what it meets move against each other, and its impulse.

use fe_core::explicit::Predicted;

/// A direction in which a point and what it meets move against each other.
#[derive(Debug, Default)]
pub(super) struct Row {
    /// Freedoms, with how far the distance grows as they move.
    pub entries: Vec<(usize, f64)>,
    /// Velocity that an impulse of 1 gives to each, M⁻¹ Jᵀ [1/M].
    gains: Vec<f64>,
    /// J M⁻¹ Jᵀ [1/M]; 0 where all is held.
    pub compliance: f64,
    /// Rate of the distance without contact, and the same before the forces of the increment [L/T].
    pub predicted: f64,
    pub before: f64,
    /// Impulse [F T].
    pub impulse: f64,
}

impl Row {
    pub fn new(entries: Vec<(usize, f64)>, at: &Predicted) -> Self {
        let gains = at.gains(&entries);
        let compliance = entries.iter().zip(&gains).map(|(entry, gain)| entry.1 * gain).sum();
        let gained: f64 = entries.iter().zip(&gains).map(|(entry, gain)| gain * at.force[entry.0] * at.mean).sum();
        let mut row = Row { entries, gains, compliance, ..Row::default() };
        row.predicted = row.rate(at);
        row.before = row.predicted - gained;
        row
    }

    /// Rate of the distance now [L/T].
    pub fn rate(&self, at: &Predicted) -> f64 {
        self.entries.iter().map(|&(f, d)| d * at.v[f]).sum()
    }

    /// The same without its own impulse.
    pub fn free_rate(&self, at: &Predicted) -> f64 {
        self.rate(at) - self.compliance * self.impulse
    }

    /// What impulses have moved the distance by in the increment [L].
    pub fn moved(&self, at: &Predicted) -> f64 {
        (self.rate(at) - self.predicted) * at.dt
    }

    /// Sum of the ways [L] that its freedoms have in the increment.
    pub fn way(&self, at: &Predicted) -> f64 {
        self.entries.iter().map(|&(f, d)| (d * at.v[f]).abs()).sum::<f64>() * at.dt
    }

    /// Takes another impulse; what it moves the distance by [L].
    pub fn change(&mut self, impulse: f64, at: &mut Predicted) -> f64 {
        let more = impulse - self.impulse;
        self.impulse = impulse;
        self.entries.iter().zip(&self.gains).for_each(|(entry, gain)| at.v[entry.0] += more * gain);
        more.abs() * self.compliance * at.dt
    }

    /// Moves its freedoms to the end of the increment; `react` is told the forces [F] on those that are held. What it takes from
    /// the motion [F L]: ½ λ (v(n−½) + v(n+½)) is what it gives to ½ v(n−½) M v(n+½).
    pub fn settle(&self, at: &mut Predicted, mut react: impl FnMut(usize, f64)) -> f64 {
        let mut held = 0.0;
        for (&(f, d), gain) in self.entries.iter().zip(&self.gains) {
            if at.is_prescribed[f] {
                held += d * at.v[f];
                react(f, self.impulse * d / at.mean);
            } else if self.impulse != 0.0 && *gain != 0.0 {
                at.settle(f, self.impulse * gain);
            }
        }
        -0.5 * self.impulse * (self.before + self.rate(at) - 2.0 * held)
    }
}
