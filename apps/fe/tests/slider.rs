//! The slider against a rigid stop, through the program: hard contact by a penalty and a linear law, on all rigid
//! surfaces; the reference node held, moved and loaded. Closed forms: k x + A p(x − g₀) = F.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::job::{Job, PRINTED, relative};
use common::slider::{Body, DISTANCE, K, pair, penalty};

/// Load towards the stop [F].
const LOAD: f64 = 500.0;

const SURFACE: &str = "SURFACE TO SURFACE";
const NODE: &str = "NODE TO SURFACE";

/// A pressure load on the near face, pulling towards the stop.
fn pulled(body: Body, stop: &str, contact: &str) -> String {
    let axis = body.axis();
    format!(
        "{}{stop}{contact}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n*DSLOAD\nSEC, P, -{LOAD}\n\
         *NODE PRINT, NSET=REF\nRF\n*NODE PRINT, NSET=NEAR\nU\n*CONTACT PRINT\nCF\n*END STEP\n** axis {axis}\n",
        body.deck()
    )
}

const BODIES: [(Body, bool); 4] =
    [(Body::Brick, false), (Body::Brick, true), (Body::Plane, false), (Body::Ring, false)];

/// A01: N = 400 β/(1+β) for the penalty βk, over twelve orders of magnitude, from one increment. A condition number
/// of 1 + β adds β ε to the digits that are printed.
#[test]
fn a01_hard_slider_by_penalty() {
    for (body, revolved) in BODIES {
        for (kind, betas) in [(SURFACE, &[1e-6, 1e-3, 1.0, 1e3, 1e6][..]), (NODE, &[1.0, 1e6])] {
            for &beta in betas {
                let contact = penalty(beta * K) + &pair(kind);
                let job = Job::run("slider_penalty", &pulled(body, &body.stop(revolved), &contact));
                let what = format!("{body:?} {revolved} {kind} {beta}");
                let force = (LOAD - K * DISTANCE) * beta / (1.0 + beta);
                let tolerance = PRINTED + 16.0 * beta * f64::EPSILON;
                relative(&what, [job.last("forces", "REF", body.axis())], [force], tolerance);
                let x = -job.last("displacements", "NEAR", body.axis());
                relative(&what, [x], [DISTANCE + force / (beta * K)], tolerance);
            }
        }
    }
}

/// A02: LINEAR K = 4000: x = 0.18, p = 320.
#[test]
fn a02_linear_slider() {
    let law = "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n4000.\n";
    for (body, revolved) in BODIES {
        for kind in [SURFACE, NODE] {
            let job = Job::run("slider_linear", &pulled(body, &body.stop(revolved), &(law.to_owned() + &pair(kind))));
            let what = format!("{body:?} {revolved} {kind}");
            relative(&what, [job.last("displacements", "NEAR", body.axis())], [-0.18], PRINTED);
            relative(&what, [job.last("forces", "REF", body.axis())], [320.0], PRINTED);
        }
    }
}

/// A01 by multipliers, as decks have it by default from node to surface: N = 400 and x = 0.1.
#[test]
fn a01_hard_slider_direct() {
    for (body, revolved) in BODIES {
        for (kind, card) in [(SURFACE, ", DIRECT"), (NODE, ", DIRECT"), (NODE, "")] {
            let behavior = format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR{card}\n");
            let job = Job::run("slider_direct", &pulled(body, &body.stop(revolved), &(behavior + &pair(kind))));
            let what = format!("{body:?} {revolved} {kind}{card}");
            relative(&what, [job.last("forces", "REF", body.axis())], [LOAD - K * DISTANCE], PRINTED);
            relative(&what, [job.last("displacements", "NEAR", body.axis())], [-DISTANCE], PRINTED);
        }
    }
}

/// A01 by augmented Lagrange, β = 10: after pass n the force is 400 (1 − 11⁻ⁿ) and the overclosure 400 · 11⁻ⁿ / k: 0.036,
/// 0.0033, 0.0003. With small sliding it ends with the first one below a thousandth of the facet's length (1, the ring's
/// 0.56), divided by the scale factor where that is below 1.
#[test]
fn a01_hard_slider_augmented_lagrange() {
    for (body, revolved) in BODIES {
        for (line, passes) in [("10000.", 3), ("100000., 0., 0.1", 2), ("2000000., 0., 0.005", 1)] {
            let behavior = format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, AUGMENTED LAGRANGE\n{line}\n");
            let small = pair(SURFACE).replace(SURFACE, &format!("{SURFACE}, SMALL SLIDING"));
            let job = Job::run("slider_augmented", &pulled(body, &body.stop(revolved), &(behavior + &small)));
            let what = format!("{body:?} {revolved} {line}");
            let left = 11f64.powi(-passes);
            let force = (LOAD - K * DISTANCE) * (1.0 - left);
            relative(&what, [job.last("forces", "REF", body.axis())], [force], PRINTED);
            let overlap = (LOAD - K * DISTANCE) * left / K;
            relative(&what, [-job.last("displacements", "NEAR", body.axis())], [DISTANCE + overlap], PRINTED);
        }
    }
}

/// A06: under NO SEPARATION a stop that closed pulls: the force goes from 400 to −400 while the load goes from 500 to
/// −300. One that never closed does not.
#[test]
fn a06_no_separation() {
    for (ways, force) in [(", NO SEPARATION", -400.0), (", NO SEPARATION, DIRECT", -400.0), (", DIRECT", 0.0)] {
        for (body, revolved) in BODIES {
            let behavior = format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR{ways}\n");
            let pulled = pulled(body, &body.stop(revolved), &(behavior + &pair(NODE)));
            let back = format!("{pulled}*STEP\n*STATIC\n*DSLOAD\nSEC, P, 300.\n*END STEP\n");
            let job = Job::run("slider_held", &back);
            let what = format!("{body:?} {revolved}{ways}");
            let found = job.last("forces", "REF", body.axis());
            assert!((found - force).abs() <= PRINTED * 400.0, "{what}: {found}");
            let x = if force < 0.0 { DISTANCE } else { -300.0 / K };
            relative(&what, [-job.last("displacements", "NEAR", body.axis())], [x], PRINTED);
        }
    }
    let behavior = "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, NO SEPARATION\n".to_owned() + &pair(NODE);
    let away = pulled(Body::Brick, &Body::Brick.stop(false), &behavior).replace("P, -500", "P, 300");
    let job = Job::run("slider_never_closed", &away);
    assert_eq!(job.last("forces", "REF", 3), 0.0);
    relative("away", [job.last("displacements", "NEAR", 3)], [0.3], PRINTED);
}

/// The clearance and the scale factor of the penalty's data line: g₀ becomes g₀ − c, β becomes f β (A01: β = 1,
/// c = 0.05: N = 225).
#[test]
fn a01_clearance_and_scale() {
    for (line, force) in [("1000., 0.05", 225.0), ("500., 0., 2.", 200.0), ("250., 0.05, 4.", 225.0)] {
        let contact = format!("*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PENALTY\n{line}\n{}", pair(SURFACE));
        let job = Job::run("slider_clearance", &pulled(Body::Brick, &Body::Brick.stop(false), &contact));
        relative(line, [job.last("forces", "REF", 3)], [force], PRINTED);
    }
}

/// A surface of nodes, with areas that add up to 1 and without: the law's number is a pressure, or a force.
#[test]
fn a01_node_based() {
    for (area, beta, force) in [(", 0.25", 1.0, 200.0), ("", 0.25, 200.0), ("", 1.0, 400.0 * 4.0 / 5.0)] {
        let nodes = format!("*SURFACE, NAME=POINTS, TYPE=NODE\nNEAR{area}\n");
        let contact = nodes + &penalty(beta * K) + &pair(NODE).replace("SEC,", "POINTS,");
        let job = Job::run("slider_nodes", &pulled(Body::Brick, &Body::Brick.stop(true), &contact));
        relative(area, [job.last("forces", "REF", 3)], [force], PRINTED);
    }
}

/// The stop is moved by its reference node, over the free distance and into the column: N = k β/(1+β) (u − g₀).
#[test]
fn the_reference_node_moves_the_stop() {
    for (body, revolved) in BODIES {
        let axis = body.axis();
        let deck = format!(
            "{}{}{}{}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n*STATIC\n0.25, 1.\n*BOUNDARY\nREF, {axis}, {axis}, 0.3\n\
             *NODE PRINT, NSET=REF\nRF, U\n*NODE PRINT, NSET=HELD, TOTALS=ONLY\nRF\n*END STEP\n",
            body.deck(),
            body.stop(revolved),
            penalty(K),
            pair(SURFACE)
        );
        let job = Job::run("slider_moved", &deck);
        let force = 0.5 * K * (0.3 - DISTANCE);
        relative("reference", [job.last("forces", "REF", axis)], [force], PRINTED);
        relative("reference", [job.last("displacements", "REF", axis)], [0.3], PRINTED);
        relative("held", [job.last("total force", "HELD", axis)], [-force], PRINTED);
        // At a quarter of the way nothing touches.
        assert_eq!(job.all("forces", "REF", axis)[0], 0.0);
    }
}

/// The stop is free along its normal and pushed by a force on its reference node: contact alone holds it, N = F, and
/// it goes g₀ + F/k + F/βk.
#[test]
fn contact_holds_a_loaded_reference_node() {
    for (body, revolved) in BODIES {
        let axis = body.axis();
        let others = if axis == 3 { "REF, 1, 2\nREF, 4, 6" } else { "REF, 1\nREF, 6" };
        let deck = format!(
            "{}{}{}{}*BOUNDARY\nHELD, 1, 3\n{others}\n*STEP\n*STATIC\n0.5, 1.\n*CLOAD\nREF, {axis}, 40.\n\
             *NODE PRINT, NSET=REF\nRF, U\n*NODE PRINT, NSET=HELD, TOTALS=ONLY\nRF\n*END STEP\n",
            body.deck(),
            body.stop(revolved),
            penalty(2.0 * K),
            pair(SURFACE)
        );
        let job = Job::run("slider_loaded", &deck);
        relative("held", [job.last("total force", "HELD", axis)], [-40.0], PRINTED);
        relative("way", [job.last("displacements", "REF", axis)], [DISTANCE + 40.0 / K + 40.0 / (2.0 * K)], PRINTED);
    }
}

/// Names that the results file cannot hold as they are do not stop a run.
#[test]
fn surfaces_with_dots_and_slashes() {
    let body = Body::Brick;
    let contact = (penalty(K) + &pair(SURFACE)).replace("SEC,", "\"PART-1.S/EC\",");
    let deck = pulled(body, &body.stop(false), &contact).replace("NAME=SEC", "NAME=\"PART-1.S/EC\"");
    let job = Job::run("slider_names", &deck.replace("\nSEC, P", "\n\"PART-1.S/EC\", P"));
    relative("force", [job.last("forces", "REF", 3)], [200.0], PRINTED);
}

/// Messages about a run name nodes by the labels of the deck.
#[test]
fn a_free_node_is_named_by_its_label() {
    let scratch = Scratch::new("slider_free");
    let body = Body::Brick;
    // The reference node turns freely: nothing holds its rotations but contact in one plane.
    let deck = pulled(body, &body.stop(false), &(penalty(K) + &pair(SURFACE))).replace("REF, 1, 6", "REF, 1, 3");
    scratch.write("slider.inp", &deck);
    let run = scratch.fe(&["run", "slider.inp"]);
    assert_eq!(run.status, 1);
    let said = run.output + &run.error;
    assert!(said.contains("node 99") && !said.contains("node 8"), "{said}");
}
