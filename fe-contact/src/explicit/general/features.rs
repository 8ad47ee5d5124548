//! Feature edges: where the surface has a ridge, or ends.

use super::definition::Sides;
use super::surface::{FaceData, normal};
use crate::facet::Vec3;
use std::collections::HashMap;

/// Cosine of the angle between the normals of two faces from which on their common edge is a feature: 30°.
const FEATURE: f64 = 0.866_025_403_784_438_6;

/// What an edge may touch: directions that point out of the body there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cone {
    /// From the normal of one face to that of the other.
    Ridge([u32; 2]),
    /// The same on the back of a sheet.
    Valley([u32; 2]),
    /// Away from the only face.
    End(u32),
}

/// A feature edge.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    /// In the carriers' lists.
    pub nodes: [u32; 2],
    pub cone: Cone,
    /// As that of a node.
    pub classes: u16,
    pub component: u32,
    pub body: Option<u32>,
}

impl Edge {
    /// Its faces.
    pub fn faces(&self) -> Vec<u32> {
        match self.cone {
            Cone::Ridge(both) | Cone::Valley(both) => both.to_vec(),
            Cone::End(only) => vec![only],
        }
    }

    /// Directions between which those out of the body lie, and the middle one.
    pub fn out(&self, faces: &[FaceData], x: &[Vec3]) -> ([Vec3; 2], Vec3) {
        let of = |face: u32| normal(&faces[face as usize], x);
        match self.cone {
            Cone::Ridge(both) => {
                let ends = both.map(of);
                (ends, ends[0] + ends[1])
            }
            Cone::Valley(both) => {
                let ends = both.map(|face| -of(face));
                (ends, ends[0] + ends[1])
            }
            Cone::End(face) => {
                let up = of(face);
                let along = (x[self.nodes[1] as usize] - x[self.nodes[0] as usize]).normalize();
                ([up, -up], along.cross(&up))
            }
        }
    }
}

/// The feature edges of faces.
pub(super) fn edges(faces: &[FaceData], x: &[Vec3]) -> Vec<Edge> {
    let mut sides: HashMap<[u32; 2], Vec<(u32, u8)>> = HashMap::new();
    let mut order = Vec::new();
    for (f, face) in faces.iter().enumerate() {
        let corners = face.corners();
        for i in 0..corners.len() {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            let key = [a.min(b), a.max(b)];
            let at = sides.entry(key).or_default();
            if at.is_empty() {
                order.push(key);
            }
            at.push((f as u32, i as u8));
        }
    }
    let mut out = Vec::new();
    for key in order {
        let at = &sides[&key];
        let (first, corner) = at[0];
        let face = &faces[first as usize];
        let cone = match at[..] {
            [_] => (face.sides == Sides::Both).then_some(Cone::End(first)),
            [_, (second, _)] => fold(faces, [first, second], x),
            _ => None,
        };
        let count = usize::from(face.count);
        // In the direction in which the first face goes around.
        let nodes = [face.corners[usize::from(corner)], face.corners[(usize::from(corner) + 1) % count]];
        out.extend(cone.map(|cone| Edge { nodes, cone, classes: 0, component: face.component, body: face.body }));
    }
    out
}

/// The cone of the edge of two faces that meet at an angle.
fn fold(faces: &[FaceData], both: [u32; 2], x: &[Vec3]) -> Option<Cone> {
    let [a, b] = both.map(|f| &faces[f as usize]);
    let [na, nb] = [a, b].map(|face| normal(face, x));
    if na.dot(&nb) > FEATURE {
        return None;
    }
    let middle = |face: &FaceData| face.corners().iter().map(|&i| x[i as usize]).sum::<Vec3>() / f64::from(face.count);
    let is_ridge = (middle(b) - middle(a)).dot(&na) < 0.0;
    match (is_ridge, a.sides == Sides::Both && b.sides == Sides::Both) {
        (true, _) => Some(Cone::Ridge(both)),
        (false, true) => Some(Cone::Valley(both)),
        (false, false) => None,
    }
}
