//! `fe check`: reads a deck as a run would, and tells what each step needs.

use crate::approach::free_bodies;
use crate::course::Course;
use crate::explicit;
use crate::fields::needs_recovery;
use crate::job::{JobFailure, enter, scene};
use crate::plan::{Matrix, Plan};
use crate::printed;
use crate::recorder::chosen_fields;
use crate::terms::Terms;
use fe_core::linear::LinearSolver;
use fe_core::linear::multifrontal::Multifrontal;
use fe_io::{Deck, Library, Model, resolve};
use std::fmt::Write;
use std::path::Path;

/// The plan of every step, in words.
pub fn check(deck: &Path, library: &Library) -> Result<String, JobFailure> {
    let cards = Deck::read(deck).map_err(|faults| JobFailure::Deck(faults.to_string()))?;
    let model = resolve(&cards, library).map_err(|faults| JobFailure::Deck(faults.to_string()))?;
    if model.steps.iter().any(|step| explicit::explicit(step).is_some()) {
        return explicit::check(&model);
    }
    let mut terms = Terms::new(&model).map_err(JobFailure::Deck)?;
    let mesh = &terms.structure.mesh;
    let mut text = String::new();
    let (nodes, cells, bodies) = (mesh.points.len(), mesh.cell_count(), terms.bodies.len());
    // Writing to a string does not fail.
    let _ = writeln!(text, "{nodes} nodes, {cells} elements, {bodies} bodies");
    model.notes.iter().chain(&terms.notes).for_each(|note| {
        let _ = writeln!(text, "{}", crate::console::remark(note));
    });
    let _ = writeln!(text, "{}", results_in_words(&model, &terms));
    let mut rest = terms.rest();
    let mut course = Course::new(&model);
    for (index, step) in model.steps.iter().enumerate() {
        enter(&model, &mut terms, index, &mut course, &mut rest);
        let scene = scene(&terms, step, &course)?;
        let (free, fixed) = (scene.free(), course.fixed(rest.u.len()));
        let matrix = free.contains(&true).then(|| {
            let (mut solver, pattern) = (Multifrontal::default(), scene.pattern());
            solver.analyse(&pattern, &free, &scene.changing());
            Matrix::of(&pattern, solver.cost())
        });
        let bodies = free_bodies(&terms.structure, &terms.freedoms, &terms.bodies, &fixed, &terms.contacts);
        let plan = Plan::of(&terms, step, (&rest.u, &fixed), matrix, &bodies);
        let _ = writeln!(text, "\nstep {}, time {}\n{plan}", index + 1, step.procedure.period());
    }
    Ok(text)
}

/// The words by which the fields of the results file are asked for.
fn results_in_words(model: &Model, terms: &Terms) -> String {
    let fields = chosen_fields(model, terms);
    let mut words: Vec<&str> = Vec::new();
    for field in &fields {
        // Fields at points and at cells share a word.
        if !words.contains(&field.request) {
            words.push(field.request);
        }
    }
    let mut tables = model.steps.iter().flat_map(|step| &step.output.tables);
    let recovers = fields.iter().any(needs_recovery) || tables.any(printed::needs_recovery);
    let without = if recovers { "" } else { "; stresses and strains are not computed" };
    format!("results {}{without}", words.join(", "))
}
