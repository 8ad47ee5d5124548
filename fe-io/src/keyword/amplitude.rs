use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

const TABLE: &str = "a table of times and factors is there";

pub const AMPLITUDE: Keyword = Keyword {
    name: "AMPLITUDE",
    level: Level::Either,
    summary: "how a load or a support follows time: a table, constant outside",
    parameters: &[
        Parameter::name("NAME", "name of the amplitude").required(),
        Parameter::choice(
            "TIME",
            &[Choice::there("STEP TIME"), Choice::there("TOTAL TIME")],
            "STEP TIME (default) or TOTAL TIME",
        ),
        Parameter::choice(
            "DEFINITION",
            &[
                Choice::there("TABULAR"),
                Choice::there("SMOOTH STEP"),
                Choice::not_yet("EQUALLY SPACED", TABLE),
                Choice::not_yet("PERIODIC", TABLE),
                Choice::not_yet("MODULATED", TABLE),
                Choice::not_yet("DECAY", TABLE),
                Choice::not_yet("USER", TABLE),
                Choice::not_yet("SOLUTION DEPENDENT", TABLE),
            ],
            "TABULAR (default): linear between the points; SMOOTH STEP: along 10 τ³ − 15 τ⁴ + 6 τ⁵, at rest in each of them",
        ),
        Parameter::choice(
            "VALUE",
            &[Choice::there("RELATIVE"), Choice::not_yet("ABSOLUTE", "factors on the magnitude are there")],
            "RELATIVE (default): factors on the magnitude",
        ),
        Parameter::not_yet("SMOOTH", "write more points"),
        Parameter::not_yet("INPUT", "say `*AMPLITUDE` and in the next line `*INCLUDE, INPUT=file`"),
        Parameter::not_yet("SHIFTX", "write the times as they shall be"),
        Parameter::not_yet("SHIFTY", "write the factors as they shall be"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::number("time", "T", "time, ascending"),
        Field::number("factor", "-", "factor on the magnitude; up to four pairs a line").repeats(),
    ])]),
    source: "Abaqus Keywords Reference, *AMPLITUDE",
};
