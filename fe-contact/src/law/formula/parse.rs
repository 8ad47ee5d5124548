//! Lines `name = expression` to one expression of the overclosure; faults know their place.

use super::expression::{FUNCTIONS, Node};
use super::parser::Parser;
use std::ops::Range;

/// What is wrong with a formula, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{title}")]
pub struct Fault {
    /// Index of the line; `None`: the formula as a whole.
    pub line: Option<usize>,
    /// Bytes of the line.
    pub at: Range<usize>,
    /// What is wrong.
    pub title: String,
    /// An unknown word, and the words that are known in its place.
    pub known: Option<(String, Vec<String>)>,
}

/// Names that stand for themselves.
pub(super) const OWN: [&str; 3] = ["h", "g", "pi"];

/// One line.
pub(super) struct Definition<'a> {
    line: usize,
    /// As written.
    pub name: &'a str,
    /// Bytes of the name.
    at: Range<usize>,
    /// What follows the equals sign, and where it begins.
    text: &'a str,
    from: usize,
    pub used: bool,
    pub state: State,
}

/// How far a line was read.
pub(super) enum State {
    Written,
    Open,
    /// Its expression; `None`: faulty.
    Read(Option<Node>),
}

/// What lines say.
pub(super) struct Parsed {
    pub pressure: Node,
    /// Index of its line, and the bytes of the expression there.
    pub place: (usize, Range<usize>),
    pub reach: f64,
    /// Definitions that nothing uses.
    pub unused: Vec<Fault>,
}

/// The formula that lines say, or all that is wrong with them.
pub(super) fn parse(lines: &[&str]) -> Result<Parsed, Vec<Fault>> {
    let mut all = Definitions { list: Vec::new(), faults: Vec::new(), depth: 0 };
    lines.iter().enumerate().for_each(|(i, line)| all.begin(i, line));
    for i in 0..all.list.len() {
        all.read(i);
    }
    let pressure = all.find("p");
    if pressure.is_none() && all.faults.is_empty() {
        all.faults.push(Fault { line: None, at: 0..0, title: "no line says `p = …`".into(), known: None });
    }
    let reach = all.find("reach").map_or(Some(0.0), |i| all.constant(i));
    match (pressure.and_then(|i| all.node(i).map(|node| (i, node))), reach) {
        (Some((i, pressure)), Some(reach)) if all.faults.is_empty() => {
            let of = |d: &Definition| (d.line, d.from + leading(d.text)..d.from + d.text.trim_end().len());
            Ok(Parsed { pressure, place: of(&all.list[i]), reach, unused: all.unused() })
        }
        _ => Err(all.faults),
    }
}

pub(super) fn leading(text: &str) -> usize {
    text.len() - text.trim_start().len()
}

/// All lines.
pub(super) struct Definitions<'a> {
    pub list: Vec<Definition<'a>>,
    faults: Vec<Fault>,
    /// Of the expressions that are being read.
    pub depth: usize,
}

impl<'a> Definitions<'a> {
    pub fn find(&self, name: &str) -> Option<usize> {
        self.list.iter().position(|d| d.name.eq_ignore_ascii_case(name))
    }

    fn node(&self, i: usize) -> Option<Node> {
        if let State::Read(node) = &self.list[i].state { node.clone() } else { None }
    }

    fn fault(&mut self, line: usize, at: Range<usize>, title: String) {
        self.faults.push(Fault { line: Some(line), at, title, known: None });
    }

    /// The name of a line.
    fn begin(&mut self, line: usize, text: &'a str) {
        let Some((head, rest)) = text.split_once('=') else {
            self.fault(line, 0..text.len(), "a line of a formula is `name = expression`".into());
            return;
        };
        let name = head.trim();
        let at = leading(head)..leading(head) + name.len();
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let taken = OWN.iter().copied().chain(FUNCTIONS.iter().map(|function| function.0));
        let title = match self.find(name) {
            _ if !is_name => format!("`{name}` is no name: letters, digits and `_`, a letter first"),
            _ if { taken }.any(|t| t.eq_ignore_ascii_case(name)) => {
                format!("`{name}` has a meaning of its own and cannot be defined")
            }
            Some(_) => format!("`{name}` is defined twice (capitals do not count)"),
            None => {
                let from = head.len() + 1;
                self.list.push(Definition { line, name, at, text: rest, from, used: false, state: State::Written });
                return;
            }
        };
        self.fault(line, at, title);
    }

    /// Reads a definition, and first those that it uses.
    pub fn read(&mut self, i: usize) -> Option<Node> {
        if let State::Read(node) = &self.list[i].state {
            return node.clone();
        }
        self.list[i].state = State::Open;
        let (line, text, from) = (self.list[i].line, self.list[i].text, self.list[i].from);
        let node = Parser::new(self, line, (text, from)).whole();
        let node = node.map_err(|fault| self.faults.extend(fault)).ok();
        self.list[i].state = State::Read(node.clone());
        node
    }

    /// A definition that must not depend on the overclosure.
    fn constant(&mut self, i: usize) -> Option<f64> {
        self.list[i].used = true;
        let node = self.node(i)?;
        if node.number().is_none() {
            let Definition { line, name, at, .. } = &self.list[i];
            self.fault(*line, at.clone(), format!("`{name}` must be a number, and depends on the overclosure"));
        }
        node.number()
    }

    fn unused(&self) -> Vec<Fault> {
        let unused = self.list.iter().filter(|d| !d.used && !d.name.eq_ignore_ascii_case("p"));
        let fault = |d: &Definition| {
            let title = format!("`{}` is used nowhere", d.name);
            Fault { line: Some(d.line), at: d.at.clone(), title, known: None }
        };
        unused.map(fault).collect()
    }
}
