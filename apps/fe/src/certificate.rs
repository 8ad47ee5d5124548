//! The certificate: what stands beside every converged increment, and beside the whole run.

use crate::explicit::{Balance, Spent};
use crate::number::scientific;
use crate::terms::Terms;
use fe_contact::state::ContactState;
use fe_contact::viscous::Taken;
use fe_core::element::Family;
use fe_core::procedure::{Converged, Convergence, Energy, Seconds};
use std::fmt;

/// Largest imbalance of the forces, over the largest sum of forces, that a certified increment may have. The sum
/// of up to 10⁶ residuals of 1e-8 each, of random sign, is 1e-5 of one force and much less of their sum.
const BALANCE: f64 = 1e-6;

/// Stabilisation that takes more of the stored energy than this is warned of [%].
const LARGE_SHARE: f64 = 1.0;

/// What is checked of one increment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Certificate {
    /// Largest residual over the largest force [-].
    pub residual: f64,
    /// Largest overclosure [L] over all pairs, 0 where none is closed.
    pub overclosure: f64,
    /// Largest tension left between surfaces, in the law's unit.
    pub tension: f64,
    /// Part of the stored energy that sits in the contact laws [-]: with bodies pressed together, the part of the
    /// contact displacement that the law or the penalty gives way, instead of the bodies.
    pub contact_share: f64,
    /// Sum of applied forces by direction [F].
    pub applied: [f64; 3],
    /// Sum of reactions by direction [F], those of springs to the ground included.
    pub reaction: [f64; 3],
    /// Largest component of their sum, over the largest sum of absolute values [-].
    pub imbalance: f64,
    /// Energies [F L].
    pub energy: Energy,
    /// Energies [F L] that damping and stabilisation of contact have taken so far.
    pub taken: Taken,
    /// Resultant of each pair on its secondary side [F]; not among [`COLUMNS`], every pair has a history of its own.
    pub resultants: Vec<[f64; 3]>,
}

/// Names and dimensions of the numbers that [`Certificate::row`] gives.
pub const COLUMNS: [(&str, &str); 17] = [
    ("residual", "1"),
    ("overclosure", "L"),
    ("tension", "F/L²"),
    ("contact_share", "1"),
    ("applied_1", "F"),
    ("applied_2", "F"),
    ("applied_3", "F"),
    ("reaction_1", "F"),
    ("reaction_2", "F"),
    ("reaction_3", "F"),
    ("imbalance", "1"),
    ("energy_solids", "F L"),
    ("energy_contact", "F L"),
    ("energy_friction", "F L"),
    ("work", "F L"),
    ("energy_stabilization", "F L"),
    ("energy_damping", "F L"),
];

impl Certificate {
    /// Of a converged state.
    pub fn of(
        terms: &Terms,
        at: &Converged,
        convergence: &Convergence,
        pairs: &[ContactState],
        fixed: &[bool],
    ) -> Self {
        let freedoms = &terms.freedoms;
        let (mut applied, mut reaction, mut size) = ([0.0; 3], [0.0; 3], [0.0f64; 3]);
        for (f, &prescribed) in fixed.iter().enumerate() {
            let c = freedoms.component(f);
            if c < 3 {
                let held = if prescribed { at.residual[f] } else { 0.0 };
                applied[c] += at.external[f];
                reaction[c] += held;
                size[c] += at.external[f].abs() + held.abs();
            }
        }
        // What springs give to the ground comes back from there.
        for members in terms.members.iter().filter(|members| members.element().family() == Family::Spring) {
            let force = members.resultant(freedoms, &at.u);
            for c in 0..3 {
                reaction[c] -= force[c];
                size[c] += force[c].abs();
            }
        }
        // About the axis, radial forces balance by the ring itself.
        let axisymmetric = terms.structure.is_axisymmetric();
        let sums = (0..3).filter(|&c| !(axisymmetric && c == 0)).map(|c| (applied[c] + reaction[c]).abs());
        // Forces that round-off alone explains need not balance: each freedom may leave as much.
        let noise = convergence.round_off * freedoms.len() as f64;
        let largest = size.into_iter().fold(noise / BALANCE, f64::max);
        let ratio = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        Certificate {
            residual: convergence.ratio(),
            overclosure: worst(pairs, |p| p.largest_overclosure),
            tension: worst(pairs, |p| p.largest_tension),
            contact_share: ratio(at.energy.contact, at.energy.contact + at.energy.solids),
            applied,
            reaction,
            imbalance: ratio(sums.fold(0.0, f64::max), largest),
            energy: at.energy,
            taken: Taken {
                damping: pairs.iter().map(|p| p.taken.damping).sum(),
                stabilization: pairs.iter().map(|p| p.taken.stabilization).sum(),
            },
            resultants: pairs.iter().map(|p| p.total().0).collect(),
        }
    }

    /// The numbers in the order of [`COLUMNS`].
    pub fn row(&self) -> Vec<f64> {
        let mut row = vec![self.residual, self.overclosure, self.tension, self.contact_share];
        row.extend(self.applied);
        row.extend(self.reaction);
        let Energy { solids, contact, friction, work } = self.energy;
        row.extend([self.imbalance, solids, contact, friction, work, self.taken.stabilization, self.taken.damping]);
        row
    }

    /// Why an increment is not certified, if so. The residual was judged by the procedure.
    pub fn fault(&self) -> Option<String> {
        if self.tension > 0.0 {
            Some(format!("a tension of {:.3e} is left between surfaces that do not hold it", self.tension))
        } else if self.imbalance > BALANCE {
            Some(format!("applied forces and reactions differ by {:.3e} of their size", self.imbalance))
        } else {
            None
        }
    }
}

/// The largest of what each pair has.
fn worst(pairs: &[ContactState], of: impl Fn(&ContactState) -> Option<(u32, f64)>) -> f64 {
    pairs.iter().filter_map(of).fold(0.0, |largest, (_, value)| largest.max(value))
}

/// Certificate of a whole run: the worst of all increments, and what it took.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunCertificate {
    /// Worst numbers of all increments; sums and energies are those of the last one.
    pub worst: Certificate,
    /// Increments written.
    pub increments: usize,
    /// Attempts that were cut back.
    pub cutbacks: usize,
    /// Iterations in all.
    pub iterations: usize,
    /// Factorisations.
    pub factorisations: usize,
    /// Seconds by phase.
    pub seconds: Phases,
    /// Peak memory of the process [bytes], where the system tells.
    pub peak_memory: Option<u64>,
    /// Elements of an explicit job.
    pub elements: usize,
    /// Seconds of its increments.
    pub spent: Spent,
    /// Energies at the end of an explicit job, which has no equilibria to certify.
    pub explicit: Option<Balance>,
}

impl RunCertificate {
    /// Takes an increment in.
    pub fn add(&mut self, increment: &Certificate, convergence: &Convergence) {
        let last = self.worst.clone();
        self.worst = increment.clone();
        self.worst.residual = self.worst.residual.max(last.residual);
        self.worst.overclosure = self.worst.overclosure.max(last.overclosure);
        self.worst.tension = self.worst.tension.max(last.tension);
        self.worst.contact_share = self.worst.contact_share.max(last.contact_share);
        self.worst.imbalance = self.worst.imbalance.max(last.imbalance);
        self.increments += 1;
        self.iterations += convergence.iterations();
    }
}

/// Wall-clock seconds of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phases {
    /// Deck and meshes.
    pub read: f64,
    /// Contact search and integration.
    pub search: f64,
    /// The procedure's own phases.
    pub procedure: Seconds,
    /// Results.
    pub write: f64,
    /// The whole run.
    pub total: f64,
}

impl fmt::Display for RunCertificate {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match &self.explicit {
            Some(balance) => self.explicit(balance, out)?,
            None => self.equilibria(out)?,
        }
        if let Some(bytes) = self.peak_memory {
            write!(out, "\n  peak memory         {:.0} MB", bytes as f64 / 1e6)?;
        }
        Ok(())
    }
}

impl RunCertificate {
    /// Microseconds an element and increment of an explicit job.
    pub fn microseconds(&self) -> f64 {
        1e6 * self.spent.all / (self.elements.max(1) * self.increments.max(1)) as f64
    }

    fn explicit(&self, b: &Balance, out: &mut fmt::Formatter) -> fmt::Result {
        let e = |value: f64| scientific(value, 6);
        writeln!(out, "Certificate (energies at the end of {} increments)", self.increments)?;
        writeln!(out, "  kinetic             {}, at the start {}", e(b.kinetic), e(b.initial))?;
        writeln!(out, "  strain              {}", e(b.strain))?;
        writeln!(out, "  plastic             {}", e(b.plastic))?;
        writeln!(out, "  hourglass           {}", e(b.artificial))?;
        writeln!(out, "  viscous             {}", e(b.viscous))?;
        writeln!(out, "  friction            {}", e(b.friction))?;
        writeln!(out, "  contact             {}", e(b.contact))?;
        writeln!(out, "  work of loads       {}", e(b.work))?;
        writeln!(out, "  balance             {} of the largest energy", scientific(b.drift(), 2))?;
        let each = scientific(self.spent.all / self.increments.max(1) as f64, 2);
        writeln!(out, "  an increment        {each} s, {:.3} µs an element", self.microseconds())?;
        writeln!(out, "  of that             {}", self.spent)?;
        let s = self.seconds;
        write!(out, "  seconds             read {:.2}, write {:.2}; in all {:.2}", s.read, s.write, s.total)
    }

    fn equilibria(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let w = &self.worst;
        let e = |value: f64, digits: usize| scientific(value, digits);
        let three = |v: [f64; 3]| v.map(|x| format!("{:>14}", e(x, 6))).join(" ");
        writeln!(out, "Certificate (worst of {} increments; sums and energies of the last)", self.increments)?;
        writeln!(out, "  largest residual    {} of the largest force", e(w.residual, 2))?;
        writeln!(out, "  largest overclosure {}, tension left {}", e(w.overclosure, 4), e(w.tension, 1))?;
        if w.energy.contact > 0.0 {
            let share = 100.0 * w.contact_share;
            writeln!(out, "  given way           {share:.3} % of the stored energy sits in the contact (rigid: 0)")?;
        }
        writeln!(out, "  applied forces      {}", three(w.applied))?;
        writeln!(out, "  reactions           {}", three(w.reaction))?;
        for resultant in &w.resultants {
            writeln!(out, "  contact resultant   {}", three(*resultant))?;
        }
        writeln!(out, "  balance             {} of the forces", e(w.imbalance, 2))?;
        let (solids, contact, work) = (e(w.energy.solids, 6), e(w.energy.contact, 6), e(w.energy.work, 6));
        writeln!(out, "  energy              solids {solids}, contact {contact}, work of loads {work}")?;
        if w.taken.damping > 0.0 {
            writeln!(out, "  contact damping     {} taken by it", e(w.taken.damping, 6))?;
        }
        if w.taken.stabilization > 0.0 {
            let share = 100.0 * w.taken.stabilization / (w.energy.solids + w.energy.contact).max(f64::MIN_POSITIVE);
            let warned = if share > LARGE_SHARE { "warning: " } else { "" };
            let taken = e(w.taken.stabilization, 6);
            writeln!(out, "  stabilisation       {warned}{taken} taken by it, {share:.3} % of the stored energy")?;
        }
        if w.energy.friction > 0.0 {
            writeln!(out, "  friction            {} turned into heat", e(w.energy.friction, 6))?;
        }
        let (cut, its, factors) = (self.cutbacks, self.iterations, self.factorisations);
        writeln!(out, "  effort              {its} iterations, {factors} factorisations, {cut} cutbacks")?;
        let s = self.seconds;
        let p = s.procedure;
        write!(
            out,
            "  seconds             read {:.2}, search {:.2}, order {:.2}, assemble {:.2}, factor {:.2}, solve {:.2}, write {:.2}; in all {:.2}",
            s.read, s.search, p.order, p.assemble, p.factor, p.solve, s.write, s.total
        )
    }
}
