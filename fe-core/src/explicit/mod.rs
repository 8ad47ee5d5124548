//! Explicit dynamics: central differences with lumped masses.

pub mod beam;
pub mod central_difference;
pub mod line;
pub mod loads;
pub mod mass_damping;
pub mod mass_scaling;
pub mod rotation;
pub mod solid;

use fe_mesh::CellId;

/// A motion at the end of an increment; vectors over all freedoms (see [`crate::Freedoms`]).
#[derive(Clone, Copy)]
pub struct Moving<'a> {
    /// Displacement since the start [L or rad].
    pub u: &'a [f64],
    /// Mean velocity in the increment [L/T or 1/T].
    pub v: &'a [f64],
    /// Time since the start of the step [T].
    pub step_time: f64,
    /// Time since the start of the job [T].
    pub total_time: f64,
    /// Length of the increment [T]; 0 before the first one.
    pub dt: f64,
    /// Largest increment [T] that the terms before allow: contact comes after the elements.
    pub stable: f64,
}

/// An increment as it is without the contact that corrects it; vectors over all freedoms.
pub struct Predicted<'a> {
    /// Displacement at its end [L or rad].
    pub u: &'a mut [f64],
    /// Mean velocity in it [L/T or 1/T].
    pub v: &'a mut [f64],
    /// The forces [F] that have moved it.
    pub force: &'a [f64],
    /// Mass or moment of inertia of each freedom.
    pub mass: &'a [f64],
    /// Freedoms that supports move: they stay as they are.
    pub is_prescribed: &'a [bool],
    /// Length of the increment [T].
    pub dt: f64,
    /// Time [T] over which forces have changed the velocity: the mean of this increment and the one before.
    pub mean: f64,
    /// Nodes that turn in space.
    triads: &'a [rotation::Triad],
    /// Freedoms that impulses have moved.
    corrected: &'a mut Vec<usize>,
}

impl Predicted<'_> {
    /// Moves a freedom to where an impulse that gave it so much velocity [L/T] takes it.
    pub fn settle(&mut self, freedom: usize, gained: f64) {
        self.u[freedom] += gained * self.dt;
        self.corrected.push(freedom);
    }

    /// Velocity that an impulse of 1 along a row gives to each of its freedoms, M⁻¹ Jᵀ: 0 where supports move them. A row that
    /// turns a node in space has all three rotations.
    pub fn gains(&self, row: &[(usize, f64)]) -> Vec<f64> {
        let each = |&(f, d): &(usize, f64)| if self.is_prescribed[f] { 0.0 } else { d / self.mass[f] };
        let mut gains: Vec<f64> = row.iter().map(each).collect();
        for triad in self.triads.iter().filter(|triad| triad.has_tensor()) {
            let place = |c: usize| row.iter().position(|entry| entry.0 == triad.first + c);
            let places = [place(0), place(1), place(2)];
            if let [Some(_), Some(_), Some(_)] = places {
                let of = nalgebra::Vector3::from(places.map(|p| p.map_or(0.0, |p| row[p].1)));
                let gain = triad.gain(of, self.is_prescribed);
                places.iter().enumerate().for_each(|(c, p)| p.iter().for_each(|&p| gains[p] = gain[c]));
            }
        }
        gains
    }
}

/// What a term has to say of the increments to come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Advance {
    /// Largest increment [T] in which none of its parts gains energy of its own.
    pub stable: f64,
    /// The element that says so.
    pub element: Option<CellId>,
    /// What its parts without a mass of their own add to ω² [1/T²]: the largest sum of a row of stiffness over the mass.
    pub rate: f64,
    /// The same of viscosity, added to 2ξω [1/T].
    pub damping: f64,
}

impl Default for Advance {
    fn default() -> Self {
        Advance { stable: f64::INFINITY, element: None, rate: 0.0, damping: 0.0 }
    }
}

impl Advance {
    /// With what another term says: increments are stable up to 2/ω (√(1 + ξ²) − ξ), ω² at most the sum of what elements with
    /// mass and what others have (Rayleigh's quotient of a sum is at most the sum of the quotients).
    pub fn and(self, other: Advance) -> Advance {
        let first = if other.stable < self.stable { other } else { self };
        Advance { rate: self.rate + other.rate, damping: self.damping + other.damping, ..first }
    }

    /// Largest stable increment [T].
    pub fn increment(&self) -> f64 {
        let omega = (4.0 / (self.stable * self.stable) + self.rate).sqrt();
        // Without stiffness a dashpot alone: Δt ≤ 2/(c/m).
        let xi = 0.5 * self.damping / omega;
        if omega > 0.0 { 2.0 / omega * ((1.0 + xi * xi).sqrt() - xi) } else { 2.0 / self.damping }
    }
}

/// Why an explicit step cannot go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Halt {
    /// An element has no volume left.
    #[error("an element has turned inside out")]
    Inverted {
        /// The element.
        cell: CellId,
    },
    /// A force is no number any more.
    #[error("a force has no end")]
    Unbounded {
        /// The freedom it acts on.
        freedom: usize,
    },
    /// A freedom has neither mass nor support.
    #[error("a freedom has neither mass nor support")]
    Massless {
        /// The freedom.
        freedom: usize,
    },
    /// A body turns too far in one increment.
    #[error("a body turns too far in an increment")]
    Spinning {
        /// One of its rotations.
        freedom: usize,
    },
}

/// Whatever acts on the nodes in an explicit step: solids, members, loads, contact.
pub trait ExplicitTerm: Send {
    /// What messages call it.
    fn name(&self) -> &str;

    /// Adds its lumped masses [M] and moments of inertia [M L²] to the freedoms.
    fn add_mass(&self, _mass: &mut [f64]) {}

    /// Its tensors of inertia of nodes that turn in space; they are not in [`Self::add_mass`].
    fn rotary(&self) -> &[rotation::Rotary] {
        &[]
    }

    /// Is told the masses of all freedoms, its own included; of a tensor of inertia the least principal moment.
    fn weigh(&mut self, _mass: &[f64]) {}

    /// Corrects the end of an increment before forces are found there: impulses to `v`, and what they move to `u`. Its forces
    /// on free freedoms are in that; on prescribed ones [`Self::advance`] adds them.
    fn correct(&mut self, _at: &mut Predicted) {}

    /// Moves its state on to the end of an increment, and adds the forces [F] that act on the freedoms there.
    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt>;

    /// Energy [F L] that its forces have taken from the motion so far, stored or dissipated, by its own reckoning.
    fn stored(&self) -> f64;
}
