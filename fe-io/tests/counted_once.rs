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
