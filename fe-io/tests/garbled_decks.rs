//! Decks with characters deleted, doubled and exchanged: whatever comes, an answer or messages, never a panic.

use fe_io::{Deck, Library, resolve};

/// A linear congruential generator (Knuth, MMIX): the same numbers on every machine.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as usize) % limit.max(1)
    }
}

const CHARACTERS: &[char] = &['*', ',', '=', '"', '\n', '\r', '\t', ' ', '-', '.', '0', '9', 'e', 'S', 'é', '\0', '７'];

fn garbled(deck: &str, numbers: &mut Numbers) -> String {
    let mut characters: Vec<char> = deck.chars().collect();
    for _ in 0..1 + numbers.below(6) {
        let at = numbers.below(characters.len());
        match numbers.below(5) {
            0 => drop(characters.remove(at)),
            1 => characters.insert(at, CHARACTERS[numbers.below(CHARACTERS.len())]),
            2 => characters[at] = CHARACTERS[numbers.below(CHARACTERS.len())],
            3 => {
                let end = (at + numbers.below(60)).min(characters.len());
                let piece: Vec<char> = characters[at..end].to_vec();
                let to = numbers.below(characters.len());
                characters.splice(to..to, piece);
            }
            _ => {
                let end = (at + numbers.below(30)).min(characters.len());
                characters.drain(at..end);
            }
        }
        if characters.is_empty() {
            break;
        }
    }
    characters.into_iter().collect()
}

#[test]
fn garbled_decks_never_panic() {
    let good = [
        include_str!("good/plain.inp"),
        include_str!("good/odd.inp"),
        include_str!("good/contact.inp"),
        include_str!("good/requests.inp"),
        include_str!("good/behaviors.inp"),
        include_str!("bad/law_formula_words.inp"),
        include_str!("bad/rigid_profile.inp"),
        include_str!("bad/loads.inp"),
        include_str!("bad/controls.inp"),
    ];
    let mut numbers = Numbers(2024);
    let (mut sound, mut refused) = (0, 0);
    for round in 0..2000 {
        let text = garbled(good[round % good.len()], &mut numbers);
        match Deck::from_text("garbled.inp", &text).and_then(|deck| resolve(&deck, &Library::default())) {
            Ok(_) => sound += 1,
            Err(faults) => {
                refused += 1;
                assert!(faults.faults() > 0 && !faults.to_string().is_empty(), "{text}");
            }
        }
    }
    // Both kinds come up, so that neither way is left untried.
    assert!(sound > 20 && refused > 500, "{sound} sound, {refused} refused");
}
