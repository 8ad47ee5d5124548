//! The manual as it is printed; `BLESS=1` writes `tests/manual.txt` anew.

use fe_contact::law::Laws;
use fe_io::keyword::CARDS;
use fe_io::manual;
use std::fs;

#[test]
fn the_manual_is_that_of_the_tables() {
    let mut text = manual::list();
    for card in CARDS {
        text.push_str("\n----\n");
        text.push_str(&manual::card(card.name, &Laws::standard()).expect("it is in the list"));
    }
    if std::env::var_os("BLESS").is_some() {
        fs::write("tests/manual.txt", &text).expect("the folder is writable");
    }
    let golden = fs::read_to_string("tests/manual.txt").unwrap_or_default();
    assert!(golden == text, "the manual differs (BLESS=1 writes it anew):\n{text}");
}

#[test]
fn other_words_are_answered_too() {
    let laws = Laws::standard();
    let of = |name: &str| manual::card(name, &laws);
    assert!(of("*surfacebehavior").is_ok_and(|text| text.contains("slope [F/L³]")));
    assert!(of("change contact type").is_ok_and(|text| text.contains("not there yet")));
    assert!(of("PREPRINT").is_ok_and(|text| text.contains("no effect")));
    assert!(of("BOUNDRY").is_err_and(|text| text.contains("*BOUNDARY")));
}
