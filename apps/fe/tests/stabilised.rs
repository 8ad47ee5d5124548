//! D03: a block that contact alone holds: free along the plane, where stabilisation resists, or friction holds it.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use fe_io::results::read::tables;

/// A unit cube, E = 1000, 1e-3 above a rigid plane, with its weight 2 and a side load.
fn block(side: f64, controls: &str) -> String {
    format!(
        "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
         7, 1., 1., 1.\n8, 0., 1., 1.\n*NODE, NSET=REF\n99, 0., 0., -5.\n*ELEMENT, TYPE=C3D8, ELSET=BLOCK\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*DENSITY\n1.\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n\
         *SURFACE, NAME=SEC\nBLOCK, S1\n*SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., -0.001, 1., 0., -0.001\n\
         0., 1., -0.001\nSTART, -1., 0.\nLINE, 2., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=99\n\
         *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, SMALL SLIDING\nSEC, FLOOR\n\
         *BOUNDARY\nREF, 1, 6\n*STEP\n*STATIC, DIRECT\n0.25, 1.\n*DLOAD\nBLOCK, GRAV, 2., 0., 0., -1.\n\
         *CLOAD\nALL, 1, {side}\n{controls}*NODE PRINT, NSET=REF, FREQUENCY=100\nRF\n*END STEP\n"
    )
}

/// The reaction is the weight, nothing drifts, and stabilisation takes next to nothing.
#[test]
fn d03_held_by_contact_and_stabilised() {
    for controls in
        ["*CONTACT CONTROLS, STABILIZE\n", "*CONTACT CONTROLS, STABILIZE, MASTER=FLOOR, SLAVE=SEC\n1., 0.1, 0.5\n"]
    {
        let scratch = Scratch::new("stabilised");
        scratch.write("block.inp", &block(0.0, controls));
        let run = scratch.fe(&["run", "block.inp"]);
        assert_eq!(run.status, 0, "{}", run.error);
        let text = tables(&scratch.read("block.dat")).unwrap();
        let reaction = &text.iter().rev().find(|b| b.title.starts_with("forces")).unwrap().rows[0].values;
        assert!((reaction[2] - 2.0).abs() < 1e-8 * 2.0, "{reaction:?}");
        let results = Results::open(&scratch.path("block.vtkhdf"));
        let u = results.point_field("U", 3, 4);
        // The mean over the eight nodes of the block, along the plane: the cube itself grows about its middle.
        let mean = |c: usize| (0..9).map(|n| u[3 * n + c]).sum::<f64>() / 8.0;
        assert!(mean(0).abs() < 1e-6 && mean(1).abs() < 1e-6, "drift {} {}", mean(0), mean(1));
        let line = run.output.lines().find(|l| l.contains("stabilisation  ")).expect("the energy is told");
        let taken: f64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
        let energy = run.output.lines().find(|l| l.starts_with("  energy")).unwrap();
        let solids: f64 = energy.split_whitespace().nth(2).unwrap().trim_end_matches(',').parse().unwrap();
        assert!(taken < 1e-4 * solids, "{line} {energy}");
    }
}

/// Without stabilisation, or with a side load, or where it acts across the surface alone, the block is refused.
#[test]
fn d03_what_nothing_holds_is_refused() {
    let across = "*CONTACT CONTROLS, STABILIZE, TANGENT FRACTION=0.\n";
    for (side, controls) in [(0.0, ""), (0.0, across), (0.01, "*CONTACT CONTROLS, STABILIZE\n")] {
        let scratch = Scratch::new("stabilised_not");
        scratch.write("block.inp", &block(side, controls));
        let run = scratch.fe(&["run", "block.inp", "--quiet"]);
        assert_eq!(run.status, 1, "{side} {controls}");
        assert!(run.error.contains("body BLOCK is free"), "{}", run.error);
    }
}

/// D03 (c): friction alone holds it along the plane, and about z: it sticks, and gives the plane its side load of 0.16, below
/// 0.3 times its weight at every corner. What is not held exactly gives way by no more than its elastic slip.
#[test]
fn d03_held_by_friction() {
    for (friction, slip) in
        [("*FRICTION, LAGRANGE\n0.3\n", 1e-12), ("*FRICTION\n0.3\n", 0.005), ("*FRICTION, ROUGH\n", 1e-12)]
    {
        let scratch = Scratch::new("held_by_friction");
        // Without Poisson's ratio: a foot that widens would slip.
        let deck = block(0.02, "").replace("1000., 0.3", "1000., 0.");
        let deck = deck.replace("*CONTACT PAIR", &format!("{friction}*CONTACT PAIR"));
        scratch.write("block.inp", &deck);
        let run = scratch.fe(&["run", "block.inp"]);
        assert_eq!(run.status, 0, "{friction}{}", run.error);
        let note = run.output.lines().find(|l| l.contains("held by contact alone")).expect("the body is told about");
        assert!(note.contains("body BLOCK") && note.contains("along z"), "{note}");
        let text = tables(&scratch.read("block.dat")).unwrap();
        let reaction = &text.iter().rev().find(|b| b.title.starts_with("forces")).unwrap().rows[0].values;
        assert!((reaction[2] - 2.0).abs() < 1e-8 * 2.0 && (reaction[0] + 0.16).abs() < 1e-8 * 0.16, "{reaction:?}");
        let results = Results::open(&scratch.path("block.vtkhdf"));
        for corner in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]] {
            let node = results.point_at(corner);
            let value = |name: &str| results.point_field(name, 1, 4)[node];
            assert_eq!(value("CSTATUS"), 1.0, "{friction}");
            assert!(value("CSLIP1").hypot(value("CSLIP2")) <= slip, "{friction} {}", value("CSLIP1"));
        }
    }
}
