use super::{Data, DataLine, Field, Keyword, Level, Parameter};

const ELSET: Parameter = Parameter::name("ELSET", "the elements").required();
const ORIENTATION: Parameter = Parameter::not_yet("ORIENTATION", "freedoms are those of the global axes");
const DEPENDENCIES: Parameter = Parameter::not_yet("DEPENDENCIES", "give one number");

const FREEDOMS: DataLine = DataLine::once(&[
    Field::whole("freedom", "freedom of the first node: 1 to 3 translation, 4 to 6 rotation").least(1.0).below(7.0),
    Field::whole("freedom", "freedom of the second node, that of the first where none is given")
        .or("the first")
        .least(1.0)
        .below(7.0),
])
.when("a freedom is named: a blank line for elements along their line");

pub const SPRING: Keyword = Keyword {
    name: "SPRING",
    level: Level::Part,
    summary: "gives springs their freedoms and stiffness",
    parameters: &[
        ELSET,
        Parameter::not_yet("NONLINEAR", "linear springs are there: give one stiffness"),
        Parameter::not_yet("COMPLEX STIFFNESS", "linear springs are there: give one stiffness"),
        ORIENTATION,
        DEPENDENCIES,
        Parameter::silent("RTOL", "of no meaning for one stiffness"),
    ],
    data: Data::Lines(&[
        FREEDOMS,
        DataLine::once(&[
            Field::number("stiffness", "F/L or F·L", "force per displacement, or moment per rotation").least(0.0),
            Field::number("frequency", "1/T", "without effect").or("any"),
            Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
        ]),
    ]),
    source: "Abaqus Keywords Reference, *SPRING",
};

pub const DASHPOT: Keyword = Keyword {
    name: "DASHPOT",
    level: Level::Part,
    summary: "gives dashpots their freedoms and viscosity; static steps have no velocity, and so no force of dashpots",
    parameters: &[
        ELSET,
        Parameter::not_yet("NONLINEAR", "linear dashpots are there: give one viscosity"),
        ORIENTATION,
        DEPENDENCIES,
    ],
    data: Data::Lines(&[
        FREEDOMS,
        DataLine::once(&[
            Field::number("viscosity", "F T/L or F·L T", "force per velocity").least(0.0),
            Field::number("frequency", "1/T", "without effect").or("any"),
            Field::number("temperature", "ϑ", "without effect: there are no temperatures").or("any"),
        ]),
    ]),
    source: "Abaqus Keywords Reference, *DASHPOT",
};

pub const ROTARY_INERTIA: Keyword = Keyword {
    name: "ROTARY INERTIA",
    level: Level::Part,
    summary: "gives the rotary inertia of nodes in explicit steps, in global axes at the start; it turns with the node",
    parameters: &[
        ELSET,
        Parameter::not_yet("ORIENTATION", "give the tensor in global axes"),
        Parameter::not_yet("ALPHA", "bodies are not damped against the ground"),
        Parameter::idle("COMPOSITE", "there are no modes"),
    ],
    data: Data::Lines(&[DataLine::once(&[
        Field::number("I11", "M L²", "moment of inertia about axis 1").least(0.0),
        Field::number("I22", "M L²", "about axis 2").or("0").least(0.0),
        Field::number("I33", "M L²", "about axis 3; in the plane the one that counts").or("0").least(0.0),
        Field::number("I12", "M L²", "entry 12 of the tensor, −∫ x₁ x₂ dm").or("0"),
        Field::number("I13", "M L²", "entry 13").or("0"),
        Field::number("I23", "M L²", "entry 23").or("0"),
    ])]),
    source: "Abaqus Keywords Reference, *ROTARY INERTIA",
};

pub const MASS: Keyword = Keyword {
    name: "MASS",
    level: Level::Part,
    summary: "gives the masses of nodes; of these static steps have the weight alone",
    parameters: &[
        ELSET,
        Parameter::not_yet("TYPE", "masses are the same in all directions"),
        Parameter::not_yet("ORIENTATION", "masses are the same in all directions"),
        Parameter::idle("ALPHA", "of implicit dynamics alone"),
        Parameter::idle("COMPOSITE", "there are no modes"),
    ],
    data: Data::Lines(&[DataLine::once(&[Field::number("mass", "M", "mass of each node").above(0.0)])]),
    source: "Abaqus Keywords Reference, *MASS",
};
