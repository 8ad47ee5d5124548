//! Where the time of an explicit job goes.

use super::scene::Scene;
use fe_core::explicit::central_difference::CentralDifference;
use std::fmt;

/// Smallest share that is told by itself [-].
const LEAST: f64 = 0.01;

/// Seconds by the clock of the increments of a job.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spent {
    /// All of it, from the beginning of each step's first increment to the end of its last one.
    pub all: f64,
    /// In it each term that is no contact, by its name: elements, damping, loads.
    pub others: Vec<(String, f64)>,
    /// In it each contact, by its name.
    pub contacts: Vec<(String, f64)>,
    /// In it what looks at energies, and stores and prints results.
    pub output: f64,
}

impl Spent {
    /// Adds what the terms took in a step, all of it, and its output [s].
    pub fn add(&mut self, scene: &mut Scene, procedure: &CentralDifference, [all, output]: [f64; 2]) {
        self.all += all;
        self.output += output;
        let first = scene.terms().len() - scene.contact_terms();
        for (place, (term, seconds)) in scene.terms().iter().zip(procedure.seconds()).enumerate() {
            let among = if place < first { &mut self.others } else { &mut self.contacts };
            match among.iter_mut().find(|(name, _)| name == term.name()) {
                Some((_, sum)) => *sum += seconds,
                None => among.push((term.name().to_owned(), *seconds)),
            }
        }
    }

    /// Seconds of all elements, damping and loads.
    pub fn others(&self) -> f64 {
        sum(&self.others)
    }

    /// Seconds of all contacts.
    pub fn contacts(&self) -> f64 {
        sum(&self.contacts)
    }
}

fn sum(terms: &[(String, f64)]) -> f64 {
    terms.iter().fold(0.0, |sum, (_, seconds)| sum + seconds)
}

/// `71.2 % solids; 24.0 % general contact; 3.1 % output; 1.7 % the rest`: what moves the nodes, and what takes less than a
/// hundredth, is the rest.
impl fmt::Display for Spent {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let terms = self.others.iter().chain(&self.contacts).map(|(name, seconds)| (name.as_str(), *seconds));
        let mut rest = self.all;
        for (name, seconds) in terms.chain([("output", self.output)]).filter(|(_, s)| *s >= LEAST * self.all) {
            rest -= seconds;
            write!(out, "{:.1} % {name}; ", 100.0 * seconds / self.all)?;
        }
        write!(out, "{:.1} % the rest", 100.0 * rest / self.all)
    }
}
