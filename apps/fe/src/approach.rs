//! Bodies that contact alone holds: recognised, told about, and brought into first contact without strain.

use crate::terms::Terms;
use fe_contact::first_contact::{Rest, RigidContact};
use fe_contact::pair::Pair;
use fe_core::Freedoms;
use fe_core::bodies::{Body, RigidMotion};
use fe_core::procedure::system::dot;
use fe_core::structure::Structure;

/// A body with rigid motions that no support takes.
#[derive(Clone, Debug)]
pub struct FreeBody {
    /// Index into the scene's bodies.
    pub body: usize,
    /// Its free motions.
    pub motions: Vec<RigidMotion>,
    /// A contact pair has it on one of its sides.
    pub touched: bool,
}

/// The bodies that supports leave free.
pub fn free_bodies(
    structure: &Structure,
    freedoms: &Freedoms,
    bodies: &[Body],
    fixed: &[bool],
    pairs: &[Pair],
) -> Vec<FreeBody> {
    let mut free = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let motions = body.free_motions(structure, freedoms, fixed);
        if !motions.is_empty() {
            let has = |n: &u32| body.nodes.binary_search(n).is_ok();
            let touched = pairs.iter().any(|pair| pair.points.iter().any(|p| p.nodes.iter().any(has)));
            free.push(FreeBody { body: index, motions, touched });
        }
    }
    free
}

/// What moving the free bodies into first contact came to; bodies are indices into the free ones.
#[derive(Clone, Debug, PartialEq)]
pub enum Approach {
    /// The rigid motion of each body that had to move; none where all touch, or nothing loads them.
    Moved(Vec<(usize, RigidMotion)>),
    /// Its load drives it where no surface stops it; the unit direction of its centre.
    Lost(usize, [f64; 3]),
    /// No contact can hold it in this motion.
    Unheld(usize, RigidMotion),
}

/// Moves free bodies together along their free motions, the way their loads drive them, until contact holds them.
pub fn approach(terms: &Terms, free: &[FreeBody], u: &[f64], external: &[f64]) -> Approach {
    let each: Vec<(usize, RigidMotion)> =
        free.iter().enumerate().flat_map(|(b, body)| body.motions.iter().map(move |m| (b, *m))).collect();
    let body = |b: usize| &terms.bodies[free[b].body];
    let field = |(b, motion): &(usize, RigidMotion)| body(*b).field(&terms.structure, &terms.freedoms, motion);
    let contact = RigidContact::new(&terms.pairs, u, each.iter().map(field));
    // Of amounts of all motions: what each body does.
    let by_body = |amounts: &[f64]| {
        let mut sums = vec![[0.0; 6]; free.len()];
        for ((b, motion), amount) in each.iter().zip(amounts) {
            (0..6).for_each(|c| sums[*b][c] += amount * motion[c]);
        }
        sums
    };
    let size = |b: usize, m: &RigidMotion| {
        let scaled = m.iter().enumerate().map(|(c, v)| if c < 3 { *v } else { v * body(b).size });
        scaled.map(|v| v * v).sum::<f64>().sqrt()
    };
    let most = |motions: &[RigidMotion]| {
        (0..motions.len()).max_by(|&a, &b| size(a, &motions[a]).total_cmp(&size(b, &motions[b]))).unwrap_or(0)
    };
    if let Some(amounts) = contact.unheld().first() {
        let motions = by_body(amounts);
        let b = most(&motions);
        return Approach::Unheld(b, motions[b]);
    }
    let forces: Vec<f64> = each.iter().map(|motion| drive(body(motion.0), &field(motion), terms, external)).collect();
    match contact.settle(&forces) {
        Rest::At(amounts) => {
            let moved = by_body(&amounts).into_iter().enumerate();
            Approach::Moved(moved.filter(|(_, m)| m.iter().any(|v| *v != 0.0)).collect())
        }
        Rest::Nowhere(direction) => {
            let motions = by_body(&direction);
            let b = most(&motions);
            let length = size(b, &motions[b]);
            Approach::Lost(b, [0, 1, 2].map(|c| motions[b][c] / length))
        }
    }
}

/// Force of the loads along a motion; a load across it leaves round-off, which is nothing.
fn drive(body: &Body, field: &[f64], terms: &Terms, external: &[f64]) -> f64 {
    let loads = body.nodes.iter().flat_map(|&n| terms.freedoms.of_node(n as usize)).map(|f| external[f].abs());
    let (size, force) = (loads.fold(0.0, f64::max), dot(field, external));
    if force.abs() <= 1e-10 * size * body.nodes.len() as f64 { 0.0 } else { force }
}

/// A motion in words: the directions along and about which it goes.
pub fn in_words(motion: &RigidMotion, size: f64) -> String {
    let names = ["along x", "along y", "along z", "about x", "about y", "about z"];
    let scaled: Vec<f64> = motion.iter().enumerate().map(|(c, v)| if c < 3 { *v } else { v * size }).collect();
    let largest = scaled.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let parts: Vec<&str> =
        names.iter().zip(&scaled).filter(|(_, v)| v.abs() > 1e-6 * largest).map(|(name, _)| *name).collect();
    parts.join(" with ")
}
