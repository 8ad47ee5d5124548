//! The very same deck through this program and through CalculiX, in turn.

use crate::machine::Origin;
use crate::peer::Solver;
use crate::problem::{MeshFile, Problem};
use crate::rows::{Row, median, quantile};
use crate::study::{Job, Options, medians};
use std::error::Error;
use std::io::Write;

/// Runs the scenes that a problem names for comparison and prints errors, costs and ratios. Without CalculiX a line
/// says so, and this program runs alone.
pub fn compare(problem: &dyn Problem, options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let mut solvers = vec![Solver::own(&origin.version)?];
    match Solver::calculix() {
        Some(solver) => solvers.push(solver),
        None => writeln!(out, "CalculiX is not installed (benchmarks/scripts/install_calculix.sh): no comparison")?,
    }
    let versions: Vec<&str> = solvers.iter().map(|solver| solver.version.as_str()).collect();
    writeln!(out, "{}: {}", problem.name(), problem.about())?;
    writeln!(
        out,
        "{origin}; {}; the same deck, in turn; {} thread(s) each; medians of {} runs\n",
        versions.join(", "),
        options.threads,
        options.runs
    )?;
    write!(out, "{:<24}{:>10}  {:<12}", "scene", "unknowns", "program")?;
    problem.norms().iter().try_for_each(|norm| write!(out, "{:>14}", norm.name))?;
    writeln!(out, "{:>10}{:>10}{:>9}", "wall s", "cpu s", "MB")?;
    let mut rows = Vec::new();
    for (curve, n) in problem.compared() {
        let scene = problem.scene(&curve, n);
        if scene.unknowns > options.most {
            continue;
        }
        let write =
            |solver: &Solver| scene.write(&options.work.join(problem.name()).join(solver.name), MeshFile::Cards);
        let job = |solver| -> std::io::Result<Job> {
            let (curve, threads) = (curve.name(), options.threads);
            Ok(Job { problem, curve, n, scene: &scene, solver, deck: write(solver)?, threads })
        };
        let jobs = solvers.iter().map(job).collect::<Result<Vec<_>, _>>()?;
        let mut runs: Vec<Vec<Row>> = vec![Vec::new(); solvers.len()];
        for run in 0..=options.runs {
            for (job, runs) in jobs.iter().zip(&mut runs) {
                let row = job.run(run)?;
                runs.extend((run > 0).then_some(row));
            }
        }
        for (solver, runs) in solvers.iter().zip(&runs) {
            write!(out, "{:<24}{:>10}  {:<12}", scene.name, scene.unknowns, solver.name)?;
            runs[0].errors.iter().try_for_each(|error| write!(out, "{error:>+14.3e}"))?;
            let cost = medians(runs);
            writeln!(out, "{:>10.3}{:>10.3}{:>9.0}", cost.wall, cost.cpu, 1e-6 * cost.memory)?;
        }
        if let [own, peer] = &runs[..] {
            print_ratios(out, own, peer)?;
        }
        rows.extend(runs.into_iter().flatten());
    }
    let path = options.results.join(format!("{}_compared.csv", problem.name()));
    crate::rows::write(&path, &origin, problem.norms(), &rows)?;
    Ok(writeln!(out, "rows: {}", path.display())?)
}

/// Ratios of each pair of runs: median and quartiles.
fn print_ratios(out: &mut dyn Write, own: &[Row], peer: &[Row]) -> std::io::Result<()> {
    write!(out, "{:<24}{:>10}  ratio by pair", "", "")?;
    let parts = |row: &Row| [row.cost.wall, row.cost.cpu, row.cost.memory];
    for (index, name) in ["wall", "cpu", "memory"].iter().enumerate() {
        let ratios: Vec<f64> = own.iter().zip(peer).map(|(own, peer)| parts(own)[index] / parts(peer)[index]).collect();
        let [low, high] = [0.25, 0.75].map(|part| quantile(ratios.iter().copied(), part));
        write!(out, "  {name} {:.3} ({low:.3}–{high:.3})", median(ratios.iter().copied()))?;
    }
    writeln!(out)
}
