//! Supports and loads through the steps: what holds, what changes, what is taken away.

use fe_core::Freedoms;
use fe_core::amplitude::{Amplitude, TimeBase};
use fe_core::explicit::loads::Loads;
use fe_core::external::ExternalForces;
use fe_core::load::{self, Load, LoadError, LoadKind, Prescribed, PressedFace, Support};
use fe_core::procedure::Converged;
use fe_core::ramp::Ramp;
use fe_core::step::Procedure;
use fe_core::structure::Structure;
use fe_io::model::{Changes, Model, Step};
use fe_mesh::{CellId, Face};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What acts from step to step. A value without an amplitude ramps over the step from where it was; what a step
/// removes ramps to zero (loads) or leaves its reaction behind as a load that ramps to zero (supports).
#[derive(Clone, Debug, Default)]
pub struct Course {
    amplitudes: Vec<Arc<Amplitude>>,
    supports: BTreeMap<usize, (Prescribed, Ramp)>,
    nodal: Vec<Active>,
    distributed: Vec<Active>,
    released: Vec<(usize, Ramp)>,
    /// Step and total time at the last step's end, and its period [T].
    end: (f64, f64, f64),
}

/// A load in force.
#[derive(Clone, Debug)]
struct Active {
    kind: LoadKind,
    ramp: Ramp,
    /// Magnitude at the end of the last step.
    held: f64,
}

impl Course {
    /// Before the first step.
    pub fn new(model: &Model) -> Self {
        Course { amplitudes: model.amplitudes.iter().cloned().map(Arc::new).collect(), ..Course::default() }
    }

    /// Enters a step. `initial` are the supports of the model data, for the first step. `at` is the state.
    pub fn enter(&mut self, initial: &[Support], step: &Step, freedoms: &Freedoms, at: &Converged) {
        self.released.clear();
        self.hold(at);
        let before: Vec<usize> = self.supports.keys().copied().collect();
        if step.supports.replace {
            self.supports.clear();
        } else {
            self.support(initial, freedoms, at);
        }
        self.support(&step.supports.items, freedoms, at);
        let free = before.into_iter().filter(|f| !self.supports.contains_key(f));
        self.release(free.map(|f| (f, at.residual[f])).collect());
        let amplitudes = &self.amplitudes;
        self.nodal = change(std::mem::take(&mut self.nodal), &step.nodal_loads, amplitudes);
        self.distributed = change(std::mem::take(&mut self.distributed), &step.distributed_loads, amplitudes);
        if matches!(step.procedure, Procedure::Explicit(_)) {
            self.at_once();
        }
        self.end = (step.procedure.period(), at.total_time + step.procedure.period(), step.procedure.period());
    }

    /// In an explicit step what has no amplitude holds from its start, and what is taken away is gone.
    fn at_once(&mut self) {
        self.released.clear();
        let loads = self.nodal.iter_mut().chain(&mut self.distributed).map(|active| &mut active.ramp);
        let ramps = loads.chain(self.supports.values_mut().map(|(_, ramp)| ramp));
        ramps.filter(|ramp| ramp.amplitude.is_none()).for_each(|ramp| *ramp = Ramp::constant(ramp.to));
    }

    /// Forces [F], by freedom, that ramp to zero over the step just entered.
    pub fn release(&mut self, forces: Vec<(usize, f64)>) {
        self.released.extend(forces.into_iter().map(|(f, from)| (f, Ramp { from, to: 0.0, amplitude: None })));
    }

    /// At the end of a step: values without a course in total time stay where they are.
    fn hold(&mut self, at: &Converged) {
        let (step_time, total_time, period) = self.end;
        for Active { ramp, held, .. } in self.nodal.iter_mut().chain(&mut self.distributed) {
            *held = ramp.at(step_time, total_time, period);
            if !ramp.amplitude.as_ref().is_some_and(|a| a.base == TimeBase::Total) {
                *ramp = Ramp::constant(*held);
            }
        }
        self.nodal.retain(|a| a.ramp != Ramp::constant(0.0));
        self.distributed.retain(|a| a.ramp != Ramp::constant(0.0));
        for (f, (prescribed, ramp)) in &mut self.supports {
            if !ramp.amplitude.as_ref().is_some_and(|a| a.base == TimeBase::Total) {
                *ramp = Ramp::constant(match prescribed {
                    Prescribed::Displacement => at.u[*f],
                    Prescribed::Velocity | Prescribed::Acceleration => ramp.at(step_time, total_time, period),
                });
            }
        }
    }

    fn support(&mut self, items: &[Support], freedoms: &Freedoms, at: &Converged) {
        for item in items {
            if let Some(f) = freedoms.index(item.node as usize, item.component as usize) {
                let amplitude = item.amplitude.map(|a| self.amplitudes[a].clone());
                self.supports.insert(f, (item.prescribed, Ramp { from: at.u[f], to: item.value, amplitude }));
            }
        }
    }

    /// True for each of so many freedoms that the step prescribes.
    pub fn fixed(&self, freedoms: usize) -> Vec<bool> {
        (0..freedoms).map(|f| self.supports.contains_key(&f)).collect()
    }

    /// Prescribed freedoms of the step, ascending.
    pub fn prescribed(&self) -> Vec<(usize, Ramp)> {
        self.supports.iter().map(|(f, (_, ramp))| (*f, ramp.clone())).collect()
    }

    /// Prescribed freedoms of an explicit step, ascending, with what is prescribed of each.
    pub fn moved(&self) -> impl Iterator<Item = (usize, Prescribed, Ramp)> + '_ {
        self.supports.iter().map(|(f, (prescribed, ramp))| (*f, *prescribed, ramp.clone()))
    }

    /// Loads of the step, all of them as they are at the start.
    pub fn external(&self, structure: &Structure, freedoms: &Freedoms) -> Result<ExternalForces, LoadError> {
        self.dead(self.nodal.iter().chain(&self.distributed), structure, freedoms)
    }

    /// Loads of an explicit step: pressures follow their faces.
    pub fn following(&self, structure: &Structure, freedoms: &Freedoms) -> Result<Loads, LoadError> {
        let faces = |active: &Active| match &active.kind {
            LoadKind::Pressure { faces } => Some(faces.clone()),
            _ => None,
        };
        let others = self.distributed.iter().filter(|active| faces(active).is_none());
        let mut loads = Loads::new(self.dead(self.nodal.iter().chain(others), structure, freedoms)?, self.end.2);
        for active in &self.distributed {
            let Some(faces) = faces(active) else { continue };
            let pressed = faces.into_iter().map(|face| PressedFace::new(face, structure, freedoms));
            loads = loads.press(pressed.collect::<Result<_, _>>()?, active.ramp.clone());
        }
        Ok(loads)
    }

    fn dead<'a>(
        &self,
        loads: impl Iterator<Item = &'a Active>,
        structure: &Structure,
        freedoms: &Freedoms,
    ) -> Result<ExternalForces, LoadError> {
        let mut parts = Vec::new();
        for active in loads {
            parts.push((load::unit_forces(&active.kind, structure, freedoms)?, active.ramp.clone()));
        }
        parts.extend(self.released.iter().map(|(f, ramp)| (vec![(*f, 1.0)], ramp.clone())));
        Ok(ExternalForces { parts })
    }
}

/// The loads of one kind after a step's cards: those it names anew start from their old magnitude, place by place.
fn change(old: Vec<Active>, changes: &Changes<Load>, amplitudes: &[Arc<Amplitude>]) -> Vec<Active> {
    let mut fresh = Vec::new();
    for (i, item) in changes.items.iter().enumerate() {
        let amplitude = item.amplitude.map(|a| amplitudes[a].clone());
        for (from, places) in old_magnitudes(&item.kind, &old, &changes.items[..i]) {
            let ramp = Ramp { from, to: item.magnitude, amplitude: amplitude.clone() };
            fresh.push(Active { kind: on(&item.kind, places), ramp, held: from });
        }
    }
    let mut kept = Vec::new();
    for Active { kind, ramp, held } in old {
        let named = named(&changes.items, &kind);
        let left: Vec<Place> = places(&kind).into_iter().filter(|p| !named.contains(p)).collect();
        if !left.is_empty() {
            let fading = Ramp { from: held, to: 0.0, amplitude: None };
            kept.push(Active { kind: on(&kind, left), ramp: if changes.replace { fading } else { ramp }, held });
        }
    }
    kept.extend(fresh);
    kept
}

/// Where a load acts.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Node(u32),
    Face(Face),
    Cell(CellId),
}

fn places(kind: &LoadKind) -> Vec<Place> {
    match kind {
        LoadKind::Nodal { nodes, .. } => nodes.iter().map(|&n| Place::Node(n)).collect(),
        LoadKind::Pressure { faces } => faces.iter().map(|&f| Place::Face(f)).collect(),
        LoadKind::Line { cells, .. } | LoadKind::Gravity { cells, .. } => {
            cells.iter().map(|&c| Place::Cell(c)).collect()
        }
    }
}

/// The same sort of load on other places.
fn on(kind: &LoadKind, places: Vec<Place>) -> LoadKind {
    let mut kind = kind.clone();
    match &mut kind {
        LoadKind::Nodal { nodes, .. } => nodes.clear(),
        LoadKind::Pressure { faces } => faces.clear(),
        LoadKind::Line { cells, .. } | LoadKind::Gravity { cells, .. } => cells.clear(),
    }
    for place in places {
        match (&mut kind, place) {
            (LoadKind::Nodal { nodes, .. }, Place::Node(n)) => nodes.push(n),
            (LoadKind::Pressure { faces }, Place::Face(f)) => faces.push(f),
            (LoadKind::Line { cells, .. } | LoadKind::Gravity { cells, .. }, Place::Cell(c)) => cells.push(c),
            _ => {}
        }
    }
    kind
}

/// One load takes the place of the other: forces in the same direction, pressures, or gravity.
fn alike(a: &LoadKind, b: &LoadKind) -> bool {
    match (a, b) {
        (LoadKind::Nodal { component: p, .. }, LoadKind::Nodal { component: q, .. }) => p == q,
        (LoadKind::Line { component: p, .. }, LoadKind::Line { component: q, .. }) => p == q,
        _ => std::mem::discriminant(a) == std::mem::discriminant(b),
    }
}

/// The places of all loads like `kind`.
fn named(loads: &[Load], kind: &LoadKind) -> BTreeSet<Place> {
    loads.iter().filter(|l| alike(&l.kind, kind)).flat_map(|l| places(&l.kind)).collect()
}

/// The places of a load by the magnitude they had; 0 where another card of the step goes on from it already, or
/// where gravity turns.
fn old_magnitudes(kind: &LoadKind, old: &[Active], earlier: &[Load]) -> Vec<(f64, Vec<Place>)> {
    let mut magnitude: BTreeMap<Place, f64> = BTreeMap::new();
    for active in old.iter().filter(|a| alike(&a.kind, kind) && same_direction(&a.kind, kind)) {
        places(&active.kind).into_iter().for_each(|p| *magnitude.entry(p).or_default() += active.held);
    }
    let taken = named(earlier, kind);
    let mut groups: Vec<(f64, Vec<Place>)> = Vec::new();
    for place in places(kind) {
        let from = if taken.contains(&place) { 0.0 } else { magnitude.get(&place).copied().unwrap_or(0.0) };
        match groups.iter_mut().find(|g| g.0 == from) {
            Some(group) => group.1.push(place),
            None => groups.push((from, vec![place])),
        }
    }
    groups
}

fn same_direction(a: &LoadKind, b: &LoadKind) -> bool {
    match (a, b) {
        (LoadKind::Gravity { direction: p, .. }, LoadKind::Gravity { direction: q, .. }) => p == q,
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodal(nodes: &[u32], magnitude: f64) -> Load {
        Load { kind: LoadKind::Nodal { nodes: nodes.to_vec(), component: 0 }, magnitude, amplitude: None }
    }

    fn total(loads: &[Active], node: u32, at: f64) -> f64 {
        loads.iter().filter(|a| places(&a.kind).contains(&Place::Node(node))).map(|a| a.ramp.at(at, at, 1.0)).sum()
    }

    #[test]
    fn a_load_named_again_goes_from_its_old_magnitude() {
        let first = change(vec![], &Changes { replace: false, items: vec![nodal(&[1, 2], 10.0)] }, &[]);
        assert_eq!((total(&first, 1, 0.5), total(&first, 1, 1.0)), (5.0, 10.0));
        let held =
            first.into_iter().map(|a| Active { ramp: Ramp::constant(a.ramp.to), held: a.ramp.to, ..a }).collect();
        let second = change(held, &Changes { replace: false, items: vec![nodal(&[2, 3], 4.0)] }, &[]);
        assert_eq!((total(&second, 1, 0.5), total(&second, 2, 0.5), total(&second, 3, 0.5)), (10.0, 7.0, 2.0));
        assert_eq!((total(&second, 1, 1.0), total(&second, 2, 1.0), total(&second, 3, 1.0)), (10.0, 4.0, 4.0));
    }

    #[test]
    fn what_is_replaced_fades() {
        let old = vec![Active { kind: nodal(&[1, 2], 0.0).kind, ramp: Ramp::constant(8.0), held: 8.0 }];
        let new = change(old, &Changes { replace: true, items: vec![nodal(&[2], 4.0)] }, &[]);
        assert_eq!((total(&new, 1, 0.5), total(&new, 1, 1.0)), (4.0, 0.0));
        assert_eq!((total(&new, 2, 0.5), total(&new, 2, 1.0)), (6.0, 4.0));
    }

    /// An amplitude in total time has a magnitude of its own at the end of a step: what replaces the load starts there.
    #[test]
    fn a_load_in_total_time_fades_from_where_it_was() {
        let points = vec![(0.0, 0.0), (4.0, 1.0)];
        let amplitude = Some(Arc::new(Amplitude {
            name: "A".into(),
            base: TimeBase::Total,
            course: fe_core::amplitude::Course::Linear,
            points,
        }));
        let ramp = Ramp { from: 0.0, to: 8.0, amplitude };
        let active = Active { kind: nodal(&[1, 2], 0.0).kind, ramp, held: 0.0 };
        let mut course = Course { nodal: vec![active], end: (1.0, 1.0, 1.0), ..Course::default() };
        course.hold(&Converged::default());
        let new = change(course.nodal, &Changes { replace: true, items: vec![nodal(&[2], 4.0)] }, &[]);
        assert_eq!((total(&new, 1, 0.0), total(&new, 1, 0.5), total(&new, 2, 0.5)), (2.0, 1.0, 3.0));
    }

    #[test]
    fn cards_of_one_step_add_up() {
        let old = vec![Active { kind: nodal(&[1], 0.0).kind, ramp: Ramp::constant(8.0), held: 8.0 }];
        let items = vec![nodal(&[1], 1.0), nodal(&[1], 2.0)];
        let new = change(old, &Changes { replace: false, items }, &[]);
        assert_eq!((total(&new, 1, 0.0), total(&new, 1, 1.0)), (8.0, 3.0));
    }
}
