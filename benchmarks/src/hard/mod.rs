//! Hard cases: scenes at the edge of what a contact program meets, each with what must happen. A case is one row of
//! [`CASES`]; its scenes are decks run through the same entry as `fe`, and closures that judge what came out.

mod ball;
mod cases;
pub(crate) mod deck;
mod finding;
pub(crate) mod patch;
pub(crate) mod run;

pub use cases::CASES;
pub use finding::{Finding, Verdict};
pub use run::{Place, Run, Solved};

use std::io::{self, Write};
use std::path::Path;

/// One case.
pub struct Case {
    /// Identifier, `D07`.
    pub id: &'static str,
    /// Short name.
    pub name: &'static str,
    /// Its scenes, in the order in which they are printed.
    pub scenes: fn() -> Vec<Scene>,
}

/// One scene of a case.
pub struct Scene {
    /// What it is, in a few words.
    pub name: String,
    /// True for scenes that are for a release build.
    pub slow: bool,
    judged: Judged,
}

type Judge = Box<dyn Fn(&Place) -> Finding>;

enum Judged {
    /// Cannot be built yet: what it needs.
    Waits(&'static str),
    By(Judge),
}

impl Scene {
    /// A scene that is run and judged.
    pub fn new(name: impl Into<String>, judge: impl Fn(&Place) -> Finding + 'static) -> Self {
        Scene { name: name.into(), slow: false, judged: Judged::By(Box::new(judge)) }
    }

    /// A scene that waits for something the program does not have.
    pub fn waits(name: impl Into<String>, needs: &'static str) -> Self {
        Scene { name: name.into(), slow: false, judged: Judged::Waits(needs) }
    }

    /// For a release build only.
    pub fn slow(mut self) -> Self {
        self.slow = true;
        self
    }

    /// Runs it and judges.
    pub fn finding(&self, place: &Place) -> Finding {
        match &self.judged {
            Judged::Waits(needs) => Finding::waits(needs),
            Judged::By(judge) => judge(place),
        }
    }
}

/// The cases with these identifiers or full names (`D07_initial_overclosure`); all where none is named.
pub fn chosen(names: &[String]) -> Result<Vec<&'static Case>, String> {
    let is = |case: &Case, name: &str| {
        name.eq_ignore_ascii_case(case.id) || name.eq_ignore_ascii_case(&format!("{}_{}", case.id, case.name))
    };
    if let Some(unknown) = names.iter().find(|name| !CASES.iter().any(|case| is(case, name))) {
        let known: Vec<&str> = CASES.iter().map(|case| case.id).collect();
        return Err(format!("there is no case `{unknown}`; there are {}", known.join(", ")));
    }
    Ok(CASES.iter().filter(|case| names.is_empty() || names.iter().any(|name| is(case, name))).collect())
}

/// The folder of one scene below `folder`; scenes keep apart, so that their decks can be looked at afterwards.
pub fn place_of(folder: &Path, case: &Case, scene: usize) -> Place {
    Place::new(folder.join(format!("{}_{:02}", case.id, scene + 1)))
}

/// Runs cases below a folder and prints a line for each scene; the number of scenes that failed.
pub fn run(cases: &[&Case], folder: &Path, out: &mut dyn Write) -> io::Result<usize> {
    writeln!(out, "{}", finding::HEAD)?;
    let mut failed = 0;
    for case in cases {
        for (number, scene) in (case.scenes)().iter().enumerate() {
            let finding = scene.finding(&place_of(folder, case, number));
            failed += usize::from(finding.verdict() == Verdict::Failed);
            writeln!(out, "{}", finding.line(&format!("{}_{}", case.id, case.name), &scene.name))?;
            out.flush()?;
        }
    }
    Ok(failed)
}
