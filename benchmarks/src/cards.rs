//! A mesh as keyword cards, which other programs read too.

use fe_core::element::ElementType;
use fe_mesh::{Face, Mesh};
use std::fmt::Write;

/// `*NODE`, `*ELEMENT`, `*NSET` and `*SURFACE` of a mesh; each of `elements` is an element set and its type. All nodes
/// are in the set `NALL`.
pub fn mesh(mesh: &Mesh, elements: &[(&str, ElementType)]) -> String {
    let mut text = String::from("*NODE, NSET=NALL\n");
    for (label, [x, y, z]) in mesh.point_labels.iter().zip(&mesh.points) {
        // Writing to a string does not fail, here and below.
        let _ = writeln!(text, "{label}, {x:.12e}, {y:.12e}, {z:.12e}");
    }
    for (set, element) in elements {
        let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET={set}", element.name());
        for &cell in &mesh.cell_sets[*set] {
            let nodes = mesh.cell(cell).iter().map(|&n| mesh.point_labels[n as usize]);
            row(&mut text, std::iter::once(mesh.cell_label(cell)).chain(nodes));
        }
    }
    for (name, nodes) in &mesh.node_sets {
        let _ = writeln!(text, "*NSET, NSET={name}");
        nodes.chunks(8).for_each(|chunk| row(&mut text, chunk.iter().map(|&n| mesh.point_labels[n as usize])));
    }
    for (name, faces) in &mesh.surfaces {
        let _ = writeln!(text, "*SURFACE, NAME={name}, TYPE=ELEMENT");
        for &Face { cell, face } in faces {
            let _ = writeln!(text, "{}, S{}", mesh.cell_label(cell), face + 1);
        }
    }
    text
}

fn row(text: &mut String, labels: impl Iterator<Item = u64>) {
    let words: Vec<String> = labels.map(|label| label.to_string()).collect();
    text.push_str(&words.join(", "));
    text.push('\n');
}
