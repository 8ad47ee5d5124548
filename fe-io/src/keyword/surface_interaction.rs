use super::{Data, DataLine, Field, Keyword, Level, Parameter};

pub const SURFACE_INTERACTION: Keyword = Keyword {
    name: "SURFACE INTERACTION",
    level: Level::Model,
    summary: "how two surfaces act on each other; *SURFACE BEHAVIOR and *FRICTION follow; hard contact that slides freely without them",
    parameters: &[
        Parameter::name("NAME", "name of the interaction").required(),
        Parameter::not_yet("PAD THICKNESS", "move the surface"),
        Parameter::idle("TRACKING THICKNESS", "gaps are reported whatever their size"),
        Parameter::not_yet("USER", "write a law in Rust and add it to the library"),
        Parameter::idle("UNSYMM", "what friction adds that is not symmetric is always taken along"),
        Parameter::not_yet("DEPVAR", "write a law in Rust and add it to the library"),
        Parameter::not_yet("PROPERTIES", "write a law in Rust and add it to the library"),
    ],
    data: Data::Lines(&[DataLine::optional(&[Field::number(
        "thickness or area",
        "L or L²",
        "out-of-plane thickness of a plane model, or the area of every node of a node-based surface",
    )
    .or("thickness of the elements; a node without area")
    .above(0.0)])]),
    source: "Abaqus Keywords Reference, *SURFACE INTERACTION",
};
