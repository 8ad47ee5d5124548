//! D15: the same scene in other units gives the same numbers and takes the same iterations.

use super::laws;
use crate::hard::ball::{self, Ball};
use crate::hard::deck::Order;
use crate::hard::finding::{Finding, difference};
use crate::hard::patch::{PRESSURE, Patch, YOUNG};
use crate::hard::run::{Place, Run};
use crate::hard::{Scene, deck};
use std::rc::Rc;

/// Factors on lengths, forces and times.
const UNITS: [(&str, [f64; 3]); 7] = [
    ("in m, N, s instead of mm, N, s", [1e-3, 1.0, 1.0]),
    ("lengths x 1e9", [1e9, 1.0, 1.0]),
    ("lengths x 1e-9", [1e-9, 1.0, 1.0]),
    ("forces x 1e9", [1.0, 1e9, 1.0]),
    ("forces x 1e-9", [1.0, 1e-9, 1.0]),
    ("times x 1e9", [1.0, 1.0, 1e9]),
    ("times x 1e-9", [1.0, 1.0, 1e-9]),
];

/// Bound of the case on dimensionless results.
const BOUND: f64 = 1e-9;

/// Scenes of D15.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (name, units) in UNITS {
        scenes.push(Scene::new(format!("patch 3/4, {name}"), move |place| compared(place, (units, 2), &patch)));
    }
    let mesh = Rc::new(std::cell::OnceCell::new());
    for (name, units) in UNITS {
        let mesh = Rc::clone(&mesh);
        let scene = Scene::new(format!("ball, {name}"), move |place| {
            let mesh = mesh.get_or_init(ball::mesh);
            compared(place, (units, 2), &|[length, force, time]| {
                Ball { length, force, time, ..Ball::default() }.deck(mesh)
            })
        });
        scenes.push(scene.slow());
    }
    for (name, units) in UNITS {
        let name = format!("A03, {name}");
        let scene = Scene::new(name, move |place| compared(place, (units, 2), &laws::exponential));
        scenes.push(scene);
    }
    for (name, units) in UNITS {
        scenes.push(Scene::new(format!("A10, {name}"), move |place| compared(place, (units, 1), &winkler)));
    }
    scenes.push(Scene::waits("B04 in other units, density", "dynamics"));
    scenes
}

/// The pressed patch 3/4.
fn patch([l, f, t]: [f64; 3]) -> String {
    let patch = Patch::plane(3, 4);
    let mut mesh = patch.mesh();
    mesh.points.iter_mut().for_each(|p| *p = p.map(|x| x * l));
    let sets = ["LOW_BLOCK", "UP_BLOCK"];
    format!(
        "{}{}*SURFACE INTERACTION, NAME=I\n{}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nUP_YMIN, LOW_YMAX\n\
         *BOUNDARY\nLOW_YMIN, 2\nLOW_XMIN, 1\nUP_XMIN, 1\n*STEP\n*STATIC\n{t:e}, {t:e}\n\
         *CONTROLS, PARAMETERS=FIELD\n1e-12\n*DSLOAD\nUP_YMAX, P, {:e}\n*END STEP\n",
        deck::cards(&mesh, &sets.map(|set| (set, patch.element)), Order::AsMade),
        // A thickness of one unit: forces are those of a slab as thick as the unit of length.
        deck::elastic(&sets, YOUNG * f / (l * l), patch.poisson),
        patch.behavior,
        PRESSURE * f / (l * l),
    )
}

/// Half of A10's beam on a rigid flat by LINEAR contact, a force per length, pressed in its middle, which a slide holds.
fn winkler([l, f, t]: [f64; 3]) -> String {
    let (mut nodes, mut beams) = (String::new(), String::new());
    for i in 0..=20 {
        nodes += &format!("{}, {:e}, 0., 0.\n", i + 1, 40.0 * f64::from(i) * l);
        if i > 0 {
            beams += &format!("{i}, {i}, {}\n", i + 1);
        }
    }
    format!(
        "*NODE\n{nodes}99, 0., 0., {:e}\n*ELEMENT, TYPE=B33, ELSET=BEAM\n{beams}\
         *BEAM GENERAL SECTION, ELSET=BEAM, SECTION=GENERAL\n{:e}, {:e}, 0., {:e}, {:e}\n0., 1., 0.\n{:e}, {:e}\n\
         *NSET, NSET=BEAM, GENERATE\n1, 21\n*SURFACE, NAME=LINE\nBEAM,\n\
         *SURFACE, NAME=FLAT, TYPE=CYLINDER\n0., 0., 0., {:e}, 0., 0.\n0., {l:e}, 0.\nSTART, {:e}, 0.\nLINE, {:e}, 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLAT, REF NODE=99\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:e}\n*CONTACT PAIR, INTERACTION=I\nLINE, FLAT\n\
         *BOUNDARY\n99, 1, 6\nBEAM, 2\nBEAM, 4\nBEAM, 6\n1, 1\n1, 5\n*STEP\n*STATIC\n{t:e}, {t:e}\n\
         *CONTROLS, PARAMETERS=FIELD\n1e-10\n*CLOAD\n1, 3, {:e}\n*END STEP\n",
        -100.0 * l,
        400.0 * l * l,
        2e4 * l.powi(4),
        2e4 * l.powi(4),
        4e4 * l.powi(4),
        2.1e5 * f / (l * l),
        8e4 * f / (l * l),
        l,
        -2000.0 * l,
        2000.0 * l,
        5.0 * f / (l * l),
        -5000.0 * f,
    )
}

/// The law's number is a force over this power of a length.
fn compared(place: &Place, (units, power): ([f64; 3], i32), deck: &dyn Fn([f64; 3]) -> String) -> Finding {
    let reference = place.run("reference", &deck([1.0; 3]));
    let run = place.run("scaled", &deck(units));
    let mut found = Finding::converged(&run).and(Finding::converged(&reference)).holds(
        (run.iterations, run.cutbacks) == (reference.iterations, reference.cutbacks),
        format!("{} iterations instead of {}", run.iterations, reference.iterations),
    );
    let dimensionless = |run: &Run, [l, f, _]: [f64; 3]| {
        let solved = run.solved()?;
        let u: Vec<f64> = solved.displacements().into_iter().flatten().map(|u| u / l).collect();
        let p: Vec<f64> = solved.pressures().iter().map(|p| p * l.powi(power) / f).collect();
        Some((u, p))
    };
    if let (Some((u, p)), Some((v, q))) = (dimensionless(&reference, [1.0; 3]), dimensionless(&run, units)) {
        found = found.within(difference(&u, &v), BOUND).within(difference(&p, &q), BOUND);
    }
    found
}
