//! Problems with known answers: geometry at any refinement, deck and mesh as a user would write them, and the answer.

pub mod cantilever;
pub mod contact_area;
pub mod cylinder;
pub mod grading;
pub mod hertz_ball;
pub mod hertz_line;
mod octant;
pub mod thick_sphere;

pub use crate::problem::Problem;

/// All problems.
pub fn all() -> Vec<Box<dyn Problem>> {
    vec![
        Box::new(cantilever::Cantilever),
        Box::new(cylinder::Cylinder),
        Box::new(hertz_ball::HertzBall),
        Box::new(hertz_line::HertzLine),
        Box::new(thick_sphere::ThickSphere),
    ]
}

/// The problem of a name; the error lists the names there are.
pub fn find(name: &str) -> Result<Box<dyn Problem>, String> {
    let names: Vec<&str> = all().iter().map(|problem| problem.name()).collect();
    let known = || format!("no problem is called `{name}`; there are {}", names.join(", "));
    all().into_iter().find(|problem| problem.name() == name).ok_or_else(known)
}

#[cfg(test)]
mod tests;
