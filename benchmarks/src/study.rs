//! Measures the curves of a problem: errors against unknowns, seconds and memory.

use crate::fit;
use crate::machine::Origin;
use crate::measure;
use crate::peer::Solver;
use crate::plot::{Line, Panel, Plot};
use crate::problem::{Answer, Curve, MeshFile, Problem, Scene};
use crate::rows::{Row, median};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};

/// How a study is run.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Threads.
    pub threads: usize,
    /// Runs of each scene, after one that is not counted.
    pub runs: usize,
    /// Largest number of unknowns.
    pub most: usize,
    /// Folder of decks, meshes and answers.
    pub work: PathBuf,
    /// Folder of rows and plots.
    pub results: PathBuf,
}

/// Runs a scene that was written to `deck` once, and measures the errors of what it printed.
pub fn run_once(
    problem: &dyn Problem,
    scene: &Scene,
    (solver, deck, threads): (&Solver, &Path, usize),
) -> Result<(measure::Cost, Vec<f64>), Box<dyn Error>> {
    let folder = deck.parent().unwrap_or(Path::new("."));
    let log = format!("{}.{}.log", scene.name, solver.name);
    let cost = measure::run(&solver.command(deck, threads), folder, &log, threads)?;
    let answer = Answer::read(&deck.with_extension("dat"))?;
    Ok((cost, problem.errors(scene, &answer)?))
}

/// The row of a run.
pub fn row(curve: &str, n: usize, scene: &Scene, solver: &Solver, run: usize) -> Row {
    Row {
        curve: curve.into(),
        n,
        unknowns: scene.unknowns,
        version: solver.version.clone(),
        threads: 0,
        run,
        cost: measure::Cost { wall: 0.0, cpu: 0.0, memory: 0.0 },
        errors: Vec::new(),
        command: String::new(),
    }
}

/// Measures all curves of a problem, prints table and rates, and writes rows and plots.
pub fn study(problem: &dyn Problem, options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let solver = Solver::own(&origin.version)?;
    let folder = options.work.join(problem.name());
    writeln!(out, "{}: {}", problem.name(), problem.about())?;
    writeln!(
        out,
        "{}; commit {}; {} threads; medians of {} runs\n",
        origin.machine, origin.commit, options.threads, options.runs
    )?;
    write!(out, "{:<24}{:>6}{:>10}", "curve", "n", "unknowns")?;
    problem.norms().iter().try_for_each(|norm| write!(out, "{:>14}", norm.name))?;
    writeln!(out, "{:>10}{:>10}{:>9}", "wall s", "cpu s", "MB")?;
    let mut rows = Vec::new();
    for curve in problem.curves() {
        let first = rows.len();
        for &n in &curve.sizes {
            let scene = problem.scene(&curve, n);
            if scene.unknowns > options.most {
                continue;
            }
            let deck = scene.write(&folder, MeshFile::Gmsh)?;
            let from = rows.len();
            for run in 0..=options.runs {
                let (cost, errors) = run_once(problem, &scene, (&solver, &deck, options.threads))?;
                if run > 0 {
                    let command = format!("fe run {}.inp --threads {}", scene.name, options.threads);
                    let threads = options.threads;
                    rows.push(Row { cost, errors, command, threads, ..row(&curve.name(), n, &scene, &solver, run) });
                }
            }
            print_scene(out, &rows[from..])?;
        }
        print_rates(out, problem, &curve, &rows[first..])?;
    }
    let path = options.results.join(format!("{}.csv", problem.name()));
    crate::rows::write(&path, &origin, problem.norms(), &rows)?;
    writeln!(out, "rows: {}", path.display())?;
    for plot in plots(problem, &rows, &origin, &options.results)? {
        writeln!(out, "plot: {}", plot.display())?;
    }
    Ok(())
}

/// The medians of the runs of one scene.
fn print_scene(out: &mut dyn Write, rows: &[Row]) -> std::io::Result<()> {
    let Some(first) = rows.first() else { return Ok(()) };
    write!(out, "{:<24}{:>6}{:>10}", first.curve, first.n, first.unknowns)?;
    first.errors.iter().try_for_each(|error| write!(out, "{error:>14.3e}"))?;
    let cost = medians(rows);
    writeln!(out, "{:>10.3}{:>10.3}{:>9.0}", cost.wall, cost.cpu, 1e-6 * cost.memory)
}

/// Rates over the last three meshes, and the work that a percent costs.
fn print_rates(out: &mut dyn Write, problem: &dyn Problem, curve: &Curve, rows: &[Row]) -> std::io::Result<()> {
    let scenes = scenes(rows);
    for (index, norm) in problem.norms().iter().enumerate() {
        let over = |work: &dyn Fn(&[Row]) -> f64| -> Vec<(f64, f64)> {
            let points = scenes.iter().map(|rows| (work(rows), rows[0].errors[index].abs()));
            points.filter(|point| point.1 > norm.floor).collect()
        };
        let sizes = over(&|rows| rows[0].n as f64);
        if sizes.len() < 3 {
            continue;
        }
        let last = |points: &[(f64, f64)]| -fit::slope(&points[points.len() - 3..]);
        let seconds = over(&|rows| medians(rows).cpu);
        write!(
            out,
            "  {} {}: rate {:.2} in n, {:.2} in cpu seconds",
            curve.name(),
            norm.name,
            last(&sizes),
            last(&seconds)
        )?;
        for percent in [1.0, 0.1, 0.01] {
            if let Some(cost) = fit::work_for(&seconds, 0.01 * percent) {
                write!(out, "; {percent} % in {cost:.2} s")?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// One plot for each norm.
fn plots(problem: &dyn Problem, rows: &[Row], origin: &Origin, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut paths = Vec::new();
    let foot = format!("{}; {}; commit {}", origin.machine, origin.version, origin.commit);
    for (index, norm) in problem.norms().iter().enumerate() {
        let panel = |work: &'static str, of: &dyn Fn(&[Row]) -> f64| Panel {
            work,
            lines: problem.curves().iter().map(|curve| line(&curve.name(), rows, index, of)).collect(),
        };
        let plot = Plot {
            title: &format!("{}: {}", problem.name(), problem.about()),
            origin: &foot,
            error: norm.name,
            floor: norm.floor,
            panels: vec![
                panel("unknowns", &|rows| rows[0].unknowns as f64),
                panel("seconds, whole process", &|rows| medians(rows).wall),
                panel("peak memory [MB]", &|rows| 1e-6 * medians(rows).memory),
            ],
        };
        let path = folder.join(format!("{}_{}.svg", problem.name(), norm.name.replace(' ', "_")));
        plot.write(&path)?;
        paths.push(path);
    }
    Ok(paths)
}

fn line(curve: &str, rows: &[Row], norm: usize, work: &dyn Fn(&[Row]) -> f64) -> Line {
    let own: Vec<Row> = rows.iter().filter(|row| row.curve == curve).cloned().collect();
    let points = scenes(&own).iter().map(|rows| (work(rows), rows[0].errors[norm].abs())).collect();
    Line { name: curve.into(), points }
}

/// The rows of each scene, which stand together.
fn scenes(rows: &[Row]) -> Vec<&[Row]> {
    rows.chunk_by(|a, b| a.curve == b.curve && a.n == b.n).collect()
}

/// Medians of the runs of a scene.
pub fn medians(rows: &[Row]) -> measure::Cost {
    let of = |part: &dyn Fn(&measure::Cost) -> f64| median(rows.iter().map(|row| part(&row.cost)));
    measure::Cost { wall: of(&|c| c.wall), cpu: of(&|c| c.cpu), memory: of(&|c| c.memory) }
}
