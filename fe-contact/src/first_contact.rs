//! The first contact of a body that contact alone holds: how far it moves rigidly until it is met.

use crate::pair::Pair;

/// The largest factor t ≥ 0 so that no gap falls below the clearance at which its law starts when everything moves
/// from the displacement `u` by t · `motion` (both over all freedoms, `motion` a rigid one of one body). Gaps are linear
/// in t. `None`: nothing is ever met; 0: something touches or overlaps already and would be pressed.
pub fn first_contact(pairs: &[Pair], u: &[f64], motion: &[f64]) -> Option<f64> {
    let fastest = motion.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let mut first: Option<f64> = None;
    for pair in pairs {
        let start = pair.law().reach();
        for i in 0..pair.points.len() {
            let rate = pair.rate(i, motion);
            // Slower than round-off of the motion: the point slides past.
            if rate >= -1e-10 * fastest {
                continue;
            }
            let factor = ((pair.opening(i, u) - start) / -rate).max(0.0);
            first = Some(first.map_or(factor, |f| f.min(factor)));
        }
    }
    first
}
