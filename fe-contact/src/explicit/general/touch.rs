//! Two places that touch, and what they are looked at with.

use super::definition::Acting;
use super::surface::Surface;
use super::table::Table;
use crate::explicit::behaviour::Meeting;
use crate::explicit::carriers::Carriers;
use crate::explicit::pair::{Point, open};
use crate::facet::Vec3;
use crate::point::ContactStatus;
use crate::tangents::Space;

/// A node and a face, or two edges, that touch or did so an increment ago.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    /// Node or edge.
    pub first: u32,
    /// Face or edge.
    pub second: u32,
    /// How far the places part as nodes move along the normal.
    pub row: [(u32, f64); 5],
    /// Unit normal, out of the second.
    pub normal: Vec3,
    pub point: Point,
    /// Stiffness [F/L] and viscosity [F T/L].
    pub rates: [f64; 2],
    /// Work taken and heat of friction [F L] in the increment.
    pub work: f64,
    pub rubbed: f64,
}

impl Touch {
    pub fn is_closed(&self) -> bool {
        self.point.status != ContactStatus::Open
    }

    /// Force [F] of the contact along the normal.
    pub fn normal_force(&self) -> Vec3 {
        self.normal * self.normal.dot(&self.point.force)
    }

    /// As it is when the places have left each other.
    pub fn left(&self, scene: &Scene) -> Self {
        let work = -0.5 * self.point.force.dot(&scene.way(&self.row));
        let point = Point { force: Vec3::zeros(), gap: f64::INFINITY, ..open(&self.point) };
        Touch { point, rates: [0.0; 2], work, rubbed: 0.0, ..*self }
    }
}

/// Where two places are against each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub gap: f64,
    /// Unit normal, out of the second.
    pub normal: Vec3,
    pub row: [(u32, f64); 5],
    /// Area [L²].
    pub measure: f64,
    /// Stiffness [F/L] of hard contact.
    pub penalty: f64,
}

/// An increment as contact sees it.
pub(super) struct Scene<'a> {
    pub surface: &'a Surface,
    pub carriers: &'a Carriers,
    pub table: &'a Table,
    /// Stiffness [F/L] of hard contact of each node; infinite where nothing moves it.
    pub penalties: &'a [f64],
    pub dt: f64,
    /// How far any two places have moved against each other since the start, at most [L].
    pub travelled: f64,
    /// For how long [T] what comes is foreseen, and the gap [L] below which it may act by then.
    pub soon: f64,
    pub reach: f64,
    /// The distance [L] below which places are looked at: `reach`, and twice what things move against each other in an
    /// increment, so that it is seen from which side they come.
    pub watched: f64,
    pub look: Look,
}

/// What is known of the candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Look {
    /// They are those of the start, where faces may overlap.
    First,
    /// They have just been found anew.
    Anew,
    /// They are those of the increment before.
    Again,
}

impl Scene<'_> {
    pub fn x(&self, node: u32) -> Vec3 {
        self.carriers.x[node as usize]
    }

    /// Where a node was at the beginning of the increment.
    pub fn before(&self, node: u32) -> Vec3 {
        self.carriers.x[node as usize] - self.carriers.v[node as usize] * self.dt
    }

    /// How far places part in the increment [L].
    fn way(&self, row: &[(u32, f64)]) -> Vec3 {
        self.rate(row) * self.dt
    }

    /// How fast they do [L/T].
    fn rate(&self, row: &[(u32, f64)]) -> Vec3 {
        row.iter().map(|&(node, d)| self.carriers.v[node as usize] * d).sum()
    }

    /// How deep [L] places may be that were not so at the beginning of the increment: twice what they themselves have moved
    /// against each other. What all things may have moved is too much: a stiff spring would begin with more than all energy.
    pub fn deep_at_once(&self, row: &[(u32, f64)]) -> f64 {
        2.0 * self.way(row).norm()
    }

    /// The least stiffness [F/L] of some nodes.
    pub fn penalty(&self, nodes: &[u32]) -> f64 {
        nodes.iter().map(|&node| self.penalties[node as usize]).fold(f64::INFINITY, f64::min)
    }

    /// Stiffness [F/L] where nodes have such shares of what acts.
    pub fn penalty_at(&self, shares: impl Iterator<Item = (u32, f64)>) -> f64 {
        shares.filter(|share| share.1 > 0.0).map(|(node, share)| share * self.penalties[node as usize]).sum()
    }

    /// Two places at the end of the increment; `before` is how they touched at its beginning.
    pub fn touch(&self, ends: [u32; 2], before: Option<&Touch>, at: Place, acting: Acting) -> Touch {
        let Place { gap, normal, row, measure, penalty } = at;
        let rate = self.rate(&row);
        let moved = rate * self.dt;
        let was = before.map_or_else(Point::default, |touch| touch.point);
        let point = Point { index: row[0].0, measure, penalty, ..was };
        let mass = self.carriers.mass_of(&row);
        let closing = (-self.soon * rate.dot(&normal)).max(0.0);
        let meeting = Meeting { gap, normal, moved, closing, mass, dt: self.dt, space: Space::Solid };
        let answer = self.table.behaviours[usize::from(acting.behaviour)].meet(&point, &meeting);
        let answered = if answer.point.status == ContactStatus::Open { open(&answer.point) } else { answer.point };
        Touch {
            first: ends[0],
            second: ends[1],
            row,
            normal,
            point: answered,
            rates: answer.rates,
            work: -0.5 * (was.force + answer.point.force).dot(&moved),
            rubbed: answer.rubbed,
        }
    }
}
