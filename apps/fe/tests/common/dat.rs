//! Reads the tables of a `.dat` file.

/// One table.
pub struct Block {
    /// The header up to ` for set`, ` for all` or ` and time`.
    pub title: String,
    /// Name of the set, if any; `SECONDARY, MAIN` for the force of a pair.
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
            blocks.push(header(line, blocks.last()));
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

/// A table's first line; a caption within the statistics of a pair goes on from the line before.
fn header(line: &str, before: Option<&Block>) -> Block {
    let block = |title: &str, set: String, time| Block { title: title.trim().into(), set, time, rows: Vec::new() };
    let timed = line.rsplit_once("and time").and_then(|(head, time)| Some((head, time.trim().parse().ok()?)));
    let Some((head, time)) = timed else {
        let before = before.unwrap_or_else(|| panic!("no time in '{line}'"));
        return block(line, before.set.clone(), before.time);
    };
    if let Some(pair) = head.trim().strip_prefix("statistics for slave set ") {
        return block("statistics", pair.replace("master set ", ""), time);
    }
    match head.split_once("for set ").or_else(|| head.split_once("forset ")) {
        Some((title, rest)) => block(title, rest.trim().into(), time),
        None => block(head, String::new(), time),
    }
}
