//! What facets contribute to a constraint, and how the contributions become one contact point.

use crate::facet::Vec3;
use crate::point::{ContactPoint, Measure, Slide};
use crate::tangents::{Space, tangents};
use fe_core::Freedoms;

/// A weighted part of one node's constraint; everything is an integral with the node's weight function.
#[derive(Clone, Debug)]
pub struct Share {
    /// The secondary node that carries the constraint.
    pub node: u32,
    /// ∫ψ [L²].
    pub weight: f64,
    /// ∫ψ g.
    pub gap: f64,
    /// ∫ψ n.
    pub normal: Vec3,
    /// By node.
    pub rows: Vec<Row>,
    /// ∫ψ ∂g/∂θ of a rigid main surface's reference node.
    pub turn: Vec3,
    /// −∫ψ r, r the way from that node to the secondary side: its turning moves the rigid surface there by θ × r.
    pub lever: Vec3,
}

/// What one node adds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Node.
    pub node: u32,
    /// ∫ψ ∂g/∂u.
    pub gap: Vec3,
    /// ∫ψ φ [L²] on the secondary side, −∫ψ φ on the main one: the part of its motion in the relative motion.
    pub motion: f64,
}

impl Row {
    /// A node that moves the secondary side (`weight` > 0) or the main one (< 0) where the normal is so.
    pub fn new(node: u32, normal: &Vec3, weight: f64) -> Self {
        Row { node, gap: normal * weight, motion: weight }
    }

    /// Adds what it does elsewhere.
    pub fn add(&mut self, normal: &Vec3, weight: f64) {
        self.gap += normal * weight;
        self.motion += weight;
    }
}

impl Share {
    /// Nothing yet.
    pub fn new(node: u32) -> Self {
        let zero = Vec3::zeros();
        Share { node, weight: 0.0, gap: 0.0, normal: zero, rows: Vec::new(), turn: zero, lever: zero }
    }

    /// Takes another gap [L], and where there is one another normal of a main surface of elements.
    pub fn stand(&mut self, gap: f64, normal: Option<Vec3>) {
        self.gap = gap * self.weight;
        if let Some(to) = normal {
            let from = self.normal.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
            self.rows.iter_mut().for_each(|row| row.gap = to * row.gap.dot(&from));
            self.normal = to * self.weight;
        }
    }

    /// Adds the moving rigid surface: a point of it at `arm` from the reference node moves by u + θ × arm. Of a secondary
    /// side away by a gap it is taken with it, so that what acts along the surface meets on one line.
    pub fn add_rigid(&mut self, reference: u32, normal: &Vec3, arm: &Vec3, weight: f64) {
        self.rows.push(Row::new(reference, normal, -weight));
        self.turn -= arm.cross(normal) * weight;
        self.lever -= arm * weight;
    }

    /// Sums rows of like nodes, nodes ascending, in the order in which they were added.
    pub fn compress(&mut self) {
        self.rows.sort_by_key(|r| r.node);
        self.rows.dedup_by(|next, kept| {
            let same = next.node == kept.node;
            if same {
                kept.gap += next.gap;
                kept.motion += next.motion;
            }
            same
        });
    }

    fn absorb(&mut self, other: Share) {
        self.weight += other.weight;
        self.gap += other.gap;
        self.normal += other.normal;
        self.turn += other.turn;
        self.lever += other.lever;
        self.rows.extend(other.rows);
    }

    /// The contact point: the mean with the weights. `reference`: the node that takes the turning; `slides`: something acts
    /// along the surface.
    pub fn into_point(
        self,
        measure: Measure,
        freedoms: &Freedoms,
        reference: Option<u32>,
        slides: Option<Space>,
    ) -> ContactPoint {
        let nodes = self.rows.iter().map(|row| row.node).collect();
        let row = self.over_freedoms(freedoms, reference, |row| row.gap, self.turn);
        let normal = self.normal.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let gap = self.gap / self.weight;
        let slide = slides.map(|space| {
            let directions = tangents(&normal, space);
            let along = |t: &Vec3| self.over_freedoms(freedoms, reference, |row| t * row.motion, self.lever.cross(t));
            let rows = [along(&directions[0]), if space == Space::Plane { Vec::new() } else { along(&directions[1]) }];
            Box::new(Slide { directions: directions.map(Into::into), rows })
        });
        ContactPoint { node: self.node, gap, normal: normal.into(), measure, nodes, row, round: None, slide }
    }

    /// A row over the freedoms of the nodes: `of` each one's translations, `turn` by the turning of the reference node.
    fn over_freedoms(
        &self,
        freedoms: &Freedoms,
        reference: Option<u32>,
        of: impl Fn(&Row) -> Vec3,
        turn: Vec3,
    ) -> Vec<f64> {
        let mean = 1.0 / self.weight;
        let each = |row: &Row| {
            let (d, node) = (of(row), row.node);
            freedoms.of_node(node as usize).map(move |f| match freedoms.component(f) {
                c @ 0..3 => d[c] * mean,
                c if Some(node) == reference => turn[c - 3] * mean,
                _ => 0.0,
            })
        };
        self.rows.iter().flat_map(each).collect()
    }
}

/// One share a node, nodes ascending: those of one node are added up in the order given.
pub fn merge(mut shares: Vec<Share>) -> Vec<Share> {
    shares.sort_by_key(|s| s.node);
    let mut merged: Vec<Share> = Vec::new();
    for share in shares {
        match merged.last_mut() {
            Some(last) if last.node == share.node => last.absorb(share),
            _ => merged.push(share),
        }
    }
    merged.iter_mut().for_each(Share::compress);
    merged
}
