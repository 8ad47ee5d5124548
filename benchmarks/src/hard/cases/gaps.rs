//! D02, D18, D32: gap elements between bodies of unlike stiffness, between two stops, and without a direction.

use crate::hard::Scene;
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{EXACT, step};
use crate::hard::run::{Run, Solved};

/// Relative bound of a discrete problem that has the closed answer.
const ALGEBRAIC: f64 = 1e-10;

/// A spring to the ground in a direction.
fn spring(label: usize, node: usize, direction: usize, stiffness: f64) -> String {
    format!(
        "*ELEMENT, TYPE=SPRING1, ELSET=S{label}\n{label}, {node}\n*SPRING, ELSET=S{label}\n{direction}\n{stiffness:e}\n"
    )
}

/// Scenes of D02: springs r and 1 with a stiffness between them, a unit force that presses the soft one on the stiff one.
pub fn springs() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for exponent in [6, 9, 12] {
        let stiff = 10f64.powi(exponent);
        for (between, name) in [(1.0, "1"), (stiff.sqrt(), "√r"), (stiff, "r")] {
            for law in ["PRESSURE-OVERCLOSURE=LINEAR", "PENALTY"] {
                scenes.push(Scene::new(format!("springs, r = 1e{exponent}, {name} between, {law}"), move |place| {
                    let deck = "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n".to_owned()
                        + &spring(11, 1, 1, stiff)
                        + &spring(12, 2, 1, 1.0)
                        + &format!(
                            "*ELEMENT, TYPE=GAPUNI, ELSET=G\n13, 1, 2\n*GAP, ELSET=G\n0., 1.\n*SURFACE BEHAVIOR, {law}\n\
                             {between:e}\n*BOUNDARY\n1, 2, 3\n2, 2, 3\n{}",
                            step(EXACT, "*CLOAD\n2, 1, -1.\n")
                        );
                    let run = place.run("springs", &deck);
                    let (ways, all) = (1.0 / stiff + 1.0, 1.0 / stiff + 1.0 + 1.0 / between);
                    // The soft spring takes its share of the hard case, 1 / (1/r + 1), times the flexibilities' ratio.
                    let force = 1.0 / ways * (ways / all);
                    Finding::converged(&run)
                        .measured(&run, |solved| vec![(from_value(force, &solved.pressures()), ALGEBRAIC)])
                }));
            }
        }
    }
    scenes
}

/// Scenes of D18: a spring between two stops, led into one of them by 4 and let go there.
pub fn stops() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for start in [5.0, -5.0] {
        for (stiffness, law) in [
            (1e3, "PRESSURE-OVERCLOSURE=LINEAR"),
            (1e3, "PENALTY"),
            (1e6, "PRESSURE-OVERCLOSURE=LINEAR"),
            (1e6, "PENALTY"),
        ] {
            scenes.push(Scene::new(format!("two stops of {stiffness:e}, let go at {start}, {law}"), move |place| {
                let stop = |set: &str| format!("*GAP, ELSET={set}\n1., 1.\n*SURFACE BEHAVIOR, {law}\n{stiffness:e}\n");
                let held = "2, 1, 3\n3, 1, 3\n1, 2, 3\n";
                let deck = "*NODE\n1, 0., 0., 0.\n2, 0., 0., 0.\n3, 0., 0., 0.\n".to_owned()
                    + &spring(11, 1, 1, 1.0)
                    + "*ELEMENT, TYPE=GAPUNI, ELSET=RIGHT\n12, 1, 2\n*ELEMENT, TYPE=GAPUNI, ELSET=LEFT\n13, 3, 1\n"
                    + &stop("RIGHT")
                    + &stop("LEFT")
                    + &format!("*BOUNDARY\n{held}")
                    + &step(EXACT, &format!("*BOUNDARY\n1, 1, 1, {start:e}\n"))
                    + &step(EXACT, &format!("*BOUNDARY, OP=NEW\n{held}*CLOAD\n1, 1, 0.5\n"));
                let run = place.run("stops", &deck);
                Finding::converged(&run)
                    .holds(run.iterations <= 15, format!("it chatters: {} iterations", run.iterations))
                    .measured(&run, |solved| vec![(from_value(0.5, &along(solved, 1)), ALGEBRAIC)])
            }));
        }
    }
    scenes
}

/// Displacements along x of nodes up to a label.
fn along(solved: &Solved, last: u64) -> Vec<f64> {
    (1..=last).map(|label| solved.displacement(label).map_or(f64::NAN, |u| u[0])).collect()
}

/// A node on springs of 50 along x and 100 across, tied to a held one by element 3.
fn tied(element: &str, line: &str, place: [f64; 3], force: f64) -> String {
    let [x, y, z] = place;
    format!("*NODE\n1, 0., 0., 0.\n2, {x:?}, {y:?}, {z:?}\n")
        + &spring(11, 2, 1, 50.0)
        + &spring(12, 2, 2, 100.0)
        + &spring(13, 2, 3, 100.0)
        + &format!(
            "*ELEMENT, TYPE={element}, ELSET=G\n3, 1, 2\n*GAP, ELSET=G\n{line}\n*BOUNDARY\n1, 1, 3\n{}",
            step(EXACT, &format!("*CLOAD\n2, 1, {force:e}\n"))
        )
}

/// Scenes of D32.
pub fn degenerate() -> Vec<Scene> {
    let (here, above) = ([0.0; 3], [0.0, 0.0, 2.0]);
    let solved = [("GAPCYL", "0.5, 0., 0., 1.", above), ("GAPSPHER", "0.5", here)];
    let refused = [
        ("GAPUNI", "0.5", here, "element 3 (GAPUNI) has no direction"),
        ("GAPCYL", "-0.5, 0., 0., 1.", above, "element 3 (GAPCYL) has no direction"),
        ("GAPSPHER", "-0.5", here, "element 3 (GAPSPHER) has no direction"),
        ("GAPCYL", "0.5, 0., 0., 0.", above, "the axis of GAPCYL elements is missing or 0"),
        ("GAPSPHER", "0.", above, "the distance of GAPSPHER elements is missing or 0"),
    ];
    let open = solved.into_iter().map(|(element, line, at)| {
        Scene::new(format!("{element} {line}, nodes coincide: open, then closed"), move |place| {
            let judged = |force: f64, u: f64| -> Finding {
                let run: Run = place.run(&format!("force_{force}"), &tied(element, line, at, force));
                Finding::converged(&run).measured(&run, |solved| {
                    let pressed = (force - 50.0 * u, solved.pressures());
                    let wrong = pressed.1.iter().fold(0.0, |m: f64, p| m.max((p - pressed.0).abs()));
                    vec![(from_value(u, &along(solved, 2)[1..]), ALGEBRAIC), (wrong / force, ALGEBRAIC)]
                })
            };
            judged(10.0, 0.2).and(judged(100.0, 0.5))
        })
    });
    let without = refused.into_iter().map(|(element, line, at, words)| {
        Scene::new(format!("{element} {line}, nodes {:?} apart", at[2]), move |place| {
            Finding::refused(&place.run("refused", &tied(element, line, at, 10.0)), &[words])
        })
    });
    open.chain(without).collect()
}
