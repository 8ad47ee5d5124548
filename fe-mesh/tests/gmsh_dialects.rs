//! What other writers and other settings of gmsh make of the formats.
#![allow(clippy::unwrap_used)]

use fe_mesh::Mesh;
use fe_mesh::gmsh::{Kept, Note, parse};

fn read(text: &str) -> (Mesh, Vec<Note>) {
    parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error}")).into_mesh(Kept::HighestDimension)
}

/// Labels of the cells of a set.
fn labels(mesh: &Mesh, set: &str) -> Vec<u64> {
    mesh.cell_sets[set].iter().map(|&id| mesh.cell_label(id)).collect()
}

/// Format 2.2 with three triangles and these elements.
fn with_elements(elements: &[&str]) -> String {
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n$EndNodes\n\
         $Elements\n{}\n{}\n$EndElements\n",
        elements.len(),
        elements.join("\n")
    )
}

/// Copies of an element far apart, groups that overlap in part: one cell each, in all its groups. The numbers ran
/// through, so that the cells are numbered as if there were no copies.
#[test]
fn copies_far_apart() {
    let elements = [
        "1 2 2 7 1 1 2 3",
        "2 2 2 7 1 1 3 4",
        "3 2 2 7 1 2 5 3",
        "4 2 2 8 1 1 3 4",
        "5 2 2 8 1 2 5 3",
        "6 2 2 9 1 1 2 3",
    ];
    let (mesh, _) = read(&with_elements(&elements));
    assert_eq!(mesh.cell_count(), 3);
    assert_eq!(labels(&mesh, "PHYSICAL_2_7"), [1, 2, 3]);
    let mut of_8 = labels(&mesh, "PHYSICAL_2_8");
    of_8.sort_unstable();
    assert_eq!((of_8, labels(&mesh, "PHYSICAL_2_9")), (vec![2, 3], vec![1]));
}

/// Numbers with gaps are the user's own: they stay, the lowest of each cell's.
#[test]
fn numbers_with_gaps_stay() {
    let elements = ["10 2 2 7 1 1 2 3", "20 2 2 8 1 1 2 3", "30 2 2 7 1 1 3 4"];
    let (mesh, _) = read(&with_elements(&elements));
    assert_eq!((labels(&mesh, "PHYSICAL_2_7"), labels(&mesh, "PHYSICAL_2_8")), (vec![10, 30], vec![10]));
}

/// The same element twice in one group, or on two entities, is no copy for another group: both stay, to be found by
/// the check of the mesh. Elements without tags or group are in no set.
#[test]
fn what_is_no_copy_stays() {
    let elements = ["1 2 2 7 1 1 2 3", "2 2 2 7 1 1 2 3", "3 2 2 8 2 1 2 3", "4 2 0 1 3 4", "5 2 2 0 1 2 5 3"];
    let (mesh, _) = read(&with_elements(&elements));
    assert_eq!(mesh.cell_count(), 5);
    assert_eq!((labels(&mesh, "PHYSICAL_2_7"), labels(&mesh, "PHYSICAL_2_8")), (vec![1, 2], vec![3]));
    assert_eq!(mesh.cell_sets.len(), 2);
    assert_eq!(fe_mesh::check::duplicate_cells(&mesh).len(), 2);
}

/// Line ends of Windows, blank lines, sections without a mesh (one of which holds what looks like an end), version `2`,
/// partition tags, a named group without elements, and a reversed group (negative number).
#[test]
fn dialects_of_format_2() {
    let names = "$PhysicalNames\n2\n2 7 \"Plate no. 1\"\n1 3 \" rim \"\n$EndPhysicalNames\n";
    let text = with_elements(&["1 2 4 -7 1 1 2 1 2 3", "2 2 2 7 1 1 3 4"])
        .replace("2.2 0 8", "2 0 8")
        .replace("$Nodes\n", &format!("\n$Comments\na $EndNodes here\n$EndComments\n{names}$Nodes\n"))
        .replace("$EndElements\n", "$EndElements\n$Periodic\n1\n0 1 2\n0\n$EndPeriodic\n$ElementData\n$EndElementData")
        .replace('\n', "\r\n");
    let (mesh, notes) = read(&text);
    assert_eq!(labels(&mesh, "PLATE NO. 1"), [1, 2]);
    assert_eq!(notes, [Note::EmptyGroup { name: "RIM".to_string() }]);
    assert_eq!(mesh.node_sets["RIM"], []);
    assert_eq!((mesh.points.len(), mesh.node_sets["PLATE NO. 1"].len()), (5, 4));
}

/// Format 4.1 without entities, with parametric coordinates, and no element at all.
#[test]
fn dialects_of_format_4() {
    let text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 3 1 30\n1 1 1 1\n1\n0 0 0 0.5\n2 1 1 2\n30\n2\n\
        1 0 0 0.25 0.75\n0 1 -0.0 1 1\n$EndNodes\n$Elements\n1 1 5 5\n2 1 2 1\n5 1 30 2\n$EndElements\n";
    let (mesh, notes) = read(text);
    assert_eq!((mesh.point_labels.as_slice(), &mesh.blocks[0].nodes[..]), (&[1, 30, 2][..], &[0, 1, 2][..]));
    assert_eq!(mesh.points, [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert!(notes.is_empty() && mesh.cell_sets.is_empty());
    let empty = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 0 0\n$EndElements";
    assert_eq!(read(empty), (Mesh::default(), Vec::new()));
}
