//! Contact as a term of the virtual work: δW = −Σ A p(g) δg over its points.

use crate::contact::Contact;
use crate::enforce::{Answer, CLOSED, OPEN, SLIPPING};
use crate::law::NormalLaw;
use crate::point::{ContactPoint, ContactStatus, Kinematics, dot};
use crate::slip::Along;
use fe_core::term::{Equilibrium, Lacking, Overlap};
use fe_core::{Assembly, BlockMatrix, Couplings, Motion, Pattern, Reject, Term};
use std::ops::Range;
use std::sync::Arc;

/// Where the points stand in matrices of one pattern.
#[derive(Debug)]
pub(crate) struct Blocks {
    pattern: Arc<Pattern>,
    /// For each point where the values of its blocks (i, j ≤ i) start, i outer.
    starts: Vec<Vec<usize>>,
}

impl Blocks {
    fn new(pattern: &Arc<Pattern>, points: &[ContactPoint]) -> Self {
        let start = |i: u32, j: u32| {
            // A node without freedoms has no block, and nothing to put into it.
            let empty =
                pattern.freedoms.of_node(i as usize).is_empty() || pattern.freedoms.of_node(j as usize).is_empty();
            let block = || pattern.block(i, j).expect("the nodes of a point are coupled");
            if empty { 0 } else { pattern.value_start[block()] }
        };
        let lower = |nodes: &[u32]| {
            let each = nodes.iter().enumerate().flat_map(|(a, &i)| nodes[..=a].iter().map(move |&j| start(i, j)));
            each.collect()
        };
        Blocks { pattern: pattern.clone(), starts: points.iter().map(|p| lower(&p.nodes)).collect() }
    }
}

impl Contact {
    /// Gap [L] of a point at a displacement.
    pub fn opening(&self, point: usize, u: &[f64]) -> f64 {
        self.points[point].opening(u, &self.places[point])
    }

    /// Where a point stands at a displacement.
    pub(crate) fn at(&self, point: usize, u: &[f64]) -> Kinematics<'_> {
        self.points[point].at(u, &self.places[point])
    }

    /// How the gap [L] of a point changes with a small motion `field` from a displacement.
    pub fn rate(&self, point: usize, u: &[f64], field: &[f64]) -> f64 {
        dot(&self.at(point, u).row, field, &self.places[point])
    }

    /// A law's answer. At the kink, within round-off of the model's size, the point touches: it is closed and
    /// has the stiffness of the closed side, or one of that size, so that a body that just touches is held.
    pub(crate) fn respond(&self, law: &dyn NormalLaw, gap: f64) -> Answer {
        let kink = law.reach();
        let mut response = law.respond(gap);
        let (touches, own_slope) = ((gap - kink).abs() <= self.touch, response.stiffness);
        if touches {
            response.stiffness = own_slope.max(law.typical_stiffness());
        }
        let status = if gap <= kink + self.touch { ContactStatus::Closed } else { ContactStatus::Open };
        Answer { response, status, touches, own_slope }
    }

    /// True when a point presses at `u`, and goes on to press as much on one side of its gap at least.
    pub(crate) fn on_plateau(&self, point: usize, u: &[f64]) -> bool {
        let gap = self.opening(point, u);
        let sides = [gap - self.touch, gap + self.touch].map(|g| self.law.respond(g));
        sides.iter().any(|side| side.pressure > 0.0 && side.stiffness <= 0.0)
    }

    fn blocks(&self, pattern: &Arc<Pattern>) -> Arc<Blocks> {
        let mut kept = self.blocks.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match &*kept {
            Some(blocks) if Arc::ptr_eq(&blocks.pattern, pattern) => blocks.clone(),
            _ => kept.insert(Arc::new(Blocks::new(pattern, &self.points))).clone(),
        }
    }

    /// Adds factor · d dᵀ of a row d over a point's nodes, the lower blocks; nodes are ascending.
    pub(crate) fn add_stiffness(
        &self,
        point: usize,
        (factor, row): (f64, &[f64]),
        blocks: &Blocks,
        out: &mut BlockMatrix,
    ) {
        let mut starts = blocks.starts[point].iter();
        let mut first = 0;
        for (a, place) in self.places[point].iter().enumerate() {
            let rows = &row[first..first + place.len()];
            first += place.len();
            let mut columns = row;
            for (other, &start) in self.places[point][..=a].iter().zip(starts.by_ref()) {
                let (of_node, rest) = columns.split_at(other.len());
                columns = rest;
                let values = out.values[start..].iter_mut();
                let products = rows.iter().flat_map(|r| of_node.iter().map(move |c| factor * r * c));
                values.zip(products).for_each(|(value, product)| *value += product);
            }
        }
    }
}

impl Term for Contact {
    fn name(&self) -> &str {
        Contact::name(self)
    }

    fn couplings(&self, couplings: &mut Couplings) {
        if self.acts() {
            self.points.iter().for_each(|p| couplings.add(&p.nodes));
        }
    }

    fn history(&self) -> usize {
        self.numbers()
            + usize::from(self.allowance.is_some())
            + self.resistances().map(|r| r.numbers(self.points.len())).sum::<usize>()
    }

    fn augment(&self, at: Equilibrium, old: &[f64], new: &mut [f64]) -> Option<Overlap> {
        if self.acts() { self.take_multipliers(at, old, new) } else { None }
    }

    /// A removed contact is nothing at all.
    fn is_linear(&self) -> bool {
        !self.acts()
    }

    fn evaluate(&self, at: Motion, old: &[f64], new: &mut [f64], out: &mut Assembly) -> Result<(), Reject> {
        if !self.acts() {
            return Ok(());
        }
        self.allow(&at, new);
        let moved = at.du.iter().any(|d| *d != 0.0);
        let blocks = out.stiffness.as_deref().map(|k| self.blocks(&k.pattern));
        let friction = self.friction_at(&at);
        for (i, p) in self.points.iter().enumerate() {
            let here = self.at(i, at.u);
            if !here.gap.is_finite() {
                let place = format!("the gaps of {}", self.name());
                return Err(Reject::NotFinite { place, node: Some(p.node as usize) });
            }
            let answer = self.answer(i, here.gap, (old, new));
            let along = self.along(i, (&at, friction.as_deref()), &answer, (old, new));
            let Answer { response, status, own_slope, .. } = answer;
            let measure = p.measure.value();
            out.energy += response.energy * measure;
            let now = match Contact::status_of(status, along.as_ref()) {
                ContactStatus::Open => OPEN,
                ContactStatus::Closed => CLOSED,
                ContactStatus::Slipping => SLIPPING,
            };
            out.status_changes += usize::from(new[i] != now);
            new[i] = now;
            self.keep(i, along.as_ref(), old, new);
            let force = response.pressure * measure;
            add(&here.row, -force, &self.places[i], out.residual);
            for (row, shear) in along.iter().flat_map(|a| a.slide.rows.iter().zip(a.answer.shear)) {
                add(row, shear * measure, &self.places[i], out.residual);
            }
            if let Some(along) = &along {
                let [shear, elastic] = [along.answer.shear, along.answer.elastic];
                out.energy += 0.5 * measure * self.stored(shear, elastic);
            }
            if let (Some(blocks), Some(stiffness)) = (&blocks, out.stiffness.as_deref_mut()) {
                // A force along a direction that turns has a stiffness of its own: −N ∂²g/∂u².
                let turning = here.bending.iter().map(|(factor, row)| (-force * factor, row.as_slice()));
                // Once the increment has moved, a point that touches and does not press has come off: held back, points
                // under tiny loads, which open by no more than round-off of the model's size, would never do so.
                let came_off = moved && response.pressure == 0.0 && !self.is_held(i, old);
                let slope = if came_off { own_slope } else { response.stiffness };
                let all = std::iter::once((slope * measure, &*here.row)).chain(turning);
                for part in all.filter(|part| part.0 != 0.0) {
                    self.add_stiffness(i, part, blocks, stiffness);
                }
                for (factor, row) in along.iter().flat_map(Along::stiffness) {
                    self.add_stiffness(i, (factor * measure, &row), blocks, stiffness);
                }
            }
        }
        self.resist(&at, (old, new), blocks.as_deref(), out);
        Ok(())
    }

    fn lacking<'s>(&'s self, at: Motion, (old, new): (&[f64], &[f64])) -> Option<Lacking<'s>> {
        let friction = self.friction_at(&at).filter(|law| self.acts() && !law.is_symmetric())?;
        let of_point = |i: usize| {
            let here = self.at(i, at.u);
            let answer = self.answer(i, here.gap, (old, new));
            let along = self.along(i, (&at, Some(&friction)), &answer, (old, new))?;
            along.has_rest().then_some((i, here.row, answer.response.stiffness, along))
        };
        let slipping: Vec<_> = (0..self.points.len()).filter_map(of_point).collect();
        if slipping.is_empty() {
            return None;
        }
        let product = move |x: &[f64], y: &mut [f64]| {
            for (i, row, stiffness, along) in &slipping {
                let (places, measure) = (&self.places[*i], self.points[*i].measure.value());
                let pressing = -stiffness * dot(row, x, places);
                let changes = along.rest(pressing, along.slide.slip(x, places));
                for (row, change) in along.slide.rows.iter().zip(changes) {
                    add(row, change * measure, places, y);
                }
            }
        };
        Some(Box::new(product))
    }

    fn force_round_off(&self, u: &[f64], history: &[f64]) -> f64 {
        if !self.acts() {
            return 0.0;
        }
        let of_point = |i: usize| {
            let answer = self.answer(i, self.opening(i, u), (history, history));
            answer.response.stiffness * self.points[i].measure.value()
        };
        // What acts on prescribed freedoms alone need not be balanced.
        let moving = (0..self.points.len()).filter(|&i| self.law_of_stuck(i).is_none());
        self.round_off() * moving.map(of_point).fold(0.0, f64::max)
    }

    fn dissipated(&self, old: &[f64], new: &[f64]) -> f64 {
        self.rubbed(old, new)
    }

    fn stiffen(&self, u: &[f64], stiffness: &mut BlockMatrix) -> bool {
        if !self.acts() {
            return false;
        }
        let blocks = self.blocks(&stiffness.pattern);
        let mut done = false;
        for (i, p) in self.points.iter().enumerate() {
            let here = self.at(i, u);
            let Answer { response: answer, status, .. } = self.respond(&*self.law, here.gap);
            if status != ContactStatus::Open && answer.stiffness <= 0.0 {
                let lacking = self.law.typical_stiffness() - answer.stiffness;
                self.add_stiffness(i, (lacking * p.measure.value(), &here.row), &blocks, stiffness);
                done = true;
            }
            let Some(law) = self.friction().filter(|law| status != ContactStatus::Open && !law.is_none()) else {
                continue;
            };
            // A point that slips holds nothing along the surface, and may yet come to stick.
            let Some(slide) = self.slide_from(i, u) else { continue };
            let own = law.stiffness(answer.pressure);
            let factor = if own > 0.0 { own } else { self.law.typical_stiffness() };
            for row in slide.rows.iter().filter(|row| !row.is_empty()) {
                self.add_stiffness(i, (factor * p.measure.value(), row), &blocks, stiffness);
                done = true;
            }
        }
        done
    }
}

/// Adds a force along a row.
pub(crate) fn add(row: &[f64], force: f64, places: &[Range<usize>], residual: &mut [f64]) {
    if force != 0.0 {
        row.iter().zip(places.iter().cloned().flatten()).for_each(|(d, f)| residual[f] += force * d);
    }
}
