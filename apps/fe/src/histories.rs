//! Names of histories, and what those of contacts hold, in static and in explicit steps.

use fe_contact::state::ContactState;
use fe_io::results::HistoryInfo;

/// Columns with their units: the whole force, its moment about the origin, then the parts of the force.
const COLUMNS: [(&str, &str); 14] = [
    ("force_1", "F"),
    ("force_2", "F"),
    ("force_3", "F"),
    ("moment_1", "F L"),
    ("moment_2", "F L"),
    ("moment_3", "F L"),
    ("closed_area", "L²"),
    ("overclosure", "L"),
    ("normal_1", "F"),
    ("normal_2", "F"),
    ("normal_3", "F"),
    ("shear_1", "F"),
    ("shear_2", "F"),
    ("shear_3", "F"),
];

/// Names that can stand in the results file, each once: `/` and `.` cannot stand in them.
pub fn names<'a>(contacts: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for contact in contacts {
        let plain = contact.replace(['/', '.'], "_");
        let numbered = (2..).map(|n| format!("{plain} {n}"));
        let name = std::iter::once(plain.clone()).chain(numbered).find(|name| !names.contains(name));
        names.push(name.expect("one of endlessly many names is free"));
    }
    names
}

/// The history of a contact.
pub fn info(name: &str) -> HistoryInfo {
    HistoryInfo {
        name: name.into(),
        columns: COLUMNS.map(|column| column.0.to_owned()).to_vec(),
        units: COLUMNS.map(|column| column.1.to_owned()).to_vec(),
        meaning: "resultant of the pair on its secondary side: CFT and CMT, CAREA, the largest overclosure, CFN, CFS"
            .into(),
    }
}

/// A row of it.
pub fn row(state: &ContactState) -> Vec<f64> {
    let (force, moment) = state.total();
    let mut row = force.to_vec();
    row.extend(moment);
    row.extend([state.closed_area, state.largest_overclosure.map_or(0.0, |l| l.1)]);
    row.extend(state.secondary.force);
    row.extend(state.secondary_shear.as_ref().map_or([0.0; 3], |shear| shear.force));
    row
}
