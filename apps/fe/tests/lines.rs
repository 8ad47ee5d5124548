//! Trusses, beams, springs and masses from decks to tables, and what is told where nothing holds them.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;
use common::{Run, Scratch};

/// Runs a deck.
fn attempt(name: &str, deck: &str) -> Run {
    let scratch = Scratch::new(name);
    scratch.write("job.inp", deck);
    scratch.fe(&["run", "job.inp"])
}

/// n beams along x from the origin to x = 1000, a set of the last node, the first held in all freedoms.
fn cantilever(element: &str, n: usize, section: &str) -> String {
    let mut deck = "*NODE\n".to_owned();
    (0..=n).for_each(|i| deck += &format!("{}, {}\n", i + 1, 1000.0 * i as f64 / n as f64));
    deck += &format!("*ELEMENT, TYPE={element}, ELSET=BEAM\n");
    (1..=n).for_each(|i| deck += &format!("{i}, {i}, {}\n", i + 1));
    deck += &format!("*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n*DENSITY\n8e-9\n{section}");
    deck += &format!("*NSET, NSET=TIP\n{}\n*NSET, NSET=FOOT\n1\n*BOUNDARY\nFOOT, ENCASTRE\n", n + 1);
    deck
}

const SQUARE: &str = "*BEAM SECTION, ELSET=BEAM, MATERIAL=STEEL, SECTION=RECT\n20., 20.\n0., 0., -1.\n";
const PRINT: &str = "*NODE PRINT, NSET=TIP\nU\n*NODE PRINT, NSET=FOOT, TOTALS=YES\nRF\n*END STEP\n";

/// The figures of the case; tables print six to seven digits, 1e-6 relative.
#[test]
fn c03_beams_from_decks() {
    for (element, n, exact) in
        [("B21", 2, 111.643557423), ("B23", 1, 119.047619048), ("B31", 4, 117.223914566), ("B33", 2, 119.047619048)]
    {
        let deck = cantilever(element, n, SQUARE) + "*STEP\n*STATIC\n1., 1.\n*CLOAD\nTIP, 2, 1000.\n" + PRINT;
        let job = Job::run(&format!("c03_{element}"), &deck);
        assert!((job.last("displacements", "TIP", 2) / exact - 1.0).abs() < 1e-6, "{element}");
        assert!((job.last("forces", "FOOT", 2) + 1000.0).abs() < 1e-3, "{element}");
    }
}

/// A moment on the tip bends to M L² / 2 E I; forces per length add q L⁴ / 8 E I, weight the same with q = ρ A g, whose sum
/// the foot carries.
#[test]
fn moments_and_loads_along_beams() {
    let inertia = 20f64.powi(4) / 12.0;
    let loads = "*STEP\n*STATIC\n1., 1.\n*CLOAD\nTIP, 6, 1e6\n".to_owned() + PRINT;
    let job = Job::run("beam_moment", &(cantilever("B33", 2, SQUARE) + &loads));
    assert!((job.last("displacements", "TIP", 2) / (1e6 * 1e6 / (2.0 * 210e3 * inertia)) - 1.0).abs() < 1e-6);
    let q = 8e-9 * 400.0 * 9810.0;
    for (name, load) in
        [("beam_line_load", format!("BEAM, PY, {}", -q)), ("beam_weight", "BEAM, GRAV, 9810., 0., -1.".into())]
    {
        let loads = format!("*STEP\n*STATIC\n1., 1.\n*DLOAD\n{load}\n{PRINT}");
        let job = Job::run(name, &(cantilever("B23", 2, SQUARE) + &loads));
        assert!(
            (job.last("displacements", "TIP", 2) / (-q * 1e12 / (8.0 * 210e3 * inertia)) - 1.0).abs() < 1e-6,
            "{name}"
        );
        assert!((job.last("forces", "FOOT", 2) / (q * 1000.0) - 1.0).abs() < 1e-6, "{name}");
    }
}

/// A bar on a spring to the ground, its other end on a spring to a held node and with a mass that weighs; the forces of all
/// springs are among the reactions, so the increment balances. u = F/k at the spring, stress F/A in the bar.
#[test]
fn bars_springs_and_masses() {
    let deck = "\
*NODE
1, 0., 0.
2, 10., 0.
3, 20., 0.
*ELEMENT, TYPE=T2D2, ELSET=BAR
1, 1, 2
*ELEMENT, TYPE=SPRING1, ELSET=GROUND
2, 1
*ELEMENT, TYPE=SPRINGA, ELSET=LINK
3, 2, 3
*ELEMENT, TYPE=MASS, ELSET=HEAVY
4, 2
*ELEMENT, TYPE=DASHPOTA, ELSET=DAMPER
5, 1, 3
*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL
2.
*SPRING, ELSET=GROUND
1
100.
*SPRING, ELSET=LINK

300.
*MASS, ELSET=HEAVY
0.5
*DASHPOT, ELSET=DAMPER

7.
*NSET, NSET=TIP
2
*NSET, NSET=FOOT
3
*NSET, NSET=ALL
1, 2
*BOUNDARY
FOOT, 1, 2
ALL, 2, 2
*STEP
*STATIC
1., 1.
*DLOAD
HEAVY, GRAV, 80., 1.
*NODE PRINT, NSET=TIP
U
*NODE PRINT, NSET=FOOT
RF
*EL PRINT, ELSET=BAR
S, E
*END STEP
";
    let job = Job::run("bars_springs", deck);
    // 40 to the right; the bar of 42000 stands in series with the 100 to the ground, both beside 300.
    let left = 1.0 / (1.0 / 100.0 + 1.0 / 42000.0);
    let u = 40.0 / (left + 300.0);
    let close = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-6, "{found} {exact}");
    close(job.last("displacements", "TIP", 1), u);
    close(job.last("forces", "FOOT", 1), -300.0 * u);
    close(job.last("stresses", "BAR", 1), left * u / 2.0);
    close(job.last("strains", "BAR", 1), left * u / 2.0 / 210000.0);
    let results = job.results();
    assert_eq!(results.integer("VTKHDF/Offsets"), [0, 2, 3, 5, 6, 8]);
    // Along the bar in every frame; nothing for springs.
    let stress = results.real("VTKHDF/CellData/S");
    let last = &stress[stress.len() - 30..];
    close(last[0], left * u / 2.0);
    assert!(last[1..6].iter().all(|s| s.abs() < 1e-12) && last[6..].iter().all(|s| s.is_nan()));
    let forces = results.real("VTKHDF/CellData/SF");
    close(forces[forces.len() - 15], left * u);
    let plan = job.plan();
    for words in
        ["1 T2D2 of STEEL, area 2 L²", "1 SPRING1, stiffness 100 F/L", "1 DASHPOTA: dashpots", "1 MASS: of masses"]
    {
        assert!(plan.contains(words), "{words}\n{plan}");
    }
}

/// Thin beams up to L / t = 1e6: slender ones exact to the digits of the table, shear-flexible ones within what the program
/// says that rounding may cost, and 1e-6 where it says nothing.
#[test]
fn d28_thin_beams_say_what_they_lose() {
    for slenderness in [1e2, 1e4, 1e6] {
        for element in ["B31", "B33"] {
            let (n, t) = (8, 1000.0 / slenderness);
            let section = format!("*BEAM SECTION, ELSET=BEAM, MATERIAL=STEEL, SECTION=RECT\n{t}, {t}\n");
            let load = 1000.0 * (t / 20.0f64).powi(4);
            let loads = format!("*STEP\n*STATIC\n1., 1.\n*CLOAD\nTIP, 2, {load}\n{PRINT}");
            let job =
                Job::run(&format!("d28_thin_{element}_{slenderness}"), &(cantilever(element, n, &section) + &loads));
            let shear = load * 1000.0 / (0.85 * 210e3 / 2.6 * t * t);
            let exact = 119.047619047619 * if element == "B31" { 1.0 - 1.0 / 256.0 } else { 1.0 }
                + if element == "B31" { shear } else { 0.0 };
            let error = job.last("displacements", "TIP", 2) / exact - 1.0;
            let printed = &job.told;
            let allowed = match printed.split_once("rounding may cost ") {
                Some((_, rest)) => rest.split_once(" of").unwrap().0.parse().unwrap(),
                None => 1e-6,
            };
            assert!(error.abs() < allowed, "{element} {slenderness} {error:e} {allowed:e}");
            assert_eq!(printed.contains("rounding may cost"), element == "B31" && slenderness > 1e5, "{printed}");
        }
    }
}

/// Mechanisms end with node, or body, and direction.
#[test]
fn d28_mechanisms_are_named() {
    let truss = "\
*NODE, NSET=ALL
1, 0., 0., 0.
2, 10., 0., 0.
3, 20., 0., 0.
*NSET, NSET=ENDS
1, 3
*ELEMENT, TYPE=T3D2, ELSET=CHAIN
1, 1, 2
2, 2, 3
*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*SOLID SECTION, ELSET=CHAIN, MATERIAL=STEEL
*BOUNDARY
ENDS, 1, 3
2, 3, 3
*STEP
*STATIC
1., 1.
*CLOAD
2, 2, 1.
*END STEP
";
    let run = attempt("d28_truss", truss);
    assert_eq!(run.status, 1, "{}", run.error);
    assert!(run.error.contains("nothing holds freedom 2 of node 2"), "{}", run.error);
    let beam = cantilever("B33", 2, SQUARE).replace("FOOT, ENCASTRE", "FOOT, 1, 3\nTIP, 2, 3")
        + "*STEP\n*STATIC\n1., 1.\n*CLOAD\n2, 2, 1000.\n*END STEP\n";
    let run = attempt("d28_beam", &beam);
    assert_eq!(run.status, 1, "{}", run.error);
    assert!(run.error.contains("nothing holds body BEAM: it is free about x"), "{}", run.error);
}
