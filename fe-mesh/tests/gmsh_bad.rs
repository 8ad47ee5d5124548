//! Meshes that cannot be read: each is refused with its place and what would be allowed, none with a panic.
#![allow(clippy::unwrap_used)]

use fe_mesh::gmsh::{Kept, Place, parse};

fn data(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/tests/data/{name}.msh", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// A text file with its first `from` replaced.
fn edited(name: &str, from: &str, to: &str) -> Vec<u8> {
    let text = String::from_utf8(data(name)).unwrap();
    assert!(text.contains(from), "{name} has no {from:?}");
    text.replacen(from, to, 1).into_bytes()
}

fn message(bytes: &[u8]) -> String {
    parse(bytes).expect_err("the mesh is bad").to_string()
}

/// Four nodes, a tetrahedron and a triangle of format 4.1, to be spoilt.
const SMALL_4: &str = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n\
    0 0 1\n$EndNodes\n$Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n3 1 4 1\n2 1 2 3 4\n$EndElements\n";

/// The same of format 2.2.
const SMALL_2: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n\
    $Elements\n2\n1 2 2 0 1 1 2 3\n2 4 2 0 1 1 2 3 4\n$EndElements\n";

/// What the small files are spoilt with, and the words of the message.
#[test]
fn text_files_that_are_refused() {
    for small in [SMALL_4, SMALL_2] {
        assert_eq!(parse(small.as_bytes()).unwrap().into_mesh(Kept::HighestDimension).0.cell_count(), 1);
    }
    let cases = [
        (SMALL_4, "4.1 0 8", "4 0 8", "line 2: the file has gmsh format 4; allowed: format 4.1 or 2.2"),
        (SMALL_4, "4.1 0 8", "3 0 8", "line 2: the file has gmsh format 3;"),
        (SMALL_4, "4.1 0 8", "4.1 7 8", "line 2: the file type is neither 0 (text) nor 1 (binary)"),
        (SMALL_4, "4.1 0 8", "4.1 0 16", "line 2: the size of a number is neither 4 nor 8 bytes"),
        (SMALL_4, "$MeshFormat\n4.1 0 8", "$NOD\n4", "line 1: the file has gmsh format 1;"),
        (SMALL_4, "$MeshFormat", "*HEADING", "line 1: this is no gmsh mesh: it does not start with $MeshFormat"),
        (SMALL_4, "1 0 0\n", "1 nan 0\n", "line 12: node 2 has a coordinate that is not finite: [1.0, NaN, 0.0]"),
        (SMALL_4, "1 0 0\n", "1 -1e999 0\n", "line 12: node 2 has a coordinate that is not finite"),
        (SMALL_4, "1 0 0\n", "1 0\n", "line 12: node 2: the line ends where a number should stand"),
        (SMALL_4, "1 0 0\n", "1 0 0 0\n", "line 12: `0` stands where the end of the line should"),
        (SMALL_4, "1 0 0\n", "1 0,5 0\n", "line 12: node 2: `0,5` stands where a number should"),
        (SMALL_4, "\n3\n4\n", "\n3\n2\n", "line 10: node 2 is given a second time; allowed: each node once"),
        (SMALL_4, "1 4 1 4", "1 5 1 4", "line 14: $Nodes announced 5 nodes, its blocks hold 4"),
        (SMALL_4, "1 4 1 4", "1 99999999999999 1 4", "line 5: 99999999999999 nodes announced, but only"),
        (SMALL_4, "1 4 1 4", "1 99999999999999999999999 1 4", "line 5: `99999999999999999999999` stands where"),
        (SMALL_4, "3 1 0 4", "3 1 0 3", "line 10: node 1: the line ends where a number should stand"),
        (SMALL_4, "2 1 2 3 4", "2 1 2 3 9", "line 21: element 2 has node 9, which $Nodes does not hold"),
        (SMALL_4, "2 1 2 3 4", "2 1 2 3", "line 21: element 2, node 4 of 4: the line ends where a count or tag"),
        (SMALL_4, "2 1 2 3 4", "2 1 2 3 4 1", "line 21: element 2 (4 nodes): `1` stands where the end of the line"),
        (SMALL_4, "2 1 2 3 4", "1 1 2 3 4", "line 21: element 1 is given a second time"),
        (SMALL_4, "3 1 4 1", "3 1 29 1", "line 20: element type 29 (a tetrahedron of order 3 or more) is not read"),
        (SMALL_4, "3 1 4 1", "3 1 777 1", "line 20: element type 777 (an unknown type) is not read; allowed: elements"),
        (SMALL_4, "3 1 4 1", "2 1 4 1", "line 20: elements of type 4 (Tet4) stand in a block of dimension 2"),
        (SMALL_4, "$EndElements\n", "", "the file ends where $EndElements should; allowed: as many records as"),
        (SMALL_4, "$EndNodes", "$EndNode", "line 15: something else stands where $EndNodes should"),
        (SMALL_4, "$EndMeshFormat\n", "", "line 3: $EndMeshFormat should stand here"),
        (SMALL_4, "$EndElements", "$EndElements\n$NodeData\n1\n", "line 23: $NodeData has no $EndNodeData"),
        (SMALL_4, "$EndElements", "$EndElements\nrest", "line 23: a section should start here, or the file end"),
        (SMALL_2, "2 1 0 0", "1 1 0 0", "line 7: node 1 is given a second time"),
        (SMALL_2, "2 1 0 0", "-2 1 0 0", "line 7: a tag is negative; allowed: tags from 1 on"),
        (SMALL_2, "2 1 0 0", "2 1 0 inf", "line 7: node 2 has a coordinate that is not finite: [1.0, 0.0, inf]"),
        (SMALL_2, "2 4 2 0 1 1 2 3 4", "2 4 2 0 1 1 2 3 5", "line 14: element 2 has node 5, which $Nodes does not"),
        (SMALL_2, "2 4 2 0 1 1 2 3 4", "2 4 2 0 1 1 2 3", "line 14: element 2, node 4 of 4: the line ends where an"),
        (SMALL_2, "2 4 2 0 1 1 2 3 4", "2 94 2 0 1 1 2 3 4", "line 14: element type 94 (a hexahedron of order 3"),
        (SMALL_2, "2 4 2 0 1", "1 4 2 0 1", "line 14: element 1 is given a second time"),
        (SMALL_2, "$Elements\n2", "$Elements\n7777777", "line 12: 7777777 elements announced, but only"),
        (SMALL_2, "$Elements\n2", "$Elements\n1", "line 14: something else stands where $EndElements should"),
    ];
    let mut unlike = Vec::new();
    for (small, from, to, words) in cases {
        assert!(small.contains(from), "{from}");
        let result = parse(small.replacen(from, to, 1).as_bytes());
        let message = result.map_or_else(|error| error.to_string(), |_| "read".to_string());
        if !message.contains(words) {
            unlike.push(format!("{from:?} → {to:?}: {message}"));
        }
    }
    assert!(unlike.is_empty(), "{unlike:#?}");
    assert!(message(b"").starts_with("line 1: the file is empty"));
    assert!(message(b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").contains("the file has no $Nodes; allowed: a mesh"));
    let (head, elements) = SMALL_4.split_once("$Elements").unwrap();
    let (format, nodes) = head.split_once("$Nodes").unwrap();
    let swapped = format!("{format}$Elements{elements}$Nodes{nodes}");
    assert!(
        message(swapped.as_bytes()).starts_with("line 7: $Elements stands before $Nodes"),
        "{}",
        message(swapped.as_bytes())
    );
}

/// Spoilt files of gmsh's own: names and entities.
#[test]
fn names_and_entities() {
    let name = message(&edited("tetrahedra_41", "\"Upper\"", "Upper"));
    assert!(name.contains(": a physical name is not in quotes; allowed: dimension tag \"name\""), "{name}");
    let entity = message(&edited("tetrahedra_41", "3 2 4 24", "3 6 4 24"));
    assert!(entity.contains(": elements on the entity 6 of dimension 3, which is not listed"), "{entity}");
    let twice = [data("tetrahedra_41"), b"$Nodes\n0 0 0 0\n$EndNodes\n".to_vec()].concat();
    assert!(message(&twice).contains("$Nodes stands here a second time"));
}

/// Offset of the first `needle`.
fn find(bytes: &[u8], needle: &[u8]) -> usize {
    bytes.windows(needle.len()).position(|window| window == needle).unwrap()
}

/// Binary files tell the byte, the section and the line where it starts.
#[test]
fn binary_files_that_are_refused() {
    let good = data("tetrahedra_41b");
    let nodes = find(&good, b"$Nodes\n") + 7;
    // Byte order: neither way round gives 1.
    let mut bad = good.clone();
    bad[find(&good, b"4.1 1 8\n") + 9] = 7;
    assert!(message(&bad).contains("the byte order is not to be told: 1 should stand here"));
    // An absurd count.
    let mut bad = good.clone();
    bad[nodes + 8..nodes + 16].fill(0x7f);
    let error = parse(&bad).unwrap_err();
    assert!(error.what.contains("nodes announced, but only"), "{error}");
    let line = 1 + good[..nodes - 7].iter().filter(|&&byte| byte == b'\n').count();
    assert_eq!(error.place, Place::Byte { offset: nodes + 16, section: "Nodes".to_string(), line });
    // A coordinate that is no number: blocks of one node first, each with header 20 and tag 8 bytes.
    let mut bad = good.clone();
    let coordinate = nodes + 32 + 20 + 8;
    bad[coordinate..coordinate + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    let error = parse(&bad).unwrap_err();
    assert!(error.to_string().starts_with(&format!("byte {coordinate}, in $Nodes (from line {line}): node 1 has")));
    // A node twice: the second block holds node 2.
    let mut bad = good.clone();
    let second = nodes + 32 + 20 + 8 + 24 + 20;
    assert_eq!(bad[second], 2);
    bad[second] = 1;
    let error = parse(&bad).unwrap_err();
    assert!(error.to_string().starts_with(&format!("byte {second}, in $Nodes (from line {line}): node 1 is given")));
    // Cut off.
    let cut = message(&good[..nodes + 500]);
    assert!(cut.contains("in $Nodes") && cut.contains("was it cut off?"), "{cut}");
    let cut = message(&data("tetrahedra_22b")[..900]);
    assert!(cut.contains("was it cut off?"), "{cut}");
    // Format 2.2: a run that is longer than what was announced.
    let mut bad = data("tetrahedra_22b");
    let elements = find(&bad, b"$Elements\n") + 10;
    let run = elements + 1 + bad[elements..].iter().position(|&byte| byte == b'\n').unwrap();
    bad[run + 4..run + 8].copy_from_slice(&100_000i32.to_le_bytes());
    assert!(message(&bad).contains("a run of 100000 elements stands where"), "{}", message(&bad));
}

/// Reverses the byte order of a binary 4.1 file with nothing but `$Nodes` and `$Elements`, number by number.
fn big_endian(numbers: &[(u64, usize)]) -> Vec<u8> {
    numbers.iter().flat_map(|&(value, bytes)| value.to_be_bytes()[8 - bytes..].to_vec()).collect()
}

/// A file from a machine of the other byte order reads the same as the text.
#[test]
fn other_byte_order() {
    let mut file = b"$MeshFormat\n4.1 1 8\n".to_vec();
    file.extend(big_endian(&[(1, 4)]));
    file.extend(b"\n$EndMeshFormat\n$Nodes\n");
    file.extend(big_endian(&[(1, 8), (4, 8), (1, 8), (4, 8), (3, 4), (1, 4), (0, 4), (4, 8)]));
    file.extend(big_endian(&[(1, 8), (2, 8), (3, 8), (4, 8)]));
    for coordinate in [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0f64] {
        file.extend(coordinate.to_be_bytes());
    }
    file.extend(b"\n$EndNodes\n$Elements\n");
    file.extend(big_endian(&[(2, 8), (2, 8), (1, 8), (2, 8)]));
    file.extend(big_endian(&[(2, 4), (1, 4), (2, 4), (1, 8), (1, 8), (1, 8), (2, 8), (3, 8)]));
    file.extend(big_endian(&[(3, 4), (1, 4), (4, 4), (1, 8), (2, 8), (1, 8), (2, 8), (3, 8), (4, 8)]));
    file.extend(b"\n$EndElements\n");
    assert_eq!(parse(&file).unwrap(), parse(SMALL_4.as_bytes()).unwrap());
}
