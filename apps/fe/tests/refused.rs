//! What the program refuses: status 1, a message with file and line, no panic, and no results left behind.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Run, Scratch};
use std::path::Path;

/// Names of the files in a folder that a job leaves or builds.
fn results_in(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    names.filter(|n| n.contains(".vtkhdf") || n.ends_with(".dat")).collect()
}

/// What is wrong with a refusal that should hold `words`.
fn objection(run: &Run, words: &[&str], scratch: &Scratch) -> Option<String> {
    let missing = words.iter().find(|w| !run.error.contains(**w));
    let left = results_in(&scratch.path(""));
    let sound = run.status == 1 && missing.is_none() && !run.error.contains("panicked") && left.is_empty();
    (!sound).then(|| format!("status {}, without {missing:?}, left {left:?}: {}", run.status, run.error))
}

/// Every deck that the reader refuses is refused by `fe run` and by `fe check`, with its own name and a line.
#[test]
fn faulty_decks() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fe-io/tests/bad");
    let scratch = Scratch::new("refused_decks");
    let mut names: Vec<String> = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if name.ends_with(".inp") {
            std::fs::copy(&path, scratch.path(&name)).unwrap();
            names.push(name);
        }
    }
    assert!(names.len() >= 50, "{}", names.len());
    let mut objections = Vec::new();
    for name in &names {
        for command in ["run", "check"] {
            let run = scratch.fe(&[command, name]);
            objections.extend(objection(&run, &["error: ", "the deck has"], &scratch).map(|o| format!("{name}: {o}")));
            // `file:line:column` stands under each message.
            let place = format!("{name}:");
            let line = run.error.split(&place).skip(1).find_map(|rest| rest.split(':').next()?.parse::<u32>().ok());
            if line.is_none() {
                objections.push(format!("{command} {name}: no line: {}", run.error));
            }
        }
    }
    assert!(objections.is_empty(), "{objections:#?}");
}

/// A deck that ends like the results keeps its text.
#[test]
fn results_never_replace_the_deck() {
    let scratch = Scratch::with_decks("refused_replacing");
    let deck = scratch.read("patch_c3d8.inp");
    scratch.write("whole.dat", &deck);
    scratch.write("half.dat", &deck);
    scratch.write("half.inp", "*INCLUDE, INPUT=half.dat\n");
    for (name, lost) in [("whole.dat", "whole.dat"), ("half.inp", "half.dat")] {
        let run = scratch.fe(&["run", name]);
        assert_eq!(run.status, 1);
        let words = format!("`{lost}` is part of the deck");
        assert!(run.error.contains(&words), "{}", run.error);
        assert_eq!(scratch.read(lost), deck);
    }
}

/// Files that cannot be read or written: what cannot, and why.
#[test]
fn files_that_cannot_be_used() {
    let scratch = Scratch::new("refused_files");
    scratch.write("deck.inp", &std::fs::read_to_string(patch()).unwrap());
    std::fs::create_dir(scratch.path("folder")).unwrap();
    let words = |run: Run, words: &[&str]| {
        let found = words.iter().all(|w| run.error.contains(w)) && !run.error.contains("panicked");
        assert!(run.status == 1 && found, "{words:?}: {}", run.error);
    };
    words(scratch.fe(&["run", "none.inp"]), &["`none.inp` cannot be read: there is no such file"]);
    words(scratch.fe(&["check", "none.inp"]), &["`none.inp` cannot be read: there is no such file"]);
    words(scratch.fe(&["run", "folder"]), &["`folder` cannot be read: it is no file"]);
    words(scratch.fe(&["run", "folder/none.inp"]), &["`folder/none.inp` cannot be read"]);
    // A folder in the place of a file refuses every user, the system's own included.
    for name in ["deck.dat", "deck.vtkhdf.unfinished", "deck.vtkhdf"] {
        std::fs::create_dir(scratch.path(name)).unwrap();
        words(scratch.fe(&["run", "deck.inp", "--quiet"]), &[name]);
        std::fs::remove_dir(scratch.path(name)).unwrap();
        let left = results_in(&scratch.path("")).into_iter().find(|n| n != "deck.dat");
        assert_eq!(left, None, "after {name}");
    }
    assert_eq!(scratch.fe(&["run", "deck.inp", "--quiet"]).status, 0);
}

fn patch() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/decks/patch_c3d8.inp")
}

/// A folder that the user may not write into. Where the system lets this user write everywhere, nothing is shown.
#[cfg(unix)]
#[test]
fn a_folder_without_write_permission() {
    use std::os::unix::fs::PermissionsExt;
    let scratch = Scratch::new("refused_folder");
    let folder = scratch.path("shut");
    std::fs::create_dir(&folder).unwrap();
    std::fs::copy(patch(), folder.join("deck.inp")).unwrap();
    std::fs::set_permissions(&folder, std::fs::Permissions::from_mode(0o555)).unwrap();
    let writes_everywhere = std::fs::write(folder.join("probe"), "").is_ok();
    let run = scratch.fe(&["run", "shut/deck.inp"]);
    std::fs::set_permissions(&folder, std::fs::Permissions::from_mode(0o755)).unwrap();
    if !writes_everywhere {
        assert_eq!(run.status, 1);
        assert!(run.error.contains("deck.vtkhdf") && !run.error.contains("panicked"), "{}", run.error);
        assert!(results_in(&folder).is_empty());
    }
}

/// Status and words of wrong and right uses of the command line.
#[test]
fn command_line() {
    let scratch = Scratch::new("refused_usage");
    let refused: &[(&[&str], &str)] = &[
        (&[], "Usage: fe"),
        (&["run"], "<DECK>"),
        (&["check"], "<DECK>"),
        (&["solve", "x.inp"], "solve"),
        (&["run", "x.inp", "y.inp"], "y.inp"),
        (&["run", "x.inp", "--fast"], "--fast"),
        (&["run", "x.inp", "--threads", "0"], "at least one thread"),
        (&["run", "x.inp", "--threads", "many"], "many"),
        (&["run", "x.inp", "--threads=-1"], "-1"),
        (&["--log", "loud", "keywords"], "loud"),
        (&["keywords", "BOUNDRY"], "did you mean *BOUNDARY?"),
    ];
    for (arguments, words) in refused {
        let run = scratch.fe(arguments);
        assert!(run.status == 1 && run.error.contains(words), "{arguments:?}: {}", run.error);
        assert!(run.output.is_empty(), "{arguments:?}: {}", run.output);
    }
    let version = concat!("fe ", env!("CARGO_PKG_VERSION"));
    let fine: &[(&[&str], &str)] = &[
        (&["--help"], "keyword deck"),
        (&["help"], "keyword deck"),
        (&["run", "--help"], "--quiet"),
        (&["check", "--help"], "<DECK>"),
        (&["--version"], version),
        (&["keywords"], "*CONTACT PAIR"),
    ];
    for (arguments, words) in fine {
        let run = scratch.fe(arguments);
        assert!(run.status == 0 && run.output.contains(words), "{arguments:?}: {}{}", run.output, run.error);
        assert!(run.error.is_empty(), "{arguments:?}: {}", run.error);
    }
}

/// What fails in a run is named by its instance, too: both cubes have a node 1, the second one is held by nothing.
#[test]
fn what_fails_in_an_instance_is_named_by_it() {
    let scratch = Scratch::with_decks("refused_instance");
    let deck = scratch.read("parts_assembly.inp");
    let deck = deck.replace("TWO.NB, 1, 2\n", "").replace("TOP, 3, 3, -0.08\n", "TWO.20, 3, 3, -0.08\n");
    scratch.write("loose.inp", &deck);
    let run = scratch.fe(&["run", "loose.inp", "--quiet"]);
    assert_eq!(run.status, 1);
    assert!(run.error.contains("TWO."), "{}", run.error);
}

/// What explicit steps do not have yet is named with its place.
#[test]
fn explicit_steps() {
    let scratch = Scratch::new("refused_explicit");
    let deck = include_str!("../../../fe-io/tests/good/explicit_bounce.inp");
    let pair = "*CONTACT PAIR, INTERACTION=I, MECHANICAL CONSTRAINT=PENALTY\nBALLS, WALLS\n";
    let damped = deck.replace(", MECHANICAL CONSTRAINT=PENALTY", "").replace("FRACTION\n0.,", "FRACTION\n0.1,");
    let damped = damped.replace("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100000.,\n", "");
    let general = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n,, I\n";
    let general = deck.replace(pair, general).replace("=LINEAR", "=LINEAR, NO SEPARATION");
    let rigid = deck.replace(", MECHANICAL CONSTRAINT=PENALTY", "").replace("TYPE=NODE\nBALL,", "TYPE=NODE\nREF,");
    let refused = [
        (rigid, "kinematic contact of two rigid bodies (node 9 is of one", "job.inp:43"),
        (general, "NO SEPARATION of interaction I in general contact is not there yet", "job.inp:39"),
        (damped, "damping of hard kinematic contact, which takes the energy of what hits, is not there", "job.inp:41"),
    ];
    for (deck, what, place) in refused {
        scratch.write("job.inp", &deck);
        for command in ["run", "check"] {
            let run = scratch.fe(&[command, "job.inp"]);
            assert_eq!(objection(&run, &[what, place], &scratch), None);
        }
    }
    scratch.write(
        "job.inp",
        "*NODE, NSET=N\n1, 0., 0.\n2, 1., 0.\n3, 1., 1.\n4, 0., 1.\n*ELEMENT, TYPE=CPS4, ELSET=E\n1, 1, 2, 3, 4\n\
         *MATERIAL, NAME=STEEL\n*ELASTIC\n1., 0.3\n*DENSITY\n1.\n*SOLID SECTION, ELSET=E, MATERIAL=STEEL\n*BOUNDARY\nN, 1\n\
         *STEP\n*DYNAMIC, EXPLICIT\n, 1.\n*END STEP\n",
    );
    let run = scratch.fe(&["run", "job.inp"]);
    assert_eq!(objection(&run, &["elements CPS4 of material STEEL are not there", "CPS4R"], &scratch), None);
}
