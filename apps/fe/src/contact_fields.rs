//! Fields of contact: those of static and of explicit steps are made of the same states.

use fe_contact::point::ContactStatus;
use fe_contact::state::{ContactState, NodeValues, SideForce};
use fe_contact::summary::MeasureKind;
use fe_io::results::FieldInfo;

/// A contact in a frame: its state, and its results at the nodes of its secondary surface.
pub type Shown<'a> = (&'a ContactState, &'a [NodeValues]);

/// True for the fields that contact fills: those that its points of these kinds have; those along the surface only where it
/// `rubs`.
pub fn has(field: &FieldInfo, kinds: &[MeasureKind], rubs: bool) -> bool {
    let along = field.name.starts_with("CSHEAR") || field.name.starts_with("CSLIP");
    let measured = match measure_of(field.name) {
        Some(kind) => kinds.contains(&kind),
        None => !kinds.is_empty(),
    };
    field.name.starts_with('C') && measured && (rubs || !along)
}

/// What the law's number is where a field holds it, or what the field itself measures.
fn measure_of(name: &str) -> Option<MeasureKind> {
    match name {
        "CPRESS" | "CNAREA" => Some(MeasureKind::Pressure),
        "CPRESS_LENGTH" => Some(MeasureKind::ForcePerLength),
        "CPRESS_FORCE" => Some(MeasureKind::Force),
        _ => None,
    }
}

/// The numbers of a contact field over so many points, `[points × width]`, NaN where it is not defined; `None` for other fields.
/// Where contacts share a node, the larger number stands, of gaps the smaller one.
pub fn values(field: &FieldInfo, points: usize, contacts: &[Shown]) -> Option<Vec<f64>> {
    let near = |node: &NodeValues, value: f64| node.opening.map_or(f64::NAN, |_| value);
    let of_kind = |value: fn(&NodeValues) -> f64| {
        let there =
            move |node: &NodeValues| if Some(node.kind) == measure_of(field.name) { value(node) } else { f64::NAN };
        at_nodes(points, contacts, |node| near(node, there(node)), f64::max)
    };
    let along = |value: fn(&NodeValues) -> f64| at_nodes(points, contacts, |node| near(node, value(node)), larger);
    Some(match field.name {
        "CPRESS" | "CPRESS_LENGTH" | "CPRESS_FORCE" => of_kind(|node| node.pressure),
        "CNAREA" => of_kind(|node| node.measure),
        "COPEN" => at_nodes(points, contacts, |node| node.opening.unwrap_or(f64::NAN), f64::min),
        "CSTATUS" => at_nodes(points, contacts, |node| status(node.status), f64::max),
        "CSHEAR1" => along(|node| node.shear[0]),
        "CSHEAR2" => along(|node| node.shear[1]),
        "CSLIP1" => along(|node| node.slip[0]),
        "CSLIP2" => along(|node| node.slip[1]),
        "CNORMF" => forces(points, contacts, |state| vec![&state.secondary, &state.main]),
        "CSHEARF" => forces(points, contacts, |state| state.secondary_shear.iter().chain(&state.main_shear).collect()),
        _ => return None,
    })
}

/// A number of the secondary nodes; where contacts share a node, `merge` of theirs.
fn at_nodes(
    points: usize,
    contacts: &[Shown],
    value: impl Fn(&NodeValues) -> f64,
    merge: fn(f64, f64) -> f64,
) -> Vec<f64> {
    let mut out = vec![f64::NAN; points];
    for node in contacts.iter().flat_map(|(_, nodes)| *nodes) {
        let place = &mut out[node.node as usize];
        // f64::max and f64::min take the number where the other is NaN.
        *place = merge(*place, value(node));
    }
    out
}

fn forces<'s>(
    points: usize,
    contacts: &'s [Shown],
    sides: impl Fn(&'s ContactState) -> Vec<&'s SideForce>,
) -> Vec<f64> {
    let mut out = vec![f64::NAN; 3 * points];
    for (state, _) in contacts {
        for &(node, force) in sides(state).into_iter().flat_map(|side| &side.nodes) {
            for c in 0..3 {
                let place = &mut out[3 * node as usize + c];
                *place = if place.is_nan() { force[c] } else { *place + force[c] };
            }
        }
    }
    out
}

/// The one of two that is larger in size; the number where the other is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || a.abs() >= b.abs() { a } else { b }
}

/// The number that stands for a status: 0 open, 1 closed or sticking, 2 slipping.
fn status(status: ContactStatus) -> f64 {
    match status {
        ContactStatus::Open => 0.0,
        ContactStatus::Closed => 1.0,
        ContactStatus::Slipping => 2.0,
    }
}
