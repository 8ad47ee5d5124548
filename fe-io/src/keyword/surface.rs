use super::{Choice, Data, DataLine, Field, Keyword, Kind, Level, Parameter};

const COORDINATE: Field = Field::number("coordinate", "L", "coordinates of a point");

pub const SURFACE: Keyword = Keyword {
    name: "SURFACE",
    level: Level::Part,
    summary: "a surface: faces of elements, nodes, or an analytical rigid shape",
    parameters: &[
        Parameter::name("NAME", "name of the surface").required(),
        Parameter::choice(
            "TYPE",
            &[
                Choice::there("ELEMENT"),
                Choice::there("NODE"),
                Choice::there("SEGMENTS"),
                Choice::there("CYLINDER"),
                Choice::there("REVOLUTION"),
                Choice::not_yet("CUTTING SURFACE", "name faces or nodes"),
                Choice::not_yet("USER", "describe the surface by lines and arcs"),
            ],
            "ELEMENT (default), NODE, or rigid: SEGMENTS in a plane, CYLINDER swept, REVOLUTION turned",
        ),
        Parameter::silent("INTERNAL", "of no meaning here"),
        Parameter::choice(
            "COMBINE",
            &[Choice::there("UNION"), Choice::there("INTERSECTION"), Choice::there("DIFFERENCE")],
            "of surfaces of faces: all faces, those that both have, those of the first that the second does not have",
        ),
        Parameter::of(
            "TRIM",
            Kind::OptionalChoice(&[Choice::not_yet("YES", "free faces are taken as they are"), Choice::there("NO")]),
            "NO (default): free faces are taken as they are, around corners too",
        ),
        Parameter::not_yet("CROP", "list the faces"),
        Parameter::not_yet("FILLET RADIUS", "write the arc as a CIRCL line"),
        Parameter::not_yet("REGION TYPE", "name faces of elements"),
    ],
    data: Data::Lines(&[
        DataLine::many(&[
            Field::word("element or set", "label of an element, or an element set"),
            Field::word("face", "S1 to S6 of solids; SPOS or SNEG of trusses, beams and rigid facets in the plane: the side on the left or on the right, going from the first node to the second; of rigid facets in space: the side from which the nodes run counter-clockwise, or the other")
                .or("faces of these solids that no other element shares; trusses and beams in space as lines, which are secondary"),
        ])
        .when("TYPE=ELEMENT"),
        DataLine::many(&[
            Field::word("node or set", "label of a node, or a node set"),
            Field::number("area", "L²", "area of each of these nodes: the law gives a pressure")
                .or("no area: the law gives a force")
                .above(0.0),
        ])
        .when("TYPE=NODE"),
        DataLine::once(&[COORDINATE, COORDINATE, COORDINATE, COORDINATE, COORDINATE, COORDINATE])
            .when("TYPE=CYLINDER or REVOLUTION: points a and b; local x from a to b, or the axis"),
        DataLine::once(&[COORDINATE, COORDINATE, COORDINATE])
            .when("TYPE=CYLINDER: point c on the generator; local y = x × (c − a)"),
        DataLine::once(&[Field::word("START", "the word START"), COORDINATE, COORDINATE])
            .when("rigid: start of the profile; bodies lie on the left, going from it"),
        DataLine::many(&[
            Field::word("LINE", "the word LINE, or CIRCL for an arc of less than 180°"),
            COORDINATE,
            COORDINATE,
            Field::number("centre", "L", "centre of the arc, two coordinates, after CIRCL").or("LINE has none"),
            Field::number("centre", "L", "").or("LINE has none"),
        ])
        .when("rigid: the pieces"),
        DataLine::many(&[Field::word("surface", "a surface of faces, defined above").repeats()])
            .when("COMBINE: any number for UNION, two for INTERSECTION and DIFFERENCE"),
    ]),
    source: "Abaqus Keywords Reference, *SURFACE",
};
