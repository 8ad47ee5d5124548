//! General contact by decks: what it leaves to pairs, what is excluded, which assignment holds, and the law by scale factors.

#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// Two cubes of one element above each other; the upper one flies down. `cards` stand in the step.
fn deck(interactions: &str, cards: &str) -> String {
    format!(
        "*NODE, NSET=LOWER\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
         7, 1., 1., 1.\n8, 0., 1., 1.\n*NODE, NSET=UPPER\n11, 0., 0., 1.002\n12, 1., 0., 1.002\n13, 1., 1., 1.002\n\
         14, 0., 1., 1.002\n15, 0., 0., 2.002\n16, 1., 0., 2.002\n17, 1., 1., 2.002\n18, 0., 1., 2.002\n\
         *ELEMENT, TYPE=C3D8R, ELSET=CUBES\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 11, 12, 13, 14, 15, 16, 17, 18\n\
         *SURFACE, NAME=TOP\n1, S2\n*SURFACE, NAME=FOOT\n2, S1\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.\n*DENSITY\n1.\n\
         *SOLID SECTION, ELSET=CUBES, MATERIAL=M\n{interactions}\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nUPPER, 3, -0.1\n*BOUNDARY\nLOWER, 1, 3\n\
         *STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.002, 0.2\n{cards}\
         *NODE PRINT, NSET=UPPER, FREQUENCY=10\nU, V\n*END STEP\n"
    )
}

const ALL: &str = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n";

fn speeds(name: &str, interactions: &str, cards: &str) -> Vec<f64> {
    Job::run(name, &deck(interactions, cards)).all("velocities", "UPPER", 3)
}

#[test]
fn pairs_are_left_to_themselves() {
    let pair = "*CONTACT PAIR, MECHANICAL CONSTRAINT=PENALTY\nFOOT, TOP\n";
    let alone = speeds("general_pair_alone", "", pair);
    let beside = speeds("general_pair_beside", "", &format!("{pair}{ALL}"));
    assert_eq!(alone, beside);
    let general = speeds("general_instead", "", ALL);
    // The same faces meet: what holds the lower cube is rigid, and both halves act.
    assert!(general.iter().any(|v| *v > 0.05), "{general:?}");
}

#[test]
fn exclusions_and_inclusions() {
    let free = speeds("general_free", "", "");
    let excluded = speeds("general_excluded", "", &format!("{ALL}*CONTACT EXCLUSIONS\nTOP, FOOT\n"));
    let none = speeds("general_none", "", "*CONTACT\n");
    assert!(excluded == free && none == free);
    let named = |name: &str, line: &str| speeds(name, "", &format!("*CONTACT\n*CONTACT INCLUSIONS\n{line}\n"));
    let [one, other] = [named("general_top_foot", "TOP, FOOT"), named("general_foot_top", "FOOT, TOP")];
    assert!(one == other && one != free);
}

/// The last line that names two faces holds; blanks name all.
#[test]
fn the_last_assignment_holds() {
    let law = |name: &str, slope: f64| {
        format!("*SURFACE INTERACTION, NAME={name}\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{slope}\n")
    };
    let both = law("SOFT", 50.0) + &law("STIFF", 500.0);
    let with = |name: &str, lines: &str| speeds(name, &both, &format!("{ALL}*CONTACT PROPERTY ASSIGNMENT\n{lines}\n"));
    let (soft, stiff) = (with("general_soft", ", , SOFT"), with("general_stiff", ", , STIFF"));
    assert!(soft != stiff);
    assert_eq!(with("general_last", ", , STIFF\n, , SOFT"), soft);
    assert_eq!(with("general_named", ", , SOFT\nTOP, FOOT, STIFF"), stiff);
    assert_eq!(with("general_over", "TOP, FOOT, STIFF\n, , SOFT"), soft);
}

/// s₀ = ½ halves the penalty below the first piece: the same as SCALE PENALTY of ½.
#[test]
fn a04_scale_factor_law() {
    let usual = "*CONTACT DAMPING, DEFINITION=CRITICAL DAMPING FRACTION\n0.,\n";
    let law = format!(
        "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=SCALE FACTOR\n0.3, , 2., 0.5\n{usual}"
    );
    let hard = format!("*SURFACE INTERACTION, NAME=I\n{usual}");
    let assigned = format!("{ALL}*CONTACT PROPERTY ASSIGNMENT\n, , I\n");
    let scaled = format!("{assigned}*CONTACT CONTROLS ASSIGNMENT, TYPE=SCALE PENALTY\n, , 0.5\n");
    let [one, other] =
        [speeds("general_scale_factor", &law, &assigned), speeds("general_scale_penalty", &hard, &scaled)];
    assert!(one.iter().any(|v| *v > 0.05), "it bounces: {one:?}");
    for (a, b) in one.iter().zip(&other) {
        // Rounding: the slope is found through the area here.
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
}
