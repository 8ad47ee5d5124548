//! `*FIXED MASS SCALING` and `*VARIABLE MASS SCALING`.

use super::scene::Scene;
use crate::deck::card::Token;
use crate::deck::number::number;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_core::element::Family;
use fe_core::step::{MassScaling, ScaledAt, ScaledTo};
use fe_mesh::CellId;

/// The mass scaling in force. That of one kind of card holds until a step has such a card.
#[derive(Clone, Debug, Default)]
pub struct InForce {
    /// Each with its kind of card.
    items: Vec<(&'static str, MassScaling)>,
    /// Kinds of cards seen in this step.
    seen: Vec<&'static str>,
}

impl InForce {
    /// A step begins.
    pub fn begin_step(&mut self) {
        self.seen.clear();
    }

    /// What holds after the cards of a step.
    pub fn in_force(&self) -> Vec<MassScaling> {
        self.items.iter().map(|(_, scaling)| scaling.clone()).collect()
    }

    /// Reads one more card.
    pub fn read(&mut self, entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
        let kind = entry.keyword.name;
        if !self.seen.contains(&kind) {
            self.seen.push(kind);
            self.items.retain(|(of, _)| *of != kind);
        }
        let before = diagnostics.faults();
        let factor = positive(entry, "FACTOR", diagnostics);
        let target = target(entry, diagnostics);
        let when = when(entry, diagnostics);
        if factor.is_none() && target.is_none() && diagnostics.faults() == before {
            let fault = Diagnostic::error(entry.card.span, format!("this `*{kind}` scales nothing"));
            let factor = if kind == "FIXED MASS SCALING" { "`FACTOR=…`, or " } else { "" };
            diagnostics.push(fault.help(format!("say {factor}`DT=…, TYPE=BELOW MIN`")));
        }
        let cells = cells(entry, scene, diagnostics);
        if diagnostics.faults() == before {
            self.items.push((kind, MassScaling { cells, factor: factor.unwrap_or(1.0), target, when }));
        }
    }
}

/// A parameter's number, which must be above 0.
fn positive(entry: &Entry<'_>, name: &str, diagnostics: &mut Diagnostics) -> Option<f64> {
    let value = entry.value(name)?;
    let found = number(&value.text)?;
    if found <= 0.0 {
        let title = format!("`{name}` of `*{}` must be > 0", entry.keyword.name);
        diagnostics.push(Diagnostic::error(value.span, title));
    }
    Some(found)
}

fn target(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> Option<(f64, ScaledTo)> {
    let increment = positive(entry, "DT", diagnostics);
    let to = entry.name("TYPE").map(|word| match word.as_str() {
        "UNIFORM" => ScaledTo::Uniform,
        "SET EQUAL DT" => ScaledTo::EqualIncrement,
        _ => ScaledTo::BelowMinimum,
    });
    let one = if entry.has("DT") { ("DT", "TYPE") } else { ("TYPE", "DT") };
    if let (true, Some(parameter)) = (entry.has("DT") != entry.has("TYPE"), entry.parameter(one.0)) {
        let fault =
            Diagnostic::error(parameter.span, format!("`{}` of `*{}` needs `{}=`", one.0, entry.keyword.name, one.1));
        diagnostics.push(fault);
    }
    increment.zip(to)
}

fn when(entry: &Entry<'_>, diagnostics: &mut Diagnostics) -> ScaledAt {
    if entry.keyword.name == "FIXED MASS SCALING" {
        return ScaledAt::Start;
    }
    let every = positive(entry, "FREQUENCY", diagnostics).map(|n| ScaledAt::Increments(n as usize));
    let parts = positive(entry, "NUMBER INTERVAL", diagnostics).map(|n| ScaledAt::Parts(n as usize));
    if every.is_some() == parts.is_some() {
        let fault = Diagnostic::error(entry.card.span, "`*VARIABLE MASS SCALING` does not say when");
        diagnostics.push(fault.help("say `FREQUENCY=` or `NUMBER INTERVAL=`, one of them"));
    }
    every.or(parts).unwrap_or(ScaledAt::Start)
}

/// Cells that have a mass of their own, ascending.
fn cells(entry: &Entry<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Vec<CellId> {
    let heavy =
        |cell: &CellId| matches!(scene.element_of(*cell).family(), Family::Solid | Family::Truss | Family::Beam);
    let Some(elset) = entry.value("ELSET") else { return scene.structure.mesh.cells().filter(heavy).collect() };
    let token = Token { text: &elset.text, span: elset.span };
    let Some(set) = scene.cell_set(token, diagnostics) else { return Vec::new() };
    let mut cells: Vec<CellId> = set.iter().copied().filter(heavy).collect();
    cells.sort_unstable();
    cells.dedup();
    if cells.is_empty() {
        let fault = Diagnostic::error(elset.span, "no element of this set has a density");
        diagnostics.push(fault.label("solids, trusses and beams have one"));
    }
    cells
}
