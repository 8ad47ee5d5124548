//! Pressure–overclosure laws: one gap in; energy, pressure and stiffness out.

pub mod linear;

use std::fmt::Debug;
use std::sync::Arc;

/// What a law answers at a gap g [L], positive when open: ψ [F/L], p = −dψ/dg [F/L²], k = d²ψ/dg² [F/L³]
/// (each times L² where no area is defined, times L where only a length is).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NormalResponse {
    /// Energy ψ per area.
    pub energy: f64,
    /// Pressure p, positive in compression.
    pub pressure: f64,
    /// Stiffness k = −dp/dg, not negative; at a kink that of the closed side.
    pub stiffness: f64,
}

/// A pressure–overclosure law.
pub trait NormalLaw: Debug + Send + Sync {
    /// The answer at a gap [L].
    fn respond(&self, gap: f64) -> NormalResponse;

    /// Clearance [L] from which on the law is zero.
    fn reach(&self) -> f64 {
        0.0
    }
}

/// One number on a law's data line: from it come the reader, its messages and the manual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// Name in messages.
    pub name: &'static str,
    /// Dimension, say `F/L³`.
    pub dimension: &'static str,
    /// What it means, in one line.
    pub meaning: &'static str,
    /// Value when left blank; `None`: it must be given.
    pub default: Option<f64>,
    /// Smallest allowed value, itself excluded.
    pub above: f64,
}

/// A law as decks name it.
#[derive(Clone, Copy, Debug)]
pub struct LawDefinition {
    /// Value of `PRESSURE-OVERCLOSURE=`, capitals.
    pub keyword: &'static str,
    /// One line for the manual, with the formula.
    pub summary: &'static str,
    /// Where the formula is from.
    pub source: &'static str,
    /// The data line.
    pub data: &'static [Datum],
    /// Builds the law from the data, already checked against `data`.
    pub build: fn(&[f64]) -> Arc<dyn NormalLaw>,
}

/// The laws that decks may name.
#[derive(Clone, Debug)]
pub struct Laws(pub Vec<LawDefinition>);

impl Laws {
    /// The laws of this crate.
    pub fn standard() -> Self {
        Laws(vec![linear::DEFINITION])
    }

    /// One more law.
    pub fn with(mut self, law: LawDefinition) -> Self {
        self.0.push(law);
        self
    }

    /// By keyword, capitals.
    pub fn find(&self, keyword: &str) -> Option<&LawDefinition> {
        self.0.iter().find(|l| l.keyword == keyword)
    }
}
