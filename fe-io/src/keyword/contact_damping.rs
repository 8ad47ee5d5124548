use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const CONTACT_DAMPING: Keyword = Keyword {
    name: "CONTACT DAMPING",
    level: Level::Part,
    summary: "pressure against the speed at which surfaces close or open, on open ones, too; under *SURFACE INTERACTION, *GAP or *INTERFACE",
    parameters: &[
        Parameter::choice(
            "DEFINITION",
            &[Choice::there("DAMPING COEFFICIENT"), Choice::there("CRITICAL DAMPING FRACTION")],
            "DAMPING COEFFICIENT (default); explicit: or CRITICAL DAMPING FRACTION",
        ),
        Parameter::of(
            "TANGENT FRACTION",
            Kind::Number,
            "damping along the surface over that across it; 0, in explicit steps 1",
        ),
    ],
    data: Data::Lines(&[
        STATIC,
        DataLine::once(&[Field::number(
            "coefficient or fraction",
            "F·T/L³ or -",
            "of critical damping √(4 m k), or a coefficient",
        )
        .least(0.0)])
        .when("explicit: closed points alone; without the card a fraction of 0.03 but for hard kinematic contact"),
    ]),
    source: "Abaqus Keywords Reference, *CONTACT DAMPING",
};

const STATIC: DataLine = DataLine::once(&[
    Field::number("coefficient", "F·T/L³", "damping coefficient; times a speed it is what the law's number is")
        .above(0.0),
    Field::number("clearance", "L", "clearance from which on nothing acts").above(0.0),
    Field::number("constant part", "-", "part of that clearance up to which the coefficient acts in full")
        .or("0")
        .least(0.0)
        .below(1.0),
])
.when("static");
