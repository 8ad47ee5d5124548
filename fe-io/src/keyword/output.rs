use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const FREQUENCY: Parameter =
    Parameter::of("FREQUENCY", Kind::Whole, "every how many increments something is stored, and the last of a step");
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
        Parameter::flag(
            "HISTORY",
            "explicit: rows of numbers in time, of what the cards below name; in static steps curves come from *NODE PRINT and *CONTACT PRINT",
        ),
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
            "explicit: at the ends of so many equal parts of the step; 20, of histories 200",
        ),
        Parameter::of("TIME INTERVAL", Kind::Number, "explicit: every so long [T] of step time"),
        Parameter::not_yet("TIME POINTS", OFTEN),
        Parameter::choice(
            "TIME MARKS",
            &[Choice::there("NO"), Choice::there("YES")],
            "explicit: NO (default): with the increment that reaches the time; YES: increments end at these times",
        ),
        Parameter::idle("NAME", "there is one results file"),
        Parameter::not_yet("DIAGNOSTIC", "the log holds the iterations"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *OUTPUT",
};

const FIELDS: &[Parameter] = &[
    VARIABLE,
    FREQUENCY,
    Parameter::name("NSET", "the nodes of a history; fields are stored for the whole model"),
    Parameter::name("ELSET", "the elements of a history; fields are stored for the whole model"),
    Parameter::name("SECONDARY", "secondary surface of the pair of a history, with MAIN").alias("SLAVE"),
    Parameter::name("MAIN", "main surface of that pair").alias("MASTER"),
    Parameter::idle("SURFACE", REGION),
    Parameter::not_yet("CPSET", REGION),
    Parameter::idle("POSITION", "stresses are those of elements, in static steps also averaged at the nodes"),
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

const NODE: &[DataLine] = &[DataLine::many(&[Field::word(
    "field",
    "U displacements, RF reactions, in explicit steps V velocities; histories also of one component, U1",
)
.repeats()])];
const ELEMENT: &[DataLine] = &[DataLine::many(&[Field::word(
    "field",
    "S stresses, MISES, E strains, of lines SF and SM; in explicit steps S, MISES, PEEQ, histories also of one component, S11",
)
.repeats()])];
const CONTACT: &[DataLine] = &[DataLine::many(&[Field::word(
    "field",
    "CSTRESS pressure and shear, CDISP gap and slip, CSTATUS, CFORCE, CNAREA; histories: CFN, CFS, CFT, CMT, CAREA",
)
.repeats()])];

pub const NODE_OUTPUT: Keyword =
    fields("NODE OUTPUT", "nodal fields or histories of the results file, under *OUTPUT", NODE);
pub const ELEMENT_OUTPUT: Keyword =
    fields("ELEMENT OUTPUT", "element fields or histories of the results file, under *OUTPUT", ELEMENT);
pub const CONTACT_OUTPUT: Keyword =
    fields("CONTACT OUTPUT", "contact fields or histories of the results file, under *OUTPUT", CONTACT);
pub const NODE_FILE: Keyword = fields("NODE FILE", "nodal fields of the results file", NODE);
pub const EL_FILE: Keyword = fields("EL FILE", "element fields of the results file", ELEMENT);
pub const CONTACT_FILE: Keyword = fields("CONTACT FILE", "contact fields of the results file", CONTACT);

pub const ENERGY_OUTPUT: Keyword = Keyword {
    name: "ENERGY OUTPUT",
    level: Level::Step,
    summary: "energies of explicit steps in time, under *OUTPUT, HISTORY: all of them stand side by side",
    parameters: &[
        VARIABLE,
        Parameter::not_yet("ELSET", "energies are those of the whole model"),
        Parameter::not_yet("PER ELEMENT SET", "energies are those of the whole model"),
        Parameter::not_yet("TIME POINTS", OFTEN),
    ],
    data: Data::Lines(&[DataLine::many(&[Field::word(
        "energy",
        "ALLKE, ALLSE, ALLPD, ALLAE, ALLIE, ALLVD, ALLFD, ALLCW (contact), ALLWK, DMASS (mass that scaling has added, %), ETOTAL",
    )
    .repeats()])]),
    source: "Abaqus Keywords Reference, *ENERGY OUTPUT",
};
