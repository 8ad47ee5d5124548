//! The table of cases, and the cases by topic.

mod edges;
mod elements;
mod explicit;
mod faults;
mod flush;
mod friction;
mod gaps;
mod held;
mod idle;
mod increments;
mod laws;
mod lost;
mod members;
mod moved;
mod order;
mod overclosure;
mod overconstraint;
mod stiffness;
mod surfaces;
mod tubes;
mod units;
mod wrong_side;

use super::Case;

/// All cases that are built, by number.
pub const CASES: &[Case] = &[
    Case { id: "D01", name: "penalty_sweep", scenes: stiffness::penalties },
    Case { id: "D02", name: "stiffness_ratio", scenes: stiffness::contrasts },
    Case { id: "D03", name: "held_by_contact", scenes: held::scenes },
    Case { id: "D04", name: "overconstraint", scenes: overconstraint::supported },
    Case { id: "D05", name: "shared_nodes", scenes: overconstraint::shared },
    Case { id: "D06", name: "two_pass", scenes: overconstraint::two_pass },
    Case { id: "D07", name: "initial_overclosure", scenes: overclosure::scenes },
    Case { id: "D08", name: "redundancy_count", scenes: overconstraint::count },
    Case { id: "D09", name: "edges_and_vertices", scenes: edges::scenes },
    Case { id: "D10", name: "tiny_c0", scenes: laws::tiny_clearance },
    Case { id: "D11", name: "odd_laws", scenes: laws::odd },
    Case { id: "D12", name: "snap_through", scenes: members::snapping },
    Case { id: "D13", name: "face_forces", scenes: surfaces::face_forces },
    Case { id: "D15", name: "units", scenes: units::scenes },
    Case { id: "D16", name: "offset", scenes: moved::offset },
    Case { id: "D17", name: "rotation", scenes: moved::rotation },
    Case { id: "D18", name: "chattering", scenes: lost::chattering },
    Case { id: "D19", name: "conforming_faces", scenes: flush::scenes },
    Case { id: "D22", name: "no_contact_or_lost", scenes: lost::none_or_lost },
    Case { id: "D23", name: "thin_itt", scenes: tubes::thin },
    Case { id: "D24", name: "no_separation", scenes: stiffness::no_separation },
    Case { id: "D25", name: "friction_limits", scenes: friction::scenes },
    Case { id: "D27", name: "bad_elements", scenes: elements::bad },
    Case { id: "D28", name: "thin_beams", scenes: members::thin },
    Case { id: "D29", name: "face_counted", scenes: faults::faces },
    Case { id: "D30", name: "duplicates", scenes: faults::duplicates },
    Case { id: "D31", name: "empty", scenes: faults::empty },
    Case { id: "D32", name: "gap_degenerate", scenes: gaps::degenerate },
    Case { id: "D33", name: "mesh_contrast", scenes: elements::contrast },
    Case { id: "D34", name: "increment_size", scenes: increments::scenes },
    Case { id: "D35", name: "order", scenes: order::scenes },
    Case { id: "D36", name: "wrong_side", scenes: wrong_side::scenes },
    Case { id: "D37", name: "quadratic_pressure", scenes: surfaces::quadratic_pressure },
    Case { id: "D38", name: "explicit_limits", scenes: explicit::scenes },
    Case { id: "D40", name: "idle", scenes: idle::scenes },
];
