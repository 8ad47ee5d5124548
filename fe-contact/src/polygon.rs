//! Convex polygons in a plane: cutting one by another.

use nalgebra::Vector2;

/// A point of the plane.
pub type Vec2 = Vector2<f64>;

/// Twice signed area is positive counter-clockwise; this is the area itself [L²].
pub fn area(polygon: &[Vec2]) -> f64 {
    let Some(&a) = polygon.first() else { return 0.0 };
    polygon.windows(2).map(|w| 0.5 * (w[0] - a).perp(&(w[1] - a))).sum()
}

/// Mean of the corners.
pub fn middle(polygon: &[Vec2]) -> Vec2 {
    polygon.iter().sum::<Vec2>() / polygon.len().max(1) as f64
}

/// The part of a convex polygon on the left (`side` = 1) or right (−1) of the line from a to b.
fn half(polygon: &[Vec2], a: Vec2, b: Vec2, side: f64) -> Vec<Vec2> {
    let mut out = Vec::with_capacity(polygon.len() + 1);
    let height = |p: &Vec2| side * (b - a).perp(&(p - a));
    for (i, p) in polygon.iter().enumerate() {
        let q = &polygon[(i + 1) % polygon.len()];
        let (hp, hq) = (height(p), height(q));
        if hp >= 0.0 {
            out.push(*p);
        }
        if (hp > 0.0 && hq < 0.0) || (hp < 0.0 && hq > 0.0) {
            out.push(p + (q - p) * (hp / (hp - hq)));
        }
    }
    out
}

/// The common part of two convex polygons, both counter-clockwise (Sutherland and Hodgman, CACM 17 (1974) 32).
pub fn common(polygon: &[Vec2], other: &[Vec2]) -> Vec<Vec2> {
    let mut rest = polygon.to_vec();
    for (i, &a) in other.iter().enumerate() {
        if rest.len() < 3 {
            return Vec::new();
        }
        rest = half(&rest, a, other[(i + 1) % other.len()], 1.0);
    }
    if rest.len() < 3 { Vec::new() } else { rest }
}

/// What is left of a convex polygon without another, in convex parts, each of more than `least` area.
pub fn without(polygon: &[Vec2], other: &[Vec2], least: f64) -> Vec<Vec<Vec2>> {
    if area(&common(polygon, other)) <= least {
        return vec![polygon.to_vec()];
    }
    let (mut rest, mut parts) = (polygon.to_vec(), Vec::new());
    for (i, &a) in other.iter().enumerate() {
        let b = other[(i + 1) % other.len()];
        let outside = half(&rest, a, b, -1.0);
        if area(&outside) > least {
            parts.push(outside);
        }
        rest = half(&rest, a, b, 1.0);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, edge: f64) -> Vec<Vec2> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(a, b)| Vec2::new(x + edge * a, y + edge * b)).to_vec()
    }

    #[test]
    fn common_part_and_rest_make_the_whole() {
        let a = square(0.0, 0.0, 2.0);
        for (other, expected) in [
            (square(1.0, 1.0, 2.0), 1.0),
            (square(0.5, 0.5, 1.0), 1.0),
            (square(-1.0, -1.0, 5.0), 4.0),
            (square(2.0, 0.0, 1.0), 0.0),
            (vec![Vec2::new(0.0, -1.0), Vec2::new(3.0, 2.0), Vec2::new(0.0, 2.0)], 3.5),
        ] {
            let overlap = area(&common(&a, &other));
            let rest: f64 = without(&a, &other, 1e-13).iter().map(|p| area(p)).sum();
            // Sums of at most ten products of numbers below 10.
            assert!((overlap - expected).abs() < 1e-14 && (overlap + rest - 4.0).abs() < 1e-14, "{other:?}");
        }
    }
}
