//! Meshes that a deck cannot use: status 1, the mesh's name with the line (text) or the section and byte (binary),
//! and what is allowed; no panic, no results.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use fe_mesh::gmsh::{self, Encoding, Kept};

/// A cube with a named foot and top: format 2.2.
const CUBE: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
2 1 \"FOOT\"
2 2 \"TOP\"
3 3 \"CUBE\"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
3
1 3 2 1 1 1 4 3 2
2 3 2 2 2 5 6 7 8
3 5 2 3 3 1 2 3 4 5 6 7 8
$EndElements
";

const DECK: &str = "\
*MESH, INPUT=cube.msh
CUBE, C3D8
*MATERIAL, NAME=M
*ELASTIC
1000., 0.3
*SOLID SECTION, ELSET=CUBE, MATERIAL=M
*BOUNDARY
FOOT, 1, 3
*STEP
*STATIC
*DSLOAD
TOP, P, 1.
*END STEP
";

/// Runs a deck over a mesh; the objection, if it is not refused in these words.
fn objection(deck: &str, mesh: &[u8], words: &[&str], scratch: &Scratch) -> Option<String> {
    scratch.write("job.inp", deck);
    std::fs::write(scratch.path("cube.msh"), mesh).unwrap();
    let run = scratch.fe(&["run", "job.inp"]);
    let missing: Vec<_> = words.iter().chain(&["job.inp:"]).filter(|w| !run.error.contains(**w)).collect();
    let left = ["job.vtkhdf", "job.vtkhdf.unfinished", "job.dat"].iter().any(|name| scratch.path(name).exists());
    let sound = run.status == 1 && missing.is_empty() && !left && !run.error.contains("panicked");
    (!sound).then(|| format!("status {}, without {missing:?}, left {left}: {}", run.status, run.error))
}

/// The cube as it is runs in both encodings: what the cases below spoil is all that is wrong with them.
#[test]
fn the_good_mesh_runs() {
    let scratch = Scratch::new("mesh_good");
    for mesh in [CUBE.as_bytes().to_vec(), binary()] {
        assert!(objection(DECK, &mesh, &[], &scratch).unwrap().contains("status 0"));
    }
}

#[test]
fn text_meshes() {
    let scratch = Scratch::new("mesh_text");
    let cases: &[(&str, &str, &[&str])] = &[
        ("3 1 1 0\n", "3 1 nan 0\n", &["`cube.msh`, line 14: node 3 has a coordinate that is not finite"]),
        ("3 1 1 0\n", "3 1 1e400 0\n", &["`cube.msh`, line 14: node 3 has a coordinate that is not finite"]),
        ("3 1 1 0\n", "3 1 1,5 0\n", &["`cube.msh`, line 14: node 3: `1,5` stands where a number should"]),
        ("3 1 1 0\n", "2 1 1 0\n", &["`cube.msh`, line 14: node 2 is given a second time", "allowed: each node once"]),
        ("$Nodes\n8", "$Nodes\n999999999999", &["`cube.msh`, line 11: 999999999999 nodes announced, but only"]),
        ("$Nodes\n8", "$Nodes\n-8", &["`cube.msh`, line 11: "]),
        ("$Elements\n3", "$Elements\n4000000000", &["`cube.msh`, line 22: 4000000000 elements announced"]),
        ("4 5 6 7 8\n$", "4 5 6 7 9\n$", &["`cube.msh`, line 25: element 3 has node 9, which $Nodes does not hold"]),
        ("4 5 6 7 8\n$", "4 5 6 7\n$", &["`cube.msh`, line 25: element 3, node 8 of 8: the line ends"]),
        ("3 5 2 3 3", "3 92 2 3 3", &["`cube.msh`, line 25: element type 92", "allowed: elements"]),
        ("3 5 2 3 3", "3 777 2 3 3", &["`cube.msh`, line 25: element type 777 (an unknown type)", "allowed: "]),
        ("3 5 2 3 3", "2 5 2 3 3", &["`cube.msh`, line 25: element 2 is given a second time"]),
        ("2.2 0 8", "3.0 0 8", &["`cube.msh`, line 2: the file has gmsh format 3", "allowed: format 4.1 or 2.2"]),
        ("2.2 0 8", "2.2 0 3", &["`cube.msh`, line 2: the size of a number"]),
        ("$MeshFormat", "# vtk DataFile", &["`cube.msh`, line 1: this is no gmsh mesh", "allowed: format 4.1 or 2.2"]),
        ("\"CUBE\"", "CUBE", &["`cube.msh`, line 8: a physical name is not in quotes"]),
        ("$EndElements\n", "", &["`cube.msh`, line 26: ", "$EndElements"]),
        // What is sound as a mesh and no use for the deck: the deck's line, and the nearest name.
        ("\"CUBE\"", "\"KUBE\"", &["no physical group `CUBE` of volumes", "did you mean `KUBE`?"]),
        ("\"FOOT\"", "\"FOOTS\"", &["there is no node set `FOOT`", "did you mean `FOOTS`?"]),
        ("\"TOP\"", "\"TOPP\"", &["there is no surface `TOP`", "did you mean `TOPP`?"]),
        ("1 2 3 4 5 6 7 8\n$", "5 6 7 8 1 2 3 4\n$", &["element 3 (C3D8) is inside out"]),
        ("1 2 3 4 5 6 7 8\n$", "1 3 2 4 5 6 7 8\n$", &["element 3 (C3D8) "]),
        (
            "5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1",
            "5 0 0 0\n6 1 0 0\n7 1 1 0\n8 0 1 0",
            &["element 3 (C3D8) has no volume"],
        ),
    ];
    let mut objections = Vec::new();
    for (from, to, words) in cases {
        assert!(CUBE.contains(from), "{from}");
        let mesh = CUBE.replacen(from, to, 1);
        objections.extend(objection(DECK, mesh.as_bytes(), words, &scratch).map(|o| format!("{from} → {to}: {o}")));
    }
    objections.extend(objection(DECK, b"", &["`cube.msh`, line 1: the file is empty"], &scratch));
    let no_nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    objections.extend(objection(DECK, no_nodes.as_bytes(), &["`cube.msh`, line 3", "no $Nodes"], &scratch));
    assert!(objections.is_empty(), "{objections:#?}");
}

fn binary() -> Vec<u8> {
    let (mesh, _) = gmsh::parse(CUBE.as_bytes()).unwrap().into_mesh(Kept::HighestDimension);
    gmsh::write(&mesh, Encoding::Binary)
}

/// Byte after the first `word` and its line end.
fn after(bytes: &[u8], word: &str) -> usize {
    bytes.windows(word.len()).position(|w| w == word.as_bytes()).unwrap() + word.len() + 1
}

#[test]
fn binary_meshes() {
    let scratch = Scratch::new("mesh_binary");
    let good = binary();
    let nodes = after(&good, "$Nodes");
    let elements = after(&good, "$Elements");
    // Four counts, then per block four 4-byte and 8-byte numbers, 8 tags, 8 × 3 coordinates (format 4.1).
    let coordinates = nodes + 4 * 8 + 3 * 4 + 8 + 8 * 8;
    let edited = |at: usize, value: [u8; 8]| {
        let mut bytes = good.clone();
        bytes[at..at + 8].copy_from_slice(&value);
        bytes
    };
    let cut = |at: usize| good[..at].to_vec();
    let in_nodes = format!(", in $Nodes (from line {})", 1 + good[..nodes - 7].iter().filter(|b| **b == b'\n').count());
    let cases: Vec<(&str, Vec<u8>, Vec<String>)> = vec![
        ("cut in the nodes", cut(coordinates + 20), vec!["`cube.msh`, byte ".into(), in_nodes.clone()]),
        (
            "cut in the elements",
            cut(elements + 40),
            vec!["`cube.msh`, byte ".into(), ", in $Elements (from line".into()],
        ),
        (
            "a coordinate that is not a number",
            edited(coordinates + 8, f64::NAN.to_le_bytes()),
            vec!["node 1 has a coordinate that is not finite".into(), in_nodes.clone()],
        ),
        (
            "a count beyond the file",
            edited(nodes + 8, (1u64 << 60).to_le_bytes()),
            vec!["1152921504606846976 nodes announced, but only".into(), in_nodes.clone()],
        ),
        (
            "more element blocks than the file can hold",
            edited(elements, u64::MAX.to_le_bytes()),
            vec!["`cube.msh`, byte ".into(), ", in $Elements".into()],
        ),
    ];
    let mut objections = Vec::new();
    for (name, mesh, words) in &cases {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        objections.extend(objection(DECK, mesh, &words, &scratch).map(|o| format!("{name}: {o}")));
    }
    // Cut anywhere.
    for at in (0..good.len()).step_by(37) {
        std::fs::write(scratch.path("cube.msh"), &good[..at]).unwrap();
        let run = scratch.fe(&["check", "job.inp"]);
        assert!(run.status == 1 && !run.error.contains("panicked"), "cut at {at}: {}", run.error);
    }
    assert!(objections.is_empty(), "{objections:#?}");
}

/// A deck whose lines do not fit the mesh.
#[test]
fn decks_that_do_not_fit_the_mesh() {
    let scratch = Scratch::new("mesh_deck");
    let cases: &[(&str, &str, &[&str])] = &[
        ("CUBE, C3D8\n", "CUBE, C3D10\n", &["holds cells of kind Hex8, not C3D10", "there is `C3D8`", "job.inp:2"]),
        ("CUBE, C3D8\n", "CUBE, CPE4\n", &["no physical group `CUBE` of areas", "job.inp:2"]),
        ("CUBE, C3D8\n", "CUBE\n", &["job.inp:2"]),
        ("CUBE, C3D8\n", "", &["names no elements of the mesh", "job.inp:1"]),
        ("CUBE, C3D8\n", "CUBE, C3D8\nCUBE, C3D8\n", &["element 3 of group `CUBE` has a type already", "job.inp:3"]),
        ("cube.msh", "sphere.msh", &["the mesh `sphere.msh` cannot be read: there is no such file", "job.inp:1"]),
        ("cube.msh", ".", &["the mesh `.` cannot be read: it is no file", "job.inp:1"]),
        ("*MESH, INPUT=cube.msh\n", "*MESH\n", &["`*MESH` needs `INPUT=`", "job.inp:1"]),
        ("*MATERIAL", "*MESH, INPUT=cube.msh\nCUBE, C3D8\n*MATERIAL", &["node 1 is there twice", "job.inp:3"]),
    ];
    let mut objections = Vec::new();
    for (from, to, words) in cases {
        assert!(DECK.contains(from), "{from}");
        let deck = DECK.replacen(from, to, 1);
        objections.extend(objection(&deck, CUBE.as_bytes(), words, &scratch).map(|o| format!("{from} → {to}: {o}")));
    }
    assert!(objections.is_empty(), "{objections:#?}");
}
