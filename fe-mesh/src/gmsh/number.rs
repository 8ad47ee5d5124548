//! Decimal text to the nearest double.

/// 10⁰ … 10²²: the powers of ten that a double holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The number at the start of `text`, correctly rounded, and its length [bytes]; `None` when the first word is no
/// number. `nan` and `inf` are numbers here.
pub(super) fn float(text: &[u8]) -> Option<(f64, usize)> {
    exact(text).or_else(|| {
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        let word = std::str::from_utf8(&text[..end]).ok()?;
        Some((word.parse().ok()?, end))
    })
}

/// Numbers whose digits and power of ten are both exact doubles, so that one multiplication or division rounds
/// correctly (Clinger 1990); `None` for all others.
fn exact(text: &[u8]) -> Option<(f64, usize)> {
    let byte = |at: usize| text.get(at).copied().unwrap_or(b' ');
    let negative = byte(0) == b'-';
    let mut at = negative as usize;
    let start = at;
    let mut digits = 0u64;
    let mut power = 0i64;
    while byte(at).is_ascii_digit() {
        digits = digits.wrapping_mul(10).wrapping_add((byte(at) - b'0') as u64);
        at += 1;
    }
    let mut count = at - start;
    if byte(at) == b'.' {
        let point = at;
        at += 1;
        while byte(at).is_ascii_digit() {
            digits = digits.wrapping_mul(10).wrapping_add((byte(at) - b'0') as u64);
            at += 1;
        }
        let decimals = at - point - 1;
        count += decimals;
        power = -(decimals as i64);
    }
    // Nineteen digits fit into the integer whatever they are; leading zeros are counted, which only costs speed.
    if count == 0 || count > 19 {
        return None;
    }
    if matches!(byte(at), b'e' | b'E') {
        let (exponent, length) = exponent(&text[at + 1..])?;
        power += exponent;
        at += 1 + length;
    }
    if digits > 1 << 53 || power.abs() > 22 || !byte(at).is_ascii_whitespace() {
        return None;
    }
    let scale = POWERS[power.unsigned_abs() as usize];
    let magnitude = if power < 0 { digits as f64 / scale } else { digits as f64 * scale };
    Some((if negative { -magnitude } else { magnitude }, at))
}

/// The exponent after `e`: value and length; at most three digits.
fn exponent(text: &[u8]) -> Option<(i64, usize)> {
    let byte = |at: usize| text.get(at).copied().unwrap_or(b' ');
    let start = matches!(byte(0), b'-' | b'+') as usize;
    let mut at = start;
    let mut value = 0i64;
    while byte(at).is_ascii_digit() && at < start + 4 {
        value = 10 * value + (byte(at) - b'0') as i64;
        at += 1;
    }
    (at > start && at <= start + 3).then_some((if byte(0) == b'-' { -value } else { value }, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The nearest double, bit for bit what the standard library gives, for numbers of every length and size:
    /// the exact path and the other one meet between 2⁵³ and 10²².
    #[test]
    fn agrees_with_the_standard_library() {
        let mut state = 7u64;
        for i in 0..200_000 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let value = match i % 4 {
                0 => f64::from_bits(state),
                1 => (state >> 11) as f64 / (1u64 << 53) as f64,
                2 => ((state >> 40) as f64 - 8e6) / 1000.0,
                _ => (state >> 20) as f64 * 1e-18,
            };
            if !value.is_finite() {
                continue;
            }
            for word in [format!("{value}"), format!("{value:e}"), format!("{value:.7}"), format!("{value:.16e}")] {
                let want: f64 = word.parse().unwrap();
                let (got, length) = float(format!("{word} 1").as_bytes()).unwrap();
                assert_eq!((got.to_bits(), length), (want.to_bits(), word.len()), "{word}");
            }
        }
    }

    /// What is no number is none; signs, points and exponents at the edge of the grammar.
    #[test]
    fn grammar() {
        for bad in ["", " ", "-", ".", "e5", "1e", "1e+", "1.5x", "0x10", "1,5", "--1", "1.2.3"] {
            assert_eq!(float(bad.as_bytes()), None, "{bad}");
        }
        for (good, value) in [("5", 5.0), ("-.5", -0.5), ("1.", 1.0), ("+2", 2.0), ("1E-03", 1e-3), ("1e+0005", 1e5)] {
            assert_eq!(float(good.as_bytes()), Some((value, good.len())), "{good}");
        }
        assert_eq!(float(b"-0").map(|(v, _)| v.is_sign_negative()), Some(true));
        assert!(float(b"nan").is_some_and(|(v, _)| v.is_nan()));
    }
}
