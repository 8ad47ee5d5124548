use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const FREQUENCY: Parameter =
    Parameter::of("FREQUENCY", Kind::Whole, "every how many increments a frame is stored, and the last of a step");
const VARIABLE: Parameter = Parameter::choice(
    "VARIABLE",
    &[Choice::there("PRESELECT"), Choice::there("ALL")],
    "PRESELECT: the usual fields, ALL: all of them, instead of data lines",
);
const REGION: &str = "fields are stored for the whole model";
const OFTEN: &str = "use FREQUENCY";

pub const OUTPUT: Keyword = Keyword {
    name: "OUTPUT",
    level: Level::Step,
    summary: "what the results file holds; the *… OUTPUT cards follow",
    parameters: &[
        Parameter::flag("FIELD", "fields of the results file"),
        Parameter::flag("HISTORY", "without effect: curves come from *NODE PRINT and *CONTACT PRINT"),
        FREQUENCY,
        VARIABLE,
        Parameter::of(
            "OP",
            Kind::Choice(&[
                Choice::there("NEW"),
                Choice::not_yet("ADD", "repeat the earlier requests"),
                Choice::not_yet("REPLACE", "say `OP=NEW` and repeat the others"),
            ]),
            "NEW (default)",
        ),
        Parameter::of(
            "NUMBER INTERVAL",
            Kind::Whole,
            "explicit: frames at the ends of so many equal parts of the step; 20",
        ),
        Parameter::of("TIME INTERVAL", Kind::Number, "explicit: frames every so long [T] of step time"),
        Parameter::not_yet("TIME POINTS", OFTEN),
        Parameter::idle("TIME MARKS", "a frame comes with the increment that reaches its time"),
        Parameter::idle("NAME", "there is one results file"),
        Parameter::not_yet("DIAGNOSTIC", "the log holds the iterations"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *OUTPUT",
};

const FIELDS: &[Parameter] = &[
    VARIABLE,
    FREQUENCY,
    Parameter::idle("NSET", REGION),
    Parameter::idle("ELSET", REGION),
    Parameter::idle("SECONDARY", REGION).alias("SLAVE"),
    Parameter::idle("MAIN", REGION).alias("MASTER"),
    Parameter::idle("SURFACE", REGION),
    Parameter::not_yet("CPSET", REGION),
    Parameter::idle("POSITION", "stresses are averaged at the nodes"),
    Parameter::idle("DIRECTIONS", "components are those of the global axes"),
    Parameter::idle("EXTERIOR", REGION),
    Parameter::idle("OUTPUT", "plane elements stay plane"),
    Parameter::idle("GLOBAL", "there are no local systems"),
    Parameter::idle("CONTACT ELEMENTS", "pairs are listed by their nodes"),
    Parameter::not_yet("TIME POINTS", OFTEN),
];

const fn fields(name: &'static str, summary: &'static str, keys: &'static [DataLine]) -> Keyword {
    Keyword {
        name,
        level: Level::Step,
        summary,
        parameters: FIELDS,
        data: Data::Lines(keys),
        source: "Abaqus Keywords Reference, the card of this name; *… FILE as CalculiX",
    }
}

const NODE: &[DataLine] =
    &[DataLine::many(&[
        Field::word("field", "U displacements, RF reactions, in explicit steps V velocities").repeats()
    ])];
const ELEMENT: &[DataLine] = &[DataLine::many(&[Field::word(
    "field",
    "S stresses, MISES, E strains, of lines SF and SM; in explicit steps S, MISES, PEEQ",
)
.repeats()])];
const CONTACT: &[DataLine] =
    &[DataLine::many(&[
        Field::word("field", "CSTRESS pressure and shear, CDISP gap and slip, CSTATUS, CFORCE").repeats()
    ])];

pub const NODE_OUTPUT: Keyword = fields("NODE OUTPUT", "nodal fields of the results file, under *OUTPUT", NODE);
pub const ELEMENT_OUTPUT: Keyword =
    fields("ELEMENT OUTPUT", "element fields of the results file, under *OUTPUT", ELEMENT);
pub const CONTACT_OUTPUT: Keyword =
    fields("CONTACT OUTPUT", "contact fields of the results file, under *OUTPUT", CONTACT);
pub const NODE_FILE: Keyword = fields("NODE FILE", "nodal fields of the results file", NODE);
pub const EL_FILE: Keyword = fields("EL FILE", "element fields of the results file", ELEMENT);
pub const CONTACT_FILE: Keyword = fields("CONTACT FILE", "contact fields of the results file", CONTACT);
