use super::{Data, DataLine, Field, Keyword, Level, Parameter};

pub const GAP: Keyword = Keyword {
    name: "GAP",
    level: Level::Part,
    summary: "distance, direction and area of gap elements; *SURFACE BEHAVIOR may follow, hard contact without it",
    parameters: &[Parameter::name("ELSET", "the elements, all of one type").required()],
    data: Data::Lines(&[DataLine::once(&[
        Field::number(
            "distance",
            "L",
            "GAPUNI: initial clearance, negative for an overlap; GAPCYL, GAPSPHER: largest distance of the nodes, or negative, the least",
        )
        .or("0, for GAPUNI"),
        Field::number("x", "-", "direction of a GAPUNI from the first node to the second, axis of a GAPCYL; of any length")
            .or("the direction from the first node to the second, for GAPUNI"),
        Field::number("y", "-", "y of the direction or axis").or("0"),
        Field::number("z", "-", "z of the direction or axis").or("0"),
        Field::number("area", "L²", "area of each element, which makes the law's number a pressure")
            .or("the law's number is a force")
            .above(0.0),
    ])]),
    source: "Abaqus Keywords Reference, *GAP",
};
