//! The main side: the nearest point of moving faces, or of a rigid surface.

use super::carriers::Carriers;
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
    /// Mean size [L] of the faces.
    size: f64,
    places: Vec<Vec3>,
    /// Candidate faces of each secondary node: where they begin in `faces`.
    start: Vec<u32>,
    faces: Vec<u32>,
}

/// Candidates lie within this part of the faces' mean size [-].
const MARGIN: f64 = 0.5;

/// A node counts as inside down to this part of a face's size [-]: deeper, it belongs to another face.
const DEEPEST: f64 = 0.5;

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
        Faces { corners, counts, size, places: Vec::new(), start: Vec::new(), faces: Vec::new() }
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
            let near = grid.meeting(&Bounds::around(&[carriers.x[node as usize]], 0.0));
            // A node does not meet faces of its own.
            self.faces.extend(near.into_iter().filter(|&face| !self.corners[face as usize].contains(&node)));
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
        let p = corners.map(|i| carriers.x[i as usize]);
        let (weights, normal) = match self.counts[face] {
            2 => {
                let along = p[1] - p[0];
                let s = ((x - p[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
                ([1.0 - s, s, 0.0, 0.0], along.cross(&Vec3::z()))
            }
            3 => {
                let [a, b, c] = on_triangle(x, [p[0], p[1], p[2]]);
                ([a, b, c, 0.0], (p[1] - p[0]).cross(&(p[2] - p[0])))
            }
            _ => on_quadrilateral(x, p),
        };
        let place: Vec3 = weights.iter().zip(&p).map(|(w, p)| p * *w).sum();
        let (normal, offset) = (normal.normalize(), x - place);
        let distance = offset.norm();
        let height = offset.dot(&normal);
        let sign = if height < 0.0 { -1.0 } else { 1.0 };
        // Past an edge the direction is that of the offset, as long as it is clearly there.
        let inside = (height.abs() - distance).abs() <= 1e-9 * self.size;
        let direction = if inside { normal } else { offset * (sign / distance) };
        let facing = if distance > 0.0 { height.abs() / distance } else { 1.0 };
        let shares = std::array::from_fn(|i| (corners[i], weights[i]));
        (Hit { gap: sign * if inside { height.abs() } else { distance }, normal: direction, place, shares }, facing)
    }
}

/// Barycentric weights of the point of a triangle nearest to x (Ericson, Real-Time Collision Detection, 5.1.5).
fn on_triangle(x: &Vec3, [a, b, c]: [Vec3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let dots = |p: &Vec3| (ab.dot(&(x - p)), ac.dot(&(x - p)));
    let ((d1, d2), (d3, d4), (d5, d6)) = (dots(&a), dots(&b), dots(&c));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let t = d1 / (d1 - d3);
        return [1.0 - t, t, 0.0];
    }
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let t = d2 / (d2 - d6);
        return [1.0 - t, 0.0, t];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - t, t];
    }
    let sum = va + vb + vc;
    [va / sum, vb / sum, vc / sum]
}

/// Weights of the corners at the nearest point of four triangles around the mean of the corners, and the normal there.
fn on_quadrilateral(x: &Vec3, p: [Vec3; 4]) -> ([f64; 4], Vec3) {
    let middle = (p[0] + p[1] + p[2] + p[3]) * 0.25;
    let mut best = (f64::INFINITY, [0.0; 4], Vec3::zeros());
    for i in 0..4 {
        let j = (i + 1) % 4;
        let [a, b, m] = on_triangle(x, [p[i], p[j], middle]);
        let distance = (p[i] * a + p[j] * b + middle * m - x).norm_squared();
        if distance < best.0 {
            let mut weights = [0.25 * m; 4];
            weights[i] += a;
            weights[j] += b;
            best = (distance, weights, (p[j] - p[i]).cross(&(middle - p[i])));
        }
    }
    (best.1, best.2)
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
