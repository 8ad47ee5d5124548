use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const ITERATIONS: &str = "-";

pub const CONTROLS: Keyword = Keyword {
    name: "CONTROLS",
    level: Level::Step,
    summary: "when an increment counts as converged, and when it is cut back; holds for later steps too",
    parameters: &[
        Parameter::choice(
            "PARAMETERS",
            &[
                Choice::there("FIELD"),
                Choice::there("TIME INCREMENTATION"),
                Choice::there("BALANCE"),
                Choice::not_yet("LINE SEARCH", "there is no line search"),
                Choice::not_yet("CONSTRAINTS", "there are no multipliers"),
                Choice::not_yet("CONTACT", "statuses settle by CONVERT SDI"),
                Choice::not_yet("CONTACT CONTROLS", "statuses settle by CONVERT SDI"),
                Choice::not_yet("DIRECT CYCLIC", "there are static steps"),
            ],
            "which of the data lines below",
        ),
        Parameter::flag("RESET", "all controls get their defaults"),
        Parameter::choice("ANALYSIS", &[Choice::there("DISCONTINUOUS")], "DISCONTINUOUS: I_0 = 8, I_R = 10"),
        Parameter::of(
            "FIELD",
            Kind::Choice(&[
                Choice::there("DISPLACEMENT"),
                Choice::there("GLOBAL"),
                Choice::not_yet("ROTATION", "controls hold for all freedoms"),
                Choice::not_yet("TEMPERATURE", "there are no temperatures"),
            ]),
            "DISPLACEMENT (default) or GLOBAL",
        ),
        Parameter::not_yet("TYPE", "give the control itself"),
    ],
    data: Data::Lines(&[
        DataLine::once(FIELD).when("PARAMETERS=FIELD"),
        DataLine::once(COUNTS).when("PARAMETERS=TIME INCREMENTATION, first line"),
        DataLine::optional(FACTORS).when("PARAMETERS=TIME INCREMENTATION, second line"),
        DataLine::once(BALANCE).when("PARAMETERS=BALANCE, Signorini's own"),
    ]),
    source: "Abaqus Analysis User's Manual, Commonly used control parameters",
};

const IDLE: &str = "without effect here";

/// PARAMETERS=FIELD.
pub const FIELD: &[Field] = &[
    Field::number("R_n", "-", "largest residual over the average force").or("5e-3").above(0.0),
    Field::number("C_n", "-", "largest correction over the largest increment").or("1e-2").above(0.0),
    Field::number("q_0", "F", IDLE).or("any"),
    Field::number("q_u", "F", IDLE).or("any"),
    Field::number("R_P", "-", "residual after I_P iterations").or("2e-2").above(0.0),
    Field::number("ε", "-", IDLE).or("any"),
    Field::number("C_ε", "-", IDLE).or("any"),
    Field::number("R_l", "-", IDLE).or("any"),
];

/// PARAMETERS=TIME INCREMENTATION, first line.
pub const COUNTS: &[Field] = &[
    Field::whole("I_0", "iterations before divergence is looked for").or("4").least(1.0),
    Field::whole("I_R", "iterations before slow convergence is looked for").or("8").least(1.0),
    Field::whole("I_P", "iterations before R_P replaces R_n").or("9").least(1.0),
    Field::whole("I_C", "most iterations").or("16").least(1.0),
    Field::whole("I_L", "more iterations than this shrink the next increment").or("10").least(1.0),
    Field::whole("I_G", "two increments of no more iterations than this enlarge the next").or("4").least(1.0),
    Field::whole("I_S", "most iterations with changes of status, CONVERT SDI=NO").or("12").least(1.0),
    Field::whole("I_A", "most attempts for one increment").or("5").least(1.0),
    Field::whole("I_J", IDLE).or("any"),
    Field::whole("I_T", IDLE).or("any"),
    Field::whole("I_S^c", "most iterations with changes of status, CONVERT SDI=YES").or("50").least(1.0),
    Field::whole("I_J^c", IDLE).or("any"),
    Field::whole("I_A^c", IDLE).or("any"),
];

/// PARAMETERS=TIME INCREMENTATION, second line.
pub const FACTORS: &[Field] = &[
    Field::number("D_f", ITERATIONS, "factor on the increment when the residual diverges")
        .or("0.25")
        .above(0.0)
        .below(1.0),
    Field::number("D_C", ITERATIONS, "factor when convergence is slow").or("0.5").above(0.0).below(1.0),
    Field::number("D_B", ITERATIONS, "factor on the next increment after more than I_L iterations")
        .or("0.75")
        .above(0.0)
        .below(1.0),
    Field::number("D_A", ITERATIONS, IDLE).or("any"),
    Field::number("D_S", ITERATIONS, "factor when statuses do not settle").or("0.25").above(0.0).below(1.0),
    Field::number("D_H", ITERATIONS, IDLE).or("any"),
    Field::number("D_D", ITERATIONS, "growth after two easy increments").or("1.5").least(1.0),
    Field::number("W_G", ITERATIONS, IDLE).or("any"),
];

/// PARAMETERS=BALANCE.
pub const BALANCE: &[Field] =
    &[Field::number("balance", "-", "largest residual over the largest force that a result may have")
        .above(0.0)
        .below(1.0)];
