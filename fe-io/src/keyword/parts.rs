use super::{Data, DataLine, Field, Keyword, Level, Parameter};

const ELSEWHERE: &str = "say `PART=` of a part of this deck";

pub const PART: Keyword = Keyword {
    name: "PART",
    level: Level::Model,
    summary: "begins a part: nodes, elements, sets, surfaces and sections that each *INSTANCE copies",
    parameters: &[Parameter::name("NAME", "name of the part").required()],
    data: Data::None,
    source: "Abaqus Keywords Reference, *PART",
};

pub const END_PART: Keyword = Keyword {
    name: "END PART",
    level: Level::Model,
    summary: "ends a part",
    parameters: &[],
    data: Data::None,
    source: "Abaqus Keywords Reference, *END PART",
};

pub const ASSEMBLY: Keyword = Keyword {
    name: "ASSEMBLY",
    level: Level::Model,
    summary: "begins the assembly: instances of parts, sets and surfaces that name INSTANCE.SET or INSTANCE.label",
    parameters: &[Parameter::name("NAME", "name of the assembly").required()],
    data: Data::None,
    source: "Abaqus Keywords Reference, *ASSEMBLY",
};

pub const END_ASSEMBLY: Keyword = Keyword {
    name: "END ASSEMBLY",
    level: Level::Model,
    summary: "ends the assembly",
    parameters: &[],
    data: Data::None,
    source: "Abaqus Keywords Reference, *END ASSEMBLY",
};

pub const INSTANCE: Keyword = Keyword {
    name: "INSTANCE",
    level: Level::Assembly,
    summary: "begins a copy of a part, moved and turned; sets, surfaces and sections of its own may follow",
    parameters: &[
        Parameter::name("NAME", "name of the instance").required(),
        Parameter::name("PART", "the part").required(),
        Parameter::not_yet("INSTANCE", ELSEWHERE),
        Parameter::not_yet("LIBRARY", ELSEWHERE),
    ],
    data: Data::Lines(&[
        DataLine::optional(TRANSLATION).when("the translation"),
        DataLine::optional(ROTATION).when("the rotation, which follows the translation"),
    ]),
    source: "Abaqus Keywords Reference, *INSTANCE",
};

/// The first data line of `*INSTANCE`.
pub const TRANSLATION: &[Field] = &[
    Field::number("x", "L", "translation, first component").or("0"),
    Field::number("y", "L", "translation, second component").or("0"),
    Field::number("z", "L", "translation, third component").or("0"),
];

const ON_AXIS: Field = Field::number("coordinate", "L", "points a and b of the axis, three coordinates each").or("0");

/// The second data line of `*INSTANCE`.
pub const ROTATION: &[Field] = &[
    ON_AXIS,
    ON_AXIS,
    ON_AXIS,
    ON_AXIS,
    ON_AXIS,
    ON_AXIS,
    Field::number("angle", "degrees", "angle about the axis from a to b, right-handed"),
];

pub const END_INSTANCE: Keyword = Keyword {
    name: "END INSTANCE",
    level: Level::Assembly,
    summary: "ends an instance",
    parameters: &[],
    data: Data::None,
    source: "Abaqus Keywords Reference, *END INSTANCE",
};
