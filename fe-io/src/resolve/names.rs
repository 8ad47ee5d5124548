//! What labels and names mean, in the model and in the instances of parts.

use super::labels::Labels;
use super::motion::Motion;
use super::scene::Scene;
use crate::deck::card::{Token, Value, normalized};
use crate::deck::number::whole;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::keyword::check::Entry;
use fe_mesh::{CellId, Instance};
use std::collections::BTreeMap;

/// Labels and names of the model itself or of an instance.
#[derive(Debug, Default)]
pub struct Scope {
    /// What its names begin with: nothing in the model itself, `INSTANCE.` in an instance.
    pub prefix: String,
    /// Where an instance puts its part.
    pub motion: Motion,
    /// Node labels.
    pub nodes: Labels,
    /// Element labels, to indices into the scene's cells.
    pub elements: Labels,
}

/// A label and whose it is.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// Index into the scopes of the scene.
    pub scope: usize,
    /// The number.
    pub number: u64,
}

impl Scene<'_> {
    /// Another instance; its scope.
    pub fn add_instance(&mut self, name: &str, motion: Motion) -> usize {
        self.structure.mesh.instances.push(Instance::new(name.to_owned()));
        self.scopes.push(Scope { prefix: format!("{name}."), motion, ..Scope::default() });
        self.scopes.len() - 1
    }

    /// From here on a card is read: its labels and names are those of its scope.
    pub fn enter(&mut self, entry: &Entry<'_>) {
        (self.reading, self.inside) = (entry.scope, entry.scope);
    }

    /// From here on labels and names are those of the model.
    pub fn leave(&mut self) {
        (self.reading, self.inside) = (0, 0);
    }

    /// Labels, names and place of the card that is read.
    pub fn scope(&self) -> &Scope {
        &self.scopes[self.reading]
    }

    /// As [`Scene::scope`].
    pub fn scope_mut(&mut self) -> &mut Scope {
        &mut self.scopes[self.reading]
    }

    /// The instance that the card which is read belongs to.
    pub fn instance_mut(&mut self) -> Option<&mut Instance> {
        self.structure.mesh.instances.get_mut(self.reading.checked_sub(1)?)
    }

    /// The full name of what the card that is read calls so.
    pub fn own_name(&self, written: &str) -> String {
        format!("{}{}", self.scope().prefix, normalized(written))
    }

    /// The full name of a set or a surface that the card which is read defines; with instances, one with a point is
    /// told.
    pub fn new_name(&self, value: &Value, diagnostics: &mut Diagnostics) -> Option<String> {
        if self.scopes.len() > 1 && value.text.contains('.') {
            let fault = Diagnostic::error(value.span, format!("the name `{}` holds a point", normalized(&value.text)));
            diagnostics
                .push(fault.help("with parts, points stand between an instance and what it holds: INSTANCE.SET"));
            return None;
        }
        Some(self.own_name(&value.text))
    }

    /// The full name of what is called so where names are looked up. The name of the assembly may stand before it.
    pub fn full_name(&self, written: &str) -> String {
        let name = normalized(written);
        match &self.assembly {
            Some(assembly) if self.inside == 0 => match name.strip_prefix(assembly.as_str()) {
                Some(rest) if rest.starts_with('.') => rest[1..].to_owned(),
                _ => name,
            },
            _ => format!("{}{name}", self.scopes[self.inside].prefix),
        }
    }

    /// The scope of an instance; one that is not there is told.
    pub fn instance(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<usize> {
        let name = normalized(token.text);
        let found = self.structure.mesh.instances.iter().position(|instance| instance.name == name);
        if found.is_none() {
            diagnostics.push(self.no_instance(token, &name));
        }
        found.map(|i| i + 1)
    }

    fn no_instance(&self, token: Token<'_>, name: &str) -> Diagnostic {
        let known = self.structure.mesh.instances.iter().map(|instance| instance.name.as_str());
        let fault = Diagnostic::error(token.span, format!("there is no instance `{name}`")).known(name, known);
        match self.structure.mesh.instances.is_empty() {
            true => fault.help("write `*INSTANCE, NAME=…, PART=…` in the assembly"),
            false => fault,
        }
    }

    /// The label that a text is, `12` or `INSTANCE.12`; `None` for a name.
    pub fn label(&self, text: &str) -> Option<Label> {
        if let Some(number) = whole(text) {
            return Some(Label { scope: self.inside, number });
        }
        if self.scopes.len() == 1 || self.inside > 0 {
            return None;
        }
        let name = self.full_name(text);
        let (prefix, number) = name.split_at(name.rfind('.')? + 1);
        let scope = self.scopes.iter().position(|scope| scope.prefix == prefix)?;
        Some(Label { scope, number: whole(number)? })
    }

    /// A label in a message: that of the card where the card is the instance's own.
    fn said(&self, label: Label) -> String {
        let foreign = label.scope != self.reading;
        format!("{}{}", if foreign { &self.scopes[label.scope].prefix } else { "" }, label.number)
    }

    /// The node with a label; a missing one is told.
    pub fn node(&self, token: Token<'_>, label: Label, diagnostics: &mut Diagnostics) -> Option<u32> {
        let labels = &self.scopes[label.scope].nodes;
        let node = labels.get(label.number);
        if node.is_none() && !labels.is_faulty(label.number) {
            let title = format!("node {} is not there", self.said(label));
            diagnostics.push(Diagnostic::error(token.span, title));
        }
        node
    }

    /// The element with a label; a missing one is told.
    pub fn cell(&self, token: Token<'_>, label: Label, diagnostics: &mut Diagnostics) -> Option<CellId> {
        let labels = &self.scopes[label.scope].elements;
        let ordinal = labels.get(label.number);
        if ordinal.is_none() && !labels.is_faulty(label.number) {
            let title = format!("element {} is not there", self.said(label));
            diagnostics.push(Diagnostic::error(token.span, title));
        }
        self.cells.get(ordinal? as usize).copied()
    }

    /// The nodes that a label or the name of a set means; `None` when it means nothing, which is told.
    pub fn nodes_of(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<u32>> {
        match self.label(token.text) {
            Some(label) => self.node(token, label, diagnostics).map(|node| vec![node]),
            None => self.set(&self.structure.mesh.node_sets, "node set", token, diagnostics).map(<[u32]>::to_vec),
        }
    }

    /// The elements that a label or the name of a set means; `None` when it means nothing, which is told.
    pub fn cells_of(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<CellId>> {
        match self.label(token.text) {
            Some(label) => self.cell(token, label, diagnostics).map(|cell| vec![cell]),
            None => self.cell_set(token, diagnostics).map(<[CellId]>::to_vec),
        }
    }

    /// An element set by name; `None` when it is missing or empty, which is told.
    pub fn cell_set(&self, token: Token<'_>, diagnostics: &mut Diagnostics) -> Option<&[CellId]> {
        let sets = &self.structure.mesh.cell_sets;
        let name = self.full_name(token.text);
        if self.faulty_sets.contains(&name) && sets.get(&name).is_none_or(Vec::is_empty) {
            return None;
        }
        self.set(sets, "element set", token, diagnostics)
    }

    /// A set by name; a missing or an empty one is told.
    pub fn set<'m, T>(
        &self,
        sets: &'m BTreeMap<String, Vec<T>>,
        kind: &str,
        token: Token<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<&'m [T]> {
        match sets.get(&self.full_name(token.text)) {
            Some(set) if !set.is_empty() => Some(set),
            Some(_) => {
                let name = normalized(token.text);
                let filled = sets.iter().filter(|(_, set)| !set.is_empty()).map(|(name, _)| name.as_str());
                let fault = Diagnostic::error(token.span, format!("{kind} `{name}` is empty"));
                diagnostics.push(fault.known(&name, self.known_here(filled)));
                None
            }
            None => {
                diagnostics.push(self.unknown(kind, token, sets.keys().map(String::as_str)));
                None
            }
        }
    }

    /// The fault of a name that is not among the full names of its kind: the instance may be the wrong one.
    pub fn unknown<'n>(&self, kind: &str, token: Token<'_>, known: impl Iterator<Item = &'n str>) -> Diagnostic {
        let (written, name) = (normalized(token.text), self.full_name(token.text));
        if let Some((instance, _)) = name.split_once('.')
            && self.scopes.len() > 1
            && !self.structure.mesh.instances.iter().any(|i| i.name == instance)
        {
            return self.no_instance(token, instance);
        }
        let fault = Diagnostic::error(token.span, format!("there is no {kind} `{written}`"));
        fault.known(&written, self.known_here(known))
    }

    /// Of some full names those that can be said where names are looked up, as they are said there.
    fn known_here<'n>(&self, names: impl Iterator<Item = &'n str>) -> impl Iterator<Item = &'n str> {
        names.filter_map(|name| name.strip_prefix(self.scopes[self.inside].prefix.as_str()))
    }

    /// What a message calls a node.
    pub fn node_name(&self, node: u32) -> String {
        let mesh = &self.structure.mesh;
        let scope = mesh.instance_of_point(node).map_or(0, |i| i + 1);
        self.said(Label { scope, number: mesh.point_labels[node as usize] })
    }

    /// What a message calls an element.
    pub fn cell_name(&self, cell: CellId) -> String {
        let mesh = &self.structure.mesh;
        let scope = mesh.instance_of_cell(cell).map_or(0, |i| i + 1);
        self.said(Label { scope, number: mesh.cell_label(cell) })
    }
}
