//! The plan of a step: what it needs, and what it does not. What is not on it does not exist in memory.

use crate::approach::{FreeBody, in_words};
use crate::terms::Terms;
use fe_contact::pair::{Discretization, Pair};
use fe_core::linear::Cost;
use fe_core::term::Term;
use fe_io::model::Step;
use std::fmt;

/// What one step needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Unknown freedoms.
    pub unknowns: usize,
    /// Prescribed freedoms.
    pub prescribed: usize,
    /// Nodes without a freedom (of no element).
    pub idle_nodes: usize,
    /// What the step needs, (subject, words).
    pub needs: Vec<(String, String)>,
    /// What it does without, and why.
    pub leaves_out: Vec<String>,
}

impl Plan {
    /// Of a step with so many prescribed freedoms and loads; `cost` of its factorisation where there is a matrix.
    pub fn of(terms: &Terms, step: &Step, prescribed: usize, cost: Option<Cost>, free: &[FreeBody]) -> Self {
        let freedoms = &terms.freedoms;
        let unknowns = freedoms.len() - prescribed;
        let mut needs = Vec::new();
        let i = step.increments;
        let kind = if i.fixed { "fixed" } else { "automatic" };
        needs.push(("procedure".into(), format!("static, {kind} increments from {} of {}", i.initial, i.period)));
        for section in &terms.structure.sections {
            let material = &terms.structure.materials[section.material];
            let (count, element) = (section.cells.len(), section.element.name());
            needs.push(("solids".into(), format!("{count} {element} of {}, linear", material.name)));
        }
        needs.push(("unknowns".into(), format!("{unknowns}, and {prescribed} prescribed freedoms")));
        if let Some(cost) = cost {
            let memory = 8e-6 * cost.factor_entries as f64;
            let [work, again] = [cost.flops, cost.flops_again].map(|flops| 1e-9 * flops);
            let changes = if again > 0.0 { format!(", {again:.3} where contact has changed") } else { "".into() };
            needs.push((
                "matrix".into(),
                format!("symmetric positive definite; factor {memory:.1} MB, {work:.3} Gflop{changes}"),
            ));
        }
        for pair in &terms.pairs {
            needs.push(("contact pair".into(), pair_in_words(pair)));
        }
        for body in free {
            let body_of = &terms.bodies[body.body];
            let motions: Vec<String> = body.motions.iter().map(|m| in_words(m, body_of.size)).collect();
            let how = if body.touched { "held by contact alone" } else { "held by nothing" };
            needs.push((terms.body_name(body_of), format!("{how}: free {}", motions.join(", "))));
        }
        let idle_nodes = (0..freedoms.nodes()).filter(|&n| freedoms.of_node(n).is_empty()).count();
        Plan { unknowns, prescribed, idle_nodes, needs, leaves_out: leaves_out(terms, unknowns) }
    }

    /// The step in half a line.
    pub fn headline(&self) -> String {
        let matrix = self.needs.iter().find(|n| n.0 == "matrix").map(|n| n.1.as_str());
        format!("{} unknowns, {}", self.unknowns, matrix.unwrap_or("no matrix"))
    }
}

/// A pair, its constraint and its stiffness with units.
fn pair_in_words(pair: &Pair) -> String {
    let s = pair.summary();
    let how = match s.discretization {
        Discretization::NodeToSurface => "node to surface",
        Discretization::SurfaceToSurface => "surface to surface",
    };
    let dimension = s.measure.stiffness_dimension();
    let law = match s.penalty {
        Some(p) => {
            let origin = if p.by_default { "ten times the elements beneath" } else { "as given" };
            format!("hard by penalty, {:.6e} {dimension} ({origin}, scale {})", p.stiffness, p.scale)
        }
        None => format!("softened, {:?}", pair.law()),
    };
    let (name, points, number) = (pair.name(), s.points, s.measure.words());
    format!("{name}: {how}, {points} points, {law}; the law's number is a {number}")
}

fn leaves_out(terms: &Terms, unknowns: usize) -> Vec<String> {
    let mut out = Vec::new();
    if unknowns == 0 {
        out.push("matrix and solver: every freedom is prescribed".into());
    }
    if terms.pairs.is_empty() {
        out.push("contact: no pair".into());
    } else {
        if terms.pairs.iter().all(|p| p.has_rigid_main()) {
            out.push("contact search: every main surface is rigid".into());
        }
        out.push("multipliers: a penalty or a law carries the contact".into());
        out.push("friction and an unsymmetric matrix: no interaction has friction".into());
    }
    if terms.pairs.iter().all(|p| p.history() == 0) {
        out.push("history: no term has a state".into());
    }
    out.push("stiffness of the solids per iteration: they are linear, it is assembled once".into());
    out.push("mass and velocity: the step is static".into());
    out
}

impl fmt::Display for Plan {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        writeln!(out, "  needs")?;
        for (subject, words) in &self.needs {
            writeln!(out, "    {subject:<14} {words}")?;
        }
        writeln!(out, "  leaves out")?;
        for words in &self.leaves_out {
            writeln!(out, "    {words}")?;
        }
        if self.idle_nodes > 0 {
            writeln!(out, "    {} nodes of no element", self.idle_nodes)?;
        }
        Ok(())
    }
}
