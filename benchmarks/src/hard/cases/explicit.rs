//! D38: explicit steps at their limits.

use crate::hard::finding::Finding;
use crate::hard::run::Run;
use crate::hard::{Place, Scene};

/// Scenes of D38.
pub fn scenes() -> Vec<Scene> {
    vec![
        Scene::new("a bar with increments 1 % above the stable one", |place| {
            Finding::halted(
                &place.run("bar", &bar(1.01)),
                &["increment", "times the energy", "longer than the stable one", "element"],
            )
        }),
        Scene::new("a bar with increments 1 % below it", |place| Finding::converged(&place.run("bar", &bar(0.99)))),
        Scene::new("a massless node in contact", |place| {
            let deck = cube("PENALTY", "").replace("*DENSITY\n1.\n", "");
            Finding::refused(&place.run("cube", &deck), &["mass"])
        }),
        Scene::new("a penalty of 1e6 times the usual one", |place| stiff(place, "PENALTY")),
        Scene::new("the same factor beside kinematic contact", |place| stiff(place, "KINEMATIC")),
        Scene::new("an element that shrinks to nothing", |place| {
            Finding::halted(&place.run("flat", &flat()), &["increment", "has shrunk", "element 1", "energy"])
        }),
    ]
}

/// Twenty trusses of length and wave speed 1, let go with a velocity at the end, by increments of so much of the stable one of
/// an element.
fn bar(part: f64) -> String {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    (0..=20).for_each(|i| deck += &format!("{}, {i}., 0.\n", i + 1));
    deck += "*NSET, NSET=END\n21\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n";
    (1..=20).for_each(|i| deck += &format!("{i}, {i}, {}\n", i + 1));
    deck += "*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.\n*BOUNDARY\n1, 1, 1\n\
             ALL, 2, 2\n*INITIAL CONDITIONS, TYPE=VELOCITY\nEND, 1, 1e-6\n";
    deck + &format!(
        "*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n{part:?}, {:?}\n*BULK VISCOSITY\n0., 0.\n*END STEP\n",
        2000.0 * part
    )
}

const BRICK: &str = "*NODE, NSET=ALL\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n5, 0., 0., 1.\n6, 1., 0., 1.\n\
                     7, 1., 1., 1.\n8, 0., 1., 1.\n*NSET, NSET=FOOT\n1, 2, 3, 4\n*NSET, NSET=HEAD\n5, 6, 7, 8\n\
                     *ELEMENT, TYPE=C3D8R, ELSET=CUBE\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n\
                     *DENSITY\n1.\n*SOLID SECTION, ELSET=CUBE, MATERIAL=M\n";

/// A cube that falls flat on a rigid facet with a hundredth of its speed of sound.
fn cube(constraint: &str, controls: &str) -> String {
    format!(
        "{BRICK}*NODE\n11, -1., -1., -0.05\n12, 2., -1., -0.05\n13, 2., 2., -0.05\n14, -1., 2., -0.05\n19, 0., 0., -1.\n\
         *ELEMENT, TYPE=R3D4, ELSET=WALL\n11, 11, 12, 13, 14\n*RIGID BODY, REF NODE=19, ELSET=WALL\n\
         *SURFACE, NAME=DOWN\nCUBE, S1\n*SURFACE, NAME=UP\nWALL, SPOS\n*SURFACE INTERACTION, NAME=I\n\
         *INITIAL CONDITIONS, TYPE=VELOCITY\nALL, 3, -0.01\n*BOUNDARY\n19, 1, 6\n*STEP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=0.2\n, 10.\n\
         *CONTACT PAIR, INTERACTION=I, MECHANICAL CONSTRAINT={constraint}, CPSET=P\nDOWN, UP\n{controls}*END STEP\n"
    )
}

/// With the stiff penalty an increment is, while it is closed, a hundredth of the usual one or less, and grows back by 1.05 at
/// most: ln 100/ln 1.05 = 94 increments more. Impulses leave increments as they are, whatever the penalty would be.
fn stiff(place: &Place, constraint: &str) -> Finding {
    let controls = "*CONTACT CONTROLS, CPSET=P, SCALE PENALTY=1e6\n";
    let [usual, scaled] =
        [("usual", ""), ("scaled", controls)].map(|(name, controls)| place.run(name, &cube(constraint, controls)));
    let count = |run: &Run| run.ended.as_ref().map_or(0, |report| report.certificate.increments);
    let (before, after) = (count(&usual), count(&scaled));
    let follows = if constraint == "PENALTY" { after >= before + 94 } else { after == before };
    Finding::converged(&usual)
        .and(Finding::converged(&scaled))
        .say(format!("{before} and {after} increments"))
        .holds(follows, format!("{after} increments with the factor, {before} without"))
}

/// A cube whose top comes down on its foot at a twentieth of the speed of sound.
fn flat() -> String {
    format!(
        "{BRICK}*BOUNDARY\nFOOT, 1, 3\nHEAD, 1, 2\n*STEP\n*DYNAMIC, EXPLICIT, SCALE FACTOR=0.2\n, 100.\n*BOUNDARY, TYPE=VELOCITY\n\
         HEAD, 3, 3, -0.05\n*END STEP\n"
    )
}
