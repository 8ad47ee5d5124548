//! u = ∇φ of a harmonic φ: div u = 0 and Δu = 0, so that it solves Navier's equations without body force for every E
//! and ν, and σ = 2μ ∇∇φ for every ν. (Displacement potential: Barber, Elasticity, 3rd ed., 2010, §20.2.)

use super::Exact;
use fe_core::element::Space;

/// Harmonic potential for a space: eˣ cos y in the plane, eˣ cos 0.6y cos 0.8z in space, e^z J₀(r) around an axis;
/// `mu` is the shear modulus [F/L²]. (In plane stress the field has ε_zz = 0 as well, since tr ε vanishes.)
pub fn field(space: Space, mu: f64, at: [f64; 3]) -> Exact {
    let (displacement, curvature) = match space {
        Space::Solid | Space::Any => solid(at),
        Space::Axisymmetric => axisymmetric(at),
        Space::PlaneStrain | Space::PlaneStress | Space::Plane => plane(at),
    };
    Exact { displacement, stress: curvature.map(|c| 2.0 * mu * c) }
}

/// ∇φ and ∇∇φ.
type Derivatives = ([f64; 3], [f64; 6]);

fn solid([x, y, z]: [f64; 3]) -> Derivatives {
    let (e, (sy, cy), (sz, cz)) = (x.exp(), (0.6 * y).sin_cos(), (0.8 * z).sin_cos());
    let phi = e * cy * cz;
    let (first, second) = (-0.6 * e * sy * cz, -0.8 * e * cy * sz);
    ([phi, first, second], [phi, -0.36 * phi, -0.64 * phi, first, 0.48 * e * sy * sz, second])
}

fn plane([x, y, _]: [f64; 3]) -> Derivatives {
    let (c, s) = (x.exp() * y.cos(), x.exp() * y.sin());
    ([c, -s, 0.0], [c, -c, 0.0, -s, 0.0, 0.0])
}

fn axisymmetric([r, z, _]: [f64; 3]) -> Derivatives {
    let (e, j0, j1) = (z.exp(), bessel(0, r), bessel(1, r));
    let hoop = -e * if r > 0.0 { j1 / r } else { 0.5 };
    ([-e * j1, e * j0, 0.0], [-e * j0 - hoop, e * j0, hoop, -e * j1, 0.0, 0.0])
}

/// Bessel's J_n by its power series, for arguments up to 2: (x/2)ⁿ Σ (−x²/4)ᵏ / (k! (n+k)!); the twentieth term is
/// below 1e-36.
fn bessel(n: usize, x: f64) -> f64 {
    let mut term = (1..=n).fold(1.0, |t, i| t * 0.5 * x / i as f64);
    let mut sum = 0.0;
    for k in 1..=20 {
        sum += term;
        term *= -0.25 * x * x / (k * (n + k)) as f64;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use fe_mesh::quadrature::Rule;

    /// ∫ σ:D⁻¹:σ over the unit square or cube at E = 1000, ν = 0.3, and over the radian: with 12 points a direction
    /// the quadrature of these entire functions is exact to round-off.
    #[test]
    fn energies() {
        let mu = 1000.0 / 2.6;
        let square = |stress: [f64; 6]| {
            let [a, b, c, d, e, f] = stress.map(|s| s * s);
            (a + b + c + 2.0 * (d + e + f)) / (2.0 * mu)
        };
        let rules = [
            (Space::PlaneStrain, Rule::quadrilateral(12)),
            (Space::Solid, Rule::hexahedron(12)),
            (Space::Axisymmetric, Rule::quadrilateral(12)),
        ];
        let energy = |(space, rule): &(Space, Rule)| -> f64 {
            let part = |(xi, weight): &([f64; 3], f64)| {
                let at = xi.map(|x| 0.5 + 0.5 * x);
                let around = if *space == Space::Axisymmetric { std::f64::consts::TAU * at[0] } else { 1.0 };
                let measure = if *space == Space::Solid { 0.125 } else { 0.25 };
                0.5 * weight * measure * around * square(field(*space, mu, at).stress)
            };
            rule.points.iter().map(part).sum()
        };
        let found: Vec<f64> = rules.iter().map(energy).collect();
        for (found, exact) in found.iter().zip([2457.3292688195, 1719.0264959634, 5336.3855538619]) {
            assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
        }
    }
}
