//! One run of a deck, through the entry that `fe` uses, and what came out of it.

use fe::certificate::Certificate;
use fe::observer::{Event, Observer};
use fe::terms::Terms;
use fe::{Report, standard};
use fe_contact::state::ContactState;
use fe_io::{Deck, resolve};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A folder for the decks of one scene.
pub struct Place {
    folder: PathBuf,
}

/// What a run told and left.
pub struct Run {
    /// The deck.
    pub deck: PathBuf,
    /// The report, or why there is none.
    pub ended: Result<Report, String>,
    /// The program panicked.
    pub panicked: bool,
    /// Remarks and warnings, in order.
    pub notes: Vec<String>,
    /// Plans of the steps that began.
    pub plans: Vec<String>,
    /// Certificates of the increments.
    pub certificates: Vec<Certificate>,
    /// Attempts that were cut back.
    pub cutbacks: usize,
    /// Iterations of the increments that converged.
    pub iterations: usize,
    /// Wall-clock seconds.
    pub seconds: f64,
}

#[derive(Default)]
struct Recorded {
    notes: Vec<String>,
    plans: Vec<String>,
    certificates: Vec<Certificate>,
    cutbacks: usize,
    iterations: usize,
}

impl Observer for Recorded {
    fn event(&mut self, event: Event) {
        match event {
            Event::Note(note) => self.notes.push(note.into()),
            Event::Step { plan, .. } => self.plans.push(plan.to_string()),
            Event::Increment { convergence, certificate, .. } => {
                self.iterations += convergence.iterations();
                self.certificates.push(certificate.clone());
            }
            Event::Cutback { .. } => self.cutbacks += 1,
            Event::Frame(_) | Event::Done(_) => {}
        }
    }
}

impl Place {
    /// A folder that is made when something is written there.
    pub fn new(folder: PathBuf) -> Self {
        Place { folder }
    }

    /// Writes a file here.
    pub fn write(&self, name: &str, bytes: &[u8]) -> std::io::Result<PathBuf> {
        std::fs::create_dir_all(&self.folder)?;
        let path = self.folder.join(name);
        std::fs::write(&path, bytes)?;
        Ok(path)
    }

    /// Writes and runs a deck `NAME.inp`. A panic, or a file that cannot be written, is an end like others.
    pub fn run(&self, name: &str, deck: &str) -> Run {
        match self.write(&format!("{name}.inp"), deck.as_bytes()) {
            Ok(path) => run(&path),
            Err(error) => Run::unwritten(self.folder.join(name), error.to_string()),
        }
    }

    /// As [`Place::run`], with a number of threads.
    pub fn run_with_threads(&self, name: &str, deck: &str, threads: usize) -> Run {
        match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
            Ok(pool) => pool.install(|| self.run(name, deck)),
            Err(error) => Run::unwritten(self.folder.join(name), error.to_string()),
        }
    }

    /// What `fe check` says of a deck.
    pub fn check(&self, name: &str, deck: &str) -> Result<String, String> {
        let path = self.write(&format!("{name}.inp"), deck.as_bytes()).map_err(|error| error.to_string())?;
        let checked = catch_unwind(|| fe::check::check(&path, &standard()));
        checked.map_err(|_| "panicked".to_owned())?.map_err(|failure| failure.to_string())
    }
}

/// Runs a deck.
pub fn run(path: &Path) -> Run {
    let start = Instant::now();
    let mut told = Recorded::default();
    let ended = catch_unwind(AssertUnwindSafe(|| fe::run(path, &standard(), &mut told)));
    let seconds = start.elapsed().as_secs_f64();
    let panicked = ended.is_err();
    let ended = match ended {
        Ok(ended) => ended.map_err(|failure| failure.to_string()),
        Err(_) => Err("panicked".into()),
    };
    let Recorded { notes, plans, certificates, cutbacks, iterations } = told;
    Run { deck: path.into(), ended, panicked, notes, plans, certificates, cutbacks, iterations, seconds }
}

impl Run {
    fn unwritten(deck: PathBuf, why: String) -> Self {
        Run {
            deck,
            ended: Err(why),
            panicked: true,
            notes: Vec::new(),
            plans: Vec::new(),
            certificates: Vec::new(),
            cutbacks: 0,
            iterations: 0,
            seconds: 0.0,
        }
    }

    /// Displacements at the end; none where the run did not come to it.
    pub fn u(&self) -> &[f64] {
        self.ended.as_ref().map_or(&[], |report| &report.last.u)
    }

    /// True when a remark holds all these words.
    pub fn told(&self, words: &[&str]) -> bool {
        self.notes.iter().any(|note| words.iter().all(|word| note.contains(word)))
    }

    /// The scene with its solution; `None` where the run did not come to its end.
    pub fn solved(&self) -> Option<Solved> {
        let report = self.ended.as_ref().ok()?;
        let model = resolve(&Deck::read(&self.deck).ok()?, &standard()).ok()?;
        let mut terms = Terms::new(&model).ok()?;
        let mut rest = terms.rest();
        for step in &model.steps {
            terms.enter(step, &mut rest);
        }
        let pairs = terms.states(&report.last);
        Some(Solved { terms, pairs, u: report.last.u.clone(), forces: report.last.residual.clone() })
    }
}

/// A scene with its solution.
pub struct Solved {
    /// Terms, with the mesh.
    pub terms: Terms,
    /// State of each pair.
    pub pairs: Vec<ContactState>,
    /// Displacements [L] by freedom.
    pub u: Vec<f64>,
    /// Internal minus applied forces [F] by freedom: reactions where it is prescribed.
    pub forces: Vec<f64>,
}

impl Solved {
    /// Contact pressures of all pairs, point by point.
    pub fn pressures(&self) -> Vec<f64> {
        self.pairs.iter().flat_map(|pair| pair.points.iter().map(|point| point.pressure)).collect()
    }

    /// Penalty stiffness [F/L³] of a pair that has one.
    pub fn stiffness(&self, pair: usize) -> f64 {
        self.terms.contacts[pair].summary().penalty.map_or(f64::INFINITY, |penalty| penalty.stiffness)
    }

    /// Displacement of a node by its label [L], three components; none of an unknown node.
    pub fn displacement(&self, label: u64) -> Option<[f64; 3]> {
        self.vector(label, &self.u)
    }

    /// Displacements [L] by ascending node label, three components each.
    pub fn displacements(&self) -> Vec<[f64; 3]> {
        let mut labels = self.terms.structure.mesh.point_labels.clone();
        labels.sort_unstable();
        labels.into_iter().filter_map(|label| self.displacement(label)).collect()
    }

    /// Contact forces [F] of all secondary nodes with their labels, added up over the pairs, by ascending label.
    pub fn contact_forces(&self) -> Vec<(u64, [f64; 3])> {
        let mut sums = std::collections::BTreeMap::new();
        for (node, force) in self.pairs.iter().flat_map(|pair| &pair.secondary.nodes) {
            let label = self.terms.structure.mesh.point_labels[*node as usize];
            let sum: &mut [f64; 3] = sums.entry(label).or_default();
            (0..3).for_each(|c| sum[c] += force[c]);
        }
        sums.into_iter().collect()
    }

    fn vector(&self, label: u64, of: &[f64]) -> Option<[f64; 3]> {
        let node = self.terms.structure.mesh.point_labels.iter().position(|&l| l == label)?;
        Some(std::array::from_fn(|c| self.terms.freedoms.index(node, c).map_or(0.0, |f| of[f])))
    }
}
