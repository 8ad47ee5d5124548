//! Tests over whole pairs.

mod far;
mod friction;
mod resistance;
mod robustness;
pub mod scene;
mod speed;
mod transmission;
mod unit_rule;
mod work;
