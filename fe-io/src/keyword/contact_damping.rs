use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const CONTACT_DAMPING: Keyword = Keyword {
    name: "CONTACT DAMPING",
    level: Level::Part,
    summary: "pressure against the speed at which surfaces close or open, on open ones, too; under *SURFACE INTERACTION, *GAP or *INTERFACE",
    parameters: &[
        Parameter::choice(
            "DEFINITION",
            &[
                Choice::there("DAMPING COEFFICIENT"),
                Choice::not_yet("CRITICAL DAMPING FRACTION", "it is for explicit dynamics; a coefficient is there"),
            ],
            "DAMPING COEFFICIENT (default)",
        ),
        Parameter::of("TANGENT FRACTION", Kind::Number, "damping along the surface over that across it; 0"),
    ],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("coefficient", "F·T/L³", "damping coefficient; times a speed it is what the law's number is")
            .above(0.0),
        Field::number("clearance", "L", "clearance from which on nothing acts").above(0.0),
        Field::number("constant part", "-", "part of that clearance up to which the coefficient acts in full")
            .or("0")
            .least(0.0)
            .below(1.0),
    ])]),
    source: "Abaqus Keywords Reference, *CONTACT DAMPING",
};
