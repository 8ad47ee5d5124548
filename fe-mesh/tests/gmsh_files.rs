//! Files made by gmsh itself (`data/make.py`): the four encodings say the same.
#![allow(clippy::unwrap_used)]

use fe_mesh::gmsh::{GmshMesh, Kept, Note, parse};
use fe_mesh::{CellKind, Mesh};
use std::collections::BTreeMap;

fn data(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/{name}.msh", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn read(name: &str) -> GmshMesh {
    parse(&data(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn mesh(name: &str) -> Mesh {
    read(name).into_mesh(Kept::HighestDimension).0
}

/// Points of the text agree to 1e-15 of the largest coordinate: gmsh writes 16 digits, half a unit of the last is
/// 5e-16 of a number. All else is equal.
fn assert_same(a: &Mesh, b: &Mesh, tolerance: f64, what: &str) {
    let size = a.points.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    for (p, q) in a.points.iter().flatten().zip(b.points.iter().flatten()) {
        assert!((p - q).abs() <= tolerance * size, "{what}: {p} {q}");
    }
    assert_eq!(a.points.len(), b.points.len(), "{what}");
    assert_eq!(a.point_labels, b.point_labels, "{what}");
    assert_eq!(a.blocks, b.blocks, "{what}");
    assert_eq!(a.node_sets, b.node_sets, "{what}");
    assert_eq!(a.cell_sets, b.cell_sets, "{what}");
    assert_eq!(a.surfaces, b.surfaces, "{what}");
}

/// Same labels, connectivity and sets from 2.2 and 4.1, text and binary; binary coordinates bit for bit.
#[test]
fn four_encodings_give_one_mesh() {
    for name in ["tetrahedra", "tetrahedra_2", "hexahedra", "hexahedra_2", "plane"] {
        let binary = mesh(&format!("{name}_41b"));
        assert!(binary.cell_count() > 0);
        assert_same(&binary, &mesh(&format!("{name}_22b")), 0.0, name);
        assert_same(&binary, &mesh(&format!("{name}_41")), 1e-15, name);
        assert_same(&binary, &mesh(&format!("{name}_22")), 1e-15, name);
    }
}

/// One element of every kind: format 2.2 numbers them in another order, so they are compared by places.
#[test]
fn every_kind_in_four_encodings() {
    let binary = mesh("every_kind_41b");
    for encoding in ["41", "22", "22b"] {
        let other = mesh(&format!("every_kind_{encoding}"));
        assert_eq!(cells_by_places(&other), cells_by_places(&binary), "{encoding}");
        assert_eq!(nodes_by_places(&other), nodes_by_places(&binary), "{encoding}");
    }
}

fn sizes<T>(sets: &BTreeMap<String, Vec<T>>) -> Vec<(&str, usize)> {
    sets.iter().map(|(name, set)| (name.as_str(), set.len())).collect()
}

/// Two blocks of 2 × 2 × 2 hexahedra: counts by hand. Names are capitals, blanks stay, elements are in two sets, a group
/// without name has one made.
#[test]
fn groups_become_sets_and_surfaces() {
    let (mesh, notes) = read("hexahedra_41").into_mesh(Kept::HighestDimension);
    assert_eq!(sizes(&mesh.cell_sets), [("ALL", 16), ("LOWER BLOCK", 8), ("UPPER", 8)]);
    let surfaces = [("BOTTOM FACE", 4), ("INTERFACE", 4), ("PHYSICAL_2_5", 20), ("TOP", 4)];
    assert_eq!(sizes(&mesh.surfaces), surfaces);
    let nodes = [
        ("ALL", 45),
        ("BOTTOM FACE", 9),
        ("CORNER", 1),
        ("EDGE", 3),
        ("INTERFACE", 9),
        ("LOWER BLOCK", 27),
        ("PHYSICAL_2_5", 33),
        ("TOP", 9),
        ("UPPER", 27),
    ];
    assert_eq!(sizes(&mesh.node_sets), nodes);
    for (name, faces) in &mesh.surfaces {
        let mut of_faces: Vec<u32> = faces.iter().flat_map(|&face| mesh.face(face).1).collect();
        of_faces.sort_unstable();
        of_faces.dedup();
        assert_eq!(&of_faces, &mesh.node_sets[name]);
    }
    // The common face lies between both blocks: the lower labels, those of the first block, have it.
    let [Note::SharedFaces { surface, cells }] = &notes[..] else { panic!("{notes:?}") };
    assert_eq!((surface.as_str(), cells.len()), ("INTERFACE", 4));
    assert!(cells.iter().all(|[taken, other]| taken < other));
    assert!(mesh.surfaces["INTERFACE"].iter().all(|face| mesh.cell_sets["LOWER BLOCK"].contains(&face.cell)));
    assert!(notes[0].to_string().starts_with("surface INTERFACE: 4 of its faces lie between two elements"));
}

/// Keeping one group keeps its cells alone, and the common face belongs to them without a doubt.
#[test]
fn kept_groups() {
    let read = read("tetrahedra_22b");
    let upper = read.groups_named("upper");
    assert_eq!(upper.len(), 1);
    let (mesh, notes) = read.clone().into_mesh(Kept::Groups(&upper));
    assert_eq!(sizes(&mesh.cell_sets), [("ALL", 24), ("UPPER", 24)]);
    assert_eq!(sizes(&mesh.surfaces), [("INTERFACE", 4), ("PHYSICAL_2_5", 8), ("TOP", 4)]);
    assert_eq!((mesh.points.len(), mesh.node_sets["LOWER BLOCK"].len()), (23, 14));
    let loose: Vec<&str> = notes
        .iter()
        .map(|note| match note {
            Note::LooseFacets { surface, .. } => surface.as_str(),
            _ => panic!("{note}"),
        })
        .collect();
    assert_eq!(loose, ["BOTTOM FACE", "PHYSICAL_2_5"]);
    // Surface elements as cells, their edge group as their edge.
    let top = read.groups_named("Top");
    let (mesh, _) = read.into_mesh(Kept::Groups(&top));
    assert_eq!(sizes(&mesh.cell_sets), [("TOP", 4)]);
    assert_eq!(mesh.blocks[0].kind, CellKind::Tri3);
    assert_eq!(sizes(&mesh.surfaces), [("EDGE", 1)]);
}

/// A plane file: edges of triangles and quadrangles are surfaces; the seam belongs to the lower labels.
#[test]
fn plane_files() {
    let mesh = mesh("plane_41");
    let kinds: Vec<(CellKind, usize)> = mesh.blocks.iter().map(|block| (block.kind, block.len())).collect();
    assert_eq!(kinds, [(CellKind::Tri3, 18), (CellKind::Quad4, 9)]);
    assert_eq!(sizes(&mesh.surfaces), [("RIM", 18), ("SEAM", 3)]);
    assert!(mesh.points.iter().all(|point| point[2] == 0.0));
}

/// A point as a key: its coordinates bit for bit.
fn place(mesh: &Mesh, point: u32) -> [u64; 3] {
    mesh.points[point as usize].map(f64::to_bits)
}

/// Places of some points, sorted.
fn places(mesh: &Mesh, points: &[u32]) -> Vec<[u64; 3]> {
    let mut places: Vec<[u64; 3]> = points.iter().map(|&point| place(mesh, point)).collect();
    places.sort_unstable();
    places
}

/// Cells by the places of their points, each with its sets: whatever the order and labels.
fn cells_by_places(mesh: &Mesh) -> BTreeMap<Vec<[u64; 3]>, Vec<&str>> {
    let points = |id| mesh.cell(id).iter().map(|&point| place(mesh, point)).collect();
    let sets = |id| mesh.cell_sets.iter().filter(|(_, set)| set.contains(&id)).map(|(name, _)| name.as_str()).collect();
    mesh.cells().map(|id| (points(id), sets(id))).collect()
}

/// Names of surfaces with the corners of each face, sorted.
fn faces_by_places(mesh: &Mesh) -> BTreeMap<&str, Vec<Vec<[u64; 3]>>> {
    let surface = |faces: &[fe_mesh::Face]| {
        let mut all: Vec<_> = faces.iter().map(|&face| places(mesh, &mesh.face(face).1)).collect();
        all.sort_unstable();
        all
    };
    mesh.surfaces.iter().map(|(name, faces)| (name.as_str(), surface(faces))).collect()
}

/// Names of node sets with the places of their nodes.
fn nodes_by_places(mesh: &Mesh) -> BTreeMap<&str, Vec<[u64; 3]>> {
    mesh.node_sets.iter().map(|(name, nodes)| (name.as_str(), places(mesh, nodes))).collect()
}

/// A mesh cut into partitions reads as the whole one, points, cells and sets, though gmsh numbers it anew. Compared in
/// the same encoding, so that coordinates are the same bit for bit.
#[test]
fn partitioned_files() {
    for encoding in ["41", "41b", "22", "22b"] {
        let whole = mesh(&format!("tetrahedra_{encoding}"));
        let cut = mesh(&format!("partitioned_{encoding}"));
        assert_eq!(cut.points.len(), whole.points.len(), "{encoding}");
        assert_eq!(cells_by_places(&cut), cells_by_places(&whole), "{encoding}");
        assert_eq!(nodes_by_places(&cut), nodes_by_places(&whole), "{encoding}");
        assert_eq!(faces_by_places(&cut), faces_by_places(&whole), "{encoding}");
    }
}

/// Node tags a million apart: the same mesh with these labels.
#[test]
fn sparse_tags() {
    let dense = mesh("plane_41b");
    for encoding in ["41", "41b"] {
        let mut sparse = mesh(&format!("sparse_{encoding}"));
        for label in &mut sparse.point_labels {
            assert_eq!(*label % 1_000_003, 5);
            *label /= 1_000_003;
        }
        assert_same(&dense, &sparse, 1e-15, encoding);
    }
}

/// Edges (pairs of corners) of a volume cell in the order of their middle nodes in the decks.
fn edges(kind: CellKind) -> &'static [[usize; 2]] {
    match kind {
        CellKind::Tet10 => &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
        CellKind::Hex20 | CellKind::Hex27 => {
            &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]]
        }
        CellKind::Wedge15 | CellKind::Wedge18 => {
            &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]]
        }
        CellKind::Pyramid13 | CellKind::Pyramid14 => &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]],
        _ => &[],
    }
}

/// Corners whose mean the nodes after the edges' are: centre and faces of the 27-node brick, faces of the 18-node
/// prism, base of the 14-node pyramid.
fn centres(kind: CellKind) -> &'static [&'static [usize]] {
    match kind {
        CellKind::Hex27 => &[
            &[0, 1, 2, 3, 4, 5, 6, 7],
            &[0, 1, 2, 3],
            &[4, 5, 6, 7],
            &[0, 1, 5, 4],
            &[1, 2, 6, 5],
            &[2, 3, 7, 6],
            &[3, 0, 4, 7],
        ],
        CellKind::Wedge18 => &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        CellKind::Pyramid14 => &[&[0, 1, 2, 3]],
        _ => &[],
    }
}

/// Middle nodes stand in the decks' order: at the mean of the corners that the decks' numbering says.
#[test]
fn node_orders_are_those_of_the_decks() {
    let mesh = mesh("every_kind_41b");
    assert_eq!(mesh.cell_count(), 11);
    for id in mesh.cells() {
        let points: Vec<[f64; 3]> = mesh.cell(id).iter().map(|&node| mesh.points[node as usize]).collect();
        let kind = mesh.kind(id);
        let edges: Vec<&[usize]> = edges(kind).iter().map(|edge| &edge[..]).collect();
        let means = [&edges[..], centres(kind)].concat();
        let corners = kind.nodes() - means.len();
        for (node, of) in means.iter().enumerate() {
            let mean = |k: usize| of.iter().map(|&corner| points[corner][k]).sum::<f64>() / of.len() as f64;
            assert_eq!(points[corners + node], [mean(0), mean(1), mean(2)], "{kind:?} node {}", corners + node);
        }
        assert!(matches!(corners, 4 | 5 | 6 | 8), "{kind:?} {corners}");
    }
}
