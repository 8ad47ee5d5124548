//! A lattice of points and the cells between them.

use crate::cell::CellKind;

/// Points numbered along x first, then y, then z; `refinement` steps to each division.
pub(super) struct Lattice {
    divisions: [usize; 3],
    refinement: usize,
}

/// The corners of a brick in the decks' order.
const BRICK: [[usize; 3]; 8] = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];

/// The tetrahedra of a brick as corners of [`BRICK`]: the six paths along edges from corner 0 to corner 6.
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 2, 6], [0, 5, 1, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 4, 5, 6], [0, 7, 4, 6]];

/// The ends of a tetrahedron's edges in the order of their middle nodes.
const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

impl Lattice {
    pub fn new(divisions: [usize; 3], refinement: usize) -> Self {
        Lattice { divisions, refinement }
    }

    /// Steps along an axis; 0 where the lattice is flat.
    pub fn steps(&self, axis: usize) -> usize {
        self.divisions[axis] * self.refinement
    }

    /// Steps from the origin to each point.
    pub fn places(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        let [nx, ny, nz] = [0, 1, 2].map(|axis| self.steps(axis));
        (0..=nz).flat_map(move |z| (0..=ny).flat_map(move |y| (0..=nx).map(move |x| [x, y, z])))
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> u32 {
        (x + (self.steps(0) + 1) * (y + (self.steps(1) + 1) * z)) as u32
    }

    /// Points of all cells of a kind, division by division.
    pub fn cells(&self, kind: CellKind) -> Vec<u32> {
        let mut nodes = Vec::new();
        let [nx, ny, nz] = self.divisions;
        for z in 0..nz.max(1) {
            for y in 0..ny {
                for x in 0..nx {
                    self.division(kind, [x, y, z], &mut nodes);
                }
            }
        }
        nodes
    }

    /// Appends the cells of one division.
    fn division(&self, kind: CellKind, place: [usize; 3], nodes: &mut Vec<u32>) {
        let corner = |i: usize| -> [usize; 3] { std::array::from_fn(|k| self.refinement * (place[k] + BRICK[i][k])) };
        match kind {
            CellKind::Tri3 => nodes.extend([0, 1, 2, 0, 2, 3].map(|i| self.index(corner(i)))),
            CellKind::Quad4 => nodes.extend([0, 1, 2, 3].map(|i| self.index(corner(i)))),
            CellKind::Hex8 => nodes.extend((0..8).map(|i| self.index(corner(i)))),
            _ => {
                for tetrahedron in TETRAHEDRA {
                    nodes.extend(tetrahedron.map(|i| self.index(corner(i))));
                    if kind == CellKind::Tet10 {
                        nodes.extend(EDGES.map(|[a, b]| {
                            let (a, b) = (corner(tetrahedron[a]), corner(tetrahedron[b]));
                            self.index(std::array::from_fn(|k| (a[k] + b[k]) / 2))
                        }));
                    }
                }
            }
        }
    }
}
