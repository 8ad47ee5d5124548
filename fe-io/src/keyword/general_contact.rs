use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

const PAIRS: &str = "say `*CONTACT PAIR`";
const FIRST: Field = Field::word("first", "a surface of faces").or("all exterior faces");
const SECOND: Field = Field::word("second", "a surface of faces").or("the first one: it may touch itself");

pub const CONTACT: Keyword = Keyword {
    name: "CONTACT",
    level: Level::Either,
    summary: "general contact of explicit steps; the cards below follow it; holds for later steps too",
    parameters: &[Parameter::choice(
        "OP",
        &[Choice::there("MOD"), Choice::there("NEW")],
        "MOD (default) adds to what holds; NEW first removes it",
    )],
    data: Data::None,
    source: "Abaqus Keywords Reference, *CONTACT",
};

pub const CONTACT_INCLUSIONS: Keyword = Keyword {
    name: "CONTACT INCLUSIONS",
    level: Level::Either,
    summary: "what may touch in general contact, under *CONTACT",
    parameters: &[Parameter::flag(
        "ALL EXTERIOR",
        "all exterior faces, each other and themselves; instead of data lines",
    )],
    data: Data::Lines(&[DataLine::many(&[FIRST, SECOND])]),
    source: "Abaqus Keywords Reference, *CONTACT INCLUSIONS",
};

pub const CONTACT_EXCLUSIONS: Keyword = Keyword {
    name: "CONTACT EXCLUSIONS",
    level: Level::Either,
    summary: "what of the inclusions does not touch, under *CONTACT",
    parameters: &[],
    data: Data::Lines(&[DataLine::many(&[FIRST, SECOND])]),
    source: "Abaqus Keywords Reference, *CONTACT EXCLUSIONS",
};

pub const CONTACT_PROPERTY_ASSIGNMENT: Keyword = Keyword {
    name: "CONTACT PROPERTY ASSIGNMENT",
    level: Level::Either,
    summary: "interactions of general contact, under *CONTACT; the last line that names two faces holds",
    parameters: &[],
    data: Data::Lines(&[DataLine::many(&[FIRST, SECOND, Field::word("interaction", "the *SURFACE INTERACTION")])]),
    source: "Abaqus Keywords Reference, *CONTACT PROPERTY ASSIGNMENT",
};

pub const CONTACT_CONTROLS_ASSIGNMENT: Keyword = Keyword {
    name: "CONTACT CONTROLS ASSIGNMENT",
    level: Level::Either,
    summary: "factors on the penalty stiffness of general contact, under *CONTACT",
    parameters: &[
        Parameter::choice("TYPE", &[Choice::there("SCALE PENALTY")], "SCALE PENALTY").required(),
        Parameter::not_yet("AUTOMATIC OVERCLOSURE RESOLUTION", PAIRS),
    ],
    data: Data::Lines(&[DataLine::many(&[
        FIRST,
        SECOND,
        Field::number("factor", "-", "factor on the default penalty stiffness").above(0.0),
    ])]),
    source: "Abaqus Keywords Reference, *CONTACT CONTROLS ASSIGNMENT",
};
