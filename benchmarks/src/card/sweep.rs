//! The penalty of Hertz's line contact over twelve decades around the default.

use crate::hard::run::run as run_deck;
use crate::problem::{Answer, Curve, MeshFile, Problem};
use crate::problems::hertz_line::HertzLine;
use fe_core::element::ElementType;
use std::io::{self, Write};
use std::path::Path;

/// Elements along half the contact width.
const N: usize = 16;

/// Runs every decade, and multipliers beside them.
pub(super) fn run(folder: &Path, out: &mut dyn Write) -> io::Result<()> {
    let curve = Curve { element: ElementType::CPE4, variant: "surface to surface", sizes: vec![N] };
    let scene = HertzLine.scene(&curve, N);
    writeln!(out, "penalty: {}, {} unknowns", HertzLine.about(), scene.unknowns)?;
    write!(out, "{:<24}", "  penalty [F/L³]")?;
    HertzLine.norms().iter().try_for_each(|norm| write!(out, "{:>17}", norm.name))?;
    writeln!(out, "{:>12}{:>6}{:>5}  remarks", "overclosure", "iter", "cut")?;
    let given = |exponent: i32| (format!("PENALTY\n,, 1e{exponent}"), format!("default × 1e{exponent}"));
    let mut all: Vec<(String, String)> = (-6..=6).map(given).collect();
    all.push(("DIRECT".into(), "multipliers".into()));
    for (number, (behavior, name)) in all.iter().enumerate() {
        let place = folder.join(format!("penalty_{number:02}"));
        let cards = scene.cards.replace("*SURFACE BEHAVIOR, PENALTY\n", &format!("*SURFACE BEHAVIOR, {behavior}\n"));
        let swept = crate::problem::Scene {
            name: scene.name.clone(),
            mesh: scene.mesh.clone(),
            elements: scene.elements.clone(),
            cards,
            unknowns: scene.unknowns,
        };
        let deck = swept.write(&place, MeshFile::Gmsh)?;
        let run = run_deck(&deck);
        write!(out, "  {name:<22}")?;
        let errors = Answer::read(&deck.with_extension("dat")).and_then(|answer| HertzLine.errors(&swept, &answer));
        match (run.solved(), errors) {
            (Some(solved), Ok(errors)) => {
                errors.iter().try_for_each(|error| write!(out, "{error:>17.2e}"))?;
                let largest = solved.pairs[0].largest_overclosure.map_or(0.0, |l| l.1);
                let warned = if run.told(&["warning", "not hard"]) { "warned: too soft to be hard" } else { "" };
                writeln!(out, "{largest:>12.2e}{:>6}{:>5}  {warned}", run.iterations, run.cutbacks)?;
            }
            (_, Err(why)) => writeln!(out, "{why}")?,
            (None, _) => writeln!(out, "{}", run.ended.as_ref().err().map_or("", |why| why.as_str()))?,
        }
    }
    Ok(())
}
