//! A19: interference and clearance. A column of stiffness k = E A / L = 100 that overlaps a rigid stop by 0.1, or stands
//! away from it; hard by multipliers, or LINEAR with 400.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, PRINTED};

const HARD: &str = "*SURFACE INTERACTION, NAME=I\n";
const PAIR: &str = "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, SMALL SLIDING\nSEC, FLOOR\n";
const STEP: &str = "*STEP\n*STATIC, DIRECT\n0.25, 1.\n";

/// The column from z = 0 to 10, its upper end held, and a rigid floor that overlaps it by so much.
fn column(overlap: f64) -> String {
    format!(
        "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 10.\n6, 1., 0., 10.\n\
         7, 1., 1., 10.\n8, 0., 1., 10.\n99, 0., 0., -5.\n*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         *NSET, NSET=HELD\n5, 6, 7, 8\n*NSET, NSET=REF\n99\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*SURFACE, NAME=SEC\nE, S1\n\
         *SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., {overlap}, 1., 0., {overlap}\n0., 1., {overlap}\n\
         START, -1., 0.\nLINE, 2., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=99\n*AMPLITUDE, NAME=LATE\n\
         0., 1., 0.5, 1., 1., 0.\n*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n"
    )
}

/// Forces on the floor and gaps of the first point, increment by increment.
fn run(name: &str, model: &str, steps: &str) -> (Vec<f64>, Vec<f64>) {
    let prints = "*NODE PRINT, NSET=REF\nRF\n*CONTACT PRINT\nCDISP\n*END STEP\n";
    let job = Job::run(name, &format!("{model}{}", steps.replacen("*END STEP\n", prints, 1)));
    (job.all("forces", "REF", 3), job.all("relative contact displacement", "", 1))
}

/// To the digits printed of the largest.
fn close(what: &str, got: &[f64], expected: &[f64]) {
    common::job::close(what, got, expected, PRINTED * expected.iter().fold(0.0f64, |m, e| m.max(e.abs())));
}

/// The overlap that is let be ramps to 0: the reaction on the floor is 10 t, and the gap that counts is 0.
#[test]
fn a19_interference_ramps_over_the_step() {
    let ways = [
        ("interference_value", "*CONTACT INTERFERENCE\nSEC, FLOOR, 0.1\n"),
        ("interference_shrink", "*CONTACT INTERFERENCE, SHRINK\nSEC, FLOOR\n"),
        ("interference_direction", "*CONTACT INTERFERENCE, TYPE=CONTACT PAIR\nSEC, FLOOR, 0.1, 0., 0., 5.\n"),
        // Twice as far along a direction at 60° to the normal.
        ("interference_oblique", "*CONTACT INTERFERENCE\nSEC, FLOOR, 0.2, 0., 1.7320508075688772, 1.\n"),
    ];
    for (name, card) in ways {
        let model = column(0.1) + HARD + PAIR;
        let (forces, gaps) = run(name, &model, &format!("{STEP}{card}*END STEP\n"));
        close(name, &forces, &[2.5, 5.0, 7.5, 10.0]);
        // Nothing but what the residual leaves; 0.1 is the size of the overlap.
        assert!(gaps.iter().all(|g| g.abs() < 1e-10 * 0.1), "{name}: {gaps:?}");
    }
}

/// Along an amplitude; held in the next step; replaced there by a lesser one, and taken away.
#[test]
fn interference_goes_from_step_to_step() {
    let model = column(0.1) + HARD + PAIR;
    let late = "*CONTACT INTERFERENCE, AMPLITUDE=LATE\nSEC, FLOOR, 0.1\n*END STEP\n";
    let (forces, _) = run("interference_late", &model, &format!("{STEP}{late}"));
    // At t = 0.25, 0.5 the whole overlap is let be: the surfaces touch.
    close("amplitude", &forces, &[0.0, 0.0, 5.0, 10.0]);
    let short =
        "*STEP\n*STATIC, DIRECT\n0.5, 0.5\n*CONTACT INTERFERENCE, AMPLITUDE=LATE\nSEC, FLOOR, 0.06\n*END STEP\n";
    let stays = format!("{short}*STEP\n*STATIC\n*END STEP\n");
    let (forces, _) = run("interference_stays", &model, &stays);
    close("held", &forces, &[4.0, 4.0]);
    let replaced =
        format!("{short}*STEP\n*STATIC, DIRECT\n0.5, 1.\n*CONTACT INTERFERENCE, OP=NEW\nSEC, FLOOR, 0.02\n*END STEP\n");
    let (forces, _) = run("interference_replaced", &model, &replaced);
    close("replaced", &forces, &[4.0, 9.0, 10.0]);
}

/// Without the card all of it is pressed out in the first increment; ADJUST takes it away; a softened law shares it.
#[test]
fn a19_overlap_without_interference() {
    let (forces, _) = run("overlap", &(column(0.1) + HARD + PAIR), &format!("{STEP}*END STEP\n"));
    close("default", &forces, &[10.0; 4]);
    let adjusted = PAIR.replace("SMALL SLIDING", "SMALL SLIDING, ADJUST=0.");
    // Where the nodes go to a coordinate that is rounded, the gaps are a few ε of the model's size, and so are the forces.
    for overlap in [0.125, 0.1] {
        let (forces, _) = run("overlap_adjusted", &(column(overlap) + HARD + &adjusted), &format!("{STEP}*END STEP\n"));
        assert!(forces.iter().all(|f| f.abs() < 1e-12 * 10.0), "ADJUST to {overlap}: {forces:?}");
    }
    let law = "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n400.\n";
    let (forces, _) = run("overlap_linear", &(column(0.1) + law + PAIR), &format!("{STEP}*END STEP\n"));
    close("LINEAR 400", &forces, &[8.0; 4]);
}

/// CLEARANCE 0.05 between surfaces that touch, or overlap, or are far apart; the end is pushed by 0.08: 100 · 0.03.
#[test]
fn a19_clearance() {
    let pushed = format!("{STEP}*BOUNDARY\nHELD, 3, 3, -0.08\n*END STEP\n");
    for (overlap, card) in [
        (0.0, "VALUE=0.05\n"),
        (0.2, "VALUE=0.05\n"),
        (-0.3, "VALUE=0.05\n"),
        (0.1, "TABULAR\nBOTTOM, 0.05\n"),
        (0.1, "TABULAR\n1, 0.05\n2, 0.05\nBOTTOM, 0.05\n"),
    ] {
        let model = column(overlap) + "*NSET, NSET=BOTTOM\n1, 2, 3, 4\n" + HARD + PAIR;
        let clearance = format!("{model}*CLEARANCE, SLAVE=SEC, MASTER=FLOOR, {card}");
        let (forces, _) = run("clearance", &clearance, &pushed);
        close(card, &forces, &[0.0, 0.0, 1.0, 3.0]);
    }
    let model = column(0.0) + HARD + PAIR + "*CLEARANCE, SECONDARY=SEC, MAIN=FLOOR, VALUE=-0.1\n";
    let (forces, _) =
        run("clearance_overlap", &model, &format!("{STEP}*CONTACT INTERFERENCE, SHRINK\nSEC, FLOOR\n*END STEP\n"));
    close("an overlap by CLEARANCE, shrunk", &forces, &[2.5, 5.0, 7.5, 10.0]);
}
