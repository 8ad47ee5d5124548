//! Eight elements: from the nodes of a chunk into the lanes, and what becomes of them back.

use super::response::Answer;
use super::shape::Vector;
use super::{Energies, Hourglass};
use crate::explicit::mass_scaling::raised;
use crate::lanes::{LANES, Lanes};

/// A node of a chunk: place x₁ [L] at the end of the increment and displacement Δu [L] in it.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(super) struct Place {
    pub x: [f64; 3],
    pub du: [f64; 3],
}

/// What all elements of a chunk have in common.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Common {
    pub answer: Answer,
    pub density: f64,
    /// Thickness of a plane at the start [L].
    pub thickness: f64,
    pub hourglass: Hourglass,
    /// Linear and quadratic bulk viscosity [-].
    pub viscosity: [f64; 2],
    /// Damping by stiffness [T].
    pub beta: f64,
}

/// An increment of a chunk.
pub(super) struct Run<'a> {
    pub common: &'a Common,
    pub dt: f64,
    /// Elements.
    pub count: usize,
    pub places: &'a [Place],
    /// Where the nodes were at the start.
    pub reference: &'a [[f64; 3]],
    /// Factors on the masses of the elements, where they are scaled.
    pub factors: Option<&'a [f64]>,
    /// Stable increments [T] of the elements by themselves, where they are asked for.
    pub increments: Option<&'a mut [f64]>,
    /// Internal forces [F] on the local nodes and stiffness [F/L] there, to which those of the elements are added.
    pub forces: &'a mut [[f64; 4]],
}

/// What an increment made of a chunk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outcome {
    pub energies: Energies,
    /// Largest stable increment [T], and the element it is of.
    pub stable: (f64, usize),
    /// The largest 2ξω [1/T] of an element.
    pub damping: f64,
    /// The first element turned inside out.
    pub inverted: Option<usize>,
}

/// What an increment made of eight elements.
pub(super) struct Batch<const N: usize> {
    pub forces: [Vector; N],
    /// What no eigenvalue of the element's stiffness is above [F/L].
    pub stiffness: Lanes,
    /// Internal, plastic, hourglass, viscous.
    pub energies: [Lanes; 4],
    /// Volume, of an element or about a point of it: the least counts.
    pub volume: Lanes,
    /// 2ξω [1/T] and the stable increment [T].
    pub damping: Lanes,
    pub stable: Lanes,
}

/// Nodes of eight elements each; the last one fills up the last batch.
pub(super) fn batches<const N: usize>(elements: &[Vec<u32>]) -> Vec<[[u32; LANES]; N]> {
    let of = |b: usize| {
        std::array::from_fn(|a| std::array::from_fn(|lane| elements[(b * LANES + lane).min(elements.len() - 1)][a]))
    };
    (0..elements.len().div_ceil(LANES)).map(of).collect()
}

/// A vector of each of the nodes.
#[inline(always)]
pub(super) fn gather<const N: usize>(nodes: &[[u32; LANES]; N], of: impl Fn(usize) -> [f64; 3]) -> [Vector; N] {
    let mut out = [[Lanes::ZERO; 3]; N];
    for a in 0..N {
        for lane in 0..LANES {
            let value = of(nodes[a][lane] as usize);
            for c in 0..3 {
                out[a][c].0[lane] = value[c];
            }
        }
    }
    out
}

/// Takes all batches through an increment, each with its part of the state; `advance` is given x₁, Δu and, where the material
/// asks for it, X.
#[inline(always)]
pub(super) fn all<const N: usize>(
    run: Run,
    nodes: &[[[u32; LANES]; N]],
    state: std::slice::ChunksExactMut<Lanes>,
    advance: impl Fn([&[Vector; N]; 3], &mut [Lanes]) -> Batch<N>,
) -> Outcome {
    let Run { common, count, places, reference, factors, mut increments, forces, .. } = run;
    let mut sums = [Lanes::ZERO; 4];
    let (energies, stable) = (Energies::default(), (f64::INFINITY, 0));
    let mut outcome = Outcome { energies, stable, damping: 0.0, inverted: None };
    let mut start = [[Lanes::ZERO; 3]; N];
    for (b, (nodes, state)) in nodes.iter().zip(state).enumerate() {
        let (x, du) = (gather(nodes, |n| places[n].x), gather(nodes, |n| places[n].du));
        if common.answer.is_total() {
            start = gather(nodes, |n| reference[n]);
        }
        let batch = advance([&x, &du, &start], state);
        let real = (count - b * LANES).min(LANES);
        for (sum, part) in sums.iter_mut().zip(batch.energies) {
            for lane in 0..real {
                sum.0[lane] += part.0[lane];
            }
        }
        for lane in 0..real {
            let (element, own) = (b * LANES + lane, batch.stable.0[lane]);
            increments.iter_mut().for_each(|increments| increments[element] = own);
            let (mut stable, mut damping) = (own, batch.damping.0[lane]);
            if let Some(factors) = factors {
                stable = raised(own, factors[element], common.viscosity[0]);
                damping /= factors[element];
            }
            outcome.damping = outcome.damping.max(damping);
            if stable < outcome.stable.0 {
                outcome.stable = (stable, element);
            }
            let volume = batch.volume.0[lane];
            if (volume <= 0.0 || volume.is_nan()) && outcome.inverted.is_none() {
                outcome.inverted = Some(b * LANES + lane);
            }
        }
        for lane in 0..real {
            for a in 0..N {
                let force = &mut forces[nodes[a][lane] as usize];
                (0..3).for_each(|c| force[c] += batch.forces[a][c].0[lane]);
                force[3] += batch.stiffness.0[lane];
            }
        }
    }
    let [internal, plastic, hourglass, viscous] = sums.map(|sum| sum.0.iter().sum::<f64>());
    outcome.energies = Energies { internal, plastic, hourglass, viscous };
    outcome
}
