//! D40: what is defined and not used, loads of zero, a single element, steps of no length.

use crate::hard::Scene;
use crate::hard::deck::Order;
use crate::hard::finding::Finding;
use crate::hard::patch::Patch;
use crate::hard::run::Run;

/// A cube with laws, interactions and a rigid surface that nothing uses.
const CUBE: &str = "\
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
9, 0., 0., -1.
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=LOW
1, 2, 3, 4
*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*MATERIAL, NAME=SPARE
*ELASTIC
70000., 0.33
*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL
*SURFACE, NAME=BOTTOM
CUBE, S1
*SURFACE INTERACTION, NAME=IDLE_HARD
*SURFACE BEHAVIOR, PENALTY
*SURFACE INTERACTION, NAME=IDLE_SOFT
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1000.
*SURFACE INTERACTION, NAME=IDLE_ROUGH
*FRICTION
0.3
*AMPLITUDE, NAME=IDLE_AMPLITUDE
0., 0., 1., 1.
*BOUNDARY
LOW, 1, 3
*STEP
*STATIC
1., 1.
*CLOAD
7, 3, 0.
*END STEP
";

/// Scenes of D40.
pub fn scenes() -> Vec<Scene> {
    let refused = |times: &'static str, words: &'static [&'static str]| {
        Scene::new(format!("*STATIC {times}: a step of no length"), move |place| {
            Finding::refused(&place.run("step", &CUBE.replace("1., 1.\n*CLOAD", &format!("{times}\n*CLOAD"))), words)
        })
    };
    vec![
        Scene::new("one element, unused laws and friction, zero load", |place| {
            let run = place.run("cube", CUBE);
            all_zero(Finding::converged(&run), &run).holds(!names(&run, "IDLE"), "the plan lists what is idle")
        }),
        Scene::new("one element, every freedom held, no load", |place| {
            let deck = CUBE.replace("LOW, 1, 3", "CUBE, 1, 3").replace("*NSET, NSET=LOW\n1, 2, 3, 4\n", ALL_NODES);
            let run = place.run("cube", &deck.replace("*CLOAD\n7, 3, 0.\n", ""));
            all_zero(Finding::converged(&run), &run)
        }),
        Scene::new("patch with a pair, pressure 0", |place| {
            let patch = Patch::plane(3, 4);
            let deck =
                patch.held(&patch.mesh(), Order::AsMade).replace("*END STEP", "*DSLOAD\nUP_YMAX, P, 0.\n*END STEP");
            let run = place.run("patch", &deck);
            all_zero(Finding::converged(&run), &run)
        }),
        Scene::new("patch held by contact alone, pressure 0", |place| {
            let patch = Patch::plane(3, 4);
            let deck = patch.pressed(&patch.mesh(), Order::AsMade).replace("UP_YMAX, P, 10", "UP_YMAX, P, 0.");
            let run = place.run("patch", &deck);
            all_zero(Finding::converged(&run), &run)
        }),
        Scene::new("a pair whose surfaces cannot meet", |place| {
            let patch = Patch::plane(3, 4);
            let deck = patch.held(&patch.mesh(), Order::AsMade).replace("UP_YMIN, LOW_YMAX", "UP_XMAX, LOW_XMIN");
            let run = place.run("patch", &deck);
            let needed = run.plans.iter().any(|plan| plan.lines().any(|line| line.trim().starts_with("contact pair")));
            all_zero(Finding::warned(&run, &["UP_XMAX", "no effect"]), &run)
                .holds(!needed, "the plan lists a pair that has no effect")
        }),
        refused("1., 0.", &["period `0.` is out of range"]),
        refused("0., 0.", &["`0.` is out of range"]),
        refused("0., 1.", &["`0.` is out of range"]),
    ]
}

const ALL_NODES: &str = "*NSET, NSET=CUBE\n1, 2, 3, 4, 5, 6, 7, 8\n";

fn names(run: &Run, word: &str) -> bool {
    run.plans.iter().any(|plan| plan.contains(word))
}

/// Displacements, forces and energies are 0, and every number of the certificate is one.
fn all_zero(found: Finding, run: &Run) -> Finding {
    let numbers = || run.certificates.iter().flat_map(|certificate| certificate.row());
    let largest =
        run.u().iter().copied().chain(numbers()).fold(0.0f64, |m, v| if v.is_nan() { v } else { m.max(v.abs()) });
    found.within(if numbers().any(f64::is_nan) { f64::NAN } else { largest }, 0.0)
}
