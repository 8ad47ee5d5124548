//! Each deck of `tests/bad` is refused with the message beside it. `BLESS=1` writes the messages anew.

use fe_io::{Deck, Library, resolve};
use std::fs;
use std::path::PathBuf;

#[test]
fn bad_decks_are_refused_with_the_message_beside_them() {
    let bless = std::env::var_os("BLESS").is_some();
    let entries = fs::read_dir("tests/bad").expect("the folder is part of the crate");
    let mut decks: Vec<PathBuf> = entries.map(|entry| entry.expect("it is readable").path()).collect();
    decks.retain(|path| path.extension().is_some_and(|extension| extension == "inp"));
    decks.sort();
    assert!(decks.len() >= 20, "{} decks", decks.len());
    let mut differ = Vec::new();
    for deck in decks {
        let answer = Deck::read(&deck).and_then(|deck| resolve(&deck, &Library::default()));
        let Err(diagnostics) = answer else { panic!("{} is not refused", deck.display()) };
        assert!(diagnostics.faults() > 0, "{}", deck.display());
        let message = format!("{diagnostics}\n");
        let golden = deck.with_extension("txt");
        if bless {
            fs::write(&golden, &message).expect("the folder is writable");
        }
        if fs::read_to_string(&golden).unwrap_or_default() != message {
            differ.push(format!("{}:\n{message}", golden.display()));
        }
    }
    assert!(differ.is_empty(), "messages differ (BLESS=1 writes them anew):\n{}", differ.join("\n"));
}
