//! How jobs end: increments that are cut back or used up, killed runs, and what then stands in the results.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use fe_io::results::read::tables;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A soft cantilever of `n` squares above a rigid floor, pushed down at its end: unloaded it would go through the
/// floor by fifty times the distance, and the penalty is stiffer than the strip by five orders of magnitude.
fn cantilever(n: usize, load: f64, step: &str) -> String {
    let nodes: String = (0..=n).map(|i| format!("{}, {i}., 0.\n{}, {i}., 1.\n", i + 1, i + 1001)).collect();
    let cells: String = (1..=n).map(|i| format!("{i}, {i}, {}, {}, {}\n", i + 1, i + 1001, i + 1000)).collect();
    format!(
        "*NODE\n{nodes}9999, 0., -5.\n*NSET, NSET=REF\n9999\n*NSET, NSET=ROOT\n1, 1001\n*NSET, NSET=TIP\n{}\n\
         *ELEMENT, TYPE=CPE4, ELSET=E\n{cells}*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=SEC\nE, S1\n*SURFACE, NAME=FLOOR, TYPE=SEGMENTS\n\
         START, -1., -0.2\nLINE, {}., -0.2\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=9999\n\
         *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSEC, FLOOR\n\
         *BOUNDARY\nREF, 1, 2\nREF, 6\nROOT, 1, 2\n{step}*CLOAD\nTIP, 2, -{load}\n\
         *NODE PRINT, NSET=REF\nRF\n*NODE PRINT, NSET=ROOT, TOTALS=ONLY\nRF\n*END STEP\n",
        n + 1001,
        n + 5
    )
}

/// Values of the last row of every table of this title.
fn rows(text: &str, title: &str) -> Vec<(f64, Vec<f64>)> {
    let blocks = tables(text).unwrap().into_iter().filter(|b| b.title.starts_with(title));
    blocks.map(|b| (b.time, b.rows.last().unwrap().values.clone())).collect()
}

/// The floor takes a load that overshoots it by far in one increment, in a handful of iterations.
#[test]
fn a_soft_strip_on_a_stiff_floor_converges_at_once() {
    let scratch = Scratch::new("endings_soft");
    scratch.write("strip.inp", &cantilever(10, 30.0, "*STEP\n*STATIC\n1., 1.\n"));
    let run = scratch.fe(&["run", "strip.inp"]);
    assert_eq!(run.status, 0, "{}{}", run.output, run.error);
    assert!(run.output.contains(" 0 cutbacks"), "{}", run.output);
    let text = scratch.read("strip.dat");
    let (floor, root) = (rows(&text, "forces"), rows(&text, "total force"));
    // Ten printed digits of forces of the load's size.
    assert!((floor[0].1[1] + root[0].1[1] - 30.0).abs() < 1e-7, "{floor:?} {root:?}");
}

/// Statuses that may change in one iteration only (I_S^c = 1): the increment is cut back by D_S, and the end is the
/// same as without; with one attempt, or with increments of fixed size, the job ends with the reason.
#[test]
fn increments_that_are_cut_back() {
    let controls =
        |counts: &str, factors: &str| format!("*CONTROLS, PARAMETERS=TIME INCREMENTATION\n{counts}\n{factors}\n");
    let once = ", , , , , , , , , , 1";
    let scratch = Scratch::new("endings_cut");
    let run = |name: &str, step: String| {
        scratch.write(&format!("{name}.inp"), &cantilever(10, 300.0, &step));
        scratch.fe(&["run", &format!("{name}.inp")])
    };
    let whole = run("whole", "*STEP\n*STATIC\n".into());
    assert!(whole.status == 0 && whole.output.contains(" 0 cutbacks"), "{}{}", whole.output, whole.error);
    for (name, factors, first) in [("default", "", 0.25), ("eighth", ", , , , 0.125", 0.125)] {
        let cut = run(name, format!("*STEP\n*STATIC\n{}", controls(once, factors)));
        assert!(cut.status == 0 && cut.output.contains(" 1 cutbacks"), "{}{}", cut.output, cut.error);
        assert!(cut.output.contains("cut back: ") && cut.output.contains("still change between open and closed"));
        let end = |name: &str| rows(&scratch.read(&format!("{name}.dat")), "forces").last().unwrap().1[1];
        assert_eq!(rows(&scratch.read(&format!("{name}.dat")), "forces")[0].0, first);
        // Ten printed digits.
        assert!((end(name) / end("whole") - 1.0).abs() < 1e-9, "{} {}", end(name), end("whole"));
    }
    let refused = [
        ("one", format!("*STEP\n*STATIC\n{}", controls(", , , , , , , 1, , , 1", "")), "was tried 1 time"),
        ("fixed", format!("*STEP\n*STATIC, DIRECT\n{}", controls(once, "")), "fixed size cannot be cut back"),
        ("small", format!("*STEP\n*STATIC\n1., 1., 0.5\n{}", controls(once, "")), "less than the smallest allowed"),
    ];
    for (name, step, words) in refused {
        let ended = run(name, step);
        assert!(ended.status == 1 && ended.error.contains(words), "{name}: {}", ended.error);
        assert!(ended.error.contains("still change between open and closed") && ended.error.contains("help: "));
        assert_eq!(Results::open(&scratch.path(&format!("{name}.vtkhdf"))).times(), [0.0]);
    }
}

/// `INC=` used up: status 1, the reason with what helps, and the finished increments in file and tables.
#[test]
fn increments_that_are_used_up() {
    let scratch = Scratch::new("endings_used_up");
    scratch.write("strip.inp", &cantilever(10, 30.0, "*STEP, INC=3\n*STATIC\n0.125, 1., , 0.125\n"));
    let run = scratch.fe(&["run", "strip.inp"]);
    assert_eq!(run.status, 1);
    for words in ["step 1 ended", "3 increments are used up", "3.750000e-1 of 1.0", "INC="] {
        assert!(run.error.contains(words), "{words}: {}", run.error);
    }
    let results = Results::open(&scratch.path("strip.vtkhdf"));
    assert_eq!(results.times(), [0.0, 0.125, 0.25, 0.375]);
    assert_eq!(rows(&scratch.read("strip.dat"), "forces").len(), 3);
}

/// Killed in the middle: every finished increment is readable.
#[test]
fn a_killed_run_leaves_its_finished_increments() {
    let scratch = Scratch::new("endings_killed");
    scratch.write("strip.inp", &cantilever(400, 0.02, "*STEP, INC=100000\n*STATIC, DIRECT\n0.0001, 1.\n"));
    let arguments = ["run", "strip.inp", "--quiet", "--threads", "1"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_fe"))
        .args(arguments)
        .current_dir(scratch.path(""))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let tables =
        || std::fs::read_to_string(scratch.path("strip.dat")).map_or(0, |text| text.matches("total force").count());
    let start = Instant::now();
    while tables() < 5 && start.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    assert!(!child.wait().unwrap().success(), "the job was to be killed before its end");
    let printed = tables();
    assert!((5..10000).contains(&printed), "{printed}");
    let results = Results::open(&scratch.path("strip.vtkhdf"));
    let times = results.times();
    // The frame of an increment is complete before its tables; time 0 has a frame too.
    assert!(times.len() >= printed, "{} frames, {printed} tables", times.len());
    for (i, time) in times.iter().enumerate() {
        // Sums of up to 10⁴ equal increments.
        assert!((time - 1e-4 * i as f64).abs() < 1e-12, "frame {i} at {time}");
    }
    let last = results.point_field("U", 3, times.len() - 1);
    let tip = results.point_at([400.0, 1.0, 0.0]);
    assert!(last[3 * tip + 1] < 0.0 && last.iter().all(|v| v.is_finite()));
}

/// Frames and tables as often as asked for, and the last of a step; only the fields that are asked for.
#[test]
fn chosen_fields_and_frequencies() {
    let scratch = Scratch::new("endings_chosen");
    let step = "*STEP\n*STATIC, DIRECT\n0.125, 1.\n*OUTPUT, FIELD, FREQUENCY=3\n*NODE OUTPUT\nU\n\
                *CONTACT OUTPUT\nCSTRESS\n*CONTACT PRINT, FREQUENCY=5\nCF\n";
    scratch.write("strip.inp", &cantilever(10, 30.0, step));
    let run = scratch.fe(&["run", "strip.inp", "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let results = Results::open(&scratch.path("strip.vtkhdf"));
    assert_eq!(results.times(), [0.0, 0.375, 0.75, 1.0]);
    let names = results.names("VTKHDF/PointData");
    assert!(["U", "CPRESS"].iter().all(|n| names.contains(&n.to_string())), "{names:?}");
    assert!(["RF", "S", "E", "MISES", "COPEN"].iter().all(|n| !names.contains(&n.to_string())), "{names:?}");
    let text = scratch.read("strip.dat");
    let times: Vec<f64> = rows(&text, "total surface force").iter().map(|r| r.0).collect();
    assert_eq!(times, [0.625, 1.0]);
    assert_eq!(rows(&text, "forces").len(), 8);
}

/// A load that moves the strip beyond all numbers: the gap that is none is named by the label of its node.
#[test]
fn a_gap_that_is_no_number_is_named_by_its_node() {
    let scratch = Scratch::new("endings_not_finite");
    let deck = cantilever(2, 1e308, "*STEP\n*STATIC\n1., 1., 1., 1.\n").replace("1000., 0.3", "1e-5, 0.3");
    scratch.write("strip.inp", &deck);
    let run = scratch.fe(&["run", "strip.inp"]);
    assert_eq!(run.status, 1);
    for words in ["not finite", "the gaps of SEC on FLOOR at node ", "extreme numbers"] {
        assert!(run.error.contains(words), "{words}: {}", run.error);
    }
    let digits = run.error.split("at node ").nth(1).unwrap().split(|c: char| !c.is_ascii_digit()).next().unwrap();
    let label: u32 = digits.parse().unwrap();
    assert!((1..=3).contains(&label), "the nodes of SEC are 1 to 3: {}", run.error);
}
