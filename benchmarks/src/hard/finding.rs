//! What is found in a scene: how it ended, its effort, its error against its bound, and what is wrong with it.

use super::run::{Run, Solved};

/// Head of the table.
pub const HEAD: &str = "case                       scene                                            outcome                                                      incr  cut  iter     error     bound";

/// The end of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// As it must be.
    Good,
    /// Not as it must be.
    Failed,
    /// Not there yet.
    Waits,
}

/// What is found in a scene.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    outcome: String,
    waits: bool,
    /// Increments, cutbacks, iterations.
    effort: Option<[usize; 3]>,
    /// Error and bound; of several the worst in proportion.
    error: Option<(f64, f64)>,
    faults: Vec<String>,
}

impl Finding {
    /// A scene that waits.
    pub fn waits(needs: &str) -> Self {
        Finding { outcome: format!("waits: needs {needs}"), waits: true, ..Finding::default() }
    }

    /// A run that must come to its end.
    pub fn converged(run: &Run) -> Self {
        let effort = Some([run.certificates.len(), run.cutbacks, run.iterations]);
        match &run.ended {
            Ok(_) => Finding { outcome: "converged".into(), effort, ..Finding::default() },
            Err(why) => {
                let faults = vec![format!("it must converge: {why}")];
                Finding { outcome: short(why), effort, faults, ..Finding::default() }
            }
        }
    }

    /// A run that must be refused, with these words in the message and without an increment.
    pub fn refused(run: &Run, words: &[&str]) -> Self {
        let effort = Some([run.certificates.len(), run.cutbacks, run.iterations]);
        let mut found = Finding { effort, ..Finding::default() };
        match &run.ended {
            Ok(_) => {
                found.outcome = "converged".into();
                found.faults.push("it must be refused".into());
            }
            Err(why) => {
                found.outcome = format!("refused: {}", short(why));
                found = found.holds(!run.panicked, "a panic is no refusal");
                found = found.holds(run.certificates.is_empty(), "it must be refused before the first increment");
                for word in words {
                    found = found.holds(why.contains(word), format!("the message does not say `{word}`: {why}"));
                }
            }
        }
        found
    }

    /// A run that must end after some increments, with these words in the message.
    pub fn stopped(run: &Run, words: &[&str]) -> Self {
        let went_on = run.ended.is_ok() || !run.certificates.is_empty();
        Finding::halted(run, words).holds(went_on, "it must go on until then")
    }

    /// A run that must end before its time, with these words in the message.
    pub fn halted(run: &Run, words: &[&str]) -> Self {
        let effort = Some([run.certificates.len(), run.cutbacks, run.iterations]);
        let mut found = Finding { effort, ..Finding::default() };
        match &run.ended {
            Ok(_) => {
                found.outcome = "converged".into();
                found.holds(false, "it must end before its time")
            }
            Err(why) => {
                found.outcome = format!("ended: {}", short(why));
                found = found.holds(!run.panicked, "a panic is no end");
                let missing = |word: &&&str| !why.contains(**word);
                let said = words.iter().filter(missing).copied().collect::<Vec<_>>();
                found.holds(said.is_empty(), format!("the message does not say {said:?}: {why}"))
            }
        }
    }

    /// A run that comes to its end with a remark that holds these words.
    pub fn warned(run: &Run, words: &[&str]) -> Self {
        let mut found = Finding::converged(run);
        let note = run.notes.iter().find(|note| words.iter().all(|word| note.contains(word)));
        if run.ended.is_ok() && note.is_some() {
            found.outcome = "converged, warned".into();
        }
        found.holds(note.is_some(), format!("no remark says {words:?}: {:#?}", run.notes))
    }

    /// Something that must be true, in words for where it is not.
    pub fn holds(mut self, condition: bool, fault: impl Into<String>) -> Self {
        if !condition {
            self.faults.push(fault.into());
        }
        self
    }

    /// An error with its bound; one that is not a number fails.
    pub fn within(mut self, error: f64, bound: f64) -> Self {
        let ratio = |(error, bound): (f64, f64)| if error.is_nan() { f64::INFINITY } else { error / bound };
        if self.error.is_none_or(|before| ratio((error, bound)) > ratio(before)) {
            self.error = Some((error, bound));
        }
        self.holds(error <= bound, format!("error {error:.3e} above its bound {bound:.1e}"))
    }

    /// Errors of a solved scene; a scene that is not solved has none (and its end is a fault already).
    pub fn measured(self, run: &Run, errors: impl Fn(&Solved) -> Vec<(f64, f64)>) -> Self {
        match run.solved() {
            Some(solved) => errors(&solved).into_iter().fold(self, |found, (error, bound)| found.within(error, bound)),
            None => self.holds(run.ended.is_err(), "its results cannot be read"),
        }
    }

    /// Adds words to the outcome.
    pub fn say(mut self, words: impl AsRef<str>) -> Self {
        self.outcome.push_str(", ");
        self.outcome.push_str(words.as_ref());
        self
    }

    /// The worse of two findings of one scene; their faults together.
    pub fn and(mut self, other: Finding) -> Self {
        if self.faults.is_empty() && !other.faults.is_empty() {
            self.outcome = other.outcome;
        }
        self.faults.extend(other.faults);
        match other.error {
            Some((error, bound)) => self.within_quietly(error, bound),
            None => self,
        }
    }

    /// As [`Finding::within`] where a fault was told already.
    fn within_quietly(self, error: f64, bound: f64) -> Self {
        let faults = self.faults.clone();
        Finding { faults, ..self.within(error, bound) }
    }

    /// The verdict.
    pub fn verdict(&self) -> Verdict {
        match (self.faults.is_empty(), self.waits) {
            (false, _) => Verdict::Failed,
            (true, true) => Verdict::Waits,
            (true, false) => Verdict::Good,
        }
    }

    /// What is wrong.
    pub fn faults(&self) -> &[String] {
        &self.faults
    }

    /// The line of the table, with the faults below.
    pub fn line(&self, case: &str, scene: &str) -> String {
        let effort = self.effort.map_or(" ".repeat(15), |[i, c, n]| format!("{i:5} {c:4} {n:5}"));
        let error = self.error.map_or(" ".repeat(19), |(error, bound)| format!("{error:9.1e} {bound:9.1e}"));
        let verdict = match self.verdict() {
            Verdict::Good => "ok",
            Verdict::Failed => "FAILED",
            Verdict::Waits => "waits",
        };
        let outcome = cut(&self.outcome, if self.waits { 95 } else { 60 });
        let mut line = if self.waits {
            format!("{case:26} {:48} {outcome:<97}{verdict}", cut(scene, 48))
        } else {
            format!("{case:26} {:48} {outcome:<60} {effort} {error}  {verdict}", cut(scene, 48))
        };
        for fault in &self.faults {
            line.push_str("\n    ");
            line.push_str(&fault.replace('\n', "\n    "));
        }
        line
    }
}

/// The first fault of a message, without its place.
fn short(text: &str) -> String {
    let line = text.lines().find(|line| line.starts_with("error: ")).or(text.lines().next()).unwrap_or_default();
    let line = line.trim_start_matches("error: ");
    let placed = line.split_once(".inp:").and_then(|(_, rest)| rest.split_once(": "));
    placed.map_or(line, |(_, said)| said).to_owned()
}

fn cut(text: &str, length: usize) -> String {
    if text.chars().count() <= length { text.into() } else { text.chars().take(length - 1).chain(['…']).collect() }
}

/// Largest difference of two lists of numbers, over the largest number of the first; infinite where their lengths differ.
pub fn difference(reference: &[f64], found: &[f64]) -> f64 {
    if reference.len() != found.len() || reference.is_empty() {
        return f64::INFINITY;
    }
    let size = reference.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let worst = reference.iter().zip(found).map(|(a, b)| (a - b).abs());
    // `max` passes over NaN; here it must be seen.
    worst.fold(0.0, |m: f64, d| if d.is_nan() || m.is_nan() { f64::NAN } else { m.max(d) }) / size
}

/// Largest relative difference of numbers from one expected value, not 0.
pub fn from_value(expected: f64, found: &[f64]) -> f64 {
    difference(&vec![expected; found.len()], found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A finding fails by an error above its bound, by one that is not a number, and by what does not hold; it keeps
    /// the worst error in proportion.
    #[test]
    fn what_fails() {
        assert_eq!(Finding::default().within(1e-12, 1e-10).verdict(), Verdict::Good);
        assert_eq!(Finding::default().within(0.0, 0.0).verdict(), Verdict::Good);
        assert_eq!(Finding::waits("something").verdict(), Verdict::Waits);
        for failed in [
            Finding::default().within(1e-9, 1e-10),
            Finding::default().within(f64::NAN, 1e-10).within(0.0, 1.0),
            Finding::default().within(0.0, 1.0).and(Finding::default().within(f64::NAN, 1e-10)),
            Finding::default().holds(false, "it does not hold"),
        ] {
            assert_eq!(failed.verdict(), Verdict::Failed, "{failed:?}");
        }
        let worst = Finding::default().within(1e-3, 1.0).within(1e-11, 1e-10).within(1e-2, 1.0);
        assert_eq!(worst.error, Some((1e-11, 1e-10)));
    }

    #[test]
    fn differences_see_what_is_not_a_number_and_what_is_missing() {
        assert_eq!(difference(&[1.0, -2.0], &[1.0, -2.5]), 0.25);
        assert!(difference(&[1.0, f64::NAN, 2.0], &[1.0, 0.0, 2.0]).is_nan());
        assert_eq!(difference(&[1.0], &[1.0, 1.0]), f64::INFINITY);
        assert_eq!(from_value(10.0, &[]), f64::INFINITY);
    }

    #[test]
    fn a_message_is_cut_to_its_fault() {
        let message = "warning: first\n --> a.inp:1:1\n\nerror: node 7 is there twice\n --> a.inp:9:1";
        assert_eq!(short(message), "node 7 is there twice");
        assert_eq!(short("folder/a.inp:110: node 18 lies deep\nhelp: move it"), "node 18 lies deep");
    }
}
