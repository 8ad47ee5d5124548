//! Text to cards, each with its place. What the words mean is no matter here.

pub mod card;
pub mod nearest;
pub mod number;
mod scan;
pub mod source;

use crate::diagnostic::Diagnostics;
use card::{Card, Line, Lines};
pub(crate) use scan::bytes_of;
use source::{Source, Span};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A deck as written, included files in their places.
#[derive(Clone, Debug)]
pub struct Deck {
    /// The files, the deck itself first.
    pub sources: Vec<Arc<Source>>,
    /// Folder of each file, from which the names in it are looked up.
    pub folders: Vec<PathBuf>,
    /// The cards in order.
    pub cards: Vec<Card>,
}

impl Deck {
    /// Reads a deck and all that it includes.
    pub fn read(path: impl AsRef<Path>) -> Result<Deck, Diagnostics> {
        scan::read(path.as_ref())
    }

    /// A deck from a text; files that it includes are looked up in the working folder.
    pub fn from_text(name: &str, text: &str) -> Result<Deck, Diagnostics> {
        scan::from_text(name, text)
    }

    /// The text of a span.
    pub fn text(&self, span: Span) -> &str {
        &self.sources[span.source as usize].text[span.start as usize..span.end as usize]
    }

    /// Data lines of a card; comments are left out, blank lines are not.
    pub fn all_lines<'a>(&'a self, card: &'a Card) -> impl Iterator<Item = Line<'a>> + Clone {
        card.data.iter().flat_map(|&piece| Lines::new(&self.sources[piece.source as usize], piece))
    }

    /// Data lines of a card, without comments and blank lines.
    pub fn lines<'a>(&'a self, card: &'a Card) -> impl Iterator<Item = Line<'a>> + Clone {
        self.all_lines(card).filter(|line| !line.text.is_empty())
    }
}
