use super::{Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const CLEARANCE: Keyword = Keyword {
    name: "CLEARANCE",
    level: Level::Model,
    summary: "gaps of a pair at the start that take the place of those between the surfaces, without moving nodes; with SMALL SLIDING",
    parameters: &[
        Parameter::name("SECONDARY", "secondary surface of the pair").alias("SLAVE").required(),
        Parameter::name("MAIN", "its main surface").alias("MASTER").required(),
        Parameter::of("VALUE", Kind::Number, "one gap for all points; negative for an overlap"),
        Parameter::flag("TABULAR", "gaps node by node, in data lines"),
        Parameter::not_yet("BOLT", "give the gaps node by node"),
        Parameter::not_yet("INPUT", "write the lines into the deck, or *INCLUDE them"),
        Parameter::not_yet("CPSET", "it is for explicit dynamics"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("node or set", "label of a node, or a node set"),
        Field::number("gap", "L", "gap at the start, negative for an overlap"),
        Field::number("nx", "-", "normal of the main surface, outward").or("that of the surface"),
        Field::number("ny", "-", "its y component").or("0"),
        Field::number("nz", "-", "its z component").or("0"),
    ])
    .when("TABULAR")]),
    source: "Abaqus Keywords Reference, *CLEARANCE",
};
