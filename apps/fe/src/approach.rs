//! Bodies that contact alone holds: recognised, told about, and brought into first contact without strain.

use crate::terms::Terms;
use fe_contact::contact::Contact;
use fe_contact::first_contact::{Rest, RigidContact};
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
    pairs: &[Contact],
) -> Vec<FreeBody> {
    let mut free = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let motions = body.free_motions(structure, freedoms, fixed);
        if !motions.is_empty() {
            let has = |n: &u32| body.nodes.binary_search(n).is_ok();
            let touched =
                pairs.iter().filter(|pair| pair.acts()).any(|pair| pair.points.iter().any(|p| p.nodes.iter().any(has)));
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

/// The free motions of all free bodies.
struct Motions<'a> {
    terms: &'a Terms,
    free: &'a [FreeBody],
    /// Each with the index of its free body.
    each: Vec<(usize, RigidMotion)>,
}

impl<'a> Motions<'a> {
    fn new(terms: &'a Terms, free: &'a [FreeBody]) -> Self {
        let each = free.iter().enumerate().flat_map(|(b, body)| body.motions.iter().map(move |m| (b, *m)));
        Motions { terms, free, each: each.collect() }
    }

    fn body(&self, b: usize) -> &'a Body {
        &self.terms.bodies[self.free[b].body]
    }

    fn fields(&self) -> impl ExactSizeIterator<Item = Vec<f64>> {
        self.each.iter().map(|(b, motion)| self.body(*b).field(&self.terms.structure, &self.terms.freedoms, motion))
    }

    /// Of amounts of all motions: what each body does.
    fn by_body(&self, amounts: &[f64]) -> Vec<RigidMotion> {
        let mut sums = vec![[0.0; 6]; self.free.len()];
        for ((b, motion), amount) in self.each.iter().zip(amounts) {
            (0..6).for_each(|c| sums[*b][c] += amount * motion[c]);
        }
        sums
    }

    /// The body that moves most, its motion and how large that is.
    fn most(&self, amounts: &[f64]) -> (usize, RigidMotion, f64) {
        let size = |(b, m): (usize, RigidMotion)| {
            let scaled = m.iter().enumerate().map(|(c, v)| if c < 3 { *v } else { v * self.body(b).size });
            (b, m, scaled.map(|v| v * v).sum::<f64>().sqrt())
        };
        let sized = self.by_body(amounts).into_iter().enumerate().map(size);
        sized.max_by(|a, b| a.2.total_cmp(&b.2)).unwrap_or((0, [0.0; 6], 0.0))
    }
}

/// Moves free bodies together along their free motions, the way their loads drive them, until contact holds them.
pub fn approach(terms: &Terms, free: &[FreeBody], u: &[f64], external: &[f64]) -> Approach {
    let motions = Motions::new(terms, free);
    let contact = RigidContact::new(&terms.contacts, u, motions.fields());
    let unheld = contact.unheld().into_iter().map(|amounts| motions.most(&amounts));
    // Where contact is stabilised, what drives a body that way decides.
    let stabilized = |b: usize| {
        let has = |n: &u32| motions.body(b).nodes.binary_search(n).is_ok();
        let holds = terms.contacts.iter().filter(|contact| contact.acts() && contact.holds_along());
        holds.flat_map(|contact| &contact.points).any(|p| p.nodes.iter().any(has))
    };
    if let Some((b, motion, _)) = unheld.into_iter().find(|(b, ..)| !stabilized(*b)) {
        return Approach::Unheld(b, motion);
    }
    let fields = motions.each.iter().zip(motions.fields());
    let forces: Vec<f64> = fields.map(|((b, _), field)| drive(motions.body(*b), &field, terms, external)).collect();
    match contact.settle(&forces) {
        Rest::At(amounts) => {
            let moved = motions.by_body(&amounts).into_iter().enumerate();
            Approach::Moved(moved.filter(|(_, m)| m.iter().any(|v| *v != 0.0)).collect())
        }
        Rest::Nowhere(direction) => {
            let (b, motion, size) = motions.most(&direction);
            Approach::Lost(b, [0, 1, 2].map(|c| motion[c] / size))
        }
    }
}

/// A free body (index into the free ones) and a motion of it that changes no force at the equilibrium `u`: all points
/// that hold it press on a plateau of their law, and it might as well stand elsewhere.
pub fn undecided(terms: &Terms, free: &[FreeBody], u: &[f64]) -> Option<(usize, RigidMotion)> {
    if free.is_empty() {
        return None;
    }
    let motions = Motions::new(terms, free);
    let contact = RigidContact::answering(&terms.contacts, u, motions.fields())?;
    let (b, motion, _) = motions.most(contact.unheld().first()?);
    Some((b, motion))
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
