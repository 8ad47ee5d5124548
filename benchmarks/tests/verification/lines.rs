//! Decks of trusses and beams through the program.

use benchmarks::hard::{Place, Run, Solved};
use std::fmt::Write;
use std::path::Path;

/// Relative bound of a discrete problem that has the closed answer.
pub const ALGEBRAIC: f64 = 1e-10;

/// The bound of forces of multipliers between beams in n parts: a condition number above 1e4 adds to it in proportion. The
/// penalty that finds them is a thousand times the stiffness at a node, 24 EI/h³, the beam's own 48 EI/L³.
pub fn of_forces(parts: usize) -> f64 {
    ALGEBRAIC * (500.0 * (parts as f64).powi(3) * 1e-4).max(1.0)
}

/// Runs a deck, which must come to its end, in a folder of its own.
pub fn solve(name: &str, deck: &str) -> (Run, Solved) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verification").join(name);
    let run = Place::new(folder).run("job", deck);
    assert!(run.ended.is_ok(), "{name}: {:?}", run.ended.as_ref().err());
    let solved = run.solved().unwrap();
    (run, solved)
}

/// Elements in a row from node to node; labels of both ascend from `first`. The nodes are the set `N_` of the name.
pub fn row(element: &str, set: &str, first: usize, places: &[[f64; 3]]) -> String {
    let mut cards = format!("*NODE, NSET=N_{set}\n");
    for (i, [x, y, z]) in places.iter().enumerate() {
        let _ = writeln!(cards, "{}, {x:?}, {y:?}, {z:?}", first + i);
    }
    let _ = writeln!(cards, "*ELEMENT, TYPE={element}, ELSET={set}");
    (first..first + places.len() - 1).for_each(|i| _ = writeln!(cards, "{i}, {i}, {}", i + 1));
    cards
}

/// Places along x, of these heights in the plane.
pub fn along_x(stations: &[f64], y: f64) -> Vec<[f64; 3]> {
    stations.iter().map(|&x| [x, y, 0.0]).collect()
}

/// n equal parts of a length.
pub fn parts(length: f64, n: usize) -> Vec<f64> {
    (0..=n).map(|i| length * i as f64 / n as f64).collect()
}

/// A beam section [L², L⁴, L⁴] with a modulus; its first axis is along z.
pub fn section(set: &str, [area, inertia]: [f64; 2], young: f64) -> String {
    let (torsion, shear) = (2.0 * inertia, young / 2.6);
    format!(
        "*BEAM GENERAL SECTION, ELSET={set}, SECTION=GENERAL\n{area:?}, {inertia:?}, 0., {inertia:?}, {torsion:?}\n\
         0., 0., 1.\n{young:?}, {shear:?}\n"
    )
}

/// One step in one increment, down to round-off.
pub fn step(loads: &str) -> String {
    format!("*STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n{loads}*END STEP\n")
}

/// Force [F] of a point: the law's number times its measure.
pub fn forces(solved: &Solved) -> Vec<f64> {
    solved.pairs.iter().flat_map(|pair| &pair.points).map(|point| point.pressure * point.measure.value()).collect()
}

/// The relative error is below a bound.
pub fn close(what: &str, found: f64, exact: f64, bound: f64) {
    let error = (found / exact - 1.0).abs();
    eprintln!("{what}: {found:.12e}, error {error:.1e} of {bound:.1e}");
    assert!(error <= bound, "{what}: {found}, not {exact}");
}
