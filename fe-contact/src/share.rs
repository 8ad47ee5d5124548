//! What facets contribute to a constraint, and how the contributions become one contact point.

use crate::facet::Vec3;
use crate::point::{ContactPoint, Measure};
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
    /// ∫ψ ∂g/∂u by node.
    pub rows: Vec<(u32, Vec3)>,
    /// ∫ψ ∂g/∂θ of a rigid main surface's reference node.
    pub turn: Vec3,
}

impl Share {
    /// Nothing yet.
    pub fn new(node: u32) -> Self {
        Share { node, weight: 0.0, gap: 0.0, normal: Vec3::zeros(), rows: Vec::new(), turn: Vec3::zeros() }
    }

    /// Takes another gap [L], and where there is one another normal of a main surface of elements.
    pub fn stand(&mut self, gap: f64, normal: Option<Vec3>) {
        self.gap = gap * self.weight;
        if let Some(to) = normal {
            let from = self.normal.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
            self.rows.iter_mut().for_each(|(_, d)| *d = to * d.dot(&from));
            self.normal = to * self.weight;
        }
    }

    /// Adds the moving rigid surface: a point of it at `arm` from the reference node moves by u + θ × arm.
    pub fn add_rigid(&mut self, reference: u32, normal: &Vec3, arm: &Vec3, weight: f64) {
        self.rows.push((reference, normal * -weight));
        self.turn -= arm.cross(normal) * weight;
    }

    /// Sums rows of like nodes, nodes ascending, in the order in which they were added.
    pub fn compress(&mut self) {
        self.rows.sort_by_key(|r| r.0);
        self.rows.dedup_by(|next, kept| {
            let same = next.0 == kept.0;
            if same {
                kept.1 += next.1;
            }
            same
        });
    }

    fn absorb(&mut self, other: Share) {
        self.weight += other.weight;
        self.gap += other.gap;
        self.normal += other.normal;
        self.turn += other.turn;
        self.rows.extend(other.rows);
    }

    /// The contact point: the mean with the weights. `reference`: the node that takes the turning.
    pub fn into_point(self, measure: Measure, freedoms: &Freedoms, reference: Option<u32>) -> ContactPoint {
        let mean = 1.0 / self.weight;
        let (mut nodes, mut row) = (Vec::with_capacity(self.rows.len()), Vec::new());
        for (node, d) in &self.rows {
            nodes.push(*node);
            row.extend(freedoms.of_node(*node as usize).map(|f| match freedoms.component(f) {
                c @ 0..3 => d[c] * mean,
                c if Some(*node) == reference => self.turn[c - 3] * mean,
                _ => 0.0,
            }));
        }
        let normal = self.normal.try_normalize(0.0).unwrap_or_else(Vec3::zeros);
        let gap = self.gap * mean;
        ContactPoint { node: self.node, gap, normal: normal.into(), measure, nodes, row, round: None }
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
