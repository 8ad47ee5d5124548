//! What acts at one point of contact that forces keep apart: law, damping and friction, whatever brings the point about.

use super::pair::Point;
use crate::facet::Vec3;
use crate::friction::{Coulomb, Sliding, Spring};
use crate::law::NormalLaw;
use crate::point::ContactStatus;
use crate::tangents::{Space, tangents};
use crate::viscous::DampingAmount;
use std::sync::Arc;

/// How surfaces answer in normal direction.
#[derive(Clone, Debug)]
pub enum Normal {
    /// No overclosure wanted.
    Hard,
    /// A softened law.
    Softened(Arc<dyn NormalLaw>),
}

/// What acts between two surfaces.
#[derive(Clone, Debug)]
pub struct Behaviour {
    /// Normal behaviour.
    pub normal: Normal,
    /// Friction. It sticks on springs as stiff as those of hard contact, on its own where no element has given them a stiffness.
    pub friction: Option<Coulomb>,
    /// Damping across the surface of closed points; along it nothing is damped.
    pub damping: Option<DampingAmount>,
}

/// Two surfaces at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    /// Gap [L], negative inside.
    pub gap: f64,
    /// Unit normal, out of the main side.
    pub normal: Vec3,
    /// Way [L] of the secondary side against the main one in the increment.
    pub moved: Vec3,
    /// Mass [M] that the sides have against each other.
    pub mass: f64,
    /// Length of the increment [T].
    pub dt: f64,
    pub space: Space,
}

/// The answer of a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer {
    /// Its new state, with the force [F] on the secondary side.
    pub point: Point,
    /// Stiffness [F/L] and viscosity [F T/L] across the surface.
    pub rates: [f64; 2],
    /// Heat [F L] of friction in the increment.
    pub rubbed: f64,
}

impl Behaviour {
    /// Pressure and slope of a point, in the law's unit.
    fn press(&self, point: &Point, gap: f64) -> (f64, f64) {
        match &self.normal {
            Normal::Softened(law) => {
                let response = law.respond(gap);
                (response.pressure, response.stiffness)
            }
            Normal::Hard => {
                let slope = point.penalty / point.measure;
                if gap < 0.0 { (-slope * gap, slope) } else { (0.0, 0.0) }
            }
        }
    }

    /// A point at the end of an increment.
    pub(super) fn meet(&self, point: &Point, at: &Meeting) -> Answer {
        let mut next = Point { gap: at.gap, ..*point };
        let (law, slope) = self.press(point, at.gap);
        let stiffness = slope * point.measure;
        let mut pressure = law;
        let mut damping = 0.0;
        if let Some(amount) = self.damping
            && law > 0.0
            && at.dt > 0.0
        {
            damping = match amount {
                DampingAmount::Coefficient(coefficient) => coefficient * point.measure,
                DampingAmount::CriticalFraction(part) => part * (4.0 * at.mass * stiffness).sqrt(),
            };
            // It never pulls.
            pressure = (law - damping * at.moved.dot(&at.normal) / at.dt / point.measure).max(0.0);
        }
        next.pressure = pressure;
        next.status = if law > 0.0 { ContactStatus::Closed } else { ContactStatus::Open };
        next.force = at.normal * (pressure * point.measure);
        (next.elastic, next.shear) = (Vec3::zeros(), [0.0; 2]);
        let mut rubbed = 0.0;
        if let Some(friction) = &self.friction
            && law > 0.0
        {
            rubbed = rub(friction, point, &mut next, at);
        }
        Answer { point: next, rates: [stiffness, damping], rubbed }
    }
}

/// Adds the friction of a closed point to its next state; the heat [F L].
fn rub(friction: &Coulomb, point: &Point, next: &mut Point, at: &Meeting) -> f64 {
    let directions = tangents(&at.normal, at.space);
    let along = |v: &Vec3| directions.map(|t| t.dot(v));
    let (elastic, slip) = (along(&point.elastic), along(&at.moved));
    let stiff = point.penalty / point.measure;
    let spring = if stiff > 0.0 { Spring::Stiffness(stiff) } else { friction.spring };
    let answer = friction.respond_on(spring, Sliding { pressure: next.pressure, elastic, slip, dt: at.dt });
    let mut rubbed = 0.0;
    for i in 0..2 {
        next.force -= directions[i] * (answer.shear[i] * point.measure);
        next.elastic += directions[i] * answer.elastic[i];
        next.slip[i] += slip[i];
        let heat = slip[i] - (answer.elastic[i] - elastic[i]);
        rubbed += answer.shear[i] * heat * point.measure;
    }
    next.shear = answer.shear;
    if answer.slips {
        next.status = ContactStatus::Slipping;
    }
    rubbed
}
