use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const ELSET: Parameter = Parameter::name("ELSET", "the elements").required();
const POISSON: Parameter = Parameter::idle("POISSON", "cross-sections keep their size");
const ROTARY: &str = "explicit steps raise it until only stretching limits the increment; static ones have none";
const LUMPED: &str = "masses are lumped in explicit steps; static ones have no inertia";
const GENERAL_INSTEAD: &str = "give area and moments by `*BEAM GENERAL SECTION, SECTION=GENERAL`";
const RECT: Choice = Choice::there("RECT");
const CIRC: Choice = Choice::there("CIRC");
const PIPE: Choice = Choice::there("PIPE");
const THICK_PIPE: Choice = Choice::not_yet("THICK PIPE", "`PIPE` counts its whole wall");

/// A shape that is not there yet.
const fn later(shape: &'static str) -> Choice {
    Choice::not_yet(shape, GENERAL_INSTEAD)
}

const INTEGRATED: &[Choice] = &[
    RECT,
    CIRC,
    PIPE,
    THICK_PIPE,
    later("BOX"),
    later("I"),
    later("L"),
    later("T"),
    later("HEX"),
    later("TRAPEZOID"),
    later("ARBITRARY"),
    later("ELBOW"),
];
const GENERAL: &[Choice] = &[
    Choice::there("GENERAL"),
    RECT,
    CIRC,
    PIPE,
    THICK_PIPE,
    later("BOX"),
    later("I"),
    later("L"),
    later("T"),
    later("HEX"),
    later("TRAPEZOID"),
    later("ARBITRARY"),
    later("MESHED"),
    Choice::not_yet("NONLINEAR GENERAL", "sections are elastic: `SECTION=GENERAL`"),
];

const RECTANGLE: DataLine = DataLine::once(&[
    Field::number("a", "L", "width along axis 1").above(0.0),
    Field::number("b", "L", "height along axis 2").above(0.0),
]);
const CIRCLE: DataLine = DataLine::once(&[Field::number("radius", "L", "radius").above(0.0)]);
const TUBE: DataLine = DataLine::once(&[
    Field::number("outer radius", "L", "outer radius").above(0.0),
    Field::number("wall", "L", "thickness of the wall, at most the radius").above(0.0),
]);
const AXIS: DataLine = DataLine::optional(&[
    Field::number("n1 x", "-", "direction of axis 1 of the cross-section; axis 2 is the beam's direction times axis 1")
        .or("0"),
    Field::number("n1 y", "-", "second component").or("0"),
    Field::number("n1 z", "-", "third component; without a direction (0, 0, −1), as always in the plane").or("0"),
]);

pub const BEAM_SECTION: Keyword = Keyword {
    name: "BEAM SECTION",
    level: Level::Part,
    summary: "gives beams their material and the shape of their cross-section",
    parameters: &[
        ELSET,
        Parameter::name("MATERIAL", "their material").required(),
        Parameter::choice("SECTION", INTEGRATED, "shape of the cross-section").required(),
        POISSON,
        Parameter::idle("ROTARY INERTIA", ROTARY),
        Parameter::idle("LUMPED", LUMPED),
        Parameter::idle("TEMPERATURE", "there are no temperatures"),
    ],
    data: Data::Lines(&[
        RECTANGLE.when("RECT"),
        CIRCLE.when("CIRC"),
        TUBE.when("PIPE"),
        AXIS,
        DataLine::optional(&[Field::number("points", "-", "integration points: without effect, the section is exact")
            .or("any")
            .repeats()]),
    ]),
    source: "Abaqus Keywords Reference, *BEAM SECTION; shear stiffness κ G A of B21 and B31 with κ = 0.85 (RECT), 0.89 (CIRC), 0.53 (PIPE) after Cowper; no compensation for slender elements. Stresses of beams are not printed",
};

pub const BEAM_GENERAL_SECTION: Keyword = Keyword {
    name: "BEAM GENERAL SECTION",
    level: Level::Part,
    summary: "gives beams area, moments of inertia and moduli",
    parameters: &[
        ELSET,
        Parameter::choice("SECTION", GENERAL, "GENERAL (default): area and moments; or a shape"),
        Parameter::of("DENSITY", Kind::Number, "mass per volume [M/L³]; gravity needs it"),
        Parameter::not_yet("MATERIAL", "write E and G on the third data line"),
        Parameter::not_yet("DEPENDENCIES", "give one line of constants"),
        POISSON,
        Parameter::idle("ROTARY INERTIA", ROTARY),
        Parameter::idle("LUMPED", LUMPED),
        Parameter::idle("ZERO", "there are no temperatures"),
    ],
    data: Data::Lines(&[
        RECTANGLE.when("RECT"),
        CIRCLE.when("CIRC"),
        TUBE.when("PIPE"),
        AXIS,
        DataLine::once(&[
            Field::number("area", "L²", "A").above(0.0),
            Field::number("I11", "L⁴", "∫ x₂² dA: bending about axis 1, with displacement along axis 2").above(0.0),
            Field::number("I12", "L⁴", "∫ x₁ x₂ dA").or("0"),
            Field::number("I22", "L⁴", "∫ x₁² dA; B21 and B23 have no use for it").or("0").least(0.0),
            Field::number("J", "L⁴", "torsion constant; B21 and B23 have no use for it").or("0").least(0.0),
        ])
        .when("GENERAL"),
        DataLine::once(&[
            Field::number("E", "F/L²", "Young's modulus").above(0.0),
            Field::number("G", "F/L²", "shear modulus; B23 has no use for it").or("0").least(0.0),
        ])
        .when("third line"),
    ]),
    source: "Abaqus Keywords Reference, *BEAM GENERAL SECTION; shear stiffness κ G A of B21 and B31 with κ = 1 (GENERAL) and as on *BEAM SECTION",
};
