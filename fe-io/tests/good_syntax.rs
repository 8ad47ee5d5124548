//! The ways in which decks write the same thing.

use fe_contact::interaction::{Enforcement, NormalBehavior, Penalty};
use fe_contact::pair::{Adjust, Discretization};
use fe_core::step::{Controls, Procedure};
use fe_io::model::{Frames, Quantity, Totals};
use fe_io::{Deck, Library, Model, resolve};

fn model(text: &str) -> Model {
    let answer = Deck::from_text("test.inp", text).and_then(|deck| resolve(&deck, &Library::default()));
    answer.unwrap_or_else(|faults| panic!("{faults}"))
}

fn controls(model: &Model, step: usize) -> Controls {
    match model.steps[step].procedure {
        Procedure::Static { controls, .. } => controls,
        Procedure::Explicit(_) => panic!("it is static"),
    }
}

const PLAIN: &str = include_str!("good/plain.inp");
const ODD: &str = include_str!("good/odd.inp");

/// Same bodies, supports, steps, whatever the spelling.
#[test]
fn odd_spelling_means_the_same() {
    let (plain, odd) = (model(PLAIN), model(ODD));
    assert_eq!(plain.structure, odd.structure);
    assert_eq!((plain.supports, &plain.heading), (odd.supports, &odd.heading));
    let of = |m: &Model| {
        let steps = m.steps.iter();
        let parts = steps.map(|s| (s.procedure, s.supports.clone(), s.nodal_loads.clone(), s.output.clone()));
        parts.collect::<Vec<_>>()
    };
    assert_eq!(of(&model(PLAIN)), of(&model(ODD)));
    assert!(plain.notes.is_empty(), "{:?}", plain.notes);
    // UNSORTED, and a card without effect.
    assert_eq!(odd.notes.len(), 2, "{:?}", odd.notes);
}

#[test]
fn line_ends_of_windows_and_a_byte_order_mark() {
    let windows = format!("\u{feff}{}", PLAIN.replace('\n', "\r\n"));
    let folder = std::env::temp_dir().join(format!("deck-line-ends-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for scratch files");
    let path = folder.join("windows.inp");
    std::fs::write(&path, windows).expect("the folder is writable");
    let deck = Deck::read(&path).expect("the deck is sound");
    let read = resolve(&deck, &Library::default()).expect("the deck is sound");
    std::fs::remove_dir_all(&folder).expect("it was made above");
    assert_eq!(read.structure, model(PLAIN).structure);
}

#[test]
fn included_files_and_meshes_are_looked_up_beside_the_deck() {
    let deck = Deck::read("tests/good/includes.inp").unwrap_or_else(|faults| panic!("{faults}"));
    let read = resolve(&deck, &Library::default()).unwrap_or_else(|faults| panic!("{faults}"));
    assert_eq!(read.structure, model(PLAIN).structure);
    assert_eq!(&*read.steps[0].place.file, "tests/good/step.inc");
    assert_eq!(read.steps[0].place.line, 2);
}

/// Penalties, linear and not, and a formula; what is left blank of a nonlinear penalty is 0.03, 0.01 and 1/3.
#[test]
fn behaviors() {
    let model = model(include_str!("good/behaviors.inp"));
    let of = |i: usize| &model.interactions[i].normal;
    let NormalBehavior::Hard(Enforcement::NonlinearPenalty(usual)) = of(0) else { panic!("{:?}", of(0)) };
    assert_eq!(usual.last, Penalty { stiffness: None, clearance: 0.0, scale: 1.0 });
    assert_eq!((usual.upper, usual.initial, usual.lower), (0.03, 0.01, 1.0 / 3.0));
    let NormalBehavior::Hard(Enforcement::NonlinearPenalty(given)) = of(1) else { panic!("{:?}", of(1)) };
    assert_eq!(given.last, Penalty { stiffness: Some(2e5), clearance: 0.01, scale: 0.5 });
    assert_eq!((given.upper, given.initial, given.lower), (0.06, 0.02, 0.5));
    let NormalBehavior::Hard(Enforcement::Penalty(linear)) = of(2) else { panic!("{:?}", of(2)) };
    assert_eq!(linear.stiffness, Some(1000.0));
    let NormalBehavior::Softened(formula) = of(3) else { panic!("{:?}", of(3)) };
    // K c² + 2 K c h = 400 + 8000 h.
    assert!((formula.respond(-0.05).pressure - 800.0).abs() < 1e-10);
}

#[test]
fn contact_cards() {
    let model = model(include_str!("good/contact.inp"));
    assert_eq!(model.interactions.len(), 2);
    let NormalBehavior::Hard(Enforcement::Penalty(Penalty { stiffness, clearance, scale })) =
        model.interactions[0].normal
    else {
        panic!("{:?}", model.interactions[0]);
    };
    assert_eq!((stiffness, clearance, scale), (Some(1e5), 0.01, 2.0));
    let NormalBehavior::Softened(law) = &model.interactions[1].normal else { panic!("{:?}", model.interactions[1]) };
    // p = k h: slope 100, overclosure 0.5.
    assert_eq!(law.respond(-0.5).pressure, 50.0);
    let pairs: Vec<_> = model.pairs.iter().map(|(pair, place)| (pair, place.line)).collect();
    assert_eq!(pairs.len(), 3);
    assert_eq!(pairs[0].0.discretization, Discretization::SurfaceToSurface);
    assert_eq!(pairs[1].0.discretization, Discretization::NodeToSurface);
    assert_eq!(pairs[1].0.adjust, Some(Adjust::Within(0.05)));
    assert_eq!(pairs[2].0.adjust, Some(Adjust::Nodes(vec![8, 9])));
    assert!(pairs.windows(2).all(|two| two[0].1 < two[1].1));
    assert_eq!(model.references(), vec![16]);
    // Free faces of the upper cube: all but none are shared, six faces.
    assert_eq!(model.structure.mesh.surfaces["SKIN"].len(), 6);
}

#[test]
fn requests_hold_until_a_step_has_such_a_card() {
    let model = model(include_str!("good/requests.inp"));
    let names = |step: usize| model.steps[step].output.tables.iter().map(|t| &t.quantity).collect::<Vec<_>>();
    assert_eq!(names(0), [&Quantity::Displacement, &Quantity::Reaction, &Quantity::Stress]);
    assert_eq!(names(1), names(0));
    assert_eq!(names(2), [&Quantity::Stress, &Quantity::Reaction]);
    assert_eq!(model.steps[2].output.tables[1].totals, Totals::Only);
    assert_eq!(model.steps[0].output.fields, None);
    assert_eq!(model.steps[1].output.fields.as_deref(), Some(&["U".to_owned(), "S".to_owned()][..]));
    assert_eq!(model.steps[2].output.frames, Frames::Increments(5));
    assert!(model.steps[1].supports.replace && !model.steps[2].supports.replace);
    assert_eq!(controls(&model, 1).balance, 1e-6);
    assert_eq!(controls(&model, 2).d_f, 0.1);
    assert_eq!(controls(&model, 2).balance, 1e-6);
}

/// Defaults of `*STATIC`: Abaqus Keywords Reference.
#[test]
fn static_defaults() {
    let steps = |line: &str| {
        let text = PLAIN.replace("0.25, 1.\n", line);
        let Procedure::Static { increments, .. } = model(&text).steps[0].procedure else { panic!("it is static") };
        [increments.initial, increments.period, increments.minimum, increments.maximum]
    };
    assert_eq!(steps(""), [1.0, 1.0, 1e-5, 1.0]);
    assert_eq!(steps("\n"), [1.0, 1.0, 1e-5, 1.0]);
    assert_eq!(steps("0.1, 2.,\n"), [0.1, 2.0, 2e-5, 2.0]);
    assert_eq!(steps(", 4., , 2.\n".replace(", 4.", "1., 4.").as_str()), [1.0, 4.0, 4e-5, 2.0]);
    assert_eq!(steps("1e-6, 1., 0., 0.\n"), [1e-6, 1.0, 1e-6, 1.0]);
}

/// Requests that do less than they seem to are remarked on; `VARIABLE=` fields are added to, not replaced.
#[test]
fn requests_without_effect_are_told() {
    let with = |requests: &str| model(&PLAIN.replace("*END STEP", &format!("{requests}*END STEP")));
    let notes = |requests: &str| with(requests).notes.join("\n");
    assert!(notes("*CONTACT PRINT\nCSTRESS\n").contains("no contact pair"), "{}", notes("*CONTACT PRINT\nCF\n"));
    assert!(notes("*NODE PRINT, NSET=TOP, TOTALS=ONLY\nU\n").contains("`TOTALS` of this `*NODE PRINT` has no effect"));
    assert_eq!(notes("*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF, U\n"), "");
    let fields = |requests: &str| with(requests).steps[0].output.fields.clone().expect("fields are chosen");
    let all = fields("*OUTPUT, FIELD, VARIABLE=PRESELECT\n");
    assert_eq!(fields("*OUTPUT, FIELD, VARIABLE=PRESELECT\n*NODE OUTPUT\nU\n"), all);
    assert_eq!(fields("*OUTPUT, FIELD\n*NODE OUTPUT\nU\n"), ["U"]);
    assert_eq!(fields("*OUTPUT, FIELD\n*NODE OUTPUT, VARIABLE=PRESELECT\n"), ["U", "RF"]);
}
