//! The procedure of a step: time incrementation and convergence controls.

use fe_mesh::CellId;

/// How a step goes from its start to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Procedure {
    /// `*STATIC`: equilibrium at the end of each increment.
    Static {
        /// Increments.
        increments: Increments,
        /// When an increment has converged.
        controls: Controls,
    },
    /// `*DYNAMIC, EXPLICIT`: central differences in time.
    Explicit(Explicit),
}

impl Procedure {
    /// Step time [T].
    pub fn period(&self) -> f64 {
        match self {
            Procedure::Static { increments, .. } => increments.period,
            Procedure::Explicit(explicit) => explicit.period,
        }
    }
}

/// `*DYNAMIC, EXPLICIT` with `*BULK VISCOSITY`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Explicit {
    /// Step time [T].
    pub period: f64,
    /// Where the size of an increment comes from.
    pub increment: IncrementChoice,
    /// Factor on the stable increment [-], > 0; an increment that is given stays as it is.
    pub scale: f64,
    /// Largest increment [T].
    pub largest: Option<f64>,
    /// Linear and quadratic bulk viscosity [-].
    pub bulk_viscosity: [f64; 2],
}

impl Explicit {
    /// Linear and quadratic bulk viscosity unless a deck says otherwise: Abaqus Keywords Reference, *BULK VISCOSITY.
    pub const BULK_VISCOSITY: [f64; 2] = [0.06, 1.2];
}

/// Where the size of an explicit increment comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IncrementChoice {
    /// What is not below the highest frequency of the whole model: of solids that of all together
    /// ([`crate::explicit::solid::Solids::together`]), of members that of the fastest.
    Global,
    /// The highest frequency of any element by itself, which is not below that of the whole model, either.
    ElementByElement,
    /// The deck, [T].
    Fixed(f64),
}

/// `*FIXED MASS SCALING` or `*VARIABLE MASS SCALING`: densities of some cells are raised, so that increments may be longer.
#[derive(Clone, Debug, PartialEq)]
pub struct MassScaling {
    /// The cells, ascending.
    pub cells: Vec<CellId>,
    /// Factor on their masses [-], > 0; what follows comes on top.
    pub factor: f64,
    /// Stable increment of each element [T] that is aimed at, and by which masses.
    pub target: Option<(f64, ScaledTo)>,
    /// When masses are scaled.
    pub when: ScaledAt,
}

/// Which elements a stable increment that is aimed at scales.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaledTo {
    /// Those with a smaller one, each to it.
    BelowMinimum,
    /// All, by the one factor that the element with the least one needs.
    Uniform,
    /// All, each to it; masses may fall.
    EqualIncrement,
}

/// When masses are scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaledAt {
    /// At the start of the step.
    Start,
    /// Every so many increments, and at the start.
    Increments(usize),
    /// At the ends of so many equal parts of the step, and at the start.
    Parts(usize),
}

/// `*STATIC`'s data line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increments {
    /// First increment [T].
    pub initial: f64,
    /// Step time [T].
    pub period: f64,
    /// Smallest increment [T].
    pub minimum: f64,
    /// Largest increment [T].
    pub maximum: f64,
    /// All increments of the first one's size (`DIRECT`).
    pub fixed: bool,
    /// Most increments of the step (`*STEP, INC=`).
    pub most: usize,
}

/// `*CONTROLS`, with the decks' defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controls {
    /// R_n: largest residual over the average force.
    pub residual: f64,
    /// C_n: largest correction over the largest increment.
    pub correction: f64,
    /// R_P: residual after `i_p` iterations.
    pub late_residual: f64,
    /// Largest residual over the largest force that a result may have: ours, on top of the decks' criteria.
    pub balance: f64,
    /// I_0: iterations before divergence is looked for.
    pub i_0: usize,
    /// I_R: iterations before slow convergence is looked for.
    pub i_r: usize,
    /// I_P: iterations before `late_residual` replaces `residual`.
    pub i_p: usize,
    /// I_C: iterations foreseen at most.
    pub i_c: usize,
    /// I_L: more iterations than this shrink the next increment.
    pub i_l: usize,
    /// I_G: at most this many iterations in two increments enlarge the next.
    pub i_g: usize,
    /// I_A: attempts for one increment.
    pub i_a: usize,
    /// I_S: iterations with changes of status, `CONVERT SDI=NO`.
    pub i_s: usize,
    /// Iterations with changes of status, `CONVERT SDI=YES`.
    pub i_s_converted: usize,
    /// `*STEP, CONVERT SDI=`.
    pub convert_sdi: bool,
    /// D_f: factor on the increment when the residual diverges.
    pub d_f: f64,
    /// D_C: factor when convergence is slow.
    pub d_c: f64,
    /// D_B: factor on the next increment after too many iterations.
    pub d_b: f64,
    /// D_S: factor when statuses do not settle.
    pub d_s: f64,
    /// D_D: growth after two easy increments.
    pub d_d: f64,
}

impl Default for Controls {
    fn default() -> Self {
        Controls {
            residual: 5e-3,
            correction: 1e-2,
            late_residual: 2e-2,
            balance: 1e-8,
            i_0: 4,
            i_r: 8,
            i_p: 9,
            i_c: 16,
            i_l: 10,
            i_g: 4,
            i_a: 5,
            i_s: 12,
            i_s_converted: 50,
            convert_sdi: true,
            d_f: 0.25,
            d_c: 0.5,
            d_b: 0.75,
            d_s: 0.25,
            d_d: 1.5,
        }
    }
}
