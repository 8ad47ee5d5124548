//! Materials.

/// Isotropic linear elasticity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus E [F/L²], > 0.
    pub young: f64,
    /// Poisson's ratio ν [-], −1 < ν < 0.5.
    pub poisson: f64,
}

impl Elastic {
    /// Lamé's first constant λ = E ν / ((1 + ν)(1 − 2ν)) [F/L²].
    pub fn lambda(&self) -> f64 {
        self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// Shear modulus μ = E / (2 (1 + ν)) [F/L²].
    pub fn mu(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }
}

/// A material as the deck names it.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name, capitals.
    pub name: String,
    /// Elasticity.
    pub elastic: Elastic,
    /// Density [M/L³], where given.
    pub density: Option<f64>,
}
