//! The assembled system of one step: which terms act, what is prescribed, and one evaluation of it all.

use crate::external::ExternalForces;
use crate::freedoms::Freedoms;
use crate::matrix::{BlockMatrix, Couplings, Pattern};
use crate::ramp::Ramp;
use crate::reject::Reject;
use crate::term::{Assembly, Lacking, Motion, Term};
use std::ops::Range;
use std::sync::Arc;

/// What acts in one step.
pub struct Scene<'a> {
    /// Freedoms of all nodes.
    pub freedoms: &'a Freedoms,
    /// Terms of the virtual work.
    pub terms: Vec<&'a dyn Term>,
    /// Loads.
    pub external: ExternalForces,
    /// Prescribed freedoms, ascending, each with its course.
    pub prescribed: Vec<(usize, Ramp)>,
    /// Step time [T].
    pub period: f64,
}

impl Scene<'_> {
    /// True for each freedom that is not prescribed.
    pub fn free(&self) -> Vec<bool> {
        let mut free = vec![true; self.freedoms.len()];
        self.prescribed.iter().for_each(|(f, _)| free[*f] = false);
        free
    }

    /// The pattern of the stiffness.
    pub fn pattern(&self) -> Arc<Pattern> {
        let mut couplings = Couplings::new(self.freedoms.nodes());
        self.terms.iter().for_each(|term| term.couplings(&mut couplings));
        Arc::new(Pattern::new(self.freedoms, &couplings))
    }

    /// True for each node that a term couples which is not linear: the blocks between these change.
    pub fn changing(&self) -> Vec<bool> {
        let mut couplings = Couplings::new(self.freedoms.nodes());
        self.terms.iter().filter(|term| !term.is_linear()).for_each(|term| term.couplings(&mut couplings));
        couplings.touched()
    }
}

/// One evaluation of a scene.
pub struct Evaluation {
    /// Internal minus external force [F].
    pub residual: Vec<f64>,
    /// Of it, what the terms that are not linear give.
    pub nonlinear: Vec<f64>,
    /// Tangent; `None` where the linear part is all of it.
    pub tangent: Option<BlockMatrix>,
    /// Energy of the linear terms [F L].
    pub linear_energy: f64,
    /// Energy of the others [F L].
    pub nonlinear_energy: f64,
    /// Contact points that changed status since the last evaluation.
    pub status_changes: usize,
}

/// A scene with the stiffness of its linear terms, assembled once a step.
pub struct System<'a> {
    /// The scene.
    pub scene: Scene<'a>,
    /// Stiffness of the linear terms; `None` where no freedom is free.
    pub linear: Option<BlockMatrix>,
    /// True for each node between which other terms add stiffness, `[nodes]`; see [`Scene::changing`].
    pub changing: Vec<bool>,
    /// Where the values between two of these stand: what a tangent may differ in.
    changing_values: Vec<Range<usize>>,
}

impl<'a> System<'a> {
    /// Assembles the linear part. A scene without free freedoms gets no matrix at all.
    pub fn new(scene: Scene<'a>) -> Result<Self, Reject> {
        let any_free = scene.prescribed.len() < scene.freedoms.len();
        let mut linear = any_free.then(|| BlockMatrix::zero(scene.pattern()));
        if let Some(matrix) = &mut linear {
            let rest = vec![0.0; scene.freedoms.len()];
            let mut force = vec![0.0; scene.freedoms.len()];
            for term in scene.terms.iter().filter(|t| t.is_linear()) {
                let at = Motion { u: &rest, du: &rest, step_time: 0.0, total_time: 0.0, dt: 0.0 };
                let mut out =
                    Assembly { residual: &mut force, stiffness: Some(matrix), energy: 0.0, status_changes: 0 };
                term.evaluate(at, &[], &mut [], &mut out)?;
            }
        }
        let changing = if any_free { scene.changing() } else { Vec::new() };
        let changing_values = linear.as_ref().map_or(Vec::new(), |matrix| values_between(&matrix.pattern, &changing));
        Ok(System { scene, linear, changing, changing_values })
    }

    /// True when two tangents of this scene are equal.
    pub fn same(&self, one: &BlockMatrix, other: &BlockMatrix) -> bool {
        self.changing_values.iter().all(|range| one.values[range.clone()] == other.values[range.clone()])
    }

    /// The linear part as a matrix of its own, in the memory of an earlier tangent where there is one.
    fn copy(&self, linear: &BlockMatrix, spare: Option<BlockMatrix>) -> BlockMatrix {
        let Some(mut matrix) = spare else { return linear.clone() };
        for range in &self.changing_values {
            matrix.values[range.clone()].copy_from_slice(&linear.values[range.clone()]);
        }
        matrix
    }

    /// True when every term is linear: the tangent is then [`System::linear`] itself.
    pub fn is_linear(&self) -> bool {
        self.scene.terms.iter().all(|t| t.is_linear())
    }

    /// Size of the forces [F] of the linear terms at displacements as large as `u`, with signs that leave no rigid motion:
    /// of the order of |K||u|, where there is no K.
    pub fn shaken(&self, u: &[f64]) -> Vec<f64> {
        let shaken: Vec<f64> = u.iter().enumerate().map(|(f, u)| u * sign(f)).collect();
        let mut force = vec![0.0; u.len()];
        for term in self.scene.terms.iter().filter(|t| t.is_linear()) {
            let at = Motion { u: &shaken, du: &shaken, step_time: 0.0, total_time: 0.0, dt: 0.0 };
            let mut out = Assembly { residual: &mut force, stiffness: None, energy: 0.0, status_changes: 0 };
            // A term that fails here has failed at the displacement itself.
            let _ = term.evaluate(at, &[], &mut [], &mut out);
        }
        force.iter().map(|f| f.abs()).collect()
    }

    /// Evaluates all terms. `history` holds for each term (old, new); `spare` is an earlier tangent, whose memory the
    /// new one takes.
    pub fn evaluate(
        &self,
        at: Motion,
        external: &[f64],
        history: (&[Vec<f64>], &mut [Vec<f64>]),
        spare: Option<BlockMatrix>,
    ) -> Result<Evaluation, Reject> {
        let n = self.scene.freedoms.len();
        let mut residual = vec![0.0; n];
        let mut nonlinear = vec![0.0; n];
        let mut tangent = match &self.linear {
            Some(linear) if !self.is_linear() => Some(self.copy(linear, spare)),
            _ => None,
        };
        let (mut linear_energy, mut nonlinear_energy, mut status_changes) = (0.0, 0.0, 0);
        if let Some(linear) = &self.linear {
            linear.multiply_add(at.u, &mut residual);
            linear_energy = 0.5 * dot(&residual, at.u);
        }
        for (k, term) in self.scene.terms.iter().enumerate() {
            if term.is_linear() && self.linear.is_some() {
                continue;
            }
            let force = if term.is_linear() { &mut residual } else { &mut nonlinear };
            let mut out = Assembly { residual: force, stiffness: tangent.as_mut(), energy: 0.0, status_changes: 0 };
            term.evaluate(at, &history.0[k], &mut history.1[k], &mut out)?;
            if term.is_linear() {
                linear_energy += out.energy;
            } else {
                nonlinear_energy += out.energy;
            }
            status_changes += out.status_changes;
        }
        for (r, (c, e)) in residual.iter_mut().zip(nonlinear.iter().zip(external)) {
            *r += c - e;
        }
        if !residual.iter().all(|r| r.is_finite()) {
            return Err(Reject::NotFinite { place: "the forces".into(), node: None });
        }
        Ok(Evaluation { residual, nonlinear, tangent, linear_energy, nonlinear_energy, status_changes })
    }

    /// What the tangent lacks at a motion with its history (old, new), term by term; nothing where it lacks nothing.
    pub fn lacking(&self, at: Motion, (old, new): (&[Vec<f64>], &[Vec<f64>])) -> Vec<Lacking<'_>> {
        let terms = self.scene.terms.iter().zip(old.iter().zip(new));
        terms.filter_map(|(term, (old, new))| term.lacking(at, (old, new))).collect()
    }

    /// Lets the terms stiffen a tangent that is singular; true when one did.
    pub fn stiffen(&self, u: &[f64], tangent: &mut BlockMatrix) -> bool {
        // Every term is asked, not only as far as the first that does.
        let mut stiffened = false;
        for term in &self.scene.terms {
            stiffened |= term.stiffen(u, tangent);
        }
        stiffened
    }
}

/// Signs without a pattern: the top bit of the index times the golden ratio.
fn sign(index: usize) -> f64 {
    if (index as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 63 == 0 { 1.0 } else { -1.0 }
}

/// Where the values of the blocks between two of these nodes stand, neighbours in one.
fn values_between(pattern: &Pattern, nodes: &[bool]) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for row in (0..pattern.nodes()).filter(|&row| nodes[row]) {
        let blocks = pattern.row_start[row]..pattern.row_start[row + 1];
        for block in blocks.filter(|&block| nodes[pattern.columns[block] as usize]) {
            let values = pattern.value_start[block]..pattern.value_start[block + 1];
            match ranges.last_mut() {
                Some(last) if last.end == values.start => last.end = values.end,
                _ => ranges.push(values),
            }
        }
    }
    ranges
}

/// Σ aᵢ bᵢ.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs of stiffness 1 between neighbours.
    struct Chain;

    /// A spring on one node whose stiffness is its displacement.
    struct Hardening(u32);

    impl Term for Chain {
        fn name(&self) -> &str {
            "chain"
        }

        fn couplings(&self, couplings: &mut Couplings) {
            couplings.add_all(&[0, 1, 1, 2], 2);
        }

        fn evaluate(&self, _: Motion, _: &[f64], _: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
            for (node, stiffness) in [(0, 1.0), (1, 2.0), (2, 1.0)] {
                out.stiffness.iter_mut().for_each(|k| k.add_block(node, node, &[stiffness]));
            }
            out.stiffness.iter_mut().for_each(|k| [1, 2].iter().for_each(|&n| k.add_block(n, n - 1, &[-1.0])));
            Ok(())
        }

        fn is_linear(&self) -> bool {
            true
        }
    }

    impl Term for Hardening {
        fn name(&self) -> &str {
            "hardening"
        }

        fn couplings(&self, couplings: &mut Couplings) {
            couplings.add(&[self.0]);
        }

        fn evaluate(&self, at: Motion, _: &[f64], _: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
            let u = at.u[self.0 as usize];
            out.stiffness.iter_mut().for_each(|k| k.add_block(self.0, self.0, &[u]));
            Ok(())
        }
    }

    /// In the memory of an earlier tangent stands the same as in fresh memory; tangents differ as their displacements do.
    #[test]
    fn a_tangent_takes_the_memory_of_an_earlier_one() {
        let freedoms = Freedoms::new(&[1, 1, 1]);
        let (chain, hardening) = (Chain, Hardening(1));
        let external = ExternalForces::default();
        let terms: Vec<&dyn Term> = vec![&chain, &hardening];
        let system =
            System::new(Scene { freedoms: &freedoms, terms, external, prescribed: Vec::new(), period: 1.0 }).unwrap();
        assert_eq!(system.changing, [false, true, false]);
        let tangent = |u: f64, spare| {
            let u = [0.0, u, 0.0];
            let at = Motion { u: &u, du: &u, step_time: 1.0, total_time: 1.0, dt: 1.0 };
            let old = [Vec::new(), Vec::new()];
            system.evaluate(at, &[0.0; 3], (&old, &mut old.clone()), spare).unwrap().tangent.unwrap()
        };
        let first = tangent(0.5, None);
        let (again, fresh) = (tangent(0.25, Some(first.clone())), tangent(0.25, None));
        assert_eq!(again.values, fresh.values);
        assert_eq!(fresh.diagonal(), [1.0, 2.25, 1.0]);
        assert!(system.same(&again, &fresh) && !system.same(&first, &fresh));
    }
}
