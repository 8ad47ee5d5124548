//! Beams in space; those in the plane are the same with the freedoms of the plane.
//!
//! Axes: t along the line, 1 across it, 2 = t × 1. Strains: ε₀, κ₁ = θ₁′ and κ₂ = θ₂′ (curvatures about axes 1 and 2),
//! φ = θₜ′, γ₁ = u₁′ − θ₂, γ₂ = u₂′ + θ₁; ′ the derivative along the line. The fibre at (x₁, x₂) has ε₀ + x₂ κ₁ − x₁ κ₂.

use super::{Defect, Point, ROUND_OFF, along, cross, norm};
use crate::element::ElementType::{self, B23, B33};
use crate::structure::LineSection;

/// Strains at a point.
const STRAINS: usize = 6;

/// Slender beams, cubic across their line.
pub(super) fn is_slender(element: ElementType) -> bool {
    matches!(element, B23 | B33)
}

/// Integration points of a cell: the curvatures of a cubic are linear, two points integrate them; one point keeps the
/// linear beam from locking.
pub(super) fn points(element: ElementType) -> usize {
    if is_slender(element) { 2 } else { 1 }
}

/// D of the strains.
pub(crate) fn moduli(section: &LineSection) -> Vec<f64> {
    let (e, g, p) = (section.young, section.shear, &section.profile);
    let shear = p.shear_factor * g * p.area;
    let mut d = vec![0.0; STRAINS * STRAINS];
    let diagonal = [e * p.area, e * p.i11, e * p.i22, g * p.torsion, shear, shear];
    diagonal.into_iter().enumerate().for_each(|(i, modulus)| d[i * STRAINS + i] = modulus);
    d[STRAINS + 2] = -e * p.i12;
    d[2 * STRAINS + 1] = -e * p.i12;
    d
}

/// Unit axes t, 1, 2 of a beam, and its length [L].
pub(crate) fn axes(x: [[f64; 3]; 2], first_axis: [f64; 3]) -> Result<([[f64; 3]; 3], f64), Defect> {
    let (t, length) = along(&x[0], &x[1])?;
    let across = cross(&t, &first_axis);
    let size = norm(&across);
    // An angle of less than 1e-6 leaves no direction that means something.
    if size <= 1e6 * ROUND_OFF * norm(&first_axis) {
        return Err(Defect::AlongFirstAxis);
    }
    let second = across.map(|a| a / size);
    Ok(([t, cross(&second, &t), second], length))
}

/// Rates of the strains at the integration points.
pub(super) fn integration(element: ElementType, x: [[f64; 3]; 2], first_axis: [f64; 3]) -> Result<Vec<Point>, Defect> {
    let (axes, length) = axes(x, first_axis)?;
    let places: &[f64] = if is_slender(element) { &[-1.0, 1.0] } else { &[0.0] };
    let point = |sign: &f64| {
        let xi = sign / 3f64.sqrt();
        let local = if is_slender(element) { slender(xi, length) } else { flexible(length) };
        let weight = length / places.len() as f64;
        Point { weight, rates: local.iter().map(|rates| in_space(rates, &axes)).collect() }
    };
    Ok(places.iter().map(point).collect())
}

/// Rates with the freedoms along t, 1, 2 and about them, carried to x, y, z.
fn in_space(local: &[f64; 6], axes: &[[f64; 3]; 3]) -> [f64; 6] {
    std::array::from_fn(|c| {
        let (part, i) = (c / 3 * 3, c % 3);
        (0..3).map(|k| local[part + k] * axes[k][i]).sum()
    })
}

/// Rates of a linear beam at its middle, `[strains × nodes]`.
fn flexible(length: f64) -> Vec<[f64; 6]> {
    let s = 1.0 / length;
    let mut rates = Vec::with_capacity(2 * STRAINS);
    for (strain, place) in [0, 4, 5, 3, 1, 2].into_iter().enumerate() {
        for sign in [-1.0, 1.0] {
            let mut rate = [0.0; 6];
            rate[place] = sign * s;
            match strain {
                4 => rate[5] = -0.5,
                5 => rate[4] = 0.5,
                _ => {}
            }
            rates.push(rate);
        }
    }
    rates
}

/// Rates of a cubic beam at ξ ∈ [−1, 1], `[strains × nodes]`: with Hermite's functions u₁″ = κ₂ of u₁ and its slope θ₂,
/// and u₂″ = −κ₁ of u₂ and its slope −θ₁. No shear.
fn slender(xi: f64, length: f64) -> Vec<[f64; 6]> {
    let s = 1.0 / length;
    let mut rates = vec![[0.0; 6]; 2 * STRAINS];
    for (node, sign) in [-1.0, 1.0].into_iter().enumerate() {
        let deflection = -sign * 6.0 * xi * s * s;
        let slope = (3.0 * xi + sign) * s;
        rates[node][0] = sign * s;
        rates[6 + node][3] = sign * s;
        (rates[4 + node][1], rates[4 + node][5]) = (deflection, slope);
        (rates[2 + node][2], rates[2 + node][4]) = (-deflection, slope);
    }
    rates
}

/// Nodal forces and moments, x, y, z each, of a force per length q [F/L] over a whole beam: the work of q on the
/// displacements. The moments of a cubic beam are ± L²/12 t × q (Przemieniecki, Theory of Matrix Structural Analysis,
/// table 11.1).
pub(super) fn nodal_forces(element: ElementType, x: [[f64; 3]; 2], q: [f64; 3]) -> Result<Vec<[f64; 6]>, Defect> {
    let (t, length) = along(&x[0], &x[1])?;
    let moment = if is_slender(element) { length * length / 12.0 } else { 0.0 };
    let turn = cross(&t, &q).map(|m| moment * m);
    let force = q.map(|q| 0.5 * length * q);
    Ok([1.0, -1.0].map(|sign| std::array::from_fn(|c| if c < 3 { force[c] } else { sign * turn[c - 3] })).to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_a_right_handed_frame() {
        let ([t, one, two], length) = axes([[1.0, 0.0, 0.0], [1.0, 2.0, 0.0]], [3.0, 4.0, 0.0]).unwrap();
        assert_eq!((t, length), ([0.0, 1.0, 0.0], 2.0));
        assert_eq!((one, two), ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0]));
        assert!(crate::member::dot(&one, &two) == 0.0);
        assert_eq!(axes([[0.0; 3], [0.0, 1.0, 0.0]], [0.0, -5.0, 0.0]), Err(Defect::AlongFirstAxis));
        assert_eq!(axes([[1.0; 3], [1.0; 3]], [0.0, -5.0, 0.0]), Err(Defect::NoLength));
    }
}
