//! Speed against error: problems with known answers, run through the same entry as `fe`, and what measures them.
#![cfg_attr(test, allow(clippy::unwrap_used))]

pub mod card;
pub mod cards;
pub mod compare;
pub mod exact;
pub mod explicit;
pub mod fit;
pub mod growth;
pub mod hard;
pub mod machine;
pub mod measure;
pub mod norm;
pub mod peer;
pub mod plot;
pub mod problem;
pub mod problems;
pub mod reading;
pub mod rows;
pub mod study;
pub mod windows;
