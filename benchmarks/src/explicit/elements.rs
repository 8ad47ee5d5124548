//! Updates of elements a second, beside what the memory lets through.

use super::bodies::solids;
use crate::rows::median;
use fe_core::element::ElementType::{self, C3D4, C3D8R};
use fe_core::explicit::solid::Solids;
use fe_core::explicit::{ExplicitTerm, Moving};
use fe_core::material::{Elastic, Hardening, Response};
use fe_core::structure::Structure;
use fe_mesh::generate::Block;
use rayon::prelude::*;
use std::io::{self, Write};
use std::time::Instant;

/// Increments of a run.
const INCREMENTS: usize = 20;

/// Numbers of each of the three arrays that the memory is measured with: 128 MB, more than any cache.
const NUMBERS: usize = 1 << 24;

/// A block in motion.
struct Moved {
    solids: Solids,
    v: Vec<f64>,
    u: Vec<f64>,
    forces: Vec<f64>,
}

/// A block whose material may yield, of so many cubes along each edge, every node at a speed of its own.
fn block(element: ElementType, n: usize) -> Moved {
    let mesh = if element == C3D4 { Block::tet4([n; 3]) } else { Block::hex8([n; 3]) }.mesh();
    let structure = Structure { mesh, elements: vec![element], ..Structure::default() };
    let freedoms = structure.freedoms(&[]);
    let hardening = Hardening { points: vec![(400.0, 0.0), (500.0, 1.0)] };
    let steel = Response::Plastic { elastic: Elastic { young: 210e3, poisson: 0.3 }, hardening };
    let solids = solids(&structure, &freedoms, (&steel, 7.85e-9), [0.06, 1.2]);
    let freedoms = freedoms.len();
    let v = (0..freedoms).map(|f| ((f * 7919) % 1000) as f64 * 1e-3).collect();
    Moved { solids, v, u: vec![0.0; freedoms], forces: vec![0.0; freedoms] }
}

impl Moved {
    /// Updates a second, in increments so short that nothing yields.
    fn rate(&mut self) -> io::Result<f64> {
        let at = Moving { u: &self.u, v: &self.v, step_time: 0.0, total_time: 0.0, dt: 1e-9, stable: f64::INFINITY };
        let start = Instant::now();
        for _ in 0..INCREMENTS {
            self.forces.fill(0.0);
            self.solids.advance(&at, &mut self.forces).map_err(io::Error::other)?;
        }
        Ok((self.solids.count() * INCREMENTS) as f64 / start.elapsed().as_secs_f64())
    }

    /// Bytes an update that go between memory and processor at most: all is read once and written once, and of the motion two
    /// vectors are read, the forces cleared and summed.
    fn traffic(&self) -> f64 {
        let vectors = 6 * size_of_val(&self.u[..]);
        (2 * self.solids.bytes() + vectors) as f64 / self.solids.count() as f64
    }
}

/// Bytes a second of a = b + 3 c over arrays that no cache holds: two read, one written (STREAM triad).
fn bandwidth() -> f64 {
    let (mut a, b, c) = (vec![0.0; NUMBERS], vec![1.0; NUMBERS], vec![2.0; NUMBERS]);
    let part = NUMBERS / rayon::current_num_threads().max(1);
    let mut best = 0.0f64;
    for _ in 0..5 {
        let start = Instant::now();
        a.par_chunks_mut(part).zip(b.par_chunks(part).zip(c.par_chunks(part))).for_each(|(a, (b, c))| {
            a.iter_mut().zip(b.iter().zip(c)).for_each(|(a, (b, c)): (&mut f64, (&f64, &f64))| *a = b + 3.0 * c);
        });
        best = best.max((3 * NUMBERS * size_of::<f64>()) as f64 / start.elapsed().as_secs_f64());
    }
    std::hint::black_box(&a);
    best
}

/// Prints the rates of C3D8R and C3D4 in blocks that no cache holds.
pub fn study(runs: usize, out: &mut Vec<u8>) -> io::Result<()> {
    let memory = bandwidth();
    writeln!(out, "elements: blocks with J2 plasticity and bulk viscosity; memory {:.1} GB/s (triad)", 1e-9 * memory)?;
    let titles = ["elements", "M updates/s", "bytes each", "memory's limit", "of the limit"];
    write!(out, "{:<8}", "element")?;
    titles.iter().try_for_each(|title| write!(out, "{title:>16}"))?;
    writeln!(out)?;
    for (element, n) in [(C3D8R, 64), (C3D4, 40)] {
        let mut block = block(element, n);
        block.rate()?;
        let rates = (0..runs).map(|_| block.rate()).collect::<io::Result<Vec<f64>>>()?;
        let (rate, traffic) = (median(rates), block.traffic());
        let limit = memory / traffic;
        writeln!(
            out,
            "{:<8}{:>16}{:>16.2}{traffic:>16.0}{:>16.1}{:>15.0}%",
            element.name(),
            block.solids.count(),
            1e-6 * rate,
            1e-6 * limit,
            100.0 * rate / limit
        )?;
    }
    writeln!(out)
}
