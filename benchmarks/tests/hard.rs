//! The hard cases: what must happen happens in every scene.

use benchmarks::hard::{CASES, Verdict, place_of};
use std::path::Path;

/// Scenes that failed, with what is wrong.
fn failures(slow: bool) -> Vec<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(if slow { "hard_slow" } else { "hard" });
    let mut failures = Vec::new();
    for case in CASES {
        for (number, scene) in (case.scenes)().iter().enumerate().filter(|(_, scene)| scene.slow == slow) {
            let finding = scene.finding(&place_of(&folder, case, number));
            if finding.verdict() == Verdict::Failed {
                failures.push(format!("{} {}: {:#?}", case.id, scene.name, finding.faults()));
            }
        }
    }
    failures
}

#[test]
fn quick_scenes() {
    let failures = failures(false);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
#[ignore = "a minute, in release"]
fn slow_scenes() {
    let failures = failures(true);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
