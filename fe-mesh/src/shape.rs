//! Shape functions N_a(ξ) on the reference cells and their derivatives ∂N_a/∂ξ_i.
//!
//! Lines and products of lines span \[−1, 1\] in each direction, triangles and tetrahedra the unit simplex
//! (corners at the origin and at 1 on each axis). A line's coordinate is ξ₀; coordinates beyond the cell's own
//! dimension are ignored and their derivatives are zero.
//! Source: Zienkiewicz, Taylor, Zhu, The Finite Element Method, 7th ed., chapter 6.

use crate::cell::CellKind::{self, *};

/// Where a reference cell's nodes sit, `[nodes]`; empty for kinds that have no shape functions here.
pub const fn nodes(kind: CellKind) -> &'static [[f64; 3]] {
    match kind {
        Line2 => LINE.first_chunk::<2>().expect("a line has three places").as_slice(),
        Line3 => &LINE,
        Tri3 => TRIANGLE.first_chunk::<3>().expect("a triangle has six places").as_slice(),
        Tri6 => &TRIANGLE,
        Quad4 => QUADRILATERAL.first_chunk::<4>().expect("a quadrilateral has eight places").as_slice(),
        Quad8 => &QUADRILATERAL,
        Tet4 => TETRAHEDRON.first_chunk::<4>().expect("a tetrahedron has ten places").as_slice(),
        Tet10 => &TETRAHEDRON,
        Hex8 => &HEXAHEDRON,
        _ => &[],
    }
}

/// Centre of mass of the reference cell.
pub const fn centroid(kind: CellKind) -> [f64; 3] {
    match kind {
        Tri3 | Tri6 => [1.0 / 3.0, 1.0 / 3.0, 0.0],
        Tet4 | Tet10 => [0.25; 3],
        _ => [0.0; 3],
    }
}

/// Length, area or volume of the reference cell.
pub const fn measure(kind: CellKind) -> f64 {
    match kind {
        Line2 | Line3 => 2.0,
        Tri3 | Tri6 => 0.5,
        Quad4 | Quad8 => 4.0,
        Tet4 | Tet10 => 1.0 / 6.0,
        Hex8 => 8.0,
        _ => 0.0,
    }
}

const LINE: [[f64; 3]; 3] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]];

const TRIANGLE: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.0]];

const QUADRILATERAL: [[f64; 3]; 8] = [
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [-1.0, 0.0, 0.0],
];

const TETRAHEDRON: [[f64; 3]; 10] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.5, 0.0, 0.0],
    [0.5, 0.5, 0.0],
    [0.0, 0.5, 0.0],
    [0.0, 0.0, 0.5],
    [0.5, 0.0, 0.5],
    [0.0, 0.5, 0.5],
];

const HEXAHEDRON: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// The corners between which the mid nodes of a quadratic simplex lie, after the corners.
const EDGES: [(usize, usize); 6] = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)];

/// Values N_a at ξ into `out`, `[nodes]`.
///
/// # Panics
/// When [`nodes`] is empty for the kind, or `out` is shorter than it.
pub fn values(kind: CellKind, xi: &[f64; 3], out: &mut [f64]) {
    match kind {
        Line2 | Quad4 | Hex8 => product_values(kind, xi, out),
        Line3 => {
            let x = xi[0];
            out[..3].copy_from_slice(&[0.5 * x * (x - 1.0), 0.5 * x * (x + 1.0), 1.0 - x * x]);
        }
        Quad8 => {
            for (n, c) in out[..8].iter_mut().zip(&QUADRILATERAL) {
                let (p, q) = (1.0 + c[0] * xi[0], 1.0 + c[1] * xi[1]);
                *n = if c[0] == 0.0 {
                    0.5 * (1.0 - xi[0] * xi[0]) * q
                } else if c[1] == 0.0 {
                    0.5 * p * (1.0 - xi[1] * xi[1])
                } else {
                    0.25 * p * q * (p + q - 3.0)
                };
            }
        }
        Tri3 | Tet4 => {
            let l = barycentric(kind.dimension(), xi);
            out[..kind.nodes()].copy_from_slice(&l[..kind.nodes()]);
        }
        Tri6 | Tet10 => {
            let corners = kind.dimension() + 1;
            let l = barycentric(kind.dimension(), xi);
            for a in 0..corners {
                out[a] = l[a] * (2.0 * l[a] - 1.0);
            }
            for (n, &(a, b)) in out[corners..kind.nodes()].iter_mut().zip(&EDGES) {
                *n = 4.0 * l[a] * l[b];
            }
        }
        _ => panic!("{kind:?} has no shape functions"),
    }
}

/// Derivatives ∂N_a/∂ξ_i at ξ into `out`, `[nodes][3]`.
///
/// # Panics
/// When [`nodes`] is empty for the kind, or `out` is shorter than it.
pub fn gradients(kind: CellKind, xi: &[f64; 3], out: &mut [[f64; 3]]) {
    match kind {
        Line2 | Quad4 | Hex8 => product_gradients(kind, xi, out),
        Line3 => {
            let x = xi[0];
            for (g, value) in out[..3].iter_mut().zip([x - 0.5, x + 0.5, -2.0 * x]) {
                *g = [value, 0.0, 0.0];
            }
        }
        Quad8 => {
            for (g, c) in out[..8].iter_mut().zip(&QUADRILATERAL) {
                let (p, q) = (1.0 + c[0] * xi[0], 1.0 + c[1] * xi[1]);
                *g = if c[0] == 0.0 {
                    [-xi[0] * q, 0.5 * (1.0 - xi[0] * xi[0]) * c[1], 0.0]
                } else if c[1] == 0.0 {
                    [0.5 * c[0] * (1.0 - xi[1] * xi[1]), -p * xi[1], 0.0]
                } else {
                    [0.25 * c[0] * q * (2.0 * p + q - 3.0), 0.25 * c[1] * p * (p + 2.0 * q - 3.0), 0.0]
                };
            }
        }
        Tri3 | Tet4 => {
            let d = kind.dimension();
            (0..=d).for_each(|a| out[a] = barycentric_gradient(d, a));
        }
        Tri6 | Tet10 => {
            let d = kind.dimension();
            let l = barycentric(d, xi);
            for a in 0..=d {
                out[a] = barycentric_gradient(d, a).map(|g| (4.0 * l[a] - 1.0) * g);
            }
            for (g, &(a, b)) in out[d + 1..kind.nodes()].iter_mut().zip(&EDGES) {
                let (ga, gb) = (barycentric_gradient(d, a), barycentric_gradient(d, b));
                *g = std::array::from_fn(|i| 4.0 * (l[a] * gb[i] + l[b] * ga[i]));
            }
        }
        _ => panic!("{kind:?} has no shape functions"),
    }
}

/// N_a = Π_i (1 + c_ai ξ_i)/2 over the cell's directions, c_a being node a.
fn product_values(kind: CellKind, xi: &[f64; 3], out: &mut [f64]) {
    for (n, c) in out[..kind.nodes()].iter_mut().zip(nodes(kind)) {
        *n = (0..kind.dimension()).map(|i| 0.5 * (1.0 + c[i] * xi[i])).product();
    }
}

fn product_gradients(kind: CellKind, xi: &[f64; 3], out: &mut [[f64; 3]]) {
    let d = kind.dimension();
    for (g, c) in out[..kind.nodes()].iter_mut().zip(nodes(kind)) {
        *g = [0.0; 3];
        for (i, gi) in g[..d].iter_mut().enumerate() {
            *gi = (0..d).map(|j| if i == j { 0.5 * c[j] } else { 0.5 * (1.0 + c[j] * xi[j]) }).product();
        }
    }
}

/// Barycentric coordinates on the unit simplex of `dimension`.
fn barycentric(dimension: usize, xi: &[f64; 3]) -> [f64; 4] {
    let rest = 1.0 - xi[..dimension].iter().sum::<f64>();
    [rest, xi[0], xi[1], xi[2]]
}

fn barycentric_gradient(dimension: usize, a: usize) -> [f64; 3] {
    std::array::from_fn(|i| match (i < dimension, a) {
        (false, _) => 0.0,
        (true, 0) => -1.0,
        (true, a) => f64::from(a == i + 1),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const KINDS: [CellKind; 9] = [Line2, Line3, Tri3, Tri6, Quad4, Quad8, Tet4, Tet10, Hex8];
    const AT: [f64; 3] = [0.23, 0.31, 0.17];

    /// N_a is one at node a and zero at the others: exact, the nodes are dyadic numbers.
    #[test]
    fn one_at_the_own_node() {
        for kind in KINDS {
            assert_eq!(nodes(kind).len(), kind.nodes());
            for (b, xi) in nodes(kind).iter().enumerate() {
                let mut n = [0.0; 10];
                values(kind, xi, &mut n);
                (0..kind.nodes()).for_each(|a| assert_eq!(n[a], f64::from(a == b), "{kind:?} {a} {b}"));
            }
        }
    }

    /// Σ N = 1, Σ N ξ_a = ξ, Σ ∂N = 0 to round-off of ten terms.
    #[test]
    fn linear_fields_are_reproduced() {
        for kind in KINDS {
            let (mut n, mut g) = ([0.0; 10], [[0.0; 3]; 10]);
            values(kind, &AT, &mut n);
            gradients(kind, &AT, &mut g);
            assert!((n.iter().sum::<f64>() - 1.0).abs() < 1e-15);
            for (i, &at) in AT.iter().enumerate() {
                let inside = i < kind.dimension();
                let x: f64 = nodes(kind).iter().zip(&n).map(|(x, n)| x[i] * n).sum();
                assert!((x - if inside { at } else { 0.0 }).abs() < 1e-15, "{kind:?}");
                assert!(g.iter().map(|g| g[i]).sum::<f64>().abs() < 2e-15, "{kind:?}");
            }
        }
    }

    /// Central differences of cubics at most: truncation h²/6·N''' ≤ 2e-9 and round-off ε/h = 2e-12 at h = 1e-4.
    #[test]
    #[allow(clippy::needless_range_loop)]
    fn gradients_are_those_of_the_values() {
        let h = 1e-4;
        for kind in KINDS {
            let (mut plus, mut minus, mut g) = ([0.0; 10], [0.0; 10], [[0.0; 3]; 10]);
            gradients(kind, &AT, &mut g);
            for i in 0..3 {
                let at = |s: f64| std::array::from_fn(|j| AT[j] + if i == j { s } else { 0.0 });
                values(kind, &at(h), &mut plus);
                values(kind, &at(-h), &mut minus);
                for a in 0..kind.nodes() {
                    let difference = if i < kind.dimension() { (plus[a] - minus[a]) / (2.0 * h) } else { 0.0 };
                    assert!((difference - g[a][i]).abs() < 1e-8, "{kind:?} {a} {i}");
                }
            }
        }
    }
}
