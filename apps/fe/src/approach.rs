//! Bodies that contact alone holds: recognised, told about, and brought into first contact without strain.

use fe_contact::first_contact::first_contact;
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

/// What moving a free body into first contact came to.
#[derive(Clone, Debug, PartialEq)]
pub enum Approach {
    /// It touches already, or nothing loads it along its free motions.
    None,
    /// The displacement field of the move, over all freedoms, and the largest displacement [L] in it.
    Moved {
        /// Displacement of every freedom.
        field: Vec<f64>,
        /// Mean translation of the body [L].
        translation: [f64; 3],
    },
    /// Its load drives it where no surface stops it; the direction.
    Lost {
        /// Unit direction of the body's centre.
        direction: [f64; 3],
    },
}

/// Moves a free body along its free motions, the way its loads drive it, until the first constraint meets.
pub fn approach(
    structure: &Structure,
    freedoms: &Freedoms,
    body: &Body,
    motions: &[RigidMotion],
    pairs: &[Pair],
    state: (&[f64], &[f64]),
) -> Approach {
    let (u, external) = state;
    let mut drive = [0.0; 6];
    let (mut loaded, mut size) = (0.0f64, 0.0f64);
    for &n in &body.nodes {
        freedoms.of_node(n as usize).for_each(|f| size = size.max(external[f].abs()));
    }
    for motion in motions {
        let force = dot(&body.field(structure, freedoms, motion), external);
        loaded = loaded.max(force.abs());
        (0..6).for_each(|c| drive[c] += force * motion[c]);
    }
    // A load across the free motions leaves round-off along them.
    if loaded <= 1e-10 * size * body.nodes.len() as f64 || size == 0.0 {
        return Approach::None;
    }
    let length = drive.iter().zip([1.0, 1.0, 1.0, body.size, body.size, body.size]);
    let length = length.map(|(d, s)| (d * s) * (d * s)).sum::<f64>().sqrt();
    drive.iter_mut().for_each(|d| *d /= length);
    let field = body.field(structure, freedoms, &drive);
    let direction = [drive[0], drive[1], drive[2]];
    match first_contact(pairs, u, &field) {
        None => Approach::Lost { direction },
        Some(t) if t <= 0.0 => Approach::None,
        Some(t) => {
            let field = field.into_iter().map(|v| v * t).collect();
            Approach::Moved { field, translation: direction.map(|d| d * t) }
        }
    }
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
