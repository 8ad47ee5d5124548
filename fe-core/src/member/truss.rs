//! Trusses: one strain, along the line.

use super::{Defect, Point, ROUND_OFF, along, dot, norm};
use crate::element::ElementType;
use fe_mesh::{CellKind, quadrature::Rule, shape};

/// Integration points of a cell: one of two nodes, two of three.
pub(super) fn points(element: ElementType) -> usize {
    element.kind().nodes() - 1
}

/// Nodal forces of a force per length q [F/L] over a whole truss: ∫ N_a q ds.
pub(super) fn nodal_forces(kind: CellKind, x: &[[f64; 3]], q: [f64; 3]) -> Vec<[f64; 6]> {
    let mut forces = vec![[0.0; 6]; x.len()];
    // Degree 2 of the functions and 1 of the stretch.
    for (xi, weight) in Rule::of(kind, 3).points {
        let (mut values, mut slopes) = ([0.0; 3], [[0.0; 3]; 3]);
        shape::values(kind, &xi, &mut values);
        shape::gradients(kind, &xi, &mut slopes);
        let stretch = norm(&tangent(x, &slopes));
        for (force, value) in forces.iter_mut().zip(values) {
            (0..3).for_each(|i| force[i] += weight * stretch * value * q[i]);
        }
    }
    forces
}

/// x′, from the first node, so that differences keep their digits far from the origin.
fn tangent(x: &[[f64; 3]], slopes: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|i| x.iter().zip(slopes).map(|(p, s)| s[0] * (p[i] - x[0][i])).sum())
}

/// ε = t·du/ds = x′·u′ / |x′|², ′ the derivative with ξ.
pub(super) fn integration(kind: CellKind, x: &[[f64; 3]]) -> Result<Vec<Point>, Defect> {
    let (_, length) = along(&x[0], &x[1])?;
    let degree = 2 * (x.len() - 1) - 1;
    let point = |(xi, weight): &([f64; 3], f64)| {
        let mut slopes = [[0.0; 3]; 3];
        shape::gradients(kind, xi, &mut slopes);
        let tangent = tangent(x, &slopes);
        let stretch = norm(&tangent);
        let chord: [f64; 3] = std::array::from_fn(|i| x[1][i] - x[0][i]);
        if stretch <= ROUND_OFF * length || dot(&tangent, &chord) <= 0.0 {
            return Err(Defect::Folded);
        }
        let [a, b, c] = tangent.map(|t| t / (stretch * stretch));
        let rates = slopes[..x.len()].iter().map(|s| [a * s[0], b * s[0], c * s[0], 0.0, 0.0, 0.0]).collect();
        Ok(Point { weight: weight * stretch, rates })
    };
    Rule::of(kind, degree).points.iter().map(point).collect()
}
