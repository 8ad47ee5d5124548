//! The nearest known word to one that is not known.

/// Edit distance (insert, delete, replace, swap of neighbours), letters in any case.
fn distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|s| s.to_uppercase().chars().collect::<Vec<_>>());
    let mut rows = vec![vec![0usize; b.len() + 1]; a.len() + 1];
    rows[0].iter_mut().enumerate().for_each(|(j, d)| *d = j);
    for i in 1..=a.len() {
        rows[i][0] = i;
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

/// The nearest of the known words, if it is near enough to be meant: at most a third of the letters differ, or
/// the word is the beginning of just one of them. The first wins a draw.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.chars().count() > 80 {
        return None;
    }
    let allowed = (word.chars().count() / 3).max(1);
    let known: Vec<&str> = known.into_iter().collect();
    let best = known.iter().copied().map(|k| (distance(word, k), k)).min_by_key(|(d, _)| *d);
    if let Some((d, k)) = best
        && d <= allowed
        && d < k.chars().count()
    {
        return Some(k);
    }
    let mut longer = known.into_iter().filter(|k| word.len() > 2 && k.to_uppercase().starts_with(&word.to_uppercase()));
    longer.next().filter(|_| longer.next().is_none())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_found_far_ones_are_not() {
        let known = ["BOUNDARY", "NODE", "NODE PRINT", "ELASTIC", "CONTACT PAIR"];
        assert_eq!(nearest("BOUNDRY", known), Some("BOUNDARY"));
        assert_eq!(nearest("BUONDARY", known), Some("BOUNDARY"));
        assert_eq!(nearest("CONTACT", known), Some("CONTACT PAIR"));
        assert_eq!(nearest("elastik", known), Some("ELASTIC"));
        assert_eq!(nearest("VISCO", known), None);
        assert_eq!(nearest("X", ["A"]), None);
        assert_eq!(nearest(&"A".repeat(5000), known), None);
    }
}
