//! One expression: numbers, names, functions and operators to a tree.

use super::expression::{FUNCTIONS, Function, Node, Operator};
use super::parse::{Definitions, Fault, OWN, State, leading};

/// Parentheses, and names in definitions of names, may nest so deep.
const DEEPEST: usize = 100;
/// An expression, names written out, may have so many operations and numbers.
const LONGEST: usize = 1000;

/// `Err(None)`: what is wrong was told where it stands.
type Step<T> = Result<T, Option<Fault>>;

/// Reads the expression of one definition.
pub(super) struct Parser<'p, 'a> {
    all: &'p mut Definitions<'a>,
    line: usize,
    text: &'a str,
    /// Where the text begins in its line.
    base: usize,
    at: usize,
}

impl<'p, 'a> Parser<'p, 'a> {
    /// Of a line, the text that begins at the byte `base` of it.
    pub fn new(all: &'p mut Definitions<'a>, line: usize, (text, base): (&'a str, usize)) -> Self {
        Parser { all, line, text, base, at: 0 }
    }

    /// All of it.
    pub fn whole(&mut self) -> Step<Node> {
        let node = self.sum()?;
        match self.peek() {
            None => Ok(node),
            Some(')') => Err(self.here("this parenthesis closes nothing")),
            Some('=') => Err(self.here("a line has one `=`")),
            Some(_) => Err(self.here("an operator is missing before this")),
        }
    }

    /// The next character that is no blank.
    fn peek(&mut self) -> Option<char> {
        self.at += leading(&self.text[self.at..]);
        self.text[self.at..].chars().next()
    }

    fn takes(&mut self, symbol: &str) -> bool {
        self.peek();
        let there = self.text[self.at..].starts_with(symbol);
        self.at += if there { symbol.len() } else { 0 };
        there
    }

    fn wrong(&self, from: usize, title: impl Into<String>) -> Fault {
        let at = self.base + from..self.base + self.at.max(from);
        Fault { line: Some(self.line), at, title: title.into(), known: None }
    }

    /// A fault at the word that comes next, or at the end of the line.
    fn here(&mut self, title: &str) -> Option<Fault> {
        let word = match self.peek() {
            Some(c) if is_word(c) => self.text[self.at..].chars().take_while(|c| is_word(*c)).count(),
            Some(c) => c.len_utf8(),
            None => {
                self.at = self.text.trim_end().len();
                let from = self.text[..self.at].char_indices().last().map_or(0, |(last, _)| last);
                return Some(self.wrong(from, title));
            }
        };
        let from = self.at;
        self.at += word;
        Some(self.wrong(from, title))
    }

    /// Folded, and refused where it is no number, or too long.
    fn made(&self, from: usize, node: Node) -> Step<Node> {
        let node = node.folded();
        match node.number() {
            Some(value) if !value.is_finite() => Err(Some(self.wrong(from, format!("this is no number: {value}")))),
            _ if node.size() > LONGEST => Err(Some(self.wrong(from, "this is too long with all names written out"))),
            _ => Ok(node),
        }
    }

    fn sum(&mut self) -> Step<Node> {
        self.chain(&[("+", Operator::Add), ("-", Operator::Subtract)], Self::product)
    }

    fn product(&mut self) -> Step<Node> {
        self.chain(&[("*", Operator::Multiply), ("/", Operator::Divide)], Self::signed)
    }

    fn chain(&mut self, operators: &[(&str, Operator)], next: fn(&mut Self) -> Step<Node>) -> Step<Node> {
        self.peek();
        let from = self.at;
        let mut node = next(self)?;
        while let Some((_, operator)) = operators.iter().find(|(symbol, _)| self.takes(symbol)) {
            let other = next(self)?;
            node = self.made(from, Node::Join(*operator, Box::new([node, other])))?;
        }
        Ok(node)
    }

    fn signed(&mut self) -> Step<Node> {
        if self.takes("-") {
            let inner = self.nested(Self::signed)?;
            return Ok(Node::Join(Operator::Subtract, Box::new([Node::Number(0.0), inner])).folded());
        }
        if self.takes("+") {
            return self.nested(Self::signed);
        }
        let from = self.at;
        let base = self.atom()?;
        if self.takes("^") || self.takes("**") {
            let exponent = self.nested(Self::signed)?;
            return self.made(from, Node::Join(Operator::Power, Box::new([base, exponent])));
        }
        Ok(base)
    }

    fn nested(&mut self, inner: impl FnOnce(&mut Self) -> Step<Node>) -> Step<Node> {
        if self.all.depth == DEEPEST {
            return Err(self.here("this is nested too deep"));
        }
        self.all.depth += 1;
        let node = inner(self);
        self.all.depth -= 1;
        node
    }

    fn atom(&mut self) -> Step<Node> {
        match self.peek() {
            Some('(') => {
                let from = self.at;
                self.at += 1;
                let node = self.nested(Self::sum)?;
                self.closes(from)?;
                Ok(node)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() || c == '_' => self.word(),
            None => Err(self.here("a number or a name is missing after this")),
            Some(_) => Err(self.here("a number or a name is missing before this")),
        }
    }

    fn closes(&mut self, opened: usize) -> Step<()> {
        match self.takes(")") {
            true => Ok(()),
            false if self.peek().is_none() => {
                self.at = opened + 1;
                Err(Some(self.wrong(opened, "this parenthesis is not closed")))
            }
            false if self.peek() == Some(',') => Err(self.here("this comma is one too many")),
            false => Err(self.here("an operator is missing before this")),
        }
    }

    fn number(&mut self) -> Step<Node> {
        let from = self.at;
        let rest = &self.text.as_bytes()[from..];
        let digits = |at: usize| rest[at..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
        let mut end = digits(0);
        if rest.get(end).is_some_and(|b| b"eEdD".contains(b)) {
            let sign = usize::from(rest.get(end + 1).is_some_and(|b| b"+-".contains(b)));
            let exponent = digits(end + 1 + sign);
            end += if exponent > 0 { 1 + sign + exponent } else { 0 };
        }
        self.at += end;
        let text = &self.text[from..self.at];
        match text.replace(['d', 'D'], "e").parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Node::Number(value)),
            _ => Err(Some(self.wrong(from, format!("`{text}` is not a number")))),
        }
    }

    fn word(&mut self) -> Step<Node> {
        let from = self.at;
        let rest = &self.text[from..];
        let written = &rest[..rest.find(|c| !is_word(c)).unwrap_or(rest.len())];
        self.at += written.len();
        if self.peek() == Some('(') {
            return self.call(written, from);
        }
        match written.to_ascii_lowercase().as_str() {
            "h" => Ok(Node::Overclosure),
            "g" => Ok(Node::Join(Operator::Subtract, Box::new([Node::Number(0.0), Node::Overclosure]))),
            "pi" => Ok(Node::Number(std::f64::consts::PI)),
            _ => self.defined(written, from),
        }
    }

    /// What another line defines.
    fn defined(&mut self, written: &str, from: usize) -> Step<Node> {
        self.at = from + written.len();
        let Some(i) = self.all.find(written) else {
            let names = self.all.list.iter().map(|d| d.name.to_owned());
            let known = OWN.iter().map(|name| (*name).to_owned()).chain(names).collect();
            let fault = self.wrong(from, format!("`{written}` is not defined"));
            return Err(Some(Fault { known: Some((written.into(), known)), ..fault }));
        };
        if matches!(self.all.list[i].state, State::Open) {
            return Err(Some(self.wrong(from, format!("`{written}` is defined by itself"))));
        }
        self.all.list[i].used = true;
        self.nested(|parser| parser.all.read(i).ok_or(None))
    }

    fn call(&mut self, written: &str, from: usize) -> Step<Node> {
        let name = written.to_ascii_lowercase();
        let opened = self.at;
        let Some((_, function)) = FUNCTIONS.iter().find(|function| function.0 == name) else {
            self.at = from + written.len();
            let names = FUNCTIONS.iter().map(|function| function.0.to_owned());
            let known = Some((written.into(), names.collect()));
            let fault = self.wrong(from, format!("`{written}` is not a function"));
            return Err(Some(Fault { known, ..fault }));
        };
        self.at += 1;
        let first = self.nested(Self::sum)?;
        let node = match function {
            Function::Curve(curve) => Node::Apply(*curve, Box::new(first)),
            Function::Abs => Node::Abs(Box::new(first)),
            Function::Join(operator) => Node::Join(*operator, Box::new([first, self.argument()?])),
            Function::If => self.branches(first)?,
        };
        self.closes(opened)?;
        self.made(from, node)
    }

    /// A comma and what follows it.
    fn argument(&mut self) -> Step<Node> {
        if !self.takes(",") {
            return Err(self.here("a comma and another argument are missing here"));
        }
        self.nested(Self::sum)
    }

    /// `a < b, one, other` with the first side read.
    fn branches(&mut self, first: Node) -> Step<Node> {
        let comparisons = ["<=", ">=", "<", ">"];
        let Some(sign) = comparisons.into_iter().find(|sign| self.takes(sign)) else {
            return Err(self.here("`<` or `>` is missing here: `if(a < b, one, other)`"));
        };
        let second = self.nested(Self::sum)?;
        let (one, other) = (self.argument()?, self.argument()?);
        let sides = if sign.starts_with('<') { [first, second] } else { [second, first] };
        let [low, high] = sides;
        Ok(Node::If(Box::new([low, high, one, other])))
    }
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}
