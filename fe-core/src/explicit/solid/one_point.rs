//! Elements of one shape with one integration point: their nodes and state, eight side by side.

use super::batch::{Common, Outcome, Run, all, batches, gather};
use super::chunk::Elements;
use super::kernel::{batch, geometry};
use super::shape::Shape;
use crate::element::Space;
use crate::lanes::{LANES, Lanes};
use pulp::{Arch, Simd, WithSimd};
use std::marker::PhantomData;

/// Numbers of state of a batch: stress, plastic strain, element mass, pressure of bulk viscosity, hourglass forces; in a plane also
/// 1 over the lightest node's part of the mass, and the stretch of the thickness.
const fn numbers(space: Space, hourglass: usize) -> usize {
    HOURGLASS + 3 * hourglass + if matches!(space, Space::Solid) { 0 } else { 2 }
}
pub(super) const PLASTIC: usize = 6;
pub(super) const MASS: usize = 7;
pub(super) const VISCOUS: usize = 8;
pub(super) const HOURGLASS: usize = 9;

#[derive(Debug)]
pub(super) struct OnePoint<S, const N: usize, const H: usize> {
    /// Local nodes of eight elements each; the last batch repeats its last element.
    nodes: Vec<[[u32; LANES]; N]>,
    state: Vec<Lanes>,
    shape: PhantomData<S>,
}

impl<S: Shape<N, H>, const N: usize, const H: usize> OnePoint<S, N, H> {
    const NUMBERS: usize = numbers(S::SPACE, H);

    /// Free of stress.
    pub fn new(elements: &[Vec<u32>]) -> Self {
        let nodes = batches(elements);
        let mut state = vec![Lanes::ZERO; nodes.len() * Self::NUMBERS];
        if S::SPACE != Space::Solid {
            // The stretch of the thickness.
            state.chunks_exact_mut(Self::NUMBERS).for_each(|state| state[HOURGLASS + 3 * H + 1] = Lanes::splat(1.0));
        }
        OnePoint { nodes, state, shape: PhantomData }
    }
}

impl<S: Shape<N, H>, const N: usize, const H: usize> Elements for OnePoint<S, N, H> {
    fn weigh(
        &mut self,
        common: &Common,
        (count, reference): (usize, &[[f64; 3]]),
        factor: &dyn Fn(usize) -> f64,
        masses: &mut [f64],
    ) {
        for (b, (nodes, state)) in self.nodes.iter().zip(self.state.chunks_exact_mut(Self::NUMBERS)).enumerate() {
            let x = gather(nodes, |n| reference[n]);
            let geometry = geometry::<S, N, H, false>(&x, &[[Lanes::ZERO; 3]; N]);
            let (mass, shares) = (geometry.volume * (common.density * common.thickness), S::shares(&x));
            state[MASS] = mass;
            if S::SPACE != Space::Solid {
                let most = |most: Lanes, share: &Lanes| most.max(Lanes::splat(1.0) / *share);
                state[HOURGLASS + 3 * H] = shares.iter().fold(Lanes::ZERO, most);
            }
            for lane in 0..(count - b * LANES).min(LANES) {
                let of_node = nodes.iter().zip(&shares);
                let mass = factor(b * LANES + lane) * mass.0[lane];
                of_node.for_each(|(n, share)| masses[n[lane] as usize] += mass * share.0[lane]);
            }
        }
    }

    fn advance(&mut self, run: Run) -> Outcome {
        Arch::new().dispatch(Pass::<S, N, H> { run, elements: self })
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.state[..])
    }

    fn point(&self, element: usize) -> ([f64; 6], f64) {
        let state = &self.state[element / LANES * Self::NUMBERS..];
        ([0, 1, 2, 3, 4, 5].map(|i| state[i].0[element % LANES]), state[PLASTIC].0[element % LANES])
    }
}

/// An increment of them all, on the widest vectors that the machine has.
struct Pass<'a, 'b, S, const N: usize, const H: usize> {
    run: Run<'a>,
    elements: &'b mut OnePoint<S, N, H>,
}

impl<S: Shape<N, H>, const N: usize, const H: usize> WithSimd for Pass<'_, '_, S, N, H> {
    type Output = Outcome;

    #[inline(always)]
    fn with_simd<V: Simd>(self, _: V) -> Outcome {
        if V::IS_SCALAR { self.go::<false>() } else { self.go::<true>() }
    }
}

impl<S: Shape<N, H>, const N: usize, const H: usize> Pass<'_, '_, S, N, H> {
    #[inline(always)]
    fn go<const FUSED: bool>(self) -> Outcome {
        let (common, dt) = (self.run.common, self.run.dt);
        let state = self.elements.state.chunks_exact_mut(numbers(S::SPACE, H));
        // Inlined as all the rest is: what is not would be compiled for the narrowest vectors.
        all(
            self.run,
            &self.elements.nodes,
            state,
            #[inline(always)]
            |motion, state| batch::<S, N, H, FUSED>(common, dt, motion, state),
        )
    }
}
