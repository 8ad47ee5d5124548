use super::{Data, DataLine, Field, Keyword, Level, Parameter};

pub const SOLID_SECTION: Keyword = Keyword {
    name: "SOLID SECTION",
    level: Level::Part,
    summary: "gives solids and trusses their material, plane ones their thickness, trusses their area",
    parameters: &[
        Parameter::name("ELSET", "the elements").required(),
        Parameter::name("MATERIAL", "their material").required(),
        Parameter::not_yet("ORIENTATION", "isotropic materials need none"),
        Parameter::not_yet("COMPOSITE", "give each layer elements of its own"),
        Parameter::idle("CONTROLS", "the elements have no hourglass or other controls"),
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
