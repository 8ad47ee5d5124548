//! Tests over whole pairs.

mod scene;
mod transmission;
mod unit_rule;
mod work;
