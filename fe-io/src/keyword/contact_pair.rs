use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const FROZEN: &str = "sliding is infinitesimal: the pairing is that of the start";

pub const CONTACT_PAIR: Keyword = Keyword {
    name: "CONTACT PAIR",
    level: Level::Model,
    summary: "two surfaces that may touch; before static steps, where sliding is infinitesimal, or in explicit steps, where a pair holds until a later step deletes it or defines it anew",
    parameters: &[
        Parameter::name(
            "INTERACTION",
            "the *SURFACE INTERACTION; explicit pairs without one are hard and slide freely",
        ),
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("NODE TO SURFACE"),
                Choice::there("SURFACE TO SURFACE"),
                Choice::not_yet("MORTAR", "say `TYPE=SURFACE TO SURFACE`"),
                Choice::not_yet("LINMORTAR", "say `TYPE=SURFACE TO SURFACE`"),
                Choice::not_yet("PGLINMORTAR", "say `TYPE=SURFACE TO SURFACE`"),
            ],
            "static: NODE TO SURFACE (default) or SURFACE TO SURFACE",
        ),
        Parameter::flag(
            "SMALL SLIDING",
            "static: the default way of enforcing hard contact becomes that of small sliding; explicit, kinematic, in the first step: nodes keep their places on the main surface",
        ),
        Parameter::of(
            "ADJUST",
            Kind::Text,
            "static: secondary nodes are moved onto the main surface without strain: those open by no more than a length, or those of a node set, and those that overlap",
        ),
        Parameter::flag(
            "TIED",
            "static, with ADJUST: secondary nodes that lie on the main surface then neither part nor slide, whatever the interaction says",
        ),
        Parameter::idle("EXTENSION ZONE", FROZEN),
        Parameter::idle("HCRIT", FROZEN),
        Parameter::idle("SMOOTH", FROZEN),
        Parameter::idle("NO THICKNESS", "there are no shells"),
        Parameter::idle("TRACKING", FROZEN),
        Parameter::idle("SUPPLEMENTARY CONSTRAINTS", "there is one constraint a node"),
        Parameter::idle("MIDFACE NODES", "faces with a node in the middle are not there"),
        Parameter::idle("MINIMUM DISTANCE", "nothing is damped"),
        Parameter::idle("SLIDING TRANSITION", FROZEN),
        Parameter::not_yet("GEOMETRIC CORRECTION", "refine the mesh"),
        Parameter::name("CPSET", "explicit: name of a set of pairs, for *CONTACT CONTROLS"),
        Parameter::choice(
            "MECHANICAL CONSTRAINT",
            &[Choice::there("KINEMATIC"), Choice::there("PENALTY")],
            "explicit: KINEMATIC (default) corrects accelerations, PENALTY adds forces that grow with the overclosure",
        ),
        Parameter::choice(
            "OP",
            &[Choice::there("ADD"), Choice::there("DELETE")],
            "explicit: ADD (default), or DELETE the pairs of the data lines",
        ),
        Parameter::of(
            "WEIGHT",
            Kind::Number,
            "explicit: 1 makes the first surface the main one, 0 the second; ½ (default between deformable bodies): both are both",
        ),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("secondary", "surface whose nodes or faces carry the constraints"),
        Field::word("main", "surface that they press on"),
    ])]),
    source: "Abaqus Keywords Reference, *CONTACT PAIR",
};
