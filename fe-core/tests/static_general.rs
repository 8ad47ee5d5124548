//! What a static procedure keeps right from increment to increment: work, loads taken back to nothing, supports let go.
#![allow(clippy::unwrap_used)]

use fe_core::element::ElementType;
use fe_core::external::ExternalForces;
use fe_core::increment::Attempt;
use fe_core::linear::multifrontal::Multifrontal;
use fe_core::load::{LoadKind, unit_forces};
use fe_core::material::{Elastic, Material};
use fe_core::procedure::static_general::StaticGeneral;
use fe_core::procedure::system::Scene;
use fe_core::procedure::{Converged, Procedure};
use fe_core::ramp::Ramp;
use fe_core::solid::SolidBlock;
use fe_core::step::Controls;
use fe_core::{Freedoms, Section, Structure};
use fe_mesh::generate::Block;

/// A beam along x, clamped at one end.
struct Beam {
    structure: Structure,
    freedoms: Freedoms,
    solid: SolidBlock,
}

impl Beam {
    fn new() -> Self {
        let mesh = Block::hex8([12, 3, 3]).size([6.0, 1.0, 1.0]).mesh();
        let cells = mesh.cell_sets["BLOCK"].clone();
        let section = Section { element: ElementType::C3D8, cells, material: 0, thickness: 1.0, hourglass: None };
        let elastic = Elastic { young: 2.1e5, poisson: 0.3 };
        let materials = vec![Material::elastic("M", elastic)];
        let structure = Structure {
            mesh,
            elements: vec![ElementType::C3D8],
            materials,
            sections: vec![section],
            ..Structure::default()
        };
        let freedoms = structure.freedoms(&[]);
        let solid = SolidBlock::new(&structure, &structure.sections[0], &freedoms).unwrap();
        Beam { structure, freedoms, solid }
    }

    fn of_set(&self, set: &str, components: &[usize]) -> Vec<usize> {
        let nodes = self.structure.mesh.node_sets[set].iter();
        nodes.flat_map(|&n| components.iter().map(move |&c| self.freedoms.index(n as usize, c).unwrap())).collect()
    }

    fn rest(&self) -> Converged {
        let zero = vec![0.0; self.freedoms.len()];
        let history = vec![Vec::new()];
        Converged { u: zero.clone(), residual: zero.clone(), external: zero, history, ..Converged::default() }
    }

    /// A step of equal increments with more freedoms `held`.
    fn step(&self, from: &Converged, external: ExternalForces, held: Vec<(usize, Ramp)>, count: usize) -> Converged {
        let clamped = self.of_set("XMIN", &[0, 1, 2]).into_iter().map(|f| (f, Ramp::constant(0.0)));
        let mut prescribed: Vec<_> = clamped.chain(held).collect();
        prescribed.sort_by_key(|p| p.0);
        let scene = Scene { freedoms: &self.freedoms, terms: vec![&self.solid], external, prescribed, period: 1.0 };
        let mut procedure = StaticGeneral::new(scene, Controls::default(), Box::new(Multifrontal::default())).unwrap();
        let mut at = Converged { step_time: 0.0, ..from.clone() };
        for increment in 1..=count {
            let (dt, step_time) = (1.0 / count as f64, increment as f64 / count as f64);
            at = procedure.advance(&at, Attempt { increment, attempt: 1, dt, step_time }).unwrap().0;
        }
        at
    }

    /// A force across the free end.
    fn bending(&self, from: f64, to: f64) -> ExternalForces {
        let load = LoadKind::Nodal { nodes: self.structure.mesh.node_sets["XMAX"].clone(), component: 2 };
        let unit = unit_forces(&load, &self.structure, &self.freedoms).unwrap();
        ExternalForces { parts: vec![(unit, Ramp { from, to, amplitude: None })] }
    }
}

/// Displacement and work fall back to round-off, in one increment and in several.
#[test]
fn a_load_taken_back_leaves_nothing() {
    let beam = Beam::new();
    let loaded = beam.step(&beam.rest(), beam.bending(0.0, 5.0), vec![], 1);
    let largest = |u: &[f64]| u.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    assert!(largest(&loaded.u) > 1e-3);
    for increments in [1, 3] {
        let back = beam.step(&loaded, beam.bending(5.0, 0.0), vec![], increments);
        // Condition number of a slender beam of 12 elements: about 1e4; 1e4 ε = 2e-12.
        assert!(largest(&back.u) < 1e-11 * largest(&loaded.u), "{:e}", largest(&back.u));
        assert!(back.energy.work.abs() < 1e-11 * loaded.energy.work, "{:e}", back.energy.work);
    }
}

/// The end is pulled and bent by prescribed displacements, then let go, its reaction ramping away: the forces are
/// linear in the displacement, so that the trapezoidal rule is exact and work equals stored energy to round-off.
#[test]
fn a_support_let_go_gives_its_work_back() {
    let beam = Beam::new();
    let held = beam.of_set("XMAX", &[0, 2]);
    let pull = held.iter().map(|&f| (f, Ramp { from: 0.0, to: 0.01, amplitude: None })).collect();
    let pulled = beam.step(&beam.rest(), ExternalForces::default(), pull, 2);
    assert!((pulled.energy.work / pulled.energy.solids - 1.0).abs() < 1e-12);
    let let_go = held.iter().map(|&f| (vec![(f, 1.0)], Ramp { from: pulled.residual[f], to: 0.0, amplitude: None }));
    let free = beam.step(&pulled, ExternalForces { parts: let_go.collect() }, vec![], 4);
    assert!(free.energy.solids < 1e-20 * pulled.energy.solids);
    assert!(free.energy.work.abs() < 1e-11 * pulled.energy.work, "{:e}", free.energy.work / pulled.energy.work);
}

/// Moved as a whole by prescribed freedoms, the beam has no forces but round-off, and says so: with no matrix as well as
/// with one, whose round-off is of the same size.
#[test]
fn round_off_is_known_without_a_matrix() {
    let beam = Beam::new();
    let round_off = |free: usize| {
        let prescribed =
            (free..beam.freedoms.len()).map(|f| (f, Ramp { from: 0.0, to: 0.01, amplitude: None })).collect();
        let external = ExternalForces::default();
        let scene = Scene { freedoms: &beam.freedoms, terms: vec![&beam.solid], external, prescribed, period: 1.0 };
        let mut procedure = StaticGeneral::new(scene, Controls::default(), Box::new(Multifrontal::default())).unwrap();
        assert_eq!(procedure.cost().is_some(), free > 0);
        let attempt = Attempt { increment: 1, attempt: 1, dt: 1.0, step_time: 1.0 };
        let (at, convergence) = procedure.advance(&beam.rest(), attempt).unwrap();
        let largest = at.residual.iter().fold(0.0f64, |m, r| m.max(r.abs()));
        assert!(largest > 0.0 && largest <= convergence.round_off, "{largest:e} {:e}", convergence.round_off);
        convergence.round_off
    };
    let (with, without) = (round_off(3), round_off(0));
    assert!(without > 0.1 * with && without <= 1.01 * with, "{without:e} {with:e}");
}
