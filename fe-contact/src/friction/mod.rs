//! Friction: pressure and slip in; shear, its derivatives and the new state out. The law knows no geometry.

mod carried;
pub mod change;
mod coefficient;
pub mod slip;

pub use coefficient::{Coefficient, Value};

/// What a `*FRICTION` says.
#[derive(Clone, Debug, PartialEq)]
pub enum Friction {
    /// The shear is at most μ p.
    Coulomb {
        /// μ.
        coefficient: Coefficient,
        /// Largest shear τ_max, in the unit of the pressure; none where it is not given.
        largest: Option<f64>,
        /// What points do that stick.
        stick: Stick,
    },
    /// Points that are closed never slip.
    Rough,
}

/// What points do that stick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stick {
    /// They give way by up to this [L] before they slip.
    ElasticSlip(f64),
    /// The same, as a part of the mean length of the secondary facets of the model [-].
    Tolerance(f64),
    /// They do not move at all.
    Lagrange,
    /// They give way on springs of this stiffness [F/L³], by the unit rule [F/L²] or [F/L], whatever the pressure: of explicit
    /// steps.
    Slope(f64),
}

/// The usual part of the facets' length that sticking points give way by [-] (Abaqus Analysis User's Manual, Frictional
/// behavior).
pub const TOLERANCE: f64 = 0.005;

/// How far the shear of sticking points is from their slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spring {
    /// The full shear is reached after this elastic slip γ_c [L]: the stiffness is τ_c/γ_c.
    Slip(f64),
    /// A stiffness [F/L³], whatever the pressure.
    Stiffness(f64),
}

/// Coulomb's law, isotropic: |τ| ≤ τ_c = min(μ p, τ_max). τ = τ_c C(g/γ_c) or K γ_c C(g/γ_c) with γ_c = τ_c/K, where
/// g is the elastic slip that there would be without slipping and C(x) = x/max(1, |x|).
#[derive(Clone, Debug, PartialEq)]
pub struct Coulomb {
    /// μ and τ_max; `None`: rough.
    pub limit: Option<(Coefficient, Option<f64>)>,
    /// The springs.
    pub spring: Spring,
}

/// What slips.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sliding {
    /// Pressure p in the law's unit; nothing holds by friction where it pulls.
    pub pressure: f64,
    /// Elastic slip before [L].
    pub elastic: [f64; 2],
    /// Slip increment Δγ [L].
    pub slip: [f64; 2],
    /// Time increment [T].
    pub dt: f64,
}

/// What the law answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shear {
    /// τ in the pressure's unit: against the slip on the secondary side.
    pub shear: [f64; 2],
    /// The symmetric part of ∂τ/∂Δγ that is never negative.
    pub stiffness: [[f64; 2]; 2],
    /// What is left of ∂τ/∂Δγ.
    pub rest: [[f64; 2]; 2],
    /// ∂τ/∂p [-].
    pub by_pressure: [f64; 2],
    /// Elastic slip after [L].
    pub elastic: [f64; 2],
    /// It slips.
    pub slips: bool,
}

impl Friction {
    /// No friction at all, which may yet come to be some; `stick` is what points do then.
    pub fn none(stick: Stick) -> Self {
        Friction::Coulomb { coefficient: Coefficient::Constant(0.0), largest: None, stick }
    }

    /// True where μ = 0 everywhere.
    pub fn is_none(&self) -> bool {
        matches!(self, Friction::Coulomb { coefficient: Coefficient::Constant(0.0), .. })
    }
}

impl Coulomb {
    /// True where μ = 0 everywhere: no point sticks, and none stores anything.
    pub fn is_none(&self) -> bool {
        matches!(self.limit, Some((Coefficient::Constant(0.0), _)))
    }

    /// The answer.
    pub fn respond(&self, at: Sliding) -> Shear {
        self.respond_on(self.spring, at)
    }

    /// The answer on other springs.
    pub fn respond_on(&self, spring: Spring, at: Sliding) -> Shear {
        if self.is_none() {
            return Shear::default();
        }
        let trial: [f64; 2] = std::array::from_fn(|i| at.elastic[i] + at.slip[i]);
        let Some((coefficient, largest)) = &self.limit else {
            let of_pressure = || self.stiffness(at.pressure);
            return sticking(trial, if let Spring::Stiffness(k) = spring { k } else { of_pressure() });
        };
        let path = at.slip[0].hypot(at.slip[1]);
        let (critical, by_pressure, by_path) = critical(coefficient, *largest, at, path);
        let size = trial[0].hypot(trial[1]);
        let allowed = match spring {
            Spring::Slip(slip) => slip,
            Spring::Stiffness(stiffness) => critical / stiffness,
        };
        let slips = size > allowed;
        if let (false, Spring::Stiffness(stiffness)) = (slips, spring) {
            return sticking(trial, stiffness);
        }
        // C.
        let direction = trial.map(|g| if slips { g / size } else { g / allowed });
        let mut answer = Shear { slips, elastic: trial, ..Shear::default() };
        answer.shear = direction.map(|c| critical * c);
        answer.by_pressure = direction.map(|c| by_pressure * c);
        if slips {
            answer.elastic = direction.map(|c| allowed * c);
            answer.stiffness = across(direction, critical / size);
        } else {
            answer.stiffness = diagonal(critical / allowed);
        }
        if by_path != 0.0 && path > 0.0 {
            answer.rest = direction.map(|c| at.slip.map(|s| c * by_path * s / path));
        }
        answer
    }

    /// Stiffness of a point that sticks [F/L³]; 0 where nothing presses on springs that the pressure makes.
    pub fn stiffness(&self, pressure: f64) -> f64 {
        match (self.spring, &self.limit) {
            (Spring::Stiffness(stiffness), _) => stiffness,
            (Spring::Slip(slip), Some((coefficient, largest))) => {
                critical(coefficient, *largest, Sliding { pressure, ..Sliding::default() }, 0.0).0 / slip
            }
            (Spring::Slip(slip), None) => pressure.max(0.0) / slip,
        }
    }

    /// True where ∂τ/∂p vanishes everywhere: a symmetric matrix is all of it.
    pub fn is_symmetric(&self) -> bool {
        self.limit.is_none() || self.is_none()
    }
}

/// τ_c, ∂τ_c/∂p, ∂τ_c/∂|Δγ|.
fn critical(coefficient: &Coefficient, largest: Option<f64>, at: Sliding, path: f64) -> (f64, f64, f64) {
    if at.pressure <= 0.0 {
        // A point that touches has the slope of one that presses.
        let slope = if at.pressure == 0.0 { coefficient.at(0.0, 0.0).value } else { 0.0 };
        return (0.0, slope, 0.0);
    }
    let rate = if at.dt > 0.0 { path / at.dt } else { 0.0 };
    let friction = coefficient.at(rate, at.pressure);
    let full = friction.value * at.pressure;
    match largest {
        Some(largest) if full >= largest => (largest, 0.0, 0.0),
        _ => {
            let by_path = if at.dt > 0.0 { at.pressure * friction.by_rate / at.dt } else { 0.0 };
            (full, friction.value + at.pressure * friction.by_pressure, by_path)
        }
    }
}

/// A point that sticks on a spring.
fn sticking(elastic: [f64; 2], stiffness: f64) -> Shear {
    let shear = elastic.map(|g| stiffness * g);
    Shear { shear, stiffness: diagonal(stiffness), elastic, ..Shear::default() }
}

fn diagonal(value: f64) -> [[f64; 2]; 2] {
    [[value, 0.0], [0.0, value]]
}

/// factor (1 − n nᵀ).
fn across([x, y]: [f64; 2], factor: f64) -> [[f64; 2]; 2] {
    [[factor * y * y, -factor * x * y], [-factor * x * y, factor * x * x]]
}

#[cfg(test)]
mod tests;
