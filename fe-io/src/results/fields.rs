//! The fields of the results file: names, components, meaning. Output cards and the manual read this list.

/// What the rows of a field belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Location {
    /// One row a point of the grid.
    Point,
    /// One row a cell, blocks in order.
    Cell,
}

/// A field of the results file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldInfo {
    /// Name of the array.
    pub name: &'static str,
    /// The word by which output cards ask for it, possibly together with others.
    pub request: &'static str,
    /// Names of the components, in order; empty for a scalar.
    pub components: &'static [&'static str],
    /// Points or cells.
    pub location: Location,
    /// Dimension: `F` force, `L` length, `1` a pure number.
    pub unit: &'static str,
    /// What it is, one line.
    pub meaning: &'static str,
}

impl FieldInfo {
    /// Numbers a row.
    pub fn width(&self) -> usize {
        self.components.len().max(1)
    }
}

const VECTOR: &[&str] = &["x", "y", "z"];
/// VTK's order of a symmetric tensor.
const TENSOR: &[&str] = &["xx", "yy", "zz", "xy", "yz", "xz"];

/// Section forces of lines, and moments.
const FORCES: &[&str] = &["N", "Q1", "Q2"];
const MOMENTS: &[&str] = &["M1", "M2", "T"];

const fn field(name: &'static str, request: &'static str, unit: &'static str, meaning: &'static str) -> FieldInfo {
    FieldInfo { name, request, components: &[], location: Location::Point, unit, meaning }
}

const fn with(components: &'static [&'static str], field: FieldInfo) -> FieldInfo {
    FieldInfo { components, ..field }
}

const fn at_cells(field: FieldInfo) -> FieldInfo {
    FieldInfo { location: Location::Cell, ..field }
}

/// Every field that can be stored. A value is NaN where the field is not defined.
pub const FIELDS: &[FieldInfo] = &[
    with(VECTOR, field("U", "U", "L", "displacement")),
    with(VECTOR, field("V", "V", "L/T", "velocity")),
    with(VECTOR, field("RF", "RF", "F", "reaction at supported freedoms, zero elsewhere")),
    with(TENSOR, field("S", "S", "F/L²", "stress, averaged at the node")),
    with(TENSOR, field("E", "E", "1", "strain, tensor components, averaged at the node")),
    field("MISES", "MISES", "F/L²", "Mises stress of the averaged stress"),
    field("CPRESS", "CSTRESS", "F/L²", "contact pressure, positive when pressed; secondary nodes"),
    field("CPRESS_LENGTH", "CSTRESS", "F/L", "contact force per length, positive when pressed; nodes of lines"),
    field("CPRESS_FORCE", "CSTRESS", "F", "contact force, positive when pressed; secondary nodes without area"),
    field(
        "CSHEAR1",
        "CSTRESS",
        "F/L²",
        "shear by friction along t₁ (of lines along them, F/L; of points F), against it on the secondary side",
    ),
    field(
        "CSHEAR2",
        "CSTRESS",
        "F/L²",
        "shear by friction along t₂ (of lines F/L, of points F), against it on the secondary side",
    ),
    field("COPEN", "CDISP", "L", "contact gap, negative when overclosed; secondary nodes"),
    field("CSLIP1", "CDISP", "L", "slip along t₁ while closed; secondary nodes"),
    field("CSLIP2", "CDISP", "L", "slip along t₂ while closed; secondary nodes"),
    field("CNAREA", "CNAREA", "L²", "area that a secondary node stands for"),
    field("CSTATUS", "CSTATUS", "1", "0 open, 1 closed (with friction: sticking), 2 slipping; secondary nodes"),
    with(VECTOR, field("CNORMF", "CFORCE", "F", "force of the contact pressure on the node, both sides")),
    with(VECTOR, field("CSHEARF", "CFORCE", "F", "force of friction on the node, both sides")),
    at_cells(with(TENSOR, field("S", "S", "F/L²", "stress, mean over the integration points"))),
    at_cells(with(TENSOR, field("E", "E", "1", "strain, tensor components, mean over the integration points"))),
    at_cells(field("MISES", "MISES", "F/L²", "Mises stress of the mean stress")),
    at_cells(field("PEEQ", "PEEQ", "1", "equivalent plastic strain")),
    at_cells(with(FORCES, field("SF", "SF", "F", "normal and shear forces of trusses and beams, mean"))),
    at_cells(with(MOMENTS, field("SM", "SM", "F L", "bending moments about axes 1 and 2, and torque, of beams, mean"))),
];

/// True for fields that are stored where a deck chooses none: all but those that hardly change.
pub fn is_usual(field: &FieldInfo) -> bool {
    field.name != "CNAREA"
}

/// The fields a word of an output card stands for: the request or one array's own name, in any case; none when
/// the word is unknown.
pub fn requested(word: &str) -> Vec<&'static FieldInfo> {
    let matches = |name: &str| name.eq_ignore_ascii_case(word);
    FIELDS.iter().filter(|f| matches(f.request) || matches(f.name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_at_their_location() {
        for (i, a) in FIELDS.iter().enumerate() {
            assert!(!a.name.contains(['/', '.']));
            assert!(FIELDS[..i].iter().all(|b| (a.name, a.location) != (b.name, b.location)), "{}", a.name);
        }
    }

    #[test]
    fn requests_stand_for_their_fields() {
        let names = |word| requested(word).iter().map(|f| f.name).collect::<Vec<_>>();
        assert_eq!(names("cstress"), ["CPRESS", "CPRESS_LENGTH", "CPRESS_FORCE", "CSHEAR1", "CSHEAR2"]);
        assert_eq!(names("CPRESS"), ["CPRESS"]);
        assert_eq!(names("S"), ["S", "S"]);
        assert!(names("PRESS").is_empty());
    }
}
