//! What steps say of contact, through the program: pairs removed and added, hard contact enforced otherwise. The slider
//! against a rigid stop: k x + N = F while it touches.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, PRINTED, close};
use common::slider::{Body, DISTANCE, K, pair, penalty};

/// The pair acts, is removed, and acts again. Its force ramps to zero over the step that removes it, N = 400 (1 − t), while
/// the column goes on to x = F/k; added again, it presses the column back.
#[test]
fn a_pair_is_removed_and_added() {
    let change = |what: &str| {
        format!("*STEP\n*STATIC, DIRECT\n0.25, 1.\n*MODEL CHANGE, TYPE=CONTACT PAIR, {what}\nSEC, FLOOR\n*END STEP\n")
    };
    for body in [Body::Brick, Body::Plane, Body::Ring] {
        let deck = format!(
            "{}{}*SURFACE INTERACTION, NAME=I\n{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n*DSLOAD\nSEC, P, -500.\n\
             *NODE PRINT, NSET=REF\nRF\n*NODE PRINT, NSET=NEAR\nU\n*END STEP\n{}{}*STEP\n*STATIC\n*END STEP\n",
            body.deck(),
            body.stop(false),
            pair("SURFACE TO SURFACE, SMALL SLIDING"),
            change("REMOVE"),
            change("ADD")
        );
        let job = Job::run("model_change", &deck);
        let held = 500.0 - K * DISTANCE;
        let mut forces = vec![held];
        forces.extend([0.75, 0.5, 0.25, 0.0].map(|t| t * held));
        forces.extend([held; 5]);
        let x: Vec<f64> = forces.iter().map(|n| -(500.0 - n) / K).collect();
        close("force on the stop", job.all("forces", "REF", body.axis()), &forces, PRINTED * held);
        close("displacement", job.all("displacements", "NEAR", body.axis()), &x, PRINTED);
    }
}

/// Steps with these cards, one each, of the slider pulled by 500.
fn forces(name: &str, behavior: &str, cards: &[&str]) -> Vec<f64> {
    let body = Body::Brick;
    let mut deck = format!(
        "{}{}{behavior}{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n",
        body.deck(),
        body.stop(false),
        pair("SURFACE TO SURFACE")
    );
    for card in cards {
        deck += &format!("*STEP\n*STATIC\n*DSLOAD\nSEC, P, -500.\n{card}*NODE PRINT, NSET=REF\nRF\n*END STEP\n");
    }
    Job::run(name, &deck).all("forces", "REF", body.axis())
}

/// A01 with the penalty f k: N = 400 f/(1 + f). A control of a pair counts more than one of all; both hold on until RESET.
#[test]
fn contact_controls_scale_the_penalty() {
    let own = "*CONTACT CONTROLS, SLAVE=SEC, MASTER=FLOOR, STIFFNESS SCALE FACTOR=9.\n";
    let cards = [
        "",
        "*CONTACT CONTROLS, STIFFNESS SCALE FACTOR=3.\n",
        "",
        own,
        "*CONTACT CONTROLS, STIFFNESS SCALE FACTOR=3.\n",
        "*CONTACT CONTROLS, SECONDARY=SEC, MAIN=FLOOR, RESET\n",
    ];
    let found = forces("controls_scale", &penalty(K), &cards);
    let expected = [1.0, 3.0, 3.0, 9.0, 9.0, 1.0].map(|f| 400.0 * f / (1.0 + f));
    close("scaled penalty", &found, expected, PRINTED * 400.0);
}

/// A card without names reaches contact elements, too; STABILIZE does not.
#[test]
fn contact_controls_reach_contact_elements() {
    let step = |cards: &str| format!("*STEP\n*STATIC\n{cards}*CLOAD\n2, 1, -500.\n*EL PRINT, ELSET=G\nS\n*END STEP\n");
    let slider = |behavior: &str| {
        format!(
            "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n*ELEMENT, TYPE=SPRING1, ELSET=S\n1, 2\n*SPRING, ELSET=S\n1\n{K}\n\
             *ELEMENT, TYPE=GAPUNI, ELSET=G\n2, 1, 2\n*GAP, ELSET=G\n{DISTANCE}, 1.\n{behavior}*BOUNDARY\n1, 1, 3\n2, 2, 3\n"
        )
    };
    let penalty = format!("*SURFACE BEHAVIOR, PENALTY\n{K}\n");
    let scaled = "*CONTACT CONTROLS, STIFFNESS SCALE FACTOR=3.\n";
    let job = Job::run(
        "controls_elements",
        &(slider(&penalty) + &[scaled, "*CONTACT CONTROLS, RESET, STABILIZE\n"].map(step).concat()),
    );
    close("scale", job.all("stresses", "G", 1), [300.0, 200.0], PRINTED * 400.0);
    assert!(job.told.contains("`STABILIZE` has no effect") && !job.plan().contains("stabilised"), "{}", job.told);
    let exact =
        step("*CONTACT CONTROLS, LAGRANGE MULTIPLIER=NO\n") + &step("*CONTACT CONTROLS, LAGRANGE MULTIPLIER=YES\n");
    let job = Job::run("controls_elements_exact", &(slider("") + &exact));
    // Without multipliers ten times the spring.
    close("multipliers", job.all("stresses", "G", 1), [400.0 * 10.0 / 11.0, 400.0], PRINTED * 400.0);
}

/// A01 with AUGMENTED LAGRANGE, β = 10: the overclosure is 0.4 · 11⁻ⁿ after n passes, 0.0364, 0.0033, 0.0003 …; the facets'
/// length is 1.
#[test]
fn contact_controls_set_the_tolerance_of_augmentation() {
    let behavior = format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, AUGMENTED LAGRANGE\n{}\n", 10.0 * K);
    let passes = |n: i32| 400.0 * (1.0 - 11f64.powi(-n));
    for (tolerance, n) in [
        // 5 % where surfaces may slide far.
        ("", 1),
        ("*CONTACT CONTROLS, ABSOLUTE PENETRATION TOLERANCE=0.04\n", 1),
        ("*CONTACT CONTROLS, ABSOLUTE PENETRATION TOLERANCE=0.01\n", 2),
        ("*CONTACT CONTROLS, RELATIVE PENETRATION TOLERANCE=0.001\n", 3),
        ("*CONTACT CONTROLS, ABSOLUTE PENETRATION TOLERANCE=3e-5\n", 4),
        ("*CONTACT CONTROLS, ABSOLUTE PENETRATION TOLERANCE=3e-6\n", 5),
        ("*CONTACT CONTROLS, ABSOLUTE PENETRATION TOLERANCE=3e-7\n", 6),
    ] {
        let found = forces("controls_tolerance", &behavior, &[tolerance]);
        close(tolerance, &found, [passes(n)], PRINTED * 400.0);
    }
}

/// LAGRANGE MULTIPLIER: hard contact for which nothing is asked is without overclosure, or a penalty of ten times the elements
/// beneath, K = 10 k: N = 400 · 10/11. Laws and penalties keep their answers, with multipliers and without.
#[test]
fn multipliers_by_controls() {
    let soft = (500.0 - K * DISTANCE) * 10.0 / 11.0;
    let hard = "*SURFACE INTERACTION, NAME=I\n".to_owned();
    let law = hard.clone() + "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n4000.\n";
    let steep = 400.0 * 1e4 / (1e4 + 1.0);
    for (contact, [without, yes, no], kind) in [
        (hard.clone(), [soft, 400.0, soft], "SURFACE TO SURFACE"),
        (hard.clone(), [400.0, 400.0, soft], "NODE TO SURFACE"),
        (hard + "*SURFACE BEHAVIOR, DIRECT\n", [400.0; 3], "NODE TO SURFACE"),
        (penalty(K), [200.0; 3], "SURFACE TO SURFACE"),
        (penalty(1e4 * K), [steep; 3], "SURFACE TO SURFACE"),
        (law, [320.0; 3], "SURFACE TO SURFACE"),
    ] {
        for body in [Body::Brick, Body::Ring] {
            let change = |what: &str| format!("*STEP\n*STATIC\n*CONTACT CONTROLS, {what}\n*END STEP\n");
            let deck = format!(
                "{}{}{contact}{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n*DSLOAD\nSEC, P, -500.\n\
                 *NODE PRINT, NSET=REF\nRF\n*END STEP\n{}{}{}",
                body.deck(),
                body.stop(false),
                pair(kind),
                change("LAGRANGE MULTIPLIER=YES"),
                change("LAGRANGE MULTIPLIER=NO"),
                change("RESET")
            );
            let job = Job::run("multipliers_by_controls", &deck);
            let what = format!("{body:?} {kind} {contact}");
            close(&what, job.all("forces", "REF", body.axis()), [without, yes, no, without], PRINTED * 400.0);
        }
    }
}
