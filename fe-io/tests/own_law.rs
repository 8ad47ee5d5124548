//! A law that a program adds is held to its word before it is used.

use fe_contact::law::{Datum, LawDefinition, Laws, Lines, NormalLaw, NormalResponse};
use fe_io::{Deck, Library, resolve};
use std::sync::Arc;

/// p = K h², with its slope wrong by a factor.
#[derive(Debug)]
struct Square {
    wrong: f64,
}

impl NormalLaw for Square {
    fn respond(&self, gap: f64) -> NormalResponse {
        let h = (-gap).max(0.0);
        NormalResponse { energy: h.powi(3) / 3.0, pressure: h * h, stiffness: self.wrong * 2.0 * h }
    }
}

const SQUARE: LawDefinition = LawDefinition {
    keyword: "SQUARE",
    summary: "p = h^2",
    source: "this test",
    data: &[Datum::positive("factor", "-", "factor on the slope, 1 where it is right")],
    lines: Lines::One,
    example: &[1.0],
    build: |data| Ok(Arc::new(Square { wrong: data[0] })),
};

#[test]
fn a_law_that_breaks_its_word_is_refused() {
    let library = Library { laws: Laws::standard().with(SQUARE) };
    let deck = |data: &str| {
        let text = include_str!("bad/law_linear.inp");
        let (before, after) = text.split_once("*SURFACE INTERACTION").expect("the deck has one");
        let (_, after) = after.split_once("*CONTACT PAIR").expect("the deck has a pair");
        let behavior = "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=SQUARE";
        format!("{before}{behavior}\n{data}\n*CONTACT PAIR{after}")
    };
    let answer = |data: &str| Deck::from_text("own.inp", &deck(data)).and_then(|deck| resolve(&deck, &library));
    assert!(answer("1.").is_ok(), "{:?}", answer("1.").err());
    for wrong in ["1.001", "0.9", "3."] {
        let message = answer(wrong).expect_err("it is wrong").to_string();
        assert!(message.contains("law `SQUARE` breaks its word: at a gap of -"), "{message}");
        assert!(message.contains("the slope of the pressure says"), "{message}");
    }
}
