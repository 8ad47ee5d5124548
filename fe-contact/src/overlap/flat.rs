//! Facets pressed flat into a plane, with the way back to their local coordinates.

use crate::facet::{Facet, Patch, Vec3};
use crate::polygon::Vec2;
use nalgebra::Matrix2;

/// A plane with its directions.
pub(super) struct Plane {
    pub(super) origin: Vec3,
    pub(super) normal: Vec3,
    pub(super) axes: [Vec3; 2],
}

impl Plane {
    pub(super) fn of(corners: &[Vec3]) -> Option<Self> {
        let origin = corners.iter().sum::<Vec3>() / corners.len() as f64;
        let last = corners[corners.len() - 1];
        let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]))
            + (corners[2] - corners[0]).cross(&(last - corners[0]));
        let normal = normal.try_normalize(0.0)?;
        let first = (corners[1] - corners[0]).try_normalize(0.0)?;
        let first = (first - normal * normal.dot(&first)).try_normalize(0.0)?;
        Some(Plane { origin, normal, axes: [first, normal.cross(&first)] })
    }

    pub(super) fn flat(&self, p: &Vec3) -> Vec2 {
        let r = p - self.origin;
        Vec2::new(r.dot(&self.axes[0]), r.dot(&self.axes[1]))
    }

    pub(super) fn point(&self, y: &Vec2) -> Vec3 {
        self.origin + self.axes[0] * y.x + self.axes[1] * y.y
    }
}

/// A patch pressed flat, with the way back to local coordinates.
pub(super) struct Flat<'a> {
    pub(super) facet: &'a Facet,
    pub(super) patch: &'a Patch,
    pub(super) corners: Vec<Vec2>,
}

impl Flat<'_> {
    /// Local coordinates of a point of the plane, and local area per area of the plane.
    pub(super) fn local(&self, y: &Vec2) -> Option<([f64; 2], f64)> {
        let xi: Vec<Vec2> = self.patch.corners().iter().map(|&c| Vec2::from(c)).collect();
        let (c, last) = (&self.corners, self.corners.len() - 1);
        let edges = Matrix2::from_columns(&[c[1] - c[0], c[last] - c[0]]).try_inverse()?;
        let slope = Matrix2::from_columns(&[xi[1] - xi[0], xi[last] - xi[0]]) * edges;
        let mut at = xi[0] + slope * (y - c[0]);
        if self.facet.affine || xi.len() == 3 {
            return Some((at.into(), slope.determinant().abs()));
        }
        for _ in 0..30 {
            let n = self.facet.hats(at.into());
            let r = y - c.iter().zip(n).map(|(c, n)| c * n).sum::<Vec2>();
            let jacobian = Matrix2::from_columns(&[
                (c[1] - c[0]) * (0.25 * (1.0 - at.y)) + (c[2] - c[3]) * (0.25 * (1.0 + at.y)),
                (c[3] - c[0]) * (0.25 * (1.0 - at.x)) + (c[2] - c[1]) * (0.25 * (1.0 + at.x)),
            ]);
            let step = jacobian.try_inverse()? * r;
            at += step;
            if step.norm() < 1e-14 {
                return Some((at.into(), 1.0 / jacobian.determinant().abs()));
            }
        }
        None
    }
}
