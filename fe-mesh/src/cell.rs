//! The kinds of cell: node counts, faces, and the numbers that other formats give them.

/// A kind of cell. Local node numbers follow the keyword decks (and so VTK, up to hex27).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum CellKind {
    Point1,
    Line2,
    Line3,
    Tri3,
    Tri6,
    Quad4,
    Quad8,
    Quad9,
    Tet4,
    Tet10,
    Hex8,
    Hex20,
    Hex27,
    Wedge6,
    Wedge15,
    Wedge18,
    Pyramid5,
    Pyramid13,
    Pyramid14,
}

use CellKind::*;

impl CellKind {
    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        match self {
            Point1 => 1,
            Line2 => 2,
            Line3 | Tri3 => 3,
            Quad4 | Tet4 => 4,
            Pyramid5 => 5,
            Tri6 | Wedge6 => 6,
            Quad8 | Hex8 => 8,
            Quad9 => 9,
            Tet10 => 10,
            Pyramid13 => 13,
            Pyramid14 => 14,
            Wedge15 => 15,
            Wedge18 => 18,
            Hex20 => 20,
            Hex27 => 27,
        }
    }

    /// Dimension of the cell itself: 0 point, 1 line, 2 area, 3 volume.
    pub const fn dimension(self) -> usize {
        match self {
            Point1 => 0,
            Line2 | Line3 => 1,
            Tri3 | Tri6 | Quad4 | Quad8 | Quad9 => 2,
            _ => 3,
        }
    }

    /// VTK's number of the cell type.
    pub const fn vtk(self) -> u8 {
        match self {
            Point1 => 1,
            Line2 => 3,
            Line3 => 21,
            Tri3 => 5,
            Tri6 => 22,
            Quad4 => 9,
            Quad8 => 23,
            Quad9 => 28,
            Tet4 => 10,
            Tet10 => 24,
            Hex8 => 12,
            Hex20 => 25,
            Hex27 => 29,
            Wedge6 => 13,
            Wedge15 => 26,
            Wedge18 => 32,
            Pyramid5 => 14,
            Pyramid13 | Pyramid14 => 27,
        }
    }

    /// The faces in the decks' numbering (S1 first): kind and local nodes of each, ordered so that the normal
    /// by the right-hand rule points out of the cell. A plane cell's faces are its edges, traversed
    /// counter-clockwise, the body on the left; a line in the plane has two sides. Empty for kinds that carry no element yet.
    /// What a plane cell has in space stands in [`CellKind::sides`].
    pub const fn faces(self) -> &'static [(CellKind, &'static [usize])] {
        match self {
            // SPOS, SNEG: the normal of SPOS is on the left of the way from the first node to the second.
            Line2 => &[(Line2, &[1, 0]), (Line2, &[0, 1])],
            Tri3 => &[(Line2, &[0, 1]), (Line2, &[1, 2]), (Line2, &[2, 0])],
            Quad4 => &[(Line2, &[0, 1]), (Line2, &[1, 2]), (Line2, &[2, 3]), (Line2, &[3, 0])],
            Tri6 => &[(Line3, &[0, 1, 3]), (Line3, &[1, 2, 4]), (Line3, &[2, 0, 5])],
            Quad8 | Quad9 => &[(Line3, &[0, 1, 4]), (Line3, &[1, 2, 5]), (Line3, &[2, 3, 6]), (Line3, &[3, 0, 7])],
            Tet4 => &[(Tri3, &[0, 2, 1]), (Tri3, &[0, 1, 3]), (Tri3, &[1, 2, 3]), (Tri3, &[0, 3, 2])],
            Tet10 => &[
                (Tri6, &[0, 2, 1, 6, 5, 4]),
                (Tri6, &[0, 1, 3, 4, 8, 7]),
                (Tri6, &[1, 2, 3, 5, 9, 8]),
                (Tri6, &[0, 3, 2, 7, 9, 6]),
            ],
            Hex8 => &[
                (Quad4, &[0, 3, 2, 1]),
                (Quad4, &[4, 5, 6, 7]),
                (Quad4, &[0, 1, 5, 4]),
                (Quad4, &[1, 2, 6, 5]),
                (Quad4, &[2, 3, 7, 6]),
                (Quad4, &[3, 0, 4, 7]),
            ],
            Hex20 | Hex27 => &[
                (Quad8, &[0, 3, 2, 1, 11, 10, 9, 8]),
                (Quad8, &[4, 5, 6, 7, 12, 13, 14, 15]),
                (Quad8, &[0, 1, 5, 4, 8, 17, 12, 16]),
                (Quad8, &[1, 2, 6, 5, 9, 18, 13, 17]),
                (Quad8, &[2, 3, 7, 6, 10, 19, 14, 18]),
                (Quad8, &[3, 0, 4, 7, 11, 16, 15, 19]),
            ],
            Wedge6 => &[
                (Tri3, &[0, 2, 1]),
                (Tri3, &[3, 4, 5]),
                (Quad4, &[0, 1, 4, 3]),
                (Quad4, &[1, 2, 5, 4]),
                (Quad4, &[2, 0, 3, 5]),
            ],
            _ => &[],
        }
    }
}

impl CellKind {
    /// The two sides of a plane cell in space, SPOS, whose normal follows from the order of the nodes by the right-hand
    /// rule, and SNEG; empty for the other kinds.
    pub const fn sides(self) -> &'static [(CellKind, &'static [usize])] {
        match self {
            Tri3 => &[(Tri3, &[0, 1, 2]), (Tri3, &[0, 2, 1])],
            Quad4 => &[(Quad4, &[0, 1, 2, 3]), (Quad4, &[0, 3, 2, 1])],
            _ => &[],
        }
    }

    /// Kind and local nodes of a face by its number: the sides count on after the faces.
    pub fn face(self, number: u8) -> (CellKind, &'static [usize]) {
        let (number, faces) = (usize::from(number), self.faces());
        if number < faces.len() { faces[number] } else { self.sides()[number - faces.len()] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_follow_the_faces() {
        assert_eq!(Quad4.face(3), (Line2, &[3usize, 0][..]));
        assert_eq!(Quad4.face(4), (Quad4, &[0usize, 1, 2, 3][..]));
        assert_eq!(Tri3.face(4), (Tri3, &[0usize, 2, 1][..]));
    }

    /// Every edge of a closed cell is walked once in each direction by its faces: the faces are oriented alike.
    #[test]
    fn faces_are_oriented_alike() {
        for kind in [Tet4, Tet10, Hex8, Hex20, Wedge6] {
            let mut edges = Vec::new();
            for (face, nodes) in kind.faces() {
                let corners = if matches!(face, Tri3 | Tri6) { 3 } else { 4 };
                for i in 0..corners {
                    edges.push((nodes[i], nodes[(i + 1) % corners]));
                }
            }
            for &(a, b) in &edges {
                assert_eq!(edges.iter().filter(|&&e| e == (a, b)).count(), 1, "{kind:?}");
                assert_eq!(edges.iter().filter(|&&e| e == (b, a)).count(), 1, "{kind:?}");
            }
        }
    }
}
