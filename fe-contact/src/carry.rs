//! What carries a contact: an interaction's words, and the stiffness beneath, made into a law and its multipliers.

use crate::conditions::{MultiplierUse, Overrides, Tolerance};
use crate::enforce::Multipliers;
use crate::interaction::{Enforcement, NormalBehavior, Penalty};
use crate::law::NormalLaw;
use crate::law::linear::Linear;
use crate::law::series::InSeries;
use crate::stiffness::{AUGMENTED_FACTOR, NONLINEAR_FACTOR, PENALTY_FACTOR};
use crate::summary::{Means, PenaltySummary};
use std::sync::Arc;

/// The stiffness of the elements beneath is needed and not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoStiffness;

/// What an interaction is enforced on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ground {
    /// Stiffness k_e [F/L³] of the elements beneath.
    pub beneath: Option<f64>,
    /// Length [L] of the facets, or what stands for it.
    pub length: f64,
    /// Surfaces that meet surface to surface and may slide far: hard contact is usually a penalty there.
    pub slides_far: bool,
}

impl Ground {
    /// Stiffness [F/L³] up to which a law stands as it is.
    pub(crate) fn stiffest(&self) -> Option<f64> {
        self.beneath.map(|k| AUGMENTED_FACTOR * k)
    }
}

impl Ground {
    /// Stiffness [F/L³] of the spring in series with a law of this slope, which multipliers take out again; `None` where the
    /// law stands as it is.
    fn spring(&self, steepest: f64, multipliers: MultiplierUse) -> Option<f64> {
        let spring = self.stiffest();
        match multipliers {
            MultiplierUse::Usual => spring.filter(|spring| steepest > *spring),
            MultiplierUse::Always => spring.or(Some(steepest)).filter(|spring| spring.is_finite()),
            MultiplierUse::Never => None,
        }
    }
}

/// Enough to find where a law comes to a pressure to a millionth.
const BISECTIONS: usize = 60;

impl Ground {
    /// The largest stiffness [F/L³] of a law up to the largest pressure that elastic bodies could bear at all, as large as
    /// the modulus of the elements beneath: k_e times their length.
    fn steepest(&self, law: &dyn NormalLaw) -> f64 {
        let steepest = law.steepest();
        let largest = self.beneath.map_or(0.0, |k| k * self.length);
        if largest <= 0.0 || self.stiffest().is_some_and(|spring| steepest <= spring) {
            return steepest;
        }
        let reach = law.reach();
        // Where the law comes to that pressure, at most as far as a straight line with its typical slope would.
        let mut far = largest / law.typical_stiffness();
        if law.respond(reach - far).pressure < largest {
            return steepest;
        }
        let mut near = 0.0;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (near + far);
            *(if law.respond(reach - middle).pressure < largest { &mut near } else { &mut far }) = middle;
        }
        let range = reach - far..reach;
        let ends = law.kinks(range.clone()).into_iter().chain([range.start, range.end]);
        ends.map(|gap| law.respond(gap).stiffness).fold(0.0, f64::max).min(steepest)
    }
}

/// A law and what stands on top of it.
#[derive(Clone, Debug)]
pub(crate) struct Carried {
    /// The law that is asked.
    pub law: Arc<dyn NormalLaw>,
    /// The law itself, where one in series is asked.
    pub bare: Option<Arc<dyn NormalLaw>>,
    /// For the plan.
    pub penalty: Option<PenaltySummary>,
    /// Multipliers on top of the law.
    pub multipliers: Option<Multipliers>,
}

impl Carried {
    /// Laws and penalties that are nowhere steeper than a thousand times the elements beneath stand as they are (Abaqus
    /// Analysis User's Manual, Contact constraint enforcement methods).
    pub fn new(normal: &NormalBehavior, ground: Ground, overrides: Overrides) -> Result<Self, NoStiffness> {
        match normal {
            NormalBehavior::Softened(law) => Ok(Self::softened(law.clone(), ground, overrides.multipliers)),
            NormalBehavior::Hard(enforcement) => Self::hard(*enforcement, ground, overrides),
        }
    }

    fn softened(law: Arc<dyn NormalLaw>, ground: Ground, multipliers: MultiplierUse) -> Self {
        match ground.spring(ground.steepest(&*law), multipliers) {
            Some(spring) => Self::in_series(law, spring, ground),
            None => Carried { law, bare: None, penalty: None, multipliers: None },
        }
    }

    fn in_series(law: Arc<dyn NormalLaw>, spring: f64, ground: Ground) -> Self {
        let penalty =
            PenaltySummary { means: Means::Mixed, stiffness: spring, by_default: true, scale: 1.0, clearance: 0.0 };
        let bare = Some(law.clone());
        Carried { law: Arc::new(InSeries { law, spring }), bare, ..Self::with(penalty, ground) }
    }

    fn hard(enforcement: Enforcement, ground: Ground, overrides: Overrides) -> Result<Self, NoStiffness> {
        let (scaled, chosen) = (overrides.stiffness_scale, overrides.multipliers);
        let usually_penalty = match chosen {
            MultiplierUse::Usual => ground.slides_far,
            MultiplierUse::Always => false,
            MultiplierUse::Never => true,
        };
        let (means, Penalty { stiffness, clearance, scale }, factor) = match enforcement {
            Enforcement::Usual if usually_penalty => (Means::Penalty, Penalty::default(), PENALTY_FACTOR),
            Enforcement::Usual | Enforcement::Direct => (Means::Multipliers, Penalty::default(), AUGMENTED_FACTOR),
            Enforcement::NonlinearPenalty(growing) => {
                (Means::NonlinearPenalty(growing.upper * ground.length), growing.last, NONLINEAR_FACTOR)
            }
            Enforcement::Penalty(penalty) => (Means::Penalty, penalty, PENALTY_FACTOR),
            Enforcement::AugmentedLagrange(penalty) => (
                Means::AugmentedLagrange(allowed(ground, overrides.tolerance, scaled * penalty.scale)),
                penalty,
                AUGMENTED_FACTOR,
            ),
        };
        let scale = scaled * scale;
        let base = stiffness.or(ground.beneath.map(|k| factor * k)).ok_or(NoStiffness)?;
        let by_default = stiffness.is_none();
        let penalty = PenaltySummary { means, stiffness: scale * base, by_default, scale, clearance };
        let law: Arc<dyn NormalLaw> = match enforcement {
            Enforcement::NonlinearPenalty(growing) => Arc::new(growing.over(penalty.stiffness, ground.length)),
            _ => Arc::new(Linear { slope: penalty.stiffness, clearance }),
        };
        // Too steep a penalty would drown the bodies' own stiffness in rounding.
        Ok(if means.is_bare() {
            match ground.spring(law.steepest(), chosen) {
                Some(spring) => Self::in_series(law, spring, ground),
                None => Carried { law, ..Self::with(penalty, ground) },
            }
        } else {
            let stiffness = ground.stiffest().map_or(penalty.stiffness, |most| most.min(penalty.stiffness));
            Self::with(PenaltySummary { stiffness, ..penalty }, ground)
        })
    }

    fn with(penalty: PenaltySummary, ground: Ground) -> Self {
        let (slope, length) = (penalty.stiffness, ground.length);
        let multipliers = match penalty.means {
            Means::Penalty | Means::NonlinearPenalty(_) => None,
            Means::AugmentedLagrange(allowed) => Some(Multipliers { slope, length, allowed: Some(allowed) }),
            Means::Multipliers | Means::Mixed => Some(Multipliers { slope, length, allowed: None }),
        };
        let law = Arc::new(Linear { slope, clearance: penalty.clearance });
        Carried { law, bare: None, penalty: Some(penalty), multipliers }
    }
}

/// Overclosure [L] that augmentation leaves: as asked for, or a thousandth of the facets' length, a twentieth where surfaces
/// may slide far, larger where the penalty is softened by a factor below 1 (Abaqus Analysis User's Manual, Contact constraint
/// enforcement methods).
fn allowed(ground: Ground, tolerance: Option<Tolerance>, scale: f64) -> f64 {
    match tolerance {
        Some(Tolerance::Absolute(depth)) => depth,
        Some(Tolerance::Relative(part)) => part * ground.length,
        None => (if ground.slides_far { 0.05 } else { 1e-3 }) * ground.length / scale.min(1.0),
    }
}
