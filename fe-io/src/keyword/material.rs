use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const MATERIAL: Keyword = Keyword {
    name: "MATERIAL",
    level: Level::Model,
    summary: "a material; the cards that follow describe it",
    parameters: &[
        Parameter::name("NAME", "name of the material").required(),
        Parameter::of("DESCRIPTION", Kind::Any, "a remark"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *MATERIAL",
};

const ELSEWHERE: &str = "isotropic elasticity is there";

pub const ELASTIC: Keyword = Keyword {
    name: "ELASTIC",
    level: Level::Model,
    summary: "linear elasticity, under *MATERIAL",
    parameters: &[
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("ISOTROPIC"),
                Choice::there("ISO"),
                Choice::not_yet("ORTHOTROPIC", ELSEWHERE),
                Choice::not_yet("ORTHO", ELSEWHERE),
                Choice::not_yet("ENGINEERING CONSTANTS", ELSEWHERE),
                Choice::not_yet("LAMINA", ELSEWHERE),
                Choice::not_yet("ANISOTROPIC", ELSEWHERE),
                Choice::not_yet("ANISO", ELSEWHERE),
                Choice::not_yet("COUPLED TRACTION", ELSEWHERE),
                Choice::not_yet("TRACTION", ELSEWHERE),
                Choice::not_yet("SHEAR", ELSEWHERE),
            ],
            "ISOTROPIC (default)",
        ),
        Parameter::not_yet("DEPENDENCIES", "give one line of constants"),
        Parameter::idle("MODULI", "there is no viscosity, so short and long term are the same"),
    ],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("Young's modulus", "F/L²", "E").above(0.0),
        Field::number("Poisson's ratio", "-", "ν").or("0").above(-1.0).below(0.5),
        Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
    ])]),
    source: "Abaqus Keywords Reference, *ELASTIC",
};

pub const DENSITY: Keyword = Keyword {
    name: "DENSITY",
    level: Level::Model,
    summary: "mass per volume, under *MATERIAL; gravity needs it",
    parameters: &[Parameter::not_yet("DEPENDENCIES", "give one number")],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("density", "M/L³", "mass per volume").above(0.0),
        Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
    ])]),
    source: "Abaqus Keywords Reference, *DENSITY",
};
