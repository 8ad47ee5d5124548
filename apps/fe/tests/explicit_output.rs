//! What explicit steps print and store, and when.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// A truss of ten elements that is let go with a velocity at its end.
fn bar(steps: &str) -> String {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    (0..=10).for_each(|i| deck += &format!("{}, {}., 0.\n", i + 1, i));
    deck += "*NSET, NSET=END\n11\n*NSET, NSET=FOOT\n1\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n";
    (1..=10).for_each(|i| deck += &format!("{i}, {i}, {}\n", i + 1));
    deck += "*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.\n\
             *BOUNDARY\nFOOT, 1, 1\nALL, 2, 2\n*INITIAL CONDITIONS, TYPE=VELOCITY\nEND, 1, 0.01\n";
    deck + steps
}

/// FREQUENCY prints every so many increments and the last one; without it the end of the step alone.
#[test]
fn tables_come_as_often_as_they_say() {
    let deck = bar("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n*NODE PRINT, NSET=END, FREQUENCY=8\nU\n\
                    *NODE PRINT, NSET=FOOT\nRF\n*NODE PRINT, NSET=FOOT, FREQUENCY=0\nV\n*END STEP\n");
    let tables = Job::run("explicit_tables", &deck).tables();
    let times = |set: &str| -> Vec<f64> { tables.iter().filter(|t| t.set == set).map(|t| t.time).collect() };
    assert_eq!((times("END"), times("FOOT")), (vec![4.0, 8.0, 10.0], vec![10.0]));
}

/// `*BULK VISCOSITY` of a later step holds from there on: with none nothing more is dissipated, and the same before it.
#[test]
fn bulk_viscosity_changes_from_step_to_step() {
    let step = |cards: &str| {
        format!(
            "*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n{cards}*OUTPUT, FIELD, NUMBER INTERVAL=1\n*END STEP\n"
        )
    };
    let dissipated = |name: &str, second: &str| -> Vec<f64> {
        let job = Job::run(name, &bar(&(step("*BULK VISCOSITY\n0.1\n") + &step(second))));
        job.results().real("Signorini/History/Energies").chunks_exact(12).map(|row| row[7]).collect()
    };
    let off = dissipated("viscosity_off", "*BULK VISCOSITY\n0., 0.\n");
    let on = dissipated("viscosity_on", "");
    assert_eq!((off.len(), off[1]), (3, on[1]));
    assert!(off[1] > 0.0 && off[2] == off[1] && on[2] > 1.1 * on[1], "{off:?} {on:?}");
}
