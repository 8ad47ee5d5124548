use super::*;
use crate::law::exponential::{self, Exponential};
use crate::law::linear::Linear;
use crate::law::tabular::Tabular;
use crate::law::work_by_quadrature;
use crate::verify;

fn law(lines: &[&str]) -> Formula {
    Formula::new(lines, 10.0).unwrap_or_else(|faults| panic!("{lines:?}: {faults:?}")).0
}

/// A few roundings of numbers that do not cancel.
const ALGEBRAIC: f64 = 1e-12;

fn assert_same(what: &str, one: NormalResponse, other: NormalResponse) {
    for (a, b) in [(one.energy, other.energy), (one.pressure, other.pressure), (one.stiffness, other.stiffness)] {
        assert!((a - b).abs() <= ALGEBRAIC * b.abs(), "{what}: {one:?}, not {other:?}");
    }
}

#[test]
fn the_formula_of_another_law_gives_its_answers() {
    let linear = law(&["p = K * h", "K = 4000."]);
    let exponential = law(&[
        "p = p0 / (exp(1) - 1) * z * (exp(z) - 1)",
        "z = min(1 + h/c0, 7)",
        "c0 = 0.05",
        "p0 = 200",
        "reach = c0",
    ]);
    let curved = Exponential::new(0.05, 200.0);
    let rows = [[0.0, -0.02], [10.0, 0.0], [10.0, 0.05], [200.0, 0.10], [260.0, 0.20]];
    let table = law(&[
        "p = 500*max(0, h + 0.02) - 500*max(0, h) + 3800*max(0, h - 0.05) - 3200*max(0, h - 0.1)",
        "reach = 0.02",
    ]);
    let tabular = Tabular::new(&rows).unwrap();
    for h in [-0.06, -0.021, -0.019, -0.01, 1e-9, 0.01, 0.0499, 0.0501, 0.07, 0.11, 0.25] {
        assert_same(&format!("LINEAR {h}"), linear.respond(-h), Linear { slope: 4000.0, clearance: 0.0 }.respond(-h));
        assert_same(&format!("TABULAR {h}"), table.respond(-h), tabular.respond(-h));
        assert_same(&format!("EXPONENTIAL {h}"), exponential.respond(-h), curved.respond(-h));
    }
    assert!(exponential.remarks().is_empty() && linear.remarks().is_empty(), "{:?}", exponential.remarks());
    let kinks = table.kinks(-1.0..1.0);
    for kink in [0.0, -0.05, -0.1] {
        assert!(kinks.iter().any(|k| (k - kink).abs() < 1e-15), "{kink}: {kinks:?}");
    }
    assert_eq!(exponential::STRAIGHT_BEYOND, 6.0);
}

/// ∫K hⁿ = K hⁿ⁺¹/(n+1), over twenty orders of magnitude and for exponents with a singular slope or curvature.
#[test]
fn energies_of_powers_are_exact() {
    for n in [0.5, 1.0, 1.5, 2.0, 3.0, 3.5] {
        let law = law(&["p = K * h ^ n", "K = 4.0e4", &format!("n = {n}")]);
        for h in [1e-18, 1e-9, 3e-4, 0.7, 9.0, 75.0, 100.0] {
            let expected = NormalResponse {
                energy: 4e4 * f64::powf(h, n + 1.0) / (n + 1.0),
                pressure: 4e4 * h.powf(n),
                stiffness: 4e4 * n * h.powf(n - 1.0),
            };
            assert_same(&format!("{n} {h}"), law.respond(-h), expected);
        }
        assert_eq!(law.respond(1e-300), NormalResponse::default());
        assert!(law.respond(0.0).stiffness.is_finite());
    }
}

#[test]
fn they_keep_their_word() {
    for lines in [
        &["p = K*h**1.5", "K=4.0D4"][..],
        &["p = C*exp(-g/l)", "C=3", "l=0.2", "reach = 6*l"],
        &["P = H^3 + if(H > 0.1, 50*(H-0.1), 0)"],
        &["p = tanh(h/0.1) + atan(h) + sqrt(h)"],
        &["p = 2 + sin(h)*cos(h) + tan(h/20) + log(1+h)/(1-g) + 3*h - abs(h-0.3)/10"],
        &["p = max(0, h - 0.25)*1e3"],
    ] {
        let law = law(lines);
        for range in [-1.0..0.5, -0.1..law.reach() + 0.1, -1e-3..1e-3] {
            verify::law(&law, range).unwrap_or_else(|fault| panic!("{lines:?}: {fault}"));
        }
        for h in [0.01, 0.2, 0.3, 0.9] {
            let work = work_by_quadrature(&law, h, 64);
            // Where the law begins with a power of h that is no whole number, the rule that compares knows no better.
            let bound = if ["sqrt", "1.5"].iter().any(|word| lines[0].contains(word)) { 1e-6 } else { 1e-11 };
            assert!((law.respond(-h).energy - work).abs() <= bound * work.max(1e-3), "{lines:?} {h}");
        }
    }
}

#[test]
fn arithmetic_is_that_of_mathematics() {
    for (text, value) in [
        ("1 + 2*3", 7.0),
        ("2*3 - -1", 7.0),
        ("(1+2)*3", 9.0),
        ("2^3^2/2", 256.0),
        ("10 - 4 - 3", 3.0),
        ("24/4/3", 2.0),
        ("30 - 2^2", 26.0),
        ("5 + (-2)^3 + 4", 1.0),
        ("2^-1", 0.5),
        ("1e1 + 1.5D+1 + .5", 25.5),
        ("4*atan(1) - pi + 1", 1.0),
        ("if(2 < 1, 5, 6) + if(2 >= 1, 1, 0)", 7.0),
        ("min(max(3, 4), 5) + abs(-2)", 6.0),
    ] {
        let law = law(&[&format!("p = {text}")]);
        assert_eq!(law.respond(-1.0).pressure, value, "{text}");
    }
    assert_eq!(law(&["p = 30 - h^2*0 - 2^2"]).respond(-1.0).pressure, 26.0);
    assert_eq!(law(&["p = -(-h)^2 + 109"]).respond(-1.0).pressure, 108.0);
}

/// Each fault with the text that its place covers.
#[test]
fn faults_know_their_place() {
    for (line, at, title) in [
        ("p = K * h", "K", "`K` is not defined"),
        ("p = (1 + h", "(", "not closed"),
        ("p = 1 + h)", ")", "closes nothing"),
        ("p = 2 h", "h", "an operator is missing"),
        ("p = 2 * ", "*", "missing after this"),
        ("p = * 2", "*", "missing before this"),
        ("p = sine(h)", "sine", "not a function"),
        ("p = 1.2.3", "1.2.3", "not a number"),
        ("p = h + log(0)*2", "log(0)", "no number"),
        ("p = max(h)", ")", "another argument"),
        ("p = exp(h, 1)", ",", "one too many"),
        ("p = if(h, 1, 2)", ",", "`<` or `>` is missing"),
        ("p = h § 2", "§", "an operator is missing"),
        ("p = h = 2", "=", "one `=`"),
        ("p", "p", "name = expression"),
        ("h = 2", "h", "a meaning of its own"),
        ("2k = 2", "2k", "no name"),
        ("p = p + 1", "p", "by itself"),
        ("p = h - 1", "h - 1", "negative"),
        ("p = sqrt(1 - h)", "sqrt(1 - h)", "no number"),
        ("p = 0*h", "0*h", "no pressure"),
    ] {
        let faults = Formula::new(&[line], 10.0).unwrap_err();
        assert_eq!(faults.len(), 1, "{line}: {faults:?}");
        assert!(faults[0].title.contains(title), "{line}: {faults:?}");
        assert_eq!(&line[faults[0].at.clone()], at, "{line}: {faults:?}");
    }
    let of = |lines: &[&str]| Formula::new(lines, 10.0).unwrap_err();
    assert!(of(&["K = 2"])[0].line.is_none());
    assert!(of(&["p = h", "reach = h"])[0].title.contains("must be a number"));
    assert!(of(&["p = h", "P = h"])[0].title.contains("twice"));
    assert_eq!(of(&["p = a", "a = b", "b = a"]).len(), 1);
    assert!(of(&[&format!("p = {}h", "(".repeat(5000))])[0].title.contains("too deep"));
    let mut doubling = vec!["p = a30".to_owned(), "a0 = h".to_owned()];
    doubling.extend((1..=30).map(|i| format!("a{i} = a{} + a{}", i - 1, i - 1)));
    let lines: Vec<&str> = doubling.iter().map(String::as_str).collect();
    assert!(of(&lines)[0].title.contains("too long"));
}

#[test]
fn jumps_falls_and_idle_names_are_told() {
    let jump = law(&["p = exp(-g/0.01)", "reach = 0.05"]).remarks();
    assert!(jump.len() == 1 && jump[0].contains("jumps from 0 to 6.7379"), "{jump:?}");
    let fall = law(&["p = 2*h*exp(-h)"]).remarks();
    assert!(fall.len() == 1 && fall[0].contains("falls"), "{fall:?}");
    let (_, unused) = Formula::new(&["p = h", "K = 2"], 1.0).unwrap();
    assert!(unused.len() == 1 && unused[0].title.contains("`K`") && unused[0].line == Some(1));
}
