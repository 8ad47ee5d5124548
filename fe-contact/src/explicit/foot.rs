//! The nearest point of a face.

use crate::facet::Vec3;

/// Deepest overclosure over the size of a face or edge [-]: what lies deeper belongs to another one.
pub(super) const DEEPEST: f64 = 0.5;

/// The point of a face that is nearest to a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    /// Shares of the corners [-].
    pub weights: [f64; 4],
    /// The point.
    pub place: Vec3,
    /// Distance [L], negative behind the face.
    pub gap: f64,
    /// Unit vector to the place from the point, back to front: the face's normal, past an edge that of the offset.
    pub normal: Vec3,
    /// The face's unit normal.
    pub face: Vec3,
    /// How squarely the face is seen [-]: 1 from right above.
    pub facing: f64,
    /// False past an edge.
    pub is_within: bool,
}

impl Foot {
    /// On a face of two corners (an edge of a plane model), three, of which the last stands twice, or four.
    pub fn on_face(p: &[Vec3; 4], count: u8, x: &Vec3) -> Self {
        let (weights, normal) = match count {
            2 => {
                let along = p[1] - p[0];
                let s = ((x - p[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
                ([1.0 - s, s, 0.0, 0.0], along.cross(&Vec3::z()))
            }
            3 => {
                let [a, b, c] = on_triangle(x, [p[0], p[1], p[2]]);
                ([a, b, c, 0.0], (p[1] - p[0]).cross(&(p[2] - p[0])))
            }
            _ => on_quadrilateral(x, *p),
        };
        let place: Vec3 = weights.iter().zip(p).map(|(w, p)| p * *w).sum();
        let (normal, offset) = (normal.normalize(), x - place);
        let distance = offset.norm();
        let height = offset.dot(&normal);
        let sign = if height < 0.0 { -1.0 } else { 1.0 };
        // Past an edge the direction is that of the offset, as long as it is clearly there.
        let is_within = (height.abs() - distance).abs() <= 1e-9 * (p[0] - p[1]).norm();
        let direction = if is_within { normal } else { offset * (sign / distance) };
        let facing = if distance > 0.0 { height.abs() / distance } else { 1.0 };
        let gap = sign * if is_within { height.abs() } else { distance };
        Foot { weights, place, gap, normal: direction, face: normal, facing, is_within }
    }
}

/// Barycentric weights of the point of a triangle nearest to x (Ericson, Real-Time Collision Detection, 5.1.5).
fn on_triangle(x: &Vec3, [a, b, c]: [Vec3; 3]) -> [f64; 3] {
    let (ab, ac) = (b - a, c - a);
    let dots = |p: &Vec3| (ab.dot(&(x - p)), ac.dot(&(x - p)));
    let ((d1, d2), (d3, d4), (d5, d6)) = (dots(&a), dots(&b), dots(&c));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let t = d1 / (d1 - d3);
        return [1.0 - t, t, 0.0];
    }
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let t = d2 / (d2 - d6);
        return [1.0 - t, 0.0, t];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return [0.0, 1.0 - t, t];
    }
    let sum = va + vb + vc;
    [va / sum, vb / sum, vc / sum]
}

/// Weights of the corners at the nearest point of four triangles around the mean of the corners, and the normal there.
fn on_quadrilateral(x: &Vec3, p: [Vec3; 4]) -> ([f64; 4], Vec3) {
    let middle = (p[0] + p[1] + p[2] + p[3]) * 0.25;
    let mut best = (f64::INFINITY, [0.0; 4], Vec3::zeros());
    for i in 0..4 {
        let j = (i + 1) % 4;
        let [a, b, m] = on_triangle(x, [p[i], p[j], middle]);
        let distance = (p[i] * a + p[j] * b + middle * m - x).norm_squared();
        if distance < best.0 {
            let mut weights = [0.25 * m; 4];
            weights[i] += a;
            weights[j] += b;
            best = (distance, weights, (p[j] - p[i]).cross(&(middle - p[i])));
        }
    }
    (best.1, best.2)
}
