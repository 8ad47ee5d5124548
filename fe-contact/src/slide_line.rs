//! Slide lines: a chain of segments through the nodes of an outer pipe, and the point of it that is nearest to a node.
//! Smoothed, the segments are joined by curves that begin and end with their tangents: Abaqus Analysis User's Manual,
//! Slide line contact elements.

use crate::facet::Vec3;
use fe_core::Structure;

/// What the segments are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Segments {
    /// Straight, from node to node.
    Linear,
    /// Parabolas through three nodes.
    Parabolic,
}

/// A slide line as a model holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct SlideLine {
    /// Nodes in the order of the tangent; of parabolas an odd number, the ends of segments at odd places.
    pub nodes: Vec<u32>,
    /// What they are joined by.
    pub segments: Segments,
    /// Part of each segment beside a corner that a curve replaces [-], 0 for none, below 0.5.
    pub smooth: f64,
    /// How far the line goes on past its ends, of the end segment [-].
    pub extension: f64,
}

/// A point of a slide line.
#[derive(Clone, Debug, PartialEq)]
pub struct Foot {
    /// Nodes with their weights N: X = Σ N Xᵢ.
    pub weights: Vec<(u32, f64)>,
    /// Unit tangent.
    pub tangent: [f64; 3],
}

/// Nodes with their weights, polynomials Σ cₖ sᵏ.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    weights: Vec<(u32, [f64; 4])>,
    from: f64,
    to: f64,
}

/// Feet this near past an end, of the segment, are at the end [-].
const AT_END: f64 = 1e-9;
/// Parts of a bent curve in each of which one nearest point is looked for.
const PARTS: usize = 8;
/// Halvings that find a point to the last digit.
const HALVINGS: usize = 60;

impl Curve {
    fn straight(a: u32, b: u32) -> Self {
        Curve { weights: vec![(a, [1.0, -1.0, 0.0, 0.0]), (b, [0.0, 1.0, 0.0, 0.0])], from: 0.0, to: 1.0 }
    }

    fn parabola(a: u32, middle: u32, b: u32) -> Self {
        let weights = vec![(a, [1.0, -3.0, 2.0, 0.0]), (middle, [0.0, 4.0, -4.0, 0.0]), (b, [0.0, -1.0, 2.0, 0.0])];
        Curve { weights, from: 0.0, to: 1.0 }
    }

    /// From `first` at 1 − f to `second` at f, with their tangents there (Hermite's cubic; a parabola between straight
    /// segments).
    fn fillet(first: &Curve, second: &Curve, f: f64) -> Self {
        let mut weights: Vec<(u32, [f64; 4])> = Vec::new();
        let value = [[1.0, 0.0, -3.0, 2.0], [0.0, 0.0, 3.0, -2.0]];
        let slope = [[0.0, 1.0, -2.0, 1.0], [0.0, 0.0, -1.0, 1.0]];
        for (end, (curve, s)) in [(first, 1.0 - f), (second, f)].into_iter().enumerate() {
            for (node, c) in &curve.weights {
                let (n, dn) = (polynomial(c, s), 2.0 * f * derivative(c, s));
                let part: [f64; 4] = std::array::from_fn(|k| n * value[end][k] + dn * slope[end][k]);
                match weights.iter_mut().find(|w| w.0 == *node) {
                    Some(w) => (0..4).for_each(|k| w.1[k] += part[k]),
                    None => weights.push((*node, part)),
                }
            }
        }
        Curve { weights, from: 0.0, to: 1.0 }
    }

    /// X(s) − x and X′(s); `apart` gives Xᵢ − x.
    fn at(&self, s: f64, apart: &impl Fn(u32) -> Vec3) -> (Vec3, Vec3) {
        let (mut x, mut slope) = (Vec3::zeros(), Vec3::zeros());
        for (node, c) in &self.weights {
            x += apart(*node) * polynomial(c, s);
            slope += apart(*node) * derivative(c, s);
        }
        (x, slope)
    }

    /// The places where the distance is least, inside and at the ends.
    fn nearest(&self, apart: &impl Fn(u32) -> Vec3) -> Vec<f64> {
        let rise = |s: f64| {
            let (x, slope) = self.at(s, apart);
            x.dot(&slope)
        };
        let step = (self.to - self.from) / PARTS as f64;
        let mut found = vec![self.from, self.to];
        for part in 0..PARTS {
            let (mut low, mut high) = (self.from + step * part as f64, self.from + step * (part + 1) as f64);
            if rise(low) > 0.0 || rise(high) < 0.0 {
                continue;
            }
            for _ in 0..HALVINGS {
                let (at_low, at_high) = (rise(low), rise(high));
                // The secant, which is exact on straight segments, in turn with the middle.
                let secant = low - at_low * (high - low) / (at_high - at_low);
                for s in [secant, 0.5 * (low + high)] {
                    if s > low && s < high {
                        *(if rise(s) < 0.0 { &mut low } else { &mut high }) = s;
                    }
                }
            }
            found.push(if rise(low).abs() < rise(high).abs() { low } else { high });
        }
        found
    }
}

impl SlideLine {
    /// The first two neighbours at the same place: a segment without length.
    pub fn coincident(&self, structure: &Structure) -> Option<(u32, u32)> {
        let points = &structure.mesh.points;
        let same = |pair: &&[u32]| points[pair[0] as usize] == points[pair[1] as usize];
        self.nodes.windows(2).find(same).map(|pair| (pair[0], pair[1]))
    }

    /// Its pieces, one after another.
    pub(crate) fn curves(&self) -> Vec<Curve> {
        let mut segments: Vec<Curve> = match self.segments {
            Segments::Linear => self.nodes.windows(2).map(|n| Curve::straight(n[0], n[1])).collect(),
            Segments::Parabolic => {
                let triples = self.nodes.windows(3).step_by(2);
                triples.map(|n| Curve::parabola(n[0], n[1], n[2])).collect()
            }
        };
        let f = self.smooth;
        // A fillet follows from whole segments.
        let fillets: Vec<Curve> = if f == 0.0 {
            Vec::new()
        } else {
            segments.windows(2).map(|pair| Curve::fillet(&pair[0], &pair[1], f)).collect()
        };
        let last = segments.len().saturating_sub(1);
        for (k, segment) in segments.iter_mut().enumerate() {
            segment.from = if k == 0 { -self.extension } else { f };
            segment.to = if k == last { 1.0 + self.extension } else { 1.0 - f };
        }
        let mut fillets = fillets.into_iter();
        segments.into_iter().flat_map(|segment| std::iter::once(segment).chain(fillets.next())).collect()
    }

    /// Mean length [L] from node to node.
    pub fn spacing(&self, structure: &Structure) -> f64 {
        let place = |n: u32| Vec3::from(structure.mesh.points[n as usize]);
        let lengths = self.nodes.windows(2).map(|n| (place(n[1]) - place(n[0])).norm());
        lengths.sum::<f64>() / self.nodes.len().saturating_sub(1).max(1) as f64
    }
}

/// The point of a line's curves nearest to a node at the reference geometry; `None` where that lies past an end of the line.
pub(crate) fn nearest(curves: &[Curve], structure: &Structure, node: u32) -> Option<Foot> {
    let place = |n: u32| Vec3::from(structure.mesh.points[n as usize]);
    let x = place(node);
    let apart = |n: u32| place(n) - x;
    let all = curves.iter().enumerate().flat_map(|(k, curve)| curve.nearest(&apart).into_iter().map(move |s| (k, s)));
    let distance = |&(k, s): &(usize, f64)| curves[k].at(s, &apart).0.norm();
    let (k, s) = all.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    let curve = &curves[k];
    let (offset, slope) = curve.at(s, &apart);
    let rise = offset.dot(&slope) / slope.norm_squared();
    let past_start = k == 0 && s == curve.from && rise > AT_END;
    let past_end = k + 1 == curves.len() && s == curve.to && rise < -AT_END;
    if past_start || past_end {
        return None;
    }
    // At a corner the mean of both sides.
    let unit = |k: usize, s: f64| curves[k].at(s, &apart).1.normalize();
    let mut tangent = unit(k, s);
    if s == curve.to && k + 1 < curves.len() {
        tangent += unit(k + 1, curves[k + 1].from);
    } else if s == curve.from && k > 0 {
        tangent += unit(k - 1, curves[k - 1].to);
    }
    let weights = curve.weights.iter().map(|(node, c)| (*node, polynomial(c, s)));
    Some(Foot { weights: weights.filter(|w| w.1 != 0.0).collect(), tangent: tangent.normalize().into() })
}

fn polynomial(c: &[f64; 4], s: f64) -> f64 {
    ((c[3] * s + c[2]) * s + c[1]) * s + c[0]
}

fn derivative(c: &[f64; 4], s: f64) -> f64 {
    (3.0 * c[3] * s + 2.0 * c[2]) * s + c[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line through the first places, and the node at the last one.
    fn line(places: &[[f64; 3]], segments: Segments, smooth: f64) -> (Structure, SlideLine, u32) {
        let mut structure = Structure::default();
        structure.mesh.points = places.to_vec();
        let node = places.len() as u32 - 1;
        (structure, SlideLine { nodes: (0..node).collect(), segments, smooth, extension: 0.1 }, node)
    }

    fn foot(places: &[[f64; 3]], segments: Segments, smooth: f64) -> Option<(Vec3, Vec3)> {
        let (structure, line, node) = line(places, segments, smooth);
        let foot = nearest(&line.curves(), &structure, node)?;
        assert!((foot.weights.iter().map(|w| w.1).sum::<f64>() - 1.0).abs() < 1e-14);
        let place = |n: u32| Vec3::from(structure.mesh.points[n as usize]);
        Some((foot.weights.iter().map(|&(n, w)| place(n) * w).sum(), foot.tangent.into()))
    }

    fn close(found: Vec3, expected: [f64; 3], bound: f64) {
        assert!((found - Vec3::from(expected)).norm() < bound, "{found}");
    }

    const CORNER: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0]];

    #[test]
    fn straight_segments() {
        let at = |x: [f64; 3]| foot(&[&CORNER[..], &[x]].concat(), Segments::Linear, 0.0);
        let (x, t) = at([0.7, 0.3, 0.4]).unwrap();
        close(x, [0.7, 0.0, 0.0], 1e-15);
        close(t, [1.0, 0.0, 0.0], 1e-15);
        // In the extension zone, past it, and on the corner's far side.
        close(at([-0.15, 0.1, 0.0]).unwrap().0, [-0.15, 0.0, 0.0], 1e-15);
        assert!(at([-0.25, 0.1, 0.0]).is_none() && at([2.1, 2.3, 0.0]).is_none());
        let (x, t) = at([2.4, -0.1, 0.0]).unwrap();
        close(x, [2.0, 0.0, 0.0], 1e-15);
        close(t, [0.5f64.sqrt(), 0.5f64.sqrt(), 0.0], 1e-15);
    }

    /// A parabola y = x²/4: its normal at (2, 1) is along (−1, 1). The root of a cubic is found to half the digits of the
    /// distance only where it is a minimum of values; here it is the zero of a slope, found to all.
    #[test]
    fn parabolic_segments() {
        let places = [[-4.0, 4.0, 0.0], [0.0, 0.0, 0.0], [4.0, 4.0, 0.0], [1.75, 1.25, 0.5]];
        let (x, t) = foot(&places, Segments::Parabolic, 0.0).unwrap();
        close(x, [2.0, 1.0, 0.0], 1e-13);
        close(t, [0.5f64.sqrt(), 0.5f64.sqrt(), 0.0], 1e-13);
    }

    /// The corner rounded over a quarter of both segments: a parabola from (1.5, 0) to (2, 0.5) with its middle at
    /// (1.875, 0.125), where its tangent is along (1, 1); between parabolas that are straight lines it is the same.
    #[test]
    fn smoothed_corners() {
        let beside = [2.0, 0.0, 0.3];
        let middles = [[0.0; 3], [1.0, 0.0, 0.0], CORNER[1], [2.0, 1.0, 0.0], CORNER[2], beside];
        let straight = [CORNER[0], CORNER[1], CORNER[2], beside];
        for (places, segments) in [(&straight[..], Segments::Linear), (&middles[..], Segments::Parabolic)] {
            let (x, t) = foot(places, segments, 0.25).unwrap();
            close(x, [1.875, 0.125, 0.0], 1e-14);
            close(t, [0.5f64.sqrt(), 0.5f64.sqrt(), 0.0], 1e-14);
        }
    }
}
