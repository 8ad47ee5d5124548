//! What an explicit step needs, and what it does not.

use super::scene::Scene;
use super::{explicit, of_element};
use crate::number::scientific;
use crate::plan::Plan;
use fe_contact::explicit::{Adjusted, GeneralContact};
use fe_core::element::Family;
use fe_core::explicit::central_difference::CentralDifference;
use fe_core::step::{Explicit, IncrementChoice};
use fe_io::model::Step;

/// The plan of a step with so many prescribed freedoms, that its procedure begins.
pub fn plan(scene: &Scene, step: &Step, prescribed: usize, procedure: &CentralDifference) -> Plan {
    let structure = &scene.structure;
    let unknowns = scene.freedoms.len() - prescribed;
    let (step_contact, marks) = (&step.general_contact, &step.output.marks);
    let step = explicit(step).expect("the step is explicit");
    let mut needs = vec![("procedure".to_owned(), in_words(&step))];
    for section in &structure.sections {
        let material = &structure.materials[section.material];
        let (count, element) = (section.cells.len(), section.element.name());
        needs.push(("solids".into(), format!("{count} {element} of {}, large displacements", material.name)));
    }
    for section in &structure.lines {
        let (count, element) = (section.cells.len(), section.element.name());
        needs.push(match section.element.family() {
            Family::Truss => ("trusses".into(), format!("{count} {element} of {}", section.name)),
            _ => {
                let inertia = "rotary inertia raised until only stretching limits the increment";
                ("beams".into(), format!("{count} {element} of {}, large rotations; {inertia}", section.name))
            }
        });
    }
    for section in &structure.discrete {
        let (count, element) = (section.cells.len(), section.element.name());
        needs.push(("discrete".into(), format!("{count} {element} of {:.6e}", section.magnitude)));
    }
    for section in &structure.rotary {
        let [a, b, c] = section.moments;
        let tensor = if structure.is_plane() { format!("{c:.6e}") } else { format!("{a:.6e}, {b:.6e}, {c:.6e}") };
        needs.push((
            "rotary inertia".into(),
            format!("{} ROTARYI of {tensor}; it turns with the node", section.cells.len()),
        ));
    }
    needs.push(("unknowns".into(), format!("{unknowns}, and {prescribed} prescribed freedoms; masses are lumped")));
    if let (count @ 1.., most) = scene.factors.raised() {
        let added = scientific(scene.added_mass(procedure.mass()), 6);
        let largest = scientific(most, 6);
        needs.push((
            "mass scaling".into(),
            format!("{count} elements, by up to {largest}: all mass changes by {added} %"),
        ));
    }
    for interval in marks.iter().filter_map(|marks| marks.interval(step.period)) {
        needs.push(("time marks".into(), format!("increments end every {} of step time", scientific(interval, 6))));
    }
    if let faces @ 1.. = scene.loads.pressed() {
        needs.push(("pressures".into(), format!("on {faces} faces, which they follow")));
    }
    let advance = procedure.stable();
    let fastest = of_element(structure, &advance);
    needs.push(("stable".into(), format!("{} at the start{fastest}", scientific(advance.increment(), 6))));
    for pair in scene.contacts() {
        let (name, (points, law)) = (pair.label(), pair.in_words());
        needs.push(("contact pair".into(), format!("{name}, by forces at {points} nodes: {law}")));
    }
    if let Some(general) = scene.general() {
        needs.push(("general contact".into(), general_in_words(general)));
        needs.extend(scene.adjusted.map(|adjusted| ("overclosures".to_owned(), adjusted_in_words(&adjusted))));
    }
    let without = (0..scene.freedoms.nodes()).filter(|&n| scene.freedoms.of_node(n).is_empty()).count();
    let idle_nodes = without.saturating_sub(scene.following());
    let mut leaves_out: Vec<String> = vec![
        "matrix and solver: forces move the nodes at once".into(),
        "iterations and cutbacks: there is nothing to converge".into(),
    ];
    if scene.pairs.is_empty() && scene.general.is_none() {
        leaves_out.push(match step_contact {
            Some(_) => "contact: *CONTACT includes no surfaces that may touch".into(),
            None => "contact: no pair acts".into(),
        });
    }
    Plan { unknowns, prescribed, idle_nodes, needs, leaves_out }
}

fn adjusted_in_words(adjusted: &Adjusted) -> String {
    let [farthest, before, after] =
        [adjusted.farthest, adjusted.deepest[0], adjusted.deepest[1]].map(|l| scientific(l, 6));
    format!(
        "{} nodes moved by up to {farthest} without strain before the first step, out of overclosures of up to {before}; {after} \
         is left",
        adjusted.nodes
    )
}

fn general_in_words(general: &GeneralContact) -> String {
    let count = general.count();
    let penalty = match count.penalty {
        Some([least, most]) => format!("penalty {} to {} F/L a node", scientific(least, 6), scientific(most, 6)),
        None => "nothing that moves".into(),
    };
    let laws = general.in_words();
    format!(
        "{} faces, {} nodes, {} feature edges, {} MB: {penalty}; {laws}",
        count.faces,
        count.nodes,
        count.edges,
        count.bytes.div_ceil(1 << 20)
    )
}

fn in_words(step: &Explicit) -> String {
    let increments = match step.increment {
        IncrementChoice::Fixed(dt) => format!("increments of {}", scientific(dt, 6)),
        IncrementChoice::Global => {
            format!("increments of {:.3} of the stable one of all solids together", step.scale)
        }
        IncrementChoice::ElementByElement => {
            format!("increments of {:.3} of the stable one of the fastest element", step.scale)
        }
    };
    let [linear, quadratic] = step.bulk_viscosity;
    format!("central differences for {}, {increments}; bulk viscosity {linear}, {quadratic}", step.period)
}
