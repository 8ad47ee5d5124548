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
}

const HEAD: &str = " step incr att status equil    step time    increment   residual  overclosure |contact force|";

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
        Console { quiet, bar, period: 1.0 }
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
                self.line(HEAD);
                self.period = period;
                if let Some(bar) = &self.bar {
                    bar.set_position(0);
                }
            }
            Event::Increment { step, attempt, convergence: c, certificate, contact_force } => {
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
                self.line(&format!("{step:5} {:4} {:3} cut back: {reason}", attempt.increment, attempt.attempt))
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
