use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const SURFACE_BEHAVIOR: Keyword = Keyword {
    name: "SURFACE BEHAVIOR",
    level: Level::Part,
    summary: "pressure against overclosure, under *SURFACE INTERACTION, *GAP or *INTERFACE",
    parameters: &[
        Parameter::of(
            "PRESSURE-OVERCLOSURE",
            Kind::Law(&[
                Choice::there("FORMULA"),
                Choice::there("SCALE FACTOR"),
                Choice::not_yet("TIED", "give both sides common nodes"),
                Choice::not_yet("HERTZ", "it is for discrete elements"),
                Choice::not_yet("JKR", "it is for discrete elements"),
                Choice::not_yet("LKM", "it is for discrete elements"),
            ]),
            "HARD (default) or a softened law; FORMULA: one of your own, written out",
        ),
        Parameter::of(
            "PENALTY",
            Kind::OptionalChoice(&[Choice::there("LINEAR"), Choice::there("NONLINEAR")]),
            "hard contact by a penalty p = f K (h + c); NONLINEAR: with a slope that grows from a part of f K to f K",
        ),
        Parameter::flag(
            "AUGMENTED LAGRANGE",
            "hard contact by a penalty, and multipliers until little overclosure is left",
        ),
        Parameter::flag("DIRECT", "hard contact by multipliers: no overclosure; a softened law as it stands"),
        Parameter::flag("NO SEPARATION", "surfaces that closed never open again"),
    ],
    data: Data::Lines(&[
        DataLine::optional(PENALTY).when("PENALTY or AUGMENTED LAGRANGE"),
        DataLine::optional(NONLINEAR_PENALTY).when("PENALTY=NONLINEAR"),
        DataLine::many(&[]).when("a law: its numbers"),
        DataLine::many(FORMULA).when("FORMULA: definitions in any order, each by others if need be"),
        DataLine::once(SCALE_FACTOR).when("SCALE FACTOR: for general contact in Explicit, refused elsewhere"),
    ]),
    source: "Abaqus Keywords Reference, *SURFACE BEHAVIOR",
};

/// The data line of hard contact by a penalty, alone or with multipliers.
pub const PENALTY: &[Field] = &[
    Field::number("stiffness", "F/L³", "penalty stiffness K")
        .or("10 × the stiffness of the elements beneath, 1000 × with multipliers")
        .above(0.0),
    Field::number("clearance", "L", "clearance c at which the pressure vanishes").or("0"),
    Field::number("scale", "-", "factor f on K").or("1").above(0.0),
];

/// The data line of hard contact by a penalty that grows.
pub const NONLINEAR_PENALTY: &[Field] = &[
    Field::number("final stiffness", "F/L³", "penalty stiffness K of large overclosures")
        .or("100 × the stiffness of the elements beneath")
        .above(0.0),
    Field::number("clearance", "L", "clearance c at which the pressure vanishes").or("0"),
    Field::number("scale", "-", "factor f on K").or("1").above(0.0),
    Field::number("upper limit", "-", "overclosure h + c from which on the slope is f K, over the facets' length")
        .or("0.03")
        .above(0.0),
    Field::number("initial stiffness", "-", "slope where contact begins, over f K").or("0.01").above(0.0).below(1.0),
    Field::number("lower limit", "-", "overclosure up to which the initial slope holds, over that of the upper limit")
        .or("1/3")
        .least(0.0)
        .below(1.0),
];

/// The data lines of a law written as a formula.
pub const FORMULA: &[Field] = &[
    Field::quantity(
        "p = expression",
        "F/L²",
        "pressure, of the overclosure h [L] or the gap g = -h; + - * / ^ ( ), exp log sqrt sin cos tan tanh atan abs, \
         min(a, b), max(a, b), if(a < b, one, other), pi; zero at larger clearances than the reach, and not negative",
    ),
    Field::quantity("reach = number", "L", "clearance from which on the pressure is zero").or("0"),
    Field::quantity("NAME = expression", "", "a constant, or what else p uses; capitals do not count").or("as needed"),
];

/// The data line of the law by scale factors.
pub const SCALE_FACTOR: &[Field] = &[
    Field::number("overclosure factor", "-", "length of a piece, as a part of the smallest element in contact")
        .or("the measure is given")
        .above(0.0),
    Field::number("overclosure measure", "L", "length of a piece").or("the factor is given").above(0.0),
    Field::number("stiffness scale", "-", "factor from the slope of one piece to the next").above(1.0),
    Field::number("initial scale", "-", "factor on the default contact stiffness for the first slope")
        .or("1")
        .above(0.0),
];
