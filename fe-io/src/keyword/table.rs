//! What a table of a card is made of.

/// One card.
#[derive(Debug)]
pub struct Keyword {
    /// Name without the star, capitals.
    pub name: &'static str,
    /// Where it may stand.
    pub level: Level,
    /// One line for the manual.
    pub summary: &'static str,
    /// What may follow the keyword.
    pub parameters: &'static [Parameter],
    /// What follows in lines of its own.
    pub data: Data,
    /// Where the meaning is from, and where it differs.
    pub source: &'static str,
}

/// Where a card may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Before the first step, outside of parts and of the assembly.
    Model,
    /// Before the first step: in a part, in an instance, in the assembly or outside of them.
    Part,
    /// In the assembly.
    Assembly,
    /// Between `*STEP` and `*END STEP`.
    Step,
    /// Before the first step outside of parts and of the assembly, or in a step.
    Either,
    /// As `Part`, or in a step.
    Anywhere,
}

/// How far a word is supported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// It works.
    There,
    /// Known, but not there yet: refused by name. What there is instead.
    NotYet(&'static str),
    /// Known and without effect here, which is remarked. Why.
    Idle(&'static str),
    /// Known and without meaning here, which nobody needs to be told.
    Silent,
}

/// One parameter of a keyword line.
#[derive(Debug)]
pub struct Parameter {
    /// Name, capitals.
    pub name: &'static str,
    /// Another name for the same.
    pub alias: Option<&'static str>,
    /// What may stand behind `=`.
    pub kind: Kind,
    /// It must be there.
    pub required: bool,
    /// How far it is supported.
    pub standing: Standing,
    /// One line for the manual.
    pub meaning: &'static str,
}

/// What may stand behind a parameter's `=`.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Nothing.
    Flag,
    /// Anything, or nothing.
    Any,
    /// A name, compared in capitals.
    Name,
    /// A number.
    Number,
    /// A whole number, not negative.
    Whole,
    /// A text, taken as written.
    Text,
    /// One of some words.
    Choice(&'static [Choice]),
    /// One of some words, or nothing, which means the first of them.
    OptionalChoice(&'static [Choice]),
    /// `HARD` or the keyword of a law of the library.
    Law(&'static [Choice]),
}

/// One of the words that a parameter may have.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// The word, capitals.
    pub word: &'static str,
    /// How far it is supported.
    pub standing: Standing,
}

/// What follows a keyword line.
#[derive(Clone, Copy, Debug)]
pub enum Data {
    /// Nothing.
    None,
    /// A free text.
    Text(&'static str),
    /// Lines of fields.
    Lines(&'static [DataLine]),
}

impl Data {
    /// How many data lines there may be, whatever the parameters; `None`: any number.
    pub fn most(&self) -> Option<usize> {
        match self {
            Data::None => Some(0),
            Data::Text(_) => None,
            Data::Lines(lines) if lines.iter().any(|line| line.repeat == Repeat::Many) => None,
            Data::Lines(lines) => Some(lines.len()),
        }
    }
}

/// One kind of data line.
#[derive(Debug)]
pub struct DataLine {
    /// How often it may come.
    pub repeat: Repeat,
    /// When it is meant; empty for always.
    pub when: &'static str,
    /// The fields.
    pub fields: &'static [Field],
}

/// How often a data line may come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repeat {
    /// Once.
    Once,
    /// Once or not at all.
    Optional,
    /// As often as needed.
    Many,
}

/// One field of a data line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Name in messages.
    pub name: &'static str,
    /// Dimension, say `F/L³`; empty for names.
    pub dimension: &'static str,
    /// One line for the manual.
    pub meaning: &'static str,
    /// What kind of entry.
    pub kind: FieldKind,
    /// It must be there.
    pub required: bool,
    /// What a blank stands for; empty where it must be there.
    pub blank: &'static str,
    /// Smallest allowed number, itself excluded.
    pub above: f64,
    /// Smallest allowed number.
    pub least: f64,
    /// Largest allowed number, itself excluded.
    pub below: f64,
    /// Further fields like this one follow.
    pub repeats: bool,
}

/// What kind of entry a field holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldKind {
    /// A number.
    Number,
    /// A whole number, not negative.
    Whole,
    /// A word or a name.
    Word,
}

const FIELD: Field = Field {
    name: "",
    dimension: "",
    meaning: "",
    kind: FieldKind::Word,
    required: true,
    blank: "",
    above: f64::NEG_INFINITY,
    least: f64::NEG_INFINITY,
    below: f64::INFINITY,
    repeats: false,
};

impl Field {
    /// A number with its dimension.
    pub const fn number(name: &'static str, dimension: &'static str, meaning: &'static str) -> Self {
        Field { name, dimension, meaning, kind: FieldKind::Number, ..FIELD }
    }

    /// A whole number.
    pub const fn whole(name: &'static str, meaning: &'static str) -> Self {
        Field { name, dimension: "-", meaning, kind: FieldKind::Whole, ..FIELD }
    }

    /// A word or a name.
    pub const fn word(name: &'static str, meaning: &'static str) -> Self {
        Field { name, meaning, ..FIELD }
    }

    /// A line of its own that defines a quantity, `name = …`.
    pub const fn quantity(name: &'static str, dimension: &'static str, meaning: &'static str) -> Self {
        Field { dimension, ..Field::word(name, meaning) }
    }

    /// It may be blank, and then means this.
    pub const fn or(mut self, blank: &'static str) -> Self {
        self.required = false;
        self.blank = blank;
        self
    }

    /// Larger than this.
    pub const fn above(mut self, value: f64) -> Self {
        self.above = value;
        self
    }

    /// At least this.
    pub const fn least(mut self, value: f64) -> Self {
        self.least = value;
        self
    }

    /// Less than this.
    pub const fn below(mut self, value: f64) -> Self {
        self.below = value;
        self
    }

    /// As often as needed.
    pub const fn repeats(mut self) -> Self {
        self.repeats = true;
        self
    }

    /// The allowed range in words; empty when any number will do.
    pub fn range(&self) -> String {
        let bound = |sign: &str, value: f64| value.is_finite().then(|| format!("{sign} {value}"));
        let bounds = [bound(">", self.above), bound("≥", self.least), bound("<", self.below)];
        bounds.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }

    /// True for a number in the range.
    pub fn holds(&self, value: f64) -> bool {
        value > self.above && value >= self.least && value < self.below
    }
}

impl Parameter {
    const fn new(name: &'static str, kind: Kind, standing: Standing, meaning: &'static str) -> Self {
        Parameter { name, alias: None, kind, required: false, standing, meaning }
    }

    /// A parameter that takes a value of some kind.
    pub const fn of(name: &'static str, kind: Kind, meaning: &'static str) -> Self {
        Self::new(name, kind, Standing::There, meaning)
    }

    /// A parameter without value.
    pub const fn flag(name: &'static str, meaning: &'static str) -> Self {
        Self::of(name, Kind::Flag, meaning)
    }

    /// A parameter with a name.
    pub const fn name(name: &'static str, meaning: &'static str) -> Self {
        Self::of(name, Kind::Name, meaning)
    }

    /// A parameter with one of some words.
    pub const fn choice(name: &'static str, words: &'static [Choice], meaning: &'static str) -> Self {
        Self::of(name, Kind::Choice(words), meaning)
    }

    /// Known, but not there yet.
    pub const fn not_yet(name: &'static str, instead: &'static str) -> Self {
        Self::new(name, Kind::Any, Standing::NotYet(instead), "not there yet")
    }

    /// Known and without effect here.
    pub const fn idle(name: &'static str, why: &'static str) -> Self {
        Self::new(name, Kind::Any, Standing::Idle(why), "without effect here")
    }

    /// Known and without meaning here.
    pub const fn silent(name: &'static str, why: &'static str) -> Self {
        Self::new(name, Kind::Any, Standing::Silent, why)
    }

    /// It must be there.
    pub const fn required(mut self) -> Self {
        self.required = true;
        self
    }

    /// Another name for the same.
    pub const fn alias(mut self, name: &'static str) -> Self {
        self.alias = Some(name);
        self
    }
}

impl Choice {
    /// A word that works.
    pub const fn there(word: &'static str) -> Self {
        Choice { word, standing: Standing::There }
    }

    /// A word that is known, but not there yet; what there is instead.
    pub const fn not_yet(word: &'static str, instead: &'static str) -> Self {
        Choice { word, standing: Standing::NotYet(instead) }
    }
}

impl DataLine {
    /// One line.
    pub const fn once(fields: &'static [Field]) -> Self {
        DataLine { repeat: Repeat::Once, when: "", fields }
    }

    /// One line or none.
    pub const fn optional(fields: &'static [Field]) -> Self {
        DataLine { repeat: Repeat::Optional, when: "", fields }
    }

    /// Lines.
    pub const fn many(fields: &'static [Field]) -> Self {
        DataLine { repeat: Repeat::Many, when: "", fields }
    }

    /// When it is meant.
    pub const fn when(mut self, when: &'static str) -> Self {
        self.when = when;
        self
    }
}
