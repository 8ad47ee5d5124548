//! D25: friction at its limits, on a block that a pressure lays on a rigid plane and springs hold along it.

use crate::hard::Scene;
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, difference, from_value};
use crate::hard::patch::EXACT;
use crate::hard::run::{Place, Run, Solved};
use fe_contact::point::ContactStatus;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;

/// Width of the block [L]; it is 1 high and 1 deep.
const WIDTH: f64 = 4.0;
/// Pressure on its top [F/L²].
const PRESSURE: f64 = 10.0;
/// μ [-] and the largest force along the plane [F] that it allows.
const FRICTION: f64 = 0.3;
const LARGEST: f64 = FRICTION * PRESSURE * WIDTH;
/// Springs along the plane, in sum [F/L], alike at all nodes.
const SPRING: f64 = 100.0;
/// Relative bound of a discrete problem that has the closed answer.
const ALGEBRAIC: f64 = 1e-10;
/// Forces of points that just touch are known to the rounding of their gaps times the stiffness beneath multipliers, 4e-9 at
/// each of 27 nodes, over the force along the plane [-].
const TOUCHING: f64 = 27.0 * 4e-9 / (0.5 * LARGEST);
/// Relative bound of μ = 10⁶ against rough surfaces.
const LIKE_ROUGH: f64 = 1e-5;

/// All ways to stick.
const STICK: [&str; 3] = ["", ", ELASTIC SLIP=1e-4", ", LAGRANGE"];

/// Cycles of a scene, and increments of each.
const CYCLES: usize = 20;
const IN_CYCLE: usize = 8;

/// Scenes of D25.
pub fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for stick in [STICK[0], STICK[1], STICK[2], ", TAUMAX=3."] {
        let name = format!("touching, without pressure, dragged along{}", stick.to_lowercase());
        scenes.push(Scene::new(name, move |place| without_pressure(place, stick)));
    }
    scenes.push(Scene::new("coefficient 0 against no friction", without_friction));
    for stick in STICK {
        scenes.push(Scene::new(format!("coefficient 1e6 against rough{}", stick.to_lowercase()), move |place| {
            let of = |name: &str, friction: &str| {
                place.run(
                    name,
                    &model(&format!("*FRICTION{friction}"), Held::Along, &[press(PRESSURE), push(1.2 * LARGEST)]),
                )
            };
            let (run, rough) = (of("high", &format!("{stick}\n1e6\n")), of("rough", ", ROUGH\n"));
            Finding::converged(&run).and(Finding::converged(&rough)).within(difference(rough.u(), run.u()), LIKE_ROUGH)
        }));
    }
    for stick in STICK {
        for part in [0.5, 1.2, 50.0] {
            let name = format!("20 cycles of {part} of the largest force{}", stick.to_lowercase());
            scenes.push(Scene::new(name, move |place| cycles(place, stick, part)));
        }
        scenes.push(Scene::new(format!("reversed in one increment{}", stick.to_lowercase()), move |place| {
            let steps = [press(PRESSURE), push(1.2 * LARGEST), push(-1.2 * LARGEST)];
            let run = place.run("block", &model(&coulomb(stick), Held::Along, &steps));
            at_rest(&run, LARGEST, -0.2 * LARGEST / SPRING, ALGEBRAIC)
        }));
        let way = 0.5 * LARGEST / SPRING;
        scenes.push(Scene::new(format!("unloaded while it sticks{}", stick.to_lowercase()), move |place| {
            let run = place.run("block", &unloaded(stick, &[0.0]));
            at_rest(&run, 0.0, way, TOUCHING)
        }));
        scenes.push(Scene::new(format!("lifted while it sticks, laid down{}", stick.to_lowercase()), move |place| {
            let (off, again) =
                (place.run("off", &unloaded(stick, &[-1.0])), place.run("again", &unloaded(stick, &[-1.0, PRESSURE])));
            at_rest(&off, 0.0, way, ALGEBRAIC).and(at_rest(&again, 0.0, way, ALGEBRAIC))
        }));
    }
    for tolerance in ["1e-12", "10."] {
        scenes.push(Scene::new(format!("slip tolerance {tolerance}"), move |place| {
            let friction = coulomb(&format!(", SLIP TOLERANCE={tolerance}"));
            let run = place.run("block", &model(&friction, Held::Along, &[press(PRESSURE), push(1.2 * LARGEST)]));
            lawful(&run, |p| FRICTION * p)
        }));
    }
    scenes.push(Scene::new("coefficient by pressure", |place| {
        let friction = "*FRICTION\n0.5, 0., 0.\n0.1, 0., 20.\n";
        let run = place.run("block", &model(friction, Held::Along, &[press(PRESSURE), push(1.2 * LARGEST)]));
        lawful(&run, |p| (0.5 - 0.02 * p) * p)
    }));
    scenes
}

/// Where springs hold the block.
#[derive(Clone, Copy, PartialEq)]
enum Held {
    /// Along the plane.
    Along,
    /// Along and across it.
    Both,
}

fn coulomb(stick: &str) -> String {
    format!("*FRICTION{stick}\n{FRICTION}\n")
}

/// The block, 8 × 2 plane strain squares without Poisson's ratio: a pressure alone does not widen it.
fn model(friction: &str, held: Held, steps: &[String]) -> String {
    let mesh = Block::quad4([8, 2]).size([WIDTH, 1.0, 0.0]).mesh();
    let reference = mesh.points.len() + 1;
    let directions: &[usize] = match held {
        Held::Along => &[1],
        Held::Both => &[1, 2],
    };
    let spring = |&component: &usize| {
        let of_node = |label: &u64| format!("{}, {label}\n", 1000 * component as u64 + label);
        let elements: String = mesh.point_labels.iter().map(of_node).collect();
        let each = SPRING / mesh.points.len() as f64;
        format!(
            "*ELEMENT, TYPE=SPRING1, ELSET=S{component}\n{elements}*SPRING, ELSET=S{component}\n{component}\n{each:e}\n"
        )
    };
    format!(
        "{}{}{}*NODE\n{reference}, 0., -1.\n*SURFACE, NAME=FLOOR, TYPE=SEGMENTS\nSTART, -9., 0.\nLINE, 9., 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE={reference}\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, DIRECT\n{friction}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nYMIN, FLOOR\n\
         *AMPLITUDE, NAME=CYCLES\n{}*BOUNDARY\n{reference}, 1, 6\n{}",
        deck::cards(&mesh, &[("BLOCK", ElementType::CPE4)], Order::AsMade),
        deck::elastic(&["BLOCK"], 1000.0, 0.0),
        directions.iter().map(spring).collect::<String>(),
        amplitude(),
        steps.concat()
    )
}

/// Up to 1, down to −1, and so on; 0 at the end of each cycle.
fn amplitude() -> String {
    let turns = (0..2 * CYCLES + 1).map(|k| format!("{}., {}.\n", 2 * k + 1, if k % 2 == 0 { 1 } else { -1 }));
    std::iter::once("0., 0.\n".to_owned()).chain(turns).collect()
}

fn step(cards: &str) -> String {
    format!("*STEP\n*STATIC\n1., 1.\n*CONTROLS, PARAMETERS=FIELD\n{EXACT:e}\n{cards}*END STEP\n")
}

fn press(pressure: f64) -> String {
    step(&format!("*DSLOAD\nYMAX, P, {pressure:e}\n"))
}

/// A force along the plane, alike at all 27 nodes.
fn push(force: f64) -> String {
    step(&format!("*CLOAD\nBLOCK, 1, {:e}\n", force / 27.0))
}

/// Pressed, pushed by half of what friction can hold, then under other pressures.
fn unloaded(stick: &str, pressures: &[f64]) -> String {
    let mut steps = vec![press(PRESSURE), push(0.5 * LARGEST)];
    steps.extend(pressures.iter().map(|&pressure| press(pressure)));
    model(&coulomb(stick), Held::Both, &steps)
}

/// No shear and no heat.
fn without_pressure(place: &Place, stick: &str) -> Finding {
    let drag = step("*BOUNDARY\nBLOCK, 2\nYMAX, 1, 1, 0.1\n");
    let run = place.run("block", &model(&coulomb(stick), Held::Along, &[drag]));
    let heat = run.certificates.iter().map(|c| c.energy.friction).fold(0.0, f64::max);
    finite(&run).within(heat, 0.0).measured(&run, |solved| {
        let shears = solved.pairs[0].points.iter().map(|p| p.shear[0].hypot(p.shear[1]));
        vec![(shears.fold(0.0, f64::max), 0.0), (solved.pressures().into_iter().fold(0.0, f64::max), 0.0)]
    })
}

/// The same bits without the card; a table of zeros says the same, but for rounding.
fn without_friction(place: &Place) -> Finding {
    let of = |name: &str, friction: &str| {
        place.run(name, &model(friction, Held::Along, &[press(PRESSURE), push(0.5 * LARGEST)]))
    };
    let (free, zero) = (of("free", ""), of("zero", "*FRICTION\n0.\n"));
    let bits = |run: &Run| run.u().iter().map(|u| u.to_bits()).collect::<Vec<_>>();
    let mut found = finite(&free).and(finite(&zero)).holds(bits(&free) == bits(&zero), "other bits");
    for (name, stick) in ["tolerance", "slip", "exact"].into_iter().zip(STICK) {
        let table = of(name, &format!("*FRICTION{stick}\n0., 0.\n0., 1.\n"));
        found = found.and(finite(&table)).within(difference(free.u(), table.u()), ALGEBRAIC);
    }
    found
}

/// Loops close from the second cycle on, and friction takes work in every increment, as much in each cycle.
fn cycles(place: &Place, stick: &str, part: f64) -> Finding {
    let load = format!(
        "*STEP, INC={}\n*STATIC, DIRECT\n{}, {}.\n*CONTROLS, PARAMETERS=FIELD\n{EXACT:e}\n*CLOAD, AMPLITUDE=CYCLES\nBLOCK, 1, {:e}\n\
         *END STEP\n",
        CYCLES * IN_CYCLE,
        4.0 / IN_CYCLE as f64,
        4 * CYCLES,
        part * LARGEST / 27.0
    );
    let run = place.run("block", &model(&coulomb(stick), Held::Along, &[press(PRESSURE), load]));
    let found = finite(&run);
    let Some((first, loops)) = run.certificates.split_first() else { return found };
    let words = format!("{} increments", loops.len());
    if loops.len() != CYCLES * IN_CYCLE {
        return found.holds(false, words);
    }
    let heat: Vec<f64> = std::iter::once(first).chain(loops).map(|c| c.energy.friction).collect();
    let falls = heat.windows(2).any(|two| two[1] < two[0]);
    let cycle = |k: usize| &loops[k * IN_CYCLE..(k + 1) * IN_CYCLE];
    let numbers = |k: usize| cycle(k).iter().flat_map(|c| [c.resultants[0][0], c.energy.solids]).collect::<Vec<f64>>();
    let taken = |k: usize| heat[(k + 1) * IN_CYCLE] - heat[k * IN_CYCLE];
    let found = found.holds(!falls, "friction gives work back");
    let found = (2..CYCLES).fold(found, |found, k| {
        let heats = (taken(k) - taken(1)).abs() / (LARGEST * LARGEST / SPRING);
        found.within(difference(&numbers(1), &numbers(k)), ALGEBRAIC).within(heats, ALGEBRAIC)
    });
    let largest = loops.iter().fold(0.0f64, |m, c| m.max(c.resultants[0][0].abs()));
    // Where it slides, all points slip the same way.
    if part > 1.0 { found.within((largest / LARGEST - 1.0).abs(), ALGEBRAIC) } else { found }
}

/// Friction holds the block by `force` [F] where it has gone `way` [L] in the mean, where springs take the rest.
fn at_rest(run: &Run, force: f64, way: f64, bound: f64) -> Finding {
    finite(run).measured(run, |solved| {
        let found = solved.pairs[0].secondary_shear.as_ref().map_or(f64::NAN, |shear| shear.force[0]);
        let ways: Vec<f64> = solved.displacements().iter().take(27).map(|u| u[0]).collect();
        let mean = ways.iter().sum::<f64>() / ways.len() as f64;
        vec![((found - force).abs() / LARGEST, bound), (from_value(way, &[mean]), bound)]
    })
}

/// No shear above what the law allows at its pressure, and as much where it slips.
fn lawful(run: &Run, allowed: impl Fn(f64) -> f64) -> Finding {
    finite(run).measured(run, |solved: &Solved| {
        let off = solved.pairs[0].points.iter().map(|point| {
            let (shear, most) = (point.shear[0].abs(), allowed(point.pressure));
            if point.status == ContactStatus::Slipping { (shear - most).abs() } else { (shear - most).max(0.0) }
        });
        vec![(off.fold(0.0, f64::max) / PRESSURE, ALGEBRAIC)]
    })
}

/// A run that comes to its end; all its numbers are finite.
fn finite(run: &Run) -> Finding {
    let rows = run.certificates.iter().all(|c| c.row().iter().all(|v| v.is_finite()));
    let finite = rows && run.u().iter().all(|u| u.is_finite());
    Finding::converged(run).holds(finite, "a number is not finite")
}
