//! How explicit steps end that cannot go on: by a reason with its increment, time, element and energies, and with results that
//! can be read.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::Job;
use common::results::Results;

/// An increment of which every multiple is a binary number: the last one of a step is like all others.
const INCREMENT: f64 = 1.0 / 131_072.0;

/// A mass on a spring of which [`INCREMENT`] is so much of the largest increment 2 √(m/k); so many of them.
fn oscillator(part: f64, increments: usize) -> String {
    let (dt, stiffness) = (INCREMENT, 1e-6 * (2.0 * part / INCREMENT).powi(2));
    let period = dt * increments as f64;
    format!(
        "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n*ELEMENT, TYPE=SPRINGA, ELSET=S\n1, 1, 2\n*SPRING, ELSET=S\n\n{stiffness:e}\n\
         *ELEMENT, TYPE=MASS, ELSET=M\n2, 2\n*MASS, ELSET=M\n1e-6\n*NSET, NSET=BALL\n2\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nBALL, 1, 100.\n*BOUNDARY\n1, 1, 3\n2, 2, 3\n*STEP\n\
         *DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n{dt:e}, {period:e}\n*NODE PRINT, NSET=BALL\nU\n*END STEP\n"
    )
}

/// B06: at 0.999 of the largest increment a swing stays what it is for 1e5 increments, u ≤ v Δt/(2 x √(1 − x²)) with x = ωΔt/2; at
/// 1.01 it grows until the balance of energies is lost, which is said with what the increment should have been.
#[test]
fn b06_increments_below_and_above_the_largest() {
    let scratch = Scratch::new("b06_largest_increment");
    scratch.write("below.inp", &oscillator(0.999, 100_000));
    let below = scratch.fe(&["run", "below.inp"]);
    assert_eq!(below.status, 0, "{}", below.error);
    let x = 0.999f64;
    let bound = 100.0 * INCREMENT / (2.0 * x * (1.0 - x * x).sqrt());
    let results = Results::open(&scratch.path("below.vtkhdf"));
    for frame in 0..results.times().len() {
        let u = results.point_field("U", 3, frame)[3];
        assert!(u.abs() <= bound * (1.0 + 1e-6), "{u} {bound}");
    }
    scratch.write("above.inp", &oscillator(1.01, 100_000));
    let above = scratch.fe(&["run", "above.inp"]);
    assert_eq!(above.status, 1);
    for word in ["in increment 100", "times the energy", "longer than the stable one", "energy in motion"] {
        assert!(above.error.contains(word), "{word}: {}", above.error);
    }
    // What was stored before is there, and the last row of energies tells what was lost.
    let results = Results::open(&scratch.path("above.vtkhdf"));
    assert!(!results.times().is_empty() && !results.real("Signorini/History/Energies").is_empty());
}

/// A cube that hits a rigid plane with a hundredth of the speed of sound, kinematically: half of its energy is in its highest modes
/// from then on, and its increments follow them.
fn hit(procedure: &str) -> String {
    format!(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
         7, 1., 1., 1.\n8, 0., 1., 1.\n9, 0., 0., -1.\n*NSET, NSET=CORNERS, GENERATE\n1, 8\n\
         *ELEMENT, TYPE=C3D8R, ELSET=CUBE\n77, 1, 2, 3, 4, 5, 6, 7, 8\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.3\n*DENSITY\n1.\n\
         *SOLID SECTION, ELSET=CUBE, MATERIAL=M\n*SURFACE, NAME=FOOT\nCUBE, S1\n\
         *SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., -0.01, 1., 0., -0.01\n0., 1., -0.01\nSTART, -9., 0.\nLINE, 9., 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=9\n*BOUNDARY\n9, 1, 6\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nCORNERS, 3, -0.01\n*STEP\n*DYNAMIC, EXPLICIT{procedure}\n\
         *CONTACT PAIR, MECHANICAL CONSTRAINT=KINEMATIC\nFOOT, FLOOR\n\
         *OUTPUT, HISTORY, FREQUENCY=1\n*ENERGY OUTPUT\nETOTAL\n*END STEP\n"
    )
}

/// What changes of the increment give to the highest modes, and take from them, is no loss of the balance: what is left goes with
/// the strain, 1e-2.
#[test]
fn a_cube_that_swings_runs_through() {
    let job = Job::run("halt_not", &hit("\n, 400."));
    let energies = job.results().real("Signorini/History/Energies");
    let rows: Vec<&[f64]> = energies.chunks_exact(15).collect();
    let worst = rows.iter().map(|row| row[13].abs() / rows[0][3]).fold(0.0, f64::max);
    assert!(worst < 1e-2, "{worst}");
}

/// The same cube 1 % above its increment, 2/ω (√(1 + b²) − b) with ω² = 4 (2μ + 3λ) and b = 0.06.
#[test]
fn a_cube_above_its_limit_is_stopped() {
    let increment = 1.01 / 2.5f64.sqrt() * ((1.0 + 0.06f64.powi(2)).sqrt() - 0.06);
    let scratch = Scratch::new("halt_above");
    scratch.write("job.inp", &hit(&format!(", DIRECT USER CONTROL\n{increment}, 400.")));
    let run = scratch.fe(&["run", "job.inp"]);
    assert_eq!(run.status, 1, "{}", run.output);
    for word in ["in increment ", "longer than the stable one", "element 77"] {
        assert!(run.error.contains(word), "{word}: {}", run.error);
    }
}

/// A cube whose top comes down on its foot at a twentieth of the speed of sound: its increments shrink with it, without an end.
#[test]
fn an_element_that_shrinks_to_nothing_ends_the_run() {
    let deck = "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
                7, 1., 1., 1.\n8, 0., 1., 1.\n*NSET, NSET=FOOT\n1, 2, 3, 4\n*NSET, NSET=HEAD\n5, 6, 7, 8\n\
                *ELEMENT, TYPE=C3D8R, ELSET=CUBE\n77, 1, 2, 3, 4, 5, 6, 7, 8\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n\
                *SOLID SECTION, ELSET=CUBE, MATERIAL=M\n*BOUNDARY\nFOOT, 1, 3\nHEAD, 1, 2\n*STEP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=0.2\n, 100.\n\
                *BOUNDARY, TYPE=VELOCITY\nHEAD, 3, 3, -0.05\n*END STEP\n";
    let scratch = Scratch::new("halt_collapse");
    scratch.write("flat.inp", deck);
    let run = scratch.fe(&["run", "flat.inp"]);
    assert_eq!(run.status, 1, "{}", run.output);
    for word in
        ["step 1 ended at step time 1.99", "in increment ", "stable increment has shrunk", "element 77", "energy"]
    {
        assert!(run.error.contains(word), "{word}: {}", run.error);
    }
    assert!(!Results::open(&scratch.path("flat.vtkhdf")).times().is_empty());
}

/// Numbers beyond all numbers end a run with the node they act on.
#[test]
fn forces_without_an_end_end_the_run() {
    let deck = oscillator(0.5, 1000).replace("*NODE PRINT", "*CLOAD\n2, 1, 1e308\n*NODE PRINT");
    let scratch = Scratch::new("halt_unbounded");
    scratch.write("job.inp", &deck);
    let run = scratch.fe(&["run", "job.inp"]);
    assert_eq!(run.status, 1);
    assert!(run.error.contains("in increment ") && run.error.contains("the force on node"), "{}", run.error);
    assert!(!Results::open(&scratch.path("job.vtkhdf")).times().is_empty());
}
