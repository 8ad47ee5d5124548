//! gmsh's numbers of the kinds of element, and its local node orders.

use crate::cell::CellKind::{self, *};

/// One kind of element that is read: gmsh's number, the kind, and where in gmsh's order each node of the decks'
/// order stands (empty: the orders agree).
struct Row(i32, CellKind, &'static [u8]);

/// Node orders derived from the reference coordinates that gmsh gives for each kind.
const TABLE: [Row; 19] = [
    Row(1, Line2, &[]),
    Row(2, Tri3, &[]),
    Row(3, Quad4, &[]),
    Row(4, Tet4, &[]),
    Row(5, Hex8, &[]),
    Row(6, Wedge6, &[]),
    Row(7, Pyramid5, &[]),
    Row(8, Line3, &[]),
    Row(9, Tri6, &[]),
    Row(10, Quad9, &[]),
    Row(11, Tet10, &[0, 1, 2, 3, 4, 5, 6, 7, 9, 8]),
    Row(12, Hex27, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15, 26, 20, 25, 21, 23, 24, 22]),
    Row(13, Wedge18, &[0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16]),
    Row(14, Pyramid14, &[0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12, 13]),
    Row(15, Point1, &[]),
    Row(16, Quad8, &[]),
    Row(17, Hex20, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15]),
    Row(18, Wedge15, &[0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11]),
    Row(19, Pyramid13, &[0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12]),
];

/// Kind and node order (`deck[i] = gmsh[order[i]]`; empty: as is) of gmsh's element type.
pub(super) fn from_gmsh(number: i32) -> Option<(CellKind, &'static [u8])> {
    TABLE.iter().find(|row| row.0 == number).map(|row| (row.1, row.2))
}

/// gmsh's element type and node order of a kind.
pub(super) fn to_gmsh(kind: CellKind) -> (i32, &'static [u8]) {
    let row = TABLE.iter().find(|row| row.1 == kind);
    row.map(|row| (row.0, row.2)).expect("the table holds every kind")
}

/// What is known of a type that is not read, for the message.
pub(super) fn describe_unsupported(number: i32) -> &'static str {
    match number {
        20..=25 => "a triangle of order 3 or more",
        26..=28 | 62..=66 => "a line of order 3 or more",
        29..=33 | 71..=75 => "a tetrahedron of order 3 or more",
        36..=41 | 47..=51 => "a quadrangle of order 3 or more",
        92..=98 => "a hexahedron of order 3 or more",
        90 | 91 | 106..=110 => "a prism of order 3 or more",
        118..=123 => "a pyramid of order 3 or more",
        _ => "an unknown type",
    }
}

/// The types that are read, for the message.
pub(super) const SUPPORTED: &str = "elements of order 1 and 2: points, lines, triangles (3, 6 nodes), quadrangles \
     (4, 8, 9), tetrahedra (4, 10), hexahedra (8, 20, 27), prisms (6, 15, 18), pyramids (5, 13, 14)";

#[cfg(test)]
mod tests {
    use super::*;

    /// Every kind has one row, its order is a permutation of its nodes.
    #[test]
    fn orders_are_permutations() {
        for Row(number, kind, order) in TABLE {
            assert_eq!(to_gmsh(kind).0, number);
            if !order.is_empty() {
                let mut sorted = order.to_vec();
                sorted.sort_unstable();
                assert_eq!(sorted, (0..kind.nodes() as u8).collect::<Vec<_>>(), "{kind:?}");
            }
        }
    }
}
