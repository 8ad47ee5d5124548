//! The laws and enforcements of `*SURFACE BEHAVIOR` side by side on problems with closed answers, and a penalty swept over
//! twelve decades.

mod blocks;
mod nodes;
mod sweep;

use crate::hard::run::{Place, Run, Solved};
use fe_contact::law::formula::Formula;
use fe_contact::law::{Laws, NormalLaw};
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

/// A law by its card, and what it answers.
struct Behavior {
    /// Name in the table.
    name: &'static str,
    /// The card with its data lines.
    card: String,
    /// What enforces it.
    by: Enforced,
}

/// What the closed answer takes as the law.
enum Enforced {
    /// No overclosure.
    Hard,
    /// The penalty that the program tells.
    Penalty,
    /// The law that the program tells.
    Told,
    /// The softened law itself.
    Law(Arc<dyn NormalLaw>),
}

/// A problem of one dimension: a spring pushed by so much against the law.
trait Push {
    /// Its name.
    fn name(&self) -> &'static str;
    /// What it is.
    fn about(&self) -> &'static str;
    /// The deck of a behaviour.
    fn deck(&self, card: &str) -> String;
    /// How far it is pushed beyond first touch [L].
    const DEPTH: f64;
    /// Force [F] of the bodies per length that they are compressed by.
    fn spring(&self) -> f64;
    /// What stands for the surface: force over the law's number.
    fn measure(&self) -> f64;
    /// Force [F] that the program found.
    fn force(&self, solved: &Solved) -> f64;
}

/// The law through the numbers of a data line.
fn law(keyword: &str, data: &[f64]) -> Arc<dyn NormalLaw> {
    let definition = Laws::standard().find(keyword).map(|definition| (definition.build)(data));
    definition.expect("the table names laws of the program").expect("its numbers are right")
}

/// The behaviours, for a problem whose bodies answer a pressure of order `p` and have a stiffness `k` per measure.
fn behaviors(p: f64, k: f64) -> Vec<Behavior> {
    let hard = |name, enforcement: &str, by| Behavior { name, card: format!("*SURFACE BEHAVIOR, {enforcement}\n"), by };
    let softened = |name, keyword: &str, rows: &[&[f64]]| {
        let lines = rows.iter().map(|row| row.iter().map(|v| format!("{v:e}")).collect::<Vec<_>>().join(", ") + "\n");
        let numbers: Vec<f64> = rows.concat();
        Behavior {
            name,
            card: format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={keyword}\n{}", lines.collect::<String>()),
            by: Enforced::Law(law(keyword, &padded(keyword, numbers))),
        }
    };
    let length = p / k;
    vec![
        hard("HARD, multipliers", "DIRECT", Enforced::Hard),
        hard("HARD, augmented Lagrange", "AUGMENTED LAGRANGE", Enforced::Hard),
        hard("HARD, penalty", "PENALTY", Enforced::Penalty),
        hard("HARD, nonlinear penalty", "PENALTY=NONLINEAR", Enforced::Told),
        softened("LINEAR", "LINEAR", &[&[k]]),
        softened("LINEAR, a million times as steep", "LINEAR", &[&[1e6 * k]]),
        softened("EXPONENTIAL", "EXPONENTIAL", &[&[length, 0.1 * p]]),
        softened("EXPONENTIAL, a million times as steep", "EXPONENTIAL", &[&[1e-6 * length, 0.1 * p]]),
        softened(
            "TABULAR, kinks and a plateau",
            "TABULAR",
            &[&[0.0, -0.5 * length], &[0.2 * p, 0.0], &[0.2 * p, 0.3 * length], &[1.5 * p, 0.6 * length]],
        ),
        softened("TABULAR, a million times as steep", "TABULAR", &[&[0.0, 0.0], &[p, 1e-6 * length]]),
        formula("FORMULA, p = K h^1.5", k / length.sqrt()),
        formula("FORMULA, a million times as steep", 1e6 * k / length.sqrt()),
    ]
}

/// The law p = K h^1.5 written out.
fn formula(name: &'static str, factor: f64) -> Behavior {
    let lines = ["p = K * h^1.5".to_owned(), format!("K = {factor:e}")];
    let card = format!("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=FORMULA\n{}\n", lines.join("\n"));
    let law = Formula::new(&lines.each_ref().map(String::as_str), 1.0).expect("the formula is right").0;
    Behavior { name, card, by: Enforced::Law(Arc::new(law)) }
}

/// Numbers of a data line with those that may be left blank.
fn padded(keyword: &str, mut numbers: Vec<f64>) -> Vec<f64> {
    if let Some(definition) = Laws::standard().find(keyword) {
        let defaults = definition.data.iter().map(|datum| datum.default.map_or(f64::NAN, |d| d.0));
        numbers.extend(defaults.skip(numbers.len()));
    }
    numbers
}

/// The force F of a spring that is pushed by `depth` against a law, depth = F / spring + h(F / measure), by bisection.
fn balance((depth, spring): (f64, f64), measure: f64, law: &dyn NormalLaw) -> f64 {
    // As the overclosure grows the law's force rises and the bodies' force falls.
    let (mut low, mut high) = (-law.reach(), depth);
    for _ in 0..200 {
        let h = 0.5 * (low + high);
        *(if measure * law.respond(-h).pressure < spring * (depth - h) { &mut low } else { &mut high }) = h;
    }
    spring * (depth - 0.5 * (low + high))
}

/// Runs every behaviour on both problems and prints the table.
pub fn laws(folder: &Path, out: &mut dyn Write) -> io::Result<()> {
    table(&blocks::Blocks, folder, out)?;
    table(&nodes::Nodes, folder, out)
}

/// Sweeps the penalty of the line contact and prints the table.
pub fn sweep(folder: &Path, out: &mut dyn Write) -> io::Result<()> {
    sweep::run(folder, out)
}

/// A behaviour on a problem.
struct Row {
    name: &'static str,
    /// What was measured, or why there is no answer.
    measured: Result<Measured, String>,
}

struct Measured {
    /// Force [F].
    force: f64,
    /// The closed answer [F].
    expected: f64,
    /// Largest overclosure [L].
    overclosure: f64,
    iterations: usize,
    seconds: f64,
}

fn table<P: Push>(problem: &P, folder: &Path, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "{}: {}", problem.name(), problem.about())?;
    let head = ["force", "error", "overclosure"].map(|word| format!("{word:>14}")).concat();
    writeln!(out, "{:<40}{head}{:>6}{:>10}", "  law, enforcement", "iter", "seconds")?;
    for Row { name, measured } in rows(problem, folder) {
        match measured {
            Ok(Measured { force, expected, overclosure, iterations, seconds }) => {
                let error = force / expected - 1.0;
                let numbers = format!("{force:>14.6e}{error:>14.1e}{overclosure:>14.3e}");
                writeln!(out, "  {name:<38}{numbers}{iterations:>6}{seconds:>10.4}")?;
            }
            Err(why) => writeln!(out, "  {name:<38}{why}")?,
        }
    }
    writeln!(out)
}

fn rows<P: Push>(problem: &P, folder: &Path) -> Vec<Row> {
    let (spring, measure) = (problem.spring(), problem.measure());
    let behaviors = behaviors(spring * P::DEPTH / measure, spring / measure);
    let row = |(number, behavior): (usize, Behavior)| {
        let place = Place::new(folder.join(format!("{}_{number:02}", problem.name())));
        let run = place.run("push", &problem.deck(&behavior.card));
        let measured = match run.solved() {
            Some(solved) => Ok(measured(problem, &behavior, &run, &solved)),
            None => Err(run.ended.err().unwrap_or_default()),
        };
        Row { name: behavior.name, measured }
    };
    behaviors.into_iter().enumerate().map(row).collect()
}

fn measured<P: Push>(problem: &P, behavior: &Behavior, run: &Run, solved: &Solved) -> Measured {
    let (spring, measure) = (problem.spring(), problem.measure());
    let expected = match &behavior.by {
        Enforced::Hard => spring * P::DEPTH,
        Enforced::Penalty => {
            let stiffness = measure * solved.stiffness(0);
            P::DEPTH * spring * stiffness / (spring + stiffness)
        }
        Enforced::Told => balance((P::DEPTH, spring), measure, solved.terms.contacts[0].law()),
        Enforced::Law(law) => balance((P::DEPTH, spring), measure, &**law),
    };
    let largest = solved.pairs.iter().filter_map(|pair| pair.largest_overclosure);
    let overclosure = largest.map(|l| l.1).fold(0.0, f64::max);
    let force = problem.force(solved);
    Measured { force, expected, overclosure, iterations: run.iterations, seconds: run.seconds }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every law under every enforcement that may carry it against the closed answer: 1e-10, a discrete problem that has it;
    /// augmented Lagrange within its allowed overclosure, a thousandth of a facet.
    #[test]
    fn closed_answers_hold() {
        let folder = std::env::temp_dir().join(format!("signorini_laws_{}", std::process::id()));
        let all = [
            (rows(&blocks::Blocks, &folder), 1e-3 * (2.0 / 3.0) / blocks::Blocks::DEPTH),
            (rows(&nodes::Nodes, &folder), 1e-3 / nodes::Nodes::DEPTH),
        ];
        std::fs::remove_dir_all(&folder).unwrap();
        for (rows, allowed) in all {
            for Row { name, measured } in rows {
                let measured = measured.unwrap();
                let bound = if name.contains("augmented") { allowed } else { 1e-10 };
                let error = (measured.force / measured.expected - 1.0).abs();
                assert!(error <= bound, "{name}: {error:e}");
            }
        }
    }
}
