//! `*ELEMENT`.

use super::scene::{Analysis, Scene};
use crate::deck::card::{Line, Token};
use crate::deck::number::whole;
use crate::deck::source::Span;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_core::element::{ElementType, Family};
use fe_mesh::{CellId, CellKind};

/// Element types that decks know and this program does not.
const NOT_YET: &[&str] = &[
    "C3D6", "C3D15", "C3D20", "C3D20R", "C3D27", "C3D8I", "C3D8H", "C3D8RH", "C3D20H", "C3D20RH", "C3D10H", "C3D10MH",
    "C3D10T", "C3D4H", "C3D5", "C3D13", "C3D6H", "C3D15H", "CPE4I", "CPE4H", "CPE4RH", "CPE6", "CPE6M", "CPE6H",
    "CPE8", "CPE8R", "CPE8H", "CPE8RH", "CPE3H", "CPS4I", "CPS6", "CPS6M", "CPS8", "CPS8R", "CAX4I", "CAX4H", "CAX4RH",
    "CAX6", "CAX6M", "CAX6H", "CAX8", "CAX8R", "CAX8H", "CAX8RH", "CAX3H", "CGAX3", "CGAX4", "CGAX6", "CGAX8", "S3",
    "S3R", "S4", "S4R", "S6", "S8", "S8R", "S8R5", "S9R5", "STRI3", "STRI65", "M3D3", "M3D4", "M3D4R", "M3D6", "M3D8",
    "M3D8R", "SFM3D3", "SFM3D4", "SFM3D4R", "SC6R", "SC8R", "T2D3", "B22", "B31R", "B32", "B32R", "PIPE21", "PIPE31",
    "PIPE32", "FRAME3D", "GAPUNIT", "ISL21A", "ISL22A", "IRS21", "IRS22", "IRS3", "IRS4", "IRS9", "RAX2", "RB2D2",
    "RB3D2", "CONN2D2", "CONN3D2", "COH2D4", "COH3D6", "COH3D8", "COHAX4", "DCOUP3D", "JOINTC", "CIN3D8", "CINPE4",
    "CINPS4", "CINAX4",
];

/// Names that decks use for an element of ours: the name, ours, and what makes it do.
const TAKEN_AS: &[(&str, ElementType, &str)] =
    &[("C3D10M", ElementType::C3D10, "in explicit steps its mass is lumped by ∫N² dV, positive at all nodes")];

/// The element type of a name; one that is not there is told, and one that stands for another.
pub fn element_type(name: &str, at: Span, diagnostics: &mut Diagnostics) -> Option<ElementType> {
    if let Some((_, element, why)) = TAKEN_AS.iter().find(|(other, ..)| *other == name) {
        diagnostics.push(Diagnostic::note(at, format!("{name} is taken as {}", element.name())).label(*why));
        return Some(*element);
    }
    let element = ElementType::from_name(name);
    if element.is_none() {
        let there = ElementType::ALL.map(ElementType::name);
        let all = there.join(", ");
        let fault = if NOT_YET.contains(&name) {
            let like = crate::deck::nearest::nearest(name, there);
            let fault = Diagnostic::error(at, format!("elements of type `{name}` are not there yet"));
            match like.filter(|like| like[..3] == name[..3.min(name.len())]) {
                Some(like) => fault.label(format!("`{like}` is there")),
                None => fault,
            }
        } else {
            let known = there.into_iter().chain(NOT_YET.iter().copied());
            Diagnostic::error(at, format!("there is no element type `{name}`")).known(name, known)
        };
        diagnostics.push(fault.help(format!("there is {all}")));
    }
    element
}

/// Refuses an element type that the steps of the job have no use for.
pub fn suits(element: ElementType, at: Span, scene: &Scene<'_>, diagnostics: &mut Diagnostics) {
    let (steps, instead) = match (scene.analysis, element.family()) {
        (Analysis::Static, Family::Rigid) => ("explicit", "give rigid bodies an analytical surface".to_owned()),
        (Analysis::Static, Family::RotaryInertia) => {
            ("explicit", "static steps have no inertia: leave it out".to_owned())
        }
        (Analysis::Static, Family::Solid) if ElementType::REDUCED.contains(&element) => {
            ("explicit", format!("`{}` is there, and does not lock", element.name().trim_end_matches('R')))
        }
        (Analysis::Explicit, Family::Gap | Family::Tube) => ("static", "pairs of surfaces are there".to_owned()),
        _ => return,
    };
    let fault = Diagnostic::error(at, format!("elements of type `{}` are for {steps} steps", element.name()));
    diagnostics.push(fault.help(instead));
}

/// Reads the elements of a card.
pub fn read(entry: &Entry<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
    let Some(value) = entry.value("TYPE") else { return };
    let name = crate::deck::card::normalized(&value.text);
    let element = element_type(&name, value.span, diagnostics);
    element.into_iter().for_each(|element| suits(element, value.span, scene, diagnostics));
    let mut reading = Reading { element, block: element.map(|e| scene.block_of(e)), label: None, nodes: Vec::new() };
    let first = scene.cells.len();
    let mut lines = scene.deck.lines(entry.card).peekable();
    while let Some(line) = lines.next() {
        reading.line(line);
        let complete = element.is_none_or(|e| reading.nodes.len() >= e.kind().nodes());
        if !(line.goes_on() && !complete && lines.peek().is_some()) {
            reading.finish(line, scene, diagnostics);
        }
    }
    if let Some(name) = entry.name("ELSET").map(|name| scene.own_name(&name)) {
        if scene.cells.len() == first {
            scene.faulty_sets.insert(name.clone());
        }
        let added = scene.cells[first..].to_vec();
        scene.structure.mesh.cell_sets.entry(name).or_default().extend(added);
    }
}

/// The element that is being read; of an unknown type only labels are.
struct Reading<'a> {
    element: Option<ElementType>,
    block: Option<usize>,
    label: Option<Result<(u64, Span), Token<'a>>>,
    /// Node labels, with their tokens.
    nodes: Vec<Token<'a>>,
}

impl<'a> Reading<'a> {
    fn line(&mut self, line: Line<'a>) {
        let mut tokens = line.tokens();
        if self.label.is_none() {
            self.label = tokens.next().map(|token| whole(token.text).map(|l| (l, token.span)).ok_or(token));
        }
        self.nodes.extend(tokens);
    }

    fn finish(&mut self, line: Line<'_>, scene: &mut Scene<'_>, diagnostics: &mut Diagnostics) {
        match self.label.take() {
            Some(Ok((label, at))) => {
                let added = self.add(label, at, line, scene, diagnostics);
                added.unwrap_or_else(|| scene.scope_mut().elements.spoil(label));
            }
            Some(Err(token)) => {
                let title = format!("`{}` is not the label of an element", token.text);
                diagnostics.push(Diagnostic::error(token.span, title).label("a whole number"));
            }
            None => {}
        }
        self.nodes.clear();
    }

    fn add(
        &self,
        label: u64,
        at: Span,
        line: Line<'_>,
        scene: &mut Scene<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<()> {
        let (element, block) = (self.element?, self.block?);
        let wanted = element.kind().nodes();
        if self.nodes.len() != wanted {
            let title = format!("element {label} has {} nodes, {} needs {wanted}", self.nodes.len(), element.name());
            let fault = Diagnostic::error(line.span, title);
            let short = self.nodes.len() < wanted;
            diagnostics.push(if short {
                fault.help("a line that ends with a comma goes on in the next")
            } else {
                fault
            });
            return None;
        }
        let start = scene.structure.mesh.blocks[block].nodes.len();
        for token in &self.nodes {
            match node(*token, scene, diagnostics) {
                Some(node) => scene.structure.mesh.blocks[block].nodes.push(node),
                None => {
                    scene.structure.mesh.blocks[block].nodes.truncate(start);
                    return None;
                }
            }
        }
        if let Some(i) = repeated(&scene.structure.mesh.blocks[block].nodes[start..]) {
            let title = format!("element {label} has node `{}` twice", self.nodes[i].text);
            let fault = Diagnostic::error(self.nodes[i].span, title);
            diagnostics.push(fault.help("elements are not collapsed: take a type with fewer nodes"));
            scene.structure.mesh.blocks[block].nodes.truncate(start);
            return None;
        }
        if element.kind() == CellKind::Line3 {
            // Decks write the mid node between the ends.
            scene.structure.mesh.blocks[block].nodes.swap(start + 1, start + 2);
        }
        let added = register(scene, block, label, at, diagnostics);
        if added.is_none() {
            scene.structure.mesh.blocks[block].nodes.truncate(start);
        }
        added
    }
}

/// Gives the cell at the end of a block, whose nodes are there, its label; a label that is taken is told.
pub fn register(
    scene: &mut Scene<'_>,
    block: usize,
    label: u64,
    at: Span,
    diagnostics: &mut Diagnostics,
) -> Option<()> {
    let ordinal = scene.cells.len() as u32;
    if let Err(other) = scene.scope_mut().elements.insert(label, ordinal) {
        let fault = Diagnostic::error(at, format!("element {label} is there twice"));
        let first = scene.place_of(scene.cells[other as usize]);
        diagnostics.push(first.into_iter().fold(fault, |fault, first| fault.related(first, "first here")));
        return None;
    }
    let cells = &mut scene.structure.mesh.blocks[block];
    let id = CellId { block: block as u32, cell: cells.labels.len() as u32 };
    cells.labels.push(label);
    scene.cells.push(id);
    scene.cell_places[block].push(at);
    scene.instance_mut().into_iter().for_each(|instance| instance.add_cell(id));
    Some(())
}

fn node(token: Token<'_>, scene: &Scene<'_>, diagnostics: &mut Diagnostics) -> Option<u32> {
    match scene.label(token.text) {
        Some(label) => scene.node(token, label, diagnostics),
        None => {
            let title = format!("`{}` is not the label of a node", token.text);
            diagnostics.push(Diagnostic::error(token.span, title).label("a whole number"));
            None
        }
    }
}

/// Place of the first node that came before.
fn repeated(nodes: &[u32]) -> Option<usize> {
    (1..nodes.len()).find(|&i| nodes[..i].contains(&nodes[i]))
}
