use super::{Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const LIBRARY: &str = "a coefficient by slip rate and pressure, or `EXPONENTIAL DECAY`, is there";

pub const FRICTION: Keyword = Keyword {
    name: "FRICTION",
    level: Level::Anywhere,
    summary: "Coulomb friction, under *SURFACE INTERACTION, *GAP, *INTERFACE or, in a step, *CHANGE FRICTION: the shear is at most μ p; without the card surfaces slide freely",
    parameters: &[
        Parameter::of("ELASTIC SLIP", Kind::Number, "length by which sticking points give way before they slip"),
        Parameter::of(
            "SLIP TOLERANCE",
            Kind::Number,
            "the same as a part of the mean length of the secondary facets of all pairs; 0.005 where nothing is said",
        ),
        Parameter::of(
            "SHEAR TRACTION SLOPE",
            Kind::Number,
            "in explicit steps: shear over the length that sticking points give way by",
        ),
        Parameter::flag("LAGRANGE", "sticking points do not move at all"),
        Parameter::flag("ROUGH", "closed points never slip, whatever presses them"),
        Parameter::of("TAUMAX", Kind::Number, "largest shear, in the unit of the pressure; 0 for none"),
        Parameter::flag("EXPONENTIAL DECAY", "μ falls with the slip rate from μ_s to μ_k"),
        Parameter::flag("TEST DATA", "the decay passes through measured points"),
        Parameter::not_yet("ANISOTROPIC", "say one coefficient for both directions"),
        Parameter::not_yet("DEPENDENCIES", LIBRARY),
        Parameter::not_yet("USER", LIBRARY),
        Parameter::not_yet("DEPVAR", LIBRARY),
        Parameter::not_yet("PROPERTIES", LIBRARY),
    ],
    data: Data::Lines(&[
        DataLine::many(TABLE).when("a coefficient, linear between the lines: slip rates rise, then pressures"),
        DataLine::once(DECAY).when("EXPONENTIAL DECAY: μ = μ_k + (μ_s − μ_k) exp(−d γ̇)"),
        DataLine::many(POINT).when("EXPONENTIAL DECAY, TEST DATA: μ at rest, at a slip rate, at high rates"),
        DataLine::optional(&[]).when("ROUGH: none"),
    ]),
    source: "Abaqus Keywords Reference, *FRICTION",
};

/// A coefficient and where it holds.
pub const TABLE: &[Field] = &[
    Field::number("friction coefficient", "-", "μ").least(0.0),
    Field::number("slip rate", "L/T", "slip rate at which it holds").or("0").least(0.0),
    Field::number("pressure", "F/L²", "pressure at which it holds (what the law's number is)").or("0").least(0.0),
];

/// A decay.
pub const DECAY: &[Field] = &[
    Field::number("static coefficient", "-", "μ_s at rest").least(0.0),
    Field::number("kinetic coefficient", "-", "μ_k at high slip rates").least(0.0),
    Field::number("decay coefficient", "T/L", "d").least(0.0),
];

/// A measured point of a decay.
pub const POINT: &[Field] = &[
    Field::number("friction coefficient", "-", "μ").least(0.0),
    Field::number("slip rate", "L/T", "slip rate at which it was measured, in the second line").or("0").least(0.0),
];
