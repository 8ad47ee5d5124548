//! What decks for explicit dynamics say, and what the model holds of it.

use fe_contact::interaction::NormalBehavior;
use fe_contact::pair::{GeneralContact, MechanicalConstraint, Region, Sliding};
use fe_contact::surface::{Main, Secondary};
use fe_contact::viscous::{DampingAmount, ExplicitDamping};
use fe_core::amplitude::Course;
use fe_core::element::ElementType;
use fe_core::load::Prescribed;
use fe_core::material::{Damping, Elastic, Hardening, NeoHooke, Response};
use fe_core::step::{Explicit, IncrementChoice, MassScaling, Procedure, ScaledAt, ScaledTo};
use fe_core::structure::{Hourglass, HourglassControl};
use fe_io::model::{ActivePair, Frames, Quantity, RigidBody};
use fe_io::{Deck, Library, Model, resolve};

const CUBE: &str = include_str!("good/explicit_cube.inp");

fn read(text: &str) -> Result<Model, String> {
    let answer = Deck::from_text("test.inp", text).and_then(|deck| resolve(&deck, &Library::default()));
    answer.map_err(|faults| faults.to_string())
}

/// The model of the cube with other steps.
fn with(steps: &str) -> Model {
    let model = CUBE.split("*STEP").next().unwrap_or_default();
    read(&format!("{model}{steps}")).unwrap_or_else(|faults| panic!("{faults}"))
}

fn explicit(model: &Model, step: usize) -> Explicit {
    match model.steps[step].procedure {
        Procedure::Explicit(explicit) => explicit,
        other => panic!("{other:?}"),
    }
}

/// Defaults and data line of `*DYNAMIC, EXPLICIT`; `*BULK VISCOSITY` holds until a step changes it.
#[test]
fn procedures() {
    let usual = Explicit {
        period: 2.0,
        increment: IncrementChoice::Global,
        scale: 1.0,
        largest: None,
        bulk_viscosity: [0.06, 1.2],
    };
    let step = |card: &str| format!("*STEP\n*DYNAMIC, EXPLICIT{card}\n*END STEP\n");
    assert_eq!(explicit(&with(&step("\n, 2.")), 0), usual);
    let scaled = Explicit { scale: 0.5, largest: Some(0.1), increment: IncrementChoice::ElementByElement, ..usual };
    assert_eq!(explicit(&with(&step(", ELEMENT BY ELEMENT, SCALE FACTOR=0.5\n, 2., , 0.1")), 0), scaled);
    let fixed = Explicit { increment: IncrementChoice::Fixed(0.25), ..usual };
    assert_eq!(explicit(&with(&step(", DIRECT USER CONTROL\n0.25, 2.")), 0), fixed);
    let large = step("\n, 2.").replace("*STEP", "*STEP, NLGEOM=YES");
    assert_eq!(explicit(&with(&large), 0), usual);
    let cards =
        ["\n, 2.\n*BULK VISCOSITY\n0.", "\n, 2.", "\n, 2.\n*BULK VISCOSITY\n0.1, 0.", "\n, 2.\n*BULK VISCOSITY"];
    let model = with(&cards.map(step).concat());
    let viscosities: Vec<[f64; 2]> = (0..4).map(|i| explicit(&model, i).bulk_viscosity).collect();
    assert_eq!(viscosities, [[0.0, 1.2], [0.0, 1.2], [0.1, 0.0], [0.06, 1.2]]);
}

/// Materials of explicit steps; what a node begins with, and what of it is prescribed.
#[test]
fn materials_and_velocities() {
    let text = CUBE.replace("*DENSITY", "*PLASTIC\n200., 0.\n300., 0.05\n*DAMPING, ALPHA=2., BETA=1e-9\n*DENSITY");
    let data = "*AMPLITUDE, NAME=UP, DEFINITION=SMOOTH STEP\n0., 0., 1., 1.\n*INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 3, -5.\n7, 1, 2.\n\
                *MATERIAL, NAME=RUBBER\n*HYPERELASTIC, NEO HOOKE\n80.\n*STEP";
    let motion = "*BOUNDARY, AMPLITUDE=UP\n5, 3, 3, 0.1\n*BOUNDARY, TYPE=VELOCITY\n6, 3, 3, -1.\n\
                  *BOUNDARY, TYPE=ACCELERATION\n7, 3, 3, 2.\n*END STEP";
    let model =
        read(&text.replace("*STEP", data).replace("*END STEP", motion)).unwrap_or_else(|faults| panic!("{faults}"));
    let steel = &model.structure.materials[0];
    let elastic = Elastic { young: 210e3, poisson: 0.3 };
    let hardening = Hardening { points: vec![(0.0, 200.0), (0.05, 300.0)] };
    assert_eq!(steel.response, Response::Plastic { elastic, hardening });
    assert_eq!((steel.density, steel.damping), (Some(7.85e-9), Damping { alpha: 2.0, beta: 1e-9 }));
    // K = 2/D1 = 20 · 2 C10.
    assert_eq!(model.structure.materials[1].response, Response::NeoHooke(NeoHooke { c10: 80.0, d1: 2.0 / 3200.0 }));
    assert!(model.notes.iter().any(|note| note.contains("20 shear moduli")), "{:?}", model.notes);
    let velocities: Vec<_> = (0..8).map(|node| (node, 2, -5.0)).chain([(6, 0, 2.0)]).collect();
    assert_eq!(model.initial_velocities, velocities);
    let supports: Vec<_> = model.steps[0].supports.items.iter().map(|s| (s.node, s.prescribed, s.value)).collect();
    let wanted = [Prescribed::Displacement, Prescribed::Velocity, Prescribed::Acceleration].into_iter();
    let wanted: Vec<_> = wanted.zip([(4, 0.1), (5, -1.0), (6, 2.0)]).map(|(p, (node, v))| (node, p, v)).collect();
    assert_eq!(supports, wanted);
    assert_eq!(model.amplitudes[0].course, Course::SmoothStep);
}

/// Facets of rigid bodies, their sides, masses at reference nodes, and elements with one integration point.
#[test]
fn rigid_bodies_and_reduced_elements() {
    let text = CUBE.replace("TYPE=C3D8", "TYPE=C3D8R").replace("MATERIAL=STEEL", "MATERIAL=STEEL, CONTROLS=SOFT");
    let data = "*SECTION CONTROLS, NAME=SOFT, HOURGLASS=VISCOUS\n0.5\n*NODE\n11, 0., 0., -1.\n12, 1., 0., -1.\n13, 1., 1., -1.\n\
                14, 0., 1., -1.\n15, 2., 0., -1.\n19, 0., 0., -2.\n*ELEMENT, TYPE=R3D3, ELSET=FLOOR\n12, 12, 15, 13\n\
                *ELEMENT, TYPE=R3D4, ELSET=FLOOR\n11, 11, 12, 13, 14\n*RIGID BODY, ELSET=FLOOR, REF NODE=19\n\
                *ELEMENT, TYPE=MASS, ELSET=M\n30, 19\n*MASS, ELSET=M\n1.\n*SURFACE, NAME=UP\nFLOOR, SPOS\n\
                *SURFACE, NAME=DOWN\nFLOOR, SNEG\n*STEP";
    let model = read(&text.replace("*STEP", data)).unwrap_or_else(|faults| panic!("{faults}"));
    let structure = &model.structure;
    let (section, hourglass) = (&structure.sections[0], Hourglass { control: HourglassControl::Viscous, scale: 0.5 });
    assert_eq!((section.element, section.hourglass), (ElementType::C3D8R, Some(hourglass)));
    let floor = &structure.mesh.cell_sets["FLOOR"];
    let body = RigidBody { reference: 13, cells: floor.clone(), surface: None };
    assert_eq!((&model.rigid_bodies, model.references()), (&vec![body], vec![13]));
    let corners = |surface: &str| -> Vec<Vec<u32>> {
        structure.mesh.surfaces[surface].iter().map(|face| structure.mesh.face(*face).1).collect()
    };
    assert_eq!(corners("UP"), [vec![9, 12, 10], vec![8, 9, 10, 11]]);
    assert_eq!(corners("DOWN"), [vec![9, 10, 12], vec![8, 11, 10, 9]]);
    // Nodes of facets have no freedoms, the reference node has those of its body.
    let masks = structure.masks();
    assert_eq!(masks[8..13], [0; 5]);
    assert_eq!(structure.freedoms(&model.references()).of_node(13).len(), 6);
}

/// The decks of problems with known answers are read.
#[test]
fn decks_of_laws_and_impacts() {
    let [bounce, exponential, linear, oscillator] = [
        include_str!("good/explicit_bounce.inp"),
        include_str!("good/explicit_law_exponential.inp"),
        include_str!("good/explicit_law_linear.inp"),
        include_str!("good/explicit_oscillator.inp"),
    ]
    .map(|text| read(text).unwrap_or_else(|faults| panic!("{faults}")));
    let acting = ActivePair { pair: 0, interaction: Some(0), scale_penalty: 1.0 };
    for model in [&bounce, &exponential, &linear] {
        let (pair, _) = &model.explicit_pairs[0];
        assert_eq!((model.explicit_pairs.len(), pair.constraint), (1, MechanicalConstraint::Penalty));
        assert_eq!(pair.secondary, Secondary::Nodes(vec![(5, None)]));
        let Main::Faces(faces) = &pair.main else { panic!("{:?}", pair.main) };
        assert_eq!(model.structure.mesh.face(faces[0]).1, [0, 1, 2, 3]);
        assert!(model.steps.iter().all(|step| step.explicit_pairs == [acting]));
        let damping = ExplicitDamping { amount: DampingAmount::CriticalFraction(0.0), tangent_fraction: 1.0 };
        assert_eq!(model.interactions[0].explicit_damping, Some(damping));
    }
    let printed: Vec<_> = bounce.steps[1].output.tables.iter().map(|table| &table.quantity).collect();
    assert_eq!(printed, [&Quantity::Displacement, &Quantity::Velocity, &Quantity::Reaction]);
    assert_eq!(linear.steps[0].supports.items[0].prescribed, Prescribed::Velocity);
    assert_eq!(oscillator.initial_velocities, [(1, 0, 200.0)]);
    // k_max, which static steps leave out: the slope is held there.
    let NormalBehavior::Softened(law) = &exponential.interactions[0].normal else { panic!("it is softened") };
    assert!((law.respond(-1.0).stiffness - 6000.0).abs() < 1e-9 * 6000.0);
}

/// Pairs and interactions hold until a step changes them.
#[test]
fn pairs_hold_until_a_step_changes_them() {
    let scene = include_str!("good/explicit_bounce.inp").split("*STEP").next().unwrap_or_default();
    let step = |cards: &str| format!("*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n{cards}*END STEP\n");
    let steps = [
        "*CONTACT PAIR, INTERACTION=I, CPSET=A, WEIGHT=0.5, SMALL SLIDING\nBALLS, WALLS\n",
        "*CONTACT CONTROLS, CPSET=A, SCALE PENALTY=3.\n*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, NO SEPARATION\n*FRICTION\n0.3\n",
        "*CONTACT PAIR, MECHANICAL CONSTRAINT=PENALTY\nBALLS, WALLS\n",
        "",
        "*CONTACT PAIR, OP=DELETE\nBALLS, WALLS\n",
    ];
    let model = read(&(scene.to_owned() + &steps.map(step).concat())).unwrap_or_else(|faults| panic!("{faults}"));
    let in_force: Vec<Vec<ActivePair>> = model.steps.iter().map(|step| step.explicit_pairs.clone()).collect();
    let active = |pair, interaction, scale_penalty| vec![ActivePair { pair, interaction, scale_penalty }];
    let anew = active(1, None, 1.0);
    assert_eq!(in_force, [active(0, Some(0), 1.0), active(0, Some(1), 3.0), anew.clone(), anew, vec![]]);
    let (first, second) = (&model.explicit_pairs[0].0, &model.explicit_pairs[1].0);
    assert_eq!(
        (first.constraint, first.sliding, first.weight),
        (MechanicalConstraint::Kinematic, Sliding::Small, Some(0.5))
    );
    assert_eq!(
        (second.constraint, second.sliding, second.weight),
        (MechanicalConstraint::Penalty, Sliding::Finite, None)
    );
    for idle in ["`WEIGHT` has no effect", "`SMALL SLIDING` has no effect"] {
        assert!(model.notes.iter().any(|note| note.contains(idle)), "{:?}", model.notes);
    }
    let [before, after] = [&model.interactions[0], &model.interactions[1]];
    assert!(before.friction.is_none() && after.friction.is_some() && after.no_separation);
    assert_eq!((&before.name, before.explicit_damping.is_some()), (&after.name, true));
}

/// Masses are scaled as the last card of a kind says; frames come as often as the last `*OUTPUT` says.
#[test]
fn mass_scaling_and_frames() {
    let step = |cards: &str| format!("*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n{cards}\n*END STEP\n");
    let steps = [
        "*FIXED MASS SCALING, FACTOR=4., ELSET=CUBE\n*VARIABLE MASS SCALING, DT=1e-7, TYPE=BELOW MIN, NUMBER INTERVAL=5",
        "*FIXED MASS SCALING, DT=1e-6, TYPE=SET EQUAL DT\n*OUTPUT, FIELD, NUMBER INTERVAL=10",
        "*OUTPUT, FIELD, TIME INTERVAL=2e-6",
        "*OUTPUT, HISTORY, TIME INTERVAL=1e-7\n*ENERGY OUTPUT\nALLKE\n*RESTART, WRITE\n*FILE OUTPUT, NUMBER INTERVAL=3",
    ];
    let model = with(&steps.map(step).concat());
    let cells = model.structure.mesh.cell_sets["CUBE"].clone();
    let fixed = MassScaling { cells: cells.clone(), factor: 4.0, target: None, when: ScaledAt::Start };
    let below = Some((1e-7, ScaledTo::BelowMinimum));
    let variable = MassScaling { cells: cells.clone(), factor: 1.0, target: below, when: ScaledAt::Parts(5) };
    let equal = Some((1e-6, ScaledTo::EqualIncrement));
    let anew = MassScaling { cells, factor: 1.0, target: equal, when: ScaledAt::Start };
    assert_eq!(model.steps[0].mass_scaling, [fixed, variable.clone()]);
    assert!((1..4).all(|i| model.steps[i].mass_scaling == [variable.clone(), anew.clone()]));
    let frames: Vec<Frames> = model.steps.iter().map(|step| step.output.frames).collect();
    assert_eq!(frames, [Frames::EXPLICIT, Frames::Parts(10), Frames::Time(2e-6), Frames::Time(2e-6)]);
}

/// General contact holds from the model data on until a step adds to it or replaces it.
#[test]
fn general_contact() {
    let data = "*SURFACE, NAME=TOP\nCUBE, S2\n*SURFACE, NAME=FOOT\nCUBE, S1\n*SURFACE INTERACTION, NAME=I\n*CONTACT\n\
                *CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n";
    let step = |cards: &str| format!("*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n{cards}*END STEP\n");
    let steps = [
        "",
        "*CONTACT\n*CONTACT EXCLUSIONS\nTOP, FOOT\n*CONTACT CONTROLS ASSIGNMENT, TYPE=SCALE PENALTY\nTOP,, 2.\n",
        "*CONTACT, OP=NEW\n*CONTACT INCLUSIONS\n,\n, TOP\n",
    ];
    let model = with(&(data.to_owned() + &steps.map(step).concat()));
    let all = || [Region::AllExterior, Region::AllExterior];
    let [top, foot] = ["TOP", "FOOT"].map(|name| Region::Surface(name.into()));
    let first = GeneralContact { inclusions: vec![all()], interactions: vec![(all(), 0)], ..Default::default() };
    let second = GeneralContact {
        exclusions: vec![[top.clone(), foot]],
        scale_penalty: vec![([top.clone(), top.clone()], 2.0)],
        ..first.clone()
    };
    let third = GeneralContact { inclusions: vec![all(), [Region::AllExterior, top]], ..Default::default() };
    let found: Vec<_> = model.steps.iter().map(|step| step.general_contact.clone()).collect();
    assert_eq!(found, [first, second, third].map(Some));
}

/// C3D10M is C3D10 in both kinds of steps, and a note says so.
#[test]
fn c3d10m_is_taken_as_c3d10() {
    let cards = CUBE.split_once("*NSET").map(|(_, rest)| rest).unwrap_or_default();
    let tetrahedron = "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 1., 0.\n4, 0., 0., 1.\n5, .5, 0., 0.\n\
                       6, .5, .5, 0.\n7, 0., .5, 0.\n8, 0., 0., .5\n9, .5, 0., .5\n10, 0., .5, .5\n\
                       *ELEMENT, TYPE=C3D10M, ELSET=CUBE\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n*NSET";
    let explicit = format!("{tetrahedron}{cards}").replace("LOW, 1, 3", "1, 1, 3");
    let fixed = explicit.replace("*DYNAMIC, EXPLICIT\n, 1e-5", "*STATIC\n1., 1.");
    assert_ne!(fixed, explicit);
    for text in [explicit, fixed] {
        let model = read(&text).unwrap_or_else(|faults| panic!("{faults}"));
        assert_eq!(model.structure.elements, [ElementType::C3D10]);
        assert!(model.notes.iter().any(|note| note.contains("C3D10M is taken as C3D10")), "{:?}", model.notes);
    }
}
