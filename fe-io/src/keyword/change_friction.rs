use super::{Data, Keyword, Level, Parameter};

pub const CHANGE_FRICTION: Keyword = Keyword {
    name: "CHANGE FRICTION",
    level: Level::Step,
    summary: "the friction of an interaction becomes that of the *FRICTION that follows, and stays so; in the first step it begins at 0",
    parameters: &[
        Parameter::name("INTERACTION", "the interaction; or"),
        Parameter::name("ELSET", "set of contact elements, that of their *GAP or *INTERFACE"),
        Parameter::name(
            "AMPLITUDE",
            "part of the way of μ and of the elastic slip over time, from 0 to 1 without falling; without one it ramps over \
             the step. All else changes at once",
        ),
        Parameter::flag("RESET", "back to the friction of the model data; no *FRICTION follows"),
    ],
    data: Data::None,
    source: "Abaqus Keywords Reference, *CHANGE FRICTION",
};
