//! Cards that change nothing here; each is remarked on in one line.

/// Name, and why it has no effect.
pub(super) const CARDS: &[(&str, &str)] = &[
    ("PREPRINT", "`fe check` prints the model"),
    ("RESTART", "no restart files are written"),
    ("MONITOR", "the log shows each increment"),
    ("PRINT", "the log shows each increment"),
    ("PRINT FORMAT", "tables have the layout of CalculiX"),
    ("FILE FORMAT", "results are written as VTKHDF"),
    ("FILE OUTPUT", "results are written as VTKHDF"),
    ("ENERGY PRINT", "energies are part of each increment's certificate"),
    ("ENERGY FILE", "energies are part of each increment's certificate"),
    ("INCREMENTATION OUTPUT", "the log shows each increment"),
    ("PHYSICAL CONSTANTS", "nothing here needs them"),
    ("DATA CHECK", "say `fe check`"),
    ("DIAGNOSTICS", "the log shows each increment"),
    ("ELEMENT MATRIX OUTPUT", "matrices are not written"),
    ("USER OUTPUT VARIABLES", "there are no user subroutines"),
];
