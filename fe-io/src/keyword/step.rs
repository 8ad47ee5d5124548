use super::{Choice, Data, Keyword, Kind, Level, Parameter};

pub const STEP: Keyword = Keyword {
    name: "STEP",
    level: Level::Model,
    summary: "begins a step; *STATIC or *DYNAMIC follows",
    parameters: &[
        Parameter::of("INC", Kind::Whole, "most increments of a static step, 100 without it"),
        Parameter::of("NAME", Kind::Text, "name of the step"),
        Parameter::of(
            "NLGEOM",
            Kind::OptionalChoice(&[Choice::there("YES"), Choice::there("NO")]),
            "NO (static steps, where there is no other yet): displacements are small; YES (explicit steps): the geometry follows them",
        ),
        Parameter::choice(
            "CONVERT SDI",
            &[Choice::there("YES"), Choice::there("NO")],
            "YES (default): statuses may change in I_S^c iterations, NO: in I_S; an increment never ends with a change",
        ),
        Parameter::choice(
            "AMPLITUDE",
            &[Choice::there("RAMP"), Choice::not_yet("STEP", "give the loads an amplitude of 1 throughout")],
            "RAMP (default): loads without an amplitude grow over a static step; in explicit steps they act in full from the start",
        ),
        Parameter::not_yet("PERTURBATION", "say `*STEP`: without NLGEOM and contact one increment is linear"),
        Parameter::idle("UNSYMM", "the stiffness is symmetric"),
        Parameter::idle("EXTRAPOLATION", "increments begin at the last converged state"),
        Parameter::idle("SOLVER", "there is one solver, a direct one"),
    ],
    data: Data::Text("a remark"),
    source: "Abaqus Keywords Reference, *STEP",
};

pub const END_STEP: Keyword = Keyword {
    name: "END STEP",
    level: Level::Step,
    summary: "ends a step",
    parameters: &[],
    data: Data::None,
    source: "Abaqus Keywords Reference, *END STEP",
};
