//! Formulations and schemes: which pairs run, which are refused, and what they conserve.

use crate::program::{Finished, Folder, numbers};
use heavytop::methods::SchemeName;

const GAUSS: &[&str] =
    &["implicit-midpoint", "gauss-4", "gauss-6", "gauss-8", "gauss-10", "gauss-12", "gauss-16"];
const EXPLICIT: &[&str] = &["explicit-midpoint", "rk4"];
const PARTITIONED: &[&str] = &["symplectic-euler", "stormer-verlet", "lobatto-iiia-iiib-4"];
const COMPOSED: &[&str] =
    &["strang", "yoshida-4", "suzuki-4", "yoshida-6", "kahan-li-6", "kahan-li-8"];

const PAIRS: [(&str, &[&[&str]]); 4] = [
    ("collective", &[GAUSS, EXPLICIT, PARTITIONED, COMPOSED]),
    ("reduced", &[GAUSS, COMPOSED]),
    ("direct", &[GAUSS, EXPLICIT, COMPOSED]),
    ("splitting", &[COMPOSED]),
];

fn simulate(folder: &Folder, formulation: &str, scheme: &str, rest: &str) -> Finished {
    let method = format!("formulation = '{formulation}'\nscheme = '{scheme}'");
    folder.write("a.toml", &format!("[integrator]\n{method}\n{rest}"));
    folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"])
}

#[test]
fn each_pair_that_makes_sense_runs_and_conserves_what_it_promises() {
    for (formulation, schemes) in PAIRS {
        for &scheme in schemes.iter().copied().flatten() {
            for body in ["", "\n[body]\ninertia = [3.0, 2.0, 1.5]"] {
                let folder = Folder::new();
                let run =
                    simulate(&folder, formulation, scheme, &format!("step = 0.1\nend = 1{body}"));
                let (code, said) = (run.code(), run.complaints());
                assert_eq!(code, 0, "{formulation} {scheme}: {said}");
                let (_, rows) = numbers(&folder.read("a.csv"));
                assert_eq!(rows.len(), 11);
                let deviation = |column: usize| {
                    let deviations = rows.iter().map(|row| (row[column] - rows[0][column]).abs());
                    deviations.fold(0.0, f64::max)
                };
                let (f1, f2) = (deviation(8), deviation(9));
                let what = format!("{formulation} {scheme}: f1 {f1:e}, f2 {f2:e}");
                if PARTITIONED.contains(&scheme) || EXPLICIT.contains(&scheme) {
                    assert!(f1 > 1e-7, "{what}");
                } else {
                    assert!(f1 < 1e-12 && f2 < 1e-11, "{what}");
                }
                // All runs follow the same top, so that none is far off.
                assert!(deviation(7) < 5.0, "{what}, h {:e}", deviation(7));
                assert_eq!(said.is_empty(), !PARTITIONED.contains(&scheme), "{what}: {said}");
                if !said.is_empty() {
                    let warning = format!("heavytop: warning: {scheme} does not descend");
                    assert!(said.starts_with(&warning) && said.lines().count() == 1, "{said}");
                }
            }
        }
    }
}

#[test]
fn each_other_pair_is_refused_with_the_schemes_that_there_are() {
    let all = PAIRS[0].1.concat();
    for (formulation, schemes) in PAIRS {
        let here = schemes.concat();
        for scheme in all.iter().filter(|scheme| !here.contains(scheme)) {
            let folder = Folder::new();
            let run = simulate(&folder, formulation, scheme, "end = 1");
            let list = here.join(", ");
            let message = format!(": {formulation} has no scheme {scheme}; it has {list}\n");
            assert_eq!((run.code(), run.messages()), (2, 1));
            assert!(run.stderr().contains(&message), "{}", run.stderr());
            assert_eq!(folder.names(), ["a.toml"]);
        }
    }
}

#[test]
fn reduced_is_collective() {
    for scheme in GAUSS.iter().chain(COMPOSED) {
        let rows = ["collective", "reduced"].map(|formulation| {
            let folder = Folder::new();
            assert_eq!(simulate(&folder, formulation, scheme, "end = 2").code(), 0);
            numbers(&folder.read("a.csv")).1
        });
        assert_eq!(rows[0].len(), 101);
        for (one, other) in rows[0].iter().zip(&rows[1]) {
            for (x, y) in one[..7].iter().zip(&other[..7]) {
                assert!((x - y).abs() < 1e-11, "{scheme} at {}: {x} and {y}", one[0]);
            }
        }
    }
}

#[test]
fn the_orders_are_those_of_the_names() {
    let orders = [2_u16, 4, 4, 6, 6, 8];
    for formulation in ["collective", "direct", "splitting"] {
        let end = |scheme: &str, step: f64| {
            let folder = Folder::new();
            let steps = format!("step = {step}\nend = 1");
            assert_eq!(simulate(&folder, formulation, scheme, &steps).code(), 0);
            let (_, rows) = numbers(&folder.read("a.csv"));
            rows[rows.len() - 1][1..7].to_vec()
        };
        let distance = |x: &[f64], y: &[f64]| {
            x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt()
        };
        let exact = end("kahan-li-8", 0.004);
        for (scheme, order) in COMPOSED.iter().zip(orders) {
            // The step is large enough for errors above round-off, and small enough for the leading term.
            let step = if order == 8 { 0.2 } else { 0.05 };
            let [coarse, fine] =
                [step, step / 2.0].map(|step| distance(&end(scheme, step), &exact));
            let found = (coarse / fine).log2();
            assert!((found - f64::from(order)).abs() < 0.5, "{formulation} {scheme}: {found}");
            let named = SchemeName::NAMES.iter().find(|(name, _)| name == scheme).unwrap().1;
            assert_eq!(named.order(), order);
        }
    }
}
