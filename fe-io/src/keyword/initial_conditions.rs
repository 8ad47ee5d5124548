use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

const VELOCITY: &str = "a job begins without stress; `TYPE=VELOCITY` is there";

pub const INITIAL_CONDITIONS: Keyword = Keyword {
    name: "INITIAL CONDITIONS",
    level: Level::Part,
    summary: "velocities that explicit steps begin with",
    parameters: &[
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("VELOCITY"),
                Choice::not_yet("ROTATING VELOCITY", "give each node its velocity"),
                Choice::not_yet("STRESS", VELOCITY),
                Choice::not_yet("HARDENING", VELOCITY),
                Choice::not_yet("TEMPERATURE", "there are no temperatures"),
                Choice::not_yet("FIELD", "there are no fields"),
                Choice::not_yet("PLASTIC STRAIN", VELOCITY),
                Choice::not_yet("SOLUTION", VELOCITY),
                Choice::not_yet("CONTACT", "a pair begins as its surfaces lie"),
            ],
            "VELOCITY",
        )
        .required(),
        Parameter::not_yet("INPUT", "say `*INITIAL CONDITIONS` and in the next line `*INCLUDE, INPUT=file`"),
        Parameter::not_yet("STEP", VELOCITY),
        Parameter::not_yet("INC", VELOCITY),
        Parameter::not_yet("FILE", VELOCITY),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("node or set", "label of a node, or a node set"),
        Field::whole("freedom", "1 to 3 translations, 4 to 6 rotations").least(1.0).below(7.0),
        Field::number("velocity", "L/T or rad/T", "velocity at the start of the job"),
    ])]),
    source: "Abaqus Keywords Reference, *INITIAL CONDITIONS",
};
