//! The program `fe` with one more pressure–overclosure law, p = K h³; README.md explains it line by line.

use fe_contact::law::{Datum, LawDefinition, Laws, Lines, NormalLaw, NormalResponse};
use std::process::ExitCode;
use std::sync::Arc;

/// p = K h³ for an overclosure h = −g > 0, else 0; K [F/L⁵].
#[derive(Debug)]
struct Cubic(f64);

impl NormalLaw for Cubic {
    fn respond(&self, gap: f64) -> NormalResponse {
        let (k, h) = (self.0, (-gap).max(0.0));
        NormalResponse { energy: k * h.powi(4) / 4.0, pressure: k * h.powi(3), stiffness: 3.0 * k * h.powi(2) }
    }
}

/// As decks name it: `PRESSURE-OVERCLOSURE=CUBIC`.
const CUBIC: LawDefinition = LawDefinition {
    keyword: "CUBIC",
    summary: "p = K h^3 for an overclosure h > 0",
    source: "apps/own-law/README.md",
    data: &[Datum::positive("factor", "F/L⁵", "factor K on the third power of the overclosure")],
    lines: Lines::One,
    example: &[2.8e6],
    build: |data| Ok(Arc::new(Cubic(data[0]))),
};

fn main() -> ExitCode {
    fe::main(fe::Library { laws: Laws::standard().with(CUBIC) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pressure is the slope of the energy, stiffness that of the pressure.
    #[test]
    fn the_law_keeps_its_word() {
        let law = (CUBIC.build)(CUBIC.example).expect("the example is sound");
        fe_contact::verify::law(&*law, -1.0..0.5).expect("the three belong together");
        fe_contact::verify::at_all_scales(&*law, 1.0).expect("at small overclosures, too");
    }
}
