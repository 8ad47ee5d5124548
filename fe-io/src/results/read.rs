//! Reads the tables of a `.dat` file, ours or CalculiX's.

/// One table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The header up to ` for set`, ` for all` or ` and time`.
    pub title: String,
    /// Name of the set, if any; `SECONDARY, MAIN` for the force of a pair.
    pub set: String,
    /// Total time [T].
    pub time: f64,
    /// Rows.
    pub rows: Vec<Row>,
}

/// One row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Leading whole numbers: labels, and integration points.
    pub labels: Vec<u64>,
    /// Numbers.
    pub values: Vec<f64>,
}

/// All tables of a file in order; the error names the line that is none of a table.
pub fn tables(text: &str) -> Result<Vec<Table>, String> {
    let mut tables: Vec<Table> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        let fault = |what: &str| format!("line {}: {what}: '{line}'", index + 1);
        if line.is_empty() {
            continue;
        }
        if line.starts_with(|c: char| c.is_ascii_alphabetic()) {
            tables.push(header(line, tables.last()).ok_or_else(|| fault("a header without a time"))?);
            continue;
        }
        let table = tables.last_mut().ok_or_else(|| fault("a row before the first header"))?;
        table.rows.push(row(line).ok_or_else(|| fault("no row of numbers"))?);
    }
    Ok(tables)
}

fn row(line: &str) -> Option<Row> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let labels: Vec<u64> = words.iter().map_while(|word| word.parse().ok()).collect();
    let values = words[labels.len()..].iter().map(|word| word.parse().ok()).collect::<Option<_>>()?;
    Some(Row { labels, values })
}

/// A table's first line; a caption within the statistics of a pair goes on from the line before.
fn header(line: &str, before: Option<&Table>) -> Option<Table> {
    let table = |title: &str, set: String, time| Table { title: title.trim().into(), set, time, rows: Vec::new() };
    let timed = line.rsplit_once("and time").and_then(|(head, time)| Some((head, time.trim().parse().ok()?)));
    let Some((head, time)) = timed else {
        let before = before?;
        return Some(table(line, before.set.clone(), before.time));
    };
    if let Some(pair) = head.trim().strip_prefix("statistics for slave set ") {
        return Some(table("statistics", pair.replace("master set ", ""), time));
    }
    Some(match head.split_once("for set ").or_else(|| head.split_once("forset ")) {
        Some((title, rest)) => table(title, rest.trim().into(), time),
        None => table(head.split("for all").next().unwrap_or(head), String::new(), time),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_none_of_a_table_is_named() {
        let text = " displacements (vx,vy,vz) for set TIP and time  0.1000000E+01\n\n  7  1.0E+00 -2.5E-03 0.0E+00\n";
        let read = tables(text).unwrap();
        assert_eq!((read.len(), read[0].set.as_str(), read[0].time), (1, "TIP", 1.0));
        assert_eq!(read[0].rows, [Row { labels: vec![7], values: vec![1.0, -2.5e-3, 0.0] }]);
        assert_eq!(tables(" 7 1.0\n").unwrap_err(), "line 1: a row before the first header: '7 1.0'");
        assert_eq!(tables(&format!("{text} 8 1.0 x\n")).unwrap_err(), "line 4: no row of numbers: '8 1.0 x'");
    }
}
