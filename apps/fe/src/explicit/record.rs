//! Results of explicit jobs: frames, energies, tables.

use super::scene::Scene;
use crate::fields::{mises, status};
use crate::recorder::{results_file, tables_path};
use fe_contact::explicit::PointState as ContactPoint;
use fe_core::explicit::ExplicitTerm;
use fe_core::explicit::central_difference::{CentralDifference, State};
use fe_core::explicit::solid::PointState;
use fe_io::Model;
use fe_io::model::{Quantity, Table};
use fe_io::results::fields::{FIELDS, requested};
use fe_io::results::table::{ElementRow, Tables};
use fe_io::results::{self, FieldInfo, HistoryInfo, HistoryRow, Location, ResultsError, ResultsFile};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Energies [F L] of a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// ALLKE: of motion.
    pub kinetic: f64,
    /// What stands for it in the balance: see [`CentralDifference::conserved`].
    pub conserved: f64,
    /// ALLSE: recoverable, of solids, trusses and springs.
    pub strain: f64,
    /// ALLPD: dissipated by plastic flow.
    pub plastic: f64,
    /// ALLAE: taken by the resistance to hourglass motion.
    pub artificial: f64,
    /// ALLVD: dissipated by bulk viscosity, dashpots and the damping of materials.
    pub viscous: f64,
    /// Taken by contact: stored by penalties and laws, dissipated by friction and damping.
    pub contact: f64,
    /// ALLWK: work of loads and supports.
    pub work: f64,
    /// What there was at the start: of initial velocities.
    pub initial: f64,
    /// Largest sum of energies so far.
    pub largest: f64,
}

impl Balance {
    /// ETOTAL: what is there, less what came from outside and what there was; 0 but for the error of the increments.
    pub fn total(&self) -> f64 {
        self.conserved + self.strain + self.plastic + self.artificial + self.viscous + self.contact
            - self.work
            - self.initial
    }

    /// Its size over the largest energy so far [-].
    pub fn drift(&self) -> f64 {
        let total = self.total().abs();
        if total == 0.0 { 0.0 } else { total / self.largest }
    }
}

/// What is told of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Number of the step, from 1.
    pub step: usize,
    /// Increments of the step so far.
    pub increment: usize,
    /// Step time [T].
    pub step_time: f64,
    /// The last increment [T].
    pub dt: f64,
    /// Energies.
    pub balance: Balance,
}

/// Name of the history of energies, and its columns.
const ENERGIES: &str = "Energies";
const COLUMNS: [&str; 9] = ["ALLKE", "ALLSE", "ALLPD", "ALLAE", "ALLVD", "CONTACT", "ALLWK", "ETOTAL", "increment"];

/// What a moment is made of: scene, state, procedure, prescribed freedoms.
pub type Moment<'a> = (&'a Scene, &'a State, &'a CentralDifference, &'a [bool]);

/// The files of a job.
pub struct Record {
    file: ResultsFile,
    tables: Tables,
    seconds: f64,
    initial: Option<f64>,
    largest: f64,
}

impl Record {
    /// Creates them.
    pub fn create(job: &Path, model: &Model, scene: &Scene) -> Result<Self, ResultsError> {
        let history = HistoryInfo {
            name: ENERGIES.into(),
            columns: COLUMNS.map(str::to_owned).to_vec(),
            units: COLUMNS.map(|name| if name == "increment" { "T" } else { "F L" }.to_owned()).to_vec(),
            meaning: "energies, and the length of the last increment".into(),
        };
        let file = results_file(job, model, &scene.structure, (fields(model, scene), vec![history]))?;
        let tables = Tables::create(&tables_path(job))?;
        Ok(Record { file, tables, seconds: 0.0, initial: None, largest: 0.0 })
    }

    /// Where the results file is.
    pub fn path(&self) -> PathBuf {
        self.file.path().to_path_buf()
    }

    /// Seconds spent on writing.
    pub fn seconds(&self) -> f64 {
        self.seconds
    }

    /// Stores a frame.
    pub fn frame(
        &mut self,
        (scene, state, procedure, fixed): Moment,
        (step, increment): (usize, usize),
    ) -> Result<Balance, ResultsError> {
        let start = Instant::now();
        let balance = self.balance(scene, state, procedure);
        let source = Source { scene, state, fixed, velocity: procedure.velocity(state), states: states(scene) };
        let values: Vec<Vec<f64>> = self.file.fields().iter().map(|field| source.values(field)).collect();
        let fields: Vec<&[f64]> = values.iter().map(Vec::as_slice).collect();
        let Balance { kinetic, strain, plastic, artificial, viscous, contact, work, .. } = balance;
        let row = [kinetic, strain, plastic, artificial, viscous, contact, work, balance.total(), state.dt];
        let rows = [HistoryRow { name: ENERGIES, values: &row }];
        self.file.append(&results::Frame { time: state.total_time, step, increment, fields: &fields }, &rows)?;
        self.seconds += start.elapsed().as_secs_f64();
        Ok(balance)
    }

    /// Prints tables.
    pub fn print(&mut self, (scene, state, procedure, fixed): Moment, tables: &[&Table]) -> Result<(), ResultsError> {
        let start = Instant::now();
        let source = Source { scene, state, fixed, velocity: procedure.velocity(state), states: states(scene) };
        for table in tables {
            source.print(table, &mut self.tables)?;
        }
        self.tables.flush()?;
        self.seconds += start.elapsed().as_secs_f64();
        Ok(())
    }

    fn balance(&mut self, scene: &Scene, state: &State, procedure: &CentralDifference) -> Balance {
        let solids = scene.solids.as_ref().map(|solids| solids.energies()).unwrap_or_default();
        let [stored, dissipated] = scene.lines.as_ref().map_or([0.0; 2], |lines| lines.energies());
        let conserved = procedure.conserved(state);
        let contact = scene.contact_energy();
        let strain = solids.internal - solids.plastic + stored;
        let damped = scene.damping.as_ref().map_or(0.0, |damping| damping.stored());
        let viscous = solids.viscous + dissipated + damped;
        let sum = conserved + strain + solids.plastic + solids.hourglass + viscous + contact;
        self.largest = self.largest.max(sum.abs());
        Balance {
            kinetic: procedure.kinetic(state),
            conserved,
            strain,
            plastic: solids.plastic,
            artificial: solids.hourglass,
            viscous,
            contact,
            work: state.work - scene.loads.stored(),
            initial: *self.initial.get_or_insert(sum),
            largest: self.largest,
        }
    }

    /// The end of a job.
    pub fn finish(self, outcome: &str) -> Result<(), ResultsError> {
        self.file.finish(outcome)
    }
}

/// The fields that any step asks for, or the usual ones.
fn fields(model: &Model, scene: &Scene) -> Vec<FieldInfo> {
    let there = |field: &&FieldInfo| match (field.name, field.location) {
        ("U" | "V" | "RF", _) => true,
        ("S" | "MISES" | "PEEQ", Location::Cell) => scene.solids.is_some(),
        ("COPEN" | "CSTATUS", _) => {
            model.steps.iter().any(|step| !step.explicit_pairs.is_empty() || step.general_contact.is_some())
        }
        _ => false,
    };
    let wanted = |field: &&FieldInfo| {
        model.steps.iter().any(|step| match &step.output.fields {
            None => true,
            Some(words) => words.iter().any(|word| requested(word).contains(field)),
        })
    };
    FIELDS.iter().filter(there).filter(wanted).copied().collect()
}

/// States of the solids, cells ascending.
fn states(scene: &Scene) -> Vec<PointState> {
    let mut states: Vec<PointState> = scene.solids.iter().flat_map(|solids| solids.states()).collect();
    states.sort_unstable_by_key(|state| state.cell);
    states
}

/// What a frame is made of.
struct Source<'a> {
    scene: &'a Scene,
    state: &'a State,
    fixed: &'a [bool],
    velocity: Vec<f64>,
    states: Vec<PointState>,
}

impl Source<'_> {
    fn values(&self, field: &FieldInfo) -> Vec<f64> {
        let nodal = |of: &dyn Fn(usize) -> f64| {
            let nodes = 0..self.scene.freedoms.nodes() as u32;
            nodes.flat_map(|node| self.vector(node, of)).collect()
        };
        match field.name {
            "U" => nodal(&|f| self.state.u[f]),
            "V" => nodal(&|f| self.velocity[f]),
            "RF" => nodal(&|f| self.reaction(f)),
            "S" => self.cells(6, |state, place| place.copy_from_slice(&state.stress)),
            "MISES" => self.cells(1, |state, place| place[0] = mises(&state.stress)),
            "PEEQ" => self.cells(1, |state, place| place[0] = state.plastic),
            "COPEN" => self.contact(|point| point.opening.unwrap_or(f64::NAN), f64::min),
            "CSTATUS" => self.contact(|point| status(point.status), f64::max),
            other => unreachable!("explicit jobs have no {other}"),
        }
    }

    /// Force [F] of a support.
    fn reaction(&self, freedom: usize) -> f64 {
        if self.fixed[freedom] { -self.state.force[freedom] } else { 0.0 }
    }

    fn vector(&self, node: u32, of: &dyn Fn(usize) -> f64) -> [f64; 3] {
        std::array::from_fn(|c| self.scene.freedoms.index(node as usize, c).map_or(0.0, of))
    }

    /// A number of the secondary nodes; where pairs share a node, `merge` of theirs.
    fn contact(&self, value: impl Fn(&ContactPoint) -> f64, merge: fn(f64, f64) -> f64) -> Vec<f64> {
        let mut out = vec![f64::NAN; self.scene.structure.mesh.points.len()];
        for point in self.scene.contact_states() {
            let place = &mut out[point.node as usize];
            *place = merge(*place, value(&point));
        }
        out
    }

    fn cells(&self, width: usize, put: impl Fn(&PointState, &mut [f64])) -> Vec<f64> {
        let mesh = &self.scene.structure.mesh;
        let first = mesh.first_cells();
        let mut out = vec![f64::NAN; width * mesh.cell_count()];
        for state in &self.states {
            let place = width * (first[state.cell.block as usize] + state.cell.cell as usize);
            put(state, &mut out[place..place + width]);
        }
        out
    }

    fn print(&self, table: &Table, tables: &mut Tables) -> Result<(), ResultsError> {
        let (mesh, time) = (&self.scene.structure.mesh, self.state.total_time);
        let nodes = mesh.node_sets.get(&table.set).map_or(&[][..], Vec::as_slice);
        let labels: Vec<u64> = nodes.iter().map(|&n| mesh.point_labels[n as usize]).collect();
        let vectors = |of: &dyn Fn(usize) -> f64| nodes.iter().map(|&n| self.vector(n, of)).collect::<Vec<_>>();
        match table.quantity {
            Quantity::Displacement => tables.displacements(&table.set, time, &labels, &vectors(&|f| self.state.u[f])),
            Quantity::Velocity => tables.velocities(&table.set, time, &labels, &vectors(&|f| self.velocity[f])),
            Quantity::Reaction => {
                tables.reactions(&table.set, time, &labels, &vectors(&|f| self.reaction(f)), table.totals)
            }
            Quantity::Stress => {
                let cells = mesh.cell_sets.get(&table.set).map_or(&[][..], Vec::as_slice);
                let of_set = self.states.iter().filter(|state| cells.binary_search(&state.cell).is_ok());
                let row = |state: &PointState| ElementRow {
                    element: mesh.cell_label(state.cell),
                    point: 1,
                    values: state.stress,
                };
                tables.stresses(&table.set, time, &of_set.map(row).collect::<Vec<_>>())
            }
            // Strains and contact are not printed in explicit steps.
            _ => Ok(()),
        }
    }
}
