//! What a run leaves in the results file.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;

/// The blocks under a LINEAR law (closed form in the deck's header): frames from time 0 on, and the fields.
#[test]
fn the_file_holds_frames_and_fields() {
    let scratch = Scratch::with_decks("results_fields");
    let run = scratch.fe(&["run", "blocks_linear_s2s.inp", "--quiet"]);
    assert_eq!((run.status, run.output.as_str()), (0, ""), "{}", run.error);
    let results = Results::open(&scratch.path("blocks_linear_s2s.vtkhdf"));
    assert_eq!(results.times(), [0.0, 0.25, 0.5, 0.75, 1.0]);
    let top = results.point_at([4.0, 4.0, 5.0]);
    // The end of a ramp is exact.
    assert_eq!(results.point_field("U", 3, 4)[3 * top + 2], -0.05);
    assert_eq!(results.point_field("U", 3, 0)[3 * top + 2], 0.0);
    // p = U / (1/K + L/E), twice: at half time and at the end; a well-conditioned system of 192 unknowns.
    let pressure = 0.05 / (1.0 / 2000.0 + 5.0 / 1000.0);
    let contact = results.point_at([4.0 / 3.0 - 1e-11 / 3.0, 4.0 / 3.0, 2.0]);
    for (frame, part) in [(2, 0.5), (4, 1.0)] {
        let found = results.point_field("CPRESS", 1, frame)[contact];
        assert!((found / (part * pressure) - 1.0).abs() < 1e-9, "{found}");
    }
    let foot = results.point_at([0.0, 0.0, 0.0]);
    assert!(results.point_field("CPRESS", 1, 4)[foot].is_nan());
    let stress = results.point_field("S", 6, 4);
    assert!((stress[6 * foot + 2] / -pressure - 1.0).abs() < 1e-9);
    assert!((results.point_field("MISES", 1, 4)[foot] / pressure - 1.0).abs() < 1e-9);
    let reaction: f64 = results.point_field("RF", 3, 4).chunks_exact(3).map(|r| r[2]).sum();
    assert!(reaction.abs() < 1e-9 * 16.0 * pressure);
}

/// Two instances of one part of 27 nodes and 8 elements: both have the labels of the part, and their own number.
#[test]
fn instances_have_the_labels_of_their_part() {
    let scratch = Scratch::with_decks("results_parts");
    let run = scratch.fe(&["run", "parts_assembly.inp", "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let results = Results::open(&scratch.path("parts_assembly.vtkhdf"));
    for (labels, group, count) in [("NodeLabel", "PointData", 27), ("ElementLabel", "CellData", 8)] {
        let part: Vec<i64> = (1..=count).collect();
        assert_eq!(results.integer(&format!("VTKHDF/{group}/{labels}")), [part.clone(), part].concat());
        let expected = [vec![1; count as usize], vec![2; count as usize]].concat();
        assert_eq!(results.integer(&format!("VTKHDF/{group}/Instance")), expected);
        assert_eq!(results.integer(&format!("VTKHDF/Steps/{group}Offsets/Instance"))[0], 0);
    }
    // The upper end of the turned instance is the foot of the part.
    let foot = results.point_at([0.0, 2.0, 6.0]);
    assert_eq!((results.integer("VTKHDF/PointData/NodeLabel")[foot], foot), (1, 27));
    let flat = scratch.fe(&["run", "blocks_linear_s2s.inp", "--quiet"]);
    assert_eq!(flat.status, 0, "{}", flat.error);
    let names = Results::open(&scratch.path("blocks_linear_s2s.vtkhdf")).names("VTKHDF/PointData");
    assert!(!names.iter().any(|name| name == "Instance"), "{names:?}");
}

/// A deck with a fault leaves the results of an earlier run alone.
#[test]
fn a_faulty_deck_leaves_earlier_results() {
    let scratch = Scratch::with_decks("results_kept");
    assert_eq!(scratch.fe(&["run", "patch_c3d8.inp", "--quiet"]).status, 0);
    let before = std::fs::read(scratch.path("patch_c3d8.vtkhdf")).unwrap();
    scratch.write("patch_c3d8.inp", &scratch.read("patch_c3d8.inp").replace("*STATIC", "*STATICS"));
    assert_eq!(scratch.fe(&["run", "patch_c3d8.inp", "--quiet"]).status, 1);
    assert_eq!(std::fs::read(scratch.path("patch_c3d8.vtkhdf")).unwrap(), before);
}
