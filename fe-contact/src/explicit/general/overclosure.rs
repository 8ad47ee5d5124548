//! Overclosures of the start: nodes are moved out of them without strain, before anything else is made.

use super::surface::FaceData;
use super::touch::{Look, Touch};
use super::{GeneralContact, GeneralDefinition, PENALTY};
use crate::explicit::carriers::RigidFollower;
use crate::facet::Vec3;
use fe_core::{Freedoms, Structure};
use std::collections::BTreeMap;

/// Moves of the nodes, one after the other, at most: those of one change the overclosures of others.
const SWEEPS: usize = 10;

/// Overclosure over the mean size of the faces that is left [-].
const LEFT: f64 = 1e-6;

/// What was moved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Adjusted {
    /// Nodes that were moved.
    pub nodes: usize,
    /// How far at most [L].
    pub farthest: f64,
    /// Deepest overclosure before and after [L].
    pub deepest: [f64; 2],
}

/// Moves the nodes of solids out of the faces that they are behind, where deformable bodies overlap each of them by half. Faces of
/// one body, and depths of more than half a face, stay as they are. `None` where nothing overlaps.
pub fn adjust(
    structure: &mut Structure,
    freedoms: &Freedoms,
    definition: &GeneralDefinition,
    rigid: &[RigidFollower],
) -> Option<Adjusted> {
    let mut moved: BTreeMap<u32, Vec3> = BTreeMap::new();
    let (mut deepest, mut left) = (None, 0.0);
    for _ in 0..SWEEPS {
        let mut contact = GeneralContact::new(structure, freedoms, definition, rigid);
        let tolerance = LEFT * contact.ground.surface.size;
        let touches = contact.overlaps();
        let depth = |touch: &Touch| -touch.point.gap;
        left = touches.iter().map(depth).fold(0.0, f64::max);
        if left <= tolerance {
            break;
        }
        deepest.get_or_insert(left);
        let (carriers, faces) = (&contact.ground.carriers, &contact.ground.surface.faces);
        for touch in touches.iter().filter(|touch| carriers.body_of(touch.first).is_none()) {
            let part = part(&faces[touch.second as usize]);
            let by = touch.normal * (part * depth(touch));
            let node = carriers.nodes[touch.first as usize];
            *moved.entry(node).or_insert_with(Vec3::zeros) += by;
            let place = &mut structure.mesh.points[node as usize];
            (0..3).for_each(|c| place[c] += by[c]);
        }
    }
    let farthest = moved.values().map(|by| by.norm()).fold(0.0, f64::max);
    deepest.map(|deepest| Adjusted { nodes: moved.len(), farthest, deepest: [deepest, left] })
}

fn part(face: &FaceData) -> f64 {
    if face.body.is_some() { 1.0 } else { 0.5 }
}

impl GeneralContact {
    /// The nodes that are behind faces at the start.
    fn overlaps(&mut self) -> Vec<Touch> {
        let carriers = &self.ground.carriers;
        let of = |node: u32| if carriers.body_of(node).is_some() { f64::INFINITY } else { PENALTY };
        self.ground.penalties = (0..carriers.nodes.len() as u32).map(of).collect();
        let look = self.search(0.0);
        debug_assert_eq!(look, Look::First);
        self.meet(0.0, look);
        let of_nodes = self.nodes.iter().flat_map(|run| &run.touches);
        of_nodes.filter(|touch| touch.point.gap < 0.0).copied().collect()
    }
}
