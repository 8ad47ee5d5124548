//! A run on the terminal: the increment table, a progress bar, the certificate.

use crate::number::scientific;
use crate::observer::{Event, Observer};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{IsTerminal, Write};

/// Writes a run to standard output.
pub struct Console {
    quiet: bool,
    bar: Option<ProgressBar>,
    period: f64,
    head_is_due: bool,
}

const HEAD: &str = " step incr att status equil    step time    increment   residual  overclosure |contact force|";

const FRAMES: &str = " step increment    step time    increment      kinetic       strain   dissipated      contact         work      drift";

impl Console {
    /// On standard output, with a progress bar where that is a terminal; or silent.
    pub fn new(quiet: bool) -> Self {
        let bar = (!quiet && std::io::stdout().is_terminal()).then(|| {
            let bar = ProgressBar::new(1000);
            if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} % of the step, {elapsed}") {
                bar.set_style(style);
            }
            bar
        });
        Console { quiet, bar, period: 1.0, head_is_due: false }
    }

    /// The head of a table, once a step.
    fn head(&mut self, text: &str) {
        if std::mem::take(&mut self.head_is_due) {
            self.line(text);
        }
    }

    fn line(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| write_line(text)),
            None => write_line(text),
        }
    }
}

/// A remark as it is printed; those on a line of the deck say themselves whether they warn.
pub fn remark(note: &str) -> String {
    let placed = [": note: ", ": warning: "].iter().any(|kind| note.contains(kind));
    if placed { note.into() } else { format!("note: {note}") }
}

fn write_line(text: &str) {
    // A run goes on where its output is closed.
    let _ = writeln!(std::io::stdout().lock(), "{text}");
}

impl Observer for Console {
    fn event(&mut self, event: Event) {
        if self.quiet {
            return;
        }
        match event {
            Event::Note(note) => self.line(&remark(note)),
            Event::Step { number, plan, period } => {
                self.line(&format!("\nstep {number}, time {period}: {}", plan.headline()));
                self.period = period;
                self.head_is_due = true;
                if let Some(bar) = &self.bar {
                    bar.set_position(0);
                }
            }
            Event::Increment { step, attempt, convergence: c, certificate, contact_force } => {
                self.head(HEAD);
                self.line(&format!(
                    "{step:5} {:4} {:3} {:6} {:5} {:>12} {:>12} {:>10} {:>12} {:>14}",
                    attempt.increment,
                    attempt.attempt,
                    c.status_iterations,
                    c.equilibrium_iterations,
                    scientific(attempt.step_time, 5),
                    scientific(attempt.dt, 5),
                    scientific(certificate.residual, 2),
                    scientific(certificate.overclosure, 4),
                    scientific(contact_force, 6),
                ));
                if let Some(bar) = &self.bar {
                    bar.set_position((1000.0 * attempt.step_time / self.period) as u64);
                }
            }
            Event::Cutback { step, attempt, reason } => {
                self.head(HEAD);
                self.line(&format!("{step:5} {:4} {:3} cut back: {reason}", attempt.increment, attempt.attempt))
            }
            Event::Frame(frame) => {
                self.head(FRAMES);
                if let Some(bar) = &self.bar {
                    bar.set_position((1000.0 * frame.step_time / self.period) as u64);
                }
                let (b, e) = (frame.balance, |value: f64| scientific(value, 4));
                let dissipated = b.plastic + b.artificial + b.viscous + b.friction;
                self.line(&format!(
                    "{:5} {:9} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12} {:>10}",
                    frame.step,
                    frame.increment,
                    scientific(frame.step_time, 5),
                    scientific(frame.dt, 4),
                    e(b.kinetic),
                    e(b.strain),
                    e(dissipated),
                    e(b.contact),
                    e(b.work),
                    scientific(b.drift(), 1),
                ));
            }
            Event::Done(certificate) => {
                if let Some(bar) = self.bar.take() {
                    bar.finish_and_clear();
                }
                write_line(&format!("\n{certificate}"));
            }
        }
    }
}
