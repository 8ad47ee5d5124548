//! `fe check`: every kind of scene has a plan of its own, and what a plan leaves out does not exist.
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use common::results::Results;
use fe::approach::free_bodies;
use fe::course::Course;
use fe::job::{enter, scene, static_procedure};
use fe::terms::Terms;
use fe_core::linear::multifrontal::Multifrontal;
use fe_core::procedure::static_general::StaticGeneral;
use fe_io::{Deck, Model, resolve};
use std::path::{Path, PathBuf};

const SCENES: [&str; 8] = [
    "all_prescribed",
    "deformable_pair",
    "held_by_contact",
    "multipliers",
    "node_based",
    "rigid_main",
    "rigid_ring",
    "solids_alone",
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/plans")
}

/// Sizes of matrix and factor follow from the ordering, which is no part of what a plan promises.
fn without_sizes(text: &str) -> String {
    let sized = |word: &str| word.contains('.') && word.parse::<f64>().is_ok();
    let masked = |line: &str| {
        let words = line.split(' ').map(|word| if sized(word) { "#" } else { word });
        words.collect::<Vec<_>>().join(" ")
    };
    let plain = |line: &str| match line.split_whitespace().next() {
        Some("matrix") => line.split(';').next().unwrap().to_string(),
        Some("memory") => masked(line),
        _ => line.to_string(),
    };
    text.lines().map(|line| plain(line) + "\n").collect()
}

/// Each deck of `tests/plans` has the plan beside it, and no two plans are alike. `BLESS=1` writes them anew.
#[test]
fn each_scene_has_the_plan_beside_it() {
    let mut plans: Vec<String> = Vec::new();
    for name in SCENES {
        let scratch = Scratch::new(&format!("plan_{name}"));
        std::fs::copy(folder().join(format!("{name}.inp")), scratch.path("scene.inp")).unwrap();
        let check = scratch.fe(&["check", "scene.inp"]);
        assert_eq!(check.status, 0, "{name}: {}", check.error);
        let plan = without_sizes(&check.output);
        let golden = folder().join(format!("{name}.txt"));
        if std::env::var_os("BLESS").is_some() {
            std::fs::write(&golden, &plan).unwrap();
        }
        assert_eq!(plan, std::fs::read_to_string(&golden).unwrap_or_default(), "{name}: BLESS=1 writes it anew");
        let steps = plan.split("step 1").nth(1).unwrap().to_string();
        assert!(!plans.contains(&steps), "{name} has the plan of another scene");
        plans.push(steps);
    }
}

fn model(name: &str) -> Model {
    let deck = Deck::read(folder().join(format!("{name}.inp"))).unwrap();
    resolve(&deck, &fe::standard()).unwrap()
}

/// What stands in memory when the first step of a scene begins.
struct Begun {
    searched: Vec<Option<usize>>,
    points: usize,
    history: usize,
    matrix: bool,
    solver: bool,
    free: usize,
}

fn begun(name: &str) -> Begun {
    let model = model(name);
    let mut terms = Terms::new(&model).unwrap();
    let mut rest = terms.rest();
    let mut course = Course::new(&model);
    enter(&model, &mut terms, 0, &mut course, &mut rest);
    let scene = scene(&terms, &model.steps[0], &course).unwrap();
    let fixed: Vec<bool> = scene.free().iter().map(|f| !f).collect();
    let free = free_bodies(&terms.structure, &terms.freedoms, &terms.bodies, &fixed, &terms.contacts).len();
    let procedure =
        StaticGeneral::new(scene, static_procedure(&model.steps[0]).unwrap().1, Box::<Multifrontal>::default())
            .unwrap();
    assert_eq!(terms.contacts.capacity() == 0, terms.contacts.is_empty(), "{name}: no storage without pairs");
    Begun {
        searched: terms.contacts.iter().map(|pair| pair.summary().searched).collect(),
        points: terms.contacts.iter().map(|pair| pair.points.len()).sum(),
        history: terms.all().iter().map(|term| term.history()).sum(),
        matrix: procedure.pattern().is_some(),
        solver: procedure.cost().is_some(),
        free,
    }
}

/// No matrix, ordering or factor without unknowns; no search with rigid mains; no history without a state, no multiplier
/// beside a penalty or a law.
#[test]
fn what_a_plan_leaves_out_is_not_there() {
    for name in SCENES {
        let Begun { searched, points, history, matrix, solver, free } = begun(name);
        let pairs = usize::from(!["all_prescribed", "solids_alone"].contains(&name));
        assert_eq!(searched.len(), pairs, "{name}");
        let rigid = name.starts_with("rigid");
        assert!(searched.iter().all(|facets| facets.is_none() == rigid), "{name}: {searched:?}");
        assert_eq!(points > 0, pairs > 0, "{name}");
        // A status for each point; a multiplier beside it only where multipliers make contact hard.
        assert_eq!(history, if name == "multipliers" { 2 * points } else { points }, "{name}");
        assert_eq!((matrix, solver), (name != "all_prescribed", name != "all_prescribed"), "{name}");
        let held_by_contact = ["held_by_contact", "rigid_ring"].contains(&name);
        assert_eq!(free, usize::from(held_by_contact), "{name}");
    }
}

/// The structure is the model's own unless nodes are moved.
#[test]
fn a_job_shares_its_bodies_with_the_model() {
    let mut model = model("deformable_pair");
    assert!(std::ptr::eq(&*Terms::new(&model).unwrap().structure, &*model.structure));
    model.pairs[0].0.adjust = Some(fe_contact::pair::Adjust::Within(0.1));
    assert!(std::ptr::eq(&*Terms::new(&model).unwrap().structure, &*model.structure), "nothing had to be moved");
    let points = &mut std::sync::Arc::make_mut(&mut model.structure).mesh.points;
    points[8..].iter_mut().for_each(|x| x[2] += 0.05);
    assert!(!std::ptr::eq(&*Terms::new(&model).unwrap().structure, &*model.structure));
}

/// A run without unknowns never orders or factors, and its history is empty; the file holds the fields asked for.
#[test]
fn a_run_keeps_to_its_plan() {
    let scratch = Scratch::new("plan_run");
    for (name, fields) in [("all_prescribed", &["U", "RF", "S", "E", "MISES"][..]), ("solids_alone", &["U"])] {
        let deck = scratch.path(&format!("{name}.inp"));
        std::fs::copy(folder().join(format!("{name}.inp")), &deck).unwrap();
        let report = fe::run(&deck, &fe::standard(), &mut fe::observer::Silent).unwrap();
        let (effort, order) = (report.certificate.factorisations, report.certificate.seconds.procedure.order);
        assert_eq!((effort == 0, order == 0.0), (name == "all_prescribed", name == "all_prescribed"), "{name}");
        assert!(report.last.history.iter().all(|h| h.capacity() == 0), "{name}");
        let mut stored = Results::open(&report.results).names("VTKHDF/PointData");
        let mut expected = [fields, &["NodeLabel"]].concat();
        stored.sort();
        expected.sort_unstable();
        assert_eq!(stored, expected, "{name}");
    }
}

/// Element 4 of the solid patch of MacNeal and Harder is folded at a corner, and is told with its element and corner;
/// the others are not. j at a corner is the triple product of its half edges, from the coordinates -1.5813e-3.
#[test]
fn a_brick_folded_at_a_corner_is_warned_of() {
    let scratch = Scratch::with_decks("plan_folded");
    let check = scratch.fe(&["check", "patch_c3d8.inp"]);
    assert_eq!(check.status, 0, "{}", check.error);
    let told: Vec<&str> = check.output.lines().filter(|line| line.contains("folded")).collect();
    assert_eq!(told.len(), 1, "{}", check.output);
    for words in ["patch_c3d8.inp:", "warning: element 4 (C3D8)", "at corner 8 (node 13)", "j = -1.581e-3"] {
        assert!(told[0].contains(words), "{words}: {}", told[0]);
    }
}
