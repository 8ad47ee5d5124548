//! Messages about a deck or a mesh: file, line, caret, nearest known word.

use crate::deck::nearest::nearest;
use crate::deck::source::{Source, Span};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// The deck is refused.
    Error,
    /// The deck runs, but perhaps not as meant.
    Warning,
    /// Worth knowing.
    Note,
}

/// One message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in one line; names stand in backticks.
    pub title: String,
    /// Where, and what to say there.
    pub primary: Option<(Span, String)>,
    /// Other places that matter, each with its line of text.
    pub related: Vec<(Span, String)>,
    /// What to do instead.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// A message at a place.
    pub fn new(severity: Severity, at: Span, title: impl Into<String>) -> Self {
        let primary = Some((at, String::new()));
        Diagnostic { severity, title: title.into(), primary, related: Vec::new(), help: Vec::new() }
    }

    /// A fault at a place.
    pub fn error(at: Span, title: impl Into<String>) -> Self {
        Self::new(Severity::Error, at, title)
    }

    /// A warning at a place.
    pub fn warning(at: Span, title: impl Into<String>) -> Self {
        Self::new(Severity::Warning, at, title)
    }

    /// A remark at a place.
    pub fn note(at: Span, title: impl Into<String>) -> Self {
        Self::new(Severity::Note, at, title)
    }

    /// What to say beside the underline.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(primary) = &mut self.primary {
            primary.1 = text.into();
        }
        self
    }

    /// Another place that matters.
    pub fn related(mut self, at: Span, text: impl Into<String>) -> Self {
        self.related.push((at, text.into()));
        self
    }

    /// What to do instead.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help.push(text.into());
        self
    }

    /// Names the nearest known word, or all of them when they are few and none is near.
    pub fn known<'a>(self, word: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known: Vec<&str> = known.into_iter().collect();
        match nearest(word, known.iter().copied()) {
            Some(near) => self.label(format!("did you mean `{near}`?")),
            None if known.is_empty() => self,
            None if known.len() <= 12 => self.help(format!("there is {}", listed(&known))),
            None => self,
        }
    }

    /// Messages of one kind differ in numbers only.
    fn kind(&self) -> String {
        self.title.chars().filter(|c| !c.is_ascii_digit()).collect()
    }
}

/// `A`, `B` and `C`.
pub(crate) fn listed(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|w| format!("`{w}`")).collect();
    match quoted.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, before)) => format!("{} and {last}", before.join(", ")),
    }
}

/// Of one kind, no more than this many are shown; the others are counted.
const SHOWN_OF_A_KIND: usize = 5;
/// Nor more than this many in all.
const SHOWN: usize = 100;

/// All messages about a deck. As an error it holds at least one fault.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    seen: BTreeMap<String, usize>,
    faults: usize,
    more: usize,
    sources: Vec<Arc<Source>>,
}

impl std::error::Error for Diagnostics {}

impl Diagnostics {
    /// No message yet, about these sources.
    pub fn new(sources: Vec<Arc<Source>>) -> Self {
        Diagnostics { sources, ..Default::default() }
    }

    /// One more message. Beyond a few of the same kind they are only counted.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if self.list.contains(&diagnostic) {
            return;
        }
        self.faults += usize::from(diagnostic.severity == Severity::Error);
        if self.list.len() >= SHOWN {
            self.more += 1;
            return;
        }
        let count = self.seen.entry(diagnostic.kind()).or_default();
        *count += 1;
        if *count <= SHOWN_OF_A_KIND {
            self.list.push(diagnostic);
        } else {
            self.more += 1;
        }
    }

    /// Number of faults, those that are only counted included.
    pub fn faults(&self) -> usize {
        self.faults
    }

    /// The messages, in the order of their places.
    pub fn list(&self) -> impl Iterator<Item = &Diagnostic> {
        let mut sorted: Vec<&Diagnostic> = self.list.iter().collect();
        sorted.sort_by_key(|d| d.primary.as_ref().map(|p| p.0));
        sorted.into_iter()
    }

    /// `file:line:column: severity: title`; a remark goes without the word.
    pub fn line(&self, diagnostic: &Diagnostic) -> String {
        let severity = match diagnostic.severity {
            Severity::Error => "error: ",
            Severity::Warning => "warning: ",
            Severity::Note => "",
        };
        let place = diagnostic.primary.as_ref().map(|(at, _)| {
            let source = &self.sources[at.source as usize];
            format!("{}:{}:{}: ", source.name, source.line(at.start), source.column(at.start))
        });
        let said = diagnostic.primary.as_ref().map(|(_, said)| said.as_str()).filter(|said| !said.is_empty());
        let mut line = format!("{}{severity}{}", place.unwrap_or_default(), diagnostic.title);
        for more in said.into_iter().chain(diagnostic.help.iter().map(String::as_str)) {
            line.push_str("; ");
            line.push_str(more);
        }
        line
    }

    /// All messages, in colours for a terminal.
    pub fn coloured(&self) -> String {
        self.render(&Renderer::styled())
    }

    fn render(&self, renderer: &Renderer) -> String {
        let mut out = String::new();
        for diagnostic in self.list() {
            out.push_str(&renderer.render(&[self.group(diagnostic)]));
            out.push_str("\n\n");
        }
        if self.more > 0 {
            out.push_str(&format!("{} more messages like these are not shown\n", self.more));
        }
        match self.faults {
            0 => {}
            1 => out.push_str("the deck has 1 fault\n"),
            n => out.push_str(&format!("the deck has {n} faults\n")),
        }
        out
    }

    fn group<'a>(&'a self, diagnostic: &'a Diagnostic) -> Group<'a> {
        let level = match diagnostic.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
            Severity::Note => Level::NOTE,
        };
        let places = diagnostic.primary.iter().map(|p| (AnnotationKind::Primary, p));
        let places = places.chain(diagnostic.related.iter().map(|p| (AnnotationKind::Context, p)));
        let snippets = places.map(|(kind, (at, said))| self.snippet(kind, *at, said));
        let group = level.primary_title(diagnostic.title.as_str()).elements(snippets);
        group.elements(diagnostic.help.iter().map(|help| Level::HELP.message(help.as_str())))
    }

    fn snippet<'a>(
        &'a self,
        kind: AnnotationKind,
        at: Span,
        said: &'a str,
    ) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
        let source = &self.sources[at.source as usize];
        let line = source.line_range(at.start);
        let from = (at.start as usize).clamp(line.start, line.end) - line.start;
        let to = (at.end as usize).clamp(line.start + from, line.end) - line.start;
        let mut mark = kind.span(from..to.max(from));
        if !said.is_empty() {
            mark = mark.label(said);
        }
        let snippet = Snippet::source(&source.text[line]).line_start(source.line(at.start) as usize);
        snippet.path(&*source.name).annotation(mark)
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.render(&Renderer::plain()).trim_end())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_lines() -> Diagnostics {
        Diagnostics::new(vec![Arc::new(Source { name: "a.inp".into(), text: "*NODE\n*BOUNDRY, OP=NEW\n".into() })])
    }

    #[test]
    fn a_message_shows_file_line_and_word() {
        let mut all = two_lines();
        let at = Span { source: 0, start: 6, end: 14 };
        all.push(
            Diagnostic::error(at, "`*BOUNDRY` is no card").known("BOUNDRY", ["BOUNDARY"]).help("see `fe keywords`"),
        );
        let text = all.to_string();
        assert!(text.contains("a.inp:2:1"), "{text}");
        assert!(text.contains("^^^^^^^^ did you mean `BOUNDARY`?"), "{text}");
        assert!(text.contains("the deck has 1 fault"), "{text}");
        assert!(all.coloured().contains("\u{1b}["));
    }

    #[test]
    fn messages_of_a_kind_are_counted_after_a_few() {
        let mut all = two_lines();
        for node in 0..100 {
            all.push(Diagnostic::error(Span { source: 0, start: 0, end: 1 }, format!("node {node} is not there")));
        }
        assert_eq!((all.list().count(), all.faults()), (5, 100));
        assert!(all.to_string().contains("95 more messages like"));
    }
}
