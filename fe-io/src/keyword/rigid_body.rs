use super::{Choice, Data, Keyword, Level, Parameter};

pub const RIGID_BODY: Keyword = Keyword {
    name: "RIGID BODY",
    level: Level::Part,
    summary: "an analytical rigid surface, or facets of types R2D2, R3D3 and R3D4, move with a reference node",
    parameters: &[
        Parameter::name("ANALYTICAL SURFACE", "the rigid surface"),
        Parameter::name("ELSET", "the rigid facets, in explicit steps"),
        Parameter::name("REF NODE", "label of the node, or a node set that holds just it").required(),
        Parameter::not_yet("NSET", "give the surface as an analytical one"),
        Parameter::not_yet("PIN NSET", "give the surface as an analytical one"),
        Parameter::not_yet("TIE NSET", "give the surface as an analytical one"),
        Parameter::not_yet("ROT NODE", "the reference node holds the rotations too: freedoms 4 to 6"),
        Parameter::not_yet("ISOTHERMAL", "there are no temperatures"),
        Parameter::choice(
            "POSITION",
            &[
                Choice::there("INPUT"),
                Choice::not_yet("CENTER OF MASS", "give the reference node the coordinates of the centre of mass"),
            ],
            "INPUT (default): the reference node stands where the deck puts it",
        ),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *RIGID BODY",
};
