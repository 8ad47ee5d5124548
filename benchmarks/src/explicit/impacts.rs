//! Kinematic contact and penalties side by side on impacts with closed solutions: a bar on a wall, two bars whose meshes do not
//! match, a ball on a flat.

use super::bodies::{hard, outer_faces, solids};
use crate::machine::Origin;
use fe_contact::explicit::{ContactPair, Definition, Enforcement, MainSurface, PairSides, Secondary};
use fe_contact::rigid::{Piece, RigidSurface, Sweep};
use fe_contact::summary::MeasureKind;
use fe_contact::viscous::ExplicitDamping;
use fe_core::Freedoms;
use fe_core::element::ElementType::C3D8R;
use fe_core::explicit::central_difference::{CentralDifference, State, Support};
use fe_core::explicit::solid::Solids;
use fe_core::explicit::{ExplicitTerm, Halt};
use fe_core::load::Prescribed;
use fe_core::material::{Elastic, Response};
use fe_core::ramp::Ramp;
use fe_core::structure::Structure;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::error::Error;
use std::f64::consts::PI;
use std::io::Write;
use std::time::Instant;

/// What came of an impact.
#[derive(Clone, Copy, Debug, Default)]
pub struct Impact {
    /// Largest overclosure [L].
    pub overclosure: f64,
    /// Part of the energy that the bodies have lost [-].
    pub lost: f64,
    /// What the impulse on what hits is more than that of the closed solution [-].
    pub impulse: f64,
    /// Largest contact force [F].
    pub force: f64,
    /// From the first touch to the last [T].
    pub time: f64,
    /// Largest way [L] of the centre of mass of what hits towards the other side.
    pub approach: f64,
    /// Mean increment over the one without contact [-].
    pub increment: f64,
    /// How many increments there were.
    pub increments: usize,
    /// Seconds of all.
    pub seconds: f64,
}

/// Which surface is secondary to the other one, and how contact is enforced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Kinematic, the first surface secondary.
    Kinematic,
    /// Kinematic, both.
    Balanced,
    /// Penalty; both, where they are deformable.
    Penalty,
}

/// Bodies about to hit each other.
pub struct Scene {
    structure: Structure,
    material: Response,
    density: f64,
    /// The nodes of what hits come first.
    first: usize,
    /// Prescribed components.
    held: Vec<(u32, usize)>,
    /// Velocity [L/T] of what hits, along −z.
    speed: f64,
    /// Secondary nodes of both surfaces, and the surfaces as main ones.
    sides: [(Vec<u32>, Option<MainSurface>); 2],
    /// Closed solution of the impulse [F T].
    impulse: f64,
    /// How long it is followed [T].
    period: f64,
}

/// Elements along a bar.
const BAR: usize = 50;

/// Speed of a bar over that of sound, 1: small, so that it is linear.
const SPEED: f64 = 1e-3;

fn floor(reference: u32) -> MainSurface {
    let surface = RigidSurface {
        name: "FLAT".into(),
        sweep: Sweep::Cylinder { origin: [0.0; 3], x: [1.0, 0.0, 0.0], y: [0.0, 0.0, 1.0] },
        start: [-100.0, 0.0],
        pieces: vec![Piece::Line { to: [100.0, 0.0] }],
    };
    MainSurface::Rigid { surface, reference }
}

/// A body above a rigid flat at z = 0, with a reference node after its own.
fn on_flat(mut mesh: Mesh, secondary: Vec<u32>, mut held: Vec<(u32, usize)>) -> Scene {
    let first = mesh.points.len();
    mesh.points.push([0.0, 0.0, -1.0]);
    mesh.point_labels.push(first as u64 + 1);
    held.extend((0..6).map(|c| (first as u32, c)));
    Scene {
        structure: Structure { mesh, elements: vec![C3D8R], ..Structure::default() },
        material: Response::Elastic(Elastic { young: 1.0, poisson: 0.0 }),
        density: 1.0,
        first,
        held,
        speed: SPEED,
        sides: [(secondary, None), (Vec::new(), Some(floor(first as u32)))],
        impulse: 0.0,
        period: 0.0,
    }
}

/// B01: a bar of cubes with E = ρ = 1, ν = 0 on a wall.
pub fn bar_on_wall() -> Scene {
    let mesh = Block::hex8([1, 1, BAR]).size([1.0, 1.0, BAR as f64]).mesh();
    let foot = at_height(&mesh, 0..mesh.points.len());
    let length = BAR as f64;
    Scene { impulse: 2.0 * length * SPEED, period: 2.6 * length, ..on_flat(mesh, foot, Vec::new()) }
}

/// B02: a bar of 2 × 2 elements in its section onto one of 3 × 3.
pub fn two_bars() -> Scene {
    let length = BAR as f64;
    let mut mesh = Block::hex8([2, 2, BAR]).size([2.0, 2.0, length]).mesh();
    let first = mesh.points.len();
    let size = [2.0, 2.0, length];
    mesh.append(&Block::hex8([3, 3, 3 * BAR / 2]).size(size).origin([0.0, 0.0, -length]).mesh());
    let nodes = [at_height(&mesh, 0..first), at_height(&mesh, first..mesh.points.len())];
    let structure = Structure { mesh, elements: vec![C3D8R], ..Structure::default() };
    let faces = outer_faces(&structure);
    let sides = nodes.map(|nodes| {
        let own = faces.iter().filter(|face| face.iter().all(|node| nodes.contains(node))).cloned();
        let main = MainSurface::Faces(own.collect());
        (nodes, Some(main))
    });
    Scene {
        structure,
        material: Response::Elastic(Elastic { young: 1.0, poisson: 0.0 }),
        density: 1.0,
        first,
        held: Vec::new(),
        speed: SPEED,
        sides,
        impulse: 4.0 * length * SPEED,
        period: 2.6 * length,
    }
}

/// Radius [L] of the ball of B05, of steel (N, mm, t).
pub const RADIUS: f64 = 10.0;

/// B05: a quarter of a ball on a flat. A cube whose shells become spheres; edges of 0.07 beneath the pole, six along the largest
/// contact radius, and on from there each a fifth longer than the last.
pub fn ball_on_flat() -> Scene {
    let along = graded(1.0);
    let up = graded(2.0);
    let counts = [along.len() - 1, along.len() - 1, up.len() - 1];
    let mut mesh = Block::hex8(counts).size(counts.map(|n| n as f64)).mesh();
    let mut held = Vec::new();
    let mut pole = Vec::new();
    for (node, point) in (0u32..).zip(&mut mesh.points) {
        let [i, j, k] = point.map(|x| x.round() as usize);
        let cube = [along[i], along[j], up[k] - 1.0];
        let largest = cube.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let size = cube.iter().map(|x| x * x).sum::<f64>().sqrt();
        let factor = if size > 0.0 { RADIUS * largest / size } else { 0.0 };
        *point = cube.map(|x| factor * x);
        point[2] += RADIUS;
        held.extend([(i, 0), (j, 1)].iter().filter(|(at, _)| *at == 0).map(|&(_, c)| (node, c)));
        if k == 0 && point[0].hypot(point[1]) < 0.1 * RADIUS {
            pole.push(node);
        }
    }
    let (density, speed) = (7.85e-9, 1000.0);
    let impulse = 0.25 * 4.0 / 3.0 * PI * RADIUS.powi(3) * density * 2.0 * speed;
    let material = Response::Elastic(Elastic { young: 210e3, poisson: 0.3 });
    Scene { material, density, speed, impulse, period: 6.0e-5, ..on_flat(mesh, pole, held) }
}

/// Places from 0 to a length: seven steps of 0.007, then each a fifth longer, the last ones fitted.
fn graded(length: f64) -> Vec<f64> {
    let (mut places, mut step) = (vec![0.0], 0.007);
    while places[places.len() - 1] < length {
        if places.len() > 7 {
            step *= 1.2;
        }
        places.push(places[places.len() - 1] + step);
    }
    let (even, last) = (places[7], places[places.len() - 1]);
    places.iter().map(|&x| if x <= even { x } else { even + (x - even) * (length - even) / (last - even) }).collect()
}

fn at_height(mesh: &Mesh, range: std::ops::Range<usize>) -> Vec<u32> {
    range.filter(|&node| mesh.points[node][2].abs() < 1e-9).map(|node| node as u32).collect()
}

impl Scene {
    fn pairs(&self, freedoms: &Freedoms, way: Way) -> PairSides {
        let both = self.sides.iter().all(|side| side.1.is_some() && !side.0.is_empty());
        let parts = if both && way != Way::Kinematic { vec![0.5, 0.5] } else { vec![1.0] };
        let pair = |(side, part): (usize, f64)| {
            let main = self.sides[1 - side].1.clone().expect("the other side is a surface");
            let behaviour = hard((way == Way::Penalty).then(ExplicitDamping::default));
            let nodes = self.sides[side].0.iter().map(|&node| (node, part)).collect();
            let enforcement =
                if way == Way::Penalty { Enforcement::Penalty(part) } else { Enforcement::Kinematic(part) };
            let secondary = Secondary { nodes, kind: MeasureKind::Force };
            let definition = Definition { name: "pair".into(), secondary, main, behaviour, enforcement };
            ContactPair::new(&self.structure, freedoms, definition, &[])
        };
        PairSides { pairs: parts.into_iter().enumerate().map(pair).collect() }
    }

    /// Follows the impact.
    pub fn run(&self, way: Way) -> Result<Impact, Halt> {
        let mut references: Vec<u32> = self.held.iter().filter(|h| h.1 == 5).map(|h| h.0).collect();
        references.dedup();
        let freedoms = self.structure.freedoms(&references);
        let mut solids = solids(&self.structure, &freedoms, (&self.material, self.density), [0.0; 2]);
        let mut pairs = self.pairs(&freedoms, way);
        let mut state = State::rest(&freedoms);
        let down: Vec<usize> = (0..self.first).filter_map(|node| freedoms.index(node, 2)).collect();
        down.iter().for_each(|&f| state.v[f] = -self.speed);
        let mut mass = vec![0.0; state.u.len()];
        solids.add_mass(&mut mass);
        let mean = |of: &[f64]| down.iter().map(|&f| mass[f] * of[f]).sum::<f64>();
        let whole: f64 = down.iter().map(|&f| mass[f]).sum();
        let hold = |freedom| Support { freedom, kind: Prescribed::Displacement, course: Ramp::constant(0.0) };
        let supports = || self.held.iter().filter_map(|&(n, c)| freedoms.index(n as usize, c)).map(hold).collect();
        let free = CentralDifference::new(&mut [&mut solids], supports(), (1e9, f64::INFINITY), &mut state)?;
        let free = free.stable().increment();
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut solids, &mut pairs];
        let mut procedure = CentralDifference::new(terms, supports(), (1e9, f64::INFINITY), &mut state)?;
        let energy = |procedure: &CentralDifference, state: &State, solids: &Solids| {
            let taken = solids.energies();
            procedure.conserved(state) + taken.internal + taken.hourglass
        };
        let (momentum, before) = (mean(&state.v), energy(&procedure, &state, &solids));
        let mut impact = Impact::default();
        let start = Instant::now();
        let mut touch: Option<f64> = None;
        while state.step_time < self.period {
            let dt = 0.9 * procedure.stable().increment();
            procedure.advance(&mut [&mut solids, &mut pairs], &mut state, dt)?;
            impact.increments += 1;
            impact.approach = impact.approach.max(-mean(&state.u) / whole);
            let states: Vec<_> = pairs.pairs.iter().map(|pair| pair.state()).collect();
            let force: f64 = states.iter().zip([1.0, -1.0]).map(|(s, sign)| sign * s.secondary.force[2]).sum();
            impact.force = impact.force.max(force);
            let deepest = states.iter().filter_map(|s| s.largest_overclosure).map(|o| o.1).fold(0.0, f64::max);
            impact.overclosure = impact.overclosure.max(deepest);
            if force > 0.0 {
                let first = *touch.get_or_insert(state.step_time - dt);
                impact.time = state.step_time - first;
            }
        }
        impact.seconds = start.elapsed().as_secs_f64();
        impact.increment = state.step_time / impact.increments as f64 / (0.9 * free);
        impact.lost = 1.0 - energy(&procedure, &state, &solids) / before;
        impact.impulse = (mean(&state.v) - momentum) / self.impulse - 1.0;
        Ok(impact)
    }
}

/// Prints all impacts.
pub fn study(threads: usize, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    writeln!(out, "impacts, C3D8R, no bulk viscosity, increments of 0.9 of the stable one; hard contact")?;
    writeln!(out, "{}; {threads} thread(s)\n", Origin::here())?;
    writeln!(
        out,
        "{:24} {:12} {:>12} {:>10} {:>10} {:>10} {:>10} {:>9}",
        "impact", "contact", "overclosure", "lost", "impulse", "increment", "increments", "seconds"
    )?;
    let scenes: [(&str, Scene, &[Way]); 3] = [
        ("bar on a wall", bar_on_wall(), &[Way::Kinematic, Way::Penalty]),
        ("two bars, 2 × 2 on 3 × 3", two_bars(), &[Way::Kinematic, Way::Balanced, Way::Penalty]),
        ("ball on a flat, a quarter", ball_on_flat(), &[Way::Kinematic, Way::Penalty]),
    ];
    for (name, scene, ways) in scenes {
        for &way in ways {
            let i = pool.install(|| scene.run(way))?;
            writeln!(
                out,
                "{name:24} {:12} {:>12.3e} {:>8.3} % {:>8.3} % {:>10.4} {:>10} {:>9.2}",
                format!("{way:?}").to_lowercase(),
                i.overclosure,
                100.0 * i.lost,
                100.0 * i.impulse,
                i.increment,
                i.increments,
                i.seconds
            )?;
        }
    }
    Ok(())
}
