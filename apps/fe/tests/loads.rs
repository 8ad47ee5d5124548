//! Loads, supports and amplitudes through the steps of a deck: reactions are what is applied, displacements those of
//! a bar. A unit cube of E = 1000, ν = 0 and ϱ = 2, its foot held: u = F / 1000 at the top.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;
use fe_io::results::read::Table;

const CUBE: &str = "\
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
*ELEMENT, TYPE=C3D8, ELSET=E
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=FOOT
1, 2, 3, 4
*NSET, NSET=TOP
5, 6, 7, 8
*MATERIAL, NAME=M
*ELASTIC
1000., 0.
*DENSITY
2.
*SOLID SECTION, ELSET=E, MATERIAL=M
*SURFACE, NAME=LID
E, S2
*AMPLITUDE, NAME=STEPS
0., 0., 0.5, 1., 0.75, 0.25
*AMPLITUDE, NAME=TOTAL, TIME=TOTAL TIME
0.5, 0., 1.5, 1.
*BOUNDARY
FOOT, 1, 3
";

const PRINTS: &str = "*NODE PRINT, NSET=FOOT, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=TOP\nU\n";

/// Time, total reaction of the foot and mean displacement of the top, of every increment.
fn history(name: &str, steps: &str) -> Vec<(f64, [f64; 3], [f64; 3])> {
    let blocks = Job::run(name, &format!("{CUBE}{steps}")).tables();
    let of = |title: &'static str| blocks.iter().filter(move |b| b.title.starts_with(title));
    let mean = |block: &Table| -> [f64; 3] {
        let rows = block.rows.len() as f64;
        std::array::from_fn(|c| block.rows.iter().map(|r| r.values[c]).sum::<f64>() / rows)
    };
    of("total force").zip(of("displacements")).map(|(f, u)| (f.time, mean(f), mean(u))).collect()
}

/// The third components against (time, reaction, displacement). Ten printed digits of numbers up to ten.
fn agrees(found: &[(f64, [f64; 3], [f64; 3])], expected: &[(f64, f64, f64)]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (got, want) in found.iter().zip(expected) {
        let near = |a: f64, b: f64, size: f64| (a - b).abs() < 1e-8 * size;
        let fits = near(got.0, want.0, 1.0) && near(got.1[2], want.1, 1.0) && near(got.2[2], want.2, 1e-3);
        assert!(fits, "{got:?}, not {want:?}");
    }
}

/// Forces on nodes, a pressure on faces and on a surface, and gravity: 8 down each. Gravity stretches as half of it.
#[test]
fn reactions_are_what_is_applied() {
    for (card, u) in [
        ("*CLOAD\nTOP, 3, -2.\n", -8e-3),
        ("*DLOAD\nE, P2, 8.\n", -8e-3),
        ("*DSLOAD\nLID, P, 8.\n", -8e-3),
        ("*DLOAD\nE, GRAV, 4., 0., 0., -3.\n", -4e-3),
        ("*DLOAD\n, GRAV, 4., 0., 0., -1.\n", -4e-3),
        // Cards of one step add up.
        ("*CLOAD\nTOP, 3, -1.\n*DSLOAD\nLID, P, 4.\n", -8e-3),
    ] {
        let found = history("loads_kinds", &format!("*STEP\n*STATIC\n0.5, 1.,,0.5\n{card}{PRINTS}*END STEP\n"));
        agrees(&found, &[(0.5, 4.0, 0.5 * u), (1.0, 8.0, u)]);
        assert!(found.iter().all(|f| f.1[0].abs() + f.1[1].abs() < 1e-9), "{card}{found:?}");
    }
}

/// A load stays in later steps, changes from its old value, goes over the step when `OP=NEW` takes it away.
#[test]
fn loads_through_steps() {
    let step = |cards: &str| format!("*STEP\n*STATIC, DIRECT\n0.5, 1.\n{cards}*END STEP\n");
    let found = history(
        "loads_steps",
        &[
            step(&format!("*CLOAD\nTOP, 3, -2.\n{PRINTS}")),
            step(""),
            step("*CLOAD\nTOP, 3, -1.\n"),
            step("*DSLOAD\nLID, P, 4.\n"),
            step("*CLOAD, OP=NEW\n5, 3, 0.\n"),
            step("*DSLOAD, OP=NEW\nLID, P, -2.\n"),
        ]
        .concat(),
    );
    let reactions = [4.0, 8.0, 8.0, 8.0, 6.0, 4.0, 6.0, 8.0, 6.0, 4.0, 1.0, -2.0];
    let expected: Vec<_> = (1..).zip(reactions).map(|(i, r)| (0.5 * f64::from(i), r, -1e-3 * r)).collect();
    agrees(&found, &expected);
}

/// A prescribed displacement, held, changed, and released: its reaction fades over the step.
#[test]
fn supports_through_steps() {
    let step = |cards: &str| format!("*STEP\n*STATIC, DIRECT\n0.5, 1.\n{cards}*END STEP\n");
    let found = history(
        "loads_supports",
        &[
            step(&format!("*BOUNDARY\nTOP, 3, 3, -0.01\n{PRINTS}")),
            step(""),
            step("*BOUNDARY\nTOP, 3, 3, -0.004\n"),
            step("*BOUNDARY, OP=NEW\nFOOT, 1, 3\n"),
        ]
        .concat(),
    );
    let ways = [5.0, 10.0, 10.0, 10.0, 7.0, 4.0, 2.0, 0.0];
    let expected: Vec<_> = (1..).zip(ways).map(|(i, r)| (0.5 * f64::from(i), r, -1e-3 * r)).collect();
    agrees(&found, &expected);
}

/// Linear between the points of an amplitude, constant outside; in step time and in total time.
#[test]
fn amplitudes() {
    let step = |cards: &str| format!("*STEP\n*STATIC, DIRECT\n0.25, 1.\n{cards}*END STEP\n");
    let found = history("loads_amplitude", &step(&format!("*CLOAD, AMPLITUDE=STEPS\nTOP, 3, -2.\n{PRINTS}")));
    agrees(&found, &[(0.25, 4.0, -4e-3), (0.5, 8.0, -8e-3), (0.75, 2.0, -2e-3), (1.0, 2.0, -2e-3)]);
    let two = step(&format!("*DSLOAD, AMPLITUDE=TOTAL\nLID, P, 8.\n{PRINTS}")) + &step("");
    let reactions = [0.0, 0.0, 2.0, 4.0, 6.0, 8.0, 8.0, 8.0];
    let expected: Vec<_> = (1..).zip(reactions).map(|(i, r)| (0.25 * f64::from(i), r, -1e-3 * r)).collect();
    agrees(&history("loads_total_time", &two), &expected);
    let moved = step(&format!("*BOUNDARY, AMPLITUDE=STEPS\nTOP, 3, 3, -0.008\n{PRINTS}"));
    agrees(
        &history("loads_moved", &moved),
        &[(0.25, 4.0, -4e-3), (0.5, 8.0, -8e-3), (0.75, 2.0, -2e-3), (1.0, 2.0, -2e-3)],
    );
}
