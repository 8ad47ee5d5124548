//! A contact pair: its points, what is known of them, and who answers for it.

use super::behaviour::Normal;
use super::carriers::{Carriers, RigidFollower};
use super::definition::{Definition, Enforcement};
use super::sides;
use super::target::{Faces, MainSurface, Target};
use crate::facet::Vec3;
use crate::point::ContactStatus;
use crate::tangents::Space;
use fe_core::explicit::{Advance, ExplicitTerm, Halt, Moving, Predicted};
use fe_core::{Freedoms, Structure};
use std::collections::BTreeMap;

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
    /// It has closed, and may not open any more.
    pub bonded: bool,
    pub gap: f64,
    pub pressure: f64,
    pub shear: [f64; 2],
    pub status: ContactStatus,
    /// Force [F] on the node at the end of the last increment.
    pub force: Vec3,
}

/// Increments in which impulses that depend on each other were still changing when their search ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Unsettled {
    /// How many.
    pub increments: usize,
    /// Largest change [L] of a gap in a last sweep: so far are gaps from what is wanted.
    pub change: f64,
}

/// A pair at work.
#[derive(Debug)]
pub struct ContactPair {
    pub(super) definition: Definition,
    pub(super) carriers: Carriers,
    pub(super) target: Target,
    pub(super) points: Vec<Point>,
    pub(super) space: Space,
    /// The increment [T] that the springs of hard contact were made for; `None` before, and where masses have changed since.
    pub(super) made_for: Option<f64>,
    pub(super) work: f64,
    pub(super) rubbed: f64,
    /// Forces [F] on prescribed freedoms, of kinematic contact in the last increment.
    pub(super) reactions: BTreeMap<usize, f64>,
    pub(super) unsettled: Unsettled,
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
        let space = if structure.is_plane() { Space::Plane } else { Space::Solid };
        ContactPair {
            definition,
            carriers,
            target,
            points,
            space,
            made_for: None,
            work: 0.0,
            rubbed: 0.0,
            reactions: BTreeMap::new(),
            unsettled: Unsettled::default(),
        }
    }

    /// Finds where the surfaces are, and which faces are near.
    pub(super) fn look(&mut self, u: &[f64], v: &[f64]) {
        self.carriers.update(u, v);
        if let Target::Faces(faces) = &mut self.target {
            faces.search(&self.carriers, self.points.iter().map(|point| point.index));
        }
    }

    /// Its part [-] of the impulses of kinematic contact; `None` where forces act.
    pub(super) fn part(&self) -> Option<f64> {
        match self.definition.enforcement {
            Enforcement::Kinematic(part) => Some(part),
            Enforcement::Penalty(_) => None,
        }
    }

    /// `SECONDARY on MAIN`.
    pub fn label(&self) -> &str {
        &self.definition.name
    }

    /// How many secondary nodes it has, and what acts at them.
    pub fn in_words(&self) -> (usize, String) {
        let is_hard = matches!(self.definition.behaviour.normal, Normal::Hard);
        let (hard, enforcement) = match self.part() {
            None => {
                let largest = self.points.iter().map(|point| point.penalty).fold(0.0, f64::max);
                (format!("hard, penalty up to {largest:.6e} F/L a node"), String::new())
            }
            Some(part) => {
                let weight = if part < 1.0 { format!(" of weight {part}") } else { String::new() };
                let damping = if is_hard { ", no damping" } else { "" };
                ("hard".to_owned(), format!(", kinematic{weight}{damping}"))
            }
        };
        (self.points.len(), self.definition.behaviour.in_words(&hard) + &enforcement)
    }

    /// Increments of kinematic contact that were left unsettled since this was asked last.
    pub fn take_unsettled(&mut self) -> Unsettled {
        std::mem::take(&mut self.unsettled)
    }

    /// Energy [F L] that friction has turned into heat.
    pub fn rubbed(&self) -> f64 {
        self.rubbed
    }
}

impl ExplicitTerm for ContactPair {
    fn name(&self) -> &str {
        &self.definition.name
    }

    fn weigh(&mut self, mass: &[f64]) {
        if self.carriers.weigh(mass) {
            self.made_for = None;
        }
    }

    fn correct(&mut self, at: &mut Predicted) {
        sides::correct(std::slice::from_mut(self), at);
    }

    fn advance(&mut self, at: &Moving, forces: &mut [f64]) -> Result<Advance, Halt> {
        if self.part().is_some() {
            if at.dt == 0.0 {
                self.survey(at.u, at.v);
            }
            self.reactions.iter().for_each(|(&freedom, force)| forces[freedom] += force);
            return Ok(Advance::default());
        }
        Ok(self.press(at, forces))
    }

    fn stored(&self) -> f64 {
        self.work
    }
}

/// A point that nothing presses.
pub(super) fn open(point: &Point) -> Point {
    Point {
        pressure: 0.0,
        shear: [0.0; 2],
        elastic: Vec3::zeros(),
        status: ContactStatus::Open,
        bonded: false,
        ..*point
    }
}
