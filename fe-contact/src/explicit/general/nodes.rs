//! Nodes against faces.
//!
//! A node touches a face that is behind it and was before it, or is a neighbour of the one that it touches: what merely lies on
//! the back of a face, across a thin wall or around a ridge, never does. Of the faces of one connected surface the nearest
//! counts.

use super::definition::Sides;
use super::surface::{FaceData, NodeData};
use super::touch::{Look, Place, Scene, Touch};
use crate::explicit::behaviour::Normal;
use crate::explicit::foot::{DEEPEST, Foot};
use crate::facet::Vec3;
use crate::search::Grid;

/// Most of the product of the unit normals of a node and a face that it may touch [-]: they look at each other, or nearly.
const FACING: f64 = 0.3;

/// A face near a node.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    face: u32,
    /// 1 where the node is or was on the front of the face, −1 on the back of a sheet.
    side: f64,
    /// The node has been in front of that side.
    was_outside: bool,
    /// How far things must have travelled [L] until the node may be at the face.
    clear: f64,
}

/// Some nodes with the faces near them.
#[derive(Clone, Debug, Default)]
pub(super) struct Nodes {
    /// Their first and last, in the carriers' lists.
    range: std::ops::Range<u32>,
    /// Where the candidates of each begin.
    start: Vec<u32>,
    candidates: Vec<Candidate>,
    /// How far things must have travelled [L] until each may be at a face; of those that touch it does not matter.
    clear: Vec<f64>,
    /// Slip [L] of each while it was closed.
    slip: Vec<[f64; 2]>,
    /// Of the last increment, nodes ascending.
    pub touches: Vec<Touch>,
}

/// What a face is to a node.
struct Nearest {
    face: u32,
    side: f64,
    foot: Foot,
    gap: f64,
}

impl Nodes {
    pub fn new(range: std::ops::Range<u32>) -> Self {
        let slip = vec![[0.0; 2]; range.len()];
        Nodes { range, slip, ..Nodes::default() }
    }

    /// Number of pairs of a node and a face near each other.
    pub fn candidates(&self) -> usize {
        self.candidates.len()
    }

    /// Bytes of all of it.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.start[..])
            + size_of_val(&self.candidates[..])
            + size_of_val(&self.clear[..])
            + size_of_val(&self.slip[..])
            + size_of_val(&self.touches[..])
    }

    /// Finds the faces that come near, in a grid of their boxes.
    pub fn search(&mut self, scene: &Scene, grid: &Grid, [faces, nodes]: [&[Vec3]; 2]) {
        self.candidates.clear();
        self.start.clear();
        self.start.push(0);
        self.clear.clear();
        self.clear.resize(self.range.len(), f64::NEG_INFINITY);
        for i in self.range.clone() {
            let node = &scene.surface.nodes[i as usize];
            let first = self.candidates.len();
            let x = scene.x(i);
            for face in grid.holding(x) {
                let (data, normal) = (&scene.surface.faces[face as usize], &faces[face as usize]);
                let (product, height) =
                    (nodes[i as usize].dot(normal), (scene.before(i) - scene.before(data.corners[0])).dot(normal));
                if let Some(side) = side(node, data, product, height)
                    && !data.corners().contains(&i)
                    && part(scene, i, data).is_some()
                {
                    let clear = scene.travelled + away(scene, data, normal, &x);
                    self.candidates.push(Candidate { face, side, was_outside: false, clear });
                }
            }
            self.candidates[first..].sort_by_key(|c| scene.surface.faces[c.face as usize].component);
            self.start.push(self.candidates.len() as u32);
        }
    }

    /// Moves on to the end of an increment.
    pub fn advance(&mut self, scene: &Scene) {
        let before = std::mem::take(&mut self.touches);
        let mut before = before.as_slice();
        for local in 0..self.range.len() {
            let node = self.range.start + local as u32;
            let (own, rest) = before.split_at(before.iter().take_while(|touch| touch.first == node).count());
            before = rest;
            if scene.look == Look::Again && self.clear[local] - scene.travelled >= scene.watched {
                continue;
            }
            self.clear[local] = self.look(scene, local, own);
        }
    }

    /// Adds the touches of a node; how far things must have travelled until it may be at a face that it does not touch.
    fn look(&mut self, scene: &Scene, local: usize, before: &[Touch]) -> f64 {
        let node = self.range.start + local as u32;
        let range = self.start[local] as usize..self.start[local + 1] as usize;
        let faces = &scene.surface.faces;
        let component = |c: &Candidate| faces[c.face as usize].component;
        let closed: Vec<&Touch> = before.iter().filter(|touch| touch.is_closed()).collect();
        // The nearest face that counts is at most as much farther away than those that it touches as things have moved.
        let within = scene.watched + closed.iter().map(|touch| touch.point.gap.abs()).fold(0.0, f64::max);
        let (count, mut clear) = (self.touches.len(), f64::INFINITY);
        for same in self.candidates[range].chunk_by_mut(|a, b| component(a) == component(b)) {
            let number = component(&same[0]);
            let was = closed.iter().find(|touch| faces[touch.second as usize].component == number);
            let nearest = nearest(scene, node, same, &closed, within);
            clear = same.iter().map(|candidate| candidate.clear).fold(clear, f64::min);
            let Some(Nearest { face: number, side, foot, gap }) = nearest else {
                self.touches.extend(was.map(|was| was.left(scene)));
                continue;
            };
            let face = &faces[number as usize];
            if gap >= scene.reach && was.is_none() {
                continue;
            }
            let Some((acting, part)) = part(scene, node, face) else { continue };
            let share = |i: usize| (face.corners[i], foot.weights[i]);
            let opposite = scene.penalty_at((0..4).map(share));
            let scale = part * scene.table.scales[usize::from(acting.scale)];
            let normal = foot.normal * side;
            let place = Place {
                gap,
                normal,
                row: row(node, face, &foot),
                measure: part * scene.surface.facing(node, &normal, &scene.carriers.x),
                penalty: scale * scene.penalty(&[node]).min(opposite),
            };
            let mut touch = scene.touch([node, number], was.copied(), place, acting);
            if was.is_none() {
                let own = self.slip[local];
                (0..2).for_each(|i| touch.point.slip[i] += own[i]);
            }
            self.slip[local] = touch.point.slip;
            self.touches.push(touch);
        }
        let is_near = self.touches.len() > count;
        if is_near { f64::NEG_INFINITY } else { clear }
    }

    /// The nearest gap [L] of each node that does not touch and has a face near.
    pub fn gaps<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = (u32, f64)> + 'a {
        (0..self.range.len()).filter_map(move |local| {
            let node = self.range.start + local as u32;
            let mut own = self.candidates[self.start[local] as usize..self.start[local + 1] as usize].to_vec();
            if own.is_empty() || self.touches.binary_search_by_key(&node, |touch| touch.first).is_ok() {
                return None;
            }
            nearest(scene, node, &mut own, &[], f64::INFINITY).map(|nearest| (node, nearest.gap))
        })
    }

    /// Slip [L] of a node while it was closed.
    pub fn slip(&self, node: u32) -> [f64; 2] {
        self.slip[(node - self.range.start) as usize]
    }
}

/// The side of a face that a node may touch, by the product of their normals and the node's height [L] over the face; `None`
/// where they look the same way.
fn side(node: &NodeData, face: &FaceData, product: f64, height: f64) -> Option<f64> {
    match face.sides {
        Sides::Outer => (node.is_sheet || product < FACING).then_some(1.0),
        Sides::Both if node.is_sheet || product.abs() < FACING => Some(if height < 0.0 { -1.0 } else { 1.0 }),
        Sides::Both => Some(-product.signum()),
    }
}

/// What acts between a node and a face, and the node's part of it [-]: both sides are secondary by halves, but for rigid ones
/// against others; their ridges press on what is hard. `None`: nothing.
fn part(scene: &Scene, node: u32, face: &FaceData) -> Option<(super::Acting, f64)> {
    let data = &scene.surface.nodes[node as usize];
    let acting = scene.table.of_face(data.classes, face.class)?;
    let is_hard = || matches!(scene.table.behaviours[usize::from(acting.behaviour)].normal, Normal::Hard);
    let part = match (data.body, face.body) {
        (Some(one), Some(other)) if one == other => return None,
        (Some(_), None) if !(data.is_feature && is_hard()) => return None,
        (None, None) | (Some(_), Some(_)) => 0.5,
        (None, Some(_)) | (Some(_), None) => 1.0,
    };
    let moves = scene.penalty(&[node]).min(scene.penalty(face.corners())).is_finite();
    moves.then_some((acting, part))
}

/// The nearest of the faces of one component that a node is before or touches; what is farther away than `within` [L] is left
/// out, and sleeps: no face that the node has come through in the increment, or now touches instead of another one, is.
fn nearest(scene: &Scene, node: u32, same: &mut [Candidate], closed: &[&Touch], within: f64) -> Option<Nearest> {
    let faces = &scene.surface.faces;
    let x = scene.x(node);
    let mut best: Option<(usize, Foot, f64)> = None;
    let mut past = Vec::new();
    for (place, candidate) in same.iter_mut().enumerate() {
        let face = &faces[candidate.face as usize];
        // Around the edge of a sheet a node comes to the other side without coming nearer.
        let may_sleep = face.sides == Sides::Outer && scene.look != Look::First;
        if may_sleep && candidate.clear - scene.travelled >= within {
            continue;
        }
        let foot = Foot::on_face(&face.corners.map(|i| scene.x(i)), face.count, &x);
        let around = !foot.is_within && face.is_on_border(&foot.weights);
        let is_touched = closed.iter().any(|touch| touches_neighbour(faces, touch.second, candidate.face));
        if face.sides == Sides::Both && !foot.is_within {
            let side = if foot.gap < 0.0 { -1.0 } else { 1.0 };
            if around {
                candidate.side = side;
            }
            past.push((place, side));
        }
        let gap = candidate.side * foot.gap;
        candidate.clear = scene.travelled + gap.abs();
        let overlaps = scene.look == Look::First
            && foot.is_within
            && gap > -DEEPEST * face.size
            && scene.surface.nodes[node as usize].component != face.component;
        let is_behind = gap < 0.0;
        let was = match scene.look {
            Look::First => false,
            Look::Anew => is_behind && candidate.side * gap_before(scene, node, face) >= 0.0,
            Look::Again => candidate.was_outside,
        };
        // Nothing is deep at once: past a ridge, or a corner, the node has come around.
        let at_once = scene.deep_at_once(&row(node, face, &foot));
        let deepest = (at_once + within - scene.watched).min(DEEPEST * face.size);
        let may = !is_behind || overlaps || (!around && gap > -deepest && (was || is_touched));
        candidate.was_outside = was || !is_behind || overlaps;
        // Of faces that share the nearest point one that sees the node from outside is right: it is past a ridge of the others.
        let better = |(_, other, least): &(usize, Foot, f64)| {
            let tie = 1e-9 * face.size;
            let alike = (gap.abs() - least.abs()).abs() <= tie;
            let outside = (gap >= 0.0, foot.facing) > (*least >= 0.0, other.facing);
            if alike { outside } else { gap.abs() < least.abs() }
        };
        if may && best.as_ref().is_none_or(better) {
            best = Some((place, foot, gap));
        }
    }
    // Past an edge of a sheet a node that is outside may come to the other side.
    if best.as_ref().is_some_and(|(_, _, gap)| *gap >= 0.0) {
        past.into_iter().for_each(|(place, side)| same[place].side = side);
    }
    best.map(|(place, foot, gap)| Nearest { face: same[place].face, side: same[place].side, foot, gap })
}

/// How far a node and its foot part as nodes move.
fn row(node: u32, face: &FaceData, foot: &Foot) -> [(u32, f64); 5] {
    let corner = |i: usize| (face.corners[i], -foot.weights[i]);
    [(node, 1.0), corner(0), corner(1), corner(2), corner(3)]
}

/// The gap [L] of a node over a face at the beginning of the increment.
fn gap_before(scene: &Scene, node: u32, face: &FaceData) -> f64 {
    Foot::on_face(&face.corners.map(|i| scene.before(i)), face.count, &scene.before(node)).gap
}

/// The least distance [L] that a place may have from a face: by its height over it, and by a ball around it; of sheets none is
/// known.
fn away(scene: &Scene, face: &FaceData, normal: &Vec3, x: &Vec3) -> f64 {
    if face.sides == Sides::Both {
        return f64::NEG_INFINITY;
    }
    let corners = face.corners.map(|corner| scene.x(corner));
    let heights = corners.map(|corner| (x - corner).dot(normal));
    let (least, most) = heights.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(*h), b.max(*h)));
    let middle = (corners[0] + corners[2]) * 0.5;
    let radius = corners.iter().map(|corner| (corner - middle).norm_squared()).fold(0.0, f64::max).sqrt();
    least.max(-most).max((x - middle).norm() - radius)
}

/// True for the same face, and for faces that share a corner.
fn touches_neighbour(faces: &[FaceData], one: u32, other: u32) -> bool {
    let (a, b) = (&faces[one as usize], &faces[other as usize]);
    one == other || a.corners().iter().any(|corner| b.corners().contains(corner))
}
