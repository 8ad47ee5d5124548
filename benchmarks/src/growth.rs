//! How seconds and memory grow with the unknowns: the cantilever from some twenty thousand to three hundred thousand,
//! each run in a process of its own.

use crate::fit;
use crate::machine::Origin;
use crate::measure::{self, Cost};
use crate::problem::{Curve, MeshFile, Problem};
use crate::problems::cantilever::Cantilever;
use crate::rows::median;
use crate::study::Options;
use fe::observer::Silent;
use fe_core::element::ElementType;
use std::error::Error;
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

/// Name of the subcommand that runs a deck and prints its seconds by phase.
pub const PHASES: &str = "phases";

/// What is measured of a run: seconds by phase, those of the whole process, and its memory [MB].
const MEASURED: [&str; 10] = ["read", "search", "order", "assemble", "factor", "solve", "write", "wall", "cpu", "MB"];

/// Seconds below which a phase is left out of the exponents on all meshes.
const LEAST: f64 = 0.01;

/// Elements and refinements: 19,440, 94,500 and some 300,000 unknowns.
fn curves() -> [Curve; 2] {
    [(ElementType::C3D8, vec![8, 14, 21]), (ElementType::C3D10, vec![4, 7, 10])].map(|(element, sizes)| Curve {
        element,
        variant: "",
        sizes,
    })
}

/// Runs the cantilever on all its meshes and prints medians and exponents.
pub fn study(options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let (threads, runs) = (options.threads, options.runs);
    writeln!(out, "growth: {}", Cantilever.about())?;
    writeln!(out, "{origin}; {threads} thread(s); medians of {runs} runs\n")?;
    write!(out, "{:<8}{:>4}{:>10}", "element", "n", "unknowns")?;
    MEASURED.iter().try_for_each(|name| write!(out, "{name:>10}"))?;
    writeln!(out)?;
    let mut rows = format!("element,n,unknowns,commit,machine,threads,run,{}\n", MEASURED.join(","));
    for curve in curves() {
        let mut points: Vec<(usize, [f64; 10])> = Vec::new();
        for &n in &curve.sizes {
            let scene = Cantilever.scene(&curve, n);
            if scene.unknowns > options.most {
                continue;
            }
            let deck = scene.write(&options.work.join("growth"), MeshFile::Gmsh)?;
            let mut samples = Vec::new();
            for run in 1..=runs {
                let sample = measured(&deck, threads)?;
                let numbers = sample.map(|value| format!("{value:.6}")).join(",");
                let Origin { commit, machine, .. } = &origin;
                // Writing to a string does not fail.
                let _ = writeln!(
                    rows,
                    "{},{n},{},{commit},\"{machine}\",{threads},{run},{numbers}",
                    curve.name(),
                    scene.unknowns
                );
                samples.push(sample);
            }
            let medians = std::array::from_fn(|k| median(samples.iter().map(|sample| sample[k])));
            write!(out, "{:<8}{n:>4}{:>10}", curve.name(), scene.unknowns)?;
            medians.iter().try_for_each(|value| write!(out, "{:>10}", three_digits(*value)))?;
            writeln!(out)?;
            points.push((scene.unknowns, medians));
        }
        print_exponents(&points, out)?;
    }
    std::fs::create_dir_all(&options.results)?;
    let path = options.results.join("growth.csv");
    std::fs::write(&path, rows)?;
    Ok(writeln!(out, "rows: {}", path.display())?)
}

/// Exponents over the unknowns, by least squares in log–log.
fn print_exponents(points: &[(usize, [f64; 10])], out: &mut dyn Write) -> std::io::Result<()> {
    if points.len() < 2 {
        return Ok(());
    }
    write!(out, "{:<22}", "  exponent")?;
    for k in 0..MEASURED.len() {
        let measured: Vec<(f64, f64)> = points.iter().map(|(unknowns, values)| (*unknowns as f64, values[k])).collect();
        // A phase that a scene does not have takes no time worth the name.
        if measured.iter().any(|point| point.1 >= LEAST) && measured.iter().all(|point| point.1 > 0.0) {
            write!(out, "{:>10.2}", fit::slope(&measured))?;
        } else {
            write!(out, "{:>10}", "-")?;
        }
    }
    writeln!(out)
}

/// A number with three digits, the usual ones of a table of seconds.
fn three_digits(value: f64) -> String {
    let digits = if value >= 100.0 { 0 } else { 3 };
    format!("{value:.digits$}")
}

/// One run in a process of its own.
fn measured(deck: &Path, threads: usize) -> Result<[f64; 10], Box<dyn Error>> {
    let own = std::env::current_exe()?.display().to_string();
    let file = deck.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = deck.parent().unwrap_or(Path::new("."));
    let command = [own, PHASES.into(), file, "--threads".into(), threads.to_string()];
    let Cost { wall, cpu, memory } = measure::run(&command, folder, "phases.log", threads)?;
    let text = std::fs::read_to_string(folder.join("phases.log"))?;
    let seconds: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    match seconds[..] {
        [read, search, order, assemble, factor, solve, write] => {
            Ok([read, search, order, assemble, factor, solve, write, wall, cpu, 1e-6 * memory])
        }
        _ => Err(format!("the run of {} told no seconds: {text}", deck.display()).into()),
    }
}

/// Runs a deck and prints its seconds by phase.
pub fn phases(deck: &Path, threads: usize, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.max(1)).build()?;
    let report = pool.install(|| fe::run(deck, &fe::standard(), &mut Silent))?;
    let (s, p) = (report.certificate.seconds, report.certificate.seconds.procedure);
    let seconds = [s.read, s.search, p.order, p.assemble, p.factor, p.solve, s.write];
    Ok(writeln!(out, "{}", seconds.map(|value| value.to_string()).join(" "))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// N, N^1.5 and what is not there.
    #[test]
    fn exponents_are_those_of_the_powers() {
        let point = |n: usize| {
            let mut values = [0.0; 10];
            values[4] = 1e-6 * (n as f64).powf(1.5);
            values[9] = 1e-2 * n as f64;
            (n, values)
        };
        let mut told = Vec::new();
        print_exponents(&[point(1000), point(10_000), point(300_000)], &mut told).unwrap();
        let told = String::from_utf8(told).unwrap();
        let words: Vec<&str> = told.split_whitespace().collect();
        assert_eq!(words, ["exponent", "-", "-", "-", "-", "1.50", "-", "-", "-", "-", "1.00"], "{told}");
    }

    #[test]
    fn a_run_tells_its_seconds_by_phase() {
        let folder = std::env::temp_dir().join(format!("growth-{}", std::process::id()));
        let scene = Cantilever.scene(&curves()[0], 1);
        let deck = scene.write(&folder, MeshFile::Gmsh).unwrap();
        let mut told = Vec::new();
        phases(&deck, 1, &mut told).unwrap();
        std::fs::remove_dir_all(folder).unwrap();
        let seconds: Vec<f64> =
            String::from_utf8(told).unwrap().split_whitespace().map(|w| w.parse().unwrap()).collect();
        assert_eq!(seconds.len(), 7);
        // Without contact there is next to nothing to search; a factorisation takes some time.
        assert!(seconds.iter().all(|s| *s >= 0.0) && seconds[4] > 0.0, "{seconds:?}");
    }
}
