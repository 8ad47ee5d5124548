//! The two directions along a surface.

use crate::facet::Vec3;

/// Whether surfaces slide in a plane or in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Space {
    /// Plane and axisymmetric models: along one direction.
    Plane,
    /// Along two.
    Solid,
    /// Along two, of which the first goes along a line of this unit direction.
    Led(Vec3),
}

/// Below this angle to x [rad], 0.1°, the projection of x on the surface is that of z instead.
const NEAR: f64 = 0.1 * std::f64::consts::PI / 180.0;

/// t₁, t₂ across a unit normal: in a plane t₁ = e_z × n; in space t₁ the projection of the line's direction, or where there
/// is none or the line stands nearly along the normal of global x, of z where the normal is nearly along x; t₂ = n × t₁
/// (Abaqus Analysis User's Manual, Conventions).
pub fn tangents(normal: &Vec3, space: Space) -> [Vec3; 2] {
    let lies = |direction: &Vec3| normal.cross(direction).norm() > NEAR.sin();
    let wanted = match space {
        Space::Plane => Vec3::z().cross(normal),
        Space::Led(line) if lies(&line) => line,
        Space::Solid | Space::Led(_) if lies(&Vec3::x()) => Vec3::x(),
        Space::Solid | Space::Led(_) => Vec3::z(),
    };
    let second = normal.cross(&wanted).try_normalize(0.0).unwrap_or_else(Vec3::zeros);
    [second.cross(normal), second]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conventions() {
        let of = |n: [f64; 3], space| tangents(&Vec3::from(n), space).map(|t| [t.x, t.y, t.z]);
        assert_eq!(of([0.0, 0.0, 1.0], Space::Solid), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(of([-1.0, 0.0, 0.0], Space::Solid), [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
        assert_eq!(of([0.0, 1.0, 0.0], Space::Plane)[0], [-1.0, 0.0, 0.0]);
        let led = Space::Led(Vec3::new(0.0, 0.6, 0.8));
        assert_eq!(of([0.0, 0.0, 1.0], led), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]);
        let along = Vec3::new(0.0, 0.6, 0.8);
        assert_eq!(tangents(&along, led), tangents(&along, Space::Solid));
        for degrees in [0.05f64, 0.2, 30.0] {
            let angle = degrees.to_radians();
            let n = Vec3::new(angle.cos(), angle.sin(), 0.0);
            let [a, b] = tangents(&n, Space::Solid);
            assert!(a.dot(&n).abs() < 1e-15 && b.dot(&n).abs() < 1e-15 && (a.cross(&b) - n).norm() < 1e-14);
            assert_eq!(a.z.abs() > 0.5, degrees < 0.1);
        }
    }
}
