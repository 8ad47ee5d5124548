//! `*CHANGE FRICTION` through the program: a point pressed with N = 200 on which a spring of 1000 and a load act along the
//! surface, F = 1000 x + T.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, close};

/// T and x at the end of every increment of all steps: of gap elements under `cards`, with the given steps.
fn solve(name: &str, cards: &str, steps: &[String]) -> Vec<[f64; 2]> {
    let deck = format!(
        "*NODE, NSET=N\n1, 0., 0., 0.\n2, 0., 0., 0.\n*ELEMENT, TYPE=SPRING1, ELSET=S\n7, 1\n*SPRING, ELSET=S\n1\n1000.\n\
         *ELEMENT, TYPE=GAPUNI, ELSET=G\n9, 2, 1\n*GAP, ELSET=G\n0., 0., 1., 0.\n{cards}*NSET, NSET=P\n1\n\
         *BOUNDARY\n2, 1, 3\n1, 3\n{}",
        steps.concat()
    );
    let job = Job::run(name, &deck);
    job.all("stresses", "G", 4).into_iter().zip(job.all("displacements", "P", 1)).map(|(t, x)| [t, x]).collect()
}

/// A step of so many equal increments that ends with this load along the surface.
fn step(increments: usize, load: f64, cards: &str) -> String {
    let size = 1.0 / increments as f64;
    format!(
        "*STEP\n*STATIC, DIRECT\n{size:?}, 1.\n*CONTROLS, PARAMETERS=FIELD\n1e-12\n{cards}*CLOAD\n1, 2, -200.\n1, 1, {load:?}\n\
         *EL PRINT, ELSET=G\nS\n*NODE PRINT, NSET=P\nU\n*END STEP\n"
    )
}

fn change(friction: &str) -> String {
    format!("*CHANGE FRICTION, ELSET=G\n*FRICTION{friction}\n")
}

/// Ten digits of a force up to 80 are printed.
fn assert_near(found: &[[f64; 2]], expected: &[[f64; 2]]) {
    close("T and x", found.as_flattened(), expected.as_flattened(), 1e-8);
}

/// T and x of a point that slips under a load of 100.
fn slips(mu: f64) -> [f64; 2] {
    [200.0 * mu, (100.0 - 200.0 * mu) / 1000.0]
}

/// μ falls from 0.3 to 0.1 while the point slips on, T = 200 μ(t); it stays there in a step that says nothing, and rises to
/// 0.4 under a point that now sticks.
#[test]
fn the_force_of_a_sliding_point_follows_the_coefficient() {
    let steps = [
        step(1, 100.0, ""),
        step(4, 100.0, &change(", LAGRANGE\n0.1")),
        step(1, 100.0, ""),
        step(2, 100.0, &change(", LAGRANGE\n0.4")),
        // T turns from 20 to −80 before it slips back.
        step(1, -100.0, ""),
    ];
    let found = solve("change_sliding", "*FRICTION, LAGRANGE\n0.3\n", &steps);
    let mut expected = vec![slips(0.3)];
    expected.extend([0.25, 0.2, 0.15, 0.1, 0.1, 0.1, 0.1].map(slips));
    expected.push([-80.0, -0.02]);
    assert_near(&found, &expected);
}

/// A load of 50 sticks under μ = 0.3, until μ = 0.3 − 0.2 t is less than 0.25.
#[test]
fn a_sticking_point_slips_when_friction_falls() {
    let amplitude = "*AMPLITUDE, NAME=LATE\n0., 0., 0.5, 0., 1., 1.\n";
    for (when, name) in [("", ""), (amplitude, ", AMPLITUDE=LATE")] {
        let card = change(", LAGRANGE\n0.1").replace("ELSET=G", &format!("ELSET=G{name}"));
        let steps = [step(1, 50.0, ""), step(8, 50.0, &card)];
        let found = solve("change_sticking", &format!("*FRICTION, LAGRANGE\n0.3\n{when}"), &steps);
        let part = |t: f64| if name.is_empty() { t } else { (2.0 * t - 1.0).max(0.0) };
        let at = |i: usize| {
            let shear = f64::min(50.0, 200.0 * (0.3 - 0.2 * part(i as f64 / 8.0)));
            [shear, (50.0 - shear) / 1000.0]
        };
        assert_near(&found, &std::iter::once([50.0, 0.0]).chain((1..=8).map(at)).collect::<Vec<_>>());
    }
}

/// Without friction at first, the load is all the spring's; friction that comes then holds the point where it stands, without
/// a force until it moves. RESET takes it away again.
#[test]
fn friction_comes_and_goes() {
    for stick in ["LAGRANGE", "ELASTIC SLIP=1e-9"] {
        let steps = [
            step(1, 100.0, ""),
            step(2, 100.0, &change(&format!(", {stick}\n0.3"))),
            step(1, -100.0, ""),
            step(4, -100.0, "*CHANGE FRICTION, ELSET=G, RESET\n"),
            step(1, 100.0, ""),
        ];
        let found = solve("change_from_nothing", "", &steps);
        let mut expected = vec![[0.0, 0.1]; 3];
        expected.push([-60.0, -0.04]);
        expected.extend([0.75, 0.5, 0.25, 0.0].map(|part| [-60.0 * part, -0.1 + 0.06 * part]));
        expected.push([0.0, 0.1]);
        assert_near(&found, &expected);
    }
}

/// In the first step friction begins at 0 whatever the model data say: under a load of 100 t, T = 200 t · 0.3 t while the point
/// slips, and what the load adds when that becomes more.
#[test]
fn in_the_first_step_friction_begins_at_zero() {
    let steps = [step(4, 100.0, &change(", LAGRANGE\n0.3"))];
    let slips = |t: f64| [60.0 * t * t, (100.0 * t - 60.0 * t * t) / 1000.0];
    let [first, second, third] = [0.25, 0.5, 0.75].map(slips);
    for cards in ["", "*FRICTION, LAGRANGE\n0.5\n"] {
        assert_near(&solve("change_first", cards, &steps), &[first, second, third, [third[0] + 25.0, third[1]]]);
    }
}

/// The elastic slip goes along with the coefficient: a point that never slips has T = 200 μ x/γ, so that x = F/(1000 + 200 μ/γ).
#[test]
fn elastic_slip_ramps_with_the_coefficient() {
    let sticks = |mu: f64, slip: f64| {
        let stiffness = 200.0 * mu / slip;
        [50.0 * stiffness / (1000.0 + stiffness), 50.0 / (1000.0 + stiffness)]
    };
    let steps = [step(1, 50.0, ""), step(2, 50.0, &change(", ELASTIC SLIP=0.03\n0.5")), step(1, 50.0, "")];
    let found = solve("change_elastic", "*FRICTION, ELASTIC SLIP=0.01\n0.4\n", &steps);
    let last = sticks(0.5, 0.03);
    assert_near(&found, &[sticks(0.4, 0.01), sticks(0.45, 0.02), last, last]);
}

/// Other ways to stick, and rough points, take the shear over as it is; what the new law does not hold slips at once.
#[test]
fn other_ways_to_stick_keep_the_shear() {
    let ways = [", LAGRANGE\n0.3", ", ELASTIC SLIP=0.01\n0.3", ", ROUGH"];
    for from in ways {
        for to in ways {
            let steps = [step(1, 50.0, ""), step(2, 50.0, &change(to)), step(1, 50.0, &change(", LAGRANGE\n0.1"))];
            let found = solve("change_ways", &format!("*FRICTION{from}\n"), &steps);
            // The spring of 200 · 0.3/0.01 = 6000 gives way at first, and keeps what it has.
            let first = if from.contains("ELASTIC") { [50.0 * 6.0 / 7.0, 50.0 / 7000.0] } else { [50.0, 0.0] };
            assert_near(&found, &[first, first, first, [20.0, 0.03]]);
        }
    }
}

/// A pad that presses with 240 slides on while the coefficient of its interaction falls from 0.3 to 0.15; the plan of each step
/// says what holds.
#[test]
fn a_pair_changes_with_its_interaction() {
    let deck = include_str!("decks/friction_cycle.inp");
    let model = deck.split("*STEP").next().unwrap();
    let step = |cards: &str| {
        format!("*STEP\n*STATIC, DIRECT\n0.25, 1.\n{cards}*NODE PRINT, NSET=NBASE, TOTALS=ONLY\nRF\n*END STEP\n")
    };
    let change = "*CHANGE FRICTION, INTERACTION=I\n*FRICTION, ELASTIC SLIP=0.02\n";
    let steps = [
        step("*BOUNDARY\nNPAD, 3, 3, -0.01\n"),
        step("*BOUNDARY\nNPAD, 1, 1, 0.4\n"),
        step(&format!("*BOUNDARY\nNPAD, 1, 1, 0.8\n{change}0.15\n")),
        step(&format!("{change}0.\n")),
        step("*CHANGE FRICTION, INTERACTION=I, RESET\n"),
    ];
    let job = Job::run("change_pair", &format!("{model}{}", steps.concat()));
    let shears = job.all("total force", "NBASE", 1);
    let mut expected = vec![0.0; 4];
    expected.extend([0.3; 4]);
    expected.extend([0.2625, 0.225, 0.1875, 0.15, 0.1125, 0.075, 0.0375, 0.0]);
    // What had no friction holds no shear until it slips again.
    expected.extend([0.0; 4]);
    close("shear", shears, expected.iter().map(|mu| -240.0 * mu).collect::<Vec<_>>(), 1e-8 * 240.0);
    let plan = job.plan();
    for words in [
        "friction, μ = 0.3, sticking",
        "friction, μ = 0.15 at the end of the step, at its start μ = 0.3, sticking",
        "friction, μ = 0 at the end of the step, at its start μ = 0.15, sticking",
        "friction, μ = 0.3 at the end of the step, at its start μ = 0, sticking",
    ] {
        assert!(plan.contains(words), "{words}: {plan}");
    }
}
