//! A contact pair. By penalty: equal and opposite forces where secondary nodes are closed.

use super::carriers::{Carriers, RigidFollower};
use super::target::{Faces, Hit, MainSurface, Target};
use crate::facet::Vec3;
use crate::friction::{Coulomb, Sliding, Spring};
use crate::law::NormalLaw;
use crate::point::ContactStatus;
use crate::tangents::{Space, tangents};
use fe_core::explicit::{Advance, ExplicitTerm, Halt, Moving, Predicted};
use fe_core::{Freedoms, Structure};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The secondary side: each node with what the law's number is multiplied by, area [L²], length [L], or 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Secondary {
    /// Nodes and their measures.
    pub nodes: Vec<(u32, f64)>,
}

/// How surfaces answer in normal direction.
#[derive(Clone, Debug)]
pub enum Normal {
    /// No overclosure wanted.
    Hard,
    /// A softened law.
    Softened(Arc<dyn NormalLaw>),
}

/// How contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enforcement {
    /// Springs; hard contact has those of `PENALTY` times this factor.
    Penalty(f64),
    /// Impulses that correct the end of every increment: hard contact is kept exactly, and no increment is shortened.
    Kinematic,
}

/// `*CONTACT DAMPING` of closed points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Viscosity {
    /// μ₀ [F T/L³], by the unit rule [F T/L²] or [F T/L].
    Coefficient(f64),
    /// A part ξ [-] of what is critical: ξ √(4 m k) with the mass of the node and its contact stiffness.
    Critical(f64),
}

/// A pair.
#[derive(Clone, Debug)]
pub struct Definition {
    /// `SECONDARY on MAIN`.
    pub name: String,
    /// Secondary side.
    pub secondary: Secondary,
    /// Main side.
    pub main: MainSurface,
    /// Normal behaviour.
    pub normal: Normal,
    /// Enforcement.
    pub enforcement: Enforcement,
    /// Friction. It sticks on springs as stiff as those of hard contact, on its own where no element has given them a stiffness.
    pub friction: Option<Coulomb>,
    /// Damping across the surface, and along it as a part of that [-].
    pub damping: Option<(Viscosity, f64)>,
}

/// Stiffness of hard contact of a node over m/Δt² [-], m the mass that the two sides have against each other and Δt the
/// increment that the elements allow: the increment shrinks by some percent.
pub const PENALTY: f64 = 0.1;

/// A secondary node.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Point {
    /// In the carriers' lists.
    pub index: u32,
    pub measure: f64,
    /// Stiffness [F/L] of hard contact.
    pub penalty: f64,
    /// Elastic slip [L], a vector along the surface.
    pub elastic: Vec3,
    /// Slip while closed [L].
    pub slip: [f64; 2],
    pub gap: f64,
    pub pressure: f64,
    pub shear: [f64; 2],
    pub status: ContactStatus,
    /// Force [F] on the node at the end of the last increment.
    pub force: Vec3,
}

/// What is known of a secondary node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// Node.
    pub node: u32,
    /// Gap [L]; `None` where nothing is near.
    pub opening: Option<f64>,
    /// The law's number, positive in compression.
    pub pressure: f64,
    /// Shear in the same unit along t₁ and t₂.
    pub shear: [f64; 2],
    /// Slip while closed [L].
    pub slip: [f64; 2],
    /// Open, closed or slipping.
    pub status: ContactStatus,
    /// Area, length or 1.
    pub measure: f64,
}

/// A pair at work.
#[derive(Debug)]
pub struct ContactPair {
    pub(super) definition: Definition,
    pub(super) carriers: Carriers,
    pub(super) target: Target,
    pub(super) points: Vec<Point>,
    pub(super) secondary: Vec<u32>,
    pub(super) space: Space,
    has_penalty: bool,
    pub(super) work: f64,
    pub(super) rubbed: f64,
    /// Forces [F] on prescribed freedoms, of kinematic contact in the last increment.
    pub(super) reactions: BTreeMap<usize, f64>,
}

impl ContactPair {
    /// With all surfaces where they are at the start; `rigid` are the bodies whose nodes may be in the faces.
    pub fn new(structure: &Structure, freedoms: &Freedoms, definition: Definition, rigid: &[RigidFollower]) -> Self {
        let own = definition.secondary.nodes.iter().map(|n| n.0);
        let (nodes, references): (Vec<u32>, Vec<u32>) = match &definition.main {
            MainSurface::Faces(faces) => (own.chain(faces.iter().flatten().copied()).collect(), Vec::new()),
            MainSurface::Rigid { reference, .. } => (own.collect(), vec![*reference]),
        };
        let carriers = Carriers::new(structure, freedoms, nodes, rigid, &references);
        let target = match &definition.main {
            MainSurface::Faces(faces) => Target::Faces(Faces::new(faces, &carriers)),
            MainSurface::Rigid { surface, .. } => Target::Rigid(surface.clone()),
        };
        let point =
            |&(node, measure): &(u32, f64)| Point { index: carriers.index(node) as u32, measure, ..Point::default() };
        let points: Vec<Point> = definition.secondary.nodes.iter().map(point).collect();
        let secondary = points.iter().map(|p| p.index).collect();
        let space = if structure.is_plane() { Space::Plane } else { Space::Solid };
        ContactPair {
            definition,
            carriers,
            target,
            points,
            secondary,
            space,
            has_penalty: false,
            work: 0.0,
            rubbed: 0.0,
            reactions: BTreeMap::new(),
        }
    }

    /// State of all secondary nodes.
    pub fn states(&self) -> impl Iterator<Item = PointState> + '_ {
        self.points.iter().map(|p| PointState {
            node: self.carriers.nodes[p.index as usize],
            opening: p.gap.is_finite().then_some(p.gap),
            pressure: p.pressure,
            shear: p.shear,
            slip: p.slip,
            status: p.status,
            measure: p.measure,
        })
    }

    /// `SECONDARY on MAIN`.
    pub fn label(&self) -> &str {
        &self.definition.name
    }

    /// How many secondary nodes it has, and what acts at them.
    pub fn in_words(&self) -> (usize, String) {
        let normal = match &self.definition.normal {
            Normal::Softened(_) => "softened law".to_owned(),
            Normal::Hard if self.definition.enforcement == Enforcement::Kinematic => "hard".to_owned(),
            Normal::Hard => {
                let largest = self.points.iter().map(|point| point.penalty).fold(0.0, f64::max);
                format!("hard, penalty up to {largest:.6e} F/L a node")
            }
        };
        let friction = if self.definition.friction.is_some() { ", friction" } else { "" };
        let damping = match self.definition.damping {
            Some((Viscosity::Critical(part), _)) if part > 0.0 => format!(", damping {part} of critical"),
            Some((Viscosity::Coefficient(value), _)) if value > 0.0 => format!(", damping {value:.6e}"),
            _ => String::new(),
        };
        let enforcement =
            if self.definition.enforcement == Enforcement::Kinematic { ", kinematic, no damping" } else { "" };
        (self.points.len(), format!("{normal}{enforcement}{friction}{damping}"))
    }

    /// Energy [F L] that friction has turned into heat.
    pub fn rubbed(&self) -> f64 {
        self.rubbed
    }

    /// Mass [M] that a point and what it meets have against each other: 1/m = 1/m_s + Σ N²/m_i; what has none counts as held.
    fn mass(&self, point: &Point, hit: &Hit) -> f64 {
        let inverse = |index: u32| {
            let mass = self.carriers.mass[index as usize];
            if mass > 0.0 { 1.0 / mass } else { 0.0 }
        };
        let main: f64 = hit.shares.iter().map(|&(node, w)| if w > 0.0 { w * w * inverse(node) } else { 0.0 }).sum();
        let all = inverse(point.index) + main;
        if all > 0.0 { 1.0 / all } else { 0.0 }
    }

    /// Stiffness of hard contact, once the increment is known.
    fn stiffen(&mut self, increment: f64) {
        let Enforcement::Penalty(scale) = self.definition.enforcement else { return };
        for point in &mut self.points {
            let mass = self.carriers.mass[point.index as usize];
            point.penalty = if increment.is_finite() { scale * PENALTY * mass / (increment * increment) } else { 0.0 };
        }
        self.has_penalty = true;
    }

    /// Pressure and slope of a point, in the law's unit.
    fn normal(&self, point: &Point, gap: f64) -> (f64, f64) {
        match &self.definition.normal {
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

    /// One point at a hit: its new state, and the force [F] on the secondary node.
    fn meet(&self, point: &Point, hit: &Hit, moved: &Vec3, dt: f64) -> (Point, Vec3, [f64; 3]) {
        let mut next = Point { gap: hit.gap, ..*point };
        let (law, slope) = self.normal(point, hit.gap);
        let mass = self.mass(point, hit);
        let stiffness = slope * point.measure;
        let mut pressure = law;
        let mut damping = 0.0;
        if let Some((viscosity, _)) = self.definition.damping
            && law > 0.0
            && dt > 0.0
        {
            damping = match viscosity {
                Viscosity::Coefficient(coefficient) => coefficient * point.measure,
                Viscosity::Critical(part) => part * (4.0 * mass * stiffness).sqrt(),
            };
            // It never pulls.
            pressure = (law - damping * moved.dot(&hit.normal) / dt / point.measure).max(0.0);
        }
        next.pressure = pressure;
        next.status = if law > 0.0 { ContactStatus::Closed } else { ContactStatus::Open };
        let mut force = hit.normal * (pressure * point.measure);
        (next.elastic, next.shear) = (Vec3::zeros(), [0.0; 2]);
        let mut rubbed = 0.0;
        if let Some(friction) = &self.definition.friction
            && law > 0.0
        {
            let directions = tangents(&hit.normal, self.space);
            let along = |v: &Vec3| directions.map(|t| t.dot(v));
            let (elastic, slip) = (along(&point.elastic), along(moved));
            let stiff = point.penalty / point.measure;
            let spring = if stiff > 0.0 { Spring::Stiffness(stiff) } else { friction.spring };
            let answer = friction.respond_on(spring, Sliding { pressure, elastic, slip, dt });
            for i in 0..2 {
                force -= directions[i] * (answer.shear[i] * point.measure);
                next.elastic += directions[i] * answer.elastic[i];
                next.slip[i] += slip[i];
                let heat = slip[i] - (answer.elastic[i] - elastic[i]);
                rubbed += answer.shear[i] * heat * point.measure;
            }
            next.shear = answer.shear;
            if answer.slips {
                next.status = ContactStatus::Slipping;
            }
        }
        (next, force, [stiffness, damping, rubbed])
    }
}

impl ExplicitTerm for ContactPair {
    fn name(&self) -> &str {
        &self.definition.name
    }

    fn weigh(&mut self, mass: &[f64]) {
        self.carriers.weigh(mass);
    }

    fn correct(&mut self, at: &mut Predicted) {
        if self.definition.enforcement == Enforcement::Kinematic {
            self.correct_kinematically(at);
        }
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        if self.definition.enforcement == Enforcement::Kinematic {
            if at.dt == 0.0 {
                self.survey(at.u, at.v);
            }
            self.reactions.iter().for_each(|(&freedom, force)| forces[freedom] += force);
            return Ok(Advance::default());
        }
        self.carriers.update(at.u, at.v);
        if !self.has_penalty {
            self.stiffen(at.stable);
        }
        if let Target::Faces(faces) = &mut self.target {
            faces.search(&self.carriers, &self.secondary);
        }
        for i in 0..self.points.len() {
            let point = self.points[i];
            let index = point.index as usize;
            let (x, v) = (self.carriers.x[index], self.carriers.v[index]);
            let Some(hit) = self.target.nearest(&self.carriers, i, &x) else {
                self.points[i] = Point { gap: f64::INFINITY, force: Vec3::zeros(), ..open(&point) };
                continue;
            };
            let main: Vec3 = match &self.target {
                Target::Faces(_) => hit.shares.iter().map(|&(node, w)| self.carriers.v[node as usize] * w).sum(),
                Target::Rigid(_) => self.carriers.bodies[0].velocity_at(&x),
            };
            let moved = (v - main) * at.dt;
            let (next, force, [stiffness, damping, rubbed]) = self.meet(&point, &hit, &moved, at.dt);
            self.work -= 0.5 * (point.force + force).dot(&moved);
            self.rubbed += rubbed;
            self.points[i] = Point { force, ..next };
            if force == Vec3::zeros() {
                continue;
            }
            self.carriers.stiffen(point.index, &hit.shares, [stiffness, damping]);
            self.carriers.force[index] += force;
            match &self.target {
                Target::Faces(_) => {
                    hit.shares.iter().for_each(|&(node, w)| self.carriers.force[node as usize] -= force * w);
                }
                Target::Rigid(_) => self.carriers.bodies[0].push(&-force, &x),
            }
        }
        self.carriers.scatter(forces);
        let [rate, damping] = self.carriers.rates();
        Ok(Advance { rate, damping, ..Advance::default() })
    }

    fn stored(&self) -> f64 {
        self.work
    }
}

/// A point that nothing presses.
pub(super) fn open(point: &Point) -> Point {
    Point { pressure: 0.0, shear: [0.0; 2], elastic: Vec3::zeros(), status: ContactStatus::Open, ..*point }
}
