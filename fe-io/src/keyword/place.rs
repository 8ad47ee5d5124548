//! Where cards stand: in the model, a part, the assembly, one of its instances, or a step.

use super::same;
use super::table::{Keyword, Level};
use crate::deck::Deck;
use crate::deck::card::Card;
use crate::diagnostic::{Diagnostic, Diagnostics};

/// Cards that begin and end something; its name with an article.
const BLOCKS: [(&str, &str, &str); 4] = [
    ("STEP", "END STEP", "a step"),
    ("PART", "END PART", "a part"),
    ("ASSEMBLY", "END ASSEMBLY", "the assembly"),
    ("INSTANCE", "END INSTANCE", "an instance"),
];

/// Cards that are model data in static jobs, and may stand in steps of explicit dynamics.
const EXPLICIT: [&str; 4] = ["SURFACE INTERACTION", "SURFACE BEHAVIOR", "CONTACT DAMPING", "CONTACT PAIR"];

/// What a card stands in.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place<'a> {
    /// Number of the step, from 0.
    pub step: Option<usize>,
    /// The `*PART` or the `*INSTANCE`.
    pub block: Option<&'a Card>,
}

/// What has begun and not ended, while cards are read in order.
#[derive(Default)]
pub(super) struct Places<'a> {
    /// True when the deck has an explicit step.
    explicit: bool,
    steps: usize,
    /// Card, its keyword, its end and its name with an article; the innermost last.
    open: Vec<(&'a Card, (&'static str, &'static str, &'static str))>,
}

impl<'a> Places<'a> {
    /// Of a deck, before its first card.
    pub fn of(deck: &'a Deck) -> Self {
        let says = |card: &Card, name: &str| card.parameters.iter().any(|parameter| same(&parameter.name, name));
        let explicit = |card: &Card| same(&card.keyword, "DYNAMIC") && says(card, "EXPLICIT");
        Places { explicit: deck.cards.iter().any(explicit), ..Places::default() }
    }

    /// The place of the next card; one in a wrong place is told.
    pub fn enter(&mut self, card: &'a Card, keyword: &Keyword, diagnostics: &mut Diagnostics) -> Place<'a> {
        let block = BLOCKS.into_iter().find(|(begin, end, _)| [*begin, *end].contains(&keyword.name));
        match block {
            None => self.level(card, keyword, diagnostics),
            Some(block) if block.0 == keyword.name => self.begin(card, keyword, block, diagnostics),
            Some((begin, ..)) => {
                let place = self.here();
                match self.open.iter().rposition(|(_, block)| block.0 == begin) {
                    Some(at) => {
                        self.close(at + 1, None, diagnostics);
                        self.open.pop();
                    }
                    None => {
                        let title = format!("`*{}` without a `*{begin}` before it", keyword.name);
                        diagnostics.push(Diagnostic::error(card.span, title));
                    }
                }
                return place;
            }
        }
        self.here()
    }

    /// The deck ends.
    pub fn end(&mut self, diagnostics: &mut Diagnostics) {
        self.close(0, None, diagnostics);
    }

    fn here(&self) -> Place<'a> {
        let last = |names: &[&str]| self.open.iter().rev().find(|(_, block)| names.contains(&block.0));
        Place {
            step: last(&["STEP"]).map(|_| self.steps - 1),
            block: last(&["PART", "INSTANCE"]).map(|(card, _)| *card),
        }
    }

    fn begin(
        &mut self,
        card: &'a Card,
        keyword: &Keyword,
        block: (&'static str, &'static str, &'static str),
        diagnostics: &mut Diagnostics,
    ) {
        // Instances stand in the assembly; nothing else stands in another.
        let keep = match self.open.last() {
            Some((_, (last, ..))) if block.0 == "INSTANCE" => self.open.len() - usize::from(*last == "INSTANCE"),
            _ => 0,
        };
        self.close(keep, Some(card), diagnostics);
        match block.0 {
            "STEP" => self.steps += 1,
            _ => self.level(card, keyword, diagnostics),
        }
        self.open.push((card, block));
    }

    /// Tells and leaves what is open beyond the first `keep`.
    fn close(&mut self, keep: usize, next: Option<&Card>, diagnostics: &mut Diagnostics) {
        for (card, (begin, end, _)) in self.open.drain(keep..).rev() {
            let title = format!("this {} has no `*{end}`", begin.to_lowercase());
            let fault = Diagnostic::error(card.span, title);
            diagnostics.push(match next {
                Some(next) if begin != "STEP" => fault.related(next.span, "it ends before this"),
                _ => fault,
            });
        }
    }

    fn level(&self, card: &Card, keyword: &Keyword, diagnostics: &mut Diagnostics) {
        let star = format!("`*{}`", keyword.name);
        let fault = |title: String| Diagnostic::error(card.span, format!("{star} {title}"));
        let fault = match (self.open.last(), keyword.level) {
            (Some((_, ("STEP", ..))), _) if self.explicit && EXPLICIT.contains(&keyword.name) => return,
            (Some((step, ("STEP", ..))), Level::Model | Level::Part | Level::Assembly) => {
                let explicit = EXPLICIT.contains(&keyword.name);
                let fault = match explicit {
                    true => {
                        fault("in a step is for explicit dynamics".into()).help("write it before the first `*STEP`")
                    }
                    false => fault("belongs to the model, not into a step".into()),
                };
                fault.related(step.span, "the step begins here")
            }
            (Some((_, ("STEP", ..))), _) | (Some((_, ("ASSEMBLY", ..))), Level::Assembly) => return,
            (None | Some(_), Level::Step) => {
                fault("belongs into a step".into()).help("write it between `*STEP` and `*END STEP`")
            }
            (Some(_), Level::Part | Level::Anywhere) => return,
            (_, Level::Assembly) => {
                fault("belongs into the assembly".into()).help("write it between `*ASSEMBLY` and `*END ASSEMBLY`")
            }
            (Some((block, (begin, end, article))), Level::Model | Level::Either) => {
                let fault = fault(format!("belongs to the model, not into {article}"));
                let fault = fault.related(block.span, format!("the {} begins here", begin.to_lowercase()));
                fault.help(format!("write it after `*{end}`"))
            }
            (None, _) if self.steps > 0 => {
                fault("stands after a step".into()).help("write the model before the first `*STEP`")
            }
            (None, _) => return,
        };
        diagnostics.push(fault);
    }
}
