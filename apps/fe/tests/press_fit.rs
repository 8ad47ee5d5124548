//! A25: two rings pressed into each other, steel 20/40 in aluminium 40/60, radial interference 0.02, held along the axis
//! (plane strain); against Lamé's closed form. B18: the same by slow explicit steps.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// Inner radius, outer radius [L], E [F/L²], ν [-].
const INNER: [f64; 4] = [20.0, 40.0, 210e3, 0.3];
const OUTER: [f64; 4] = [40.0, 60.0, 70e3, 0.33];
const INTERFERENCE: f64 = 0.02;
/// Density over E [T²/L²]: that of steel and that of aluminium are within 2 % of it.
const SLOWNESS: f64 = 3.8e-14;

/// Radial displacement of a ring's face per unit of pressure on it, plane strain (E/(1 − ν²), ν/(1 − ν)): of its outer face
/// inward, of its inner face outward. Timoshenko and Goodier 1970, article 28.
fn compliance([inner, outer, young, nu]: [f64; 4], face: f64) -> f64 {
    let (young, nu) = (young / (1.0 - nu * nu), nu / (1.0 - nu));
    let share = (outer * outer + inner * inner) / (outer * outer - inner * inner);
    face / young * (share + if face == inner { nu } else { -nu })
}

/// The pressure on the inner ring's face of rings that overlap or touch; `give`: what the contact gives way per pressure.
/// The force on both faces is the same.
fn pressure(inner: [f64; 4], outer: [f64; 4], give: f64) -> f64 {
    let (own, other) = (inner[1], outer[0]);
    INTERFERENCE / (compliance(inner, own) + own / other * compliance(outer, other) + give)
}

/// Nodes and elements of a ring with n elements through it, from label `first`.
fn ring([inner, outer, young, nu]: [f64; 4], n: usize, first: usize, name: &str) -> String {
    let mut text = format!("*NODE, NSET=N{name}\n");
    for row in 0..2 {
        for i in 0..=n {
            let r = inner + (outer - inner) * i as f64 / n as f64;
            text += &format!("{}, {r:?}, {row}.\n", first + row * (n + 1) + i);
        }
    }
    text += &format!("*ELEMENT, TYPE=CAX4, ELSET=E{name}\n");
    for i in 0..n {
        let [a, b] = [first + i, first + n + 1 + i];
        text += &format!("{}, {a}, {}, {}, {b}\n", first + i, a + 1, b + 1);
    }
    text + &format!(
        "*MATERIAL, NAME=M{name}\n*ELASTIC\n{young}, {nu}\n*DENSITY\n{}\n*SOLID SECTION, ELSET=E{name}, MATERIAL=M{name}\n",
        SLOWNESS * young
    )
}

/// Both rings, their pair and one step of so many increments.
fn deck(rings: [[f64; 4]; 2], n: usize, behavior: &str, cards: [&str; 2], increments: usize) -> String {
    let [inner, outer] = rings;
    let step = 1.0 / increments as f64;
    format!(
        "{}{}*SURFACE, NAME=SEC\n{n}, S2\n*SURFACE, NAME=MAIN\n1001, S4\n*AMPLITUDE, NAME=RISES\n0., 0., 1., 1.\n\
         *SURFACE INTERACTION, NAME=I\n{behavior}\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, SMALL SLIDING\nSEC, MAIN\n{}\
         *BOUNDARY\nNI, 2\nNO, 2\n*STEP, INC=200\n*STATIC, DIRECT\n{step:?}, 1.\n{}*CONTACT PRINT, FREQUENCY=1000\nCSTRESS\n*END STEP\n",
        ring(inner, n, 1, "I"),
        ring(outer, n, 1001, "O"),
        cards[0],
        cards[1]
    )
}

/// Pressures at the end.
fn run(name: &str, deck: &str) -> Vec<f64> {
    Job::run(name, deck).tables().last().unwrap().rows.iter().map(|row| row.values[0]).collect()
}

const SHRINK: &str = "*CONTACT INTERFERENCE, SHRINK\nSEC, MAIN\n";
/// From touching surfaces: a gap of 0.02 is asked for in the end.
const RISES: &str = "*CONTACT INTERFERENCE, AMPLITUDE=RISES\nSEC, MAIN, -0.02\n";
const GAP: &str = "*CLEARANCE, SECONDARY=SEC, MAIN=MAIN, VALUE=-0.02\n";

/// Each with a half of the interference.
fn overlapping() -> [[f64; 4]; 2] {
    let (mut inner, mut outer) = (INNER, OUTER);
    (inner[1], outer[0]) = (inner[1] + 0.5 * INTERFERENCE, outer[0] - 0.5 * INTERFERENCE);
    [inner, outer]
}

/// Interference as overlapping meshes, at once and shrunk; from touching meshes by CONTACT INTERFERENCE and CLEARANCE:
/// within 0.06/n² of the closed form (the bound of second-order elements for this thickness of rings).
#[test]
fn a25_press_fit() {
    let (touching, overlapping) = ([INNER, OUTER], overlapping());
    assert!((pressure(INNER, OUTER, 0.0) - 11.1774107014).abs() < 1e-9);
    for n in [2, 4, 8] {
        for (rings, cards, increments) in [
            (overlapping, ["", ""], 1),
            (overlapping, ["", SHRINK], 4),
            (touching, ["", RISES], 4),
            (touching, [GAP, SHRINK], 2),
        ] {
            let exact = pressure(rings[0], rings[1], 0.0);
            let found = run("press_fit", &deck(rings, n, "", cards, increments));
            assert_eq!(found.len(), 2);
            let worst = found.iter().fold(0.0f64, |m, p| m.max((p / exact - 1.0).abs()));
            assert!(worst <= 0.06 / (n * n) as f64, "{n} {cards:?}: {found:?}, not {exact}");
        }
    }
}

/// A ring whose E/(1 − ν²) and ν/(1 − ν) are the E and ν of this one, which is so in plane stress.
fn as_plane_strain([inner, outer, young, nu]: [f64; 4]) -> [f64; 4] {
    let nu_strain = nu / (1.0 + nu);
    [inner, outer, young * (1.0 - nu_strain * nu_strain), nu_strain]
}

/// Slices that are free along the axis but for one node: plane stress, with the displacements of both faces; two rings of
/// steel press with 24.609375.
#[test]
fn a25_press_fit_in_plane_stress() {
    let steel = [40.0, 60.0, 210e3, 0.3];
    for (outer, exact) in [(OUTER, 10.3380374138), (steel, 24.609375)] {
        let given = pressure(as_plane_strain(INNER), as_plane_strain(outer), 0.0);
        assert!((given / exact - 1.0).abs() < 1e-9, "{given}");
        for n in [2, 4, 8] {
            let free = deck([INNER, outer], n, "", [GAP, SHRINK], 2).replace("NI, 2\nNO, 2\n", "1, 2\n1001, 2\n");
            let print = "*NODE PRINT, NSET=NI\nU\n*NODE PRINT, NSET=NO\nU\n*CONTACT PRINT";
            let job = Job::run("press_fit_free", &free.replace("*CONTACT PRINT", print));
            let tables = job.tables();
            let bound = 0.06 / (n * n) as f64;
            let pressures = &tables.iter().rfind(|t| t.title.starts_with("contact stress")).unwrap().rows;
            assert!(pressures.iter().all(|row| (row.values[0] / exact - 1.0).abs() <= bound), "{n}: {pressures:?}");
            let across = |set: &str, label: u64| {
                let table = tables.iter().rfind(|t| t.title.starts_with("displacements") && t.set == set).unwrap();
                table.rows.iter().find(|row| row.labels[0] == label).unwrap().values[0]
            };
            let [inward, outward] =
                [compliance(as_plane_strain(INNER), 40.0), compliance(as_plane_strain(outer), 40.0)];
            let found = [across("NI", n as u64 + 1), across("NO", 1001)];
            for (u, exact) in found.into_iter().zip([-exact * inward, exact * outward]) {
                assert!((u - exact).abs() <= bound * INTERFERENCE, "{n}: {u}, not {exact}");
            }
        }
    }
}

/// By a penalty k the interference is δ − p/k.
#[test]
fn a25_press_fit_by_penalty() {
    for k in [1e3, 1e4, 1e6] {
        let behavior = format!("*SURFACE BEHAVIOR, PENALTY\n{k}\n");
        let found = run("press_fit_penalty", &deck([INNER, OUTER], 8, &behavior, [GAP, ""], 1));
        let exact = pressure(INNER, OUTER, 1.0 / k);
        assert!(found.iter().all(|p| (p / exact - 1.0).abs() <= 0.06 / 64.0), "{k}: {found:?}, not {exact}");
    }
}

/// D34: the end does not depend on the number of increments.
#[test]
fn d34_press_fit_in_any_number_of_increments() {
    let ends = [1, 3, 100].map(|n| run("press_fit_increments", &deck([INNER, OUTER], 4, "", [GAP, SHRINK], n)));
    for end in &ends[1..] {
        assert!(end.iter().zip(&ends[0]).all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{ends:?}");
    }
}

/// The rings in two slow explicit steps: a pressure squeezes the inner one until it fits, then goes away while the pair acts.
/// Both take 300/ω, ω that of the outer ring alone, the lower one, as a thin ring breathes.
fn fitted(rings: [[f64; 4]; 2], n: usize, behavior: &str) -> String {
    let [inner, outer] = rings;
    let [_, _, young, nu] = outer;
    let period = 300.0 * 0.5 * (outer[0] + outer[1]) * (SLOWNESS * young * (1.0 - nu * nu) / young).sqrt();
    // A hundredth more than the interference, as the meshes give up to 0.4 % less than Lamé.
    let squeeze = 1.01 * INTERFERENCE / compliance(inner, inner[1]);
    format!(
        "{}{}*SURFACE, NAME=SEC\n{n}, S2\n*SURFACE, NAME=MAIN\n1001, S4\n*SURFACE INTERACTION, NAME=I\n{behavior}\
         *AMPLITUDE, NAME=COMES, DEFINITION=SMOOTH STEP\n0., 0., {period:?}, 1.\n\
         *AMPLITUDE, NAME=GOES, DEFINITION=SMOOTH STEP\n0., 1., {period:?}, 0.\n*BOUNDARY\nNI, 2\nNO, 2\n\
         *STEP\n*DYNAMIC, EXPLICIT\n, {period:?}\n*DSLOAD, AMPLITUDE=COMES\nSEC, P, {squeeze:?}\n*END STEP\n\
         *STEP\n*DYNAMIC, EXPLICIT\n, {period:?}\n*CONTACT PAIR, INTERACTION=I\nSEC, MAIN\n\
         *DSLOAD, OP=NEW, AMPLITUDE=GOES\nSEC, P, {squeeze:?}\n*CONTACT PRINT, FREQUENCY=10000000\nCSTRESS\n*END STEP\n",
        ring(inner, n, 1, "I"),
        ring(outer, n, 1001, "O"),
    )
}

/// B18: the pressure of slow explicit steps is that of a static one on the same mesh, hard and with a law, and little moves. The
/// elements differ (means of the volume's change there, enhanced strains here) by less than the 0.06/n² that they may be off;
/// pressures are forces over the areas of the start, which are off by δ/2b on either side; the rings meet at 0.0008 of their way
/// in 1/ω, 30 τ²(1 − τ)²/ωT where 10 τ³ is 0.01, and swing on with that.
#[test]
fn b18_press_fit() {
    let rings = overlapping();
    for behavior in ["", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4\n"] {
        for n in [4, 8] {
            let exact = run("press_fit_static", &deck(rings, n, behavior, ["", ""], 1))[0];
            let job = Job::run("press_fit_explicit", &fitted(rings, n, behavior));
            let found: Vec<f64> = job.tables().last().unwrap().rows.iter().map(|row| row.values[0]).collect();
            assert_eq!(found.len(), 4);
            let bound = 0.06 / (n * n) as f64 + 0.5 * INTERFERENCE / 40.0 + 0.0008;
            let worst = found.iter().fold(0.0f64, |m, p| m.max((p / exact - 1.0).abs()));
            assert!(worst <= bound.min(0.005), "{n} {behavior}: {found:?}, not {exact}");
            // Time, step and increment come before ALLKE; ALLIE is four further on.
            let energies = job.results().real("Signorini/History/Energies");
            let last = energies.chunks_exact(15).last().unwrap();
            assert!(last[3] <= 0.0008f64.powi(2) * last[7], "{last:?}");
        }
    }
}

/// Springs of balanced hard contact are as stiff as each side is heavy: steel pushes three times as hard as aluminium with the
/// same overclosure, but what a face tells is all that presses on it. Both faces have the same force; their areas at the start
/// differ by δ/b, and what swings is that of [`b18_press_fit`].
#[test]
fn faces_of_unlike_bodies_tell_the_same_pressure() {
    let deck = fitted(overlapping(), 4, "");
    let pair = "*CONTACT PAIR, INTERACTION=I";
    let job = Job::run("press_fit_penalty", &deck.replace(pair, &format!("{pair}, MECHANICAL CONSTRAINT=PENALTY")));
    let found: Vec<f64> = job.tables().last().unwrap().rows.iter().map(|row| row.values[0]).collect();
    let (least, most) = found.iter().fold((f64::INFINITY, 0.0f64), |(l, m), p| (l.min(*p), m.max(*p)));
    assert!(found.len() == 4 && most / least - 1.0 <= INTERFERENCE / 40.0 + 0.0008, "{found:?}");
}
