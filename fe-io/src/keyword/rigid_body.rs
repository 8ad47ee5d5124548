use super::{Data, Keyword, Level, Parameter};

pub const RIGID_BODY: Keyword = Keyword {
    name: "RIGID BODY",
    level: Level::Part,
    summary: "an analytical rigid surface moves with a reference node",
    parameters: &[
        Parameter::name("ANALYTICAL SURFACE", "the rigid surface").required(),
        Parameter::name("REF NODE", "label of the node, or a node set that holds just it").required(),
        Parameter::not_yet("ELSET", "give the surface as an analytical one"),
        Parameter::not_yet("NSET", "give the surface as an analytical one"),
        Parameter::not_yet("PIN NSET", "give the surface as an analytical one"),
        Parameter::not_yet("TIE NSET", "give the surface as an analytical one"),
        Parameter::not_yet("ROT NODE", "the reference node holds the rotations too: freedoms 4 to 6"),
        Parameter::not_yet("ISOTHERMAL", "there are no temperatures"),
        Parameter::idle("POSITION", "a static job needs no centre of mass"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *RIGID BODY",
};
