//! Central differences against what the scheme does exactly.

use super::*;
use crate::element::ElementType::{self, MASS, SPRING1, T2D2};
use crate::explicit::line::Lines;
use crate::freedoms::Freedoms;
use crate::section::{Discrete, LineSection, Profile};
use crate::structure::Structure;
use fe_mesh::{CellBlock, CellId};

/// Points on the x axis with blocks of cells.
fn structure(points: Vec<[f64; 3]>, blocks: Vec<(ElementType, Vec<u32>)>) -> Structure {
    let mut structure = Structure::default();
    structure.mesh.point_labels = (1..=points.len() as u64).collect();
    structure.mesh.points = points;
    for (element, nodes) in blocks {
        let count = (nodes.len() / element.kind().nodes()) as u64;
        let block = CellBlock { nodes, labels: (1..=count).collect(), ..CellBlock::new(element.kind()) };
        structure.mesh.blocks.push(block);
        structure.elements.push(element);
    }
    structure
}

/// A mass on a spring along x.
fn oscillator(k: f64, m: f64) -> (Structure, Freedoms) {
    let mut structure = structure(vec![[0.0; 3]], vec![(SPRING1, vec![0]), (MASS, vec![0])]);
    let cell = |block: u32| vec![CellId { block, cell: 0 }];
    let discrete = |element, block, magnitude| Discrete { element, cells: cell(block), magnitude, components: [0, 0] };
    structure.discrete = vec![discrete(SPRING1, 0, k), discrete(MASS, 1, m)];
    let freedoms = structure.freedoms(&[]);
    (structure, freedoms)
}

/// A step without end.
fn begin(lines: &mut Lines, supports: Vec<Support>, state: &mut State) -> CentralDifference {
    CentralDifference::new(&mut [lines], supports, (1e9, f64::INFINITY), state).unwrap()
}

fn hold(freedom: usize) -> Support {
    Support { freedom, kind: Prescribed::Displacement, course: Ramp::constant(0.0) }
}

/// u_n = v₀ Δt sin nθ/sin θ with sin θ/2 = ωΔt/2; ½ v⁻ v⁺ + ½ ω² u² stays, over 10⁵ increments, but for rounding.
#[test]
fn b13_oscillator() {
    let (structure, freedoms) = oscillator(4.0, 1.0);
    let mut state = State::rest(&freedoms);
    let (dt, v0, steps) = (0.05, 3.0, 100_000);
    state.v[0] = v0;
    let mut lines = Lines::new(&structure, &freedoms, 0.0);
    let supports = (1..freedoms.len()).map(hold).collect();
    let mut procedure = begin(&mut lines, supports, &mut state);
    assert_eq!(procedure.stable().increment(), 1.0);
    for _ in 0..steps {
        procedure.advance(&mut [&mut lines], &mut state, dt).unwrap();
        let energy = procedure.conserved(&state) + lines.stored();
        // The first half step takes nothing off, as no force acts at the start.
        assert!((energy / (0.5 * v0 * v0) - 1.0).abs() < 1e-11, "{energy}");
    }
    let theta = 2.0 * (0.5f64 * 2.0 * dt).asin();
    let exact = v0 * dt * (theta * steps as f64).sin() / theta.sin();
    // Rounding of the phase: 1e5 steps of 1e-16 each, in the worst case all to one side.
    assert!((state.u[0] - exact).abs() < 1e-10, "{} {exact}", state.u[0]);
}

/// What is conserved is so, too, where increments change at will, one of no length before the first included: a mass on a spring,
/// pushed by what it hangs on, at increments of up to 0.98 of the stable one.
#[test]
fn increments_of_any_length_conserve_energy() {
    let (structure, freedoms) = oscillator(4.0, 1.0);
    let mut state = State::rest(&freedoms);
    (state.u[0], state.v[0]) = (0.3, 3.0);
    let mut lines = Lines::new(&structure, &freedoms, 0.0);
    let supports = (1..freedoms.len()).map(hold).collect();
    let mut procedure = begin(&mut lines, supports, &mut state);
    let energy = |p: &CentralDifference, state: &State, lines: &Lines| p.conserved(state) + lines.stored();
    let start = energy(&procedure, &state, &lines);
    let mut largest = 0.0f64;
    for i in 0..1000 {
        let dt = 0.98 * (0.6 + 0.4 * ((i * i) as f64).cos().abs());
        procedure.advance(&mut [&mut lines], &mut state, dt).unwrap();
        largest = largest.max(state.fed.abs()).max(procedure.kinetic(&state));
        let drift = energy(&procedure, &state, &lines) - start;
        // Rounding of sums of this size, an increment each.
        assert!(drift.abs() <= 1e-16 * f64::from(i + 1) * largest.max(start) * 4.0, "{i}: {drift} of {largest}");
    }
    assert!(state.fed.abs() > 0.1 * start, "{}", state.fed);
}

/// A chain of trusses, n of length 1, held at nothing.
fn chain(n: usize, (young, density): (f64, f64)) -> (Structure, Freedoms) {
    let points = (0..=n).map(|i| [i as f64, 0.0, 0.0]).collect();
    let nodes = (0..n as u32).flat_map(|i| [i, i + 1]).collect();
    let mut structure = structure(points, vec![(T2D2, nodes)]);
    let section = LineSection {
        element: T2D2,
        cells: structure.mesh.cells().collect(),
        name: "M".into(),
        young,
        shear: 0.0,
        density: Some(density),
        profile: Profile::bar(1.0),
        first_axis: [0.0; 3],
        damping: Default::default(),
    };
    structure.lines = vec![section];
    let freedoms = structure.freedoms(&[]);
    (structure, freedoms)
}

/// Standing waves of N elements swing with (2/Δt) asin(r sin(kh/2)), r = c Δt/h: the phase speed of the lumped chain.
#[test]
fn b07_dispersion() {
    for (wave, r, expected) in [
        (8, 0.5, 0.980541829224),
        (8, 1.0, 1.0),
        (16, 0.5, 0.995169309108),
        (32, 0.5, 0.998794489545),
        (4, 0.5, 0.92021382465),
    ] {
        // Small against a length of 1, so that the chain is linear.
        let amplitude = 1e-9;
        let (structure, freedoms) = chain(wave, (1.0, 1.0));
        let k = std::f64::consts::TAU / wave as f64;
        let (mut state, mut lines) = (State::rest(&freedoms), Lines::new(&structure, &freedoms, 0.0));
        let along = |i: usize| freedoms.index(i, 0).unwrap();
        (0..=wave).for_each(|i| state.v[along(i)] = amplitude * (k * i as f64).cos());
        let supports = (0..=wave).map(|i| hold(freedoms.index(i, 1).unwrap())).collect();
        let mut procedure = begin(&mut lines, supports, &mut state);
        assert_eq!(procedure.stable().increment(), 1.0);
        // Two waves' time and a little more.
        let steps = (2.3 * wave as f64 / r) as usize;
        (0..steps).for_each(|_| procedure.advance(&mut [&mut lines], &mut state, r).unwrap());
        let theta = r * k * expected;
        // From v₀ at rest: u_n = v₀ Δt sin nθ/sin θ, at the end of the chain as anywhere.
        let exact = amplitude * r * (steps as f64 * theta).sin() / theta.sin();
        assert!(
            (state.u[along(0)] - exact).abs() < 1e-7 * amplitude * wave as f64,
            "{wave} {r}: {} {exact}",
            state.u[along(0)]
        );
    }
}

/// Beyond the stable increment the motion grows without end, within it it does not: a chain of trusses at 0.999 and 1.01 of
/// h/c, started at random.
#[test]
fn b06_stable_chain() {
    for (part, bounded) in [(0.999, true), (1.01, false)] {
        let (structure, freedoms) = chain(20, (1.0, 1.0));
        let (mut state, mut lines) = (State::rest(&freedoms), Lines::new(&structure, &freedoms, 0.0));
        (0..=20).for_each(|i| state.v[freedoms.index(i, 0).unwrap()] = 1e-9 * ((i * i) as f64).sin());
        let supports = (0..=20).map(|i| hold(freedoms.index(i, 1).unwrap())).collect();
        let mut procedure = begin(&mut lines, supports, &mut state);
        let dt = part * procedure.stable().increment();
        let most = if bounded { 100_000 } else { 200 };
        let lost = (0..most).any(|_| procedure.advance(&mut [&mut lines], &mut state, dt).is_err());
        let largest = state.v.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        assert_eq!(!lost && largest < 1e-7, bounded, "{part}: {largest}");
    }
}

/// Waits, and does nothing else.
struct Waiting([std::time::Duration; 2]);

impl ExplicitTerm for Waiting {
    fn name(&self) -> &str {
        "waiting"
    }

    fn correct(&mut self, _: &mut Predicted) {
        std::thread::sleep(self.0[0]);
    }

    fn advance(&mut self, _: &Moving, _: &mut [f64]) -> Result<Advance, Halt> {
        std::thread::sleep(self.0[1]);
        Ok(Advance::default())
    }

    fn stored(&self) -> f64 {
        0.0
    }
}

/// A sleep lasts at least as long as it should, and what terms take is no more than all; the start is no part of it.
#[test]
fn each_term_has_its_seconds() {
    let (structure, freedoms) = oscillator(4.0, 1.0);
    let mut state = State::rest(&freedoms);
    let mut lines = Lines::new(&structure, &freedoms, 0.0);
    let waits = [[0, 40], [3, 2], [0, 6]].map(|wait| wait.map(std::time::Duration::from_millis));
    let mut waiting = waits.map(Waiting);
    let supports = (1..freedoms.len()).map(hold).collect();
    let [first, second, third] = &mut waiting;
    let terms: &mut Terms = &mut [&mut lines, first, second, third];
    let mut procedure = CentralDifference::new(terms, supports, (1e9, f64::INFINITY), &mut state).unwrap();
    assert_eq!(procedure.seconds(), [0.0; 4]);
    let start = Instant::now();
    (0..3).for_each(|_| procedure.advance(terms, &mut state, 0.05).unwrap());
    let (all, seconds) = (start.elapsed().as_secs_f64(), procedure.seconds());
    let least = [0.0, 0.120, 0.015, 0.018];
    assert!(seconds.iter().zip(least).all(|(seconds, least)| *seconds >= least), "{seconds:?}");
    assert!(seconds.iter().sum::<f64>() <= all, "{seconds:?} {all}");
}
