//! D10, D11: softened laws at the edge of what numbers and loads allow, on the slider: a brick of stiffness 1000 before a
//! rigid stop at 0.1, pressed towards it by a force, k x + A p(x − g₀) = F with A = 1.

use crate::hard::Scene;
use crate::hard::finding::{Finding, from_value};
use crate::hard::run::{Place, Run, Solved};

/// Stiffness k [F/L] of the brick.
const SPRING: f64 = 1000.0;
/// Distance g₀ [L] of the stop.
const DISTANCE: f64 = 0.1;
/// Diagonal [L] of the box around brick and reference node.
const SIZE: f64 = 6.2;
/// Relative bound of a discrete problem that has the closed answer.
const ALGEBRAIC: f64 = 1e-10;

/// Starts at a clearance, kink, plateau at 10, last slope 600 continued.
const TABLE: &str = "0., -0.02\n10., 0.\n10., 0.05\n200., 0.10\n260., 0.20";

/// Supports: the far face held; or held across alone.
const HELD: &str = "5, 1, 3\n6, 1, 3\n7, 1, 3\n8, 1, 3";
const FREE: &str = "1, 1, 2\n2, 2\n4, 1\n5, 1, 2\n6, 2\n8, 1";

/// The slider; `steps` hold the loads.
fn deck(law: &str, data: &str, held: &str, steps: &str) -> String {
    brick([1.0; 2], (law, data), held, steps)
}

/// In units of length and force.
fn brick([l, f]: [f64; 2], (law, data): (&str, &str), held: &str, steps: &str) -> String {
    let corner = |x: f64, y: f64, z: f64| format!("{:e}, {:e}, {:e}", x * l, y * l, z * l);
    let corners = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)];
    let mut text = String::from("*NODE\n");
    for (i, (x, y)) in corners.into_iter().enumerate() {
        text += &format!("{}, {}\n{}, {}\n", i + 1, corner(x, y, 0.0), i + 5, corner(x, y, 1.0));
    }
    let stop = -DISTANCE;
    text + &format!(
        "99, {}\n*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*MATERIAL, NAME=M\n*ELASTIC\n{:e}, 0.\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=NEAR\nE, S1\n*SURFACE, NAME=FAR\nE, S2\n\
         *SURFACE, NAME=STOP, TYPE=CYLINDER\n{}, {}\n{}\nSTART, {:e}, 0.\nLINE, {:e}, 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=STOP, REF NODE=99\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law}\n{data}\n\
         *CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nNEAR, STOP\n*BOUNDARY\n{held}\n99, 1, 2\n99, 4, 6\n{steps}",
        corner(0., 0., -5.),
        SPRING * f / (l * l),
        corner(0., 0., stop),
        corner(1., 0., stop),
        corner(0., 1., stop),
        -l,
        2.0 * l,
    )
}

/// A step in which the stop stands at `stop` [L] and a pressure acts on a surface.
fn step(stop: f64, surface: &str, pressure: f64) -> String {
    format!(
        "*STEP\n*STATIC\n*CONTROLS, PARAMETERS=FIELD\n1e-12, , , , 1e-12\n*BOUNDARY\n99, 3, 3, {stop:e}\n*DSLOAD\n{surface}, P, \
         {pressure:e}\n*END STEP\n"
    )
}

/// Pulled towards the stop by a force on the near face.
fn pulled(law: &str, data: &str, force: f64) -> String {
    deck(law, data, HELD, &step(0.0, "NEAR", -force))
}

/// The slider with an exponential law (A03) in units of length, force and time.
pub fn exponential([l, f, _]: [f64; 3]) -> String {
    let p = f / (l * l);
    let data = format!("{:e}, {:e}", 0.05 * l, 200.0 * p);
    brick([l, f], ("EXPONENTIAL", &data), HELD, &step(0.0, "NEAR", -500.0 * p))
}

/// Displacement of the near face towards the stop [L], and of the far face.
fn displacement(solved: &Solved) -> [f64; 2] {
    [1, 5].map(|label| solved.displacement(label).map_or(f64::NAN, |u| -u[2]))
}

fn overclosures(solved: &Solved) -> impl Iterator<Item = f64> {
    solved.pairs.iter().flat_map(|pair| pair.points.iter().map(|point| -point.opening))
}

/// Scenes of D10, with h/c₀ and the contact force F − k x of F = 500, p₀ = 50, computed with 60 digits.
pub fn tiny_clearance() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (clearance, ratio, force) in [
        (1e-2, 1.0284678230704083, 389.7153217692959),
        (1e-5, 1.0443236998392363, 399.9895567630016),
        (1e-8, 1.0443396242952999, 399.9999895566038),
        (1e-11, 1.0443396402198229, 399.9999999895566),
    ] {
        for (from, first) in [("0", String::new()), ("0.2", step(-0.3, "NEAR", -200.0))] {
            scenes.push(Scene::new(format!("c0 = {clearance:e}, from x = {from}"), move |place| {
                let slider = |steps: &str| deck("EXPONENTIAL", &format!("{clearance:e}, 50."), HELD, steps);
                let before = if first.is_empty() { 0 } else { place.run("first", &slider(&first)).iterations };
                let run = place.run("slider", &slider(&format!("{first}{}", step(0.0, "NEAR", -500.0))));
                // Gaps are known to a few units of rounding of the model's size, and the law is that steep.
                let rounding = ALGEBRAIC + 4.0 * f64::EPSILON * SIZE / clearance;
                let iterations = run.iterations - before;
                let words = format!("{iterations} iterations are more than 15");
                Finding::converged(&run).holds(iterations <= 15, words).measured(&run, |solved| {
                    let [x, _] = displacement(solved);
                    vec![
                        (from_value(force, &[500.0 - SPRING * x]), ALGEBRAIC),
                        (from_value(ratio, &overclosures(solved).map(|h| h / clearance).collect::<Vec<_>>()), rounding),
                        (from_value(force, &solved.pressures()), ALGEBRAIC),
                    ]
                })
            }));
        }
    }
    scenes
}

/// Scenes of D11.
pub fn odd() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (force, x) in [(90.0, 0.08 + 0.02 / 3.0), (140.0, 0.13), (300.0, 0.179 + 0.0005 / 3.0)] {
        scenes.push(Scene::new(format!("table with kinks, F = {force}"), move |place| {
            let run = place.run("slider", &pulled("TABULAR", TABLE, force));
            // One iteration for each of its pieces, and one to see it.
            at(&run, x, ALGEBRAIC).holds(run.iterations <= 6, "more iterations than pieces")
        }));
    }
    scenes.push(Scene::new("a plateau alone holds, F = 10", |place| {
        Finding::refused(&plateau(place, 10.0), &["body E has no unique position", "along z"])
    }));
    for (force, overclosure) in [(9.9, -0.0002), (10.001, 0.05 + 0.001 / 3800.0), (12.0, 0.05 + 2.0 / 3800.0)] {
        scenes.push(Scene::new(format!("a plateau alone holds, F = {force}"), move |place| {
            at(&plateau(place, force), DISTANCE + overclosure, ALGEBRAIC)
        }));
    }
    scenes.push(Scene::new("table from -0.02 on, F = 0", |place| {
        let run = place.run("slider", &pulled("TABULAR", TABLE, 0.0));
        let largest = |solved: &Solved| displacement(solved)[0].abs();
        Finding::converged(&run).measured(&run, |solved| vec![(largest(solved), 0.0)])
    }));
    scenes.push(Scene::new("slope 1e15", |place| {
        let run = place.run("slider", &pulled("LINEAR", "1e15", 500.0));
        at(&run, DISTANCE, 1e-9)
            .measured(&run, |solved| vec![(from_value(400.0, &[500.0 - SPRING * displacement(solved)[0]]), 1e-9)])
    }));
    scenes.push(Scene::new("first pressure above 0", |place| {
        let run = place.run("slider", &pulled("TABULAR", "10., 0.\n30., 0.1", 300.0));
        // 1000 x + 10 + 200 (x − 0.1) = 300.
        Finding::warned(&run, &["jumps from 0 to 10"]).and(at(&run, 310.0 / 1200.0, ALGEBRAIC))
    }));
    scenes.push(Scene::new("pressure falls within the table", |place| {
        let run = place.run("slider", &pulled("TABULAR", "0., 0.\n10., 0.1\n5., 0.2\n50., 0.3", 250.0));
        // 1000 (0.1 + h) + 10 − 50 (h − 0.1) = 250.
        Finding::warned(&run, &["falls between the overclosures 0.1 and 0.2"]).and(at(
            &run,
            DISTANCE + 135.0 / 950.0,
            ALGEBRAIC,
        ))
    }));
    for (name, law, data, words) in [
        ("slope 0", "LINEAR", "0.", "must be > 0"),
        ("slope below 0", "LINEAR", "-1.", "must be > 0"),
        ("table that goes back", "TABULAR", "0., 0.\n1., 0.2\n2., 0.1", "must ascend"),
        ("table that falls in the end", "TABULAR", "0., 0.\n2., 0.1\n1., 0.2", "falls from 2 to 1 at the end"),
    ] {
        scenes.push(Scene::new(name, move |place| {
            Finding::refused(&place.run("slider", &pulled(law, data, 500.0)), &[words])
        }));
    }
    scenes
}

/// The brick free along its axis, pressed onto the stop by a force on its far face.
fn plateau(place: &Place, force: f64) -> Run {
    place.run("slider", &deck("TABULAR", TABLE, FREE, &step(0.0, "FAR", force)))
}

/// Solved with the near face at `x`.
fn at(run: &Run, x: f64, bound: f64) -> Finding {
    Finding::converged(run).measured(run, |solved| vec![(from_value(x, &displacement(solved)[..1]), bound)])
}
