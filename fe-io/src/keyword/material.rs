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
    summary: "mass per volume, under *MATERIAL; gravity and explicit steps need it",
    parameters: &[Parameter::not_yet("DEPENDENCIES", "give one number")],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("density", "M/L³", "mass per volume").above(0.0),
        Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
    ])]),
    source: "Abaqus Keywords Reference, *DENSITY",
};

const HARDENING: &str = "isotropic hardening is there";

pub const PLASTIC: Keyword = Keyword {
    name: "PLASTIC",
    level: Level::Model,
    summary: "yield stress of von Mises over plastic strain, under *MATERIAL, with *ELASTIC; for explicit steps",
    parameters: &[
        Parameter::choice(
            "HARDENING",
            &[
                Choice::there("ISOTROPIC"),
                Choice::not_yet("KINEMATIC", HARDENING),
                Choice::not_yet("COMBINED", HARDENING),
                Choice::not_yet("JOHNSON COOK", HARDENING),
                Choice::not_yet("USER", HARDENING),
            ],
            "ISOTROPIC (default)",
        ),
        Parameter::not_yet("RATE", "one table for all rates is there"),
        Parameter::not_yet("DEPENDENCIES", "give two columns"),
        Parameter::not_yet("DATA TYPE", HARDENING),
        Parameter::not_yet("NUMBER BACKSTRESSES", HARDENING),
        Parameter::not_yet("PROPERTIES", HARDENING),
        Parameter::not_yet("SCALESTRESS", "write the stresses as they shall be"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::number("yield stress", "F/L²", "yield stress, which never falls").above(0.0),
        Field::number("plastic strain", "-", "equivalent plastic strain, ascending from 0; constant beyond the last")
            .or("0")
            .least(0.0),
        Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
    ])]),
    source: "Abaqus Keywords Reference, *PLASTIC",
};

const NEO_HOOKE: &str = "say `NEO HOOKE`";

pub const HYPERELASTIC: Keyword = Keyword {
    name: "HYPERELASTIC",
    level: Level::Model,
    summary: "elasticity of large strains, W = C10 (I1 − 3) + (J − 1)²/D1 with I1 at constant volume, under *MATERIAL instead of *ELASTIC; for explicit steps",
    parameters: &[
        Parameter::flag("NEO HOOKE", "the energy above, the only one there is"),
        Parameter::not_yet("ARRUDA-BOYCE", NEO_HOOKE),
        Parameter::not_yet("BETA", NEO_HOOKE),
        Parameter::not_yet("MARLOW", NEO_HOOKE),
        Parameter::not_yet("MOONEY-RIVLIN", NEO_HOOKE),
        Parameter::not_yet("N", NEO_HOOKE),
        Parameter::not_yet("OGDEN", NEO_HOOKE),
        Parameter::not_yet("POISSON", "give D1"),
        Parameter::not_yet("POLYNOMIAL", NEO_HOOKE),
        Parameter::not_yet("PROPERTIES", NEO_HOOKE),
        Parameter::not_yet("REDUCED POLYNOMIAL", NEO_HOOKE),
        Parameter::not_yet("TEST DATA INPUT", "give the constants"),
        Parameter::not_yet("TYPE", NEO_HOOKE),
        Parameter::not_yet("USER", NEO_HOOKE),
        Parameter::not_yet("VAN DER WAALS", NEO_HOOKE),
        Parameter::not_yet("YEOH", NEO_HOOKE),
        Parameter::idle("MODULI", "there is no viscosity, so short and long term are the same"),
    ],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("C10", "F/L²", "half the shear modulus of small strains").above(0.0),
        Field::number("D1", "L²/F", "2 over the bulk modulus of small strains")
            .or("0, which stands for a bulk modulus of 20 shear moduli")
            .least(0.0),
        Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
    ])]),
    source: "Abaqus Keywords Reference, *HYPERELASTIC; bulk modulus without D1 as Abaqus/Explicit",
};

pub const DAMPING: Keyword = Keyword {
    name: "DAMPING",
    level: Level::Model,
    summary: "Rayleigh damping α M + β K in dynamic steps, under *MATERIAL",
    parameters: &[
        Parameter::of(
            "ALPHA",
            Kind::Number,
            "factor [1/T] on the mass of the density, without what mass scaling adds, ≥ 0; 0",
        ),
        Parameter::of(
            "BETA",
            Kind::Number,
            "factor [T] on the elastic stiffness, ≥ 0; it shortens the stable increment; 0",
        ),
        Parameter::not_yet("STRUCTURAL", "ALPHA and BETA are there"),
        Parameter::idle("COMPOSITE", "there are no modes"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *DAMPING",
};
