//! The main side: the nearest point of moving faces, or of a rigid surface.

use super::border::{borders, is_on_border};
use super::carriers::Carriers;
use super::foot::{DEEPEST, Foot};
use crate::closest::EXTENSION;
use crate::facet::Vec3;
use crate::rigid::RigidSurface;
use crate::search::{Bounds, Grid};

/// What secondary nodes meet.
#[derive(Clone, Debug)]
pub enum MainSurface {
    /// Faces by their corner nodes, two (an edge of a plane model), three or four; counter-clockwise seen from outside, an edge
    /// with the body on its left.
    Faces(Vec<Vec<u32>>),
    /// An analytical surface that moves with a reference node.
    Rigid {
        /// Shape.
        surface: RigidSurface,
        /// Reference node.
        reference: u32,
    },
}

/// The nearest point of the main side.
#[derive(Clone, Debug, Default)]
pub(super) struct Hit {
    /// Gap [L], negative inside.
    pub gap: f64,
    /// Unit normal, out of the main side.
    pub normal: Vec3,
    /// The point.
    pub place: Vec3,
    /// Nodes (in the carriers' lists) with their shares of what acts there; empty for a rigid surface.
    pub shares: [(u32, f64); 4],
}

/// The main side at work.
#[derive(Debug)]
pub(super) enum Target {
    Faces(Faces),
    /// The surface as at the start; its body is the first of the carriers'.
    Rigid(RigidSurface),
}

/// Faces with the candidates of each secondary node, which are good until a node has moved a half of the margin.
#[derive(Debug)]
pub(super) struct Faces {
    /// Corners in the carriers' lists; a triangle repeats its last, an edge has two.
    corners: Vec<[u32; 4]>,
    counts: Vec<u8>,
    /// The [`borders`] of each face.
    border: Vec<u8>,
    /// Mean size [L] of the faces.
    size: f64,
    places: Vec<Vec3>,
    /// Candidate faces of each secondary node: where they begin in `faces`.
    start: Vec<u32>,
    faces: Vec<u32>,
}

/// Candidates lie within this part of the faces' mean size [-].
const MARGIN: f64 = 0.5;

impl Faces {
    pub fn new(faces: &[Vec<u32>], carriers: &Carriers) -> Self {
        let corners: Vec<[u32; 4]> = faces
            .iter()
            .map(|face| std::array::from_fn(|i| carriers.index(face[i.min(face.len() - 1)]) as u32))
            .collect();
        let counts: Vec<u8> = faces.iter().map(|face| face.len() as u8).collect();
        let sizes = corners.iter().map(|c| {
            let points = c.map(|i| carriers.x[i as usize]);
            (points[0] - points[2]).norm().max((points[1] - points[3]).norm())
        });
        let size = sizes.sum::<f64>() / corners.len().max(1) as f64;
        let border = borders(corners.iter().zip(counts.iter().copied()));
        Faces { corners, counts, border, size, places: Vec::new(), start: Vec::new(), faces: Vec::new() }
    }

    /// Searches anew where a node has moved far since the last search.
    pub fn search(&mut self, carriers: &Carriers, secondary: impl Iterator<Item = u32>) {
        let margin = MARGIN * self.size;
        let moved = |(x, before): (&Vec3, &Vec3)| (x - before).norm_squared();
        let farthest = carriers.x.iter().zip(&self.places).map(moved).fold(0.0, f64::max);
        if !self.places.is_empty() && farthest.sqrt() < 0.25 * margin {
            return;
        }
        self.places.clone_from(&carriers.x);
        let around = |corners: &[u32; 4]| Bounds::around(&corners.map(|i| carriers.x[i as usize]), margin);
        let grid = Grid::new(self.corners.iter().map(around).collect());
        self.start = vec![0];
        self.faces.clear();
        for node in secondary {
            let near = grid.holding(carriers.x[node as usize]);
            // A node does not meet faces of its own.
            self.faces.extend(near.filter(|&face| !self.corners[face as usize].contains(&node)));
            self.start.push(self.faces.len() as u32);
        }
    }

    /// The nearest point for the secondary node at a place of the list.
    fn nearest(&self, carriers: &Carriers, place: usize, x: &Vec3) -> Option<Hit> {
        let candidates = &self.faces[self.start[place] as usize..self.start[place + 1] as usize];
        let mut best: Option<(f64, f64, Hit)> = None;
        for &face in candidates {
            let (hit, facing) = self.on_face(carriers, face as usize, x);
            if hit.gap < -DEEPEST * self.size {
                continue;
            }
            let distance = (x - hit.place).norm();
            let tie = 1e-9 * self.size;
            let better =
                best.as_ref().is_none_or(|(d, f, _)| distance < d - tie || (distance < d + tie && facing > *f));
            if better {
                best = Some((distance, facing, hit));
            }
        }
        best.map(|(_, _, hit)| hit)
    }

    /// The nearest point of one face, and how squarely it faces x [-].
    fn on_face(&self, carriers: &Carriers, face: usize, x: &Vec3) -> (Hit, f64) {
        let corners = self.corners[face];
        let mut foot = Foot::on_face(&corners.map(|i| carriers.x[i as usize]), self.counts[face], x);
        if foot.gap < 0.0 && !foot.is_within && is_on_border(self.border[face], self.counts[face], &foot.weights) {
            foot = self.beyond(foot, x);
        }
        let shares = std::array::from_fn(|i| (corners[i], foot.weights[i]));
        (Hit { gap: foot.gap, normal: foot.normal, place: foot.place, shares }, foot.facing)
    }

    /// What is behind a face and past the border of the surface: near it as deep as it is, farther off outside.
    fn beyond(&self, foot: Foot, x: &Vec3) -> Foot {
        let height = foot.gap * foot.facing;
        let aside = (foot.gap * foot.gap - height * height).max(0.0).sqrt();
        if aside < EXTENSION * self.size {
            Foot { gap: height, normal: foot.face, ..foot }
        } else {
            Foot { gap: -foot.gap, normal: (x - foot.place).normalize(), ..foot }
        }
    }
}

impl Target {
    /// The nearest point for the secondary node at a place of the list.
    pub fn nearest(&self, carriers: &Carriers, place: usize, x: &Vec3) -> Option<Hit> {
        match self {
            Target::Faces(faces) => faces.nearest(carriers, place, x),
            Target::Rigid(surface) => {
                let body = &carriers.bodies[0];
                let distance = surface.distance(body.seen(x).into())?;
                let normal = body.rotation * Vec3::from(distance.normal);
                Some(Hit { gap: distance.gap, normal, place: x - normal * distance.gap, ..Hit::default() })
            }
        }
    }
}
