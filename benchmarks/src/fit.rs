//! Rates: straight lines through points in log–log.

/// Slope of ln y over ln x by least squares; the error's rate where x is the mesh size. NaN of fewer than two points.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let (x, y) = logs.iter().fold((0.0, 0.0), |mean, p| (mean.0 + p.0 / count, mean.1 + p.1 / count));
    logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / logs.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

/// Work at which the error falls to `error`, by the straight line in log–log between the two neighbouring points of
/// (work, error); `None` where no two points enclose it.
pub fn work_for(points: &[(f64, f64)], error: f64) -> Option<f64> {
    let pair = points.windows(2).find(|pair| pair[0].1 >= error && pair[1].1 <= error)?;
    let [(w0, e0), (w1, e1)] = [pair[0], pair[1]].map(|(w, e)| (w.ln(), e.ln()));
    let part = if e1 < e0 { (error.ln() - e0) / (e1 - e0) } else { 0.0 };
    Some((w0 + part * (w1 - w0)).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found_exactly() {
        let points: Vec<(f64, f64)> = [1.0, 2.0, 4.0, 9.0].map(|x: f64| (x, 3.0 * x.powf(1.5))).to_vec();
        assert!((slope(&points) - 1.5).abs() < 1e-14);
        let falling: Vec<(f64, f64)> = [1.0, 10.0, 100.0].map(|w: f64| (w, 0.2 / w)).to_vec();
        assert!((work_for(&falling, 0.01).unwrap() - 20.0).abs() < 1e-12);
        assert!(work_for(&falling, 1e-4).is_none() && work_for(&falling, 1.0).is_none());
    }
}
