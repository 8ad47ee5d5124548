//! Two bars of cubes, one at rest, the other one hits it (B02): ρ c v/2 at the interface for 2L/c, then the first one stands and
//! the second one goes on with its velocity. From then on the second one has come v (T − L/c).

use crate::machine::Origin;
use crate::measure::{self, Cost};
use crate::peer::Solver;
use crate::problem::{Answer, MeshFile, Scene};
use crate::rows::median;
use crate::study::Options;
use fe_core::element::ElementType::C3D8R;
use fe_mesh::Mesh;
use fe_mesh::generate::Block;
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Cubes of edge 1 along a bar and across it.
const LENGTH: usize = 40;
const WIDTH: usize = 6;

const YOUNG: f64 = 210e3;
const DENSITY: f64 = 7.85e-9;
const SPEED: f64 = 1000.0;

/// What acts between the bars, and whose words say so.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Words {
    /// None: the bars pass through each other.
    Nothing,
    /// A pair by penalty.
    Penalty,
    /// A pair on the spring that CalculiX has, as stiff as the cubes.
    Linear,
    /// CalculiX's pair.
    Calculix,
}

impl Words {
    fn in_words(self) -> &'static str {
        match self {
            Words::Nothing => "no contact",
            Words::Penalty => "penalty",
            Words::Linear | Words::Calculix => "linear, E/h",
        }
    }

    /// Behaviour, what belongs to the model, and what begins the step.
    fn cards(self) -> [String; 3] {
        let linear = format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{YOUNG:?}\n");
        let begin = format!("*STEP\n*DYNAMIC, EXPLICIT\n, {:.9e}\n", period());
        let pair = "*CONTACT PAIR, INTERACTION=BETWEEN, MECHANICAL CONSTRAINT=PENALTY\nB_ZMIN, A_ZMAX\n";
        let hard = "*SURFACE BEHAVIOR\n".to_owned();
        match self {
            Words::Nothing => [hard, String::new(), begin],
            Words::Penalty => [hard, String::new(), begin + pair],
            Words::Linear => [linear, String::new(), begin + pair],
            Words::Calculix => [
                linear,
                "*CONTACT PAIR, INTERACTION=BETWEEN, TYPE=NODE TO SURFACE\nB_ZMIN, A_ZMAX\n".into(),
                format!("*STEP, NLGEOM, INC=1000000\n*DYNAMIC, EXPLICIT\n1e-7, {:.9e}\n", period()),
            ],
        }
    }
}

/// Time of the run [T]: contact ends at two thirds.
fn period() -> f64 {
    3.0 * LENGTH as f64 / (YOUNG / DENSITY).sqrt()
}

fn mesh() -> Mesh {
    let (width, length) = (WIDTH as f64, LENGTH as f64);
    let bar = |prefix: &str, from: f64| {
        let at = move |[x, y, z]: [f64; 3]| [width * x, width * y, from + length * z];
        Block::hex8([WIDTH, WIDTH, LENGTH]).mapped(at).prefixed(prefix)
    };
    let mut mesh = bar("A_", 0.0);
    mesh.append(&bar("B_", length));
    mesh
}

fn scene(words: Words) -> Scene {
    let sections = ["A", "B"].map(|bar| format!("*SOLID SECTION, ELSET={bar}_BLOCK, MATERIAL=STEEL\n")).concat();
    let [behavior, model, step] = words.cards();
    let cards = format!(
        "*MATERIAL, NAME=STEEL\n*ELASTIC\n{YOUNG:?}, 0.\n*DENSITY\n{DENSITY:e}\n{sections}*SURFACE INTERACTION, NAME=BETWEEN\n\
         {behavior}{model}*INITIAL CONDITIONS, TYPE=VELOCITY\nA_BLOCK, 3, {SPEED:?}\n{step}\
         *NODE PRINT, NSET=B_BLOCK, FREQUENCY=1000000\nU\n*END STEP\n"
    );
    let mesh = mesh();
    let unknowns = 3 * mesh.points.len();
    Scene { name: "bars".into(), mesh, elements: vec![("A_BLOCK", C3D8R), ("B_BLOCK", C3D8R)], cards, unknowns }
}

/// How far the second bar has come, by its lumped masses, over v (T − L/c), less 1.
fn error(scene: &Scene, folder: &Path) -> Result<f64, String> {
    let moved = Answer::read(&folder.join("bars.dat"))?.displacements_of(&scene.mesh, "B_BLOCK")?;
    let half = |x: f64, from: f64, to: f64| if x == from || x == to { 0.5 } else { 1.0 };
    let (width, length) = (WIDTH as f64, LENGTH as f64);
    let weight = |[x, y, z]: [f64; 3]| half(x, 0.0, width) * half(y, 0.0, width) * half(z, length, 2.0 * length);
    let sums = moved.iter().fold([0.0; 2], |[sum, all], (point, u)| {
        let weight = weight(scene.mesh.points[*point]);
        [sum + weight * u[2], all + weight]
    });
    let wave = length / (YOUNG / DENSITY).sqrt();
    Ok(sums[0] / sums[1] / (SPEED * (period() - wave)) - 1.0)
}

/// Increments of a run, from what it printed.
fn increments(words: Words, log: &Path) -> Result<f64, Box<dyn Error>> {
    let text = std::fs::read_to_string(log)?;
    let number = match words {
        Words::Calculix => {
            let size = text.split("SELECTED time increment:").nth(1).and_then(|rest| rest.split_whitespace().next());
            size.and_then(|size| size.parse::<f64>().ok()).map(|size| (period() / size).ceil())
        }
        _ => text.split(" increments)").next().and_then(|told| told.split_whitespace().last()?.parse().ok()),
    };
    number.ok_or_else(|| format!("{} does not tell the increments", log.display()).into())
}

/// A way to run the bars, and what that took.
struct Row {
    solver: Solver,
    words: Words,
    deck: PathBuf,
    scene: Scene,
    costs: Vec<Cost>,
    /// `None` without contact.
    error: Option<f64>,
    increments: f64,
}

impl Row {
    fn new((solver, words): (Solver, Words), work: &Path) -> std::io::Result<Self> {
        let scene = scene(words);
        let folder = work.join("explicit").join(format!("{words:?}").to_lowercase());
        let deck = scene.write(&folder, MeshFile::Cards)?;
        Ok(Row { solver, words, deck, scene, costs: Vec::new(), error: None, increments: 0.0 })
    }

    fn run(&mut self, threads: usize) -> Result<(), Box<dyn Error>> {
        let folder = self.deck.parent().unwrap_or(Path::new("."));
        self.costs.push(measure::run(&self.solver.command(&self.deck, threads), folder, "run.log", threads)?);
        self.increments = increments(self.words, &folder.join("run.log"))?;
        self.error = if self.words == Words::Nothing { None } else { Some(error(&self.scene, folder)?) };
        Ok(())
    }

    /// Processor seconds of the whole process.
    fn cpu(&self) -> f64 {
        median(self.costs.iter().map(|cost| cost.cpu))
    }

    /// The same [µs] an element and increment.
    fn each(&self) -> f64 {
        1e6 * self.cpu() / (elements() as f64 * self.increments)
    }
}

fn elements() -> usize {
    2 * LENGTH * WIDTH * WIDTH
}

/// Runs the bars in all ways, in turn, and prints a line each, and ratios.
pub fn study(origin: &Origin, options: &Options, out: &mut dyn Write) -> Result<(), Box<dyn Error>> {
    let own = || Solver::own(&origin.version);
    let mut ways = vec![(own()?, Words::Nothing), (own()?, Words::Penalty), (own()?, Words::Linear)];
    match Solver::calculix() {
        Some(solver) => ways.push((solver, Words::Calculix)),
        None => writeln!(out, "CalculiX is not installed (benchmarks/scripts/install_calculix.sh): no comparison")?,
    }
    let mut rows = ways.into_iter().map(|way| Row::new(way, &options.work)).collect::<Result<Vec<_>, _>>()?;
    for run in 0..=options.runs {
        for row in &mut rows {
            row.run(options.threads)?;
            if run == 0 {
                row.costs.clear();
            }
        }
    }
    writeln!(out, "two bars of {} C3D8R in all, whole processes in turn; error of the second one's way", elements())?;
    let titles = ["increments", "wall s", "cpu s", "µs/elem./inc.", "error"];
    write!(out, "{:<12}{:<14}", "program", "contact")?;
    titles.iter().try_for_each(|title| write!(out, "{title:>14}"))?;
    writeln!(out)?;
    for row in &rows {
        let wall = median(row.costs.iter().map(|cost| cost.wall));
        let error = row.error.map_or("-".into(), |error| format!("{error:+.2e}"));
        write!(out, "{:<12}{:<14}{:>14}", row.solver.name, row.words.in_words(), row.increments)?;
        writeln!(out, "{wall:>14.3}{:>14.3}{:>14.3}{error:>14}", row.cpu(), row.each())?;
    }
    let [penalty, linear] = [1, 2].map(|k| rows[k].each() / rows[0].each());
    writeln!(out, "an increment with contact over one without: penalty {penalty:.2}, linear {linear:.2}")?;
    if let Some(peer) = rows.get(3) {
        let [whole, each] = [rows[2].cpu() / peer.cpu(), rows[2].each() / peer.each()];
        writeln!(out, "linear over calculix: {whole:.4} of the processor time, {each:.4} an element and increment")?;
    }
    Ok(())
}
