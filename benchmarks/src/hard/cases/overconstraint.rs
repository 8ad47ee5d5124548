//! D04, D05, D06, D08: multipliers that say what supports or other multipliers say already.

use super::members;
use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, EXACT, PRESSURE, Patch, YOUNG};
use crate::hard::run::{Run, Solved};
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

const BOUND: f64 = 1e-10;

/// A block [0, 2] × [0, 1] of plane strain squares, 4 × 2, with rigid walls y = 0 and x = 0 and a pair for each of some
/// secondary surfaces on one of them.
fn cornered(pairs: &[(&str, &str)], extra: &str, rest: &str) -> String {
    let mesh = Block::quad4([4, 2]).size([2.0, 1.0, 0.0]).mesh();
    let mut text = deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade);
    text += &deck::elastic(&["BLOCK"], YOUNG, patch::POISSON);
    text += "*NODE\n998, 0., 0.\n999, 0., 0.\n\
             *SURFACE, NAME=FLOOR, TYPE=SEGMENTS\nSTART, -5., 0.\nLINE, 5., 0.\n\
             *SURFACE, NAME=WALL, TYPE=SEGMENTS\nSTART, 0., 5.\nLINE, 0., -5.\n\
             *RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=998\n*RIGID BODY, ANALYTICAL SURFACE=WALL, REF NODE=999\n\
             *SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, DIRECT\n";
    text += extra;
    for (secondary, main) in pairs {
        text += &format!("*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\n{secondary}, {main}\n");
    }
    text + "*BOUNDARY\n998, 1, 2\n998, 6\n999, 1, 2\n999, 6\n" + rest
}

/// D04: supports that say what contact says, and one that says otherwise.
pub fn supported() -> Vec<Scene> {
    let pressed = patch::step(EXACT, &format!("*DSLOAD\nYMAX, P, {PRESSURE}\n"));
    let held = move |depth: f64, step: String| {
        cornered(
            &[("YMIN", "FLOOR")],
            "",
            &format!("XMIN, 1\n{}*BOUNDARY\nYMIN, 2, 2, {:e}\n*END STEP\n", step.replace("*END STEP\n", ""), -depth),
        )
    };
    let deck = held(0.0, pressed.clone());
    let mut scenes = members::supported_ends();
    scenes.push(tied(TIED, (3, 4), 0));
    scenes.push(tied("NODE TO SURFACE, TIED, ADJUST=0.01", (4, 4), 1));
    scenes.push(tied_and_in_contact());
    scenes.extend([
        Scene::new("secondary nodes held on the rigid main", move |place| {
            let run = place.run("held", &deck);
            let told = run.plans.iter().any(|plan| plan.contains("over-constraint") && plan.contains("5 multipliers"));
            Finding::converged(&run).holds(told, format!("the plan does not count 5: {:?}", run.plans)).measured(
                &run,
                |solved| {
                    // Without the pair: a column under its load.
                    let top = -PRESSURE * (1.0 - patch::POISSON * patch::POISSON) / YOUNG;
                    vec![(from_value(top, &top_of(solved)), BOUND)]
                },
            )
        }),
        Scene::new("secondary nodes held 0.01 inside the rigid main", move |place| {
            let run = place.run("inside", &held(0.01, pressed.clone()));
            Finding::refused(&run, &["node", "1.000e-2"])
        }),
        Scene::new("a node in an equation", |_| Finding::waits("*EQUATION")),
    ]);
    scenes
}

/// D04: tied blocks under tension whose sides are held in the same direction, the nodes of the tied edges too: where nodes
/// meet, the tie says along the surface what the supports say.
fn tied(kind: &'static str, (lower, upper): (usize, usize), redundant: usize) -> Scene {
    let name =
        format!("patch {lower}/{upper} tied and pulled, {}", kind.split(',').next().unwrap_or_default().to_lowercase());
    Scene::new(name, move |place| {
        let patch = Patch { kind, ..Patch::plane(lower, upper) };
        let deck = patch.pressed(&patch.mesh(), Order::AsMade).replace("P, 10\n", "P, -10\n");
        let run = place.run("tied", &deck);
        counted(&run, redundant).measured(&run, |solved| {
            let top = 2.0 * PRESSURE / patch.modulus();
            vec![(from_value(-PRESSURE, &solved.pressures()), BOUND), (from_value(top, &patch.top(solved)), BOUND)]
        })
    })
}

/// Solved, with so many multipliers counted in the plan that say what is said already.
fn counted(run: &Run, redundant: usize) -> Finding {
    let words = format!("{redundant} multipliers say");
    let told = run.plans.iter().any(|plan| plan.contains(&words) || redundant == 0);
    Finding::converged(run).holds(told, format!("the plan does not say `{words}`: {:?}", run.plans))
}

const TIED: &str = "SURFACE TO SURFACE, TIED, ADJUST=0.01";

/// D04: nodes that are tied and in a contact pair with the same surface.
fn tied_and_in_contact() -> Scene {
    Scene::new("patch 4/4 tied and pressed, its nodes in contact, too", |place| {
        let patch = Patch { kind: TIED, behavior: "*SURFACE BEHAVIOR, DIRECT\n".into(), ..Patch::plane(4, 4) };
        let mesh = patch.mesh();
        let again = "*NSET, NSET=TIED_NODES, GENERATE\n16, 20\n*SURFACE, NAME=POINTS, TYPE=NODE\nTIED_NODES, 1.\n\
                     *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nPOINTS, LOW_YMAX\n*BOUNDARY\n";
        let run = place.run("both", &patch.pressed(&mesh, Order::AsMade).replacen("*BOUNDARY\n", again, 1));
        // The normals of five nodes; of the five slips symmetry has the say in that of the node that is held, and the four
        // others hold four nodes.
        counted(&run, 5).measured(&run, |solved| {
            let force: f64 = solved.pairs.iter().map(|pair| pair.secondary.force[1]).sum();
            let top = -2.0 * PRESSURE / patch.modulus();
            vec![(from_value(2.0 * PRESSURE, &[force]), BOUND), (from_value(top, &patch.top(solved)), BOUND)]
        })
    })
}

fn top_of(solved: &Solved) -> Vec<f64> {
    let nodes = &solved.terms.structure.mesh.node_sets["YMAX"];
    nodes.iter().filter_map(|&n| Some(solved.u[solved.terms.freedoms.index(n as usize, 1)?])).collect()
}

/// D05: nodes in two contacts.
pub fn shared() -> Vec<Scene> {
    let squeezed = patch::step(EXACT, &format!("*DSLOAD\nYMAX, P, {PRESSURE}\nXMAX, P, {PRESSURE}\n"));
    let pressed = patch::step(EXACT, &format!("*DSLOAD\nYMAX, P, {PRESSURE}\n"));
    let forces = |run: &Run, expected: &[f64]| {
        Finding::converged(run).measured(run, |solved| {
            let normal =
                solved.pairs.iter().map(|pair| pair.secondary.force.iter().map(|f| f.abs()).fold(0.0, f64::max));
            let errors = normal.zip(expected).map(|(force, expected)| (from_value(*expected, &[force]), BOUND));
            errors.chain([(from_value(PRESSURE, &solved.pressures()), BOUND)]).collect()
        })
    };
    let mut scenes = vec![
        Scene::new("block in the corner of two rigid walls", move |place| {
            let run = place.run("corner", &cornered(&[("YMIN", "FLOOR"), ("XMIN", "WALL")], "", &squeezed));
            forces(&run, &[2.0 * PRESSURE, PRESSURE])
        }),
        Scene::new("two secondary surfaces that share a node", move |place| {
            let halves = "*SURFACE, NAME=LEFT\n1, S1\n2, S1\n*SURFACE, NAME=RIGHT\n3, S1\n4, S1\n";
            let run = place.run(
                "halves",
                &cornered(&[("LEFT", "FLOOR"), ("RIGHT", "FLOOR")], halves, &format!("XMIN, 1\n{pressed}")),
            );
            let total = |solved: &Solved| solved.pairs.iter().map(|pair| pair.secondary.force[1]).sum::<f64>();
            Finding::converged(&run)
                .measured(&run, |solved| vec![(from_value(2.0 * PRESSURE, &[total(solved)]), BOUND)])
        }),
    ];
    scenes.extend(in_gap_and_pair());
    scenes
}

/// D05: gap elements along x, of the law's default, from held nodes 901, 902, … to nodes of the block at x = 0, with their
/// cards of supports; or along y, to one at the bottom that the pair has, too.
fn with_gaps(labels: &[u64], direction: &str) -> (String, String) {
    let nodes: String = (901..).zip(labels).map(|(held, _)| format!("{held}, -1., -1.\n")).collect();
    let elements: String = (901..).zip(labels).map(|(held, label)| format!("{held}, {held}, {label}\n")).collect();
    let held: String = (901..).zip(labels).map(|(held, _)| format!("{held}, 1, 2\n")).collect();
    let model =
        format!("*NODE\n{nodes}*ELEMENT, TYPE=GAPUNI, ELSET=STOPS\n{elements}*GAP, ELSET=STOPS\n0., {direction}\n");
    (model, held)
}

/// D05: nodes in a pair and in gap elements.
fn in_gap_and_pair() -> [Scene; 2] {
    let mesh = Block::quad4([4, 2]).size([2.0, 1.0, 0.0]).mesh();
    let labels = move |set: &str| -> Vec<u64> {
        let nodes = mesh.node_sets.get(set).map_or(&[][..], Vec::as_slice);
        nodes.iter().map(|&n| mesh.point_labels[n as usize]).collect()
    };
    let (left, bottom) = (labels("XMIN"), labels("YMIN"));
    let total = |solved: &Solved, c: usize| solved.pairs.iter().map(|pair| pair.secondary.force[c]).sum::<f64>();
    [
        Scene::new("corner node in a pair along y and a gap along x", move |place| {
            let (model, held) = with_gaps(&left, "1.");
            let loads = format!("*DSLOAD\nYMAX, P, {PRESSURE}\nXMAX, P, {PRESSURE}\n");
            let deck = cornered(&[("YMIN", "FLOOR")], &model, &format!("{held}{}", patch::step(EXACT, &loads)));
            let run = place.run("gaps", &deck);
            Finding::converged(&run).measured(&run, |solved| {
                let column = -PRESSURE * (1.0 - 2.0 * patch::POISSON) * (1.0 + patch::POISSON) / YOUNG;
                vec![
                    (from_value(PRESSURE, &[total(solved, 0)]), BOUND),
                    (from_value(2.0 * PRESSURE, &[total(solved, 1)]), BOUND),
                    (from_value(column, &top_of(solved)), BOUND),
                ]
            })
        }),
        Scene::new("a node in a pair and in a gap along the same y", move |place| {
            let (model, held) = with_gaps(&bottom[2..3], "0., 1.");
            let loads = format!("*DSLOAD\nYMAX, P, {PRESSURE}\n");
            let rest = format!("XMIN, 1\n{held}{}", patch::step(EXACT, &loads));
            let run = place.run("parallel", &cornered(&[("YMIN", "FLOOR")], &model, &rest));
            counted(&run, 1).measured(&run, |solved| {
                let column = -PRESSURE * (1.0 - patch::POISSON * patch::POISSON) / YOUNG;
                vec![
                    (from_value(2.0 * PRESSURE, &[total(solved, 1)]), BOUND),
                    (from_value(column, &top_of(solved)), BOUND),
                ]
            })
        }),
    ]
}

/// D06: both sides are secondary at once.
pub fn two_pass() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (lower, upper) in [(4, 4), (3, 4), (5, 4)] {
        for (behavior, name) in [("DIRECT", "multipliers"), ("PENALTY", "penalty")] {
            scenes.push(Scene::new(format!("patch {lower}/{upper} both ways, {name}"), move |place| {
                let behavior = format!("*SURFACE BEHAVIOR, {behavior}\n");
                let patch = Patch { behavior, both_ways: true, ..Patch::plane(lower, upper) };
                let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
                Finding::converged(&run).measured(&run, |solved| {
                    // What acts on the upper block, as secondary and as main side.
                    let force = solved.pairs[0].secondary.force[1] + solved.pairs[1].main.force[1];
                    let column = -2.0 * PRESSURE / patch.modulus();
                    // Two penalties side by side give way half as much, by p/2k.
                    let given = if name == "penalty" { PRESSURE / (2.0 * solved.stiffness(0)) } else { 0.0 };
                    let top = from_value(column - given, &patch.top(solved));
                    vec![(from_value(2.0 * PRESSURE, &[force]), BOUND), (top, BOUND)]
                })
            }));
        }
    }
    scenes
}

/// D08: how many of the constraints of both ways on a straight interface repeat others.
pub fn count() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (lower, upper, expected) in [(3, 3, 4), (4, 4, 5), (4, 3, 2), (5, 4, 2), (8, 4, 5)] {
        scenes.push(Scene::new(format!("{} and {} nodes, both ways", lower + 1, upper + 1), move |place| {
            let behavior = "*SURFACE BEHAVIOR, DIRECT\n".into();
            let patch = Patch { behavior, both_ways: true, kind: "NODE TO SURFACE", ..Patch::plane(lower, upper) };
            let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
            counted(&run, expected)
        }));
    }
    scenes.push(Scene::new("no checkerboard between matching meshes, sides held", |place| {
        let patch = Patch { behavior: "*SURFACE BEHAVIOR, DIRECT\n".into(), ..Patch::plane(8, 8) };
        let run = place.run("patch", &patch.pressed(&patch.mesh(), Order::AsMade));
        Finding::converged(&run).measured(&run, |solved| vec![(from_value(PRESSURE, &solved.pressures()), BOUND)])
    }));
    scenes
}
