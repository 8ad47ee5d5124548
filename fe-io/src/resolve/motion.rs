//! Where an instance puts its part.

use super::rigid::unit;

/// Moved, then turned about an axis.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// Translation [L].
    pub translation: [f64; 3],
    /// The turn after it.
    pub rotation: Option<Rotation>,
}

/// A turn about an axis.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// A point of the axis [L].
    point: [f64; 3],
    /// Orthogonal, determinant 1.
    matrix: [[f64; 3]; 3],
}

impl Rotation {
    /// About the axis from `a` to `b` by an angle in degrees, right-handed; `None` where a and b are one.
    /// Quarter turns are exact: plane parts stay plane, faces on planes of coordinates stay on such.
    pub fn new(a: [f64; 3], b: [f64; 3], degrees: f64) -> Option<Self> {
        let k = unit([b[0] - a[0], b[1] - a[1], b[2] - a[2]])?;
        let (sin, cos) = match degrees.rem_euclid(360.0) {
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            other => other.to_radians().sin_cos(),
        };
        // Rodrigues: R = cos 1 + sin [k]× + (1 − cos) k kᵀ.
        let cross = [[0.0, -k[2], k[1]], [k[2], 0.0, -k[0]], [-k[1], k[0], 0.0]];
        let entry = |i: usize, j: usize| {
            let one = if i == j { 1.0 } else { 0.0 };
            cos * one + sin * cross[i][j] + (1.0 - cos) * k[i] * k[j]
        };
        Some(Rotation { point: a, matrix: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))) })
    }
}

impl Motion {
    /// Where a point of the part comes to lie [L].
    pub fn point(&self, at: [f64; 3]) -> [f64; 3] {
        let moved: [f64; 3] = std::array::from_fn(|c| at[c] + self.translation[c]);
        let Some(Rotation { point, .. }) = self.rotation else { return moved };
        let turned = self.direction(std::array::from_fn(|c| moved[c] - point[c]));
        std::array::from_fn(|c| turned[c] + point[c])
    }

    /// True when a plane part stays in its plane, seen from the same side.
    pub fn keeps_plane(&self) -> bool {
        // Cosine of the angle between the axes z: rounding apart, 1.
        self.direction([0.0, 0.0, 1.0])[2] > 1.0 - 8.0 * f64::EPSILON && self.point([0.0; 3])[2] == 0.0
    }

    /// Where a point of a plane part comes to lie [L].
    pub fn in_plane(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y, _] = self.point([x, y, 0.0]);
        [x, y]
    }

    /// How a direction of the part comes to point.
    pub fn direction(&self, v: [f64; 3]) -> [f64; 3] {
        let Some(Rotation { matrix, .. }) = &self.rotation else { return v };
        matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter turn about an axis off the origin, worked by hand: (3, 0, 1) moves to (3, 1, 1), which lies at
    /// (1, 1, 0) from the point (2, 0, 1) of the axis z and turns to (−1, 1, 0) from it.
    #[test]
    fn a_point_is_moved_then_turned() {
        let rotation = Rotation::new([2.0, 0.0, 1.0], [2.0, 0.0, 5.0], 90.0);
        let motion = Motion { translation: [0.0, 1.0, 0.0], rotation };
        assert_eq!(motion.point([3.0, 0.0, 1.0]), [1.0, 1.0, 1.0]);
        assert_eq!(motion.direction([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    }

    /// Three turns of 120° about (1, 1, 1) are none, each turns x to y, y to z, z to x: to rounding.
    #[test]
    fn a_third_of_a_turn_about_a_diagonal_swaps_the_axes() {
        let rotation = Rotation::new([0.0; 3], [1.0, 1.0, 1.0], 120.0);
        let motion = Motion { translation: [0.0; 3], rotation };
        let turned = motion.point([1.0, 2.0, 3.0]);
        let expected = [3.0, 1.0, 2.0];
        assert!((0..3).all(|c| (turned[c] - expected[c]).abs() < 8.0 * f64::EPSILON), "{turned:?}");
        assert!(Rotation::new([1.0; 3], [1.0; 3], 90.0).is_none());
    }
}
