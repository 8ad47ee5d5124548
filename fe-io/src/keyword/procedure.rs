use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const IMPLICIT: &str = "it is for implicit dynamics";

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

pub const DYNAMIC: Keyword = Keyword {
    name: "DYNAMIC",
    level: Level::Step,
    summary: "an explicit dynamic step: central differences in time",
    parameters: &[
        Parameter::flag("EXPLICIT", "explicit time integration, the only one there is yet"),
        Parameter::flag("DIRECT USER CONTROL", "all increments as long as the data line says"),
        Parameter::flag(
            "ELEMENT BY ELEMENT",
            "increments that the fastest element by itself bears; those that all solids bear together without it",
        ),
        Parameter::of("SCALE FACTOR", Kind::Number, "factor on the stable increment; 1"),
        Parameter::not_yet("FIXED TIME INCREMENTATION", "say `DIRECT USER CONTROL` and the increment"),
        Parameter::not_yet("ADIABATIC", "there are no temperatures"),
        Parameter::idle("IMPROVED DT METHOD", "there is one way to estimate the stable increment of an element"),
        Parameter::not_yet("ALPHA", IMPLICIT),
        Parameter::not_yet("APPLICATION", IMPLICIT),
        Parameter::not_yet("BETA", IMPLICIT),
        Parameter::not_yet("DIRECT", IMPLICIT),
        Parameter::not_yet("GAMMA", IMPLICIT),
        Parameter::not_yet("HAFTOL", IMPLICIT),
        Parameter::not_yet("HALFINC SCALE FACTOR", IMPLICIT),
        Parameter::not_yet("IMPACT", IMPLICIT),
        Parameter::not_yet("INCREMENTATION", IMPLICIT),
        Parameter::not_yet("INITIAL", IMPLICIT),
        Parameter::not_yet("NOHAF", IMPLICIT),
        Parameter::not_yet("RELATIVE TO", IMPLICIT),
        Parameter::not_yet("SINGULAR MASS", IMPLICIT),
        Parameter::not_yet("SOLVER", IMPLICIT),
        Parameter::not_yet("SUBSPACE", IMPLICIT),
        Parameter::not_yet("TIME INTEGRATOR", IMPLICIT),
    ],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("increment", "T", "length of all increments, with DIRECT USER CONTROL")
            .or("the stable increment")
            .above(0.0),
        Field::number("period", "T", "step time").above(0.0),
        Field::number("blank", "T", "always blank").or("nothing"),
        Field::number("maximum", "T", "largest increment").or("no bound").above(0.0),
    ])]),
    source: "Abaqus Keywords Reference, *DYNAMIC",
};

pub const BULK_VISCOSITY: Keyword = Keyword {
    name: "BULK VISCOSITY",
    level: Level::Step,
    summary: "pressure against the rate of change of volume, in explicit steps; holds for later steps too",
    parameters: &[],
    data: Data::Lines(&[DataLine::optional(&[
        Field::number("linear viscosity", "-", "against any rate of volume").or("0.06").least(0.0),
        Field::number("quadratic viscosity", "-", "where the volume shrinks").or("1.2").least(0.0),
    ])]),
    source: "Abaqus Keywords Reference, *BULK VISCOSITY",
};
