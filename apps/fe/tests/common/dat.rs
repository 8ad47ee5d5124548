//! Reads the tables of a `.dat` file.

/// One table.
pub struct Block {
    /// The header up to ` for set`, ` for all` or ` and time`.
    pub title: String,
    /// Name of the set, if any.
    pub set: String,
    /// Total time.
    pub time: f64,
    /// Rows.
    pub rows: Vec<Row>,
}

/// One row.
#[derive(Debug)]
pub struct Row {
    /// Leading integers: labels, and integration points.
    pub labels: Vec<u64>,
    /// Numbers.
    pub values: Vec<f64>,
}

/// All tables in order.
pub fn read(text: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for line in text.lines().map(str::trim).filter(|l| !l.is_empty()) {
        if line.starts_with(|c: char| c.is_ascii_alphabetic()) {
            let (head, time) = line.rsplit_once("time").unwrap_or_else(|| panic!("no time in '{line}'"));
            let (title, set) = match head.split_once("for set ").or_else(|| head.split_once("forset ")) {
                Some((title, rest)) => (title, rest.split_whitespace().next().unwrap()),
                None => (head, ""),
            };
            let time = time.trim().parse().unwrap();
            blocks.push(Block { title: title.trim().into(), set: set.into(), time, rows: Vec::new() });
            continue;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let count = words.iter().take_while(|w| w.parse::<u64>().is_ok()).count();
        blocks.last_mut().expect("a header before the rows").rows.push(Row {
            labels: words[..count].iter().map(|w| w.parse().unwrap()).collect(),
            values: words[count..].iter().map(|w| w.parse().unwrap()).collect(),
        });
    }
    blocks
}
