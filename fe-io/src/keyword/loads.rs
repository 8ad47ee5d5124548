use super::boundary::OPERATION;
use super::{Data, DataLine, Field, Keyword, Level, Parameter};

const AMPLITUDE: Parameter =
    Parameter::name("AMPLITUDE", "how the magnitude follows time; without one it ramps over the step");
const USER: Parameter = Parameter::not_yet("USER", "use an amplitude");
const FOLLOWER: Parameter = Parameter::not_yet("FOLLOWER", "displacements are small: directions stay");
const CASES: Parameter = Parameter::not_yet("LOAD CASE", "give each case a step");
const REAL: Parameter = Parameter::idle("REAL", "all loads are real");

pub const CLOAD: Keyword = Keyword {
    name: "CLOAD",
    level: Level::Step,
    summary: "forces and moments on nodes; on the full circumference in axisymmetric models",
    parameters: &[OPERATION, AMPLITUDE, USER, FOLLOWER, CASES, REAL],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("node or set", "label of a node, or a node set"),
        Field::whole("freedom", "1 to 3 force, 4 to 6 moment").least(1.0).below(7.0),
        Field::number("magnitude", "F or F·L", "force or moment on each node"),
    ])]),
    source: "Abaqus Keywords Reference, *CLOAD",
};

pub const DLOAD: Keyword = Keyword {
    name: "DLOAD",
    level: Level::Step,
    summary: "pressure on faces of elements, force per length on trusses and beams, and gravity",
    parameters: &[OPERATION, AMPLITUDE, USER, FOLLOWER, CASES, REAL],
    data: Data::Lines(&[
        DataLine::many(&[
            Field::word("element or set", "label of an element, or an element set"),
            Field::word("kind", "P1 to P6: pressure on that face"),
            Field::number("magnitude", "F/L²", "positive towards the element"),
        ])
        .when("pressure"),
        DataLine::many(&[
            Field::word("element or set", "label of a truss or beam, or an element set"),
            Field::word("kind", "PX, PY or PZ: force per length along x, y or z"),
            Field::number("magnitude", "F/L", "force per length"),
        ])
        .when("on lines"),
        DataLine::many(&[
            Field::word("element or set", "label of an element, or an element set").or("all elements"),
            Field::word("kind", "GRAV"),
            Field::number("magnitude", "L/T²", "acceleration"),
            Field::number("direction", "-", "direction, up to three components").or("0").repeats(),
        ])
        .when("gravity"),
    ]),
    source: "Abaqus Keywords Reference, *DLOAD",
};

pub const DSLOAD: Keyword = Keyword {
    name: "DSLOAD",
    level: Level::Step,
    summary: "pressure on a surface",
    parameters: &[OPERATION, AMPLITUDE, USER, FOLLOWER, CASES, REAL],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("surface", "an element-based surface"),
        Field::word("kind", "P"),
        Field::number("magnitude", "F/L²", "positive towards the body"),
    ])]),
    source: "Abaqus Keywords Reference, *DSLOAD",
};
