//! Feature edges against each other: where ridges cross, and no node is behind a face.

use super::features::{Cone, Edge};
use super::touch::{Look, Place, Scene, Touch};
use crate::explicit::foot::DEEPEST;
use crate::facet::Vec3;
use crate::search::{Bounds, Grid};

/// Sine of the angle between two edges below which they run side by side, and nodes meet faces: 5°.
const CROSSING: f64 = 0.087_155_742_747_658_2;

/// How far the common normal of two edges may lie outside of what points out of a body [-].
const SLANT: f64 = 0.35;

/// Two edges near each other.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    first: u32,
    second: u32,
    was_outside: bool,
    /// How far things must have travelled [L] until they may touch.
    wake: f64,
}

/// Some edges with those near them.
#[derive(Clone, Debug, Default)]
pub(super) struct Edges {
    range: std::ops::Range<u32>,
    candidates: Vec<Candidate>,
    /// Of the last increment, by first edge, then second.
    pub touches: Vec<Touch>,
}

/// What touches.
pub(super) struct Closed {
    /// Edges at the beginning of the increment with how deep they were [L], ascending.
    pub crossing: Vec<([u32; 2], f64)>,
    /// Nodes with the components that they touch at its end, nodes ascending.
    pub nodes: Vec<(u32, u32)>,
}

impl Closed {
    /// True where an end of one of the edges touches the surface of the other: it holds what they would.
    fn holds(&self, one: &Edge, other: &Edge) -> bool {
        let touches = |node: u32, component: u32| {
            let first = self.nodes.partition_point(|touch| touch.0 < node);
            self.nodes[first..].iter().take_while(|touch| touch.0 == node).any(|touch| touch.1 == component)
        };
        one.nodes.iter().any(|&node| touches(node, other.component))
            || other.nodes.iter().any(|&node| touches(node, one.component))
    }
}

/// How two edges lie.
struct Crossing {
    /// Where, along each from its first node [-].
    at: [f64; 2],
    /// Distance [L] along the normal out of the second, negative where they have passed each other.
    gap: f64,
    normal: Vec3,
    /// The least distance [L] that they can have.
    distance: f64,
    /// They cross within their lengths, and the normal points out of both bodies.
    is_proper: bool,
}

impl Edges {
    pub fn new(range: std::ops::Range<u32>) -> Self {
        Edges { range, ..Edges::default() }
    }

    /// Number of pairs near each other.
    pub fn candidates(&self) -> usize {
        self.candidates.len()
    }

    /// Bytes of all of it.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.candidates[..]) + size_of_val(&self.touches[..])
    }

    /// Finds the edges that come near, in a grid of their boxes.
    pub fn search(&mut self, scene: &Scene, grid: &Grid) {
        let known = std::mem::take(&mut self.candidates);
        let edges = &scene.surface.edges;
        for first in self.range.clone() {
            let own = &edges[first as usize];
            for second in grid.meeting(&Bounds::around(&own.nodes.map(|n| scene.x(n)), 0.0)) {
                if second > first && may_touch(scene, own, &edges[second as usize]) {
                    let at = known.binary_search_by_key(&[first, second], |known| [known.first, known.second]);
                    let was_outside = at.is_ok_and(|at| known[at].was_outside);
                    self.candidates.push(Candidate { first, second, was_outside, wake: f64::NEG_INFINITY });
                }
            }
        }
    }

    /// Moves on to the end of an increment.
    pub fn advance(&mut self, scene: &Scene, closed: &Closed) {
        let before = std::mem::take(&mut self.touches);
        let edges = &scene.surface.edges;
        for candidate in &mut self.candidates {
            if scene.look == Look::Again && scene.travelled < candidate.wake {
                continue;
            }
            let ends = [candidate.first, candidate.second];
            let was = before.binary_search_by_key(&ends, |touch| [touch.first, touch.second]).ok().map(|i| &before[i]);
            let was = was.filter(|touch| touch.is_closed());
            let Some(crossing) = cross(scene, ends.map(|e| &edges[e as usize])) else {
                candidate.wake = f64::NEG_INFINITY;
                self.touches.extend(was.map(|was| was.left(scene)));
                continue;
            };
            let Crossing { gap, distance, is_proper, .. } = crossing;
            candidate.wake = scene.travelled + (distance - scene.reach).max(0.0);
            let outside = candidate.was_outside;
            candidate.was_outside = gap >= 0.0 || (is_proper && outside);
            let [one, other] = ends.map(|e| &edges[e as usize]);
            // Nothing is deep at once: where no node holds them any more, or their normal has turned over, edges have not come
            // through each other.
            let at_once = scene.deep_at_once(&row([one, other], crossing.at));
            let came = |deep: f64| gap > -deep - at_once;
            let is_behind = || (outside && came(0.0)) || neighbour(scene, ends, &closed.crossing).is_some_and(came);
            let may = is_proper && (gap >= 0.0 || is_behind()) && !closed.holds(one, other);
            if may && gap < scene.reach || was.is_some() {
                candidate.wake = f64::NEG_INFINITY;
                match was {
                    Some(was) if !may => self.touches.push(was.left(scene)),
                    _ => self.touches.extend(touch(scene, ends, was, crossing)),
                }
            }
        }
    }
}

fn may_touch(scene: &Scene, one: &Edge, other: &Edge) -> bool {
    let share = one.nodes.iter().any(|node| other.nodes.contains(node));
    let same_body = one.body.is_some() && one.body == other.body;
    let same_face = || one.faces().iter().any(|face| other.faces().contains(face));
    let moves = || scene.penalty(&one.nodes).min(scene.penalty(&other.nodes)).is_finite();
    !share && !same_body && scene.table.of_edges(one.classes, other.classes).is_some() && !same_face() && moves()
}

fn touch(scene: &Scene, ends: [u32; 2], was: Option<&Touch>, crossing: Crossing) -> Option<Touch> {
    let [one, other] = ends.map(|e| &scene.surface.edges[e as usize]);
    let acting = scene.table.of_edges(one.classes, other.classes)?;
    let row = row([one, other], crossing.at);
    let nodes = [one.nodes[0], one.nodes[1], other.nodes[0], other.nodes[1]];
    let facing = |node: u32, normal: Vec3| scene.surface.facing(node, &normal, &scene.carriers.x);
    let n = crossing.normal;
    let area = [facing(nodes[0], n), facing(nodes[1], n), facing(nodes[2], -n), facing(nodes[3], -n)];
    let area = area.into_iter().fold(f64::INFINITY, f64::min);
    let [own, opposite] = [0..2, 2..4].map(|ends| scene.penalty_at(row[ends].iter().map(|&(n, d)| (n, d.abs()))));
    let penalty = scene.table.scales[usize::from(acting.scale)] * own.min(opposite);
    let place = Place { gap: crossing.gap, normal: crossing.normal, row, measure: area, penalty };
    Some(scene.touch(ends, was, place, acting))
}

/// How far places along two edges part as their nodes move.
fn row([one, other]: [&Edge; 2], at: [f64; 2]) -> [(u32, f64); 5] {
    let [s, t] = at.map(|at| at.clamp(0.0, 1.0));
    let ([a, b], [c, d]) = (one.nodes, other.nodes);
    [(a, 1.0 - s), (b, s), (c, t - 1.0), (d, -t), (a, 0.0)]
}

/// How two edges lie; `None` where they run side by side, or none of their normals points out.
fn cross(scene: &Scene, [one, other]: [&Edge; 2]) -> Option<Crossing> {
    let ([p, q], [r, s]) = (one.nodes.map(|n| scene.x(n)), other.nodes.map(|n| scene.x(n)));
    let (along, across, between) = (q - p, s - r, p - r);
    let (a, b, e) = (along.norm_squared(), along.dot(&across), across.norm_squared());
    let denominator = a * e - b * b;
    if denominator <= CROSSING * CROSSING * a * e {
        return None;
    }
    let (c, f) = (along.dot(&between), across.dot(&between));
    let at = [(b * f - c * e) / denominator, (a * f - b * c) / denominator];
    let (faces, x) = (&scene.surface.faces, &scene.carriers.x);
    let (out, middle) = other.out(faces, x);
    let normal = along.cross(&across).normalize();
    let normal = if normal.dot(&middle) < 0.0 { -normal } else { normal };
    let (own_out, own_middle) = one.out(faces, x);
    let points_out = points_out(other, &normal, (out, middle)) && points_out(one, &-normal, (own_out, own_middle));
    let gap = (between + along * at[0] - across * at[1]).dot(&normal);
    let sine = (denominator / (a * e)).sqrt();
    let beyond = |at: f64, length: f64| (-at).max(at - 1.0).max(0.0) * length.sqrt() * sine;
    let deepest = DEEPEST * a.min(e).sqrt();
    Some(Crossing {
        at,
        gap,
        normal,
        distance: gap.abs().max(beyond(at[0], a)).max(beyond(at[1], e)),
        is_proper: points_out && gap > -deepest && at.iter().all(|at| (0.0..=1.0).contains(at)),
    })
}

/// True where a direction across an edge lies between those out of its body, or little beyond.
fn points_out(edge: &Edge, direction: &Vec3, ([first, last], middle): ([Vec3; 2], Vec3)) -> bool {
    if matches!(edge.cone, Cone::End(_)) {
        return direction.dot(&middle) > -SLANT;
    }
    let (a, b, c) = (direction.dot(&first), direction.dot(&last), first.dot(&last));
    direction.dot(&middle) > 0.0 && a - c * b > -SLANT && b - c * a > -SLANT
}

/// How deep [L] edges are, at most, that share a node with these and touch, or these themselves; `None` where none do.
fn neighbour(scene: &Scene, [first, second]: [u32; 2], closed: &[([u32; 2], f64)]) -> Option<f64> {
    let edges = &scene.surface.edges;
    let meets =
        |a: u32, b: u32| a == b || edges[a as usize].nodes.iter().any(|node| edges[b as usize].nodes.contains(node));
    let around = |[a, b]: [u32; 2]| (meets(a, first) && meets(b, second)) || (meets(a, second) && meets(b, first));
    closed.iter().filter(|touch| around(touch.0)).map(|touch| touch.1).reduce(f64::max)
}
