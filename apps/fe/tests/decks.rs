//! Acceptance decks: each runs through the program, and what it prints is compared with the `** expect` lines of
//! its header (values from closed forms, given there; tolerances from the digits of the table).
#![allow(clippy::unwrap_used)]

mod common;

use common::Scratch;
use fe_io::results::read::{Table, tables};

macro_rules! decks {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            check(stringify!($name));
        })*
    };
}

decks! {
    beam_c3d8
    blocks_exponential
    blocks_linear_s2s
    blocks_node_based
    blocks_penalty_fields
    blocks_tabular
    crossing_beams
    explicit_bounce
    explicit_kinematic
    explicit_law_exponential
    explicit_law_linear
    explicit_oscillator
    friction_cycle
    gap_area
    gap_augmented
    gap_cylinder
    gap_exponential
    gap_hard
    gap_hard_penalty
    gap_linear
    gap_no_separation
    gap_sphere
    gap_tabular
    itt31_pipes
    mesh_gmsh_blocks
    parts_assembly
    patch_c3d8
    plane_stress_linear
    pressfit_axisymmetric
    thick_cylinder
    unit_rule
}

/// One `** expect` line: `table [SET] [label] comp N [at t=T]: value +- relative rel [+- absolute]`.
struct Expectation {
    table: &'static str,
    set: Option<String>,
    label: Option<u64>,
    component: usize,
    time: Option<f64>,
    value: f64,
    relative: f64,
    absolute: f64,
}

const TABLES: [&str; 7] = [
    "total force",
    "forces",
    "velocities",
    "contact stress",
    "relative contact displacement",
    "displacements",
    "stresses",
];

fn expectation(line: &str) -> Option<Expectation> {
    let text = line.strip_prefix("** expect")?.trim();
    let table = TABLES.into_iter().find(|t| text.starts_with(t))?;
    let (what, numbers) = text[table.len()..].split_once(": ").unwrap();
    // `on SET (what its number is)`.
    let what = match (what.find('('), what.find(')')) {
        (Some(start), Some(end)) => format!("{}{}", &what[..start], &what[end + 1..]),
        _ => what.to_owned(),
    };
    let words: Vec<&str> = what.split_whitespace().filter(|word| *word != "on").collect();
    let comp = words.iter().position(|w| *w == "comp").unwrap();
    let number = |text: &str| text.trim().trim_end_matches("rel").trim().parse::<f64>().unwrap();
    let mut parts = numbers.split("+-");
    let value = number(parts.next().unwrap());
    let (mut relative, mut absolute) = (0.0, 0.0);
    for part in parts {
        *(if part.contains("rel") { &mut relative } else { &mut absolute }) = number(part);
    }
    Some(Expectation {
        table,
        set: (comp > 0).then(|| words[0].to_string()),
        label: (comp > 1).then(|| words[1].parse().unwrap()),
        component: words[comp + 1].parse().unwrap(),
        time: words.iter().find_map(|w| w.strip_prefix("t=")).map(|t| t.parse().unwrap()),
        value,
        relative,
        absolute,
    })
}

fn check(name: &str) {
    let scratch = Scratch::with_decks(name);
    let deck = format!("{name}.inp");
    let run = scratch.fe(&["run", &deck, "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.error);
    let blocks = tables(&scratch.read(&format!("{name}.dat"))).unwrap();
    let mut count = 0;
    for line in scratch.read(&deck).lines().filter(|l| l.starts_with("** expect")) {
        let Some(e) = expectation(line) else { continue };
        let fits = |b: &&Table| b.title.starts_with(e.table) && e.set.as_ref().is_none_or(|s| *s == b.set);
        let found: Vec<&Table> = blocks.iter().filter(fits).collect();
        let time = e.time.unwrap_or_else(|| found.last().unwrap_or_else(|| panic!("{line}: no table")).time);
        // Headers give times to five digits.
        let rows = found.iter().filter(|b| (b.time - time).abs() <= 5e-6 * time.abs()).flat_map(|b| &b.rows);
        let rows: Vec<_> = rows.filter(|r| e.label.is_none_or(|l| r.labels.first() == Some(&l))).collect();
        assert!(!rows.is_empty(), "{line}: no row at time {time}");
        for row in rows {
            let got = row.values[e.component - 1];
            let allowed = e.relative * e.value.abs() + e.absolute;
            assert!((got - e.value).abs() <= allowed, "{line}: got {got}");
            count += 1;
        }
    }
    assert!(count > 0, "no expectation was checked");
}

/// Bad decks are refused with the line and the words that their headers expect, and leave no results.
#[test]
fn bad_decks() {
    for (name, lines, words) in [
        ("bad_card_name", 23..=23, &["`BOUNDARY`"][..]),
        ("bad_no_separation_softened", 19..=20, &["NO SEPARATION", "softened"]),
        ("bad_scale_factor_standard", 19..=20, &["SCALE FACTOR", "general contact in Explicit"]),
    ] {
        let scratch = Scratch::with_decks(name);
        let run = scratch.fe(&["run", &format!("{name}.inp"), "--quiet"]);
        assert_eq!(run.status, 1, "{name}");
        let placed = lines.clone().any(|line| run.error.contains(&format!("{name}.inp:{line}:")));
        assert!(placed && words.iter().all(|word| run.error.contains(word)), "{name}: {}", run.error);
        assert!(!scratch.path(&format!("{name}.vtkhdf")).exists(), "{name}");
    }
}
