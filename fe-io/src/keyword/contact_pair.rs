use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const FROZEN: &str = "sliding is infinitesimal: the pairing is that of the start";
const EXPLICIT: &str = "it is for explicit dynamics";

pub const CONTACT_PAIR: Keyword = Keyword {
    name: "CONTACT PAIR",
    level: Level::Model,
    summary: "two surfaces that may touch; without NLGEOM sliding is infinitesimal",
    parameters: &[
        Parameter::name("INTERACTION", "the *SURFACE INTERACTION").required(),
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("NODE TO SURFACE"),
                Choice::there("SURFACE TO SURFACE"),
                Choice::not_yet("MORTAR", "say `TYPE=SURFACE TO SURFACE`"),
                Choice::not_yet("LINMORTAR", "say `TYPE=SURFACE TO SURFACE`"),
                Choice::not_yet("PGLINMORTAR", "say `TYPE=SURFACE TO SURFACE`"),
            ],
            "NODE TO SURFACE (default) or SURFACE TO SURFACE",
        ),
        Parameter::flag("SMALL SLIDING", "the default way of enforcing hard contact becomes that of small sliding"),
        Parameter::of(
            "ADJUST",
            Kind::Text,
            "secondary nodes are moved onto the main surface without strain: those open by no more than a length, or those of a node set, and those that overlap",
        ),
        Parameter::flag(
            "TIED",
            "with ADJUST: secondary nodes that lie on the main surface then neither part nor slide, whatever the interaction says",
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
        Parameter::not_yet("CPSET", EXPLICIT),
        Parameter::not_yet("MECHANICAL CONSTRAINT", EXPLICIT),
        Parameter::not_yet("OP", EXPLICIT),
        Parameter::not_yet("WEIGHT", EXPLICIT),
    ],
    data: Data::Lines(&[DataLine::many(&[
        Field::word("secondary", "surface whose nodes or faces carry the constraints"),
        Field::word("main", "surface that they press on"),
    ])]),
    source: "Abaqus Keywords Reference, *CONTACT PAIR",
};
