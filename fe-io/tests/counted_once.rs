//! What is there twice counts once, or is told.

use fe_contact::surface::Secondary;
use fe_io::{Deck, Library, Model, resolve};

const CONTACT: &str = include_str!("good/contact.inp");

fn model(text: &str) -> Model {
    let answer = Deck::from_text("test.inp", text).and_then(|deck| resolve(&deck, &Library::default()));
    answer.unwrap_or_else(|faults| panic!("{faults}"))
}

fn told(model: &Model, words: &[&str]) -> bool {
    model.notes.iter().any(|note| words.iter().all(|word| note.contains(word)))
}

/// UPPER, face S1, presses on LOWER; SOLE holds it too, alone or with another face; and nodes on the floor alike.
#[test]
fn a_face_under_two_names_presses_once() {
    let alone = model(&CONTACT.replace("*SURFACE, NAME=SOLE\n2, S3\n", "*SURFACE, NAME=SOLE\n2, S1\n"));
    assert_eq!(alone.pairs.len(), 2, "{:?}", alone.notes);
    assert!(told(&alone, &["warning: 1 faces of surface `SOLE`", "`LOWER`", "`UPPER`", "left out", "test.inp:55"]));
    let both = model(&CONTACT.replace("2, S3\n", "2, S1\n2, S3\n"));
    let Secondary::Faces(faces) = &both.pairs[2].0.secondary else { panic!("{:?}", both.pairs[2]) };
    assert!(faces.len() == 1 && faces[0].face == 2, "{faces:?}");
    assert!(told(&both, &["1 faces of surface `SOLE`", "counts once"]));
    let nodes = CONTACT.replace("*SURFACE, NAME=FLOOR", "*SURFACE, NAME=TOES, TYPE=NODE\n2\n3\n*SURFACE, NAME=FLOOR");
    let nodes = model(&nodes.replace("FEET, FLOOR\n", "FEET, FLOOR\nTOES, FLOOR\n"));
    assert!(matches!(&nodes.pairs[2].0.secondary, Secondary::Nodes(left) if left[..] == [(2, None)]), "{nodes:?}");
}

/// The pairs face each other at the interface: no crack. Without them its four pairs of nodes are one.
#[test]
fn nodes_at_the_same_place_are_counted() {
    assert!(!told(&model(CONTACT), &["same place"]));
    let cut = CONTACT.replace("UPPER, LOWER\n", "UPPER, SIDE\n").replace("SOLE, LOWER\n", "SOLE, SIDE\n");
    let cut = cut.replace("*SURFACE, NAME=SKIN", "*SURFACE, NAME=SIDE\n1, S1\n*SURFACE, NAME=SKIN");
    let cut = model(&cut.replace("*CONTACT PRINT, MASTER=LOWER, SLAVE=UPPER\nCSTR, CDIS, CF\n", ""));
    assert!(told(&cut, &["warning: 4 pairs of nodes lie at the same place", "nodes 5 and 11"]), "{:?}", cut.notes);
    // A node of no element is none of them.
    let unused = model(&CONTACT.replace("99, 0., 0., -1.\n", "99, 0., 0., -1.\n98, 0., 0., 2.\n"));
    assert!(!told(&unused, &["same place"]));
}

/// Two cantilevers in each other, a tube element at the inner tip.
const TUBES: &str = "\
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 2., 0., 0.
11, 0., 0., 0.
12, 1., 0., 0.
13, 2., 0., 0.
*ELEMENT, TYPE=B33, ELSET=INNER
1, 1, 2
2, 2, 3
*ELEMENT, TYPE=B33, ELSET=OUTER
11, 11, 12
12, 12, 13
*BEAM GENERAL SECTION, ELSET=INNER, SECTION=GENERAL
1., 1., 0., 1., 2.
0., 0., 1.
1000., 400.
*BEAM GENERAL SECTION, ELSET=OUTER, SECTION=GENERAL
1., 1., 0., 1., 2.
0., 0., 1.
1000., 400.
*ELEMENT, TYPE=ITT31, ELSET=TUBES
21, 3
*INTERFACE, ELSET=TUBES
0.1
*SLIDE LINE, ELSET=TUBES, TYPE=LINEAR
11, 12, 13
*BOUNDARY
1, 1, 6
11, 1, 6
*STEP
*STATIC
*END STEP
";

/// All nodes of the inner tube lie in the outer one; two nodes of a tube that is cut are a crack beside it.
#[test]
fn tubes_in_each_other_are_no_crack() {
    assert!(!told(&model(TUBES), &["same place"]));
    let cut = TUBES.replace("13, 2., 0., 0.\n", "13, 2., 0., 0.\n15, 1., 0., 0.\n").replace("12, 12, 13", "12, 15, 13");
    let cut = model(&cut.replace("11, 12, 13\n*BOUNDARY", "11, 12, 13\n*BOUNDARY\n15, 1, 6"));
    assert!(told(&cut, &["warning: 2 pairs of nodes lie at the same place", "nodes 2 and 15"]), "{:?}", cut.notes);
    let apart = TUBES
        .replace("*ELEMENT, TYPE=ITT31", "*NODE\n5, 2., 3., 0.\n*ELEMENT, TYPE=ITT31")
        .replace("21, 3\n", "21, 5\n");
    assert!(told(&model(&apart), &["warning: 3 pairs of nodes"]), "{:?}", model(&apart).notes);
}
