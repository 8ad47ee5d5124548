//! Contact pairs of explicit steps through the program: laws beside the static ones, bars that hit each other.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, close, relative};

/// A mass on a spring of 1000 before a stop at a distance of 0.1; its law is that of the deck.
const SLIDER: &str = "*NODE\n1, -1., -1., 0.\n2, 1., -1., 0.\n3, 1., 1., 0.\n4, -1., 1., 0.\n9, 0., 0., -1.\n20, 0., 0., 0.1\n\
    *NSET, NSET=STOP\n9\n*NSET, NSET=SLIDER\n20\n*ELEMENT, TYPE=SPRING1, ELSET=SPR\n1, 20\n*SPRING, ELSET=SPR\n3\n1000.\n";

/// What follows the law in a static step.
fn statically(law: &str, force: f64) -> Job {
    let deck = format!(
        "{SLIDER}*ELEMENT, TYPE=GAPUNI, ELSET=GAP\n2, 9, 20\n*GAP, ELSET=GAP\n0.1, 0., 0., 1.\n{law}*BOUNDARY\nSTOP, 1, 3\n\
         SLIDER, 1, 2\n*STEP\n*STATIC\n0.1, 1., 1e-5, 0.1\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n*CLOAD\nSLIDER, 3, -{force}\n{PRINTS}"
    );
    Job::run("slow_static", &deck)
}

const PRINTS: &str =
    "*NODE PRINT, NSET=SLIDER, FREQUENCY=100000\nU\n*NODE PRINT, NSET=STOP, FREQUENCY=100000\nRF\n*END STEP\n";

/// The same in an explicit step: the force rises by a smooth step over T = 300/ω and stays.
fn slowly(law: &str, force: f64, constraint: &str) -> Job {
    let deck = format!(
        "{SLIDER}*ELEMENT, TYPE=MASS, ELSET=M\n2, 20\n*MASS, ELSET=M\n1.\n*ELEMENT, TYPE=R3D4, ELSET=WALL\n3, 1, 2, 3, 4\n\
         *RIGID BODY, REF NODE=9, ELSET=WALL\n*SURFACE, NAME=WALLS, TYPE=ELEMENT\nWALL, SPOS\n*SURFACE, NAME=BALLS, TYPE=NODE\n\
         SLIDER,\n*SURFACE INTERACTION, NAME=I\n{law}*AMPLITUDE, NAME=SLOW, DEFINITION=SMOOTH STEP\n0., 0., 9.5, 1.\n\
         *BOUNDARY\nSTOP, 1, 6\nSLIDER, 1, 2\n*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n1e-3, 12.\n\
         *CONTACT PAIR, INTERACTION=I, MECHANICAL CONSTRAINT={constraint}\nBALLS, WALLS\n*CLOAD, AMPLITUDE=SLOW\n\
         SLIDER, 3, -{force}\n{PRINTS}"
    );
    Job::run("slow_explicit", &deck)
}

/// B18 with A02, A03, A05 and a formula: the same laws, the same answers in slow explicit steps as in static ones. Where a law
/// sets in, it starts a swing, which damping stills; that of the load's end is 120/(ωT)³ = 5e-6.
#[test]
fn b18_slow_explicit() {
    let behavior = |law: &str| format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={law}\n");
    let laws = [
        (behavior("LINEAR\n4000."), 500.0, 0.18),
        (behavior("EXPONENTIAL\n0.05, 200."), 500.0, 0.113951372312813),
        (behavior("TABULAR\n0., -0.02\n10., 0.\n10., 0.05\n200., 0.10\n260., 0.20"), 300.0, 0.1791666666666667),
        (behavior("FORMULA\np = k*h^1.5\nk = 20000"), 500.0, f64::NAN),
    ];
    for (law, force, expected) in laws {
        let fixed = statically(&law, force);
        let (x, n) = (-fixed.last("displacements", "SLIDER", 3), fixed.last("forces", "STOP", 3));
        if expected.is_finite() {
            relative(&law, [x], [expected], 1e-9);
        }
        for constraint in ["PENALTY", "KINEMATIC"] {
            let damped = law.clone() + "*CONTACT DAMPING, DEFINITION=CRITICAL DAMPING FRACTION\n0.3\n";
            let job = slowly(&damped, force, constraint);
            let what = format!("{constraint} {law}");
            relative(&what, [-job.last("displacements", "SLIDER", 3)], [x], 1e-5);
            // K x/N times that of x, K the slope of the law.
            relative(&what, [job.last("forces", "STOP", 3)], [n], 5e-5);
        }
    }
    // A01: hard kinematic contact holds it at the stop with what the spring leaves.
    let hard = slowly("", 500.0, "KINEMATIC");
    close("hard", [-hard.last("displacements", "SLIDER", 3)], [0.1], 1e-10);
    relative("hard", [hard.last("forces", "STOP", 3)], [400.0], 1e-9);
}

/// Two bars of n cubes each, ν = 0, the one at 1000 onto the other one at rest.
fn two_bars(n: usize, contact: &str) -> Job {
    let (mut nodes, mut elements) = (String::new(), String::new());
    let mut sets = [String::new(), String::new()];
    for (side, set) in sets.iter_mut().enumerate() {
        let label = |layer: usize, corner: usize| 1 + 4 * (side * (n + 1) + layer) + corner;
        for layer in 0..=n {
            let z = if side == 0 { layer as f64 } else { -(layer as f64) };
            for (corner, [x, y]) in [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].into_iter().enumerate() {
                nodes += &format!("{}, {x}, {y}, {z}\n", label(layer, corner));
            }
        }
        *set = format!("{}, {}, 1\n", label(0, 0), label(n, 3));
        for layer in 0..n {
            let (low, high) = if side == 0 { (layer, layer + 1) } else { (layer + 1, layer) };
            let all = (0..4).map(|c| label(low, c)).chain((0..4).map(|c| label(high, c)));
            let all: Vec<String> = all.map(|node| node.to_string()).collect();
            elements += &format!("{}, {}\n", 1 + side * n + layer, all.join(", "));
        }
    }
    let period = 2.6 * n as f64 / WAVE;
    let deck = format!(
        "*NODE\n{nodes}*NSET, NSET=STRIKER, GENERATE\n{}*NSET, NSET=STRUCK, GENERATE\n{}\
         *ELEMENT, TYPE=C3D8R, ELSET=BARS\n{elements}*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.\n*DENSITY\n7.85e-9\n\
         *SOLID SECTION, ELSET=BARS, MATERIAL=STEEL\n*SURFACE, NAME=UPPER\n1, S1\n*SURFACE, NAME=LOWER\n{}, S2\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nSTRIKER, 3, -1000.\n*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n{}, {period}\n\
         *BULK VISCOSITY\n0., 0.\n*CONTACT PAIR{contact}\nUPPER, LOWER\n*NODE PRINT, NSET=STRIKER, FREQUENCY=100000\nV\n\
         *NODE PRINT, NSET=STRUCK, FREQUENCY=100000\nV\n*END STEP\n",
        sets[0],
        sets[1],
        n + 1,
        0.5 / WAVE,
    );
    Job::run("two_bars", &deck)
}

/// √(E/ρ).
const WAVE: f64 = 5172194.15303;

/// B02: the striker stops and the struck bar leaves with its velocity, to 1/n; balanced contact, which is usual, the first
/// surface as the only secondary one, and a penalty.
#[test]
fn b02_two_bars() {
    let n = 20;
    for contact in ["", ", WEIGHT=0.", ", MECHANICAL CONSTRAINT=PENALTY"] {
        let job = two_bars(n, contact);
        let tables = job.tables();
        let mean = |set: &str| {
            let table = tables.iter().rfind(|table| table.title.starts_with("velocities") && table.set == set).unwrap();
            let layers: Vec<f64> =
                table.rows.chunks(4).map(|four| four.iter().map(|row| row.values[2]).sum::<f64>() / 4.0).collect();
            assert_eq!(layers.len(), n + 1);
            (layers.iter().sum::<f64>() - 0.5 * (layers[0] + layers[n])) / n as f64
        };
        let (striker, struck) = (mean("STRIKER"), mean("STRUCK"));
        close(&format!("momentum{contact}"), [striker + struck], [-1000.0], 1e-5);
        close(contact, [striker], [0.0], 1000.0 / n as f64);
        let weights = job.told.matches("of weight 0.5").count() + job.plan().matches("of weight 0.5").count();
        assert_eq!(weights > 0, contact.is_empty(), "{}", job.plan());
    }
}
