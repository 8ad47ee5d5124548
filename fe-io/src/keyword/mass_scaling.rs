use super::{Choice, Data, Keyword, Kind, Level, Parameter};

const ELSET: Parameter = Parameter::name("ELSET", "the elements; without it all solids, trusses and beams");
const FACTOR: Parameter = Parameter::of("FACTOR", Kind::Number, "factor on the masses, > 0");
const DT: Parameter =
    Parameter::of("DT", Kind::Number, "stable increment [T] of each element that is aimed at, with TYPE");
const TYPE: Parameter = Parameter::choice(
    "TYPE",
    &[Choice::there("BELOW MIN"), Choice::there("UNIFORM"), Choice::there("SET EQUAL DT")],
    "with DT: BELOW MIN scales elements below it, UNIFORM all by the factor of the worst, SET EQUAL DT each to it",
);

pub const FIXED_MASS_SCALING: Keyword = Keyword {
    name: "FIXED MASS SCALING",
    level: Level::Step,
    summary: "raises masses at the start of an explicit step; holds until a step has such a card",
    parameters: &[ELSET, FACTOR, DT, TYPE],
    data: Data::None,
    source: "Abaqus Keywords Reference, *FIXED MASS SCALING",
};

pub const VARIABLE_MASS_SCALING: Keyword = Keyword {
    name: "VARIABLE MASS SCALING",
    level: Level::Step,
    summary: "raises masses during an explicit step; holds until a step has such a card",
    parameters: &[
        ELSET,
        DT,
        TYPE,
        Parameter::of("FREQUENCY", Kind::Whole, "every how many increments"),
        Parameter::of("NUMBER INTERVAL", Kind::Whole, "at the ends of so many equal parts of the step"),
        Parameter::not_yet("CROSS SECTION NODES", "give DT"),
        Parameter::not_yet("EXTRUDED LENGTH", "give DT"),
        Parameter::not_yet("FEED RATE", "give DT"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *VARIABLE MASS SCALING",
};
