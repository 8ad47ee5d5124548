//! An element along a line or on fixed freedoms, and how it answers its length.

use crate::freedoms::Freedoms;
use crate::material::Damping;
use crate::structure::Structure;
use fe_mesh::CellId;

/// How an element answers its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Answer {
    /// E A₀ [F] of a truss: N = E A₀ ln λ/λ, as the volume stays (Abaqus Theory Manual, Truss elements).
    Truss(f64),
    /// k [F/L].
    Spring(f64),
    /// c [F T/L].
    Dashpot(f64),
}

/// Where an element acts.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Reach {
    /// Between two nodes, along their line: first freedoms, how many each has, and the line at the start [L].
    Line { ends: [usize; 2], directions: usize, line: [f64; 3] },
    /// On the difference of freedoms; the second may be missing.
    Fixed { first: usize, second: Option<usize> },
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    pub cell: CellId,
    pub answer: Answer,
    pub reach: Reach,
    /// Length at the start [L]; 1 where it acts on fixed freedoms.
    pub length: f64,
    /// Half of its mass [M], and the factor on it.
    pub mass: f64,
    pub factor: f64,
    /// Stable increment [T] by itself, without the factor.
    pub stable: f64,
    /// Damping of its material.
    pub damping: Damping,
    /// Length or elongation [L] at the end of the last increment.
    pub now: f64,
    /// Force [F] of dashpot, bulk viscosity or damping by stiffness then.
    pub viscous: f64,
}

/// Forces [F] at the end of an increment, and the energy [F L] stored in it.
pub(super) struct Answered {
    pub elastic: f64,
    pub stored: f64,
    pub viscous: f64,
}

impl Element {
    /// At rest, without mass.
    pub fn new(cell: CellId, answer: Answer, (reach, length): (Reach, f64)) -> Self {
        let now = if matches!(reach, Reach::Line { .. }) { length } else { 0.0 };
        let (damping, stable) = (Damping::default(), f64::INFINITY);
        Element { cell, answer, reach, length, mass: 0.0, factor: 1.0, stable, damping, now, viscous: 0.0 }
    }

    /// The same between the nodes of a cell.
    pub fn along((structure, freedoms): (&Structure, &Freedoms), cell: CellId, answer: Answer) -> Self {
        let nodes = structure.mesh.cell(cell);
        let [a, b] = [0, 1].map(|i| structure.mesh.points[nodes[i] as usize]);
        let ends = [0, 1].map(|i| freedoms.of_node(nodes[i] as usize).start);
        let line: [f64; 3] = std::array::from_fn(|c| b[c] - a[c]);
        Element::new(cell, answer, (Reach::Line { ends, directions: structure.dimension(), line }, norm(line)))
    }

    /// Freedoms it acts on.
    pub fn freedoms(&self) -> impl Iterator<Item = usize> + '_ {
        let (ranges, second) = match &self.reach {
            Reach::Line { ends, directions, .. } => (ends.map(|end| end..end + directions), None),
            Reach::Fixed { first, second } => ([*first..first + 1, 0..0], *second),
        };
        ranges.into_iter().flatten().chain(second)
    }

    /// Length or elongation [L] at a displacement.
    pub fn length(&self, u: &[f64]) -> ([f64; 3], f64) {
        match &self.reach {
            Reach::Line { ends: [a, b], directions, line } => {
                let mut now = *line;
                (0..*directions).for_each(|c| now[c] += u[b + c] - u[a + c]);
                (now, norm(now))
            }
            Reach::Fixed { first, second } => ([0.0; 3], u[*first] - second.map_or(0.0, |second| u[second])),
        }
    }

    /// With a length or elongation `now` [L] that has changed at a `rate` [L/T]; a truss takes down its stable increment.
    pub fn answer(&mut self, now: f64, rate: f64, viscosity: f64) -> Answered {
        let (before, l0) = (self.now, self.length);
        match self.answer {
            Answer::Truss(ea) => {
                let of = |l: f64| (l / l0).ln();
                let free = now * (2.0 * self.mass / (ea * l0)).sqrt();
                let beta = self.damping.beta;
                // Of critical: bulk viscosity, and ½ β ω.
                let xi = viscosity + beta / free;
                self.stable = free * ((1.0 + xi * xi).sqrt() - xi);
                // Bulk viscosity b ρ c A l̇, and β E A l̇/l.
                let coefficient = viscosity * (2.0 * self.mass * ea / l0).sqrt() + beta * ea * l0 / (now * now);
                Answered {
                    elastic: ea * l0 / now * of(now),
                    stored: 0.5 * ea * l0 * (of(now).powi(2) - of(before).powi(2)),
                    viscous: coefficient * rate,
                }
            }
            Answer::Spring(k) => {
                let rest = if matches!(self.reach, Reach::Line { .. }) { l0 } else { 0.0 };
                let stored = 0.5 * k * (now - before) * (now + before - 2.0 * rest);
                Answered { elastic: k * (now - rest), stored, viscous: 0.0 }
            }
            Answer::Dashpot(c) => Answered { elastic: 0.0, stored: 0.0, viscous: c * rate },
        }
    }

    /// True where its ends meet, and it has no direction.
    pub fn answer_is_lost(&self, now: f64) -> bool {
        matches!(self.reach, Reach::Line { .. }) && (now <= 0.0 || now.is_nan())
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
