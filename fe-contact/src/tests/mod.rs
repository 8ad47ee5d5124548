//! Tests over whole pairs.

mod far;
mod robustness;
mod scene;
mod speed;
mod transmission;
mod unit_rule;
mod work;
