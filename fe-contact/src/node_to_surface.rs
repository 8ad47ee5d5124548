//! Node to surface: each secondary node against its foot on the main surface. It does not pass the patch test on
//! meshes that do not match.

use crate::closest::{Closest, Found};
use crate::facet::{Facet, Rules, Vec3};
use crate::overlap::{FACING, Sides};
use crate::share::{Row, Share};
use crate::surface_to_surface::{Constraints, RigidSide};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A secondary node.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Index.
    pub node: u32,
    /// Place.
    pub x: Vec3,
    /// Unit normal of its own surface, where it has one.
    pub outward: Option<Vec3>,
    /// ∫φ over the facets around it [L²]; 1 where there are none.
    pub area: f64,
}

/// The nodes of facets, ascending, with mean normals and the integrals of their shape functions.
pub fn nodes_of(facets: &[Facet]) -> Vec<Node> {
    let rules = Rules::new(3);
    let mut found: BTreeMap<u32, Node> = BTreeMap::new();
    for facet in facets {
        for (&node, &x) in facet.nodes().iter().zip(facet.points()) {
            found.entry(node).or_insert(Node { node, x, outward: Some(Vec3::zeros()), area: 0.0 });
        }
        for &(xi, w) in rules.of(facet) {
            let xi = [xi[0], xi[1]];
            let vector = facet.area_vector(xi) * w;
            let area = vector.norm() * facet.factor(&facet.position(xi));
            for (node, value) in facet.nodes().iter().zip(facet.values(xi)) {
                found.get_mut(node).expect("the node was entered above").area += area * value;
            }
            for (node, hat) in facet.nodes().iter().zip(facet.hats(xi)) {
                let n = found.get_mut(node).expect("the node was entered above");
                n.outward = n.outward.map(|o| o + vector * hat);
            }
        }
        // Mid-side nodes have no hat; the facet's own normal stands for theirs.
        for node in &facet.nodes()[facet.corners()..] {
            let n = found.get_mut(node).expect("the node was entered above");
            n.outward = n.outward.map(|o| o + facet.normal * facet.area);
        }
    }
    let unit = |n: Node| Node { outward: n.outward.and_then(|o| o.try_normalize(0.0)), ..n };
    found.into_values().map(unit).collect()
}

/// Against deformable facets; `sides` holds them (and the secondary facets, if any).
pub fn deformable(nodes: &[Node], sides: &Sides) -> Constraints {
    let closest = Closest::new(sides.main, sides.main_grid);
    let part = |n: &Node| {
        let mut part = Constraints::default();
        match closest.foot(&n.x, n.outward.as_ref(), sides.deepest) {
            Found::Foot(foot) => {
                let facet = &sides.main[foot.facet as usize];
                let mut share = Share { weight: 1.0, gap: foot.gap, normal: foot.normal, ..Share::new(n.node) };
                share.rows.push(Row::new(n.node, &foot.normal, 1.0));
                let values = facet.values(foot.xi);
                share.rows.extend(facet.nodes().iter().zip(values).map(|(&m, v)| Row::new(m, &foot.normal, -v)));
                share.compress();
                part.shares.push(share);
            }
            Found::TooDeep(foot) => {
                let outside = -foot.normal;
                if n.outward.is_none() || !sides.is_no_entry(&[n.node], &n.x, &outside, -foot.gap) {
                    part.too_deep = Some((-foot.gap, n.node));
                }
            }
            Found::Nothing => {}
        }
        part
    };
    gather(nodes.par_iter().map(part).collect())
}

/// Against a rigid surface; `deepest` [L] is the overclosure believed.
pub fn rigid(nodes: &[Node], main: RigidSide, deepest: f64) -> Constraints {
    let part = |n: &Node| {
        let mut part = Constraints::default();
        let Some(at) = main.surface.distance(n.x.into()) else { return part };
        let normal = Vec3::from(at.normal);
        if n.outward.is_some_and(|o| o.dot(&normal) > -FACING) {
            return part;
        }
        if -at.gap > deepest * (1.0 + 1e-9) {
            part.too_deep = Some((-at.gap, n.node));
        }
        let mut share = Share { weight: 1.0, gap: at.gap, normal, ..Share::new(n.node) };
        share.rows.push(Row::new(n.node, &normal, 1.0));
        share.add_rigid(main.reference, &normal, &(n.x - main.position), 1.0);
        share.compress();
        part.shares.push(share);
        part
    };
    gather(nodes.par_iter().map(part).collect())
}

fn gather(parts: Vec<Constraints>) -> Constraints {
    let mut all = Constraints::default();
    for part in parts {
        all.deepen(part.too_deep);
        all.shares.extend(part.shares);
    }
    all
}
