//! `*CONTACT` with its cards: general contact of explicit steps.

use super::interactions::Interactions;
use super::lines::{at_least_one, fields};
use super::pairs::faces_of;
use super::scene::{Analysis, Scene};
use crate::deck::card::{Token, normalized};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use crate::keyword::row::Row;
use fe_contact::pair::{GeneralContact, Region};

/// The cards.
pub const CARDS: &[&str] = &[
    "CONTACT",
    "CONTACT INCLUSIONS",
    "CONTACT EXCLUSIONS",
    "CONTACT PROPERTY ASSIGNMENT",
    "CONTACT CONTROLS ASSIGNMENT",
];

/// The general contact in force.
#[derive(Clone, Debug, Default)]
pub struct InForce {
    contact: Option<GeneralContact>,
    /// Names of interactions, in the order of the assignments.
    names: Vec<([Region; 2], String)>,
    /// True after `*CONTACT` in the model data or in the present step.
    begun: bool,
}

impl InForce {
    /// A step begins.
    pub fn begin_step(&mut self) {
        self.begun = false;
    }

    /// What holds after the cards of a step, from 0, with the interactions that it finds under their names.
    pub fn in_force(&self, interactions: &Interactions, step: usize) -> Option<GeneralContact> {
        let found =
            |(regions, name): &([Region; 2], String)| Some((regions.clone(), interactions.find_in(name, step)?));
        let interactions = self.names.iter().filter_map(found).collect();
        self.contact.clone().map(|contact| GeneralContact { interactions, ..contact })
    }

    /// Reads one more card.
    pub fn read(
        &mut self,
        entry: &Entry<'_>,
        scene: &Scene<'_>,
        interactions: &Interactions,
        diagnostics: &mut Diagnostics,
    ) {
        if scene.analysis == Analysis::Static {
            let fault = Diagnostic::error(entry.card.span, format!("`*{}` is for explicit steps", entry.keyword.name));
            diagnostics.push(fault.help("pairs of surfaces are there: `*CONTACT PAIR`"));
            return;
        }
        if entry.keyword.name == "CONTACT" {
            self.begun = true;
            if entry.says("OP", "NEW") {
                (self.contact, self.names) = (None, Vec::new());
            }
            self.contact.get_or_insert_default();
            return;
        }
        if !self.begun {
            let fault =
                Diagnostic::error(entry.card.span, format!("`*{}` stands under no `*CONTACT`", entry.keyword.name));
            diagnostics.push(fault.help("say `*CONTACT` before it"));
        }
        let Some(contact) = &mut self.contact else { return };
        if entry.has("ALL EXTERIOR") {
            contact.inclusions.push([Region::AllExterior, Region::AllExterior]);
            if let Some(line) = scene.deck.lines(entry.card).next() {
                let fault = Diagnostic::error(line.span, "`ALL EXTERIOR` has no data lines");
                diagnostics.push(fault.help("it includes every surface: write `*CONTACT EXCLUSIONS`"));
            }
            return;
        }
        // A blank line of an inclusion stands for all exterior faces.
        let lines = at_least_one(
            scene.deck.all_lines(entry.card),
            entry,
            ("this card names no surfaces", "add a line: first surface, second surface"),
            diagnostics,
        );
        for line in lines {
            let row = Row::read(line, fields(entry), diagnostics);
            let Some(regions) = regions(&row, scene, diagnostics).filter(|_| row.sound) else { continue };
            match (entry.keyword.name, row.token(2)) {
                ("CONTACT INCLUSIONS", _) => contact.inclusions.push(regions),
                ("CONTACT EXCLUSIONS", _) => contact.exclusions.push(regions),
                ("CONTACT PROPERTY ASSIGNMENT", Some(token)) => {
                    let name = normalized(token.text);
                    if interactions.find_in(&name, entry.step.unwrap_or(0)).is_none() {
                        let fault = Diagnostic::error(token.span, format!("there is no interaction `{name}`"));
                        diagnostics.push(fault.known(&name, interactions.names()));
                    }
                    self.names.push((regions, name));
                }
                _ => contact.scale_penalty.extend(row.number(2).map(|factor| (regions, factor))),
            }
        }
    }
}

/// The two surfaces of a line; `None` where one is not there, which is told.
fn regions(row: &Row<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<[Region; 2]> {
    let mut region = |token: Token<'_>| {
        faces_of(token, scene, diagnostics)?;
        Some(Region::Surface(scene.full_name(token.text)))
    };
    let first = row.token(0).map_or(Some(Region::AllExterior), &mut region);
    let second = row.token(1).map_or(first.clone(), &mut region);
    Some([first?, second?])
}
