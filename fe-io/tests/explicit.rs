//! What decks for explicit dynamics say, and what the model holds of it.

use fe_core::step::{Displacements, Explicit, IncrementChoice, Procedure};
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
        displacements: Displacements::Large,
    };
    let step = |card: &str| format!("*STEP\n*DYNAMIC, EXPLICIT{card}\n*END STEP\n");
    assert_eq!(explicit(&with(&step("\n, 2.")), 0), usual);
    let scaled = Explicit { scale: 0.5, largest: Some(0.1), increment: IncrementChoice::ElementByElement, ..usual };
    assert_eq!(explicit(&with(&step(", ELEMENT BY ELEMENT, SCALE FACTOR=0.5\n, 2., , 0.1")), 0), scaled);
    let fixed = Explicit { increment: IncrementChoice::Fixed(0.25), ..usual };
    assert_eq!(explicit(&with(&step(", DIRECT USER CONTROL\n0.25, 2.")), 0), fixed);
    let small = step("\n, 2.").replace("*STEP", "*STEP, NLGEOM=NO");
    assert_eq!(explicit(&with(&small), 0), Explicit { displacements: Displacements::Small, ..usual });
    let cards =
        ["\n, 2.\n*BULK VISCOSITY\n0.", "\n, 2.", "\n, 2.\n*BULK VISCOSITY\n0.1, 0.", "\n, 2.\n*BULK VISCOSITY"];
    let model = with(&cards.map(step).concat());
    let viscosities: Vec<[f64; 2]> = (0..4).map(|i| explicit(&model, i).bulk_viscosity).collect();
    assert_eq!(viscosities, [[0.0, 1.2], [0.0, 1.2], [0.1, 0.0], [0.06, 1.2]]);
}
