//! The first contact of bodies that contact alone holds: how far their loads move them rigidly until they are met.
//!
//! Rigid motions q under constant forces f: gaps are g + R q ≥ 0. Where points touch, only
//! directions that do not close them are open; the bodies go along the one nearest to f until the next point meets,
//! and come to rest where the pressures of touching points balance f (Farkas: f + Rᵀλ = 0, λ ≥ 0). With friction points that
//! the load presses do not slip; whether their friction is enough the equilibrium tells.

use crate::contact::Contact;
use nalgebra::{DMatrix, DVector};

/// Directions, rates and forces below this, of their size, are round-off [-].
const ROUND_OFF: f64 = 1e-10;

/// Points of pairs against rigid motions.
#[derive(Debug)]
pub struct RigidContact {
    /// Gap [L] of each point above where its law starts.
    gaps: DVector<f64>,
    /// Points with gaps up to this [L] touch.
    touch: DVector<f64>,
    /// How the gaps change with the motions, `[points × motions]`.
    rates: DMatrix<f64>,
    /// How the slips of each point change with the motions, none without friction; of a tied point its gap too, which then
    /// has no row in `rates`: it neither opens nor closes.
    slips: Vec<Vec<DVector<f64>>>,
}

/// Where bodies go.
#[derive(Clone, Debug, PartialEq)]
pub enum Rest {
    /// They come to rest after so much of each motion.
    At(Vec<f64>),
    /// Nothing stops them in this direction.
    Nowhere(Vec<f64>),
}

impl RigidContact {
    /// At the displacement `u`, of motions whose fields, all over all freedoms, are made one by one.
    pub fn new(pairs: &[Contact], u: &[f64], motions: impl ExactSizeIterator<Item = Vec<f64>>) -> Self {
        Self::of(&every_point(pairs), u, motions)
    }

    /// At an equilibrium `u`, of the points alone that answer a motion by another force; `None` where no point presses
    /// on a plateau of its law, so that pressing points do answer.
    pub fn answering(pairs: &[Contact], u: &[f64], motions: impl ExactSizeIterator<Item = Vec<f64>>) -> Option<Self> {
        let mut points = every_point(pairs);
        points.iter().any(|(pair, i)| pair.on_plateau(*i, u)).then(|| {
            let answers = |(pair, i): &(&Contact, usize)| {
                let closed = pair.opening_at_start(*i, u) <= pair.law().reach() + pair.touch;
                pair.is_tied() || (closed && !pair.on_plateau(*i, u))
            };
            points.retain(answers);
            Self::of(&points, u, motions)
        })
    }

    fn of(points: &[(&Contact, usize)], u: &[f64], motions: impl ExactSizeIterator<Item = Vec<f64>>) -> Self {
        let gap = |(pair, i): &(&Contact, usize)| {
            if pair.is_tied() { 0.0 } else { pair.opening_at_start(*i, u) - pair.law().reach() }
        };
        let gaps: Vec<f64> = points.iter().map(gap).collect();
        let touch: Vec<f64> = points.iter().map(|(pair, _)| pair.touch).collect();
        let mut rates = DMatrix::zeros(gaps.len(), motions.len());
        let along = |(pair, i): &(&Contact, usize)| match (pair.is_tied(), pair.slides(*i, u)) {
            (true, _) => 3,
            (_, true) => 2,
            _ => 0,
        };
        let mut slips: Vec<Vec<DVector<f64>>> =
            points.iter().map(|point| vec![DVector::zeros(motions.len()); along(point)]).collect();
        for (k, field) in motions.enumerate() {
            for (row, (pair, i)) in points.iter().enumerate() {
                let (gap, [one, other]) = (pair.rate(*i, u, &field), pair.slip_rate(*i, u, &field));
                if !pair.is_tied() {
                    rates[(row, k)] = gap;
                }
                slips[row].iter_mut().zip([one, other, gap]).for_each(|(rates, rate)| rates[k] = rate);
            }
        }
        RigidContact { gaps: gaps.into(), touch: touch.into(), rates, slips }
    }

    /// An orthonormal basis of the motions that change no gap, nor slip with friction: no contact of these pairs holds them.
    pub fn unheld(&self) -> Vec<Vec<f64>> {
        let mut product = self.rates.transpose() * &self.rates;
        self.slips.iter().flatten().for_each(|row| product += row * row.transpose());
        let eigen = product.symmetric_eigen();
        let limit = ROUND_OFF * ROUND_OFF * self.gaps.len() as f64;
        let basis =
            eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()).filter(|(value, _)| **value <= limit);
        basis.map(|(_, vector)| vector.iter().copied().collect()).collect()
    }

    /// Where `forces`, one a motion, move the bodies.
    pub fn settle(&self, forces: &[f64]) -> Rest {
        let forces = DVector::from_column_slice(forces);
        let mut gaps = self.gaps.clone();
        let mut moved = DVector::zeros(forces.len());
        // Each leg ends at a point that was not touched; bodies that roll along many come to rest near enough.
        for _ in 0..=self.gaps.len() {
            let touching: Vec<usize> = (0..gaps.len()).filter(|&i| gaps[i] <= self.touch[i]).collect();
            let direction = self.direction(&forces, &touching);
            if direction.norm() <= ROUND_OFF * forces.norm() {
                break;
            }
            let rates = &self.rates * &direction;
            let closing = |i: &usize| gaps[*i] > self.touch[*i] && rates[*i] < -ROUND_OFF * direction.amax();
            let next = (0..gaps.len()).filter(closing).map(|i| (gaps[i] / -rates[i], i));
            let Some((length, point)) = next.min_by(|a, b| a.0.total_cmp(&b.0)) else {
                return Rest::Nowhere(direction.iter().copied().collect());
            };
            moved += &direction * length;
            gaps += rates * length;
            gaps[point] = 0.0;
        }
        Rest::At(moved.iter().copied().collect())
    }

    /// Where `forces` drive the bodies that touch so: along what closes no touching point and, with friction, makes none
    /// slip that is pressed, or that no motion opens or closes.
    fn direction(&self, forces: &DVector<f64>, touching: &[usize]) -> DVector<f64> {
        let (direction, pressed) = open_direction(&self.rates, forces, touching);
        let idle = |i: &usize| self.rates.row(*i).amax() <= ROUND_OFF;
        let held = pressed.iter().map(|p| p.0).chain(touching.iter().copied().filter(idle));
        let rows: Vec<DVector<f64>> = held.flat_map(|i| self.slips[i].iter().cloned()).collect();
        if rows.is_empty() {
            return direction;
        }
        let svd = DMatrix::from_columns(&rows).svd(true, false);
        let Some(basis) = svd.u else { return direction };
        let largest = svd.singular_values.max();
        let columns = basis.column_iter().zip(&svd.singular_values);
        let held: Vec<_> = columns.filter(|(_, size)| **size > ROUND_OFF * largest).map(|(column, _)| column).collect();
        let without = |v: DVector<f64>| {
            held.iter().fold(v, |v, q| {
                let part = q.dot(&v);
                v - q * part
            })
        };
        let mut rates = self.rates.clone();
        for mut row in rates.row_iter_mut() {
            let free = without(row.transpose());
            row.copy_from(&free.transpose());
        }
        let free = without(forces.clone());
        let direction = open_direction(&rates, &free, touching).0;
        // What is left of a force that friction balances is rounding.
        if direction.norm() <= ROUND_OFF * forces.norm() { DVector::zeros(forces.len()) } else { direction }
    }
}

/// The vector nearest to `forces` that closes no touching point: f + Rᵀλ with the λ ≥ 0 that make it shortest
/// (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23), and these λ.
fn open_direction(
    rates: &DMatrix<f64>,
    forces: &DVector<f64>,
    touching: &[usize],
) -> (DVector<f64>, Vec<(usize, f64)>) {
    let mut pressed: Vec<(usize, f64)> = Vec::new();
    let mut direction = forces.clone();
    for _ in 0..3 * (touching.len() + 1) {
        let closing = |&i: &usize| rates.row(i).transpose().dot(&direction);
        let worst = touching.iter().map(|i| (closing(i), *i)).min_by(|a, b| a.0.total_cmp(&b.0));
        match worst {
            Some((rate, point)) if rate < -ROUND_OFF * forces.norm() => pressed.push((point, 0.0)),
            _ => break,
        }
        balance(rates, forces, &mut pressed);
        direction = forces.clone();
        pressed.iter().for_each(|&(i, force)| direction += rates.row(i).transpose() * force);
    }
    (direction, pressed)
}

/// The forces of pressed points that leave least of `forces`; points that would pull are let go.
fn balance(rates: &DMatrix<f64>, forces: &DVector<f64>, pressed: &mut Vec<(usize, f64)>) {
    while !pressed.is_empty() {
        let columns: Vec<_> = pressed.iter().map(|p| rates.row(p.0).transpose()).collect();
        let svd = DMatrix::from_columns(&columns).svd(true, true);
        let Ok(wanted) = svd.solve(&-forces, ROUND_OFF * svd.singular_values.max()) else { return };
        // As far towards what is wanted as every force stays a pressure.
        let stops = pressed
            .iter()
            .zip(&wanted)
            .filter(|(_, w)| **w <= 0.0)
            .map(|(p, w)| p.1 / (p.1 - w).max(f64::MIN_POSITIVE));
        let share = stops.fold(1.0, f64::min);
        pressed.iter_mut().zip(&wanted).for_each(|(p, w)| p.1 += share * (w - p.1));
        let before = pressed.len();
        let largest = pressed.iter().fold(0.0f64, |m, p| m.max(p.1));
        pressed.retain(|p| p.1 > f64::EPSILON * largest);
        if pressed.len() == before {
            return;
        }
    }
}

fn every_point(pairs: &[Contact]) -> Vec<(&Contact, usize)> {
    pairs.iter().filter(|pair| pair.acts()).flat_map(|pair| (0..pair.points.len()).map(move |i| (pair, i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact(gaps: &[f64], rates: &[[f64; 2]]) -> RigidContact {
        RigidContact {
            gaps: DVector::from_column_slice(gaps),
            touch: DVector::from_element(gaps.len(), 1e-12),
            rates: DMatrix::from_fn(rates.len(), 2, |i, k| rates[i][k]),
            slips: vec![Vec::new(); gaps.len()],
        }
    }

    fn assert_at(rest: &Rest, expected: [f64; 2]) {
        let Rest::At(moved) = rest else { panic!("{rest:?}") };
        // Two moves of numbers below 10.
        assert!(moved.iter().zip(expected).all(|(m, e)| (m - e).abs() < 1e-14), "{moved:?}");
    }

    /// A bar on two points at −1 and 1, free to sink (first motion, down positive) and to turn, 0.3 above one and 0.1
    /// above the other: with its load between them it comes to lie on both, with its load outside it tips over.
    #[test]
    fn a_bar_comes_to_lie_on_both_points() {
        let bar = contact(&[0.3, 0.1], &[[-1.0, -1.0], [-1.0, 1.0]]);
        for moment in [-0.5, 0.0, 0.5, 0.9] {
            assert_at(&bar.settle(&[1.0, moment]), [0.2, 0.1]);
        }
        assert!(matches!(bar.settle(&[1.0, 1.5]), Rest::Nowhere(_)));
        assert_eq!(bar.settle(&[-1.0, 0.0]), Rest::Nowhere(vec![-1.0, 0.0]));
        assert_eq!(bar.settle(&[0.0, 0.0]), Rest::At(vec![0.0, 0.0]));
    }

    /// Two bodies on top of each other, both pulled down: the lower one meets the ground, the upper one the lower one.
    #[test]
    fn a_stack_sinks_together() {
        let stack = contact(&[0.3, 0.2], &[[-1.0, 0.0], [1.0, -1.0]]);
        for forces in [[1.0, 5.0], [5.0, 1.0], [1.0, 1.0], [0.0, 1.0]] {
            assert_at(&stack.settle(&forces), [0.3, 0.5]);
        }
    }

    /// A block on a plane with friction, free to sink and to slide: it sinks along its load and then sticks, also where
    /// nothing presses it, as long as no motion opens it; a load upwards takes it away.
    #[test]
    fn friction_holds_what_is_pressed() {
        let slide = |rates: [f64; 2]| vec![DVector::from_column_slice(&rates)];
        let block = |gap: f64| RigidContact { slips: vec![slide([0.0, 1.0])], ..contact(&[gap], &[[-1.0, 0.0]]) };
        assert!(block(0.0).unheld().is_empty());
        assert_at(&block(0.0).settle(&[1.0, 0.5]), [0.0, 0.0]);
        assert_at(&block(0.2).settle(&[1.0, 0.5]), [0.2, 0.1]);
        assert_eq!(block(0.0).settle(&[-1.0, 0.0]), Rest::Nowhere(vec![-1.0, 0.0]));
        assert!(matches!(block(0.0).settle(&[0.0, 1.0]), Rest::Nowhere(_)));
        let idle = RigidContact { slips: vec![slide([0.0, 1.0])], ..contact(&[0.0], &[[0.0, 0.0]]) };
        assert_at(&idle.settle(&[0.0, 1.0]), [0.0, 0.0]);
        // A wall that nothing presses lets it sink to the ground.
        let beside = contact(&[0.0, 0.3], &[[0.0, -1.0], [-1.0, 0.0]]);
        let beside = RigidContact { slips: vec![slide([1.0, 0.0]), Vec::new()], ..beside };
        assert_at(&beside.settle(&[1.0, 0.0]), [0.3, 0.0]);
    }

    /// A point in a corner of two planes, and points that all say the same.
    #[test]
    fn repeated_points_do_no_harm() {
        let corner = contact(&[0.1, 0.1, 0.1, 0.4], &[[-1.0, 0.0], [-1.0, 0.0], [-1.0, 1e-17], [0.0, -1.0]]);
        assert_at(&corner.settle(&[2.0, 1.0]), [0.1, 0.4]);
        assert!(corner.unheld().is_empty());
        let flat = contact(&[0.1, 0.1], &[[-1.0, 0.0], [-1.0, 1e-16]]);
        assert_at(&flat.settle(&[2.0, 0.0]), [0.1, 0.0]);
        assert_eq!(flat.unheld().len(), 1);
        assert!(flat.unheld()[0][0].abs() < 1e-14);
    }
}
