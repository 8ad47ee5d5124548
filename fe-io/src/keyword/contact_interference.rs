use super::boundary::OPERATION;
use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

pub const CONTACT_INTERFERENCE: Keyword = Keyword {
    name: "CONTACT INTERFERENCE",
    level: Level::Step,
    summary: "overclosure that is let be at the start of a step, and taken out over it",
    parameters: &[
        Parameter::choice(
            "TYPE",
            &[Choice::there("CONTACT PAIR"), Choice::not_yet("ELEMENT", "contact pairs have interferences")],
            "CONTACT PAIR (default)",
        ),
        Parameter::name(
            "AMPLITUDE",
            "factor on the overclosure over time; without one it ramps from 1 to 0 over the step",
        ),
        OPERATION,
        Parameter::flag("SHRINK", "each point begins with its own overclosure, ramped to 0; in the first step"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("secondary", "secondary surface of a contact pair"),
        Field::word("main", "its main surface"),
        Field::number("overclosure", "L", "overclosure that is let be; with a direction, the length of the shift")
            .or("with SHRINK only"),
        Field::number("dx", "-", "direction in which the secondary surface is shifted before contact is looked for")
            .or("along the normals"),
        Field::number("dy", "-", "its y component").or("0"),
        Field::number("dz", "-", "its z component").or("0"),
    ])]),
    source: "Abaqus Keywords Reference, *CONTACT INTERFERENCE",
};
