//! Reference cells cut into parts that shrink towards a place.

use fe_mesh::{CellKind, shape};

/// A part of a reference cell of a linear kind: its corners ξ, an affine image of the cell.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// Corners.
    pub corners: Vec<[f64; 3]>,
    /// How often it was halved: its measure is 2^(−dimension·level) of the cell's.
    pub level: usize,
}

impl Part {
    /// The whole cell.
    pub fn whole(kind: CellKind) -> Self {
        Part { corners: shape::nodes(kind).to_vec(), level: 0 }
    }

    /// Its centre ξ.
    pub fn centre(&self) -> [f64; 3] {
        let count = self.corners.len() as f64;
        std::array::from_fn(|i| self.corners.iter().map(|c| c[i]).sum::<f64>() / count)
    }

    /// Halves: the part shrunk about each corner, and on simplices what lies between.
    fn halves(&self, kind: CellKind) -> Vec<Part> {
        let c = &self.corners;
        let middle = |a: usize, b: usize| -> [f64; 3] { std::array::from_fn(|i| 0.5 * (c[a][i] + c[b][i])) };
        let shrunk = |a: usize| (0..c.len()).map(|b| middle(a, b)).collect::<Vec<_>>();
        let mut halves: Vec<Vec<[f64; 3]>> = (0..c.len()).map(shrunk).collect();
        match kind {
            CellKind::Tri3 => halves.push(vec![middle(0, 1), middle(1, 2), middle(2, 0)]),
            CellKind::Tet4 => {
                // The octahedron in the middle, around its diagonal from edge 01 to edge 23.
                let ring = [middle(0, 2), middle(0, 3), middle(1, 3), middle(1, 2)];
                halves.extend((0..4).map(|i| vec![middle(0, 1), middle(2, 3), ring[i], ring[(i + 1) % 4]]));
            }
            _ => {}
        }
        halves.into_iter().map(|corners| Part { corners, level: self.level + 1 }).collect()
    }

    /// All parts of a cell, each halved while `near` says so.
    pub fn of(kind: CellKind, near: &dyn Fn(&Part) -> bool) -> Vec<Part> {
        let (mut open, mut done) = (vec![Part::whole(kind)], Vec::new());
        while let Some(part) = open.pop() {
            if near(&part) {
                open.extend(part.halves(kind));
            } else {
                done.push(part);
            }
        }
        done
    }
}

/// The point of the cell that lies at ξ of the part.
pub(super) fn place(kind: CellKind, part: &Part, xi: &[f64; 3]) -> [f64; 3] {
    let mut values = [0.0; 8];
    shape::values(kind, xi, &mut values);
    std::array::from_fn(|i| part.corners.iter().zip(values).map(|(c, n)| n * c[i]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use fe_mesh::quadrature::Rule;

    /// Parts cut towards a corner integrate every quadratic as the whole cell does, so that they fill it once: to the
    /// round-off of some hundred terms.
    #[test]
    fn parts_fill_the_cell() {
        use CellKind::*;
        for kind in [Tri3, Quad4, Tet4, Hex8] {
            let rule = Rule::of(kind, 3);
            let corner = shape::nodes(kind)[0];
            let near = |part: &Part| {
                let square: f64 = part.centre().iter().zip(corner).map(|(a, b)| (a - b).powi(2)).sum();
                part.level < 3 && square < 4.0 * 0.25f64.powi(part.level as i32)
            };
            let parts = Part::of(kind, &near);
            assert!(parts.len() > 1);
            for (i, j) in [(0, 0), (0, 1), (1, 1), (0, 2)] {
                let whole: f64 = rule.points.iter().map(|(x, w)| w * x[i] * x[j]).sum();
                let mut sum = 0.0;
                for part in &parts {
                    let share = 0.5f64.powi((kind.dimension() * part.level) as i32);
                    for (xi, weight) in &rule.points {
                        let x = place(kind, part, xi);
                        sum += share * weight * x[i] * x[j];
                    }
                }
                assert!((sum - whole).abs() < 1e-13, "{kind:?} {i}{j}: {sum} {whole}");
            }
        }
    }
}
