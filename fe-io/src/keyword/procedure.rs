use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const STATIC: Keyword = Keyword {
    name: "STATIC",
    level: Level::Step,
    summary: "a static step, in increments",
    parameters: &[
        Parameter::of(
            "DIRECT",
            Kind::OptionalChoice(&[
                Choice::there("YES"),
                Choice::not_yet("NO STOP", "an increment that does not converge ends the job"),
            ]),
            "all increments as large as the first",
        ),
        Parameter::not_yet("RIKS", "prescribe displacements"),
        Parameter::not_yet("STABILIZE", "hold the body by supports or springs"),
        Parameter::not_yet("ALLSDTOL", "hold the body by supports"),
        Parameter::not_yet("CONTINUE", "hold the body by supports"),
        Parameter::not_yet("FULLY PLASTIC", "there is no plasticity"),
        Parameter::idle("LONG TERM", "there is no viscosity"),
        Parameter::idle("FACTOR", "of no meaning without STABILIZE"),
        Parameter::idle("SOLVER", "there is one solver, a direct one"),
        Parameter::not_yet("TIME RESET", "total time runs on through the steps"),
        Parameter::not_yet("TOTAL TIME AT START", "total time begins at 0"),
    ],
    data: Data::Lines(&[DataLine::optional(&[
        Field::number("initial", "T", "first increment, at most the step time").or("the step time").above(0.0),
        Field::number("period", "T", "step time").or("1").above(0.0),
        Field::number("minimum", "T", "smallest increment")
            .or("the first one or 1e-5 of the step, whichever is less")
            .least(0.0),
        Field::number("maximum", "T", "largest increment").or("the step time").least(0.0),
    ])]),
    source: "Abaqus Keywords Reference, *STATIC",
};
