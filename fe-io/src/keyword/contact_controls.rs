use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const SETTLES: &str = "statuses settle by themselves, see CONVERT SDI of *STEP";
const STATIC: &str = "there are no perturbation steps";
const FOUND: &str = "points that may touch are found anew as they move";

pub const CONTACT_CONTROLS: Keyword = Keyword {
    name: "CONTACT CONTROLS",
    level: Level::Step,
    summary: "how contact is enforced and stabilised, for one pair or for all; holds for later steps too, but for STABILIZE",
    parameters: &[
        Parameter::name("SECONDARY", "secondary surface of the pair that is meant, with MAIN; all pairs without")
            .alias("SLAVE"),
        Parameter::name("MAIN", "main surface of that pair").alias("MASTER"),
        Parameter::flag("RESET", "all contact controls get their defaults"),
        Parameter::of("ABSOLUTE PENETRATION TOLERANCE", Kind::Number, "overclosure [L] that AUGMENTED LAGRANGE leaves"),
        Parameter::of(
            "RELATIVE PENETRATION TOLERANCE",
            Kind::Number,
            "overclosure over the facets' length that AUGMENTED LAGRANGE leaves; 0.001, and 0.05 where surfaces may slide far",
        ),
        Parameter::of("STIFFNESS SCALE FACTOR", Kind::Number, "factor on the penalty stiffness"),
        Parameter::of(
            "STABILIZE",
            Kind::Any,
            "resist the surfaces' motion in this step; a value is a factor on the automatic coefficient",
        ),
        Parameter::of("TANGENT FRACTION", Kind::Number, "damping along the surface over that across it; 1"),
        Parameter::choice(
            "LAGRANGE MULTIPLIER",
            &[Choice::there("YES"), Choice::there("NO")],
            "YES: multipliers carry every hard contact, penalty and law, whatever its slope; NO: laws and penalties stand as they \
             are, and hard contact is a penalty unless DIRECT or AUGMENTED LAGRANGE is asked for; without it as is usual",
        ),
        Parameter::not_yet("APPROACH", "say `STABILIZE, TANGENT FRACTION=0.`"),
        Parameter::idle("AUTOMATIC TOLERANCES", SETTLES),
        Parameter::idle("MAXCHP", SETTLES),
        Parameter::idle("PERRMX", SETTLES),
        Parameter::idle("UERRMX", SETTLES),
        Parameter::idle("FRICTION ONSET", "friction acts from the first touch on"),
        Parameter::idle("SLIDE DISTANCE", "sliding is infinitesimal"),
        Parameter::idle("PERTURBATION TANGENT SCALE FACTOR", STATIC),
        Parameter::idle("PRESSURE DEPENDENT PERTURBATION", STATIC),
        Parameter::name("CPSET", "explicit: the set of pairs that is meant"),
        Parameter::of("SCALE PENALTY", Kind::Number, "explicit: factor on the default penalty stiffness; 1"),
        Parameter::idle("GLOBTRKINC", FOUND),
        Parameter::idle("FASTLOCALTRK", FOUND),
        Parameter::idle("WARP CHECK PERIOD", FOUND),
        Parameter::idle("WARP CUT OFF", FOUND),
        Parameter::choice("TYPE", &[Choice::not_yet("SCALE PENALTY", "say `SCALE PENALTY=`")], "not there yet"),
    ],
    data: Data::Lines(&[DataLine::optional(&[
        Field::number("coefficient", "F·T/L³", "damping coefficient")
            .or("1e-3 of the stiffness beneath times the step time")
            .above(0.0),
        Field::number("end", "-", "factor on it at the end of the step, from 1 at its start").or("0").least(0.0),
        Field::number("range", "L", "clearance from which on nothing acts").or("the facets' length").above(0.0),
    ])
    .when("STABILIZE")]),
    source: "Abaqus Keywords Reference, *CONTACT CONTROLS; the automatic coefficient is Signorini's own",
};
