//! D04, D28: beams on each other over common supports; beams so thin that rounding shows, and what nothing holds.

use crate::hard::Scene;
use crate::hard::finding::{Finding, difference, from_value};
use crate::hard::patch::{EXACT, step};
use crate::hard::run::{Run, Solved};

/// Length [L] of the beams, Young's modulus [F/L²].
const LENGTH: f64 = 1000.0;
const YOUNG: f64 = 2.1e5;
/// Elements of a cantilever.
const PARTS: usize = 8;

/// Nodes in a row from the origin along a direction, at z, and elements between them, labels from `first`.
fn row(element: &str, set: &str, first: usize, (parts, [c, s]): (usize, [f64; 2])) -> String {
    let mut cards = "*NODE\n".to_owned();
    for i in 0..=parts {
        let x = LENGTH * i as f64 / parts as f64;
        cards += &format!("{}, {:?}, {:?}, 0.\n", first + i, c * x, s * x);
    }
    cards += &format!("*ELEMENT, TYPE={element}, ELSET={set}\n");
    (first..first + parts).for_each(|i| cards += &format!("{i}, {i}, {}\n", i + 1));
    cards
}

/// A section [L², L⁴] whose first axis is along z.
fn section(set: &str, area: f64, inertia: f64) -> String {
    format!(
        "*BEAM GENERAL SECTION, ELSET={set}, SECTION=GENERAL\n{area:e}, {inertia:e}, 0., {inertia:e}, {:e}\n0., 0., 1.\n\
         {YOUNG:e}, {:e}\n",
        2.0 * inertia,
        YOUNG / 2.6
    )
}

/// Scenes of D04: a beam on another one, both simply supported at the same nodes (A13).
pub fn supported_ends() -> Vec<Scene> {
    vec![Scene::new("beams on each other, ends supported", |place| {
        const PARALLEL: usize = 24;
        let deck = |secondary: &str| {
            row("B23", "LOW", 1, (PARALLEL, [1.0, 0.0]))
                + &row("B23", "UP", 101, (PARALLEL, [1.0, 0.0]))
                + &section("LOW", 900.0, 3e4)
                + &section("UP", 600.0, 2e4)
                + &format!(
                    "*NSET, NSET=INNER, GENERATE\n102, 124\n*SURFACE, NAME=TOP\nLOW, SPOS\n*SURFACE, NAME=FOOT\nUP, SNEG\n\
                     *SURFACE, NAME=INSIDE, TYPE=NODE\nINNER, {:e}\n*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, DIRECT\n\
                     *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{secondary}, TOP\n*BOUNDARY\n1, 1, 2\n101, 1, 2\n25, 2\n\
                     125, 2\n",
                    LENGTH / PARALLEL as f64
                )
                + &step(EXACT, "*DLOAD\nUP, PY, -4.\n")
        };
        let (run, without) = (place.run("ends", &deck("FOOT")), place.run("inside", &deck("INSIDE")));
        let told = run.plans.iter().any(|plan| plan.contains("2 multipliers say") && plan.contains("101, 125"));
        let middle = |solved: &Solved| solved.displacement(113).map_or(f64::NAN, |u| u[1]);
        // The condition number goes as n⁴, 1e6 here.
        let bound = 1e-8;
        Finding::converged(&run)
            .and(Finding::converged(&without))
            .holds(told, format!("the plan does not list 101, 125: {:?}", run.plans))
            .within(difference(without.u(), run.u()), bound)
            .measured(&run, |solved| vec![(from_value(-4.9603174603174605, &[middle(solved)]), bound)])
    })]
}

/// A cantilever of a square section, or of one with an area of its own, loaded across by what bends it by about 119.
fn cantilever(element: &str, direction: [f64; 2], (area, inertia): (f64, f64)) -> (String, f64) {
    let [c, s] = direction;
    let load = 3.0 * YOUNG * inertia / LENGTH.powi(3) * 119.047619047619;
    let deck = row(element, "BEAM", 1, (PARTS, direction))
        + &section("BEAM", area, inertia)
        + "*BOUNDARY\n1, ENCASTRE\n"
        + &step(EXACT, &format!("*CLOAD\n{0}, 1, {1:e}\n{0}, 2, {2:e}\n", PARTS + 1, -s * load, c * load));
    (deck, load)
}

/// The part of a deflection that the program says rounding may cost; 1e-6 where it says nothing.
fn allowed(run: &Run) -> f64 {
    let said = run.notes.iter().find_map(|note| note.split_once("rounding may cost "));
    said.and_then(|(_, rest)| rest.split_once(" of")?.0.parse().ok()).unwrap_or(1e-6)
}

/// The deflection of the tip of a beam of this direction.
fn tip(solved: &Solved, [c, s]: [f64; 2]) -> f64 {
    solved.displacement(PARTS as u64 + 1).map_or(f64::NAN, |u| c * u[1] - s * u[0])
}

/// Scenes of D12.
pub fn snapping() -> Vec<Scene> {
    ["by displacement", "by load"].map(|way| Scene::waits(format!("two-bar truss {way}"), "NLGEOM")).into()
}

/// Scenes of D28.
pub fn thin() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for element in ["B21", "B23", "B31", "B33"] {
        for exponent in [2, 4, 6] {
            for direction in [[1.0, 0.0], [0.6, 0.8]] {
                let way = if direction[1] == 0.0 { "along x" } else { "aslant" };
                scenes.push(Scene::new(format!("cantilever {element} {way}, L/t = 1e{exponent}"), move |place| {
                    let t = LENGTH / 10f64.powi(exponent);
                    let (deck, load) = cantilever(element, direction, (t * t, t.powi(4) / 12.0));
                    let run = place.run("cantilever", &deck);
                    let flexible = matches!(element, "B21" | "B31");
                    // Linear beams: 1 − 1/4n² of the bending, and the shear, with κ = 1 of a general section.
                    let bending = 119.047619047619 * if flexible { 1.0 - 0.25 / (PARTS * PARTS) as f64 } else { 1.0 };
                    let shear = if flexible { load * LENGTH / (YOUNG / 2.6 * t * t) } else { 0.0 };
                    let bound = allowed(&run);
                    Finding::converged(&run)
                        .say(format!("allowed {bound:.0e}"))
                        .measured(&run, |solved| vec![(from_value(bending + shear, &[tip(solved, direction)]), bound)])
                }));
            }
        }
    }
    for direction in [[1.0, 0.0], [0.6, 0.8]] {
        let way = if direction[1] == 0.0 { "along x" } else { "aslant" };
        scenes.push(Scene::new(format!("cantilever B33 {way}, EA L²/EI = 1e12"), move |place| {
            let run = place.run("cantilever", &cantilever("B33", direction, (1e10, 1e4)).0);
            let bound = allowed(&run);
            Finding::converged(&run)
                .say(format!("allowed {bound:.0e}"))
                .measured(&run, |solved| vec![(from_value(119.047619047619, &[tip(solved, direction)]), bound)])
        }));
    }
    scenes.push(Scene::new("a node between two trusses, loaded across", |place| {
        let deck = row("T3D2", "CHAIN", 1, (2, [1.0, 0.0]))
            + "*MATERIAL, NAME=M\n*ELASTIC\n2.1e5, 0.3\n*SOLID SECTION, ELSET=CHAIN, MATERIAL=M\n1.\n\
               *BOUNDARY\n1, 1, 3\n3, 1, 3\n2, 3\n"
            + &step(EXACT, "*CLOAD\n2, 2, 1.\n");
        Finding::refused(&place.run("chain", &deck), &["nothing holds freedom 2 of node 2"])
    }));
    scenes.push(Scene::new("a beam free about its axis", |place| {
        let deck = row("B33", "BEAM", 1, (2, [1.0, 0.0]))
            + &section("BEAM", 400.0, 1e4)
            + "*BOUNDARY\n1, 1, 3\n3, 2, 3\n"
            + &step(EXACT, "*CLOAD\n2, 2, 1000.\n");
        Finding::refused(&place.run("free", &deck), &["nothing holds body BEAM: it is free about x"])
    }));
    scenes
}
