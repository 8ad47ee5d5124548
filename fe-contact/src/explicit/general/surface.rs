//! The faces of general contact with their nodes, edges and neighbours.

use super::definition::{GeneralDefinition, GeneralFace, Sides};
use super::features::Edge;
use crate::explicit::border::{borders, is_on_border};
use crate::explicit::carriers::Carriers;
use crate::facet::Vec3;
use std::collections::HashMap;

/// A face.
#[derive(Clone, Debug)]
pub(super) struct FaceData {
    /// Corners in the carriers' lists; a triangle repeats its last.
    pub corners: [u32; 4],
    pub count: u8,
    pub sides: Sides,
    pub class: u16,
    /// See [`borders`].
    pub borders: u8,
    /// Faces that share nodes, directly or through others, have the same number.
    pub component: u32,
    /// The rigid body that it belongs to.
    pub body: Option<u32>,
    /// Longest diagonal [L] at the start.
    pub size: f64,
}

impl FaceData {
    /// Its corners, each once.
    pub fn corners(&self) -> &[u32] {
        &self.corners[..usize::from(self.count)]
    }

    /// True where a point with such shares of the corners lies on an edge that no other face has.
    pub fn is_on_border(&self, weights: &[f64; 4]) -> bool {
        is_on_border(self.borders, self.count, weights)
    }
}

/// A node.
#[derive(Clone, Debug, Default)]
pub(super) struct NodeData {
    /// Classes of its faces: an index into `class_sets`.
    pub classes: u16,
    pub component: u32,
    pub body: Option<u32>,
    /// Its faces.
    pub faces: Vec<u32>,
    /// It is the end of a feature edge.
    pub is_feature: bool,
    /// Its faces are sheets.
    pub is_sheet: bool,
}

/// All faces, nodes and feature edges; nodes are numbered as in the carriers' lists.
#[derive(Debug)]
pub(super) struct Surface {
    pub faces: Vec<FaceData>,
    pub nodes: Vec<NodeData>,
    pub edges: Vec<Edge>,
    /// Sets of classes that nodes and edges have.
    pub class_sets: Vec<Vec<u16>>,
    /// Mean size [L] of the faces.
    pub size: f64,
}

impl Surface {
    /// At the start.
    pub fn new(definition: &GeneralDefinition, carriers: &Carriers) -> Self {
        let components = components(&definition.faces, carriers);
        let of = |face: &GeneralFace| {
            let last = face.nodes.len() - 1;
            let corners: [u32; 4] = std::array::from_fn(|i| carriers.index(face.nodes[i.min(last)]) as u32);
            let p = corners.map(|i| carriers.x[i as usize]);
            let size = (p[0] - p[2]).norm().max((p[1] - p[3]).norm());
            FaceData {
                corners,
                count: face.nodes.len() as u8,
                sides: face.sides,
                class: face.class,
                borders: 0,
                component: components[corners[0] as usize],
                body: carriers.body_of(corners[0]),
                size,
            }
        };
        let mut faces: Vec<FaceData> = definition.faces.iter().map(of).collect();
        let borders = borders(faces.iter().map(|face| (&face.corners, face.count)));
        faces.iter_mut().zip(borders).for_each(|(face, borders)| face.borders = borders);
        let nodes = (0..carriers.nodes.len() as u32).map(|i| NodeData {
            component: components[i as usize],
            body: carriers.body_of(i),
            ..NodeData::default()
        });
        let mut nodes: Vec<NodeData> = nodes.collect();
        let mut classes: Vec<Vec<u16>> = vec![Vec::new(); nodes.len()];
        for (number, face) in faces.iter().enumerate() {
            for &corner in face.corners() {
                let node = &mut nodes[corner as usize];
                node.faces.push(number as u32);
                node.is_sheet |= face.sides == Sides::Both;
                classes[corner as usize].push(face.class);
            }
        }
        let mut sets = ClassSets::default();
        nodes.iter_mut().zip(classes).for_each(|(node, classes)| node.classes = sets.number(classes));
        let mut edges = super::features::edges(&faces, &carriers.x);
        edges.iter().flat_map(|edge| edge.nodes).for_each(|n| nodes[n as usize].is_feature = true);
        for edge in &mut edges {
            edge.classes = sets.number(edge.faces().iter().map(|&face| faces[face as usize].class).collect());
        }
        let size = faces.iter().map(|face| face.size).sum::<f64>() / faces.len().max(1) as f64;
        Surface { faces, nodes, edges, class_sets: sets.list, size }
    }

    /// An equal share of the area [L²] of each of a node's faces.
    pub fn area(&self, node: u32, x: &[Vec3]) -> f64 {
        let share = |face: &FaceData| 0.5 * twice(face, x).norm() / f64::from(face.count);
        self.nodes[node as usize].faces.iter().map(|&face| share(&self.faces[face as usize])).sum()
    }

    /// The area [L²] with which a node faces what has this unit normal: equal shares of its faces, as that sees them; a thousandth
    /// of their own area at least.
    pub fn facing(&self, node: u32, normal: &Vec3, x: &[Vec3]) -> f64 {
        let mut facing = 0.0;
        for &number in &self.nodes[node as usize].faces {
            let face = &self.faces[number as usize];
            let share = twice(face, x) * (0.5 / f64::from(face.count));
            let seen = -share.dot(normal);
            facing += if face.sides == Sides::Both { seen.abs() } else { seen.max(0.0) };
        }
        facing.max(1e-3 * self.area(node, x))
    }

    /// The unit normals of all faces.
    pub fn face_normals(&self, x: &[Vec3]) -> Vec<Vec3> {
        self.faces.iter().map(|face| normal(face, x)).collect()
    }

    /// The unit normals of all nodes: those of their faces by the angles there, which point out of the body at any corner
    /// (Bærentzen and Aanæs, Signed distance computation using the angle weighted pseudonormal); 0 where they cancel.
    pub fn node_normals(&self, x: &[Vec3], faces: &[Vec3]) -> Vec<Vec3> {
        let mut normals = vec![Vec3::zeros(); self.nodes.len()];
        for (face, normal) in self.faces.iter().zip(faces) {
            let corners = face.corners();
            let count = corners.len();
            for i in 0..count {
                let at = |j: usize| x[corners[j % count] as usize];
                let (a, b) = (at(i + 1) - at(i), at(i + count - 1) - at(i));
                normals[corners[i] as usize] += normal * a.cross(&b).norm().atan2(a.dot(&b));
            }
        }
        normals.iter_mut().for_each(|n| *n = n.try_normalize(1e-6).unwrap_or_else(Vec3::zeros));
        normals
    }
}

/// Twice the vector of the area.
fn twice(face: &FaceData, x: &[Vec3]) -> Vec3 {
    let p = face.corners.map(|i| x[i as usize]);
    if face.count == 3 { (p[1] - p[0]).cross(&(p[2] - p[0])) } else { (p[2] - p[0]).cross(&(p[3] - p[1])) }
}

/// Unit normal of a face, out of the body.
pub(super) fn normal(face: &FaceData, x: &[Vec3]) -> Vec3 {
    twice(face, x).try_normalize(0.0).unwrap_or_else(Vec3::zeros)
}

/// The number of each node's component: the least node that it is connected with.
fn components(faces: &[GeneralFace], carriers: &Carriers) -> Vec<u32> {
    fn root(parents: &mut [u32], mut i: u32) -> u32 {
        while parents[i as usize] != i {
            parents[i as usize] = parents[parents[i as usize] as usize];
            i = parents[i as usize];
        }
        i
    }
    let mut parents: Vec<u32> = (0..carriers.nodes.len() as u32).collect();
    for face in faces {
        let first = carriers.index(face.nodes[0]) as u32;
        for &node in &face.nodes[1..] {
            let (a, b) = (root(&mut parents, first), root(&mut parents, carriers.index(node) as u32));
            parents[a.max(b) as usize] = a.min(b);
        }
    }
    (0..parents.len() as u32).map(|i| root(&mut parents, i)).collect()
}

/// Sets of classes, each with a number.
#[derive(Default)]
struct ClassSets {
    list: Vec<Vec<u16>>,
    known: HashMap<Vec<u16>, u16>,
}

impl ClassSets {
    fn number(&mut self, mut set: Vec<u16>) -> u16 {
        set.sort_unstable();
        set.dedup();
        *self.known.entry(set).or_insert_with_key(|set| {
            self.list.push(set.clone());
            self.list.len() as u16 - 1
        })
    }
}
