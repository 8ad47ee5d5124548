//! The plan of a step: what it needs, and what it does not. What is not on it does not exist in memory.

use crate::approach::{FreeBody, in_words};
use crate::terms::Terms;
use fe_contact::contact::Contact;
use fe_contact::friction::{Coefficient, Coulomb, Spring};
use fe_contact::pair::Discretization;
use fe_contact::redundant::redundant;
use fe_contact::summary::{Means, Origin};
use fe_contact::viscous::Damping;
use fe_core::element::{ElementType, Family};
use fe_core::linear::Cost;
use fe_core::matrix::Pattern;
use fe_core::step::Procedure;
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

/// What the matrix of a step takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix {
    /// Of its factorisation.
    pub cost: Cost,
    /// Memory of its values [bytes].
    pub values: usize,
    /// Memory of its pattern [bytes].
    pub pattern: usize,
}

/// Matrices that stand side by side where terms are not linear: the stiffness of the linear terms, the tangent, and the
/// one that was factored last, which tells whether the tangent changed.
const MATRICES: usize = 3;

impl Matrix {
    /// With this pattern.
    pub fn of(pattern: &Pattern, cost: Cost) -> Self {
        Matrix { cost, values: 8 * pattern.values(), pattern: pattern.bytes() }
    }

    /// How many there are.
    fn count(terms: &Terms) -> usize {
        if terms.all().iter().all(|term| term.is_linear()) { 1 } else { MATRICES }
    }

    /// Memory of matrices, pattern and factor [bytes]. The fronts at work come on top, and go again.
    pub fn memory(&self, terms: &Terms) -> usize {
        8 * self.cost.factor_entries + Self::count(terms) * self.values + self.pattern
    }

    fn in_words(&self, terms: &Terms) -> [(String, String); 2] {
        let factor = size(8 * self.cost.factor_entries);
        let [work, again] = [self.cost.flops, self.cost.flops_again].map(|flops| 1e-9 * flops);
        let changes = if again > 0.0 { format!(", {again:.3} where contact has changed") } else { "".into() };
        let matrix = format!("symmetric positive definite; factor {factor}, {work:.3} Gflop{changes}");
        let (all, count) = (size(self.memory(terms)), Self::count(terms));
        let (values, pattern) = (size(self.values), size(self.pattern));
        let memory = format!("about {all}: factor {factor}, matrix {count} × {values}, pattern {pattern}");
        [("matrix".into(), matrix), ("memory".into(), memory)]
    }
}

/// The procedure of a step.
fn procedure_in_words(procedure: &Procedure) -> String {
    match procedure {
        Procedure::Static { increments: i, .. } => {
            let kind = if i.fixed { "fixed" } else { "automatic" };
            format!("static, {kind} increments from {} of {}", i.initial, i.period)
        }
        Procedure::Explicit(explicit) => format!("explicit, for {}", explicit.period),
    }
}

impl Plan {
    /// Of a step that begins at a displacement `u` with some freedoms prescribed; `matrix` where there is one.
    pub fn of(
        terms: &Terms,
        step: &Step,
        (u, fixed): (&[f64], &[bool]),
        matrix: Option<Matrix>,
        free: &[FreeBody],
    ) -> Self {
        let freedoms = &terms.freedoms;
        let prescribed = fixed.iter().filter(|f| **f).count();
        let unknowns = freedoms.len() - prescribed;
        let mut needs = Vec::new();
        needs.push(("procedure".into(), procedure_in_words(&step.procedure)));
        for section in &terms.structure.sections {
            let material = &terms.structure.materials[section.material];
            let (count, element) = (section.cells.len(), section.element.name());
            needs.push(("solids".into(), format!("{count} {element} of {}, linear", material.name)));
        }
        needs.extend(members_in_words(terms));
        needs.push(("unknowns".into(), format!("{unknowns}, and {prescribed} prescribed freedoms")));
        needs.extend(matrix.iter().flat_map(|matrix| matrix.in_words(terms)));
        for pair in terms.contacts.iter().filter(|pair| pair.acts() && !pair.points.is_empty()) {
            let subject = match pair.summary().origin {
                Origin::Pair(_) => "contact pair",
                Origin::Elements(element) if element.family() == Family::Tube => "tube elements",
                Origin::Elements(_) => "gap elements",
            };
            needs.push((subject.into(), contact_in_words(pair)));
        }
        needs.extend(over_constraint(terms, u, fixed).map(|words| ("over-constraint".into(), words)));
        let damped = terms.contacts.iter().filter_map(|contact| Some((contact, contact.damping()?)));
        needs.extend(damped.map(|(contact, damping)| ("damped".into(), damping_in_words(contact, damping))));
        let stabilized = terms.contacts.iter().filter_map(|contact| Some((contact, contact.stabilization()?)));
        needs.extend(stabilized.map(|(contact, ([across, along], range))| {
            let unit = contact.summary().measure.damping_dimension();
            let words = format!(
                "{}: damping {across:.6e} {unit} across and {along:.6e} {unit} along the surface, up to a clearance of {range:.3e} L",
                contact.name()
            );
            ("stabilised".into(), words)
        }));
        let searched: Vec<usize> = terms.contacts.iter().filter_map(|pair| pair.summary().searched).collect();
        if !searched.is_empty() {
            needs.push((
                "search".into(),
                format!("{} facets, once before the first step", searched.iter().sum::<usize>()),
            ));
        }
        let history: usize = terms.all().iter().map(|term| term.history()).sum();
        if history > 0 {
            let multipliers = if terms.contacts.iter().all(bare) { "" } else { ", a multiplier where there are any" };
            let damped = terms.contacts.iter().any(|contact| contact.damping().is_some());
            let pressures = if damped { ", a viscous pressure where it is damped" } else { "" };
            let rubs = terms.contacts.iter().any(|pair| pair.friction().is_some());
            let friction = if rubs { ", slip and shear where there is friction" } else { "" };
            let words = format!("{history} numbers: a status for each point{multipliers}{friction}{pressures}");
            needs.push(("history".into(), words));
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

/// Multipliers that others, or supports, make superfluous.
fn over_constraint(terms: &Terms, u: &[f64], fixed: &[bool]) -> Option<String> {
    let found = redundant(&terms.contacts, u, fixed);
    let mut labels: Vec<String> = found.iter().map(|r| terms.structure.mesh.point_name(r.node)).collect();
    labels.dedup();
    let shown = &labels[..labels.len().min(SHOWN)];
    let more = if labels.len() > SHOWN { ", …" } else { "" };
    let words = "say at touch what supports or other multipliers say, and share their force";
    (!found.is_empty()).then(|| format!("{} multipliers {words}: nodes {}{more}", found.len(), shown.join(", ")))
}

/// Labels that a list shows.
const SHOWN: usize = 10;

/// Memory [bytes] in words.
fn size(bytes: usize) -> String {
    if bytes < 1_000_000 { format!("{:.1} kB", 1e-3 * bytes as f64) } else { format!("{:.1} MB", 1e-6 * bytes as f64) }
}

/// Trusses, beams and springs with what they are made of.
fn members_in_words(terms: &Terms) -> Vec<(String, String)> {
    let lines = terms.structure.lines.iter().map(|section| {
        let (count, element, name) = (section.cells.len(), section.element.name(), &section.name);
        if section.element.family() == Family::Truss {
            return (
                "trusses".into(),
                format!("{count} {element} of {name}, area {} L², linear", section.profile.area),
            );
        }
        let shear = section.profile.shear_factor;
        let flexible = matches!(section.element, ElementType::B21 | ElementType::B31);
        let shear = if flexible { format!(", shear-flexible with κ = {shear}") } else { String::new() };
        ("beams".into(), format!("{count} {element} of {name}, linear{shear}"))
    });
    let springs = terms.structure.discrete.iter().filter(|section| section.element.family() == Family::Spring);
    let springs = springs.map(|section| {
        let (count, element, stiffness) = (section.cells.len(), section.element.name(), section.magnitude);
        let rotation = section.element != ElementType::SPRINGA && section.components[0] > 2;
        let dimension = if rotation { "F L" } else { "F/L" };
        ("springs".into(), format!("{count} {element}, stiffness {stiffness} {dimension}"))
    });
    lines.chain(springs).collect()
}

/// A contact and its damping with units.
fn damping_in_words(contact: &Contact, damping: &Damping) -> String {
    let (across, unit) = (damping.coefficient, contact.summary().measure.damping_dimension());
    let (along, to) = (damping.tangent_fraction * across, damping.clearance);
    let from = damping.constant_part * to;
    let name = contact.name();
    format!(
        "{name}: damping {across:.6e} {unit} across and {along:.6e} {unit} along the surface up to a clearance of {from:.3e} L, \
         none from {to:.3e} L on"
    )
}

/// A contact, its constraint and its stiffness with units.
fn contact_in_words(pair: &Contact) -> String {
    let s = pair.summary();
    let how = match s.origin {
        Origin::Pair(Discretization::NodeToSurface) => "node to surface",
        Origin::Pair(Discretization::SurfaceToSurface) => "surface to surface",
        Origin::Elements(element) => element.name(),
    };
    let dimension = s.measure.stiffness_dimension();
    let law = match s.penalty {
        Some(p) => {
            let factor = match p.means {
                Means::Penalty => "ten",
                Means::NonlinearPenalty(_) => "a hundred",
                _ => "a thousand",
            };
            let origin = if p.by_default { format!("{factor} times the elements beneath") } else { "as given".into() };
            let penalty = format!("{:.6e} {dimension} ({origin}, scale {})", p.stiffness, p.scale);
            match p.means {
                Means::Penalty => format!("hard by penalty, {penalty}"),
                Means::NonlinearPenalty(_) => {
                    format!("hard by nonlinear penalty, {}; final slope {penalty}", pair.law().words(s.measure))
                }
                Means::AugmentedLagrange(allowed) => {
                    format!(
                        "hard by augmented Lagrange, overclosures up to {allowed:.3e} L are left; penalty {penalty}"
                    )
                }
                Means::Multipliers => format!("hard by multipliers, found by augmenting a penalty of {penalty}"),
                Means::Mixed => {
                    let law = pair.law().words(s.measure);
                    let stuck = match pair.stuck_points() {
                        0 => String::new(),
                        count => format!("; {count} points that prescribed freedoms alone move have none"),
                    };
                    format!("{law}, with multipliers, found by augmenting a penalty of {penalty}{stuck}")
                }
            }
        }
        None => format!("softened, {}", pair.law().words(s.measure)),
    };
    let (name, points, number) = (pair.name(), s.points, s.measure.words());
    let tied = if pair.is_tied() { "tied from the start, in tension too, " } else { "" };
    let friction = pair.friction().map_or(String::new(), |friction| friction_in_words(pair, friction));
    format!("{name}: {how}, {points} points, {tied}{law}{friction}; the law's number is a {number}")
}

/// Friction with what sticking points give way by.
fn friction_in_words(pair: &Contact, law: &Coulomb) -> String {
    let Some((coefficient, largest)) = &law.limit else {
        let how = if pair.sticks_exactly() { "held by multipliers" } else { "held by the penalty" };
        return format!("; rough, {how}: closed points never slip");
    };
    if !pair.rubs() {
        return "; no friction in this step".into();
    }
    let value = coefficient_in_words(coefficient);
    let before = pair.friction_before().map_or(String::new(), |before| match &before.limit {
        Some((before, _)) => format!(" at the end of the step, at its start {}", coefficient_in_words(before)),
        None => ", rough before this step".into(),
    });
    let most = largest.map_or(String::new(), |largest| {
        format!(", the shear at most {largest} {}", pair.summary().measure.dimension())
    });
    let stick = match law.spring {
        Spring::Slip(slip) => format!("sticking points give way by up to {slip:.6e} L"),
        Spring::Stiffness(_) => "sticking points do not move (multipliers)".into(),
    };
    format!("; friction, {value}{before}{most}, {stick}")
}

fn coefficient_in_words(coefficient: &Coefficient) -> String {
    match coefficient {
        Coefficient::Constant(value) => format!("μ = {value}"),
        Coefficient::Table(_) => "μ by slip rate and pressure".into(),
        Coefficient::Between(..) => "μ between two, on the way from one to the other".into(),
        Coefficient::Decay { rest, kinetic, decay } => {
            format!("μ = {kinetic} + {} exp(−{decay} T/L γ̇)", rest - kinetic)
        }
    }
}

/// True where a penalty or a law carries a contact, without multipliers.
fn bare(contact: &Contact) -> bool {
    contact.summary().penalty.is_none_or(|penalty| penalty.means.is_bare())
}

fn leaves_out(terms: &Terms, unknowns: usize) -> Vec<String> {
    let mut out = Vec::new();
    if unknowns == 0 {
        out.push("matrix and solver: every freedom is prescribed".into());
    }
    let (met, idle): (Vec<&Contact>, Vec<&Contact>) = terms.contacts.iter().partition(|pair| !pair.points.is_empty());
    let (met, removed): (Vec<&Contact>, Vec<&Contact>) = met.into_iter().partition(|pair| pair.acts());
    out.extend(removed.iter().map(|pair| format!("contact of {}: removed", pair.name())));
    out.extend(idle.iter().map(|pair| format!("contact of {}: no part of them faces the other", pair.name())));
    if met.is_empty() {
        let none = if terms.contacts.is_empty() { "no pair" } else { "no pair acts" };
        out.push(format!("contact: {none}"));
    } else {
        if met.iter().all(|p| p.summary().searched.is_none()) {
            let pairs = met.iter().any(|p| p.has_rigid_main());
            let why = if pairs { "every main surface is rigid" } else { "contact elements name their nodes" };
            out.push(format!("contact search: {why}"));
        }
        if terms.contacts.iter().all(bare) {
            out.push("multipliers: a penalty or a law carries the contact".into());
        }
        if terms.contacts.iter().all(|pair| !pair.rubs()) {
            let later = terms.contacts.iter().any(|pair| pair.friction().is_some());
            let why = if later { "it comes in a later step, or is gone" } else { "no interaction has friction" };
            out.push(format!("friction and an unsymmetric matrix: {why}"));
        } else {
            out.push(
                "an unsymmetric matrix: what friction adds to the symmetric one is brought in by iteration".into(),
            );
        }
    }
    if terms.contacts.iter().all(|p| p.history() == 0) {
        out.push("history: no term has a state".into());
    }
    for section in &terms.structure.discrete {
        let (count, element) = (section.cells.len(), section.element.name());
        match section.element.family() {
            Family::Dashpot => out.push(format!("{count} {element}: dashpots have no force in a static step")),
            Family::Mass => out.push(format!("{count} {element}: of masses a static step has the weight alone")),
            _ => {}
        }
    }
    if unknowns > 0 {
        out.push("stiffness of the elements per iteration: they are linear, it is assembled once".into());
    }
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
