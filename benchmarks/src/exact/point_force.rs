//! A force on the surface of the elastic half space, or along a line on it: what a punch is from afar. The depth
//! coordinate grows into the body, forces press.

use fe_core::material::Elastic;
use std::f64::consts::PI;

/// Radial displacement and that into the depth [L] at the distance `r` from the force's axis and the depth `z`, under a
/// force [F]: u_r = P/(4πμR) [rz/R² − (1−2ν) r/(R+z)], u_z = P/(4πμR) [2(1−ν) + z²/R²], R² = r² + z² (Boussinesq;
/// Johnson, Contact Mechanics, 1985, §3.2).
pub fn at_a_point(elastic: Elastic, force: f64, r: f64, z: f64) -> [f64; 2] {
    let (nu, distance) = (elastic.poisson, r.hypot(z));
    let scale = force / (4.0 * PI * elastic.mu() * distance);
    let (sine, cosine) = (r / distance, z / distance);
    [scale * (sine * cosine - (1.0 - 2.0 * nu) * r / (distance + z)), scale * (2.0 * (1.0 - nu) + cosine * cosine)]
}

/// The same under a force per length [F/L], plane strain, at the side `x` and the depth `y`: of the surface
/// u_y = −(2P/πE*) ln |x|, the constant that the plane leaves open (Flamant; Johnson, 1985, §2.3).
pub fn along_a_line(elastic: Elastic, force: f64, x: f64, y: f64) -> [f64; 2] {
    let (nu, young) = (elastic.poisson, elastic.young);
    let (r, angle) = (x.hypot(y), x.atan2(y));
    let (sine, cosine) = angle.sin_cos();
    let first = 2.0 * (1.0 - nu * nu) * force / (PI * young);
    let second = (1.0 - 2.0 * nu) * (1.0 + nu) * force / (PI * young);
    let constant = (1.0 + nu) * force / (PI * young);
    let outward = -first * cosine * r.ln() - second * angle * sine + constant * cosine;
    let turning =
        first * sine * r.ln() + 2.0 * nu * constant * sine - second * angle * cosine + second * sine - constant * sine;
    // Along the radius and across it, the angle counted from the depth.
    [outward * sine + turning * cosine, outward * cosine - turning * sine]
}

#[cfg(test)]
mod tests {
    use super::*;

    const ELASTIC: Elastic = Elastic { young: 70e3, poisson: 0.3 };

    /// Navier's equations by differences of second order; their error is that of steps of 1e-3, 1e-6 of second
    /// derivatives. In the plane (λ+2μ) u_x,xx + μ u_x,yy + (λ+μ) u_y,xy = 0, and the same about the axis with hoop terms.
    #[test]
    fn equilibrium() {
        let (lambda, mu, e) = (ELASTIC.lambda(), ELASTIC.mu(), 1e-3);
        type Field = fn(Elastic, f64, f64, f64) -> [f64; 2];
        for (field, around) in [(at_a_point as Field, 1.0), (along_a_line as Field, 0.0)] {
            let (x, y) = (1.3, 0.7);
            let u = |i: i32, j: i32| field(ELASTIC, 1e3, x + f64::from(i) * e, y + f64::from(j) * e);
            let [here, left, right, down, up] = [u(0, 0), u(-1, 0), u(1, 0), u(0, -1), u(0, 1)];
            let second = |c: usize| [right[c] - 2.0 * here[c] + left[c], up[c] - 2.0 * here[c] + down[c]];
            let mixed = |c: usize| 0.25 * (u(1, 1)[c] - u(1, -1)[c] - u(-1, 1)[c] + u(-1, -1)[c]);
            let first = |c: usize| 0.5 * e * (right[c] - left[c]);
            let cross = 0.5 * e * (up[0] - down[0]);
            let radial = second(0)[0] + around * (first(0) / x - e * e * here[0] / (x * x));
            let across = (lambda + 2.0 * mu) * radial + mu * second(0)[1] + (lambda + mu) * mixed(1);
            let depth = (lambda + 2.0 * mu) * second(1)[1]
                + mu * (second(1)[0] + around * first(1) / x)
                + (lambda + mu) * (mixed(0) + around * cross / x);
            let size = (lambda + 2.0 * mu) * second(1)[1].abs();
            assert!(across.abs() < 1e-4 * size && depth.abs() < 1e-4 * size, "{around} {across} {depth} {size}");
        }
    }

    /// On the surface P (1−ν²)/(πE r), and −(2P/πE*) ln r.
    #[test]
    fn surface() {
        let modulus = ELASTIC.young / 0.91;
        for r in [0.5, 1.0, 3.0f64] {
            assert!((at_a_point(ELASTIC, 7.0, r, 0.0)[1] * PI * modulus * r / 7.0 - 1.0).abs() < 1e-14);
            let expected = -2.0 * 7.0 / (PI * modulus) * r.ln();
            assert!((along_a_line(ELASTIC, 7.0, r, 0.0)[1] - expected).abs() < 1e-18);
            assert_eq!(along_a_line(ELASTIC, 7.0, 0.0, r)[0], 0.0);
        }
    }
}
