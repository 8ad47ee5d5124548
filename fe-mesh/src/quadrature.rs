//! Quadrature rules on the reference cells: all weights positive, all points inside.
//!
//! Symmetric rules of triangles: Dunavant, Int. J. Numer. Meth. Eng. 21 (1985) 1129, numbers recomputed by
//! Newton's method on the moment equations.

use crate::cell::CellKind;

/// Points ξ and weights; the weights add up to the measure of the reference cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// (ξ, weight).
    pub points: Vec<([f64; 3], f64)>,
}

impl Rule {
    /// Gauss points of \[−1, 1\], ascending; exact to degree 2 `count` − 1.
    pub fn line(count: usize) -> Self {
        Rule { points: gauss(count).into_iter().map(|(x, w)| ([x, 0.0, 0.0], w)).collect() }
    }

    /// `count`² Gauss points on the square [−1, 1]², ξ₀ running fastest.
    pub fn quadrilateral(count: usize) -> Self {
        let line = gauss(count);
        let mut points = Vec::with_capacity(count * count);
        for &(y, wy) in &line {
            points.extend(line.iter().map(|&(x, wx)| ([x, y, 0.0], wx * wy)));
        }
        Rule { points }
    }

    /// `count`³ Gauss points on the cube [−1, 1]³, ξ₀ running fastest.
    pub fn hexahedron(count: usize) -> Self {
        let square = Rule::quadrilateral(count);
        let mut points = Vec::with_capacity(count * count * count);
        for (z, wz) in gauss(count) {
            points.extend(square.points.iter().map(|&([x, y, _], w)| ([x, y, z], w * wz)));
        }
        Rule { points }
    }

    /// On the unit triangle, exact at least to `degree`: symmetric with 1, 3, 6, 12, 16 points up to degree
    /// 1, 2, 4, 6, 8, a collapsed product of Gauss points beyond.
    pub fn triangle(degree: usize) -> Self {
        match degree {
            0..=1 => Rule { points: vec![([1.0 / 3.0, 1.0 / 3.0, 0.0], 0.5)] },
            2 => Rule { points: orbit(1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0) },
            3..=4 => {
                let mut points = orbit(0.4459484909159649, 0.4459484909159649, 0.11169079483900574);
                points.extend(orbit(0.09157621350977074, 0.09157621350977074, 0.054975871827660935));
                Rule { points }
            }
            5..=6 => symmetric(0.0, &SIX),
            7..=8 => symmetric(0.5 * 0.14431560767778717, &EIGHT),
            _ => Rule::collapsed(2, degree),
        }
    }

    /// On the unit tetrahedron, exact at least to `degree`: 1, 4 points up to degree 1, 2, a collapsed product of
    /// Gauss points beyond. The four points lie next to nodes 1 to 4 in turn.
    pub fn tetrahedron(degree: usize) -> Self {
        match degree {
            0..=1 => Rule { points: vec![([0.25; 3], 1.0 / 6.0)] },
            2 => {
                let near = (5.0 - 5f64.sqrt()) / 20.0;
                let far = 1.0 - 3.0 * near;
                let points = [[near; 3], [far, near, near], [near, far, near], [near, near, far]];
                Rule { points: points.map(|p| (p, 1.0 / 24.0)).to_vec() }
            }
            _ => Rule::collapsed(3, degree),
        }
    }

    /// The rule for a cell's own shape that is exact at least to `degree` (in each direction on squares and cubes);
    /// no points for kinds without shape functions.
    pub fn of(kind: CellKind, degree: usize) -> Self {
        use CellKind::*;
        let count = degree / 2 + 1;
        match kind {
            Line2 | Line3 => Rule::line(count),
            Tri3 | Tri6 => Rule::triangle(degree),
            Quad4 | Quad8 => Rule::quadrilateral(count),
            Tet4 | Tet10 => Rule::tetrahedron(degree),
            Hex8 => Rule::hexahedron(count),
            _ => Rule { points: Vec::new() },
        }
    }

    /// The cube pressed onto the simplex: x = u (1−v)(1−w), y = v (1−w), z = w, Jacobian (1−v)(1−w)².
    fn collapsed(dimension: usize, degree: usize) -> Self {
        let line: Vec<_> = gauss((degree + dimension) / 2 + 1).iter().map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w)).collect();
        let flat = [(0.0, 1.0)];
        let mut points = Vec::new();
        for &(w, weight_w) in if dimension == 3 { &line[..] } else { &flat[..] } {
            for &(v, weight_v) in &line {
                for &(u, weight_u) in &line {
                    let jacobian = (1.0 - v) * (1.0 - w) * (1.0 - w);
                    let at = [u * (1.0 - v) * (1.0 - w), v * (1.0 - w), w];
                    points.push((at, weight_u * weight_v * weight_w * jacobian));
                }
            }
        }
        Rule { points }
    }
}

/// (a, b, weight of area 1): the point with barycentric coordinates a, b, 1−a−b and its permutations.
const SIX: [(f64, f64, f64); 3] = [
    (0.06308901449150223, 0.06308901449150223, 0.05084490637020682),
    (0.24928674517091043, 0.24928674517091043, 0.11678627572637937),
    (0.3103524510337844, 0.053145049844816945, 0.08285107561837357),
];

const EIGHT: [(f64, f64, f64); 4] = [
    (0.4592925882927232, 0.4592925882927232, 0.09509163426728462),
    (0.1705693077517602, 0.1705693077517602, 0.10321737053471824),
    (0.05054722831703098, 0.05054722831703098, 0.03245849762319808),
    (0.008394777409957605, 0.2631128296346381, 0.027230314174434993),
];

/// A symmetric triangle rule of a weight at the centroid (none if zero) and orbits.
fn symmetric(centre: f64, orbits: &[(f64, f64, f64)]) -> Rule {
    let mut points = Vec::new();
    if centre > 0.0 {
        points.push(([1.0 / 3.0, 1.0 / 3.0, 0.0], centre));
    }
    orbits.iter().for_each(|&(a, b, w)| points.extend(orbit(a, b, 0.5 * w)));
    Rule { points }
}

/// The permutations of barycentric (a, b, 1−a−b), each with `weight`: three if a = b, else six.
fn orbit(a: f64, b: f64, weight: f64) -> Vec<([f64; 3], f64)> {
    let c = 1.0 - a - b;
    let mut points = vec![([a, b, 0.0], weight), ([c, a, 0.0], weight), ([b, c, 0.0], weight)];
    if a != b {
        points.extend([([b, a, 0.0], weight), ([c, b, 0.0], weight), ([a, c, 0.0], weight)]);
    }
    points
}

/// Gauss–Legendre points and weights on [−1, 1], ascending: roots of P_n by Newton's method from Chebyshev's.
fn gauss(count: usize) -> Vec<(f64, f64)> {
    let n = count.max(1);
    let point = |i: usize| {
        let mut x = -((i as f64 + 0.75) / (n as f64 + 0.5) * std::f64::consts::PI).cos();
        let mut slope = 1.0;
        for _ in 0..8 {
            let (mut before, mut here) = (1.0, x);
            for k in 2..=n {
                let k = k as f64;
                (before, here) = (here, ((2.0 * k - 1.0) * x * here - (k - 1.0) * before) / k);
            }
            slope = n as f64 * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    let mut points: Vec<_> = (0..n.div_ceil(2)).map(point).collect();
    if n % 2 == 1 {
        points[n / 2].0 = 0.0;
    }
    let mirrored: Vec<_> = points[..n / 2].iter().rev().map(|&(x, w)| (-x, w)).collect();
    points.extend(mirrored);
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape;

    fn factorial(n: usize) -> f64 {
        (1..=n).map(|i| i as f64).product()
    }

    /// ∫ x^i y^j z^k: i! j! k!/(i+j+k+d)! on the simplex, Π 2/(i+1) for even powers on the cube.
    fn exact(dimension: usize, simplex: bool, power: [usize; 3]) -> f64 {
        if simplex {
            return power.iter().map(|&p| factorial(p)).product::<f64>()
                / factorial(power.iter().sum::<usize>() + dimension);
        }
        power[..dimension].iter().map(|&p| if p % 2 == 0 { 2.0 / (p + 1) as f64 } else { 0.0 }).product()
    }

    /// Every monomial of the degree to 1e-15 of the measure times the number of points: round-off.
    #[test]
    fn monomials_are_exact_weights_positive_points_inside() {
        use CellKind::*;
        for kind in [Line2, Tri3, Quad4, Tet4, Hex8] {
            let (d, simplex) = (kind.dimension(), matches!(kind, Tri3 | Tet4));
            for degree in 0..=11 {
                let rule = Rule::of(kind, degree);
                let of = |power: [usize; 3]| -> f64 {
                    rule.points
                        .iter()
                        .map(|(x, w)| w * (0..d).map(|i| x[i].powi(power[i] as i32)).product::<f64>())
                        .sum()
                };
                for (i, j, k) in
                    (0..=degree).flat_map(|i| (0..=degree).flat_map(move |j| (0..=degree).map(move |k| (i, j, k))))
                {
                    let beyond = (d < 2 && j > 0) || (d < 3 && k > 0) || (simplex && i + j + k > degree);
                    if !beyond {
                        let error = (of([i, j, k]) - exact(d, simplex, [i, j, k])).abs();
                        assert!(error < 4e-15 * shape::measure(kind), "{kind:?} {degree} {i}{j}{k}: {error:e}");
                    }
                }
                for (x, w) in &rule.points {
                    assert!(*w > 0.0);
                    if simplex {
                        assert!(x[..d].iter().all(|&x| x > 0.0) && x[..d].iter().sum::<f64>() < 1.0);
                    } else {
                        assert!(x.iter().all(|x| x.abs() < 1.0));
                    }
                }
            }
        }
    }

    #[test]
    fn few_points_where_symmetric_rules_exist() {
        assert_eq!([1, 2, 4, 6, 8].map(|d| Rule::triangle(d).points.len()), [1, 3, 6, 12, 16]);
        assert_eq!([1, 2].map(|d| Rule::tetrahedron(d).points.len()), [1, 4]);
        assert!((Rule::line(2).points[1].0[0] - 1.0 / 3f64.sqrt()).abs() < 2e-16);
    }
}
