//! Thick-walled cylinder and sphere under pressure inside. Lamé; Timoshenko and Goodier, Theory of Elasticity,
//! 3rd ed., 1970, §28 and §136.

use super::Exact;
use fe_core::material::Elastic;

/// A vessel under pressure inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vessel {
    /// Inner radius [L].
    pub inner: f64,
    /// Outer radius [L].
    pub outer: f64,
    /// Pressure inside [F/L²].
    pub pressure: f64,
    /// Material.
    pub elastic: Elastic,
}

/// Radial displacement [L] and the principal stresses [F/L²] at a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radial {
    /// Outward displacement [L].
    pub displacement: f64,
    /// Radial stress [F/L²].
    pub radial: f64,
    /// Hoop stress [F/L²].
    pub hoop: f64,
    /// Stress along the axis of a cylinder, the other hoop stress of a sphere [F/L²].
    pub axial: f64,
}

impl Vessel {
    /// Of a cylinder in plane strain: σ_r = A − B/r², σ_θ = A + B/r², 2μu = (1−2ν) A r + B/r.
    pub fn cylinder(&self, r: f64) -> Radial {
        let (a, b) = (self.inner.powi(2), self.outer.powi(2));
        let uniform = self.pressure * a / (b - a);
        let part = uniform * b / (r * r);
        let nu = self.elastic.poisson;
        Radial {
            displacement: r * ((1.0 - 2.0 * nu) * uniform + part) / (2.0 * self.elastic.mu()),
            radial: uniform - part,
            hoop: uniform + part,
            axial: 2.0 * nu * uniform,
        }
    }

    /// Of a sphere: σ_r = A − 2B/r³, σ_θ = A + B/r³, u = r [(1−2ν) A + (1+ν) B/r³]/E.
    pub fn sphere(&self, r: f64) -> Radial {
        let (a, b) = (self.inner.powi(3), self.outer.powi(3));
        let uniform = self.pressure * a / (b - a);
        let part = 0.5 * uniform * b / r.powi(3);
        let Elastic { young, poisson: nu } = self.elastic;
        let hoop = uniform + part;
        Radial {
            displacement: r * ((1.0 - 2.0 * nu) * uniform + (1.0 + nu) * part) / young,
            radial: uniform - 2.0 * part,
            hoop,
            axial: hoop,
        }
    }

    /// A cylinder's field around z.
    pub fn cylinder_at(&self, [x, y, _]: [f64; 3]) -> Exact {
        let r = x.hypot(y);
        spread(self.cylinder(r), [x / r, y / r, 0.0])
    }

    /// A sphere's field about the origin.
    pub fn sphere_at(&self, [x, y, z]: [f64; 3]) -> Exact {
        let r = (x * x + y * y + z * z).sqrt();
        spread(self.sphere(r), [x / r, y / r, z / r])
    }

    /// The cylinder's field in the coordinates of axisymmetric elements, radius and height.
    pub fn cylinder_around(&self, [r, _, _]: [f64; 3]) -> Exact {
        let found = self.cylinder(r);
        let stress = [found.radial, found.axial, found.hoop, 0.0, 0.0, 0.0];
        Exact { displacement: [found.displacement, 0.0, 0.0], stress }
    }

    /// The sphere's field in the coordinates of axisymmetric elements, radius and height.
    pub fn sphere_around(&self, [r, z, _]: [f64; 3]) -> Exact {
        self.sphere_at([r, z, 0.0])
    }
}

/// Radial values along the unit vector n: u n, and σ_θ + (σ_r − σ_θ) n⊗n, with the axial stress in the place of the
/// hoop stress along z.
fn spread(found: Radial, n: [f64; 3]) -> Exact {
    let difference = found.radial - found.hoop;
    let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
    let mut stress = pairs.map(|(i, j)| difference * n[i] * n[j]);
    [found.hoop, found.hoop, found.axial].iter().zip(&mut stress).for_each(|(s, stress)| *stress += s);
    Exact { displacement: n.map(|n| found.displacement * n), stress }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published figures: MacNeal and Harder, Finite Elements in Analysis and Design 1 (1985) 3, cylinder 3/9.
    #[test]
    fn cylinder_of_macneal_and_harder() {
        for (poisson, u) in [(0.3, 4.5825e-3), (0.49, 5.039925e-3), (0.499, 5.06024925e-3), (0.4999, 5.0622749925e-3)] {
            let elastic = Elastic { young: 1000.0, poisson };
            let vessel = Vessel { inner: 3.0, outer: 9.0, pressure: 1.0, elastic };
            assert!((vessel.cylinder(3.0).displacement / u - 1.0).abs() < 1e-12);
            assert!((vessel.cylinder(3.0).radial + 1.0).abs() < 1e-14 && vessel.cylinder(9.0).radial.abs() < 1e-14);
        }
    }

    /// Figures of the same formulas worked by hand: 30/50, E = 70e3, ν = 0.3, p = 100.
    #[test]
    fn sphere() {
        let elastic = Elastic { young: 70e3, poisson: 0.3 };
        let vessel = Vessel { inner: 30.0, outer: 50.0, pressure: 100.0, elastic };
        let (inside, outside) = (vessel.sphere(30.0), vessel.sphere(50.0));
        assert!((inside.displacement / 0.0402551020408 - 1.0).abs() < 1e-11);
        assert!((outside.displacement / 0.0206632653061 - 1.0).abs() < 1e-11);
        assert!((inside.hoop / 91.3265306 - 1.0).abs() < 1e-8);
        assert!((inside.radial + 100.0).abs() < 1e-12 && outside.radial.abs() < 1e-12);
    }

    /// Hooke's law in plane strain and space: the hoop strain is u/r.
    #[test]
    fn strains_fit_stresses() {
        let elastic = Elastic { young: 70e3, poisson: 0.3 };
        let vessel = Vessel { inner: 30.0, outer: 50.0, pressure: 100.0, elastic };
        for found in [vessel.cylinder(37.0), vessel.sphere(37.0)] {
            let hoop = (found.hoop - 0.3 * (found.radial + found.axial)) / 70e3;
            assert!((hoop * 37.0 / found.displacement - 1.0).abs() < 1e-13);
        }
        let turned = vessel.sphere_at([12.0, 20.0, 30.0]).stress;
        let trace = turned[0] + turned[1] + turned[2];
        let along = vessel.sphere((144.0f64 + 400.0 + 900.0).sqrt());
        assert!((trace / (along.radial + 2.0 * along.hoop) - 1.0).abs() < 1e-13);
    }
}
