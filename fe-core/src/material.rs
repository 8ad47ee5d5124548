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

/// Isotropic hardening of a von Mises material: yield stress σ_y over equivalent plastic strain, linear in between and
/// constant beyond the last point.
#[derive(Clone, Debug, PartialEq)]
pub struct Hardening {
    /// (equivalent plastic strain [-], yield stress [F/L²]): strains ascend from 0, stresses are > 0 and never fall.
    pub points: Vec<(f64, f64)>,
}

impl Hardening {
    /// Yield stress [F/L²] at an equivalent plastic strain ≥ 0, and its slope there [F/L²], that to the right at a point.
    pub fn at(&self, strain: f64) -> (f64, f64) {
        let next = self.points.partition_point(|point| point.0 <= strain);
        let last = self.points[next.saturating_sub(1)];
        self.points.get(next).map_or((last.1, 0.0), |point| {
            let slope = (point.1 - last.1) / (point.0 - last.0);
            (last.1 + slope * (strain - last.0), slope)
        })
    }
}

/// W = C₁₀ (Ī₁ − 3) + (J − 1)²/D₁ per volume of the undeformed body, Ī₁ = J^(−2/3) tr C: Abaqus Theory Guide, Hyperelastic
/// material behavior.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeoHooke {
    /// C₁₀ [F/L²], > 0: half the shear modulus at small strain.
    pub c10: f64,
    /// D₁ [L²/F], > 0: 2 over the bulk modulus at small strain.
    pub d1: f64,
}

impl NeoHooke {
    /// The elasticity of small strains: μ = 2 C₁₀, K = 2/D₁; E = 9 K μ/(3 K + μ), ν = (3 K − 2 μ)/(2 (3 K + μ)).
    pub fn elastic(&self) -> Elastic {
        let (mu, bulk) = (2.0 * self.c10, 2.0 / self.d1);
        let sum = 3.0 * bulk + mu;
        Elastic { young: 9.0 * bulk * mu / sum, poisson: (3.0 * bulk - 2.0 * mu) / (2.0 * sum) }
    }
}

/// How a material answers to strain.
#[derive(Clone, Debug, PartialEq)]
pub enum Response {
    /// Linear.
    Elastic(Elastic),
    /// Linear up to the yield stress of von Mises, then plastic.
    Plastic {
        /// Before it yields, and when it is unloaded.
        elastic: Elastic,
        /// How the yield stress grows.
        hardening: Hardening,
    },
    /// Hyperelastic.
    NeoHooke(NeoHooke),
}

impl Response {
    /// The elasticity of small strains.
    pub fn elastic(&self) -> Elastic {
        match self {
            Response::Elastic(elastic) | Response::Plastic { elastic, .. } => *elastic,
            Response::NeoHooke(hyperelastic) => hyperelastic.elastic(),
        }
    }
}

/// Rayleigh damping: the damping matrix is α M + β K.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damping {
    /// α [1/T], ≥ 0, on the mass.
    pub alpha: f64,
    /// β [T], ≥ 0, on the elastic stiffness.
    pub beta: f64,
}

/// A material as the deck names it.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name, capitals.
    pub name: String,
    /// Stress from strain.
    pub response: Response,
    /// Density [M/L³], where given.
    pub density: Option<f64>,
    /// Damping in dynamic steps.
    pub damping: Damping,
}

impl Material {
    /// A linear elastic material without density.
    pub fn elastic(name: &str, elastic: Elastic) -> Self {
        Material {
            name: name.to_owned(),
            response: Response::Elastic(elastic),
            density: None,
            damping: Damping::default(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hardening_is_linear_between_points_and_constant_beyond() {
        let hardening = Hardening { points: vec![(0.0, 200.0), (0.05, 300.0), (0.1, 320.0)] };
        let at = [0.0, 0.025, 0.05, 0.1, 1.0].map(|strain| hardening.at(strain));
        let slopes = [2000.0, 2000.0, 400.0, 0.0, 0.0];
        for ((stress, slope), (wanted, wanted_slope)) in
            at.into_iter().zip([200.0, 250.0, 300.0, 320.0, 320.0].into_iter().zip(slopes))
        {
            assert!(
                (stress - wanted).abs() < 1e-12 * wanted && (slope - wanted_slope).abs() < 1e-9,
                "{stress} {slope}"
            );
        }
    }

    /// μ and K are those of the constants.
    #[test]
    fn hyperelasticity_of_small_strains() {
        let elastic = NeoHooke { c10: 80.0, d1: 0.01 }.elastic();
        assert!((elastic.mu() - 160.0).abs() < 1e-12);
        assert!((elastic.lambda() + 2.0 / 3.0 * elastic.mu() - 200.0).abs() < 1e-11);
    }
}
