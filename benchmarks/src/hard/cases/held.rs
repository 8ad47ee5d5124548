//! D03: bodies that contact alone holds: a block on a plane, and half a ball in a bowl.

use crate::hard::Scene;
use crate::hard::ball::{self, RADIUS};
use crate::hard::deck::{self, Order};
use crate::hard::finding::{Finding, from_value};
use crate::hard::patch::{self, EXACT};
use crate::hard::run::{Place, Run, Solved};
use fe_contact::point::ContactStatus;
use fe_core::element::ElementType;
use fe_mesh::generate::Block;
use std::f64::consts::{FRAC_PI_4, PI};

/// Weight of the block, and of the half ball [F].
const WEIGHT: f64 = 2.0;
/// Relative error of reactions, and the drift [L], that the case allows.
const REACTION: f64 = 1e-8;
const DRIFT: f64 = 1e-6;
/// What stabilisation may take, of the energy of the solids [-].
const TAKEN: f64 = 1e-4;
/// How stabilisation is asked for.
const STABILIZE: &str = "*CONTACT CONTROLS, STABILIZE\n";

/// Scenes of D03.
pub fn scenes() -> Vec<Scene> {
    let all = ("all contacts", STABILIZE);
    let one = ("one pair", "*CONTACT CONTROLS, STABILIZE, MASTER=FLOOR, SLAVE=ZMIN\n1., 0.1, 0.5\n");
    let stabilised = [all, one].map(|(name, controls)| {
        Scene::new(format!("block on a plane, stabilised, {name}"), move |place| stabilised(place, controls))
    });
    let pushed = Scene::new("block with a side load, stabilised", |place| {
        let run = place.run("block", &block(0.01, "", STABILIZE));
        Finding::refused(&run, &["body BLOCK is free along x", "its load drives it along (1.000, 0.000, 0.000)"])
    });
    let across = "*CONTACT CONTROLS, STABILIZE, TANGENT FRACTION=0.\n";
    let unheld =
        [("", "nothing holds along it", 0.0), (across, "stabilised across alone", 0.0), ("", "side load", 0.01)];
    let unheld = unheld.map(|(controls, name, side)| {
        Scene::new(format!("block on a plane, {name}"), move |place| {
            let run = place.run("block", &block(side, "", controls));
            Finding::refused(&run, &["body BLOCK is free along x", "the surfaces of its pairs cannot hold it that way"])
        })
    });
    let sticks = [
        ("*FRICTION, LAGRANGE\n0.3\n", 1e-12),
        ("*FRICTION\n0.3\n", 0.005),
        ("*FRICTION, ROUGH\n*SURFACE BEHAVIOR, DIRECT\n", 1e-12),
    ];
    let sticks = sticks.map(|(friction, slip)| {
        let name = friction.split('\n').next().unwrap_or_default().to_lowercase();
        Scene::new(format!("block held by {name}"), move |place| held_by_friction(place, friction, slip))
    });
    let mut scenes: Vec<Scene> = stabilised.into_iter().chain([pushed]).chain(unheld).chain(sticks).collect();
    scenes.push(Scene::new("half ball in a bowl, kept level, begun beside its axis", centred));
    // In a smooth bowl every pressure points to the bowl's centre: about it nothing holds the ball.
    for (side, controls, words) in [
        (0.0, "", "the surfaces of its pairs cannot hold it that way"),
        (0.05, "", "the surfaces of its pairs cannot hold it that way"),
        (0.05, STABILIZE, "its load drives it along (-"),
    ] {
        let name = if controls.is_empty() { "" } else { ", stabilised" };
        scenes.push(Scene::new(format!("half ball in a bowl, {side} beside its axis{name}"), move |place| {
            let bowl = Bowl { side, ..BOWL };
            let run = place.run("ball", &in_bowl(&bowl, "", &format!("{}{controls}", ball_weight())));
            Finding::refused(&run, &["body BALL is free", "about x", words])
        }));
    }
    for (name, friction) in [("smooth", ""), ("rough", "*FRICTION, ROUGH\n")] {
        scenes.push(Scene::new(format!("half ball on the axis of a {name} bowl, stabilised"), move |place| {
            let run = place.run("ball", &in_bowl(&BOWL, friction, &format!("{}{STABILIZE}", ball_weight())));
            let found = planned(Finding::converged(&run), &run, "body BALL", "about x");
            found.measured(&run, |solved| vec![(mean_side(solved).abs(), DRIFT)])
        }));
    }
    scenes
}

/// A unit cube, E = 1000, 1e-3 above a rigid plane, with its weight 2 and a side load at each node. Without Poisson's ratio a
/// foot does not widen, and does not slip where friction holds it.
fn block(side: f64, friction: &str, controls: &str) -> String {
    let poisson = if friction.is_empty() { 0.3 } else { 0.0 };
    format!(
        "{}{}*NODE\n99, 0., 0., -5.\n*SURFACE, NAME=FLOOR, TYPE=CYLINDER\n0., 0., -0.001, 1., 0., -0.001\n\
         0., 1., -0.001\nSTART, -1., 0.\nLINE, 2., 0.\n*RIGID BODY, ANALYTICAL SURFACE=FLOOR, REF NODE=99\n\
         *SURFACE INTERACTION, NAME=I\n{friction}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nZMIN, FLOOR\n\
         *BOUNDARY\n99, 1, 6\n*STEP\n*STATIC, DIRECT\n0.25, 1.\n{}*CLOAD\nBLOCK, 1, {side}\n{controls}*END STEP\n",
        deck::cards(&Block::hex8([1, 1, 1]).mesh(), &[("BLOCK", ElementType::C3D8)], Order::AsMade),
        heavy("BLOCK", 1000.0, poisson),
        gravity("BLOCK", 1.0)
    )
}

/// An elastic material of density 1.
fn heavy(set: &str, young: f64, poisson: f64) -> String {
    deck::elastic(&[set], young, poisson).replace("*ELASTIC", "*DENSITY\n1.\n*ELASTIC")
}

/// The weight of a body of density 1 and this volume [L³].
fn gravity(set: &str, volume: f64) -> String {
    format!("*DLOAD\n{set}, GRAV, {:e}, 0., 0., -1.\n", WEIGHT / volume)
}

/// The reaction is the weight, nothing drifts, and stabilisation takes next to nothing.
fn stabilised(place: &Place, controls: &str) -> Finding {
    let run = place.run("block", &block(0.0, "", controls));
    let found = planned(Finding::converged(&run), &run, "body BLOCK", "along x");
    let found = found.holds(run.plans.iter().any(|plan| plan.contains("stabilised")), "the plan does not say so");
    let Some(last) = run.certificates.last() else { return found };
    let taken = last.taken.stabilization;
    found
        .holds(taken > 0.0, "the energy that it takes is not told")
        .within(taken / last.energy.solids, TAKEN)
        .within((last.reaction[2] / WEIGHT - 1.0).abs(), REACTION)
        .measured(&run, |solved| {
            // The cube grows about its middle.
            let nodes = solved.displacements();
            let mean = |c: usize| nodes.iter().take(8).map(|u| u[c]).sum::<f64>() / 8.0;
            vec![(mean(0).abs(), DRIFT), (mean(1).abs(), DRIFT)]
        })
}

/// The side load of 8 × 0.02, below 0.3 times its weight at every corner, is friction's; what is not held exactly gives way by
/// no more than its elastic slip.
fn held_by_friction(place: &Place, friction: &str, most: f64) -> Finding {
    const SIDE: f64 = 8.0 * 0.02;
    let run = place.run("block", &block(SIDE / 8.0, friction, ""));
    let found = at_rest(&run, "body BLOCK");
    let Some(last) = run.certificates.last() else { return found };
    found.within((last.reaction[0] / SIDE + 1.0).abs(), REACTION).measured(&run, |solved| {
        let points = &solved.pairs[0].points;
        let slips = points.iter().filter(|p| p.status != ContactStatus::Closed).count();
        let slip = points.iter().map(|p| p.slip[0].hypot(p.slip[1])).fold(0.0, f64::max);
        let force = solved.pairs[0].secondary_shear.as_ref().map_or(f64::NAN, |shear| shear.force[0]);
        vec![(slips as f64, 0.0), (slip, most), (from_value(-SIDE, &[force]), REACTION)]
    })
}

/// A body that is named as held by contact alone, along z and otherwise, and whose weight the contact takes.
fn at_rest(run: &Run, body: &str) -> Finding {
    let found = planned(Finding::converged(run), run, body, "along z");
    let found = found.holds(run.told(&[body, "held by contact alone"]), "no remark says what holds it");
    let reaction = run.certificates.last().map_or(f64::NAN, |last| last.reaction[2]);
    found.within((reaction / WEIGHT - 1.0).abs(), REACTION)
}

/// The plan names the body and a motion that is free.
fn planned(found: Finding, run: &Run, body: &str, motion: &str) -> Finding {
    let said = |plan: &String| plan.lines().any(|line| line.contains(body) && line.contains(motion));
    found.holds(run.plans.iter().any(said), format!("the plan does not say that {body} is free {motion}"))
}

/// A rigid bowl: a part of a sphere about the origin's axis.
#[derive(Clone, Copy)]
struct Bowl {
    /// Radius [L].
    radius: f64,
    /// The ball's centre lies so far beside the bowl's axis [L], along x.
    side: f64,
    /// From the ball's pole to the bowl's depth [L], negative inside.
    clearance: f64,
}

impl Bowl {
    /// How far the ball's centre lies below that of the bowl [L].
    fn depth(&self) -> f64 {
        self.radius - RADIUS - self.clearance
    }
}

/// The half ball in a bowl, with cards of the interaction, and a step's supports and loads.
fn in_bowl(bowl: &Bowl, friction: &str, loads: &str) -> String {
    let mut mesh = ball::mesh();
    ball::lower_skin(&mut mesh, -0.7 * RADIUS);
    let middle = (0..mesh.points.len() as u32).filter(|&n| mesh.points[n as usize][1].abs() < 1e-9).collect();
    mesh.node_sets.insert("MIDDLE".into(), middle);
    let (reference, radius) = (mesh.points.len() + 1, bowl.radius);
    let (x, z) = (-bowl.side, bowl.depth());
    let (across, down) = (0.8 * radius, -0.6 * radius);
    format!(
        "{}{}*NODE\n{reference}, {x:e}, 0., {z:e}\n*SURFACE, NAME=BOWL, TYPE=REVOLUTION\n{x:e}, 0., {z:e}, {x:e}, 0., {:e}\n\
         START, 0., {:e}\nCIRCL, {across:e}, {down:e}, 0., 0.\n\
         *RIGID BODY, ANALYTICAL SURFACE=BOWL, REF NODE={reference}\n*SURFACE INTERACTION, NAME=I\n\
         *SURFACE BEHAVIOR, DIRECT\n{friction}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nSKIN, BOWL\n\
         *BOUNDARY\n{reference}, 1, 6\n{}",
        deck::cards(&mesh, &[("BALL", ElementType::C3D8)], Order::AsMade),
        heavy("BALL", ball::YOUNG, 0.3),
        z + 1.0,
        -radius,
        patch::step(EXACT, loads)
    )
}

/// A bowl in which the ball weighs so much that five nodes touch; its depth is 0.001 below the pole.
const BOWL: Bowl = Bowl { radius: 12.0, side: 0.0, clearance: 1e-3 };

fn ball_weight() -> String {
    gravity("BALL", 2.0 / 3.0 * PI * RADIUS.powi(3) / 1e4)
}

/// Kept level and pressed down, the half ball (radius R) is free along x, and comes to the middle. With normals that stay as they
/// are, a ball whose centre begins at (a, −h) from the bowl's centre keeps off its surface, at the angle θ from the depth, where
/// s·e(θ) ≤ E + (a cos θ − h sin θ)²/2R, with s where its centre comes to and E the difference of radii. Its lowest place is at
/// s = −a h/R: it goes by −a (1 + h/R). Nodes a facet l apart leave it E l/2R to either side.
fn centred(place: &Place) -> Finding {
    let bowl = Bowl { radius: 10.5, side: 0.05, clearance: -0.02 };
    let run = place.run("ball", &in_bowl(&bowl, "", "*BOUNDARY\nEQUATOR, 3, 3, -0.02\nMIDDLE, 2\n"));
    let found = planned(Finding::converged(&run), &run, "body BALL", "along x");
    let way = -bowl.side * (1.0 + bowl.depth() / RADIUS);
    // Of the ball's mesh at the pole.
    let facet = RADIUS * (0.2f64.powf(1.5) * FRAC_PI_4).tan();
    let bound = facet * (bowl.radius - RADIUS) / (2.0 * RADIUS);
    found.measured(&run, |solved| vec![((mean_side(solved) - way).abs(), bound)])
}

/// Mean displacement of the equator along x [L].
fn mean_side(solved: &Solved) -> f64 {
    let nodes = solved.terms.structure.mesh.node_sets.get("EQUATOR").map_or(&[][..], Vec::as_slice);
    let u: Vec<f64> =
        nodes.iter().filter_map(|&n| solved.terms.freedoms.index(n as usize, 0)).map(|f| solved.u[f]).collect();
    u.iter().sum::<f64>() / u.len() as f64
}
