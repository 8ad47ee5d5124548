//! Kinematic contact of two deformable sides, each secondary for its part.

use super::*;

/// Two sheets of nodes with masses, first and second, and the pair that they are: each node of one on the faces of the other one.
struct Sheets {
    points: Vec<([f64; 3], f64)>,
    faces: [Vec<Vec<u32>>; 2],
}

impl Sheets {
    /// Rectangles of n × n faces on the unit square, one over the other one by a gap: of so many faces an edge, with so much mass.
    fn new(edges: [u32; 2], gap: f64, masses: [f64; 2]) -> Self {
        let mut sheets = Sheets { points: Vec::new(), faces: [Vec::new(), Vec::new()] };
        for side in 0..2 {
            let (n, first) = (edges[side], sheets.points.len() as u32);
            let inner = |i: u32| if i == 0 || i == n { 0.5 } else { 1.0 };
            for (i, j) in (0..=n).flat_map(|i| (0..=n).map(move |j| (i, j))) {
                let place =
                    [f64::from(i) / f64::from(n), f64::from(j) / f64::from(n), if side == 0 { gap } else { 0.0 }];
                sheets.points.push((place, masses[side] * inner(i) * inner(j) / f64::from(n * n)));
            }
            let at = |i: u32, j: u32| first + i * (n + 1) + j;
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut face = vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                if side == 0 {
                    // It faces down.
                    face.reverse();
                }
                sheets.faces[side].push(face);
            }
        }
        sheets
    }

    fn nodes(&self, side: usize) -> Vec<u32> {
        let mut nodes: Vec<u32> = self.faces[side].iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// With a weight of the first side as the main one.
    fn scene(&self, weight: f64, behaviour: &Behaviour, v: impl Fn(usize, &[f64; 3]) -> [f64; 3]) -> Moved {
        let structure = masses(&self.points);
        let freedoms = structure.freedoms(&[]);
        let mut state = State::rest(&freedoms);
        for side in 0..2 {
            for node in self.nodes(side) {
                let velocity = v(side, &self.points[node as usize].0);
                (0..3).for_each(|c| state.v[freedoms.index(node as usize, c).unwrap()] = velocity[c]);
            }
        }
        let side = |secondary: usize, part: f64| {
            let area = part / self.nodes(secondary).len() as f64;
            let definition = Definition {
                name: format!("{secondary} on {}", 1 - secondary),
                secondary: Secondary {
                    nodes: self.nodes(secondary).iter().map(|&n| (n, area)).collect(),
                    kind: MeasureKind::Pressure,
                },
                main: MainSurface::Faces(self.faces[1 - secondary].clone()),
                behaviour: behaviour.clone(),
                enforcement: Enforcement::Kinematic(part),
            };
            ContactPair::new(&structure, &freedoms, definition, &[])
        };
        let mut sides = PairSides { pairs: vec![side(0, 1.0 - weight), side(1, weight)] };
        let mut lines = Lines::new(&structure, &freedoms, 0.0);
        let terms: &mut [&mut dyn ExplicitTerm] = &mut [&mut lines, &mut sides];
        let procedure = CentralDifference::new(terms, Vec::new(), (1e9, f64::INFINITY), &mut state).unwrap();
        Moved { points: self.points.clone(), freedoms, lines, sides, state, procedure }
    }
}

/// Sheets in motion.
struct Moved {
    points: Vec<([f64; 3], f64)>,
    freedoms: Freedoms,
    lines: Lines,
    sides: PairSides,
    state: State,
    procedure: CentralDifference,
}

impl Moved {
    fn advance(&mut self, dt: f64) {
        self.procedure.advance(&mut [&mut self.lines, &mut self.sides], &mut self.state, dt).unwrap();
    }

    fn of(&self, v: &[f64], node: u32) -> Vec3 {
        Vec3::from_fn(|c, _| v[self.freedoms.index(node as usize, c).unwrap()])
    }

    fn momentum(&self) -> Vec3 {
        self.points.iter().enumerate().map(|(n, (_, m))| self.of(&self.state.v, n as u32) * *m).sum()
    }

    fn energy(&self) -> f64 {
        self.procedure.conserved(&self.state)
    }

    /// The deepest overclosure [L].
    fn deepest(&self) -> f64 {
        let gaps = self.sides.pairs.iter().flat_map(|side| side.state().points).map(|point| point.opening);
        -gaps.fold(0.0, f64::min)
    }
}

/// B12 balanced: masses 2 at 10 and 3 at −5 go on with 1, 135 are lost, whatever the weight, where the nodes lie on each other;
/// pressures are those of one side.
#[test]
fn b12_plastic_impact_of_like_meshes() {
    let sheets = Sheets::new([2, 2], 0.02, [2.0, 3.0]);
    for weight in [0.5, 0.25] {
        let mut scene = sheets.scene(weight, &free(Normal::Hard), |side, _| [0.0, 0.0, [-10.0, 5.0][side]]);
        let (before, dt) = (scene.energy(), 1e-3);
        let mut impulse = [0.0; 2];
        for _ in 0..50 {
            scene.advance(dt);
            for (side, impulse) in impulse.iter_mut().enumerate() {
                let states = scene.sides.pairs[side].state().points.into_iter();
                *impulse += states.map(|p| p.pressure * p.measure.value() * dt).sum::<f64>();
            }
        }
        for node in 0..18 {
            // Nodes meet in one increment, and what is left is moved by the next one.
            assert!((scene.of(&scene.state.v, node) - Vec3::new(0.0, 0.0, -1.0)).norm() < 1e-10);
        }
        assert!((before - scene.energy() - 135.0).abs() < 1e-9 && (scene.sides.stored() - 135.0).abs() < 1e-9);
        assert!((impulse[0] + impulse[1] - 18.0).abs() < 1e-9, "{impulse:?}");
        assert!((impulse[1] - weight * 18.0).abs() < 1e-9, "{impulse:?}");
    }
}

/// Sheets that do not match, with friction, hit each other askew: momentum and balance stay, no energy comes from nowhere, and
/// little is left of the overclosure.
#[test]
fn balanced_contact_keeps_momentum() {
    let sheets = Sheets::new([3, 4], 1e-3, [2.0, 3.0]);
    let law: Arc<dyn NormalLaw> = Arc::new(Linear { slope: 1e5, clearance: 0.0 });
    let limit = Some((Coefficient::Constant(0.3), None));
    for normal in [Normal::Hard, Normal::Softened(law)] {
        let friction = Some(Coulomb { limit: limit.clone(), spring: Spring::Stiffness(1.0) });
        let is_hard = matches!(normal, Normal::Hard);
        let behaviour = Behaviour { friction, ..free(normal) };
        let velocity =
            |side: usize, x: &[f64; 3]| [[2.0, 0.0, -10.0 - 3.0 * x[0]], [0.0, 1.0, 5.0 + x[1] * x[0]]][side];
        let mut scene = sheets.scene(0.5, &behaviour, velocity);
        let (momentum, before) = (scene.momentum(), scene.energy());
        let (mut closed, mut most) = (0, 0.0f64);
        for _ in 0..200 {
            scene.advance(1e-5);
            assert!((scene.momentum() - momentum).norm() < 1e-13 * momentum.norm());
            assert!(((scene.energy() + scene.sides.stored()) / before - 1.0).abs() < 1e-12);
            most = most.max(scene.energy() / before);
            let states = scene.sides.pairs.iter().flat_map(|side| side.state().points);
            closed += states.filter(|point| point.status != ContactStatus::Open).count();
            if is_hard {
                // Each pass leaves a half of an overclosure where the other side alone has answered; it comes on with its
                // velocity, beside what an increment brings at 19 at most: ε ≤ (19 Δt + 2 ε)/4.
                assert!(scene.deepest() < 0.5 * 19.0 * 1e-5, "{}", scene.deepest());
            }
        }
        assert!(closed > 20 && most < 1.0 + 1e-12, "{closed} {most}");
        assert!(scene.sides.pairs.iter().map(|side| side.rubbed()).sum::<f64>() > 0.0);
    }
}
