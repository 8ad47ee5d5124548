//! From a model to what acts in explicit steps.

use crate::course::Course;
use crate::job::JobFailure;
use fe_core::Freedoms;
use fe_core::element::{ElementType, Family};
use fe_core::explicit::ExplicitTerm;
use fe_core::explicit::line::Lines;
use fe_core::explicit::loads::Loads;
use fe_core::explicit::solid::{Flow, Hourglass, SolidSection, Solids};
use fe_core::external::ExternalForces;
use fe_core::material::{Material, Response};
use fe_core::section::{self, HourglassControl};
use fe_core::step::Explicit;
use fe_core::structure::Structure;
use fe_io::Model;
use fe_io::model::Step;
use std::sync::Arc;

/// What goes through all explicit steps of a job.
pub struct Scene {
    /// Bodies.
    pub structure: Arc<Structure>,
    /// Freedoms of all nodes.
    pub freedoms: Freedoms,
    /// Solids, if any.
    pub solids: Option<Solids>,
    /// Trusses, springs, dashpots, masses, if any.
    pub lines: Option<Lines>,
    /// Loads of the present step.
    pub loads: Loads,
}

impl Scene {
    /// At rest before the first step.
    pub fn new(model: &Model, first: &Explicit) -> Result<Self, JobFailure> {
        let structure = Arc::clone(&model.structure);
        let freedoms = structure.freedoms(&model.references());
        let sections = sections(&structure, first)?;
        let solids = (!sections.is_empty()).then(|| Solids::new(&structure, &freedoms, &sections));
        let lines = Lines::new(&structure, &freedoms, first.bulk_viscosity[0]);
        let lines = (!lines.is_empty()).then_some(lines);
        Ok(Scene { structure, freedoms, solids, lines, loads: Loads::new(ExternalForces::default(), 1.0) })
    }

    /// Enters a step whose loads are in `course`.
    pub fn enter(&mut self, step: &Step, course: &Course) -> Result<(), JobFailure> {
        let external = course
            .external(&self.structure, &self.freedoms)
            .map_err(|error| JobFailure::Deck(format!("{}:{}: {error}", step.place.file, step.place.line)))?;
        let worked = self.loads.stored();
        self.loads = Loads::new(external, step.procedure.period()).after(worked);
        Ok(())
    }

    /// All terms: elements, loads, then contact.
    pub fn terms(&mut self) -> Vec<&mut dyn ExplicitTerm> {
        let mut terms: Vec<&mut dyn ExplicitTerm> = Vec::new();
        terms.extend(self.solids.as_mut().map(|solids| solids as &mut dyn ExplicitTerm));
        terms.extend(self.lines.as_mut().map(|lines| lines as &mut dyn ExplicitTerm));
        terms.push(&mut self.loads);
        terms
    }
}

/// The solids of each section; elements that explicit steps do not have are refused by name.
fn sections<'a>(structure: &'a Structure, step: &Explicit) -> Result<Vec<SolidSection<'a>>, JobFailure> {
    const THERE: [ElementType; 2] = [ElementType::C3D4, ElementType::C3D8R];
    let mut out = Vec::new();
    for section in &structure.sections {
        let material = &structure.materials[section.material];
        if !THERE.contains(&section.element) {
            let (element, there) = (section.element.name(), THERE.map(ElementType::name).join(" and "));
            return Err(JobFailure::Deck(format!(
                "error: elements {element} of material {} are not there in explicit steps yet\nhelp: there are {there}",
                material.name
            )));
        }
        out.push(SolidSection {
            element: section.element,
            cells: &section.cells,
            flow: flow(material)?,
            density: material.density.unwrap_or(0.0),
            hourglass: hourglass(section.hourglass),
            viscosity: step.bulk_viscosity,
        });
    }
    if let Some(section) = structure.lines.iter().find(|section| section.element.family() == Family::Beam) {
        return Err(JobFailure::Deck(format!(
            "error: beams {} of {} are not there in explicit steps yet\nhelp: there are trusses",
            section.element.name(),
            section.name
        )));
    }
    Ok(out)
}

/// Resistance to hourglass motion: what blocks of cubes need to bend, unless the deck says otherwise; stiffness 0.05 of 2μ V tr A
/// (Flanagan and Belytschko), viscosity a tenth of what is critical.
fn hourglass(control: Option<section::Hourglass>) -> Hourglass {
    match control.map(|h| (h.control, h.scale)) {
        None => Hourglass::Enhanced(1.0),
        Some((HourglassControl::Enhanced, scale)) => Hourglass::Enhanced(scale),
        Some((HourglassControl::Stiffness, scale)) => Hourglass::Stiffness(0.05 * scale),
        Some((HourglassControl::Viscous, scale)) => Hourglass::Viscous(0.1 * scale),
    }
}

fn flow(material: &Material) -> Result<Flow, JobFailure> {
    let (elastic, hardening) = match &material.response {
        Response::Elastic(elastic) => (elastic, None),
        Response::Plastic { elastic, hardening } => (elastic, Some(hardening.clone())),
        Response::NeoHooke(_) => {
            return Err(JobFailure::Deck(format!(
                "error: *HYPERELASTIC of material {} is not there in explicit steps yet\nhelp: *ELASTIC and *PLASTIC are there",
                material.name
            )));
        }
    };
    Ok(Flow { lambda: elastic.lambda(), mu: elastic.mu(), hardening })
}
