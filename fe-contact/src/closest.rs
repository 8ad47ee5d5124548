//! The point of the main facets whose normal passes through a given point. Normals are interpolated between the
//! corners, each the mean over the neighbouring facets within a feature angle: smooth surfaces get continuous
//! normals, sharp edges stay sharp.

use crate::facet::{Facet, MOST, Vec3};
use crate::overlap::FACING;
use crate::search::{Bounds, Grid};
use fe_mesh::{CellKind, shape};
use nalgebra::Matrix3;
use std::collections::BTreeMap;

/// Cosine of the feature angle of 30°: facets that meet at a greater angle meet at a sharp edge.
const FEATURE_COSINE: f64 = 0.866_025_403_784_438_6;

/// How far facets reach past the perimeter of their surface, of their size [-]: `EXTENSION ZONE`'s default.
pub const EXTENSION: f64 = 0.1;

/// Local coordinates this near to an edge lie on it [-]; gaps this near, of the facet's size, are equal.
const SAME: f64 = 1e-9;

/// A point of a main facet.
#[derive(Clone, Copy, Debug)]
pub struct Foot {
    /// Index of the facet.
    pub facet: u32,
    /// Local coordinates.
    pub xi: [f64; 2],
    /// Gap [L] along the normal.
    pub gap: f64,
    /// Unit normal.
    pub normal: Vec3,
    /// How far past the facet's edges, of its size [-].
    outside: f64,
}

/// What is found for a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found<T> {
    /// The foot to use.
    Foot(T),
    /// All feet are deeper than what is believed; the nearest one.
    TooDeep(T),
    /// The point faces no facet.
    Nothing,
}

/// Facets with the normals of their corners.
#[derive(Debug)]
pub struct Closest<'a> {
    facets: &'a [Facet],
    grid: &'a Grid,
    normals: Vec<[Vec3; 4]>,
    largest: f64,
}

impl<'a> Closest<'a> {
    /// Of facets in a grid.
    pub fn new(facets: &'a [Facet], grid: &'a Grid) -> Self {
        let mut around: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (i, f) in facets.iter().enumerate() {
            f.nodes()[..f.corners()].iter().for_each(|&n| around.entry(n).or_default().push(i as u32));
        }
        let normals = facets.iter().map(|f| corner_normals(facets, &around, f)).collect();
        let largest = facets.iter().map(|f| Bounds::around(f.points(), 0.0).diagonal()).fold(0.0, f64::max);
        Closest { facets, grid, normals, largest }
    }

    /// The foot of a point, the same for any order of the facets. `outward` is the normal of the point's own
    /// surface, where it has one: only facets that face it count. `deepest` [L]: the overclosure believed.
    pub fn foot(&self, x: &Vec3, outward: Option<&Vec3>, deepest: f64) -> Found<Foot> {
        let farthest = self.grid.bounds().union(&Bounds::around(&[*x], 0.0)).diagonal() + self.largest;
        let mut radius = self.largest;
        loop {
            let near = self.grid.meeting(&Bounds::around(&[*x], radius));
            let feet: Vec<Foot> = near.iter().filter_map(|&f| self.on_facet(f, x)).collect();
            let facing = |f: &&Foot| outward.is_none_or(|n| n.dot(&f.normal) < -FACING);
            let believed = feet.iter().filter(facing).filter(|f| f.gap >= -deepest * (1.0 + 1e-9));
            let best = believed.copied().reduce(|a, b| if self.better(&b, &a, outward) { b } else { a });
            if let Some(best) = best
                && best.gap.abs() <= radius
            {
                return Found::Foot(best);
            }
            if radius > farthest {
                let nearest = feet.iter().filter(facing).copied().min_by(|a, b| a.gap.abs().total_cmp(&b.gap.abs()));
                return nearest.map_or(Found::Nothing, Found::TooDeep);
            }
            radius *= 2.0;
        }
    }

    /// Inside before past an edge, near before far, facing before oblique, then by node numbers.
    fn better(&self, a: &Foot, b: &Foot, outward: Option<&Vec3>) -> bool {
        let (inside_a, inside_b) = (a.outside <= SAME, b.outside <= SAME);
        if inside_a != inside_b {
            return inside_a;
        }
        let (fa, fb) = (&self.facets[a.facet as usize], &self.facets[b.facet as usize]);
        let (near_a, near_b) = (a.gap.abs(), b.gap.abs());
        if (near_a - near_b).abs() > SAME * fa.size().max(fb.size()) {
            return near_a < near_b;
        }
        let cosines = outward.map_or((0.0, 0.0), |n| (n.dot(&a.normal), n.dot(&b.normal)));
        if (cosines.0 - cosines.1).abs() > SAME {
            return cosines.0 < cosines.1;
        }
        sorted(fa.nodes()) < sorted(fb.nodes())
    }

    /// x = x(ξ) + g N(ξ) on one facet, by Newton's method; `None` where that is off the facet.
    fn on_facet(&self, index: u32, x: &Vec3) -> Option<Foot> {
        let facet = &self.facets[index as usize];
        let r = x - facet.position(facet.centre());
        let height = r.dot(&facet.normal);
        // The normals of a facet lie within the feature angle of its own: what is further aside has no foot on it.
        if (r - facet.normal * height).norm() > 1.5 * self.largest + 0.6 * height.abs() {
            return None;
        }
        let (mut xi, mut g) = (facet.centre(), height);
        let tolerance = 4e-16 * (facet.size() + r.norm());
        let mut last = f64::INFINITY;
        for _ in 0..25 {
            let (n, slopes) = self.normal(index, xi);
            let error = x - facet.position(xi) - n * g;
            let size = error.norm();
            if size <= tolerance || (size < 1e4 * tolerance && size >= 0.5 * last) {
                let outside = facet.outside(xi);
                let (gap, normal) = (g * n.norm(), n.normalize());
                return (outside <= EXTENSION).then_some(Foot { facet: index, xi, gap, normal, outside });
            }
            last = size;
            let [a, b] = facet.tangents(xi);
            let step = Matrix3::from_columns(&[a + slopes[0] * g, b + slopes[1] * g, n]).lu().solve(&error)?;
            xi = [xi[0] + step.x, xi[1] + step.y];
            g += step.z;
            if !(xi[0].abs() < 1e3 && xi[1].abs() < 1e3) {
                return None;
            }
        }
        None
    }

    /// The interpolated normal, not of unit length, and its derivatives.
    fn normal(&self, index: u32, xi: [f64; 2]) -> (Vec3, [Vec3; 2]) {
        let facet = &self.facets[index as usize];
        let kind =
            [CellKind::Point1, CellKind::Point1, CellKind::Line2, CellKind::Tri3, CellKind::Quad4][facet.corners()];
        let mut gradients = [[0.0; 3]; MOST];
        shape::gradients(kind, &[xi[0], xi[1], 0.0], &mut gradients);
        let (mut n, mut slopes) = (Vec3::zeros(), [Vec3::zeros(); 2]);
        for ((corner, value), g) in self.normals[index as usize].iter().zip(facet.hats(xi)).zip(gradients) {
            n += corner * value;
            slopes[0] += corner * g[0];
            slopes[1] += corner * g[1];
        }
        (n, slopes)
    }
}

/// Unit normals of a facet's corners, means weighted by area over the facets that meet smoothly.
fn corner_normals(facets: &[Facet], around: &BTreeMap<u32, Vec<u32>>, facet: &Facet) -> [Vec3; 4] {
    let mut out = [Vec3::zeros(); 4];
    for (n, node) in out.iter_mut().zip(&facet.nodes()[..facet.corners()]) {
        let smooth = around[node].iter().map(|&j| &facets[j as usize]);
        let smooth = smooth.filter(|f| f.normal.dot(&facet.normal) >= FEATURE_COSINE);
        *n = smooth.map(|f| f.normal * f.area).sum::<Vec3>().try_normalize(0.0).unwrap_or(facet.normal);
    }
    out
}

fn sorted(nodes: &[u32]) -> Vec<u32> {
    let mut nodes = nodes.to_vec();
    nodes.sort_unstable();
    nodes
}
