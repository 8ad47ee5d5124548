use super::{Data, DataLine, Field, Keyword, Kind, Level, Parameter};

pub const MESH: Keyword = Keyword {
    name: "MESH",
    level: Level::Part,
    summary: "a mesh in gmsh format (2.2 or 4.1, text or binary); physical groups become sets and surfaces",
    parameters: &[Parameter::of("INPUT", Kind::Text, "file, looked up beside the file that names it").required()],
    data: Data::Lines(&[DataLine::many(&[
        Field::word(
            "physical group",
            "a group of cells that become elements; groups that are not named give sets only",
        ),
        Field::word("element type", "type of these elements, say C3D8"),
    ])]),
    source: "Signorini's own card; gmsh reference manual, MSH file format",
};
