//! A08, A09, A13, A16: trusses and beams that touch, hard by multipliers. Cubic beams under forces at their nodes are
//! exact, so that the answers are those of beam theory.

use crate::lines::{ALGEBRAIC, along_x, close, forces, of_forces, parts, row, section, solve, step};

/// Small displacements; with large ones N = 2980.5879950756175, which waits for them.
#[test]
fn A08_two_bar_truss_on_gap() {
    let deck = row("T3D2", "BARS", 1, &[[-1000.0, 0.0, 0.0], [0.0, 0.0, 100.0], [1000.0, 0.0, 0.0]])
        + "*NODE\n9, 0., 0., 0.\n*ELEMENT, TYPE=GAPUNI, ELSET=STOP\n9, 9, 2\n*GAP, ELSET=STOP\n1., 0., 0., 1.\n\
           *MATERIAL, NAME=M\n*ELASTIC\n1e6, 0.\n*SOLID SECTION, ELSET=BARS, MATERIAL=M\n1.\n\
           *BOUNDARY\n1, 1, 3\n3, 1, 3\n9, 1, 3\n2, 2\n"
        + &step("*CLOAD\n2, 3, -3000.\n");
    let (_, solved) = solve("two_bars", &deck);
    close("A08 N", forces(&solved)[0], 2980.2962932631685, ALGEBRAIC);
    close("A08 way", solved.displacement(2).unwrap()[2], -1.0, ALGEBRAIC);
}

/// Stations of a beam whose halves have so many elements.
fn halves(length: f64, [left, right]: [usize; 2]) -> Vec<f64> {
    let half = |n| parts(0.5 * length, n);
    half(left).into_iter().map(|x| x - 0.5 * length).chain(half(right).into_iter().skip(1)).collect()
}

/// The same at any division.
#[test]
fn A09_crossing_beams() {
    for (upper, lower) in [([1, 1], [1, 1]), ([2, 3], [4, 1]), ([5, 5], [3, 7]), ([10, 10], [10, 10])] {
        let along: Vec<[f64; 3]> = halves(1000.0, upper).into_iter().map(|x| [x, 0.0, 10.0]).collect();
        let across: Vec<[f64; 3]> = halves(800.0, lower).into_iter().map(|y| [0.0, y, 0.0]).collect();
        let (top, bottom) = (1 + upper[0], 101 + lower[0]);
        let ends = [1, along.len(), 101, 100 + across.len()];
        let deck = row("B33", "UP", 1, &along)
            + &row("B33", "LOW", 101, &across)
            + &section("UP", [600.0, 2e4], 2.1e5)
            + &section("LOW", [900.0, 3e4], 2.1e5)
            + &format!(
                "*ELEMENT, TYPE=GAPUNI, ELSET=G\n201, {bottom}, {top}\n*GAP, ELSET=G\n2., 0., 0., 1.\n*BOUNDARY\n\
                 {}, 1, 4\n{}, 1, 4\n{}, 1, 3\n{}, 1, 3\n{}, 5\n{}, 5\n",
                ends[0], ends[1], ends[2], ends[3], ends[2], ends[3]
            )
            + &step(&format!("*CLOAD\n{top}, 3, -1500.\n"));
        let (_, solved) = solve(&format!("crossing_{}_{}", along.len(), across.len()), &deck);
        let what = format!("A09 {upper:?} {lower:?}");
        let finest = 2 * upper.into_iter().chain(lower).max().unwrap();
        close(&format!("{what} N"), forces(&solved)[0], 817.6938369781312, of_forces(finest));
        close(&format!("{what} w₁"), solved.displacement(top as u64).unwrap()[2], -3.3844551737196, ALGEBRAIC);
        close(&format!("{what} w₂"), solved.displacement(bottom as u64).unwrap()[2], -1.3844551737196, ALGEBRAIC);
    }
}

/// Two beams in the plane on each other, in n parts each; SPOS is on the left of the way along x.
fn parallel(n: usize, kind: &str) -> String {
    let stations = parts(1000.0, n);
    row("B23", "LOW", 1, &along_x(&stations, 0.0))
        + &row("B23", "UP", 101, &along_x(&stations, 0.0))
        + &section("LOW", [900.0, 3e4], 2.1e5)
        + &section("UP", [600.0, 2e4], 2.1e5)
        + &format!(
            "*SURFACE, NAME=TOP\nLOW, SPOS\n*SURFACE, NAME=FOOT\nUP, SNEG\n*SURFACE INTERACTION, NAME=I\n\
             *SURFACE BEHAVIOR, DIRECT\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nFOOT, TOP\n\
             *BOUNDARY\n1, 1, 2\n101, 1, 2\n{}, 2\n{}, 2\n{}",
            n + 1,
            n + 101,
            step("*DLOAD\nUP, PY, -4.\n")
        )
}

/// A share I₂/(I₁ + I₂) of the load passes, but for an end effect of nodal multipliers: with cubic beams on matching
/// nodes the forces deviate by ½ r, −½ r², ½ r³ … of it from the supports inward, r = 2 − √3. (By the equation of three
/// moments the difference of the beams' curvatures, 0 at the ends, has d(i−1) + 4 d(i) + d(i+1) = 0 in what is not
/// constant; of n elements d(i) = −½ ((−r)^i + (−r)^(n−i)) / (1 + (−r)^n).) Supported nodes say the same as contact there.
#[test]
fn A13_parallel_beams() {
    let ratio = 2.0 - 3f64.sqrt();
    for n in [2, 4, 10, 24] {
        let (run, solved) = solve(&format!("parallel_{n}"), &parallel(n, "NODE TO SURFACE"));
        let bound = of_forces(n);
        let middle = solved.displacement(101 + n as u64 / 2).unwrap()[1];
        close(&format!("A13 {n} middle"), middle, -4.9603174603174605, bound);
        let told = run.plans.iter().any(|plan| plan.contains("2 multipliers say"));
        assert!(told, "{:?}", run.plans);
        let points = &solved.pairs[0].points;
        assert_eq!(points.len(), n + 1);
        let tail = |i: usize| -0.5 * (-ratio).powi(i as i32);
        let worst = (1..n).map(|i| {
            let deviation = (tail(i) + tail(n - i)) / (1.0 + (-ratio).powi(n as i32));
            (points[i].pressure / (2.4 * (1.0 + deviation)) - 1.0).abs()
        });
        let worst = worst.fold(0.0, f64::max);
        eprintln!("A13 {n} forces: error {worst:.1e} of {bound:.1e}");
        assert!(worst < bound);
        if n == 24 {
            let deviations = [1, 2, 3].map(|i| 100.0 * (points[i].pressure / 2.4 - 1.0));
            eprintln!("A13 from the support inward: {deviations:.3?} %");
            assert!((points[12].pressure / 2.4 - 1.0).abs() < 1e-6);
        }
    }
}

/// Two cantilevers, tip to tip, the right one's tip 3 inside the left one's.
fn misfit(nodes: bool, pair: &str, steps: &str) -> String {
    let stations = parts(500.0, 4);
    let right: Vec<f64> = stations.iter().map(|x| 1000.0 - x).collect();
    row("B23", "LEFT", 1, &along_x(&stations, 0.0))
        + &row("B23", "RIGHT", 11, &along_x(&right, if nodes { -3.0 } else { 0.0 }))
        + &section("LEFT", [600.0, 2e4], 2e5)
        + &section("RIGHT", [300.0, 5e3], 2e5)
        + pair
        + "*BOUNDARY\n1, ENCASTRE\n11, ENCASTRE\n"
        + steps
}

const POINT: &str = "*SURFACE, NAME=TOP\nLEFT, SPOS\n*SURFACE, NAME=POINT, TYPE=NODE\n15,\n*SURFACE INTERACTION, NAME=I\n\
                     *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE, SMALL SLIDING\nPOINT, TOP\n";
const GAP: &str = "*ELEMENT, TYPE=GAPUNI, ELSET=G\n21, 5, 15\n*GAP, ELSET=G\n-3., 0., 1.\n";

/// A cantilever's end in n = 4 parts, 12 EI/h³ over 3 EI/L³, has the condition number of a beam in 8.
/// In one increment by a gap element and by a surface of one node; in ten by interference, given or shrunk: the same end.
#[test]
fn A16_cantilever_misfit() {
    let ten = |card: &str| step(card).replace("1., 1.", "0.1, 1., , 0.1");
    for (name, deck) in [
        ("gap", misfit(false, GAP, &step(""))),
        ("node", misfit(true, POINT, &step(""))),
        ("interference", misfit(true, POINT, &ten("*CONTACT INTERFERENCE\nPOINT, TOP, 3.\n"))),
        ("shrink", misfit(true, POINT, &ten("*CONTACT INTERFERENCE, SHRINK\nPOINT, TOP\n"))),
    ] {
        let (run, solved) = solve(&format!("misfit_{name}"), &deck);
        assert_eq!(run.certificates.len(), if matches!(name, "gap" | "node") { 1 } else { 10 }, "{name}");
        close(&format!("A16 {name} N"), forces(&solved)[0], 57.6, of_forces(8));
        close(&format!("A16 {name} left"), solved.displacement(5).unwrap()[1], -0.6, ALGEBRAIC);
        close(&format!("A16 {name} right"), solved.displacement(15).unwrap()[1], 2.4, ALGEBRAIC);
    }
}
