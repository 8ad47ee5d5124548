//! Mass scaling of explicit steps: factors on the masses of elements.

use super::record::Turn;
use super::scene::Scene;
use fe_core::explicit::mass_scaling::{factor, raised};
use fe_core::step::{MassScaling, ScaledAt, ScaledTo};
use fe_io::model::{Frames, Step};
use fe_mesh::CellId;

/// Factors on the masses of all cells, blocks in order; none where nothing is scaled.
#[derive(Debug, Default)]
pub struct Factors {
    /// Those of the start of the step.
    fixed: Vec<f64>,
    /// Those in force.
    now: Vec<f64>,
}

impl Factors {
    /// How many masses are scaled, and the largest factor.
    pub fn raised(&self) -> (usize, f64) {
        let scaled = self.now.iter().filter(|f| **f != 1.0);
        (scaled.clone().count(), scaled.copied().fold(0.0, f64::max))
    }
}

/// True where a step asks for increments of elements.
pub fn aims(step: &Step) -> bool {
    step.mass_scaling.iter().any(|scaling| scaling.target.is_some())
}

/// True when masses are scaled anew at the end of an increment.
pub fn is_due(step: &Step, turn: &Turn) -> bool {
    step.mass_scaling.iter().any(|scaling| match scaling.when {
        ScaledAt::Start => false,
        ScaledAt::Increments(every) => turn.is_due(&Frames::Increments(every)),
        ScaledAt::Parts(parts) => turn.is_due(&Frames::Parts(parts)),
    })
}

/// Scales the masses at the start of a step; the stable increment [T] of elements whose increments are asked for, `None` where
/// nothing changes.
pub fn begin(scene: &mut Scene, step: &Step, viscosity: f64) -> Option<f64> {
    if step.mass_scaling.is_empty() && scene.factors.now.is_empty() {
        return None;
    }
    let ones = vec![1.0; scene.structure.mesh.cell_count()];
    let fixed = step.mass_scaling.iter().filter(|scaling| scaling.when == ScaledAt::Start);
    scene.factors.fixed = factors(scene, fixed, ones, viscosity);
    Some(again(scene, step, viscosity))
}

/// Scales what is scaled during a step; the stable increment [T] of elements whose increments are asked for.
pub fn again(scene: &mut Scene, step: &Step, viscosity: f64) -> f64 {
    let variable = step.mass_scaling.iter().filter(|scaling| scaling.when != ScaledAt::Start);
    let now = factors(scene, variable, scene.factors.fixed.clone(), viscosity);
    let first = scene.structure.mesh.first_cells();
    let of = |cell: CellId| now[first[cell.block as usize] + cell.cell as usize];
    scene.solids.iter_mut().for_each(|solids| solids.scale(&of));
    scene.lines.iter_mut().for_each(|lines| lines.scale(&of));
    let stable = scene.increments().map(|(cell, own)| raised(own, of(cell), viscosity)).fold(f64::INFINITY, f64::min);
    scene.factors.now = now;
    stable
}

/// Factors with more cards: those of the cards, then what their increments need.
fn factors<'a>(
    scene: &Scene,
    cards: impl Iterator<Item = &'a MassScaling>,
    mut factors: Vec<f64>,
    viscosity: f64,
) -> Vec<f64> {
    let first = scene.structure.mesh.first_cells();
    let place = |cell: CellId| first[cell.block as usize] + cell.cell as usize;
    let mut own = vec![f64::INFINITY; factors.len()];
    scene.increments().for_each(|(cell, increment)| own[place(cell)] = increment);
    for card in cards {
        card.cells.iter().for_each(|&cell| factors[place(cell)] *= card.factor);
        let Some((target, to)) = card.target else { continue };
        let scaled: Vec<usize> = card.cells.iter().map(|&c| place(c)).filter(|&i| own[i].is_finite()).collect();
        let needed = |i: usize| factor(own[i], target, viscosity);
        let most = scaled.iter().map(|&i| needed(i) / factors[i]).fold(0.0, f64::max);
        for i in scaled {
            factors[i] = match to {
                ScaledTo::BelowMinimum => factors[i].max(needed(i)),
                ScaledTo::Uniform => factors[i] * most,
                ScaledTo::EqualIncrement => needed(i),
            };
        }
    }
    factors
}
