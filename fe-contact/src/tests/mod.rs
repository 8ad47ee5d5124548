//! Tests over whole pairs.

mod far;
mod robustness;
mod scene;
mod transmission;
mod unit_rule;
mod work;
