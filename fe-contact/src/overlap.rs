//! Where a secondary facet meets main facets: the overlap in its plane, cut into polygons, and quadrature on them.

mod flat;

use crate::facet::{Facet, Vec3};
use crate::polygon::{self, Vec2};
use crate::search::{Bounds, Grid};
use fe_mesh::quadrature::Rule;
use flat::{Flat, Plane};
use std::collections::BTreeMap;

/// Facets face each other when their normals' product is below −FACING.
pub const FACING: f64 = 0.1;

/// Polygons below this share of their facet are noise.
const NOISE: f64 = 1e-13;

/// Degree of exactness where the maps are not affine: integrands are then no polynomials, errors O(h⁹).
const CURVED: usize = 8;

/// One point of integration, on both true faces.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Local coordinates on the secondary facet.
    pub secondary: [f64; 2],
    /// Index of the main facet.
    pub main: u32,
    /// Local coordinates on the main facet.
    pub main_xi: [f64; 2],
    /// Gap [L] along the normal.
    pub gap: f64,
    /// Unit normal into the secondary.
    pub normal: Vec3,
    /// Area it stands for [L²], thickness or 2πr included.
    pub weight: f64,
}

/// What one secondary facet meets.
#[derive(Clone, Debug, Default)]
pub struct Meeting {
    /// Points of integration.
    pub samples: Vec<Sample>,
    /// Deepest overclosure [L] beyond the limit where nothing else is met, and the corner node it is at.
    pub too_deep: Option<(f64, u32)>,
    /// Main facets left out because others lie before them.
    pub hidden: usize,
}

/// Two sets of facets with all that is needed to find their overlaps.
pub struct Sides<'a> {
    /// Secondary facets.
    pub secondary: &'a [Facet],
    /// Grid of the secondary facets.
    pub secondary_grid: &'a Grid,
    /// Main facets.
    pub main: &'a [Facet],
    /// Grid of the main facets.
    pub main_grid: &'a Grid,
    /// Largest overclosure [L] that is believed.
    pub deepest: f64,
    /// Size of the scene [L].
    pub reach: f64,
    rules: Vec<Rule>,
    line_rules: Vec<Rule>,
}

/// A polygon of the overlap.
struct Piece {
    polygon: Vec<Vec2>,
    main: u32,
    patch: usize,
    gap: f64,
    /// Overclosure at the deepest corner of the secondary facet, and that corner.
    depth: (f64, u32),
}

impl<'a> Sides<'a> {
    /// Both sides.
    pub fn new(secondary: (&'a [Facet], &'a Grid), main: (&'a [Facet], &'a Grid), deepest: f64) -> Self {
        let reach = secondary.1.bounds().union(&main.1.bounds()).diagonal();
        let rules = (0..=CURVED).map(Rule::triangle).collect();
        Sides {
            secondary: secondary.0,
            secondary_grid: secondary.1,
            main: main.0,
            main_grid: main.1,
            deepest,
            reach,
            rules,
            line_rules: (0..=CURVED / 2).map(|half| Rule::line(half + 1)).collect(),
        }
    }

    /// What secondary facet `i` meets.
    pub fn meeting(&self, i: usize) -> Meeting {
        let facet = &self.secondary[i];
        let mut meeting = Meeting::default();
        for patch in facet.patches() {
            let corners: Vec<Vec3> = patch.corners().iter().map(|&c| facet.position(c)).collect();
            let Some(plane) = Plane::of(&corners) else { continue };
            let flat = Flat { facet, patch, corners: corners.iter().map(|c| plane.flat(c)).collect() };
            let bounds = Bounds::around(facet.points(), 0.0);
            let candidates = self.main_grid.swept(&bounds, &plane.normal, -self.reach, self.reach);
            let pieces = self.pieces(&plane, &flat, &candidates);
            let least = NOISE * polygon::area(&flat.corners);
            for piece in self.nearest(pieces, least, &mut meeting.hidden) {
                if piece.gap >= -self.deepest * (1.0 + 1e-9) {
                    self.integrate(&plane, &flat, &piece, &mut meeting.samples);
                } else if polygon::area(&piece.polygon) > 1e-6 * polygon::area(&flat.corners) {
                    let from = plane.point(&polygon::middle(&piece.polygon));
                    let deeper = meeting.too_deep.is_none_or(|(d, _)| piece.depth.0 > d);
                    if deeper && !self.is_no_entry(facet.nodes(), &from, &plane.normal, -piece.gap) {
                        meeting.too_deep = Some(piece.depth);
                    }
                }
            }
        }
        meeting
    }

    /// The overlaps with candidates, each by itself.
    fn pieces(&self, plane: &Plane, flat: &Flat, candidates: &[u32]) -> Vec<Piece> {
        let mut pieces = Vec::new();
        let least = NOISE * polygon::area(&flat.corners);
        for &m in candidates {
            let main = &self.main[m as usize];
            for (patch, p) in main.patches().iter().enumerate() {
                let corners: Vec<Vec3> = p.corners().iter().map(|&c| main.position(c)).collect();
                let Some(other) = Plane::of(&corners) else { continue };
                let cosine = other.normal.dot(&plane.normal);
                if cosine > -FACING {
                    continue;
                }
                let outline: Vec<Vec2> = corners.iter().rev().map(|c| plane.flat(c)).collect();
                let polygon = polygon::common(&flat.corners, &outline);
                if polygon::area(&polygon) <= least {
                    continue;
                }
                let gap_at = |x: Vec3| (other.origin - x).dot(&other.normal) / cosine;
                let gap = gap_at(plane.point(&polygon::middle(&polygon)));
                let corner_depths = (0..flat.facet.corners()).map(|c| -gap_at(flat.facet.points()[c]));
                let depth = corner_depths.zip(flat.facet.nodes().iter().copied());
                let depth = depth.max_by(|a, b| a.0.total_cmp(&b.0)).expect("a facet has corners");
                pieces.push(Piece { polygon, main: m, patch, gap, depth });
            }
        }
        pieces
    }

    /// Leaves of several layers the nearest one: those believed by distance, then those too deep.
    fn nearest(&self, mut pieces: Vec<Piece>, least: f64, hidden: &mut usize) -> Vec<Piece> {
        let layers = self.layers(&pieces);
        if layers.iter().all(|&l| l == layers[0]) {
            return pieces;
        }
        let mut order: Vec<usize> = (0..pieces.len()).collect();
        let key = |p: &Piece| (p.gap < -self.deepest * (1.0 + 1e-9), p.gap.abs());
        order.sort_by(|&a, &b| {
            let (a, b) = (key(&pieces[a]), key(&pieces[b]));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        let mut kept: Vec<(usize, Vec<Vec<Vec2>>)> = Vec::new();
        for i in order {
            let mut parts = vec![std::mem::take(&mut pieces[i].polygon)];
            for (_, before) in kept.iter().filter(|(j, _)| layers[*j] != layers[i]) {
                for b in before {
                    parts = parts.iter().flat_map(|p| polygon::without(p, b, least)).collect();
                }
            }
            *hidden += usize::from(parts.is_empty());
            kept.push((i, parts));
        }
        kept.sort_by_key(|k| k.0);
        let of = |(i, parts): (usize, Vec<Vec<Vec2>>)| {
            let Piece { main, patch, gap, depth, .. } = pieces[i];
            parts.into_iter().map(move |polygon| Piece { polygon, main, patch, gap, depth })
        };
        kept.into_iter().flat_map(of).collect()
    }

    /// The connected part of the main surface (over common nodes, among the pieces) that each piece belongs to.
    fn layers(&self, pieces: &[Piece]) -> Vec<usize> {
        let mut root: Vec<usize> = (0..pieces.len()).collect();
        fn find(root: &mut [usize], mut i: usize) -> usize {
            while root[i] != i {
                root[i] = root[root[i]];
                i = root[i];
            }
            i
        }
        let mut first = BTreeMap::new();
        for (i, piece) in pieces.iter().enumerate() {
            for &n in self.main[piece.main as usize].nodes() {
                let (a, b) = (find(&mut root, *first.entry(n).or_insert(i)), find(&mut root, i));
                root[a.max(b)] = a.min(b);
            }
        }
        (0..pieces.len()).map(|i| find(&mut root, i)).collect()
    }

    /// True when the way from a point of a secondary facet inward comes out of its own surface, or enters the main
    /// body, before it comes out of the main body at `depth`: the point is then not inside of the main body.
    /// `outward` is the facet's normal; secondary facets with one of `nodes` do not count.
    pub fn is_no_entry(&self, nodes: &[u32], from: &Vec3, outward: &Vec3, depth: f64) -> bool {
        let start = Bounds::around(&[*from], 1e-9 * self.reach);
        let crosses = |facet: &Facet, least: f64, most: f64| {
            facet
                .project(from, outward, facet.centre())
                .is_some_and(|(xi, g)| g >= least && g <= most && facet.outside(xi) <= 1e-9)
        };
        // Flush faces count as crossed first.
        let flush = 1e-6 * depth;
        let leaves = |j: u32| {
            let facet = &self.secondary[j as usize];
            facet.normal.dot(outward) < -FACING
                && !facet.nodes().iter().any(|n| nodes.contains(n))
                && crosses(facet, flush, depth + flush)
        };
        let enters = |j: u32| {
            let facet = &self.main[j as usize];
            facet.normal.dot(outward) > FACING && crosses(facet, -flush, depth - flush)
        };
        let reach = depth + 2.0 * flush;
        self.secondary_grid.swept(&start, outward, -reach, flush).into_iter().any(leaves)
            || self.main_grid.swept(&start, outward, -reach, flush).into_iter().any(enters)
    }

    /// Points of integration on a piece, taken to both true faces.
    fn integrate(&self, plane: &Plane, flat: &Flat, piece: &Piece, samples: &mut Vec<Sample>) {
        let (facet, main) = (flat.facet, &self.main[piece.main as usize]);
        let corners: Vec<Vec3> = main.patches()[piece.patch].corners().iter().map(|&c| main.position(c)).collect();
        let other = Flat {
            facet: main,
            patch: &main.patches()[piece.patch],
            corners: corners.iter().map(|c| plane.flat(c)).collect(),
        };
        for (y, area) in self.points(facet, main, &piece.polygon) {
            let (Some((xi, density)), Some((start, _))) = (flat.local(&y), other.local(&y)) else { continue };
            let x = facet.position(xi);
            let vector = facet.area_vector(xi) * (density * area);
            let Some(outward) = vector.try_normalize(0.0) else { continue };
            let normal = -outward;
            let along = main.project(&x, &normal, start).filter(|(xi, _)| main.outside(*xi) <= 0.5);
            let (main_xi, gap) = along.unwrap_or_else(|| (start, (x - main.position(start)).dot(&normal)));
            let weight = vector.norm() * facet.factor(&x);
            samples.push(Sample { secondary: xi, main: piece.main, main_xi, gap, normal, weight });
        }
    }

    /// Points of the plane and their areas: exact for hats times shape functions of either side where both are affine.
    fn points(&self, facet: &Facet, main: &Facet, polygon: &[Vec2]) -> Vec<(Vec2, f64)> {
        let hats = if facet.corners() == 4 { 2 } else { 1 };
        let radius = usize::from(facet.is_edge());
        let degree = hats + facet.degree().max(main.degree()) + radius;
        let degree = if facet.affine && main.affine { degree } else { CURVED };
        if facet.is_edge() {
            let (low, high) = polygon.iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p.x), b.max(p.x)));
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            let rule = &self.line_rules[degree / 2];
            return rule.points.iter().map(|(s, w)| (Vec2::new(middle + half * s[0], 0.0), half * w)).collect();
        }
        let rule = &self.rules[degree];
        let mut points = Vec::with_capacity(rule.points.len() * (polygon.len() - 2));
        for w in polygon[1..].windows(2) {
            let (a, b) = (w[0] - polygon[0], w[1] - polygon[0]);
            let twice = a.perp(&b);
            points.extend(rule.points.iter().map(|(s, w)| (polygon[0] + a * s[0] + b * s[1], twice * w)));
        }
        points
    }
}
