//! What acts at one point of contact that forces keep apart: law, damping and friction, whatever brings the point about.

use super::pair::Point;
use crate::facet::Vec3;
use crate::friction::{Coulomb, Sliding, Spring};
use crate::law::scale_factor::Scaling;
use crate::law::{NormalLaw, NormalResponse};
use crate::point::ContactStatus;
use crate::tangents::{Space, tangents};
use crate::viscous::{DampingAmount, ExplicitDamping};
use std::sync::Arc;

/// How surfaces answer in normal direction.
#[derive(Clone, Debug)]
pub enum Normal {
    /// No overclosure wanted.
    Hard,
    /// A softened law.
    Softened(Arc<dyn NormalLaw>),
    /// A law by scale factors over the stiffness of hard contact: for general contact.
    ScaleFactor {
        /// Its numbers.
        scaling: Scaling,
        /// Length [L] of the smallest element that may touch.
        smallest: f64,
    },
}

/// Whether points may open that have closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Separation {
    /// They may.
    #[default]
    Allowed,
    /// `NO SEPARATION`: from then on they pull, too: hard contact and LINEAR with the slope that they press with, TABULAR with
    /// the first one of the table (Abaqus Analysis User's Manual, Contact pressure-overclosure relationships).
    Never,
}

/// What acts between two surfaces.
#[derive(Clone, Debug)]
pub struct Behaviour {
    /// Normal behaviour.
    pub normal: Normal,
    /// Whether closed points may open.
    pub separation: Separation,
    /// Friction. It sticks on springs as stiff as those of hard contact, on its own where no element has given them a stiffness.
    pub friction: Option<Coulomb>,
    /// `SHEAR TRACTION SLOPE`: stiffness of other springs that it sticks on, in the law's unit over a length.
    pub shear_slope: Option<f64>,
    /// Damping of closed points, across the surface and of what sticks on springs along it.
    pub damping: Option<ExplicitDamping>,
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
    /// How much less the gap [L] may be after the next increment; 0 where the sides part.
    pub closing: f64,
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
    /// Largest stiffness [F/L] and viscosity [F T/L] of a direction.
    pub rates: [f64; 2],
    /// Heat [F L] of friction in the increment.
    pub rubbed: f64,
}

impl Behaviour {
    /// Law, friction and damping in a line; `hard` is what hard contact is called.
    pub fn in_words(&self, hard: &str) -> String {
        let normal = match &self.normal {
            Normal::Softened(_) => "softened law",
            Normal::ScaleFactor { .. } => "softened law by scale factors",
            Normal::Hard => hard,
        };
        let friction = if self.friction.is_some() { ", friction" } else { "" };
        let damping = match self.damping.map(|damping| damping.amount) {
            Some(DampingAmount::CriticalFraction(part)) if part > 0.0 => format!(", damping {part} of critical"),
            Some(DampingAmount::Coefficient(value)) if value > 0.0 => format!(", damping {value:.6e}"),
            _ => String::new(),
        };
        let bond = if self.separation == Separation::Never { ", no separation" } else { "" };
        format!("{normal}{bond}{friction}{damping}")
    }

    /// Pressure and slope of a point, in the law's unit.
    fn press(&self, point: &Point, gap: f64) -> (f64, f64) {
        let pair = |response: NormalResponse| (response.pressure, response.stiffness);
        match &self.normal {
            Normal::Softened(law) => pressed(law.as_ref(), gap, point.bonded),
            Normal::ScaleFactor { scaling, smallest } => {
                pair(scaling.over(point.penalty / point.measure, *smallest).respond(gap))
            }
            Normal::Hard => {
                let slope = point.penalty / point.measure;
                if gap < 0.0 || point.bonded { (-slope * gap, slope) } else { (0.0, 0.0) }
            }
        }
    }

    /// Viscosity [F T/L] of a point in a direction in which contact has a stiffness [F/L].
    pub(super) fn viscosity(&self, measure: f64, mass: f64, stiffness: f64) -> f64 {
        match self.damping.map(|damping| damping.amount) {
            Some(DampingAmount::Coefficient(coefficient)) => coefficient * measure,
            Some(DampingAmount::CriticalFraction(part)) => part * (4.0 * mass * stiffness).sqrt(),
            None => 0.0,
        }
    }

    /// A point at the end of an increment.
    pub(super) fn meet(&self, point: &Point, at: &Meeting) -> Answer {
        let mut next = Point { gap: at.gap, ..*point };
        let (law, slope) = self.press(point, at.gap);
        // What closes in the next increment is to find one that is stable with it: a spring met at full speed in a longer one
        // gives back more than it took.
        let (soon, coming) = if at.closing > 0.0 { self.press(point, at.gap - at.closing) } else { (0.0, 0.0) };
        let stiffness = slope * point.measure;
        let most = stiffness.max(coming * point.measure);
        next.bonded = self.separation == Separation::Never && (point.bonded || law > 0.0);
        let acts = law > 0.0 || next.bonded;
        let mut pressure = law;
        if acts && at.dt > 0.0 {
            let damping = self.viscosity(point.measure, at.mass, stiffness);
            pressure = law - damping * at.moved.dot(&at.normal) / at.dt / point.measure;
            if !next.bonded {
                // It never pulls.
                pressure = pressure.max(0.0);
            }
        }
        next.pressure = pressure;
        next.status = if acts { ContactStatus::Closed } else { ContactStatus::Open };
        next.force = at.normal * (pressure * point.measure);
        (next.elastic, next.shear) = (Vec3::zeros(), [0.0; 2]);
        let viscosity = if acts || soon > 0.0 { self.viscosity(point.measure, at.mass, most) } else { 0.0 };
        let mut rates = [most, viscosity];
        let mut rubbed = 0.0;
        if let Some(friction) = &self.friction
            && acts
        {
            let along = self.rub(friction, (point, &mut next), at);
            rates = [rates[0].max(along.rates[0]), rates[1].max(along.rates[1])];
            rubbed = along.rubbed;
        }
        Answer { point: next, rates, rubbed }
    }

    /// Adds the friction of a closed point to its next state.
    fn rub(&self, friction: &Coulomb, (point, next): (&Point, &mut Point), at: &Meeting) -> Along {
        let directions = tangents(&at.normal, at.space);
        let along = |v: &Vec3| directions.map(|t| t.dot(v));
        let (elastic, slip) = (along(&point.elastic), along(&at.moved));
        let of_hard = Some(point.penalty / point.measure).filter(|stiffness| *stiffness > 0.0);
        let spring = self.shear_slope.or(of_hard).map_or(friction.spring, Spring::Stiffness);
        let answer = friction.respond_on(spring, Sliding { pressure: next.pressure, elastic, slip, dt: at.dt });
        let mut out = Along { rates: [answer.stiffness[0][0] * point.measure, 0.0], rubbed: 0.0 };
        next.shear = answer.shear;
        let fraction = self.damping.map_or(0.0, |damping| damping.tangent_fraction);
        if !answer.slips && at.dt > 0.0 && fraction > 0.0 {
            out.rates[1] = fraction * self.viscosity(point.measure, at.mass, out.rates[0]);
            let rate = |i: usize| (answer.elastic[i] - elastic[i]) / at.dt;
            (0..2).for_each(|i| next.shear[i] += out.rates[1] * rate(i) / point.measure);
        }
        for i in 0..2 {
            next.force -= directions[i] * (next.shear[i] * point.measure);
            next.elastic += directions[i] * answer.elastic[i];
            next.slip[i] += slip[i];
            out.rubbed += answer.shear[i] * (slip[i] - (answer.elastic[i] - elastic[i])) * point.measure;
        }
        if answer.slips {
            next.status = ContactStatus::Slipping;
        }
        out
    }
}

/// What acts along the surface.
struct Along {
    /// Stiffness [F/L] and viscosity [F T/L].
    rates: [f64; 2],
    /// Heat [F L] of friction in the increment.
    rubbed: f64,
}

/// Pressure and slope of a law; where surfaces are bonded it goes on beyond its reach, with the slope that it has there.
pub(super) fn pressed(law: &dyn NormalLaw, gap: f64, bonded: bool) -> (f64, f64) {
    let reach = law.reach();
    if bonded && gap > reach {
        let slope = law.respond(reach).stiffness;
        return (slope * (reach - gap), slope);
    }
    let response = law.respond(gap);
    (response.pressure, response.stiffness)
}
