//! The sizes of forces and displacements in an iteration, by which it is judged.

/// Sizes of one kind: forces [F] and displacements [L], or moments [F L] and rotations [rad].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Scale {
    /// Largest residual on a free freedom.
    pub residual: f64,
    /// Largest sum of |stiffness| · |displacement|, from which round-off is judged.
    pub product: f64,
    /// Largest correction.
    pub correction: f64,
    /// Largest displacement of the increment.
    pub increment: f64,
    /// Largest external, reaction or contact force.
    pub largest: f64,
    sum: f64,
    count: usize,
}

impl Scale {
    /// Takes a force in.
    pub fn add(&mut self, force: f64) {
        if force > 0.0 {
            self.largest = self.largest.max(force);
            self.sum += force;
            self.count += 1;
        }
    }

    /// Mean of the forces that are not zero.
    pub fn mean(&self) -> f64 {
        if self.count > 0 { self.sum / self.count as f64 } else { 0.0 }
    }

    /// Forces and moments in one: these are weighted so that the largest moment is worth the largest force, and rotations
    /// alike. Where there are moments alone they stand for themselves.
    pub fn with(&self, moments: &Scale) -> Scale {
        let weight = |own: f64, other: f64| if own > 0.0 && other > 0.0 { own / other } else { 1.0 };
        let (force, motion) = (weight(self.largest, moments.largest), weight(self.increment, moments.increment));
        let alone = self.largest == 0.0;
        Scale {
            residual: self.residual.max(force * moments.residual),
            product: self.product.max(if alone || moments.residual > 0.0 { force * moments.product } else { 0.0 }),
            correction: self.correction.max(motion * moments.correction),
            increment: self.increment.max(motion * moments.increment),
            ..if alone { *moments } else { *self }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In units of length a billion times smaller moments and displacements are a billion times larger: forces, and what
    /// is relative, stay as they are.
    #[test]
    fn the_unit_of_length_does_not_matter() {
        let seen = |unit: f64| {
            let mut forces =
                Scale { residual: 1e-3, product: 2.0, correction: unit, increment: 2.0 * unit, ..Scale::default() };
            [1.0, 3.0].into_iter().for_each(|force| forces.add(force));
            let mut moments = Scale {
                residual: 1e-2 * unit,
                product: 7.0 * unit,
                correction: 0.5,
                increment: 0.6,
                ..Scale::default()
            };
            moments.add(5.0 * unit);
            let scale = forces.with(&moments);
            [scale.residual, scale.product, scale.correction / scale.increment, scale.largest, scale.mean()]
        };
        for unit in [1e-9, 1e9] {
            let pairs = seen(1.0).into_iter().zip(seen(unit));
            pairs.for_each(|(one, other)| assert!((one - other).abs() < 1e-12 * one, "{one} {other}"));
        }
        let mut moments = Scale::default();
        moments.add(4.0);
        assert_eq!(Scale::default().with(&moments).largest, 4.0);
    }
}
