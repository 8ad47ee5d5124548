//! How fast explicit steps are: elements alone beside what the memory lets through, and two bars that hit each other beside
//! CalculiX; how general contact grows; what impacts lose; balls poured into a box.

mod bars;
mod bodies;
mod elements;
pub mod general;
pub mod impacts;
pub mod poured;

use crate::machine::Origin;
use crate::study::Options;
use std::error::Error;
use std::io::Write;

/// Measures elements and bars, and prints a table each.
pub fn study(options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let Options { threads, runs, .. } = options;
    writeln!(out, "{origin}; {threads} thread(s); medians of {runs} runs\n")?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(*threads).build()?;
    let mut table = Vec::new();
    pool.install(|| elements::study(*runs, &mut table))?;
    out.write_all(&table)?;
    bars::study(&origin, options, out)
}
