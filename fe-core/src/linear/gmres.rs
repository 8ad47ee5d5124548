//! Systems whose matrix is the identity and a little more: GMRES.

use crate::procedure::system::dot;

/// Solves A x = b, `apply` being the product with A, until the residual is below `tolerance` (an absolute norm) or after
/// `most` products; the basis begins anew after `restart` of them. Returns x and the norm of its residual (Saad and
/// Schultz, SIAM J. Sci. Stat. Comput. 7, 1986, 856-869).
pub fn gmres(
    mut apply: impl FnMut(&[f64]) -> Vec<f64>,
    right: &[f64],
    tolerance: f64,
    (restart, most): (usize, usize),
) -> (Vec<f64>, f64) {
    let mut x = vec![0.0; right.len()];
    let mut residual = right.to_vec();
    let mut products = 0;
    loop {
        let size = dot(&residual, &residual).sqrt();
        // A number that is not finite ends it, too.
        if products >= most || size <= tolerance || size.is_nan() {
            return (x, size);
        }
        let mut cycle = Cycle::new(&residual, size);
        while cycle.basis.len() <= restart && products < most {
            products += 1;
            let product = apply(&cycle.basis[cycle.basis.len() - 1]);
            if cycle.extend(product) <= tolerance || cycle.ended {
                break;
            }
        }
        cycle.add_to(&mut x);
        if cycle.ended && cycle.residual <= tolerance {
            return (x, cycle.residual);
        }
        let product = apply(&x);
        products += 1;
        residual.iter_mut().zip(right.iter().zip(&product)).for_each(|(r, (b, a))| *r = b - a);
    }
}

/// One basis, and the least-squares problem on it, kept triangular by rotations.
struct Cycle {
    basis: Vec<Vec<f64>>,
    /// Columns of the triangle.
    columns: Vec<Vec<f64>>,
    rotations: Vec<(f64, f64)>,
    right: Vec<f64>,
    residual: f64,
    /// The basis holds all there is.
    ended: bool,
}

impl Cycle {
    fn new(residual: &[f64], size: f64) -> Self {
        let first = residual.iter().map(|r| r / size).collect();
        let (columns, rotations) = (Vec::new(), Vec::new());
        Cycle { basis: vec![first], columns, rotations, right: vec![size], residual: size, ended: false }
    }

    /// One more direction; returns the norm of the residual.
    fn extend(&mut self, mut product: Vec<f64>) -> f64 {
        let before = dot(&product, &product).sqrt();
        let mut column = vec![0.0; self.basis.len()];
        // Twice is enough (Kahan and Parlett).
        for _ in 0..2 {
            for (h, v) in column.iter_mut().zip(&self.basis) {
                let part = dot(&product, v);
                *h += part;
                product.iter_mut().zip(v).for_each(|(p, v)| *p -= part * v);
            }
        }
        let next = dot(&product, &product).sqrt();
        for (i, &(c, s)) in self.rotations.iter().enumerate() {
            let (a, b) = (column[i], column[i + 1]);
            (column[i], column[i + 1]) = (c * a + s * b, c * b - s * a);
        }
        let last = column.len() - 1;
        let length = column[last].hypot(next);
        let (c, s) = if length > 0.0 { (column[last] / length, next / length) } else { (1.0, 0.0) };
        column[last] = length;
        self.rotations.push((c, s));
        self.columns.push(column);
        self.right.push(-s * self.right[last]);
        self.right[last] *= c;
        self.residual = self.right[last + 1].abs();
        self.ended = next <= f64::EPSILON * before;
        if !self.ended {
            self.basis.push(product.iter().map(|p| p / next).collect());
        }
        self.residual
    }

    /// Adds the best combination of the basis.
    fn add_to(&self, x: &mut [f64]) {
        let mut amounts = self.right[..self.columns.len()].to_vec();
        for j in (0..amounts.len()).rev() {
            let pivot = self.columns[j][j];
            amounts[j] = if pivot == 0.0 { 0.0 } else { amounts[j] / pivot };
            let (known, column) = (amounts[j], &self.columns[j]);
            amounts[..j].iter_mut().zip(column).for_each(|(a, h)| *a -= known * h);
        }
        for (amount, v) in amounts.iter().zip(&self.basis) {
            x.iter_mut().zip(v).for_each(|(x, v)| *x += amount * v);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 + a matrix of rank 3 is met after four products, with restarts a little later; what is left of the residual is of
    /// the size of rounding.
    #[test]
    fn few_directions_take_few_products() {
        let n = 40;
        let vector =
            |k: usize| (0..n).map(|i| ((i * i * (k + 2) + 3 * i + k) % 17) as f64 / 17.0 - 0.5).collect::<Vec<f64>>();
        let (left, other): (Vec<_>, Vec<_>) = ((0..3).map(vector).collect(), (5..8).map(vector).collect());
        let b = vector(11);
        for (restart, most) in [(50, 6), (2, 60)] {
            let mut products = 0;
            let product = |x: &[f64]| {
                let mut y = x.to_vec();
                for (l, r) in left.iter().zip(&other) {
                    let amount = 0.1 * dot(r, x);
                    y.iter_mut().zip(l).for_each(|(y, l)| *y += amount * l);
                }
                y
            };
            let counted = |x: &[f64]| {
                products += 1;
                product(x)
            };
            let (x, residual) = gmres(counted, &b, 1e-13, (restart, most));
            let left: f64 = product(&x).iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            assert!(products <= most && residual <= 1e-13 && left <= 1e-12, "{products} {residual} {left}");
        }
        assert_eq!(gmres(|_| panic!(), &[0.0; 3], 0.0, (5, 5)), (vec![0.0; 3], 0.0));
    }
}
