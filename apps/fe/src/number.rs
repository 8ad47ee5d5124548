//! Numbers as engineers print them.

/// `1.2346e-03`: a digit, `digits` more, and an exponent of two digits with its sign.
pub fn scientific(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$e}");
    match text.split_once('e') {
        Some((mantissa, exponent)) => {
            let (sign, exponent) = exponent.strip_prefix('-').map_or(('+', exponent), |rest| ('-', rest));
            format!("{mantissa}e{sign}{exponent:0>2}")
        }
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_have_sign_and_two_digits() {
        assert_eq!(scientific(0.0012345, 3), "1.234e-03");
        assert_eq!(scientific(-2.0, 1), "-2.0e+00");
        assert_eq!(scientific(1e-123, 0), "1e-123");
        assert_eq!(scientific(f64::NAN, 2), "NaN");
    }
}
