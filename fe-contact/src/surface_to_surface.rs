//! Surface to surface: the gap averaged over the secondary surface around each corner node,
//! g_s = (1/A_s) ∫ψ_s (x_secondary − x_main)·n dΓ, A_s = ∫ψ_s dΓ over the overlap, ψ_s the hat function of the
//! corner. The hats add up to one, so that a constant pressure is passed on exactly.

use crate::facet::{Facet, Vec3};
use crate::overlap::{FACING, Sides};
use crate::rigid::RigidSurface;
use crate::share::{Row, Share, merge};
use fe_mesh::quadrature::Rule;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Overlaps below this share of the surface around a node make no constraint.
const NEGLIGIBLE: f64 = 1e-8;

/// The constraints that a way of meeting gives.
#[derive(Debug, Default)]
pub struct Constraints {
    /// One a node, ascending; [`Share::weight`] is its area.
    pub shares: Vec<Share>,
    /// Deepest node beyond the limit: overclosure [L] and node.
    pub too_deep: Option<(f64, u32)>,
    /// Main facets left out because others lie before them.
    pub hidden: usize,
}

impl Constraints {
    /// Keeps the deeper of two.
    pub fn deepen(&mut self, other: Option<(f64, u32)>) {
        if let Some((depth, _)) = other
            && self.too_deep.is_none_or(|(d, _)| depth > d)
        {
            self.too_deep = other;
        }
    }

    fn gather(parts: Vec<Constraints>, facets: &[Facet]) -> Self {
        let mut all = Constraints::default();
        for part in parts {
            all.deepen(part.too_deep);
            all.hidden += part.hidden;
            all.shares.extend(part.shares);
        }
        let around = areas_around(facets);
        all.shares = merge(all.shares);
        all.shares.retain(|s| s.weight > NEGLIGIBLE * around[&s.node]);
        all
    }
}

/// About the area around each corner node, in equal parts of its facets.
fn areas_around(facets: &[Facet]) -> BTreeMap<u32, f64> {
    let mut around = BTreeMap::new();
    for f in facets {
        let part = f.area * f.factor(&f.position(f.centre())) / f.corners() as f64;
        f.nodes()[..f.corners()].iter().for_each(|&n| *around.entry(n).or_insert(0.0) += part);
    }
    around
}

/// Against deformable facets.
pub fn deformable(sides: &Sides) -> Constraints {
    let part = |i| {
        let facet = &sides.secondary[i];
        let meeting = sides.meeting(i);
        let corners = facet.corners();
        let mut shares: Vec<Share> = facet.nodes()[..corners].iter().map(|&n| Share::new(n)).collect();
        let none = |node| [Row::new(node, &Vec3::zeros(), 0.0); 4];
        let mut secondary: Vec<[Row; 4]> = facet.nodes().iter().map(|&n| none(n)).collect();
        let mut main: BTreeMap<u32, [Row; 4]> = BTreeMap::new();
        for s in &meeting.samples {
            let (hats, values) = (facet.hats(s.secondary), facet.values(s.secondary));
            let opposite = &sides.main[s.main as usize];
            let main_values = opposite.values(s.main_xi);
            for c in 0..corners {
                let weight = s.weight * hats[c];
                shares[c].weight += weight;
                shares[c].gap += weight * s.gap;
                shares[c].normal += s.normal * weight;
                for (row, value) in secondary.iter_mut().zip(values) {
                    row[c].add(&s.normal, weight * value);
                }
            }
            for (&n, value) in opposite.nodes().iter().zip(main_values) {
                let row = main.entry(n).or_insert_with(|| none(n));
                for c in 0..corners {
                    row[c].add(&s.normal, -(s.weight * hats[c] * value));
                }
            }
        }
        for (c, share) in shares.iter_mut().enumerate() {
            share.rows = secondary.iter().chain(main.values()).map(|row| row[c]).collect();
        }
        shares.retain(|s| s.weight > 0.0);
        Constraints { shares, too_deep: meeting.too_deep, hidden: meeting.hidden }
    };
    Constraints::gather((0..sides.secondary.len()).into_par_iter().map(part).collect(), sides.secondary)
}

/// A rigid surface and the node that moves it.
#[derive(Clone, Copy)]
pub struct RigidSide<'a> {
    /// Shape.
    pub surface: &'a RigidSurface,
    /// Reference node.
    pub reference: u32,
    /// Where that is.
    pub position: Vec3,
}

/// Against a rigid surface: n is its normal at the closest point; `deepest` [L] is the overclosure believed.
pub fn rigid(facets: &[Facet], main: RigidSide, deepest: f64) -> Constraints {
    let part = |facet: &Facet| {
        let mut part = Constraints::default();
        let corners = facet.corners();
        let mut shares: Vec<Share> = facet.nodes()[..corners].iter().map(|&n| Share::new(n)).collect();
        let degree = if facet.affine { 2 + 2 * facet.degree() } else { 8 };
        for (xi, w) in Rule::of(facet.kind, degree).points {
            let xi = [xi[0], xi[1]];
            let (x, vector) = (facet.position(xi), facet.area_vector(xi) * w);
            let Some(at) = main.surface.distance(x.into()) else { continue };
            let normal = Vec3::from(at.normal);
            if normal.dot(&vector) > -FACING * vector.norm() {
                continue;
            }
            let (hats, values) = (facet.hats(xi), facet.values(xi));
            if -at.gap > deepest * (1.0 + 1e-9) {
                let nearest = (0..corners).max_by(|&a, &b| hats[a].total_cmp(&hats[b])).unwrap_or(0);
                part.deepen(Some((-at.gap, facet.nodes()[nearest])));
            }
            let arm = x - main.position;
            let area = vector.norm() * facet.factor(&x);
            for (share, hat) in shares.iter_mut().zip(hats) {
                let weight = area * hat;
                share.weight += weight;
                share.gap += weight * at.gap;
                share.normal += normal * weight;
                share.rows.extend(facet.nodes().iter().zip(values).map(|(&n, v)| Row::new(n, &normal, weight * v)));
                share.add_rigid(main.reference, &normal, &arm, weight);
            }
        }
        shares.retain(|s| s.weight > 0.0);
        shares.iter_mut().for_each(Share::compress);
        part.shares = shares;
        part
    };
    Constraints::gather(facets.par_iter().map(part).collect(), facets)
}
