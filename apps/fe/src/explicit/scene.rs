//! From a model to what acts in explicit steps.

use super::mass_scaling::{self, Factors};
use super::{contact, explicit, general};
use crate::course::Course;
use crate::job::JobFailure;
use fe_contact::explicit::{Adjusted, ContactPair, GeneralContact, PairSides, RigidFollower};
use fe_contact::pair;
use fe_core::Freedoms;
use fe_core::element::{ElementType, Family};
use fe_core::explicit::ExplicitTerm;
use fe_core::explicit::beam;
use fe_core::explicit::line::Lines;
use fe_core::explicit::loads::Loads;
use fe_core::explicit::mass_damping::MassDamping;
use fe_core::explicit::solid::{self, Hourglass, SolidSection, Solids};
use fe_core::external::ExternalForces;
use fe_core::section::{self, HourglassControl};
use fe_core::step::{Explicit, IncrementChoice};
use fe_core::structure::{LineSection, Structure};
use fe_io::Model;
use fe_io::model::{ActivePair, Step};
use fe_mesh::CellId;
use std::sync::Arc;

/// What general contact is made of: what the deck says of it, and the pairs that act beside it.
type General = (pair::GeneralContact, Vec<ActivePair>);

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
    /// Damping of materials by mass, if any.
    pub damping: Option<MassDamping>,
    /// Loads of the present step.
    pub loads: Loads,
    /// The pairs that act in it, one after the other, with what they were made of.
    pub pairs: Vec<(ActivePair, PairSides)>,
    /// The general contact that acts in it, with what it was made of.
    pub general: Option<(General, GeneralContact)>,
    /// What general contact of the first step has moved out of overclosures.
    pub adjusted: Option<Adjusted>,
    /// Energies [F L] that contact took which acts no more: all of it, and by friction.
    left: [f64; 2],
    /// Rigid bodies with the nodes that follow them.
    pub followers: Vec<RigidFollower>,
    /// Factors on the masses of elements.
    pub factors: Factors,
    /// Masses of all translations, added up [M], without these factors.
    unscaled: f64,
}

impl Scene {
    /// At rest before the first step.
    pub fn new(model: &Model, first: &Explicit) -> Result<Self, JobFailure> {
        model.steps.iter().try_for_each(|step| contact::refuse_the_rest(model, step))?;
        let mut structure = Arc::clone(&model.structure);
        let freedoms = structure.freedoms(&model.references());
        let followers = contact::followers(&structure, &model.rigid_bodies);
        let adjusted = general::adjusted(&mut structure, &freedoms, model, &followers);
        let sections = sections(&structure, first)?;
        let solids = (!sections.is_empty()).then(|| Solids::new(&structure, &freedoms, &sections));
        let lines = Lines::new(&structure, &freedoms, first.bulk_viscosity[0]);
        let lines = (!lines.is_empty()).then_some(lines);
        let mut damping = vec![0.0; freedoms.len()];
        solids.iter().for_each(|solids| solids.add_mass_damping(&mut damping));
        lines.iter().for_each(|lines| lines.add_mass_damping(&mut damping));
        let damping = MassDamping::new(&damping);
        let loads = Loads::new(ExternalForces::default(), 1.0);
        let (pairs, left) = (Vec::new(), [0.0; 2]);
        let mut mass = vec![0.0; freedoms.len()];
        solids.iter().for_each(|solids| solids.add_mass(&mut mass));
        lines.iter().for_each(|lines| lines.add_mass(&mut mass));
        let unscaled = translating(&freedoms, &mass);
        Ok(Scene {
            structure,
            freedoms,
            solids,
            lines,
            damping,
            loads,
            pairs,
            general: None,
            adjusted,
            left,
            followers,
            factors: Factors::default(),
            unscaled,
        })
    }

    /// Enters a step whose loads are in `course`.
    pub fn enter(&mut self, model: &Model, step: &Step, course: &Course) -> Result<(), JobFailure> {
        let loads = course
            .following(&self.structure, &self.freedoms)
            .map_err(|error| JobFailure::Deck(format!("{}:{}: {error}", step.place.file, step.place.line)))?;
        let Explicit { increment, bulk_viscosity: viscosity, .. } = explicit(step).expect("all steps are explicit");
        if let Some(solids) = &mut self.solids {
            solids.damp(viscosity);
            solids.together(increment == IncrementChoice::Global);
        }
        self.lines.iter_mut().for_each(|lines| lines.damp(viscosity[0]));
        self.solids.iter_mut().for_each(|solids| solids.measure(mass_scaling::aims(step)));
        let worked = self.loads.stored();
        self.loads = loads.after(worked);
        // What acts as before goes on with its state.
        let mut before = std::mem::take(&mut self.pairs);
        for active in &step.explicit_pairs {
            let kept = before.iter().position(|(was, _)| was == active);
            let sides = match kept {
                Some(kept) => before.remove(kept).1,
                None => contact::sides(self, model, active),
            };
            self.pairs.push((*active, sides));
        }
        for pair in before.iter().flat_map(|(_, sides)| &sides.pairs) {
            self.leave([pair.stored(), pair.rubbed()]);
        }
        // Pairs are left to themselves: general contact changes with them.
        let now = step.general_contact.clone().map(|contact| (contact, step.explicit_pairs.clone()));
        if self.general.as_ref().map(|(was, _)| was) != now.as_ref() {
            if let Some((_, general)) = self.general.take() {
                self.leave([general.stored(), general.rubbed()]);
            }
            let general = general::general(self, model, step);
            self.general = now.zip(general);
        }
        Ok(())
    }

    /// General contact, where it acts.
    pub fn general(&self) -> Option<&GeneralContact> {
        self.general.as_ref().map(|(_, general)| general)
    }

    /// All pairs that act.
    pub fn contacts(&self) -> impl Iterator<Item = &ContactPair> {
        self.pairs.iter().flat_map(|(_, sides)| &sides.pairs)
    }

    /// How many of [`Self::terms`], the last ones, are contact.
    pub fn contact_terms(&self) -> usize {
        self.pairs.len() + usize::from(self.general.is_some())
    }

    /// Nodes that follow rigid bodies.
    pub fn following(&self) -> usize {
        self.followers.iter().map(|follower| follower.nodes.len()).sum()
    }

    /// Keeps the energies of contact that acts no more.
    fn leave(&mut self, energies: [f64; 2]) {
        (0..2).for_each(|k| self.left[k] += energies[k]);
    }

    /// Energies [F L] that contact has taken from the motion so far: besides friction, and by it.
    pub fn contact_energies(&self) -> [f64; 2] {
        let of_pairs = self.contacts().map(|pair| [pair.stored(), pair.rubbed()]);
        let of_general = self.general().map(|general| [general.stored(), general.rubbed()]);
        let [all, rubbed] = of_pairs.chain(of_general).fold(self.left, |[a, r], [all, rubbed]| [a + all, r + rubbed]);
        [all - rubbed, rubbed]
    }

    /// Stable increments [T] of the elements by themselves, without factors on their masses, where the step asks for them.
    pub fn increments(&self) -> impl Iterator<Item = (CellId, f64)> + '_ {
        let solids = self.solids.iter().flat_map(|solids| solids.increments());
        solids.chain(self.lines.iter().flat_map(|lines| lines.increments()))
    }

    /// DMASS: what the factors on masses have added to all mass [%].
    pub fn added_mass(&self, mass: &[f64]) -> f64 {
        if self.factors.raised().0 == 0 {
            0.0
        } else {
            100.0 * (translating(&self.freedoms, mass) / self.unscaled - 1.0)
        }
    }

    /// All terms: elements, loads, then contact.
    pub fn terms(&mut self) -> Vec<&mut dyn ExplicitTerm> {
        let mut terms: Vec<&mut dyn ExplicitTerm> = Vec::new();
        terms.extend(self.solids.as_mut().map(|solids| solids as &mut dyn ExplicitTerm));
        terms.extend(self.lines.as_mut().map(|lines| lines as &mut dyn ExplicitTerm));
        terms.extend(self.damping.as_mut().map(|damping| damping as &mut dyn ExplicitTerm));
        terms.push(&mut self.loads);
        terms.extend(self.pairs.iter_mut().map(|(_, sides)| sides as &mut dyn ExplicitTerm));
        terms.extend(self.general.as_mut().map(|(_, general)| general as &mut dyn ExplicitTerm));
        terms
    }
}

/// Masses of all translations, added up [M].
fn translating(freedoms: &Freedoms, mass: &[f64]) -> f64 {
    (0..mass.len()).filter(|&f| freedoms.component(f) < 3).map(|f| mass[f]).sum()
}

/// The solids of each section; elements that explicit steps do not have are refused by name.
fn sections<'a>(structure: &'a Structure, step: &Explicit) -> Result<Vec<SolidSection<'a>>, JobFailure> {
    let mut out = Vec::new();
    for section in &structure.sections {
        let material = &structure.materials[section.material];
        if !solid::has(section.element) {
            let there: Vec<&str> =
                ElementType::ALL.into_iter().filter(|element| solid::has(*element)).map(ElementType::name).collect();
            let (element, there) = (section.element.name(), there.join(", "));
            return Err(JobFailure::Deck(format!(
                "error: elements {element} of material {} are not there in explicit steps yet\nhelp: there are {there}",
                material.name
            )));
        }
        out.push(SolidSection {
            element: section.element,
            cells: &section.cells,
            response: &material.response,
            density: material.density.unwrap_or(0.0),
            thickness: section.thickness,
            damping: material.damping,
            hourglass: hourglass(section.hourglass),
            viscosity: step.bulk_viscosity,
        });
    }
    let missing = |section: &&LineSection| section.element.family() == Family::Beam && !beam::has(section.element);
    if let Some(section) = structure.lines.iter().find(missing) {
        return Err(JobFailure::Deck(format!(
            "error: beams {} of {} are not there in explicit steps\nhelp: B21 and B31 are there",
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
