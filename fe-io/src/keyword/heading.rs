use super::{Data, Keyword, Kind, Level, Parameter};

pub const HEADING: Keyword = Keyword {
    name: "HEADING",
    level: Level::Model,
    summary: "a title for the job",
    parameters: &[],
    data: Data::Text("title, one or more lines"),
    source: "Abaqus Keywords Reference, *HEADING",
};

pub const INCLUDE: Keyword = Keyword {
    name: "INCLUDE",
    level: Level::Either,
    summary: "another file is read in this place",
    parameters: &[Parameter::of("INPUT", Kind::Text, "file, looked up beside the file that names it").required()],
    data: Data::None,
    source: "Abaqus Keywords Reference, *INCLUDE",
};
