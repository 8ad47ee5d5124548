//! What the tests with solids share: one static increment from rest.

use fe_contact::Contact;
use fe_core::Freedoms;
use fe_core::external::ExternalForces;
use fe_core::increment::Attempt;
use fe_core::linear::multifrontal::Multifrontal;
use fe_core::procedure::static_general::StaticGeneral;
use fe_core::procedure::system::Scene;
use fe_core::procedure::{Converged, Convergence, Procedure};
use fe_core::ramp::Ramp;
use fe_core::solid::SolidBlock;
use fe_core::step::Controls;
use fe_core::term::Term;

/// Solves a step of one increment; each prescribed freedom counts once.
pub fn solve(
    freedoms: &Freedoms,
    solids: &[SolidBlock],
    pair: &Contact,
    external: ExternalForces,
    mut prescribed: Vec<(usize, Ramp)>,
) -> (Converged, Convergence) {
    prescribed.sort_by_key(|p| p.0);
    prescribed.dedup_by_key(|p| p.0);
    let terms: Vec<&dyn Term> = solids.iter().map(|b| b as &dyn Term).chain([pair as &dyn Term]).collect();
    let history = terms.iter().map(|t| vec![0.0; t.history()]).collect();
    let scene = Scene { freedoms, terms, external, prescribed, period: 1.0 };
    let zero = vec![0.0; freedoms.len()];
    let start = Converged { u: zero.clone(), residual: zero.clone(), external: zero, history, ..Converged::default() };
    let mut procedure = StaticGeneral::new(scene, Controls::default(), Box::new(Multifrontal::default())).unwrap();
    procedure.advance(&start, Attempt { increment: 1, attempt: 1, dt: 1.0, step_time: 1.0 }).unwrap()
}
