use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const GAP: Keyword = Keyword {
    name: "GAP",
    level: Level::Part,
    summary: "distance, direction and area of gap elements; *SURFACE BEHAVIOR and *FRICTION may follow, hard contact without them",
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

pub const INTERFACE: Keyword = Keyword {
    name: "INTERFACE",
    level: Level::Part,
    summary: "radial clearance of tube-to-tube elements, which *SLIDE LINE leads; *SURFACE BEHAVIOR and *FRICTION may follow",
    parameters: &[
        Parameter::name("ELSET", "the elements, all of one type and on one slide line").required(),
        Parameter::silent("NAME", "of no meaning here"),
    ],
    data: Data::Lines(&[DataLine::once(&[Field::number(
        "clearance",
        "L",
        "inner radius of the outer pipe less outer radius of the inner one; negative: sum of the outer radii of pipes side by side",
    )])]),
    source: "Abaqus Keywords Reference, *INTERFACE",
};

pub const SLIDE_LINE: Keyword = Keyword {
    name: "SLIDE LINE",
    level: Level::Part,
    summary: "nodes of the outer pipe, along which tube-to-tube elements are led",
    parameters: &[
        Parameter::name("ELSET", "the elements").required(),
        Parameter::choice(
            "TYPE",
            &[Choice::there("LINEAR"), Choice::there("PARABOLIC")],
            "LINEAR: straight from node to node; PARABOLIC: through three nodes each",
        )
        .required(),
        Parameter::of(
            "SMOOTH",
            Kind::Number,
            "part of each segment beside a corner that is rounded, 0 (default) to below 0.5",
        ),
        Parameter::of(
            "EXTENSION ZONE",
            Kind::Number,
            "how far the line goes on past its ends, of a segment, 0 to 0.2; 0.1 by default",
        ),
        Parameter::flag("GENERATE", "each data line is first, last, step"),
    ],
    data: Data::Lines(&[
        DataLine::many(&[Field::word("node", "labels of the nodes in order").repeats()]),
        DataLine::many(&[
            Field::whole("first", "first label"),
            Field::whole("last", "last label"),
            Field::whole("step", "step from label to label").or("1"),
        ])
        .when("GENERATE"),
    ]),
    source: "Abaqus Keywords Reference, *SLIDE LINE",
};
