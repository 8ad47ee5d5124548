use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

pub(super) const OPERATION: Parameter = Parameter::choice(
    "OP",
    &[Choice::there("MOD"), Choice::there("NEW")],
    "MOD (default) adds and changes; NEW first removes what is there from earlier",
);

pub const BOUNDARY: Keyword = Keyword {
    name: "BOUNDARY",
    level: Level::Either,
    summary: "prescribed displacements and rotations, in explicit steps velocities and accelerations, too; outside steps they are zero",
    parameters: &[
        OPERATION,
        Parameter::name("AMPLITUDE", "how the values follow time; without one they ramp over a static step, and hold from the start of an explicit one, where displacements other than 0 need one"),
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("DISPLACEMENT"),
                Choice::there("VELOCITY"),
                Choice::there("ACCELERATION"),
            ],
            "DISPLACEMENT (default), VELOCITY or ACCELERATION: the latter two in explicit steps",
        ),
        Parameter::not_yet("FIXED", "prescribe the values that the nodes have"),
        Parameter::not_yet("USER", "use an amplitude"),
        Parameter::not_yet("LOAD CASE", "give each case a step"),
        Parameter::not_yet("SUBMODEL", "prescribe the values"),
        Parameter::not_yet("STEP", "prescribe the values"),
        Parameter::not_yet("REGION TYPE", "name nodes"),
        Parameter::not_yet("PHANTOM", "name nodes of the model"),
        Parameter::not_yet("TIME DELAY", "write the times of the amplitude as they shall be"),
    ],
    data: Data::Lines(&[
        DataLine::many(&[
            Field::word("node or set", "label of a node, or a node set"),
            Field::whole("first", "first freedom: 1 to 3 translations, 4 to 6 rotations").least(1.0).below(7.0),
            Field::whole("last", "last freedom").or("the first one").least(1.0).below(7.0),
            Field::number("value", "L or rad", "prescribed value; of velocities per T, of accelerations per T²").or("0"),
        ])
        .when("freedoms that a node does not have are left out"),
        DataLine::many(&[
            Field::word("node or set", "label of a node, or a node set"),
            Field::word(
                "name",
                "ENCASTRE (1 to 6), PINNED (1 to 3), XSYMM (1, 5, 6), YSYMM (2, 4, 6), ZSYMM (3, 4, 5), XASYMM (2, 3, 4), YASYMM (1, 3, 5), ZASYMM (1, 2, 6)",
            ),
        ])
        .when("by name"),
    ]),
    source: "Abaqus Keywords Reference, *BOUNDARY",
};
