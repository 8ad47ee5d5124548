//! D23: tubes in each other with next to no clearance, or none. Two cantilever pipes of length 1000 along x (A07), of ten
//! cubic beams each, the inner one pressed against the outer one at its tip.

use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, EXACT};
use crate::hard::run::Solved;
use crate::hard::{Place, Run, Scene};
use std::f64::consts::PI;

const LENGTH: f64 = 1000.0;
const YOUNG: f64 = 210_000.0;
/// Outer and inner diameter of the inner pipe and of the outer one [L].
const DIAMETERS: [[f64; 2]; 2] = [[44.0, 36.0], [60.0, 50.0]];

/// The pipes.
pub struct Pipes {
    /// How far the scene is moved along every axis [L].
    pub by: f64,
    /// Radial clearance [L].
    pub clearance: f64,
    /// Force on the inner tip [F], in the plane of y and z.
    pub load: [f64; 2],
}

impl Default for Pipes {
    /// A07.
    fn default() -> Self {
        Pipes { by: 0.0, clearance: 3.0, load: [-2000.0, 0.0] }
    }
}

/// Area and moment of inertia of a pipe.
fn pipe([outside, inside]: [f64; 2]) -> [f64; 2] {
    let of = |n: i32| PI * (outside.powi(n) - inside.powi(n));
    [of(2) / 4.0, of(4) / 64.0]
}

/// Their deck: inner nodes 1…11, outer ones 101…111.
pub fn pipes(Pipes { by, clearance, load: [across, up] }: &Pipes) -> String {
    let (mut nodes, mut inner, mut outer, mut line) = (String::new(), String::new(), String::new(), Vec::new());
    for i in 0..=10 {
        let x = 0.1 * LENGTH * f64::from(i) + by;
        nodes += &format!("{}, {x:e}, {by:e}, {by:e}\n{}, {x:e}, {by:e}, {by:e}\n", i + 1, i + 101);
        line.push((i + 101).to_string());
        if i > 0 {
            inner += &format!("{i}, {i}, {}\n", i + 1);
            outer += &format!("{}, {}, {}\n", i + 100, i + 100, i + 101);
        }
    }
    let section = |set: &str, diameters: [f64; 2]| {
        let [area, second] = pipe(diameters);
        format!(
            "*BEAM GENERAL SECTION, ELSET={set}, SECTION=GENERAL\n{area:e}, {second:e}, 0., {second:e}, {:e}\n\
             0., 0., 1.\n{YOUNG}, 80769.\n",
            2.0 * second
        )
    };
    format!(
        "*NODE\n{nodes}*ELEMENT, TYPE=B33, ELSET=INNER\n{inner}*ELEMENT, TYPE=B33, ELSET=OUTER\n{outer}{}{}\
         *ELEMENT, TYPE=ITT31, ELSET=TUBES\n201, 11\n*INTERFACE, ELSET=TUBES\n{clearance:e}\n\
         *SLIDE LINE, ELSET=TUBES, TYPE=LINEAR\n{}\n*BOUNDARY\n1, 1, 6\n101, 1, 6\n{}",
        section("INNER", DIAMETERS[0]),
        section("OUTER", DIAMETERS[1]),
        line.join(", "),
        patch::step(EXACT, &format!("*CLOAD\n11, 2, {across:e}\n11, 3, {up:e}\n"))
    )
}

/// Scenes of D23.
pub fn thin() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (words, clearance) in [("1e-9 of the radius", 22e-9), ("0", 0.0)] {
        for angle in [0.0, 0.7] {
            scenes.push(Scene::new(format!("clearance {words}, load at {angle}"), move |place| {
                pressed(place, clearance, angle)
            }));
        }
    }
    scenes.push(Scene::new("concentric, no load: open", |place| {
        let run = place.run("open", &pipes(&Pipes { load: [0.0; 2], ..Pipes::default() }));
        let largest = |numbers: &[f64]| numbers.iter().fold(0.0, |m: f64, n| m.max(n.abs()));
        Finding::converged(&run)
            .measured(&run, |solved| vec![(largest(&solved.u), 0.0), (largest(&solved.pressures()), 0.0)])
    }));
    scenes.push(Scene::new("concentric, clearance below 0", |place| {
        let run = place.run("refused", &pipes(&Pipes { clearance: -3.0, ..Pipes::default() }));
        Finding::refused(&run, &["element 201 (ITT31) has no direction"])
    }));
    scenes
}

/// N = (P/k_i − c)/(1/k_i + 1/k_o) and both tips' ways along the load, k = 3EI/L³.
fn pressed(place: &Place, clearance: f64, angle: f64) -> Finding {
    let (load, (sine, cosine)) = (2000.0, angle.sin_cos());
    let [inner, outer] = DIAMETERS.map(|diameters| 3.0 * YOUNG * pipe(diameters)[1] / LENGTH.powi(3));
    let force = (load / inner - clearance) / (1.0 / inner + 1.0 / outer);
    let run: Run =
        place.run("pipes", &pipes(&Pipes { clearance, load: [load * cosine, load * sine], ..Pipes::default() }));
    let tip =
        |solved: &Solved, label: u64| solved.displacement(label).map_or(f64::NAN, |u| u[1] * cosine + u[2] * sine);
    Finding::converged(&run).measured(&run, |solved| {
        vec![
            (from_value(force, &solved.pressures()), 1e-6),
            (from_value((load - force) / inner, &[tip(solved, 11)]), 1e-6),
            (from_value(force / outer, &[tip(solved, 111)]), 1e-6),
        ]
    })
}
