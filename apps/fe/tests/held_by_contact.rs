//! Bodies that contact alone holds: told about, brought into touch without strain, pressed by force.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use fe_io::results::read::tables;

/// Two unit cubes, E = 1000, the upper one `clearance` above the lower one and free along z; a pressure on its top.
fn cubes(clearance: f64, pressure: f64, pair: &str) -> String {
    let mut nodes = String::new();
    for (first, z) in [(1, 0.0), (11, 1.0 + clearance)] {
        for (k, (x, y, up)) in
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)].iter().enumerate()
        {
            nodes += &format!("{}, {x}., {y}., {}\n", first + k, z + f64::from(*up));
        }
    }
    format!(
        "*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D8, ELSET=LOWER\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         *ELEMENT, TYPE=C3D8, ELSET=UPPER\n2, 11, 12, 13, 14, 15, 16, 17, 18\n\
         *NSET, NSET=BOTTOM\n1, 2, 3, 4\n*NSET, NSET=XSYM\n1, 4, 5, 8, 11, 14, 15, 18\n\
         *NSET, NSET=YSYM\n1, 2, 5, 6, 11, 12, 15, 16\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
         *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n\
         *SURFACE, NAME=SEC\nUPPER, S1\n*SURFACE, NAME=MAIN\nLOWER, S2\n*SURFACE, NAME=TOP\nUPPER, S2\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2000.\n{pair}\
         *BOUNDARY\nBOTTOM, 3\nXSYM, 1\nYSYM, 2\n\
         *STEP\n*STATIC\n1., 1.\n*DSLOAD\nTOP, P, {pressure}\n\
         *NODE PRINT, NSET=BOTTOM, TOTALS=YES\nRF\n*CONTACT PRINT\nCSTRESS, CDISP\n*END STEP\n"
    )
}

const PAIR: &str = "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSEC, MAIN\n";

/// p = 10 everywhere; U of the top: the clearance, the law's overclosure p/K and both strains p L/E.
#[test]
fn a_pressed_cube_closes_its_clearance_without_strain() {
    let scratch = Scratch::new("held_pressed");
    scratch.write("cubes.inp", &cubes(1e-3, 10.0, PAIR));
    let run = scratch.fe(&["run", "cubes.inp"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let note = run.output.lines().find(|l| l.contains("held by contact alone")).expect("the body is told about");
    assert!(note.contains("body UPPER") && note.contains("along z") && note.contains("-1.000000e-03"), "{note}");
    let results = Results::open(&scratch.path("cubes.vtkhdf"));
    let top = results.point_at([1.0, 1.0, 2.001]);
    let expected = -(1e-3 + 10.0 / 2000.0 + 2.0 * 10.0 / 1000.0);
    let found = results.point_field("U", 3, 1)[3 * top + 2];
    // Four hexahedra's worth of round-off at a condition number of order 10.
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    for block in tables(&scratch.read("cubes.dat")).unwrap() {
        let column = match block.title.as_str() {
            title if title.starts_with("total force") => (2, 10.0),
            title if title.starts_with("contact stress") => (0, 10.0),
            title if title.starts_with("relative contact displacement") => (0, -0.005),
            _ => continue,
        };
        assert!(!block.rows.is_empty());
        for row in block.rows {
            assert!((row.values[column.0] / column.1 - 1.0).abs() < 1e-6, "{row:?}");
        }
    }
}

/// A load that pulls the body away ends with its name and direction, not with a singular matrix.
#[test]
fn a_load_that_pulls_away_is_refused() {
    let scratch = Scratch::new("held_pulled");
    scratch.write("cubes.inp", &cubes(1e-3, -10.0, PAIR));
    let run = scratch.fe(&["run", "cubes.inp", "--quiet"]);
    assert_eq!(run.status, 1);
    for words in ["body UPPER", "along z", "(0.000, 0.000, 1.000)", "no surface"] {
        assert!(run.error.contains(words), "{words}: {}", run.error);
    }
}

/// Without a pair nothing holds it.
#[test]
fn a_body_that_nothing_holds_is_named() {
    let scratch = Scratch::new("held_by_nothing");
    scratch.write("cubes.inp", &cubes(1e-3, 10.0, ""));
    let run = scratch.fe(&["run", "cubes.inp", "--quiet"]);
    assert_eq!(run.status, 1);
    assert!(run.error.contains("nothing holds body UPPER: it is free along z"), "{}", run.error);
    let check = scratch.fe(&["check", "cubes.inp"]);
    assert_eq!(check.status, 0);
    assert!(check.output.contains("held by nothing: free along z"), "{}", check.output);
}

/// More cards of a second step; what a deck says of it replaces the load of the first.
fn second_step(deck: &str, cards: &str) -> String {
    format!("{deck}*STEP\n*STATIC\n0.5, 1.\n{cards}*END STEP\n")
}

/// The load taken away again leaves the cube where it touched: moved by its clearance, without strain.
#[test]
fn a_load_taken_away_leaves_the_body_where_it_touched() {
    let scratch = Scratch::new("held_unloaded");
    scratch.write("cubes.inp", &second_step(&cubes(1e-3, 10.0, PAIR), "*DSLOAD, OP=NEW\n"));
    let run = scratch.fe(&["run", "cubes.inp", "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let results = Results::open(&scratch.path("cubes.vtkhdf"));
    let top = results.point_at([1.0, 1.0, 2.001]);
    let found = results.point_field("U", 3, 3)[3 * top + 2];
    // Round-off of the displacement under load, 0.026, at a condition number of order 10.
    assert!((found + 1e-3).abs() < 1e-15 * 100.0, "{found}");
}

/// A later step pulls the cube off: it presses as long as its load does, and is named where it comes free, at the end of a
/// ramp or where an amplitude turns in the step's middle.
#[test]
fn a_body_that_is_pulled_off_later_is_named() {
    let scratch = Scratch::new("held_pulled_later");
    for (name, cards) in
        [("off", "*DSLOAD, OP=NEW\nTOP, P, -1.\n"), ("turning", "*DSLOAD, OP=NEW, AMPLITUDE=TURNS\nTOP, P, 1.\n")]
    {
        let deck = second_step(&cubes(1e-3, 10.0, PAIR), cards);
        let deck = deck.replacen("*STEP", "*AMPLITUDE, NAME=TURNS\n0., 10., 0.5, -1., 1., 1.\n*STEP", 1);
        scratch.write(&format!("{name}.inp"), &deck);
        let run = scratch.fe(&["run", &format!("{name}.inp"), "--quiet"]);
        assert_eq!(run.status, 1, "{name}");
        for word in ["step 2", "body UPPER", "nothing holds freedom"] {
            assert!(run.error.contains(word), "{name}: {word}: {}", run.error);
        }
    }
}

/// Free to sink and to tilt (one side is held no more), pressed off its middle: it comes to lie on the whole face, and
/// the law takes the moment.
#[test]
fn a_body_that_may_tilt_comes_to_lie() {
    let scratch = Scratch::new("held_tilting");
    let tilting = |support: &str, node: u32| {
        let load = format!("*CLOAD\n{node}, 3, -1.\n");
        cubes(1e-3, 10.0, PAIR)
            .replace("XSYM, 1\nYSYM, 2\n", support)
            .replace("*NODE PRINT", &format!("{load}*NODE PRINT"))
    };
    let tilts = "4, 1\n1, 1\n1, 2\n2, 2\n3, 2\n4, 2\n11, 1\n14, 1\n11, 2\n12, 2\n";
    scratch.write("cubes.inp", &tilting(tilts, 16));
    let run = scratch.fe(&["run", "cubes.inp"]);
    assert_eq!(run.status, 0, "{}", run.error);
    assert!(run.output.contains("about x"), "{}", run.output);
    let results = Results::open(&scratch.path("cubes.vtkhdf"));
    let height = |x: [f64; 3]| results.point_field("U", 3, 1)[3 * results.point_at(x) + 2];
    // The loaded corner is pressed deeper than the one across.
    assert!(height([1.0, 0.0, 2.001]) < height([0.0, 1.0, 2.001]));
    // Nothing holds the upper cube along x now: contact cannot.
    scratch.write("slides.inp", &tilting("1, 1\n4, 1\nYSYM, 2\n", 16));
    let run = scratch.fe(&["run", "slides.inp", "--quiet"]);
    assert_eq!(run.status, 1);
    assert!(run.error.contains("body UPPER") && run.error.contains("cannot hold it that way"), "{}", run.error);
}
