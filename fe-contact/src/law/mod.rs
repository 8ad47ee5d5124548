//! Pressure–overclosure laws: one gap in; energy, pressure and stiffness out.

pub mod exponential;
pub mod formula;
pub mod linear;
pub mod nonlinear_penalty;
pub mod scale_factor;
pub mod series;
pub mod tabular;

use crate::summary::MeasureKind;
use std::fmt::Debug;
use std::ops::Range;
use std::sync::Arc;

/// What a law answers at a gap g [L], positive when open: ψ [F/L], p = −dψ/dg [F/L²], k = d²ψ/dg² [F/L³]
/// (each times L² where no area is defined, times L where only a length is).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NormalResponse {
    /// Energy ψ per area.
    pub energy: f64,
    /// Pressure p, positive in compression.
    pub pressure: f64,
    /// Stiffness k = −dp/dg, at a kink that of the closed side; negative only where a law remarks that its pressure
    /// falls.
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

    /// Gaps [L] in a range, besides the reach, where the stiffness jumps.
    fn kinks(&self, _range: Range<f64>) -> Vec<f64> {
        Vec::new()
    }

    /// A stiffness [F/L³] of its size: what Newton's method takes where contact holds a body and the law itself has
    /// none, at first touch or on a plateau.
    fn typical_stiffness(&self) -> f64 {
        self.respond(self.reach()).stiffness
    }

    /// The largest stiffness [F/L³] that it has anywhere.
    fn steepest(&self) -> f64 {
        f64::INFINITY
    }

    /// Itself with its numbers and their units, in a line.
    fn words(&self, _number: MeasureKind) -> String {
        format!("{self:?}")
    }

    /// What a user should know of these numbers, a line each: a jump, a falling pressure.
    fn remarks(&self) -> Vec<String> {
        Vec::new()
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
    /// Value when left blank, and in words; `None`: it must be given.
    pub default: Option<(f64, &'static str)>,
    /// Smallest allowed value, itself excluded.
    pub above: f64,
    /// Smallest allowed value.
    pub least: f64,
    /// It has an effect in Explicit only.
    pub explicit: bool,
}

impl Datum {
    /// Any number.
    pub const fn number(name: &'static str, dimension: &'static str, meaning: &'static str) -> Self {
        let (above, least) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        Datum { name, dimension, meaning, default: None, above, least, explicit: false }
    }

    /// A number > 0.
    pub const fn positive(name: &'static str, dimension: &'static str, meaning: &'static str) -> Self {
        Datum { above: 0.0, ..Datum::number(name, dimension, meaning) }
    }

    /// At least this.
    pub const fn least(self, least: f64) -> Self {
        Datum { least, ..self }
    }

    /// It may be left blank and is then this value, in words `blank`.
    pub const fn or(self, value: f64, blank: &'static str) -> Self {
        Datum { default: Some((value, blank)), ..self }
    }

    /// It has an effect in Explicit only: other procedures take the default.
    pub const fn explicit(self) -> Self {
        Datum { explicit: true, ..self }
    }
}

/// How many data lines a law has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// One.
    One,
    /// So many or more, all alike.
    AtLeast(usize),
}

/// A law, or what is wrong with its numbers.
pub type Built = Result<Arc<dyn NormalLaw>, String>;

/// A law as decks name it.
#[derive(Clone, Copy, Debug)]
pub struct LawDefinition {
    /// Value of `PRESSURE-OVERCLOSURE=`, capitals.
    pub keyword: &'static str,
    /// One line for the manual, with the formula.
    pub summary: &'static str,
    /// Where the formula is from.
    pub source: &'static str,
    /// The numbers on a data line.
    pub data: &'static [Datum],
    /// The data lines.
    pub lines: Lines,
    /// Numbers of an example, line after line, with lengths of order 1: the law is checked with them.
    pub example: &'static [f64],
    /// Builds the law from the numbers, line after line, each already checked against `data`; what is wrong with them
    /// together is said.
    pub build: fn(&[f64]) -> Built,
}

/// The laws that decks may name.
#[derive(Clone, Debug)]
pub struct Laws(pub Vec<LawDefinition>);

impl Laws {
    /// The laws of this crate.
    pub fn standard() -> Self {
        Laws(vec![linear::DEFINITION, exponential::DEFINITION, tabular::DEFINITION])
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

/// ∫p dh from −reach to h by Gauss's rule with 12 points on each of `parts` pieces between kinks: for tests.
#[cfg(test)]
pub(crate) fn work_by_quadrature(law: &dyn NormalLaw, overclosure: f64, parts: usize) -> f64 {
    let range = -overclosure..law.reach();
    let mut ends = law.kinks(range.clone());
    ends.extend([range.start, range.end]);
    ends.sort_by(f64::total_cmp);
    let rule = fe_mesh::quadrature::Rule::line(12).points;
    let mut work = 0.0;
    for two in ends.windows(2) {
        let width = (two[1] - two[0]) / parts as f64;
        for i in 0..parts {
            let middle = two[0] + width * (i as f64 + 0.5);
            let at = |x: f64| law.respond(middle + 0.5 * width * x).pressure;
            work += rule.iter().map(|(x, w)| 0.5 * width * w * at(x[0])).sum::<f64>();
        }
    }
    work
}
