//! Mass scaling: exact on trusses, whose stable increment is l √(ρ/E); told in plan and results.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, close};

/// Ten trusses of length 1 with E = ρ = A = 1, but one of a quarter; without bulk viscosity, unless another is given.
fn chain(cards: &str, viscosity: &str) -> String {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    (0..=9).for_each(|i| deck += &format!("{}, {}., 0.\n", i + 1, i));
    deck += "11, 9.25, 0.\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n";
    (1..=10).for_each(|i| deck += &format!("{i}, {i}, {}\n", i + 1));
    deck += "*ELSET, ELSET=SHORT\n10\n*ELSET, ELSET=FIRST\n1\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n\
             *SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.\n*BOUNDARY\nALL, 2, 2\n*INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 1, 0.01\n";
    deck + &format!(
        "*STEP\n*DYNAMIC, EXPLICIT\n, 10.\n*BULK VISCOSITY\n{viscosity}\n{cards}\n\
         *OUTPUT, FIELD, FREQUENCY=1\n*END STEP\n"
    )
}

/// Numbers of a row of the energies.
const ENERGIES: usize = 12;

/// Mass that was added [%] and increment of the second frame; ETOTAL over ALLKE at most.
fn told(job: &Job) -> ([f64; 2], f64) {
    let rows = job.results().real("Signorini/History/Energies");
    let rows: Vec<&[f64]> = rows.chunks_exact(3 + ENERGIES).map(|row| &row[3..]).collect();
    let off = rows.iter().map(|row| (row[ENERGIES - 2] / row[0]).abs()).fold(0.0, f64::max);
    ([rows[1][ENERGIES - 3], rows[1][ENERGIES - 1]], off)
}

/// Increments are 0.98 of the stable one. The chain moves as a whole: it stays as it is, and has no forces.
#[test]
fn a_short_truss_is_given_the_mass_of_the_increment() {
    let cases = [
        ("none", "", 0.0, 0.25),
        ("below", "*FIXED MASS SCALING, DT=1., TYPE=BELOW MIN", 100.0 * 3.75 / 9.25, 1.0),
        ("below_all", "*FIXED MASS SCALING, DT=2., TYPE=BELOW MIN", 100.0 * (27.0 + 15.75) / 9.25, 2.0),
        ("uniform", "*FIXED MASS SCALING, DT=1., TYPE=UNIFORM", 1500.0, 1.0),
        ("equal", "*FIXED MASS SCALING, DT=0.5, TYPE=SET EQUAL DT", 100.0 * (-9.0 * 0.75 + 0.75) / 9.25, 0.5),
        ("factor", "*FIXED MASS SCALING, FACTOR=4.", 300.0, 0.5),
        ("set", "*FIXED MASS SCALING, ELSET=SHORT, FACTOR=9.", 100.0 * 2.0 / 9.25, 0.75),
        (
            "both",
            "*FIXED MASS SCALING, ELSET=FIRST, FACTOR=3.\n*FIXED MASS SCALING, DT=1., TYPE=BELOW MIN, ELSET=SHORT",
            100.0 * (2.0 + 3.75) / 9.25,
            1.0,
        ),
        ("variable", "*VARIABLE MASS SCALING, DT=1., TYPE=BELOW MIN, FREQUENCY=3", 100.0 * 3.75 / 9.25, 1.0),
    ];
    for (name, cards, added, stable) in cases {
        let job = Job::run(&format!("mass_scaling_{name}"), &chain(cards, "0., 0."));
        let (got, off) = told(&job);
        close(name, got, [added, 0.98 * stable], 1e-12 * added.abs().max(1.0));
        assert!(off < 1e-12, "{name}: {off}");
        assert_eq!(job.plan().contains("mass scaling"), added != 0.0, "{name}");
    }
    // Bulk viscosity takes √(1 + b²) − b, of its own of the scaled truss too: the increment is the one that was asked for.
    let job = Job::run("mass_scaling_viscous", &chain("*FIXED MASS SCALING, DT=0.5, TYPE=BELOW MIN", "0.06, 1.2"));
    let b = 0.06f64;
    // Δt(f) = l √(ρ/E) (√(f + b²) − b).
    let f = (0.5 / 0.25 + b).powi(2) - b * b;
    close("viscous", told(&job).0, [100.0 * 0.25 * (f - 1.0) / 9.25, 0.98 * 0.5], 1e-12);
}

/// A truss that is pressed to a half of its length keeps its increment, by four times its mass in the end; the balance of
/// energies counts what that gives.
#[test]
fn variable_scaling_follows_the_motion() {
    let deck = |cards: &str| {
        format!(
            "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 2., 0.\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n1, 1, 2\n2, 2, 3\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.\n\
             *BOUNDARY\n1, 1, 2\n2, 2, 2\n3, 2, 2\n*STEP\n*DYNAMIC, EXPLICIT\n, 100.\n*BULK VISCOSITY\n0., 0.\n\
             *BOUNDARY, TYPE=VELOCITY\n3, 1, 1, -0.01\n{cards}\n*OUTPUT, FIELD, FREQUENCY=1\n*END STEP\n"
        )
    };
    let job = Job::run("mass_scaling_pressed", &deck("*VARIABLE MASS SCALING, DT=1., TYPE=BELOW MIN, FREQUENCY=1"));
    let rows = job.results().real("Signorini/History/Energies");
    let rows: Vec<&[f64]> = rows.chunks_exact(3 + ENERGIES).map(|row| &row[3..]).collect();
    let last = rows[rows.len() - 1];
    // Both have l = 1/2 but for the wave of 1 % that runs in them: 300 % more mass, 2 · 2 Δl/l of it.
    assert!((last[ENERGIES - 3] - 300.0).abs() < 300.0 * 0.06, "{last:?}");
    // The last two share what is left.
    let steady = &rows[1..rows.len() - 2];
    assert!(steady.iter().all(|row| (row[ENERGIES - 1] / 0.98 - 1.0).abs() < 1e-12));
    let largest = last[1];
    assert!(rows.iter().all(|row| row[ENERGIES - 2].abs() < 1e-3 * largest));
}

/// Solids, in space and in the plane: four times the mass makes increments of twice the length, and DT the one that was asked for.
#[test]
fn solids_are_scaled() {
    let cube = "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 0.5\n6, 1., 0., 0.5\n\
                7, 1., 1., 0.5\n8, 0., 1., 0.5\n*ELEMENT, TYPE=C3D8R, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";
    let square =
        "*NODE, NSET=ALL\n1, 0., 0.\n2, 1., 0.\n3, 1., 0.5\n4, 0., 0.5\n*ELEMENT, TYPE=CPE4R, ELSET=E\n1, 1, 2, 3, 4\n";
    let (brick, plane) = (cube.replace("C3D8R", "C3D8"), square.replace("CPE4R", "CPE4"));
    for (name, mesh) in [("cube", cube), ("square", square), ("brick", &brick), ("plane", &plane)] {
        let increment = |suffix: &str, cards: &str| {
            let deck = format!(
                "{mesh}*MATERIAL, NAME=M\n*ELASTIC\n1., 0.3\n*DENSITY\n1.\n*SOLID SECTION, ELSET=E, MATERIAL=M\n\
                 *INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 1, 0.01\n*STEP\n*DYNAMIC, EXPLICIT\n, 20.\n\
                 *BULK VISCOSITY\n0., 0.\n{cards}\n*OUTPUT, FIELD, FREQUENCY=1\n*END STEP\n"
            );
            told(&Job::run(&format!("mass_scaling_{name}_{suffix}"), &deck)).0
        };
        let [none, own] = increment("own", "");
        let [added, twice] = increment("factor", "*FIXED MASS SCALING, FACTOR=4.");
        close("factor", [none, added, twice], [0.0, 300.0, 2.0 * own], 1e-12 * 300.0);
        let [_, asked] = increment("aimed", "*FIXED MASS SCALING, DT=1.5, TYPE=SET EQUAL DT");
        close("aimed", [asked], [0.98 * 1.5], 1e-12);
    }
}
