//! What explicit steps print and store, and when.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::Job;

/// A truss of ten elements that is let go with a velocity at its end.
fn bar(steps: &str) -> String {
    let mut deck = String::from("*NODE, NSET=ALL\n");
    (0..=10).for_each(|i| deck += &format!("{}, {}., 0.\n", i + 1, i));
    deck += "*NSET, NSET=END\n11\n*NSET, NSET=FOOT\n1\n*ELEMENT, TYPE=T2D2, ELSET=BAR\n";
    (1..=10).for_each(|i| deck += &format!("{i}, {i}, {}\n", i + 1));
    deck += "*MATERIAL, NAME=M\n*ELASTIC\n1., 0.\n*DENSITY\n1.\n*SOLID SECTION, ELSET=BAR, MATERIAL=M\n1.\n\
             *BOUNDARY\nFOOT, 1, 1\nALL, 2, 2\n*INITIAL CONDITIONS, TYPE=VELOCITY\nEND, 1, 0.01\n";
    deck + steps
}

/// FREQUENCY prints every so many increments and the last one; without it the end of the step alone.
#[test]
fn tables_come_as_often_as_they_say() {
    let deck = bar("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n*NODE PRINT, NSET=END, FREQUENCY=8\nU\n\
                    *NODE PRINT, NSET=FOOT\nRF\n*NODE PRINT, NSET=FOOT, FREQUENCY=0\nV\n*END STEP\n");
    let tables = Job::run("explicit_tables", &deck).tables();
    let times = |set: &str| -> Vec<f64> { tables.iter().filter(|t| t.set == set).map(|t| t.time).collect() };
    assert_eq!((times("END"), times("FOOT")), (vec![4.0, 8.0, 10.0], vec![10.0]));
}

/// Rows of a history, each without time, step, increment.
fn rows(job: &Job, name: &str, columns: usize) -> Vec<(f64, Vec<f64>)> {
    let all = job.results().real(&format!("Signorini/History/{name}"));
    all.chunks_exact(3 + columns).map(|row| (row[0], row[3..].to_vec())).collect()
}

/// Columns of the energies.
const ENERGIES: usize = 12;
const DISSIPATED: usize = 5;

/// `*BULK VISCOSITY` of a later step holds from there on: with none nothing more is dissipated, and the same before it.
#[test]
fn bulk_viscosity_changes_from_step_to_step() {
    let step = |cards: &str| {
        let output = "*OUTPUT, FIELD, NUMBER INTERVAL=1\n*OUTPUT, HISTORY, NUMBER INTERVAL=1\n*ENERGY OUTPUT\nALLVD\n";
        format!("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n{cards}{output}*END STEP\n")
    };
    let dissipated = |name: &str, second: &str| -> Vec<f64> {
        let job = Job::run(name, &bar(&(step("*BULK VISCOSITY\n0.1\n") + &step(second))));
        rows(&job, "Energies", ENERGIES).into_iter().map(|(_, row)| row[DISSIPATED]).collect()
    };
    let off = dissipated("viscosity_off", "*BULK VISCOSITY\n0., 0.\n");
    let on = dissipated("viscosity_on", "");
    assert_eq!((off.len(), off[1]), (3, on[1]));
    assert!(off[1] > 0.0 && off[2] == off[1] && on[2] > 1.1 * on[1], "{off:?} {on:?}");
}

/// Histories come as often as they say, whatever fields and tables do, and say the same as these; energies are balanced.
#[test]
fn histories_come_as_often_as_they_say() {
    let deck = bar("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n*BULK VISCOSITY\n0., 0.\n\
                    *OUTPUT, FIELD, NUMBER INTERVAL=2\n*NODE OUTPUT\nU, V\n\
                    *OUTPUT, HISTORY, TIME INTERVAL=2.\n*NODE OUTPUT, NSET=END\nU, V1\n\
                    *OUTPUT, HISTORY, FREQUENCY=5\n*NODE OUTPUT, NSET=FOOT\nRF1\n*ENERGY OUTPUT\nALLKE, ETOTAL\n\
                    *NODE PRINT, NSET=END, FREQUENCY=4\nU, V\n*END STEP\n");
    let job = Job::run("explicit_histories", &deck);
    let times = |rows: &[(f64, Vec<f64>)]| rows.iter().map(|row| row.0).collect::<Vec<_>>();
    let ends = rows(&job, "U of END", 3);
    assert_eq!(times(&ends), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
    // Tables hold ten digits.
    let printed = job.all("displacements", "END", 1);
    assert_eq!(printed.len(), 5);
    for (row, printed) in ends[1..].iter().zip(printed) {
        assert!((row.1[0] - printed).abs() < 1e-9 * printed.abs(), "{row:?} {printed}");
    }
    let speeds = rows(&job, "V1 of END", 1);
    let results = job.results();
    let end = results.point_at([10.0, 0.0, 0.0]);
    let frame = results.point_field("V", 3, 2);
    assert_eq!((results.times(), speeds[5].1[0]), (vec![0.0, 5.0, 10.0], frame[3 * end]));
    assert_eq!(times(&rows(&job, "RF1 of FOOT", 1)), [0.0, 2.5, 5.0, 7.5, 10.0]);
    let energies = rows(&job, "Energies", ENERGIES);
    assert_eq!(times(&energies), [0.0, 2.5, 5.0, 7.5, 10.0]);
    for (time, row) in &energies {
        let [kinetic, strain, .., total, dt] = row[..] else { panic!() };
        // Nothing but trusses that hardly stretch (linear to 1e-2): ETOTAL is rounding and that.
        assert!(kinetic > 0.0 && strain >= 0.0 && total.abs() < 1e-3 * energies[0].1[0], "{time} {row:?}");
        assert!(*time == 0.0 || dt == 0.5);
    }
}

/// The certificate says where the time of the increments has gone, in shares that make up the whole; the results file has the
/// same seconds.
#[test]
fn the_time_of_increments_is_told_by_what_took_it() {
    let contact = "*SURFACE, NAME=TIP, TYPE=NODE\nEND\n*NODE, NSET=REF\n12, 10.2, 0.\n*SURFACE, NAME=WALL, TYPE=SEGMENTS\n\
                   START, 10.01, -1.\nLINE, 10.01, 1.\n*RIGID BODY, ANALYTICAL SURFACE=WALL, REF NODE=12\n\
                   *BOUNDARY\nREF, 1, 6\n";
    let deck = bar(&format!(
        "{contact}*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.01, 100.\n\
         *CONTACT PAIR, MECHANICAL CONSTRAINT=PENALTY\nTIP, WALL\n*OUTPUT, FIELD, NUMBER INTERVAL=1\n*END STEP\n"
    ));
    let job = Job::run("explicit_seconds", &deck);
    let line = job.told.lines().find_map(|line| line.trim().strip_prefix("of that")).unwrap();
    let parts = line.trim().split("; ").map(|part| part.split_once(" % ").unwrap());
    let shares: Vec<(f64, &str)> = parts.map(|(share, of)| (share.parse().unwrap(), of)).collect();
    // Each is rounded to a tenth.
    let sum: f64 = shares.iter().map(|share| share.0).sum();
    assert!((sum - 100.0).abs() <= 0.05 * shares.len() as f64 + 1e-9, "{line}");
    assert!(shares.iter().all(|share| share.0 >= 0.0), "{line}");
    let run = rows(&job, "Run", 9);
    let [(_, row)] = &run[..] else { panic!("{run:?}") };
    let [increments, elements, read, all, others, contact, write, total, _] = row[..] else { panic!() };
    assert_eq!((increments, elements), (10_000.0, 10.0));
    let of = |name: &str| shares.iter().find(|share| share.1 == name).map(|share| share.0);
    // What takes less than a hundredth is not told by itself.
    match of("TIP on WALL") {
        Some(share) => assert!((100.0 * contact / all - share).abs() <= 0.05 + 1e-9, "{line} {row:?}"),
        None => assert!(contact < 0.01 * all, "{line} {row:?}"),
    }
    let elements = of("trusses, beams, springs and masses").unwrap_or(0.0);
    assert!(100.0 * others / all >= elements - 0.05, "{line} {row:?}");
    assert!(read + all <= total && others + contact <= all && write <= total, "{row:?}");
}

/// A card below `*OUTPUT, HISTORY` may say its own FREQUENCY, which holds for it alone.
#[test]
fn a_card_below_a_history_has_its_own_frequency() {
    let deck = bar("*STEP\n*DYNAMIC, EXPLICIT, DIRECT USER CONTROL\n0.5, 10.\n*OUTPUT, HISTORY, TIME INTERVAL=5.\n\
                    *NODE OUTPUT, NSET=END, FREQUENCY=8\nU1\n*NODE OUTPUT, NSET=FOOT\nRF1\n*END STEP\n");
    let job = Job::run("history_frequency", &deck);
    let times = |name: &str| rows(&job, name, 1).iter().map(|row| row.0).collect::<Vec<_>>();
    assert_eq!(times("U1 of END"), [0.0, 4.0, 8.0, 10.0]);
    assert_eq!(times("RF1 of FOOT"), [0.0, 5.0, 10.0]);
}

/// TIME MARKS=YES: increments end at the times of frames and histories; without it they pass them.
#[test]
fn increments_end_at_time_marks() {
    let output = |marks: &str| {
        bar(&format!(
            "*STEP\n*DYNAMIC, EXPLICIT\n, 10.\n*OUTPUT, FIELD, NUMBER INTERVAL=4{marks}\n*NODE OUTPUT\nU\n\
             *OUTPUT, HISTORY, TIME INTERVAL=0.75{marks}\n*NODE OUTPUT, NSET=END\nU1\n*END STEP\n"
        ))
    };
    let near = |times: &[f64], wanted: &[f64]| {
        times.len() == wanted.len() && times.iter().zip(wanted).all(|(t, w)| (t - w).abs() <= 1e-14 * w)
    };
    let job = Job::run("time_marks", &output(", TIME MARKS=YES"));
    let histories: Vec<f64> = (0..14).map(|i| 0.75 * f64::from(i)).chain([10.0]).collect();
    let ends = rows(&job, "U1 of END", 1).iter().map(|row| row.0).collect::<Vec<_>>();
    assert!(near(&ends, &histories), "{ends:?}");
    assert!(near(&job.results().times(), &[0.0, 2.5, 5.0, 7.5, 10.0]), "{:?}", job.results().times());
    assert!(job.plan().contains("increments end every 2.5"), "{}", job.plan());
    let without = Job::run("no_time_marks", &output("")).results().times();
    assert!(without.len() == 5 && without[1] > 2.51, "{without:?}");
}
