//! Energies of an explicit job, and what is told of them.

use super::scene::Scene;
use fe_core::explicit::ExplicitTerm;
use fe_core::explicit::central_difference::{CentralDifference, State};

/// Energies [F L] of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// ALLKE: of motion.
    pub kinetic: f64,
    /// What stands for it in the balance: see [`CentralDifference::conserved`].
    pub conserved: f64,
    /// ALLSE: recoverable, of solids, trusses and springs.
    pub strain: f64,
    /// ALLPD: dissipated by plastic flow.
    pub plastic: f64,
    /// ALLAE: taken by the resistance to hourglass motion.
    pub artificial: f64,
    /// ALLVD: dissipated by bulk viscosity, dashpots and the damping of materials.
    pub viscous: f64,
    /// ALLFD: turned into heat by friction.
    pub friction: f64,
    /// ALLCW: what contact has taken besides: stored by penalties and laws, damped, lost in kinematic impacts.
    pub contact: f64,
    /// ALLWK: work of loads and supports.
    pub work: f64,
    /// What there was at the start: of initial velocities.
    pub initial: f64,
    /// Largest energy so far.
    pub largest: f64,
    /// Largest so far of what there was, came from outside, or was given by contact that began overclosed.
    pub given: f64,
    /// DMASS: what mass scaling has added [%].
    pub added_mass: f64,
}

/// Columns of the history of energies.
pub const COLUMNS: [&str; 12] =
    ["ALLKE", "ALLSE", "ALLPD", "ALLAE", "ALLIE", "ALLVD", "ALLFD", "ALLCW", "ALLWK", "DMASS", "ETOTAL", "increment"];

impl Balance {
    /// ALLIE: all that is in the elements.
    pub fn internal(&self) -> f64 {
        self.strain + self.plastic + self.artificial
    }

    /// ETOTAL: what is there, less what came from outside and what there was; 0 but for the error of the increments.
    pub fn total(&self) -> f64 {
        self.sum() - self.work - self.initial
    }

    fn sum(&self) -> f64 {
        self.conserved + self.internal() + self.viscous + self.friction + self.contact
    }

    /// What is in motion and in springs, over the most that was given [-]. A mode at x = ωΔt/2 has up to 1/(1 − x²) times what it
    /// was given: 25 at 0.98, 500 at 0.999.
    pub fn swell(&self) -> f64 {
        let energy = self.kinetic + self.strain;
        if energy == 0.0 { 0.0 } else { energy / self.given }
    }

    /// Its size over the largest energy so far [-].
    pub fn drift(&self) -> f64 {
        let total = self.total().abs();
        if total == 0.0 { 0.0 } else { total / self.largest }
    }

    /// Numbers in the order of the history of energies, `increment` the length of the last one [T].
    pub fn row(&self, increment: f64) -> [f64; 12] {
        let (b, internal, total) = (self, self.internal(), self.total());
        let inside = [b.kinetic, b.strain, b.plastic, b.artificial, internal];
        let [kinetic, strain, plastic, artificial, internal] = inside;
        let outside = [b.viscous, b.friction, b.contact, b.work, b.added_mass, total, increment];
        let [viscous, friction, contact, work, added, total, increment] = outside;
        [kinetic, strain, plastic, artificial, internal, viscous, friction, contact, work, added, total, increment]
    }
}

/// Keeps what the balance is reckoned from.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energies {
    initial: Option<f64>,
    largest: f64,
    given: f64,
}

impl Energies {
    /// The balance of a state; that of the first one is what there was.
    pub fn balance(&mut self, scene: &Scene, state: &State, procedure: &CentralDifference) -> Balance {
        let solids = scene.solids.as_ref().map(|solids| solids.energies()).unwrap_or_default();
        let [stored, dissipated] = scene.lines.as_ref().map_or([0.0; 2], |lines| lines.energies());
        let damped = scene.damping.as_ref().map_or(0.0, |damping| damping.stored());
        let [contact, friction] = scene.contact_energies();
        let mut balance = Balance {
            kinetic: procedure.kinetic(state),
            conserved: procedure.conserved(state),
            strain: solids.internal - solids.plastic + stored,
            plastic: solids.plastic,
            artificial: solids.hourglass,
            viscous: solids.viscous + dissipated + damped,
            friction,
            contact,
            work: state.work - scene.loads.stored(),
            added_mass: scene.added_mass(procedure.mass()),
            ..Balance::default()
        };
        let sum = balance.sum();
        balance.initial = *self.initial.get_or_insert(sum);
        self.largest = self.largest.max(sum.abs()).max(balance.kinetic + balance.internal());
        self.given = self.given.max((balance.initial + balance.work).abs()).max(-contact);
        (balance.largest, balance.given) = (self.largest, self.given);
        balance
    }
}

/// What is told of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Number of the step, from 1.
    pub step: usize,
    /// Increments of the step so far.
    pub increment: usize,
    /// Step time [T].
    pub step_time: f64,
    /// The last increment [T].
    pub dt: f64,
    /// Energies.
    pub balance: Balance,
}
