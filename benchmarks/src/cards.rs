//! A mesh as keyword cards, in any order, which other programs read too.

use fe_core::element::ElementType;
use fe_mesh::{Face, Mesh};
use std::fmt::Write;

/// The order in which nodes, elements and faces are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As in the mesh.
    AsMade,
    /// The last first.
    Backwards,
    /// Every k-th in turn; k must have no divisor in common with the counts (a large prime does).
    Strided(usize),
}

impl Order {
    /// The order of `count` things.
    pub fn of(self, count: usize) -> Vec<usize> {
        match self {
            Order::AsMade => (0..count).collect(),
            Order::Backwards => (0..count).rev().collect(),
            Order::Strided(stride) => (0..count).map(|i| (i * stride + 5) % count).collect(),
        }
    }
}

/// How coordinates are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// So that they are read as the same bits.
    All,
    /// Thirteen digits: CalculiX reads 20 characters of a number.
    Thirteen,
}

/// `*NODE`, `*ELEMENT`, `*NSET` and `*SURFACE` of a mesh. `elements`: the cell sets that become elements, with their
/// types.
pub fn mesh(mesh: &Mesh, elements: &[(&str, ElementType)], order: Order, digits: Digits) -> String {
    let mut text = String::from("*NODE\n");
    for i in order.of(mesh.points.len()) {
        let ([x, y, z], label) = (mesh.points[i], mesh.point_labels[i]);
        // Writing to a string does not fail, here and below.
        let _ = match digits {
            Digits::All => writeln!(text, "{label}, {x:e}, {y:e}, {z:e}"),
            Digits::Thirteen => writeln!(text, "{label}, {x:.12e}, {y:.12e}, {z:.12e}"),
        };
    }
    let node_label = |&n: &u32| mesh.point_labels[n as usize];
    for (set, element) in elements {
        let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET={set}", element.name());
        let cells = mesh.cell_sets.get(*set).map_or(&[][..], Vec::as_slice);
        for i in order.of(cells.len()) {
            row(
                &mut text,
                std::iter::once(mesh.cell_label(cells[i])).chain(mesh.cell(cells[i]).iter().map(node_label)),
            );
        }
    }
    for (name, nodes) in &mesh.node_sets {
        let _ = writeln!(text, "*NSET, NSET={name}");
        nodes.chunks(LONGEST).for_each(|chunk| row(&mut text, chunk.iter().map(node_label)));
    }
    for (name, faces) in &mesh.surfaces {
        let _ = writeln!(text, "*SURFACE, NAME={name}");
        for i in order.of(faces.len()) {
            let Face { cell, face } = faces[i];
            let _ = writeln!(text, "{}, S{}", mesh.cell_label(cell), face + 1);
        }
    }
    text
}

/// Most items a line.
const LONGEST: usize = 16;

/// A data line, that goes on in another one where it is long.
fn row(text: &mut String, labels: impl Iterator<Item = u64>) {
    let words: Vec<String> = labels.map(|label| label.to_string()).collect();
    let lines: Vec<String> = words.chunks(LONGEST).map(|chunk| chunk.join(", ")).collect();
    text.push_str(&lines.join(",\n"));
    text.push('\n');
}
