use super::{Data, DataLine, Field, Keyword, Level, Parameter};

pub const ELEMENT: Keyword = Keyword {
    name: "ELEMENT",
    level: Level::Part,
    summary: "elements: label and nodes",
    parameters: &[
        Parameter::name("TYPE", "a solid: C3D4, C3D10 (C3D10M is taken as it), C3D8, CPE3, CPE4, CPS3, CPS4, CAX3, CAX4, in explicit steps with one integration point C3D8R, CPE4R, CPS4R, CAX4R; a truss: T2D2, T3D2, T3D3 (end, middle, end); a beam: B21, B23, B31, B33; of nodes: SPRING1, SPRING2, SPRINGA, DASHPOT1, DASHPOT2, DASHPOTA, MASS; contact: GAPUNI, GAPCYL, GAPSPHER, ITT21, ITT31; facets of rigid bodies in explicit steps: R2D2, R3D3, R3D4").required(),
        Parameter::name("ELSET", "element set that the elements are added to"),
        Parameter::not_yet("INPUT", "say `*ELEMENT` and in the next line `*INCLUDE, INPUT=file`"),
        Parameter::not_yet("OFFSET", "write the labels as they shall be"),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::whole("label", "label of the element"),
        Field::whole("node", "labels of its nodes; a line that ends with a comma goes on in the next").repeats(),
    ])]),
    source: "Abaqus Keywords Reference, *ELEMENT",
};

pub const ELSET: Keyword = Keyword {
    name: "ELSET",
    level: Level::Part,
    summary: "an element set; several cards of one name add up",
    parameters: &[
        Parameter::name("ELSET", "name of the set").required(),
        Parameter::flag("GENERATE", "each data line is first, last, step"),
        Parameter::idle("UNSORTED", "sets are kept in ascending order"),
        Parameter::silent("INTERNAL", "of no meaning here"),
        Parameter::name(
            "INSTANCE",
            "in the assembly: the labels and sets of the data lines are those of this instance",
        ),
    ],
    data: Data::Lines(&[
        DataLine::many(&[
            Field::word("element or set", "label of an element, or an element set defined above").repeats()
        ]),
        DataLine::many(&[
            Field::whole("first", "first label"),
            Field::whole("last", "last label"),
            Field::whole("step", "step from label to label").or("1"),
        ])
        .when("GENERATE"),
    ]),
    source: "Abaqus Keywords Reference, *ELSET",
};
