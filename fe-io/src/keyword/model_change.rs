use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

pub const MODEL_CHANGE: Keyword = Keyword {
    name: "MODEL CHANGE",
    level: Level::Step,
    summary: "contact pairs are removed, which lets their forces ramp to zero over the step, or act again; holds for later steps too",
    parameters: &[
        Parameter::choice(
            "TYPE",
            &[Choice::there("CONTACT PAIR"), Choice::not_yet("ELEMENT", "contact pairs are removed and added")],
            "CONTACT PAIR",
        )
        .required(),
        Parameter::flag("REMOVE", "the pairs act no longer"),
        Parameter::flag("ADD", "the pairs act again, all open at first"),
        Parameter::not_yet("ACTIVATE", "say `REMOVE` or `ADD`"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("secondary", "secondary surface of a contact pair"),
        Field::word("main", "its main surface"),
    ])]),
    source: "Abaqus Keywords Reference, *MODEL CHANGE",
};
