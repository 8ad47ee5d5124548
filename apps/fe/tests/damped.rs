//! A27: contact damping through the program, p = μ(c) v.
#![allow(clippy::unwrap_used)]

mod common;

use common::job::{Job, PRINTED, close};
use common::slider::{Body, DISTANCE, K, pair, penalty};

/// A gap element of area 0.5 and clearance `gap`, LINEAR 100, damped.
fn gap(gap: f64, damping: &str) -> String {
    format!(
        "*NODE\n1, 0., 0., 0.\n2, 0., 0., 1.\n*NSET, NSET=FIRST\n1\n*ELEMENT, TYPE=GAPUNI, ELSET=G\n1, 1, 2\n\
         *GAP, ELSET=G\n{gap}, 0., 0., 1., 0.5\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n100.\n\
         *CONTACT DAMPING{damping}\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n"
    )
}

/// μ at a clearance: μ₀ = 10, c₀ = 0.1, η = 0.5.
fn coefficient(clearance: f64) -> f64 {
    10.0 * ((0.1 - clearance) / 0.05).clamp(0.0, 1.0)
}

/// Closing from 0.125 to −0.01 at a speed of 2 and back: 0, 10, 20, 20, 20 at 0.12, 0.075, 0.05, 0.025, −0.01, with the law's
/// 1 there; the energy is Σ μ v² A Δt.
#[test]
fn a27_contact_damping() {
    let prints = "*NODE PRINT, NSET=FIRST\nRF\n*EL PRINT, ELSET=G\nS\n";
    let step = |z: f64| {
        format!("*STEP, INC=30\n*STATIC, DIRECT\n0.0025, 0.0675\n*BOUNDARY\n2, 3, 3, {z}\n{prints}*END STEP\n")
    };
    let deck = gap(0.125, "\n10., 0.1, 0.5") + &step(-0.135) + &step(0.0);
    let job = Job::run("damped_gap", &deck);
    let clearance = |n: usize| 0.125 - 0.005 * if n <= 27 { n as f64 } else { 54.0 - n as f64 };
    let pressure = |n: usize| {
        let speed = if n <= 27 { 2.0 } else { -2.0 };
        100.0 * (-clearance(n)).max(0.0) + speed * coefficient(clearance(n))
    };
    let pressures: Vec<f64> = (1..=54).map(pressure).collect();
    let named = [1, 10, 15, 20, 27].map(|n| pressures[n - 1]);
    close("closed form", named, [0.0, 10.0, 20.0, 20.0, 21.0], PRINTED * 20.0);
    close("pressure", job.all("stresses", "G", 1), &pressures, PRINTED * 20.0);
    let forces: Vec<f64> = pressures.iter().map(|p| 0.5 * p).collect();
    close("force", job.all("forces", "FIRST", 3), &forces, PRINTED * 10.0);
    let energy: f64 = (1..=54).map(|n| coefficient(clearance(n)) * 4.0 * 0.5 * 0.0025).sum();
    let line = job.told.lines().find(|l| l.contains("contact damping")).expect("the energy is told");
    let taken: f64 = line.split_whitespace().nth(2).unwrap().parse().unwrap();
    // It prints seven digits.
    assert!((taken - energy).abs() <= 5e-7 * energy, "{line}, not {energy}");
    let words = "damping 1.000000e1 F T/L³ across and 0.000000e0 F T/L³ along the surface up to a clearance of 5.000e-2 L, none \
                from 1.000e-1 L on";
    assert!(job.plan().contains(words), "{}", job.plan());
}

/// Along the surface the fraction of the coefficient resists, on open points, too: 0.3 · 10 · 2 · 0.5.
#[test]
fn damping_along_the_surface() {
    let step = "*STEP\n*STATIC, DIRECT\n0.25, 1.\n*BOUNDARY\n2, 1, 1, 2.\n*NODE PRINT, NSET=FIRST\nRF\n*END STEP\n";
    let job = Job::run("damped_along", &(gap(0.02, ", TANGENT FRACTION=0.3\n10., 0.1, 0.5") + step));
    close("across", job.all("forces", "FIRST", 3), [0.0; 4], PRINTED * 3.0);
    close("along", job.all("forces", "FIRST", 1), [-3.0; 4], PRINTED * 3.0);
}

/// The slider pulled towards its stop within c₀, where the coefficient falls from μ₀ at c₀/4: in each of ten increments
/// k x + ⟨K (x − g₀)⟩ + μ(g₀ − x) Δx/Δt = F, open at first and closed at last. A surface of nodes without areas has forces:
/// a quarter each.
#[test]
fn a27_damped_slider() {
    let (penalty_stiffness, damping, reach) = (4.0 * K, 300.0, 0.2);
    let viscous = |x: f64| damping * ((reach - (DISTANCE - x)) / (0.75 * reach)).clamp(0.0, 1.0);
    let pressing = |x: f64| penalty_stiffness * (x - DISTANCE).max(0.0);
    let (mut x, mut forces) = (0.0, Vec::new());
    for n in 1..=10 {
        let load = 50.0 * f64::from(n);
        let left = |next: f64| K * next + pressing(next) + viscous(next) * (next - x) / 0.1 - load;
        let (mut low, mut high) = (x, 1.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            *(if left(middle) < 0.0 { &mut low } else { &mut high }) = middle;
        }
        x = 0.5 * (low + high);
        forces.push(load - K * x);
    }
    assert!(x > DISTANCE && forces[0] > 1.0);
    for (body, kind, nodes) in [
        (Body::Brick, "SURFACE TO SURFACE", false),
        (Body::Brick, "NODE TO SURFACE", false),
        (Body::Brick, "NODE TO SURFACE", true),
        (Body::Plane, "SURFACE TO SURFACE", false),
        (Body::Ring, "SURFACE TO SURFACE", false),
    ] {
        let part = if nodes { 0.25 } else { 1.0 };
        let surface = if nodes { "*SURFACE, NAME=POINTS, TYPE=NODE\nNEAR\n" } else { "" };
        let pair = if nodes { pair(kind).replace("SEC,", "POINTS,") } else { pair(kind) };
        let deck = format!(
            "{}{}{surface}{}*CONTACT DAMPING\n{}, {reach}, 0.25\n{pair}*BOUNDARY\nHELD, 1, 3\nREF, 1, 6\n*STEP\n\
             *STATIC, DIRECT\n0.1, 1.\n*DSLOAD\nSEC, P, -500.\n*NODE PRINT, NSET=REF\nRF\n*CONTACT PRINT\nCSTRESS\n*END STEP\n",
            body.deck(),
            body.stop(false),
            penalty(part * penalty_stiffness),
            part * damping
        );
        let job = Job::run("damped_slider", &deck);
        let got: Vec<f64> = job.all("forces", "REF", body.axis()).iter().map(|f| f.abs()).collect();
        close(&format!("{body:?} {kind} {nodes}"), &got, &forces, PRINTED * 400.0);
        let pressures: Vec<f64> = forces.iter().map(|force| part * force).collect();
        close("CPRESS, on open points, too", job.all("contact stress", "", 1), &pressures, PRINTED * 400.0);
        let plan = job.plan();
        assert!(plan.contains(if nodes { " F T/L across" } else { " F T/L³ across" }), "{plan}");
    }
}
