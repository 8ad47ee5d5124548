//! Numbers as decks write them.

/// A finite number: `1`, `1.`, `.5`, `-1e3`, also the Fortran exponent `1.0D+3`. Words such as `nan` or `inf`, and
/// numbers beyond the range, are none.
pub fn number(text: &str) -> Option<f64> {
    let value = match text.parse::<f64>() {
        Ok(value) => value,
        Err(_) if text.contains(['d', 'D']) => text.replace(['d', 'D'], "e").parse().ok()?,
        Err(_) => return None,
    };
    value.is_finite().then_some(value)
}

/// A whole number, not negative. Labels are such.
pub fn whole(text: &str) -> Option<u64> {
    let bytes = text.as_bytes();
    if bytes.is_empty() || bytes.len() > 18 {
        return None;
    }
    bytes.iter().try_fold(0u64, |n, b| b.is_ascii_digit().then(|| n * 10 + u64::from(b - b'0')))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deck_numbers() {
        for (text, value) in [("1", 1.0), ("1.", 1.0), (".5", 0.5), ("-1e3", -1e3), ("+2.5E-1", 0.25), ("1.0D+3", 1e3)]
        {
            assert_eq!(number(text), Some(value), "{text}");
        }
        for text in ["", "nan", "inf", "-infinity", "1e999", "1,0", "1 0", "d", "0x1", "1..", "LOW"] {
            assert_eq!(number(text), None, "{text}");
        }
        assert_eq!(whole("0012"), Some(12));
        assert_eq!(["", "-1", "1.", "9999999999999999999", "１"].map(whole), [None; 5]);
    }
}
