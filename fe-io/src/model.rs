//! What a deck describes, resolved: plain data, also built by programs that bring no deck.

use fe_contact::conditions::Conditions;
use fe_contact::gap::GapDefinition;
use fe_contact::interaction::Interaction;
use fe_contact::pair::{ExplicitPair, GeneralContact, PairDefinition};
use fe_contact::tube::TubeDefinition;
use fe_core::amplitude::Amplitude;
use fe_core::load::{Load, Support};
use fe_core::step::{MassScaling, Procedure};
use fe_core::structure::Structure;
use fe_mesh::CellId;
use std::sync::Arc;

/// Where in a deck something stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// File as the user named it.
    pub file: Arc<str>,
    /// Line, from 1.
    pub line: u32,
}

/// The whole job.
#[derive(Clone, Debug)]
pub struct Model {
    /// `*HEADING`.
    pub heading: String,
    /// Bodies; a job shares them, unless it moves nodes.
    pub structure: Arc<Structure>,
    /// Amplitudes.
    pub amplitudes: Vec<Amplitude>,
    /// Interactions.
    pub interactions: Vec<Interaction>,
    /// Contact pairs, each with the place of its data line.
    pub pairs: Vec<(PairDefinition, Place)>,
    /// Contact pairs of explicit steps, each with the place of its data line; [`Step::explicit_pairs`] says which act.
    pub explicit_pairs: Vec<(ExplicitPair, Place)>,
    /// Gap elements, each with the place of its card.
    pub gaps: Vec<(GapDefinition, Place)>,
    /// Tube-to-tube elements, each with the place of its card.
    pub tubes: Vec<(TubeDefinition, Place)>,
    /// Rigid bodies.
    pub rigid_bodies: Vec<RigidBody>,
    /// Supports of the model data: they hold from the start.
    pub supports: Vec<Support>,
    /// Velocities at the start of an explicit job: node, freedom 0..6, value [L/T or rad/T]; each freedom once, in the
    /// order of the deck. All others begin at rest.
    pub initial_velocities: Vec<(u32, usize, f64)>,
    /// Steps, all static or all explicit.
    pub steps: Vec<Step>,
    /// Remarks on the deck that do not stop the run (cards without effect here), a line each.
    pub notes: Vec<String>,
}

impl Model {
    /// Reference nodes of rigid bodies, ascending, each once.
    pub fn references(&self) -> Vec<u32> {
        let mut references: Vec<u32> = self.rigid_bodies.iter().map(|body| body.reference).collect();
        references.sort_unstable();
        references.dedup();
        references
    }
}

/// What moves with a reference node: an analytical surface, facets, or both.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidBody {
    /// Node index.
    pub reference: u32,
    /// Facets (R2D2, R3D3, R3D4), ascending; their nodes have no freedoms of their own, and belong to no other body.
    pub cells: Vec<CellId>,
    /// Name of the analytical surface.
    pub surface: Option<String>,
}

/// What `OP=` says of a card's kind in a step.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes<T> {
    /// `OP=NEW`: what earlier steps (and model data) set is removed.
    pub replace: bool,
    /// Added, or modified where the same freedom or the same load is meant.
    pub items: Vec<T>,
}

/// One step.
#[derive(Clone, Debug)]
pub struct Step {
    /// Place of `*STEP`.
    pub place: Place,
    /// How it goes from start to end; all steps of a job are of one kind.
    pub procedure: Procedure,
    /// `*BOUNDARY`.
    pub supports: Changes<Support>,
    /// `*CLOAD`.
    pub nodal_loads: Changes<Load>,
    /// `*DLOAD` and `*DSLOAD`.
    pub distributed_loads: Changes<Load>,
    /// What the step says of each contact, in the order of [`Model::pairs`], [`Model::gaps`] and
    /// [`Model::tubes`]; of those that are not listed, nothing.
    pub conditions: Vec<Conditions>,
    /// The pairs that act in an explicit step, those that earlier steps have left included, by ascending index.
    pub explicit_pairs: Vec<ActivePair>,
    /// General contact in force, of explicit steps.
    pub general_contact: Option<GeneralContact>,
    /// Mass scaling in force, of explicit steps.
    pub mass_scaling: Vec<MassScaling>,
    /// Requests in force (those of earlier steps included where the step has no card of the same kind).
    pub output: Output,
}

/// A contact pair that acts in an explicit step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActivePair {
    /// Index into [`Model::explicit_pairs`]. A pair that a step defines anew has a new one.
    pub pair: usize,
    /// Index into [`Model::interactions`] of what holds in this step; `None`: hard contact that slides freely.
    pub interaction: Option<usize>,
    /// `*CONTACT CONTROLS, SCALE PENALTY=`: factor [-] on the default penalty stiffness.
    pub scale_penalty: f64,
}

/// What a step prints and stores.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Tables of the `.dat` file, in the deck's order.
    pub tables: Vec<Table>,
    /// Field names of the results file; `None`: the usual ones.
    pub fields: Option<Vec<String>>,
    /// When a frame is stored; the last increment of a step always is.
    pub frames: Frames,
    /// At the ends of these intervals increments of an explicit step end, too.
    pub marks: Vec<Frames>,
    /// Histories of an explicit step.
    pub histories: Vec<HistoryRequest>,
}

/// A history of an explicit step.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoryRequest {
    /// What.
    pub of: History,
    /// When; with the last increment of a step always.
    pub when: Frames,
}

/// What a history holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum History {
    /// `*ENERGY OUTPUT`: all energies, and the last increment.
    Energies,
    /// `*CONTACT OUTPUT`: resultants of a pair, by the names of its secondary and main surface; `None`: of every pair.
    Contact(Option<[String; 2]>),
    /// `*NODE OUTPUT`: a field at the nodes of a set.
    Nodes(HistoryOfSet),
    /// `*ELEMENT OUTPUT`: a field at the elements of a set.
    Elements(HistoryOfSet),
}

/// A field in a set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HistoryOfSet {
    /// Name of the set, capitals.
    pub set: String,
    /// Name of the field: U, V, RF; S, MISES, PEEQ.
    pub field: &'static str,
    /// Which of its components, from 0; `None`: all.
    pub component: Option<usize>,
}

/// When something is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frames {
    /// Every so many increments; for 0 the last one alone.
    Increments(usize),
    /// At the ends of so many equal parts of a step: with the increment that reaches them.
    Parts(usize),
    /// Every so long [T] of step time, likewise.
    Time(f64),
}

impl Frames {
    /// Frames of an explicit step unless the deck says otherwise: Abaqus Analysis User's Manual, Output to the output
    /// database.
    pub const EXPLICIT: Frames = Frames::Parts(20);

    /// Histories of an explicit step, likewise.
    pub const HISTORY: Frames = Frames::Parts(200);

    /// Nothing but the last increment of a step.
    pub const LAST: Frames = Frames::Increments(0);

    /// True when the increment of this number, from 1, is stored that goes from one step time to another in a step of a
    /// period [T].
    pub fn hold(&self, increment: usize, [from, to]: [f64; 2], period: f64) -> bool {
        let crossed = |interval: f64| passed(to, interval) > passed(from, interval);
        match *self {
            _ if to >= period => true,
            Frames::Increments(every) => every > 0 && increment.is_multiple_of(every),
            Frames::Parts(_) | Frames::Time(_) => self.interval(period).is_some_and(crossed),
        }
    }

    /// Time [T] from one to the next in a step of a period [T]; `None` where increments are counted.
    pub fn interval(&self, period: f64) -> Option<f64> {
        match *self {
            Frames::Increments(_) => None,
            Frames::Parts(parts) => Some(period / parts as f64),
            Frames::Time(interval) => Some(interval),
        }
    }

    /// The step time [T] at which the interval ends that begins at a step time or goes on there; the end of the step at the
    /// latest.
    pub fn end(&self, time: f64, period: f64) -> f64 {
        let end = self.interval(period).map_or(period, |interval| (passed(time, interval) + 1.0) * interval);
        if passed(end, period) >= 1.0 { period } else { end }
    }
}

/// How many intervals have ended at a time; one that is reached but for rounding is reached.
fn passed(time: f64, interval: f64) -> f64 {
    (time / interval * (1.0 + 8.0 * f64::EPSILON)).floor()
}

/// One table request.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// What is printed.
    pub quantity: Quantity,
    /// Name of the set, capitals; empty for contact tables.
    pub set: String,
    /// When it is printed; with the last increment of a step always.
    pub when: Frames,
    /// `TOTALS=`.
    pub totals: Totals,
}

/// `TOTALS=NO|YES|ONLY`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Totals {
    #[default]
    No,
    Yes,
    Only,
}

/// A quantity of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// `*NODE PRINT`, U.
    Displacement,
    /// `*NODE PRINT`, V, in explicit steps.
    Velocity,
    /// `*NODE PRINT`, RF.
    Reaction,
    /// `*EL PRINT`, S.
    Stress,
    /// `*EL PRINT`, E.
    Strain,
    /// `*CONTACT PRINT`, CSTRESS.
    ContactStress,
    /// `*CONTACT PRINT`, CDISP.
    ContactDisplacement,
    /// `*CONTACT PRINT`, CF, CFN or CFS: total force of a pair.
    ContactForce {
        /// Names of its secondary and main surface; `None`: every pair.
        pair: Option<[String; 2]>,
        /// CF, CFN or CFS.
        part: ForcePart,
    },
}

/// Which part of a total contact force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForcePart {
    /// All of it.
    Total,
    /// From the pressure.
    Normal,
    /// From the shear.
    Shear,
}

#[cfg(test)]
mod tests {
    use super::Frames;

    /// Numbers of the increments, of ten in a step of 1, that are stored.
    fn stored(frames: Frames) -> Vec<usize> {
        let times = |i: usize| [(i - 1) as f64 * 0.1, if i == 10 { 1.0 } else { i as f64 * 0.1 }];
        (1..=10).filter(|&i| frames.hold(i, times(i), 1.0)).collect()
    }

    #[test]
    fn frames_come_with_the_increment_that_reaches_their_time() {
        assert_eq!(stored(Frames::Increments(3)), [3, 6, 9, 10]);
        assert_eq!(stored(Frames::Increments(0)), [10]);
        assert_eq!(stored(Frames::Parts(4)), [3, 5, 8, 10]);
        assert_eq!(stored(Frames::Parts(10)), [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
        assert_eq!(stored(Frames::Time(0.45)), [5, 9, 10]);
    }

    /// Step times at which intervals end in a step of so long a period.
    fn ends(frames: Frames, period: f64) -> Vec<f64> {
        std::iter::successors(Some(0.0), |&time| Some(frames.end(time, period)).filter(|_| time < period)).collect()
    }

    #[test]
    fn intervals_end_once_each_and_with_the_step() {
        assert_eq!(ends(Frames::Time(0.45), 1.0), [0.0, 0.45, 0.9, 1.0]);
        assert_eq!(ends(Frames::Increments(3), 1.0), [0.0, 1.0]);
        for parts in 1..200 {
            assert_eq!(ends(Frames::Parts(parts), 0.7).len(), parts + 1);
            assert_eq!(ends(Frames::Time(0.7 / parts as f64), 0.7).len(), parts + 1);
        }
    }
}
