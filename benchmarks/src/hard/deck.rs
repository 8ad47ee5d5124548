//! Decks with their nodes and elements in them, in any order.

use fe_core::element::ElementType;
use fe_mesh::Mesh;
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

/// `*NODE`, `*ELEMENT`, `*NSET` and `*SURFACE` of a mesh. `elements`: the cell sets that become elements, with their
/// types; numbers are written so that they are read as the same bits.
pub fn cards(mesh: &Mesh, elements: &[(&str, ElementType)], order: Order) -> String {
    let mut text = String::from("*NODE\n");
    let line = |text: &mut String, items: &[String]| {
        // Sixteen items a line, as decks have them; writing to a string does not fail.
        for (i, chunk) in items.chunks(16).enumerate() {
            let _ = write!(text, "{}{}", if i > 0 { ",\n" } else { "" }, chunk.join(", "));
        }
        text.push('\n');
    };
    for i in order.of(mesh.points.len()) {
        let [x, y, z] = mesh.points[i];
        let _ = writeln!(text, "{}, {x:e}, {y:e}, {z:e}", mesh.point_labels[i]);
    }
    for (set, element) in elements {
        let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET={set}", element.name());
        let cells = mesh.cell_sets.get(*set).map_or(&[][..], Vec::as_slice);
        for i in order.of(cells.len()) {
            let nodes = mesh.cell(cells[i]).iter().map(|&n| mesh.point_labels[n as usize]);
            let items: Vec<String> =
                std::iter::once(mesh.cell_label(cells[i])).chain(nodes).map(|l| l.to_string()).collect();
            line(&mut text, &items);
        }
    }
    for (name, nodes) in &mesh.node_sets {
        let _ = writeln!(text, "*NSET, NSET={name}");
        for chunk in nodes.chunks(16) {
            let items: Vec<String> = chunk.iter().map(|&n| mesh.point_labels[n as usize].to_string()).collect();
            line(&mut text, &items);
        }
    }
    for (name, faces) in &mesh.surfaces {
        let _ = writeln!(text, "*SURFACE, NAME={name}");
        for i in order.of(faces.len()) {
            let _ = writeln!(text, "{}, S{}", mesh.cell_label(faces[i].cell), faces[i].face + 1);
        }
    }
    text
}

/// An elastic material of all these element sets.
pub fn elastic(sets: &[&str], young: f64, poisson: f64) -> String {
    let sections: String = sets.iter().map(|set| format!("*SOLID SECTION, ELSET={set}, MATERIAL=ELASTIC\n")).collect();
    format!("*MATERIAL, NAME=ELASTIC\n*ELASTIC\n{young:e}, {poisson:e}\n{sections}")
}

/// Prescribed displacements of a node, as data lines of `*BOUNDARY`, with a value for each direction.
pub fn prescribed(label: u64, u: &[f64]) -> String {
    u.iter().zip(1..).map(|(u, c)| format!("{label}, {c}, {c}, {u:e}\n")).collect()
}
