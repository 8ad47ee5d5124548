use super::boundary::OPERATION;
use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

const OVERCLOSURE: Field =
    Field::number("overclosure", "L", "overclosure that is let be; with a direction, the length of the shift")
        .or("with SHRINK only");
const Y: Field = Field::number("dy", "-", "its y component").or("0");
const Z: Field = Field::number("dz", "-", "its z component").or("0");

pub const CONTACT_INTERFERENCE: Keyword = Keyword {
    name: "CONTACT INTERFERENCE",
    level: Level::Step,
    summary: "overclosure that is let be at the start of a step, and taken out over it",
    parameters: &[
        Parameter::choice(
            "TYPE",
            &[Choice::there("CONTACT PAIR"), Choice::there("ELEMENT")],
            "CONTACT PAIR (default), or ELEMENT: of contact elements",
        ),
        Parameter::name(
            "AMPLITUDE",
            "factor on the overclosure over time; without one it ramps from 1 to 0 over the step",
        ),
        OPERATION,
        Parameter::flag("SHRINK", "each point begins with its own overclosure, ramped to 0; in the first step"),
    ],
    data: Data::Lines(&[
        DataLine::many(&[
            Field::word("secondary", "secondary surface of a contact pair"),
            Field::word("main", "its main surface"),
            OVERCLOSURE,
            Field::number(
                "dx",
                "-",
                "direction in which the secondary surface is shifted before contact is looked for",
            )
            .or("along the normals"),
            Y,
            Z,
        ])
        .when("CONTACT PAIR"),
        DataLine::many(&[
            Field::word("elements", "set of contact elements, that of their *GAP or *INTERFACE"),
            OVERCLOSURE,
            Field::number(
                "dx",
                "-",
                "direction in which the second node of gap elements, or the node of tubes, is shifted",
            )
            .or("along the normals"),
            Y,
            Z,
        ])
        .when("ELEMENT"),
    ]),
    source: "Abaqus Keywords Reference, *CONTACT INTERFERENCE",
};
