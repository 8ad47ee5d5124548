//! Exact fields of elastic bodies, each with its source.

pub mod harmonic;
pub mod point_force;
pub mod point_window;
pub mod thick;
pub mod window;

/// What an exact solution says of a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exact {
    /// Displacement [L]; around an axis radial, axial, 0.
    pub displacement: [f64; 3],
    /// Stress [F/L²], tension positive: xx, yy, zz, xy, yz, xz; around an axis xx is radial, yy axial, zz the hoop.
    pub stress: [f64; 6],
}
