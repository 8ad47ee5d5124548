//! A pair as a term of the virtual work: δW = −Σ A p(g) δg over its points.

use crate::law::NormalResponse;
use crate::pair::Pair;
use crate::point::{ContactPoint, ContactStatus};
use fe_core::{Assembly, Couplings, Motion, Reject, Term};

/// History of an open point, and of a closed one.
const OPEN: f64 = 0.0;
const CLOSED: f64 = 1.0;

impl Pair {
    /// Gap [L] of a point at a displacement.
    pub fn opening(&self, point: usize, u: &[f64]) -> f64 {
        let p = &self.points[point];
        p.gap + self.rate(point, u)
    }

    /// Σ d·u [L]: how the gap of a point changes with a displacement.
    pub fn rate(&self, point: usize, u: &[f64]) -> f64 {
        let freedoms = self.places[point].iter().cloned().flatten();
        self.points[point].row.iter().zip(freedoms).map(|(d, f)| d * u[f]).sum()
    }

    /// The law's answer. At the kink, within round-off of the model's size, the point touches: it is closed and
    /// has the stiffness of the closed side, so that a body that just touches is held.
    pub fn respond(&self, gap: f64) -> (NormalResponse, ContactStatus) {
        let kink = self.law.reach();
        let mut answer = self.law.respond(gap);
        if (gap - kink).abs() <= self.touch {
            answer.stiffness = answer.stiffness.max(self.law.respond(kink).stiffness);
        }
        let closed = gap <= kink + self.touch;
        (answer, if closed { ContactStatus::Closed } else { ContactStatus::Open })
    }

    fn add_stiffness(&self, point: usize, factor: f64, out: &mut fe_core::BlockMatrix) {
        let ContactPoint { nodes, row, .. } = &self.points[point];
        let mut block = Vec::new();
        let mut start_i = 0;
        for (i, place) in nodes.iter().zip(&self.places[point]) {
            let di = &row[start_i..start_i + place.len()];
            start_i += place.len();
            let mut start_j = 0;
            for (j, place) in nodes.iter().zip(&self.places[point]).take_while(|(j, _)| *j <= i) {
                let dj = &row[start_j..start_j + place.len()];
                start_j += place.len();
                block.clear();
                block.extend(di.iter().flat_map(|a| dj.iter().map(move |b| factor * a * b)));
                out.add_block(*i, *j, &block);
            }
        }
    }
}

impl Term for Pair {
    fn name(&self) -> &str {
        Pair::name(self)
    }

    fn couplings(&self, couplings: &mut Couplings) {
        self.points.iter().for_each(|p| couplings.add(&p.nodes));
    }

    fn history(&self) -> usize {
        self.points.len()
    }

    fn evaluate(&self, at: Motion, _old: &[f64], new: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
        for (i, p) in self.points.iter().enumerate() {
            let gap = self.opening(i, at.u);
            if !gap.is_finite() {
                return Err(Reject::NotFinite { place: format!("the gap of node {} of {}", p.node, self.name()) });
            }
            let (answer, status) = self.respond(gap);
            let measure = p.measure.value();
            out.energy += answer.energy * measure;
            let now = if status == ContactStatus::Open { OPEN } else { CLOSED };
            out.status_changes += usize::from(new[i] != now);
            new[i] = now;
            let force = answer.pressure * measure;
            if force != 0.0 {
                let freedoms = self.places[i].iter().cloned().flatten();
                p.row.iter().zip(freedoms).for_each(|(d, f)| out.residual[f] -= force * d);
            }
            if answer.stiffness != 0.0
                && let Some(stiffness) = out.stiffness.as_deref_mut()
            {
                self.add_stiffness(i, answer.stiffness * measure, stiffness);
            }
        }
        Ok(())
    }
}
