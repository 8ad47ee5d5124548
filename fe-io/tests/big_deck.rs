//! A large deck in a fair time. `cargo test -p fe-io --release --test big_deck -- --ignored --nocapture` measures.

use fe_io::{Deck, Library, resolve};
use std::fmt::Write;
use std::time::Instant;

/// n × n × n bricks.
fn bricks(n: usize) -> String {
    let node = |i: usize, j: usize, k: usize| 1 + i + (n + 1) * (j + (n + 1) * k);
    let mut deck = String::from("*NODE, NSET=ALL\n");
    for k in 0..=n {
        for j in 0..=n {
            for i in 0..=n {
                let at = |i: usize| i as f64 * 0.1234567;
                let _ = writeln!(deck, "{}, {:.7}, {:.7}, {:.7}", node(i, j, k), at(i), at(j), at(k));
            }
        }
    }
    deck.push_str("*ELEMENT, TYPE=C3D8, ELSET=BODY\n");
    let mut label = 0;
    for k in 0..n {
        for j in 0..n {
            for i in 0..n {
                label += 1;
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
                let face = |k: usize| corners.map(|(a, b)| node(i + a, j + b, k));
                let [a, b] = [face(k), face(k + 1)];
                let nodes: Vec<String> = a.iter().chain(&b).map(usize::to_string).collect();
                let _ = writeln!(deck, "{label}, {}", nodes.join(", "));
            }
        }
    }
    deck.push_str("*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=BODY, MATERIAL=M\n");
    deck.push_str("*BOUNDARY\n1, 1, 3\n*STEP\n*STATIC\n*END STEP\n");
    deck
}

#[test]
fn all_of_a_large_deck_is_read() {
    let text = bricks(20);
    let deck = Deck::from_text("bricks.inp", &text).expect("the deck is sound");
    let model = resolve(&deck, &Library::default()).unwrap_or_else(|faults| panic!("{faults}"));
    assert_eq!(model.structure.mesh.points.len(), 21 * 21 * 21);
    assert_eq!(model.structure.mesh.cell_count(), 20 * 20 * 20);
    assert_eq!(model.structure.mesh.points[9260], [20.0 * 0.1234567; 3]);
}

#[test]
#[ignore = "measures; for release builds"]
#[allow(clippy::print_stdout)]
fn speed() {
    let text = bricks(100);
    let megabytes = text.len() as f64 / 1e6;
    for _ in 0..3 {
        let start = Instant::now();
        let deck = Deck::from_text("bricks.inp", &text).expect("the deck is sound");
        let scanned = start.elapsed().as_secs_f64();
        let model = resolve(&deck, &Library::default()).unwrap_or_else(|faults| panic!("{faults}"));
        let all = start.elapsed().as_secs_f64();
        let (cells, cards) = (model.structure.mesh.cell_count(), megabytes / scanned);
        println!(
            "{megabytes:.1} MB, {cells} elements: cards {cards:.0} MB/s, model {:.0} MB/s ({all:.2} s)",
            megabytes / all
        );
    }
}
