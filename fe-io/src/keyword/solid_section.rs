use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

pub const SOLID_SECTION: Keyword = Keyword {
    name: "SOLID SECTION",
    level: Level::Part,
    summary: "gives solids and trusses their material, plane ones their thickness, trusses their area",
    parameters: &[
        Parameter::name("ELSET", "the elements").required(),
        Parameter::name("MATERIAL", "their material").required(),
        Parameter::not_yet("ORIENTATION", "isotropic materials need none"),
        Parameter::not_yet("COMPOSITE", "give each layer elements of its own"),
        Parameter::name("CONTROLS", "the *SECTION CONTROLS of elements with one integration point"),
    ],
    data: Data::Lines(&[DataLine::optional(&[Field::number(
        "thickness or area",
        "L or L²",
        "thickness of plane elements, area of trusses; without effect for others",
    )
    .or("1")
    .above(0.0)])]),
    source: "Abaqus Keywords Reference, *SOLID SECTION",
};

const CONTROLS: &str = "HOURGLASS is there";
const RELAX: &str = "ENHANCED, STIFFNESS and VISCOUS are there";

pub const SECTION_CONTROLS: Keyword = Keyword {
    name: "SECTION CONTROLS",
    level: Level::Part,
    summary: "hourglass control of elements with one integration point, for *SOLID SECTION, CONTROLS=",
    parameters: &[
        Parameter::name("NAME", "name of the controls").required(),
        Parameter::choice(
            "HOURGLASS",
            &[
                Choice::there("ENHANCED"),
                Choice::there("STIFFNESS"),
                Choice::there("VISCOUS"),
                Choice::not_yet("COMBINED", RELAX),
                Choice::not_yet("RELAX STIFFNESS", RELAX),
            ],
            "ENHANCED by an assumed strain, STIFFNESS against displacements, VISCOUS against velocities",
        ),
        Parameter::not_yet("CONVERSION CRITERION", CONTROLS),
        Parameter::not_yet("DISTORTION CONTROL", CONTROLS),
        Parameter::not_yet("ELEMENT CONVERSION", CONTROLS),
        Parameter::not_yet("ELEMENT DELETION", CONTROLS),
        Parameter::not_yet("KINEMATIC SPLIT", CONTROLS),
        Parameter::not_yet("LENGTH RATIO", CONTROLS),
        Parameter::not_yet("MAX DEGRADATION", CONTROLS),
        Parameter::not_yet("SECOND ORDER ACCURACY", CONTROLS),
        Parameter::not_yet("VISCOSITY", CONTROLS),
        Parameter::not_yet("WEIGHT FACTOR", CONTROLS),
    ],
    data: Data::Lines(&[DataLine::optional(&[
        Field::number("hourglass scale", "-", "factor on the resistance to hourglass displacements").or("1").above(0.0),
        Field::number("rotational scale", "-", "without effect: there are no shells").or("any"),
        Field::number("out-of-plane scale", "-", "without effect: there are no shells").or("any"),
        Field::number("linear scale", "-", "factor on the linear bulk viscosity, 1 here")
            .or("1")
            .least(1.0)
            .below(1.0 + f64::EPSILON),
        Field::number("quadratic scale", "-", "factor on the quadratic one, 1 here")
            .or("1")
            .least(1.0)
            .below(1.0 + f64::EPSILON),
    ])]),
    source: "Abaqus Keywords Reference, *SECTION CONTROLS",
};
