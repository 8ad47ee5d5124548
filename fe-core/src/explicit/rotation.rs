//! Nodes that turn in space, without limit: three rotations, a tensor of inertia, gyroscopic moments.
//!
//! Angular velocities ω stand in the middle of the increments, like all velocities, in fixed axes:
//! H(n+½) = H(n−½) + M(n) (Δt(n−1) + Δt(n))/2, H = J ω with J = R J₀ Rᵀ in the middle of the increment, R(n+½) = exp(½ Δt ω) R(n);
//! R(n+1) = exp(Δt ω) R(n). The momentum of a free body stays to rounding; its energy swings within O(Δt²), as the scheme is the
//! same backwards in time. (Midpoint rule on rotations: Simo, Wong, Int. J. Numer. Meth. Engng 31 (1991) 19; Krysl, ibid. 63
//! (2005) 2171.)

use super::Halt;
use super::central_difference::State;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

type Vec3 = Vector3<f64>;

/// Iterations for an angular velocity at most.
const MOST: usize = 40;

/// Part of the largest moment of inertia [-] below which the least one is none.
const NONE: f64 = 1e-12;

/// The tensor of inertia [M L²] of a node, in fixed axes at the start, by the first of its three rotations.
pub type Rotary = (usize, Matrix3<f64>);

/// A node with three rotations.
#[derive(Clone, Debug)]
pub(super) struct Triad {
    /// First of its rotations.
    pub first: usize,
    /// J₀; `None` where it is the same about all axes, so that nothing turns with the node.
    inertia: Option<Matrix3<f64>>,
    /// At the end of the last increment.
    rotation: UnitQuaternion<f64>,
    /// ∫ ω dt, which began as the rotation vector: what supports prescribe.
    turned: Vec3,
    /// What the increment began with: ω(n−½) and H(n−½).
    before: [Vec3; 2],
    /// As predicted for its middle: ω, H, J.
    predicted: (Vec3, Vec3, Matrix3<f64>),
}

/// A vector of the freedoms from `first` on.
fn three(v: &[f64], first: usize) -> Vec3 {
    Vec3::from_column_slice(&v[first..first + 3])
}

impl Triad {
    /// At a state, with what terms give as tensors.
    pub fn new(first: usize, u: &[f64], tensors: impl Iterator<Item = Matrix3<f64>>) -> Self {
        let turned = three(u, first);
        Triad {
            first,
            inertia: tensors.reduce(|sum, tensor| sum + tensor),
            rotation: UnitQuaternion::new(turned),
            turned,
            before: [Vec3::zeros(); 2],
            predicted: (Vec3::zeros(), Vec3::zeros(), Matrix3::zeros()),
        }
    }

    /// Adds the moments of inertia of the freedoms to the tensor, and gives them its least principal one.
    ///
    /// # Errors
    /// [`Halt::Massless`] where a free rotation has none.
    pub fn weigh(&mut self, mass: &mut [f64], is_prescribed: &[bool]) -> Result<(), Halt> {
        let Some(inertia) = &mut self.inertia else { return Ok(()) };
        let own = self.first..self.first + 3;
        *inertia += Matrix3::from_diagonal(&three(mass, self.first));
        let principal = inertia.symmetric_eigenvalues();
        let least = if principal.min() > NONE * principal.max() { principal.min() } else { 0.0 };
        mass[own.clone()].fill(least);
        let free = own.clone().find(|&f| !is_prescribed[f]);
        match free {
            // One that turns about a fixed axis needs that one moment alone.
            Some(freedom) if least == 0.0 => {
                let masked = masked(self.turned_inertia(), &self.prescribed(is_prescribed));
                let principal = masked.symmetric_eigenvalues();
                if principal.min() <= NONE * principal.max() {
                    return Err(Halt::Massless { freedom });
                }
                own.for_each(|f| mass[f] = principal.min());
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn prescribed(&self, is_prescribed: &[bool]) -> [bool; 3] {
        [0, 1, 2].map(|c| is_prescribed[self.first + c])
    }

    fn turned_by(&self, more: Vec3) -> Matrix3<f64> {
        *(Rotation3::new(more) * self.rotation.to_rotation_matrix()).matrix()
    }

    fn turned_inertia(&self) -> Matrix3<f64> {
        self.inertia_after(Vec3::zeros())
    }

    /// J [M L²] when it has turned by more.
    fn inertia_after(&self, more: Vec3) -> Matrix3<f64> {
        let rotation = self.turned_by(more);
        self.inertia.map_or_else(Matrix3::zeros, |inertia| rotation * inertia * rotation.transpose())
    }

    /// What supports prescribe of a direction.
    pub fn turned(&self, component: usize) -> f64 {
        self.turned[component]
    }

    /// What the node has turned by for supports, all axes.
    pub fn counted(&self) -> Vec3 {
        self.turned
    }

    /// Goes on from there.
    pub fn count(&mut self, turned: Vec3) {
        self.turned = turned;
    }

    /// Remembers what an increment begins with, after one of length `dt`.
    pub fn begin(&mut self, v: &[f64], dt: f64) {
        let omega = three(v, self.first);
        self.before = [omega, self.inertia_after(-0.5 * dt * omega) * omega];
    }

    /// Angular velocity in the middle of the increment; prescribed ones stand in the state.
    pub fn accelerate(&mut self, state: &mut State, (dt, mean): (f64, f64), fixed: &[bool]) -> Result<(), Halt> {
        if self.inertia.is_none() {
            return Ok(());
        }
        let momentum = self.before[1] + three(&state.force, self.first) * mean;
        let fixed = self.prescribed(fixed);
        let mut omega = self.before[0];
        (0..3).filter(|&c| fixed[c]).for_each(|c| omega[c] = state.v[self.first + c]);
        self.solve(momentum, omega, &fixed, dt)?;
        self.put(state);
        Ok(())
    }

    fn put(&self, state: &mut State) {
        state.v[self.first..self.first + 3].copy_from_slice(self.predicted.0.as_slice());
    }

    /// Finds ω with J(n+½) ω = H in the free directions, by Newton's method.
    fn solve(&mut self, momentum: Vec3, start: Vec3, fixed: &[bool; 3], dt: f64) -> Result<(), Halt> {
        let mut omega = start;
        let mut last = f64::INFINITY;
        for _ in 0..MOST {
            let inertia = self.inertia_after(0.5 * dt * omega);
            let now = inertia * omega;
            // δ(J ω) = J δω + ½ Δt (δω × H − J (δω × ω)).
            let slope = inertia + (inertia * omega.cross_matrix() - now.cross_matrix()) * (0.5 * dt);
            let mut left = momentum - now;
            (0..3).filter(|&c| fixed[c]).for_each(|c| left[c] = 0.0);
            let Some(step) = masked(slope, fixed).lu().solve(&left) else { break };
            omega += step;
            let size = step.norm();
            if size <= f64::EPSILON * omega.norm() || (size >= 0.5 * last && size <= 1e-9 * omega.norm()) {
                let inertia = self.inertia_after(0.5 * dt * omega);
                self.predicted = (omega, inertia * omega, inertia);
                return Ok(());
            }
            last = size;
        }
        Err(Halt::Spinning { freedom: self.first })
    }

    /// Velocity that an impulse along a row of coefficients of its freedoms gives to them.
    pub fn gain(&self, row: Vec3, is_prescribed: &[bool]) -> Vec3 {
        let fixed = self.prescribed(is_prescribed);
        let mut row = row;
        (0..3).filter(|&c| fixed[c]).for_each(|c| row[c] = 0.0);
        masked(self.predicted.2, &fixed).cholesky().map_or_else(Vec3::zeros, |inertia| inertia.solve(&row))
    }

    /// True where it has a tensor.
    pub fn has_tensor(&self) -> bool {
        self.inertia.is_some()
    }

    /// Takes the angular velocity as contact has corrected it, and turns the node; its rotation vector goes on as it was.
    pub fn turn(&mut self, state: &mut State, dt: f64, is_prescribed: &[bool]) -> Result<(), Halt> {
        let changed = three(&state.v, self.first) - self.predicted.0;
        if self.inertia.is_some() && changed != Vec3::zeros() {
            let momentum = self.predicted.1 + self.predicted.2 * changed;
            self.solve(momentum, self.predicted.0 + changed, &self.prescribed(is_prescribed), dt)?;
            self.put(state);
        }
        let more = three(&state.v, self.first) * dt;
        self.turned += more;
        self.rotation = UnitQuaternion::new(more) * self.rotation;
        self.rotation.renormalize_fast();
        let near = three(&state.u, self.first);
        let vector = nearest(&self.rotation, near);
        state.u[self.first..self.first + 3].copy_from_slice(vector.as_slice());
        Ok(())
    }

    /// H(n+½) − H(n−½) [F L T], and ω(n+½) + ω(n−½) [1/T], of a direction.
    pub fn gained(&self, component: usize) -> [f64; 2] {
        let [omega, momentum] = self.before;
        [self.predicted.1[component] - momentum[component], self.predicted.0[component] + omega[component]]
    }

    /// ω [1/T] and H [F L T] at the end of the increment.
    pub fn at_end(&self, state: &State, is_prescribed: &[bool]) -> [Vec3; 2] {
        let [omega, before] = self.middle(state);
        let inertia = self.turned_inertia();
        let fixed = self.prescribed(is_prescribed);
        let mut held = Vec3::zeros();
        (0..3).filter(|&c| fixed[c]).for_each(|c| held[c] = omega[c]);
        let mut left = before + three(&state.force, self.first) * (0.5 * state.dt) - inertia * held;
        (0..3).filter(|&c| fixed[c]).for_each(|c| left[c] = held[c]);
        let omega = masked(inertia, &fixed).lu().solve(&left).unwrap_or(omega);
        [omega, inertia * omega]
    }

    /// ω [1/T] and H [F L T] in the middle of the last increment.
    pub fn middle(&self, state: &State) -> [Vec3; 2] {
        let omega = three(&state.v, self.first);
        [omega, self.inertia_after(-0.5 * state.dt * omega) * omega]
    }
}

/// A matrix that leaves fixed directions as they are.
fn masked(mut matrix: Matrix3<f64>, fixed: &[bool; 3]) -> Matrix3<f64> {
    let scale = matrix.trace().abs() / 3.0;
    for c in (0..3).filter(|&c| fixed[c]) {
        matrix.row_mut(c).fill(0.0);
        matrix.column_mut(c).fill(0.0);
        matrix[(c, c)] = scale;
    }
    matrix
}

/// The rotation vector of a rotation that is nearest to another one: it may have turned more than once.
fn nearest(rotation: &UnitQuaternion<f64>, near: Vec3) -> Vec3 {
    let vector = rotation.scaled_axis();
    let angle = vector.norm();
    let length = near.norm();
    let axis = if angle > 0.0 {
        vector / angle
    } else if length > 0.0 {
        near / length
    } else {
        return vector;
    };
    let turns = ((axis.dot(&near) - angle) / std::f64::consts::TAU).round();
    if turns == 0.0 { vector } else { axis * (angle + turns * std::f64::consts::TAU) }
}

#[cfg(test)]
mod tests;
