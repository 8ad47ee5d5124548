//! Measures the curves of a problem: errors against unknowns, seconds and memory.

use crate::fit;
use crate::machine::Origin;
use crate::measure;
use crate::peer::Solver;
use crate::plot::{Line, Panel, Plot};
use crate::problem::{Answer, Curve, MeshFile, Norm, Problem, Scene};
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

/// A scene of a problem, written for a solver.
pub struct Job<'a> {
    /// The problem, which measures the errors.
    pub problem: &'a dyn Problem,
    /// Name of the curve.
    pub curve: String,
    /// Refinement.
    pub n: usize,
    /// The scene.
    pub scene: &'a Scene,
    /// Who runs it.
    pub solver: &'a Solver,
    /// Path of the deck.
    pub deck: PathBuf,
    /// Threads.
    pub threads: usize,
}

impl Job<'_> {
    /// Runs it, as the run of this number, and measures the errors of what it printed.
    pub fn run(&self, number: usize) -> Result<Row, Box<dyn Error>> {
        let Job { problem, n, scene, solver, deck, threads, .. } = self;
        let folder = deck.parent().unwrap_or(Path::new("."));
        let log = format!("{}.{}.log", scene.name, solver.name);
        let command = solver.command(deck, *threads);
        let cost = measure::run(&command, folder, &log, *threads)?;
        let answer = Answer::read(&deck.with_extension("dat"))?;
        Ok(Row {
            curve: self.curve.clone(),
            n: *n,
            unknowns: scene.unknowns,
            version: solver.version.clone(),
            threads: *threads,
            run: number,
            cost,
            errors: problem.errors(scene, &answer)?,
            command: without_folder(&command),
        })
    }
}

/// A command as a line, its program without the folder.
fn without_folder(command: &[String]) -> String {
    let (program, arguments) = command.split_first().map_or(("", &[][..]), |(p, a)| (p.as_str(), a));
    let name = Path::new(program).file_name().unwrap_or_default().to_string_lossy().into_owned();
    std::iter::once(name.as_str()).chain(arguments.iter().map(String::as_str)).collect::<Vec<_>>().join(" ")
}

/// Measures all curves of a problem, prints table and rates, and writes rows and plots.
pub fn study(problem: &dyn Problem, options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let origin = Origin::here();
    let solver = Solver::own(&origin.version)?;
    let folder = options.work.join(problem.name());
    writeln!(out, "{}: {}", problem.name(), problem.about())?;
    writeln!(out, "{origin}; {} threads; medians of {} runs\n", options.threads, options.runs)?;
    write!(out, "{:<30}{:>6}{:>10}", "curve", "n", "unknowns")?;
    problem.norms().iter().try_for_each(|norm| write!(out, "{:>w$}", norm.name, w = width(norm)))?;
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
            let (curve, threads) = (curve.name(), options.threads);
            let job = Job { problem, curve, n, scene: &scene, solver: &solver, deck, threads };
            let from = rows.len();
            for run in 0..=options.runs {
                let row = job.run(run)?;
                rows.extend((run > 0).then_some(row));
            }
            print_scene(out, problem.norms(), &rows[from..])?;
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
fn print_scene(out: &mut dyn Write, norms: &[Norm], rows: &[Row]) -> std::io::Result<()> {
    let Some(first) = rows.first() else { return Ok(()) };
    write!(out, "{:<30}{:>6}{:>10}", first.curve, first.n, first.unknowns)?;
    let mut errors = first.errors.iter().zip(norms);
    errors.try_for_each(|(error, norm)| write!(out, "{error:>w$.3e}", w = width(norm)))?;
    let cost = medians(rows);
    writeln!(out, "{:>10.3}{:>10.3}{:>9.0}", cost.wall, cost.cpu, 1e-6 * cost.memory)
}

/// Width of a norm's column.
fn width(norm: &Norm) -> usize {
    14.max(norm.name.len() + 2)
}

/// Rates over the last three meshes, and the work that a percent costs.
fn print_rates(out: &mut dyn Write, problem: &dyn Problem, curve: &Curve, rows: &[Row]) -> std::io::Result<()> {
    for (index, norm) in problem.norms().iter().enumerate() {
        let Some(in_size) = rate(rows, index, norm, &|rows| rows[0].n as f64) else { continue };
        let seconds = above_floor(rows, index, norm, &|rows| medians(rows).cpu);
        let in_seconds = rate(rows, index, norm, &|rows| medians(rows).cpu).unwrap_or(f64::NAN);
        let name = curve.name();
        write!(out, "  {name} {}: rate {in_size:.2} in n, {in_seconds:.2} in cpu seconds", norm.name)?;
        for percent in [1.0, 0.1, 0.01] {
            if let Some(cost) = fit::work_for(&seconds, 0.01 * percent) {
                write!(out, "; {percent} % in {cost:.2} s")?;
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// (work, error) of the scenes whose error is more than twice the model's own.
fn above_floor(rows: &[Row], index: usize, norm: &Norm, work: &dyn Fn(&[Row]) -> f64) -> Vec<(f64, f64)> {
    let points = scenes(rows).into_iter().map(|rows| (work(rows), rows[0].errors[index].abs()));
    points.filter(|point| point.1 > 2.0 * norm.floor).collect()
}

/// Rate of the error over the last three of these; `None` of fewer.
fn rate(rows: &[Row], index: usize, norm: &Norm, work: &dyn Fn(&[Row]) -> f64) -> Option<f64> {
    let points = above_floor(rows, index, norm, work);
    Some(-fit::slope(&points[points.len().checked_sub(3)?..]))
}

/// One plot for each norm.
fn plots(problem: &dyn Problem, rows: &[Row], origin: &Origin, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut paths = Vec::new();
    let foot = format!("{}; {}; commit {}", origin.machine, origin.version, origin.commit);
    for (index, norm) in problem.norms().iter().enumerate() {
        let panel = |work: &'static str, of: &dyn Fn(&[Row]) -> f64| Panel {
            work,
            lines: problem.curves().iter().map(|curve| line(&curve.name(), rows, (index, norm), of)).collect(),
        };
        let plot = Plot {
            title: &format!("{}: {}", problem.name(), norm.name),
            about: problem.about(),
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

/// The curve with its rate beside its name.
fn line(curve: &str, rows: &[Row], (index, norm): (usize, &Norm), work: &dyn Fn(&[Row]) -> f64) -> Line {
    let own: Vec<Row> = rows.iter().filter(|row| row.curve == curve).cloned().collect();
    let points = scenes(&own).iter().map(|rows| (work(rows), rows[0].errors[index].abs())).collect();
    let rate = rate(&own, index, norm, &|rows| rows[0].n as f64);
    Line { name: curve.to_string() + &rate.map_or(String::new(), |rate| format!(", rate {rate:.2}")), points }
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
