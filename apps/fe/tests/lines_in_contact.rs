//! Trusses as secondary lines over a block, and as sides in the plane: force = the law's number × length, or × length ×
//! thickness. All nodes are prescribed, so that the reactions are the contact forces, node by node.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// Reactions at the nodes of a set, by ascending label.
fn reactions(name: &str, deck: &str, set: &str) -> Vec<[f64; 3]> {
    let blocks = Job::run(name, deck).tables();
    let table = blocks.iter().find(|b| b.title.starts_with("forces") && b.set == set).unwrap();
    table.rows.iter().map(|row| [0, 1, 2].map(|c| row.values[c])).collect()
}

/// A block whose top is z = 0 and a truss along x that is pressed 0.01 into it. LINEAR, k = 100: 1 force per length.
fn on_block(kind: &str, nodes: &str, elements: &str) -> String {
    format!(
        "*NODE, NSET=BASE\n1, -1., -1., -2.\n2, 6., -1., -2.\n3, 6., 1., -2.\n4, -1., 1., -2.\n\
         5, -1., -1., 0.\n6, 6., -1., 0.\n7, 6., 1., 0.\n8, -1., 1., 0.\n\
         *ELEMENT, TYPE=C3D8, ELSET=EB\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*NODE, NSET=LINE\n{nodes}\
         *ELEMENT, TYPE={kind}, ELSET=BAR\n{elements}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
         *SOLID SECTION, ELSET=EB, MATERIAL=M\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.,\n\
         *SURFACE, NAME=TOP\nEB, S2\n*SURFACE, NAME=WIRE\nBAR,\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.,\n*CONTACT PAIR, INTERACTION=I\nWIRE, TOP\n\
         *BOUNDARY\nBASE, 1, 3\nLINE, 1, 2\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nLINE, 3, 3, -0.01\n\
         *NODE PRINT, NSET=LINE\nRF\n*END STEP\n"
    )
}

/// A length of 5 in pieces of 1, 1.5 and 2.5: 5 in all, each end of a piece carries half of it. The table has seven
/// digits.
#[test]
fn a18_a_line_of_two_node_trusses() {
    let nodes = "11, 0., 0., 0.\n12, 1., 0., 0.\n13, 2.5, 0., 0.\n14, 5., 0., 0.\n";
    let forces = reactions("line_two", &on_block("T3D2", nodes, "11, 11, 12\n12, 12, 13\n13, 13, 14\n"), "LINE");
    let expected = [0.5, 1.25, 2.0, 1.25];
    assert_eq!(forces.len(), 4);
    for (force, expected) in forces.iter().zip(expected) {
        assert!((force[2] + expected).abs() < 1e-6 && force[0].abs() + force[1].abs() < 1e-9, "{force:?} {expected}");
    }
    assert!((forces.iter().map(|f| f[2]).sum::<f64>() + 5.0).abs() < 1e-6);
}

/// The same line of beams.
#[test]
fn a18_a_line_of_beams() {
    let nodes = "11, 0., 0., 0.\n12, 1., 0., 0.\n13, 2.5, 0., 0.\n14, 5., 0., 0.\n";
    for kind in ["B31", "B33"] {
        let deck = on_block(kind, nodes, "11, 11, 12\n12, 12, 13\n13, 13, 14\n")
            .replace(
                "*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.,\n",
                "*BEAM SECTION, ELSET=BAR, MATERIAL=M, SECTION=RECT\n1., 1.\n0., 1., 0.\n",
            )
            .replace("LINE, 1, 2\n", "LINE, 1, 2\nLINE, 4, 6\n");
        let forces = reactions(&format!("line_{kind}"), &deck, "LINE");
        let expected = [0.5, 1.25, 2.0, 1.25];
        assert!(forces.len() == 4 && forces.iter().zip(expected).all(|(f, e)| (f[2] + e).abs() < 1e-6), "{forces:?}");
    }
}

/// The same length with nodes in the middle: a sixth, two thirds, a sixth of 2 and of 3.
#[test]
fn a18_a_line_of_three_node_trusses() {
    let nodes = "11, 0., 0., 0.\n12, 1., 0., 0.\n13, 2., 0., 0.\n14, 3.5, 0., 0.\n15, 5., 0., 0.\n";
    let forces = reactions("line_three", &on_block("T3D3", nodes, "11, 11, 12, 13\n12, 13, 14, 15\n"), "LINE");
    let expected = [1.0 / 3.0, 4.0 / 3.0, 5.0 / 6.0, 2.0, 0.5];
    assert_eq!(forces.len(), 5);
    for (force, expected) in forces.iter().zip(expected) {
        assert!((force[2] + expected).abs() < 1e-6, "{force:?} {expected}");
    }
}

/// A truss along y = 0 in the plane, from left to right or from right to left, under a block that is pressed 0.01 onto
/// it: SPOS is on the left of the way from the first node to the second. Length 2, thickness 3: 6 in all.
fn in_plane(way: &str, side: &str, pair: &str) -> String {
    format!(
        "*NODE, NSET=LINE\n1, 0., 0.\n2, 2., 0.\n*NODE, NSET=PAD\n11, 0., 0.\n12, 2., 0.\n13, 2., 1.\n14, 0., 1.\n\
         *ELEMENT, TYPE=CPS4, ELSET=EB\n11, 11, 12, 13, 14\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n1, {way}\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*SOLID SECTION, ELSET=EB, MATERIAL=M\n\
         *SOLID SECTION, ELSET=BAR, MATERIAL=M\n*SURFACE, NAME=FOOT\nEB, S1\n*SURFACE, NAME=WIRE\nBAR, {side}\n\
         *SURFACE INTERACTION, NAME=I\n3.,\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.,\n\
         *CONTACT PAIR, INTERACTION=I{pair}\n*BOUNDARY\nLINE, 1, 2\nPAD, 1, 1\n*STEP\n*STATIC\n1., 1.\n\
         *BOUNDARY\nPAD, 2, 2, -0.01\n*NODE PRINT, NSET=LINE\nRF\n*END STEP\n"
    )
}

#[test]
fn a18_either_side_of_a_truss_in_the_plane() {
    let pairs = ["\nFOOT, WIRE\n", "\nWIRE, FOOT\n", ", TYPE=SURFACE TO SURFACE\nFOOT, WIRE\n"];
    for (k, pair) in pairs.into_iter().enumerate() {
        for (way, upper, lower) in [("1, 2", "SPOS", "SNEG"), ("2, 1", "SNEG", "SPOS")] {
            let name = format!("sides_{k}_{upper}");
            for force in reactions(&name, &in_plane(way, upper, pair), "LINE") {
                assert!((force[1] - 3.0).abs() < 1e-6, "{pair} {way} {upper}: {force:?}");
            }
            // The other side faces away.
            for force in reactions(&name, &in_plane(way, lower, pair), "LINE") {
                assert_eq!(force, [0.0; 3], "{pair} {way} {lower}");
            }
        }
    }
}
