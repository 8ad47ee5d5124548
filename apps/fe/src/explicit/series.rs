//! The histories of an explicit job.

use super::contact_states::label;
use super::energies::COLUMNS;
use super::general::NAME as GENERAL;
use super::values::{Values, components};
use crate::histories;
use fe_io::Model;
use fe_io::model::{History, HistoryOfSet};
use fe_io::results::HistoryInfo;
use fe_io::results::fields::FIELDS;
use fe_mesh::Mesh;

/// A history: what it holds, and how it stands in the file.
pub struct Series {
    /// What.
    pub of: History,
    /// Name and columns.
    pub info: HistoryInfo,
}

/// The histories of all steps: energies, each pair, what the steps ask for.
pub fn of(model: &Model, mesh: &Mesh) -> Vec<Series> {
    let mut all = vec![History::Energies];
    let pairs = model.steps.iter().flat_map(|step| &step.explicit_pairs).map(|active| {
        let pair = &model.explicit_pairs[active.pair].0;
        History::Contact(Some([pair.secondary_name.clone(), pair.main_name.clone()]))
    });
    let asked = model.steps.iter().flat_map(|step| &step.output.histories).map(|request| request.of.clone());
    let has_general = model.steps.iter().any(|step| step.general_contact.is_some());
    let general = has_general.then(|| History::Contact(Some([GENERAL.into(), GENERAL.into()])));
    for history in pairs.chain(general).chain(asked.filter(|of| *of != History::Contact(None))) {
        if !all.contains(&history) {
            all.push(history);
        }
    }
    let titles: Vec<String> = all.iter().map(title).collect();
    let names = histories::names(titles.iter().map(String::as_str));
    all.into_iter().zip(names).map(|(of, name)| Series { info: info(&of, name, mesh), of }).collect()
}

fn title(of: &History) -> String {
    match of {
        History::Energies | History::Contact(None) => "Energies".into(),
        History::Contact(Some([secondary, _])) if secondary == GENERAL => GENERAL.into(),
        History::Contact(Some([secondary, main])) => label((secondary, main)),
        History::Nodes(of) | History::Elements(of) => {
            let component = of.component.map_or(String::new(), |_| components(of).concat());
            let field = if of.component.is_some() { &component } else { of.field };
            format!("{field} of {}", of.set)
        }
    }
}

fn info(of: &History, name: String, mesh: &Mesh) -> HistoryInfo {
    match of {
        History::Contact(_) => histories::info(&name),
        History::Energies => HistoryInfo {
            name,
            columns: COLUMNS.map(str::to_owned).to_vec(),
            units: COLUMNS.map(|name| unit(name).to_owned()).to_vec(),
            meaning: "energies, what mass scaling has added to all mass, and the length of the last increment".into(),
        },
        History::Nodes(of) => {
            let nodes = mesh.node_sets.get(&of.set).map_or(&[][..], Vec::as_slice);
            of_set(name, of, nodes.iter().map(|&node| mesh.point_name(node)))
        }
        History::Elements(of) => {
            let cells = mesh.cell_sets.get(&of.set).map_or(&[][..], Vec::as_slice);
            of_set(name, of, cells.iter().map(|&cell| mesh.cell_name(cell)))
        }
    }
}

fn unit(column: &str) -> &'static str {
    match column {
        "increment" => "T",
        "DMASS" => "%",
        _ => "F L",
    }
}

/// Columns `U1 LABEL`, node after node or element after element.
fn of_set(name: String, of: &HistoryOfSet, labels: impl Iterator<Item = String>) -> HistoryInfo {
    let components = components(of);
    let each = |label: String| components.iter().map(move |c| format!("{c} {label}")).collect::<Vec<_>>();
    let columns: Vec<String> = labels.flat_map(each).collect();
    let field = FIELDS.iter().rfind(|field| field.name == of.field).expect("a field of the list");
    HistoryInfo { name, units: vec![field.unit.into(); columns.len()], columns, meaning: field.meaning.into() }
}

impl Series {
    /// True when a row of it is due, with what is asked for; pairs stand beside every frame.
    pub fn is_due(&self, due: &[&History], has_frame: bool) -> bool {
        match &self.of {
            History::Contact(_) => has_frame || due.iter().any(|of| **of == History::Contact(None) || **of == self.of),
            of => due.contains(&of),
        }
    }

    /// The row; `None` for a pair that does not act.
    pub fn row(&self, values: &Values) -> Option<Vec<f64>> {
        match &self.of {
            History::Energies | History::Contact(None) => None,
            History::Contact(Some([secondary, main])) => {
                let own = |surfaces: (&str, &str)| surfaces == (secondary.as_str(), main.as_str());
                let contact = values.contacts().iter().find(|contact| own(contact.surfaces))?;
                Some(histories::row(&contact.state))
            }
            History::Nodes(of) => Some(values.at_nodes(of)),
            History::Elements(of) => Some(values.at_elements(of)),
        }
    }
}
