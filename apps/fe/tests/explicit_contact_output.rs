//! What explicit steps tell of contact.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;
use common::results::Results;

const SUM: f64 = 1e-12;

const UNDAMPED: &str = "*CONTACT DAMPING, DEFINITION=CRITICAL DAMPING FRACTION\n0.\n";

/// A brick of 2 × 2 × 1 on another of 3 × 3 × 1, both 3 × 3 wide; the upper one falls and slides.
fn blocks(contact: &str, interaction: &str, step: &str) -> String {
    let mut deck = String::from("*HEADING\n");
    let mut body = |name: &str, first: usize, n: usize, z: f64| {
        let label = |i: usize, j: usize, k: usize| first + i + (n + 1) * (j + (n + 1) * k);
        deck += &format!("*NODE, NSET={name}\n");
        for k in 0..2 {
            for j in 0..=n {
                for i in 0..=n {
                    let [x, y] = [i, j].map(|i| 3.0 * i as f64 / n as f64);
                    deck += &format!("{}, {x:?}, {y:?}, {:?}\n", label(i, j, k), z + k as f64);
                }
            }
        }
        deck += &format!("*ELEMENT, TYPE=C3D8R, ELSET={name}\n");
        for j in 0..n {
            for i in 0..n {
                let at =
                    |k| [(i, j, k), (i + 1, j, k), (i + 1, j + 1, k), (i, j + 1, k)].map(|(i, j, k)| label(i, j, k));
                let nodes: Vec<String> = at(0).into_iter().chain(at(1)).map(|n| n.to_string()).collect();
                deck += &format!("{}, {}\n", first + i + n * j, nodes.join(", "));
            }
        }
    };
    body("LOWER", 1, 3, 0.0);
    body("UPPER", 101, 2, 1.0);
    deck += "*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=LOWER, MATERIAL=M\n\
             *SOLID SECTION, ELSET=UPPER, MATERIAL=M\n*SURFACE, NAME=TOP\nLOWER, S2\n*SURFACE, NAME=BOTTOM\nUPPER, S1\n\
             *SURFACE INTERACTION, NAME=I\n";
    deck += interaction;
    deck += "*INITIAL CONDITIONS, TYPE=VELOCITY\nUPPER, 3, -0.1\nUPPER, 1, 0.05\n*NSET, NSET=FEET, GENERATE\n1, 16\n\
             *BOUNDARY\nFEET, 1, 3\n*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.002, 0.06\n";
    deck + contact + step + "*END STEP\n"
}

/// The pair of the two, with more parameters.
fn pair(parameters: &str) -> String {
    format!("*CONTACT PAIR, INTERACTION=I{parameters}\nBOTTOM, TOP\n")
}

/// Sum of a vector field over all nodes, and of its size.
fn sums(results: &Results, name: &str, frame: usize) -> ([f64; 3], f64) {
    let field = results.point_field(name, 3, frame);
    let there = || field.chunks_exact(3).filter(|v| !v[0].is_nan());
    (std::array::from_fn(|c| there().map(|v| v[c]).sum()), there().flatten().map(|x| x.abs()).sum())
}

/// Pressure and shear, forces, areas and resultants say the same, in every frame and for every way of enforcement.
fn fields_agree(name: &str, contact: &str, history: &str) {
    let job = Job::run(
        name,
        &blocks(contact, &format!("*FRICTION\n0.2\n{UNDAMPED}"), "*OUTPUT, FIELD, NUMBER INTERVAL=10\n"),
    );
    let results = job.results();
    let history: Vec<Vec<f64>> =
        results.real(&format!("Signorini/History/{history}")).chunks_exact(17).map(<[f64]>::to_vec).collect();
    let times = results.times();
    assert_eq!(times.len(), 11);
    let mut closed = 0;
    for (frame, time) in times.iter().enumerate() {
        let [pressure, gap, status, first, second] =
            ["CPRESS", "COPEN", "CSTATUS", "CSHEAR1", "CSHEAR2"].map(|f| results.point_field(f, 1, frame));
        let row = history.iter().find(|row| row[0] == *time).unwrap();
        let (force, overclosure) = (&row[3..6], row[10]);
        let (sum, size) = sums(&results, "CNORMF", frame);
        assert!(sum.iter().all(|s| s.abs() <= SUM * size), "action is reaction: {sum:?}");
        let (sum, size) = sums(&results, "CSHEARF", frame);
        assert!(sum.iter().all(|s| s.abs() <= SUM * size), "action is reaction: {sum:?}");
        let there: Vec<usize> = (0..gap.len()).filter(|&i| !gap[i].is_nan()).collect();
        for &i in &there {
            let shear = first[i].hypot(second[i]);
            match status[i] {
                0.0 => assert_eq!((pressure[i], shear), (0.0, 0.0)),
                1.0 => assert!(
                    pressure[i] >= 0.0 && shear <= 0.2 * pressure[i] * (1.0 + SUM),
                    "{frame} {i} {shear} {}",
                    pressure[i]
                ),
                _ => assert!((shear - 0.2 * pressure[i]).abs() <= 1e-9 * shear, "{shear} {}", pressure[i]),
            }
        }
        closed += there.iter().filter(|&&i| status[i] > 0.0).count();
        let deepest = there.iter().map(|&i| -gap[i]).fold(0.0, f64::max);
        assert!((overclosure - deepest).abs() <= SUM, "{overclosure} {deepest}");
        let normal: f64 = row[13];
        let total = [0, 1, 2].map(|c| row[11 + c] + row[14 + c]);
        assert!((0..3).all(|c| (total[c] - force[c]).abs() <= SUM * normal.abs()), "{row:?}");
    }
    assert!(closed > 20, "{closed}");
}

#[test]
fn fields_agree_by_penalty() {
    fields_agree("fields_penalty", &pair(", MECHANICAL CONSTRAINT=PENALTY, WEIGHT=0."), "BOTTOM on TOP");
}

#[test]
fn fields_agree_by_penalty_from_both_sides() {
    fields_agree("fields_both", &pair(", MECHANICAL CONSTRAINT=PENALTY"), "BOTTOM on TOP");
}

#[test]
fn fields_agree_by_impulses() {
    fields_agree("fields_kinematic", &pair(", WEIGHT=0."), "BOTTOM on TOP");
}

#[test]
fn fields_agree_of_general_contact() {
    let contact = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n";
    fields_agree("fields_general", contact, "general contact");
}

/// A surface that does not turn presses with Σ p A, and its nodes share its area: 9, that each side has once.
#[test]
fn pressure_times_area_is_the_force() {
    let job = Job::run(
        "pressure_area",
        &blocks(
            &pair(", MECHANICAL CONSTRAINT=PENALTY, WEIGHT=0."),
            "",
            "*CONTACT PRINT, FREQUENCY=5\nCSTRESS, CDISP, CF\n*OUTPUT, FIELD\n*CONTACT OUTPUT\nCSTRESS, CNAREA\n",
        )
        .replace("UPPER, 1, 0.05\n", ""),
    );
    let results = job.results();
    let history = results.real("Signorini/History/BOTTOM on TOP");
    for (frame, time) in results.times().iter().enumerate() {
        let [pressure, area] = ["CPRESS", "CNAREA"].map(|f| results.point_field(f, 1, frame));
        let there = || pressure.iter().zip(&area).filter(|p| !p.0.is_nan());
        assert!((there().map(|p| p.1).sum::<f64>() - 9.0).abs() < SUM * 9.0);
        let force = history.chunks_exact(17).find(|row| row[0] == *time).unwrap()[5];
        let pressed: f64 = there().map(|(p, a)| p * a).sum();
        // Faces bend by waves, so that normals turn: the square of a slope of a hundredth.
        assert!((force - pressed).abs() <= 1e-4 * pressed, "{force} {pressed}");
    }
    let tables = job.tables();
    let of = |title: &str| tables.iter().filter(|t| t.title.starts_with(title)).collect::<Vec<_>>();
    let (stress, gap) = (of("contact stress"), of("relative contact displacement"));
    assert!(!stress.is_empty() && stress.len() == gap.len() && stress.iter().any(|t| t.rows.len() > 3));
    assert_eq!(of("total surface force").len(), stress.len());
}

/// The area of the nodes of plane sections is the length of their edges times the thickness, of rings 2πr of it: more of it at
/// the outer node.
#[test]
fn edges_count_for_their_depth() {
    let areas = |element: &str| -> Vec<f64> {
        let deck = format!(
            "*NODE, NSET=ALL\n1, 1., 1.\n2, 3., 1.\n3, 3., 2.\n4, 1., 2.\n9, 0., 0.\n*ELEMENT, TYPE={element}, ELSET=E\n1, 1, 2, 3, 4\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n0.25\n*SURFACE, NAME=FOOT\n1, S1\n\
             *SURFACE, NAME=FLOOR, TYPE=SEGMENTS\nSTART, -9., 0.\nLINE, 9., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=9\n\
             *BOUNDARY\n9, 1, 6\n*STEP\n*DYNAMIC, EXPLICIT\n, 1e-3\n*CONTACT PAIR\nFOOT, FLOOR\n*OUTPUT, FIELD\n\
             *CONTACT OUTPUT\nCNAREA\n*END STEP\n"
        );
        let deck = if element == "CAX4R" { deck.replace("MATERIAL=M\n0.25\n", "MATERIAL=M\n") } else { deck };
        Job::run("depth", &deck).results().point_field("CNAREA", 1, 0)[..2].to_vec()
    };
    let thirds = |a: f64, b: f64| std::f64::consts::TAU * 2.0 * (2.0 * a + b) / 6.0;
    for (element, expected) in [("CPS4R", [0.25, 0.25]), ("CAX4R", [thirds(1.0, 3.0), thirds(3.0, 1.0)])] {
        let found = areas(element);
        assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() < SUM * e), "{element} {found:?} {expected:?}");
    }
}
