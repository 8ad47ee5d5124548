//! Stress at one point of eight elements that move on by an increment: isotropic elasticity between Cauchy stress and the
//! strain of the increment, σ₁ = Q (σ₀ + ½ C : ε) Qᵀ + ½ C : ε, exact to the square of the increment, with plasticity after von
//! Mises (then follows the radial return to the yield surface), or hyperelasticity.

use super::motion::{Matrix, Motion, Symmetric, rotated};
use super::neo_hooke;
use crate::lanes::Lanes;
use crate::material::{Hardening, Response};

/// A material at work.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Answer {
    /// Lamé's first constant λ [F/L²] of small strains.
    pub lambda: f64,
    /// Shear modulus μ [F/L²] of small strains.
    pub mu: f64,
    pub response: Response,
}

/// What is kept of a point.
#[derive(Clone, Copy)]
pub(super) struct Point {
    /// Cauchy stress.
    pub stress: Symmetric,
    /// Equivalent plastic strain.
    pub plastic: Lanes,
}

/// What an increment did at a point.
pub(super) struct Done {
    /// Work per volume [F/L²]: mean stress times strain.
    pub work: Lanes,
    /// Of that, into plastic flow.
    pub dissipated: Lanes,
    /// Of the trial deviator, what the return to the yield surface has left [-].
    pub kept: Lanes,
    /// What λ and μ do not exceed [F/L²] as far as stability goes.
    pub moduli: [Lanes; 2],
}

/// A return to the yield surface.
struct Flowed {
    dissipated: Lanes,
    /// Of the trial deviator, what is left [-].
    kept: Lanes,
    /// What is lost of the stiffness along the deviator beside that: 1/(1 + h/3μ) − 1 + kept [-]; 0 where nothing flows.
    along: Lanes,
    /// Square of the zz component of the deviator's direction [-].
    across: Lanes,
}

impl Answer {
    pub fn new(response: &Response) -> Self {
        let elastic = response.elastic();
        Answer { lambda: elastic.lambda(), mu: elastic.mu(), response: response.clone() }
    }

    /// True where the stress follows from the whole motion.
    pub fn is_total(&self) -> bool {
        matches!(self.response, Response::NeoHooke(_))
    }

    /// λ of strains in a plane without stress across it: 2λμ/(λ + 2μ).
    pub fn plane_lambda(&self) -> f64 {
        2.0 * self.lambda * self.mu / (self.lambda + 2.0 * self.mu)
    }

    /// Moves a point on; `backward` is F⁻¹, where it is needed.
    #[inline(always)]
    pub fn advance<const FUSED: bool>(&self, by: &Motion, backward: &Matrix, point: &mut Point) -> Done {
        let before = point.stress;
        let mut moduli = [self.lambda, self.mu].map(Lanes::splat);
        let (mut dissipated, mut kept) = (Lanes::ZERO, Lanes::splat(1.0));
        match &self.response {
            Response::NeoHooke(material) => (point.stress, moduli) = neo_hooke::stress(material, backward),
            Response::Elastic(_) => point.stress = self.trial::<FUSED>(&before, by),
            Response::Plastic { hardening, .. } => {
                point.stress = self.trial::<FUSED>(&before, by);
                let flowed = self.flow::<FUSED>(hardening, point);
                (dissipated, kept) = (flowed.dissipated, flowed.kept);
            }
        }
        Done { work: work::<FUSED>(&before, point, by), dissipated, kept, moduli }
    }

    /// Moves a point of a plane without stress across it on, whose stretch λ_z across is kept in `stretch`: finds the strain
    /// across.
    #[inline(always)]
    pub fn advance_plane<const FUSED: bool>(
        &self,
        by: &mut Motion,
        backward: &Matrix,
        (point, stretch): (&mut Point, &mut Lanes),
    ) -> Done {
        let before = point.stress;
        let mut moduli = [self.plane_lambda(), self.mu].map(Lanes::splat);
        let (mut dissipated, mut kept) = (Lanes::ZERO, Lanes::splat(1.0));
        if let Response::NeoHooke(material) = &self.response {
            let last = *stretch;
            *stretch = neo_hooke::stretch_across(material, backward, last);
            let mut all = *backward;
            all[2][2] = Lanes::splat(1.0) / *stretch;
            (point.stress, moduli) = neo_hooke::stress(material, &all);
            by.strain[2] = (*stretch - last) / (*stretch + last) * 2.0;
        } else {
            let stiffness = self.lambda + 2.0 * self.mu;
            by.strain[2] = ((by.strain[0] + by.strain[1]) * -self.lambda - before[2]) * (1.0 / stiffness);
            let plastic = point.plastic;
            point.stress = self.trial::<FUSED>(&before, by);
            if let Response::Plastic { hardening, .. } = &self.response {
                // Newton for σ_zz = 0. Its slope lies between K and λ + 2μ.
                for iteration in 1..=MOST {
                    let flowed = self.flow::<FUSED>(hardening, point);
                    (dissipated, kept) = (flowed.dissipated, flowed.kept);
                    let bulk = self.lambda + 2.0 / 3.0 * self.mu;
                    let slope = (flowed.kept * (2.0 / 3.0) - flowed.along * flowed.across) * (2.0 * self.mu);
                    let step = point.stress[2] / (slope + Lanes::splat(bulk));
                    if iteration == MOST || step.0.iter().all(|step| step.abs() <= 1e-15) {
                        break;
                    }
                    by.strain[2] = by.strain[2] - step;
                    point.plastic = plastic;
                    point.stress = self.trial::<FUSED>(&before, by);
                }
            }
            let half = by.strain[2] * 0.5;
            *stretch = *stretch * (Lanes::splat(1.0) + half) / (Lanes::splat(1.0) - half);
        }
        Done { work: work::<FUSED>(&before, point, by), dissipated, kept, moduli }
    }

    /// Stress after an elastic strain.
    #[inline(always)]
    fn trial<const FUSED: bool>(&self, before: &Symmetric, by: &Motion) -> Symmetric {
        let volumetric = by.opened() * (0.5 * self.lambda);
        let (mut half, mut now) = ([volumetric; 6], *before);
        for i in 0..3 {
            half[i] = volumetric.plus_product::<FUSED>(Lanes::splat(self.mu), by.strain[i]);
            half[i + 3] = by.strain[i + 3] * self.mu;
        }
        (0..6).for_each(|i| now[i] += half[i]);
        now = rotated::<FUSED>(&by.rotation, &now);
        (0..6).for_each(|i| now[i] += half[i]);
        now
    }

    /// Takes the stress back to the yield surface.
    #[inline(always)]
    fn flow<const FUSED: bool>(&self, hardening: &Hardening, point: &mut Point) -> Flowed {
        let s = &mut point.stress;
        let p = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
        let d = [s[0] - p, s[1] - p, s[2] - p, s[3], s[4], s[5]];
        let mut square = Lanes::ZERO;
        for i in 0..3 {
            square = square.plus_product::<FUSED>(d[i], d[i]).plus_product::<FUSED>(d[i + 3] * 2.0, d[i + 3]);
        }
        let trial = (square * 1.5 + Lanes::splat(f64::MIN_POSITIVE)).sqrt();
        let (added, slope) = self.added(hardening, trial, point.plastic);
        let left = trial - added * (3.0 * self.mu);
        point.plastic += added;
        let kept = left / trial;
        for i in 0..3 {
            s[i] = p + d[i] * kept;
            s[i + 3] = d[i + 3] * kept;
        }
        let one = Lanes::splat(1.0);
        let along = one / (one + slope * (1.0 / (3.0 * self.mu))) - one + kept;
        let across = d[2] * d[2] * 1.5 / (trial * trial);
        Flowed { dissipated: left * added, kept, along: along.where_positive(added, Lanes::ZERO), across }
    }

    /// Plastic strain Δp ≥ 0 after which q − 3μ Δp is the yield stress at p + Δp, and the slope of the yield stress there. Both
    /// are straight between the rows: from row to row on, that solution counts which lies beyond the row.
    #[inline(always)]
    fn added(&self, hardening: &Hardening, trial: Lanes, p: Lanes) -> (Lanes, Lanes) {
        let (mut added, mut slope_there) = (Lanes::ZERO, Lanes::ZERO);
        for (i, &(from, yield_stress)) in hardening.points.iter().enumerate() {
            let slope = hardening.points.get(i + 1).map_or(0.0, |next| (next.1 - yield_stress) / (next.0 - from));
            let beyond = trial - Lanes::splat(yield_stress) - (p - Lanes::splat(from)) * slope;
            let solution = beyond * (1.0 / (3.0 * self.mu + slope));
            // At least as far as the row itself.
            let counts = if i == 0 { solution } else { p + solution - Lanes::splat(from) };
            added = solution.where_positive(counts, added);
            slope_there = Lanes::splat(slope).where_positive(counts, slope_there);
        }
        (added.max(Lanes::ZERO), slope_there)
    }
}

/// Iterations at most for the strain across a plane: Newton takes three or four.
const MOST: usize = 20;

/// Mean of the stress before and now times the strain: what these lack and have of the rotation to the middle cancels.
#[inline(always)]
fn work<const FUSED: bool>(before: &Symmetric, point: &Point, by: &Motion) -> Lanes {
    let mut work = Lanes::ZERO;
    for i in 0..6 {
        let mean = (before[i] + point.stress[i]) * if i < 3 { 0.5 } else { 1.0 };
        work = work.plus_product::<FUSED>(mean, by.strain[i]);
    }
    work
}
