use super::{Choice, Data, DataLine, Field, Keyword, Level, Parameter};

pub const NODE: Keyword = Keyword {
    name: "NODE",
    level: Level::Part,
    summary: "nodes: label and coordinates",
    parameters: &[
        Parameter::name("NSET", "node set that the nodes are added to"),
        Parameter::choice(
            "SYSTEM",
            &[
                Choice::there("R"),
                Choice::not_yet("C", "give Cartesian coordinates"),
                Choice::not_yet("S", "give Cartesian coordinates"),
            ],
            "coordinates: R for Cartesian",
        ),
        Parameter::not_yet("INPUT", "say `*NODE` and in the next line `*INCLUDE, INPUT=file`"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::whole("label", "label of the node"),
        Field::number("x", "L", "first coordinate (the radius in axisymmetric models)").or("0"),
        Field::number("y", "L", "second coordinate (along the axis in axisymmetric models)").or("0"),
        Field::number("z", "L", "third coordinate; plane models have 0").or("0"),
    ])]),
    source: "Abaqus Keywords Reference, *NODE",
};

pub const NSET: Keyword = Keyword {
    name: "NSET",
    level: Level::Part,
    summary: "a node set; several cards of one name add up",
    parameters: &[
        Parameter::name("NSET", "name of the set").required(),
        Parameter::flag("GENERATE", "each data line is first, last, step"),
        Parameter::name("ELSET", "the nodes of the elements of a set, instead of data lines"),
        Parameter::idle("UNSORTED", "sets are kept in ascending order"),
        Parameter::silent("INTERNAL", "of no meaning here"),
        Parameter::idle("FREQUENCY", "of no meaning for a set"),
        Parameter::name(
            "INSTANCE",
            "in the assembly: the labels and sets of the data lines are those of this instance",
        ),
    ],
    data: Data::Lines(&[
        DataLine::many(&[Field::word("node or set", "label of a node, or a node set defined above").repeats()]),
        DataLine::many(&[
            Field::whole("first", "first label"),
            Field::whole("last", "last label"),
            Field::whole("step", "step from label to label").or("1"),
        ])
        .when("GENERATE"),
    ]),
    source: "Abaqus Keywords Reference, *NSET",
};
