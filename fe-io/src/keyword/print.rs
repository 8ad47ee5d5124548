use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const FREQUENCY: Parameter = Parameter::of(
    "FREQUENCY",
    Kind::Whole,
    "every how many increments, and the last of a step (explicit: without it the last alone); 0 for never",
);
const TOTALS: Parameter = Parameter::choice(
    "TOTALS",
    &[Choice::there("NO"), Choice::there("YES"), Choice::there("ONLY")],
    "NO (default), YES: sums after the table, ONLY: sums",
);
const TIMES: Parameter = Parameter::not_yet("TIME POINTS", "use FREQUENCY");
const SUMMARY: Parameter = Parameter::idle("SUMMARY", "tables have no summary");
const PLANE: Parameter = Parameter::idle("OUTPUT", "plane elements stay plane");
const LOCAL: Parameter = Parameter::idle("GLOBAL", "there are no local systems");
const OFTEN: Parameter = Parameter::not_yet("FREQUENCYF", "use FREQUENCY");

pub const NODE_PRINT: Keyword = Keyword {
    name: "NODE PRINT",
    level: Level::Step,
    summary: "tables of nodal results in JOB.dat; holds until a step has such a card",
    parameters: &[
        Parameter::name("NSET", "the nodes, all without it"),
        FREQUENCY,
        TOTALS,
        TIMES,
        SUMMARY,
        PLANE,
        LOCAL,
        OFTEN,
    ],
    data: Data::Lines(&[DataLine::many(&[Field::word(
        "key",
        "U displacements, RF reactions, in explicit steps V velocities",
    )
    .repeats()])]),
    source: "Abaqus Keywords Reference, *NODE PRINT; layout of the tables as CalculiX",
};

pub const EL_PRINT: Keyword = Keyword {
    name: "EL PRINT",
    level: Level::Step,
    summary: "tables of element results in JOB.dat; holds until a step has such a card",
    parameters: &[
        Parameter::name("ELSET", "the elements, all without it"),
        FREQUENCY,
        Parameter::choice(
            "POSITION",
            &[
                Choice::there("INTEGRATION POINTS"),
                Choice::not_yet("CENTROIDAL", "INTEGRATION POINTS is there"),
                Choice::not_yet("NODES", "INTEGRATION POINTS is there"),
                Choice::not_yet("AVERAGED AT NODES", "the results file holds nodal averages"),
            ],
            "INTEGRATION POINTS (default)",
        ),
        Parameter::choice(
            "TOTALS",
            &[
                Choice::there("NO"),
                Choice::not_yet("YES", "stresses have no sum"),
                Choice::not_yet("ONLY", "stresses have no sum"),
            ],
            "NO (default)",
        ),
        TIMES,
        SUMMARY,
        LOCAL,
        OFTEN,
    ],
    data: Data::Lines(&[DataLine::many(&[Field::word("key", "S stresses, in static steps E strains").repeats()])]),
    source: "Abaqus Keywords Reference, *EL PRINT; layout of the tables as CalculiX",
};

pub const CONTACT_PRINT: Keyword = Keyword {
    name: "CONTACT PRINT",
    level: Level::Step,
    summary: "tables of contact results in JOB.dat; holds until a step has such a card",
    parameters: &[
        FREQUENCY,
        Parameter::name("SECONDARY", "secondary surface of the pair whose force is meant, with MAIN").alias("SLAVE"),
        Parameter::name("MAIN", "main surface of that pair").alias("MASTER"),
        TOTALS,
        Parameter::not_yet("NSET", "name the pair by MAIN and SECONDARY"),
        TIMES,
        SUMMARY,
    ],
    data: Data::Lines(&[DataLine::many(&[Field::word(
        "key",
        "CSTRESS pressure and shear, CDISP gap and slip, CF, CFN, CFS total force of a pair (all, of pressure, of shear)",
    )
    .repeats()])]),
    source: "Abaqus Keywords Reference, *CONTACT PRINT; CF, CFN, CFS and the layout as CalculiX",
};
