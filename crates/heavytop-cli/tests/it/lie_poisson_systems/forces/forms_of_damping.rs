//! Forms of damping of spins by formula and by name.

use crate::commands::sweep::{column, rows};
use crate::program::{Folder, numbers};

/// A spin of length 2 in a field along e₃.
const SPIN: &str = "\
[system]
algebra = 'so(3)'
bracket = 'plus'
hamiltonian = '-3*Pi3'
initial.Pi = [2, 0, 0]
[damping]
friction = 0.5
[integrator]
step = 0.05
end = 2
";

/// A ring of three spins of different lengths.
const CHAIN: &str = "\
[system]
kind = 'spin-chain'
parameters = { spins = 3, exchange = 1, field = [0, 0, 2] }
initial = { S_1 = [1, 0, 0.5], S_2 = [0, 0.6, 0.2], S_3 = [0.3, 1, 1] }
[damping]
friction = 0.4
[integrator]
step = 0.05
end = 5
";

fn run(folder: &Folder, text: &str) -> (String, Vec<Vec<f64>>) {
    folder.write("a.toml", text);
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]);
    assert_eq!(done.code(), 0, "{}", done.stderr());
    (done.stderr(), numbers(&folder.read("a.csv")).1)
}

/// ds/dt = s × aB + bB s × (B × s)/B with a = 1, b = θ, or with a = 1/(1 + α²), b = α a/|s|: s₃ = L tanh(b L B t), and the spin
/// turns by −aBt.
#[test]
fn a_spin_has_the_closed_form_of_each_damping() {
    let folder = Folder::new();
    for (form, a, b) in [
        ("", 1.0, 0.5),
        ("form = 'landau-lifshitz'\n", 1.0, 0.5),
        ("form = 'gilbert'\n", 0.8, 0.8 * 0.5 / 2.0),
    ] {
        let (told, rows) = run(&folder, &SPIN.replace("0.5\n", &format!("0.5\n{form}")));
        assert!(told.contains("largest deviations c1"), "{told}");
        let end = rows.last().unwrap();
        // gauss-8 at the step 0.05: far below 1e-8.
        assert!((end[3] - 2.0 * (b * 2.0 * 3.0 * 2.0_f64).tanh()).abs() < 1e-8, "{form} {end:?}");
        let turned = end[2].atan2(end[1]) + a * 3.0 * 2.0;
        let rest = turned.rem_euclid(core::f64::consts::TAU);
        assert!(rest.min(core::f64::consts::TAU - rest) < 1e-8, "{form} {rest}");
    }
}

/// A chain needs no inner product with a form, loses energy, keeps each length, and is at rest where a temperature is not.
#[test]
fn a_chain_by_name_has_the_forms_of_spins() {
    let folder = Folder::new();
    folder.write("a.toml", CHAIN);
    let done = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert!(done.code() == 2 && done.stderr().contains("add inner_product"), "{}", done.stderr());
    let with = |form: &str| CHAIN.replace("0.4\n", &format!("0.4\n{form}\n"));
    let (_, unit) = run(&folder, &with("inner_product = 1"));
    let (_, landau) = run(&folder, &with("form = 'landau-lifshitz'"));
    assert_eq!(unit, landau);
    let (told, gilbert) = run(&folder, &with("form = 'gilbert'"));
    assert!(told.contains("largest changes, of what the motion does not keep, h "), "{told}");
    assert_ne!(gilbert.last(), landau.last());
    let length = |row: &[f64], i: usize| row[i..i + 3].iter().map(|x| x * x).sum::<f64>();
    for rows in gilbert.windows(2) {
        assert!(rows[1][10] < rows[0][10] + 1e-13, "{:?}", rows[1]);
        for i in [1, 4, 7] {
            assert!((length(&rows[1], i) - length(&gilbert[0], i)).abs() < 1e-13);
        }
    }
    let warm = with("form = 'gilbert'\n[noise]\ntemperature = 0.1");
    let (told, warm) = run(&folder, &warm);
    assert!(told.contains("noise of seed 1, path 0"), "{told}");
    assert_ne!(warm.last(), gilbert.last());
    assert!((length(warm.last().unwrap(), 4) - length(&warm[0], 4)).abs() < 1e-12);
}

/// Gilbert's α is varied as the friction is; a temperature without friction is refused before a member is followed.
#[test]
fn sweeps_vary_the_damping_and_refuse_a_void_temperature() {
    let folder = Folder::new();
    let axis = |name: &str, from: f64, to: f64| {
        format!(
            "[sweep]\nobservables = ['final-state']\naxes = [{{ parameter = '{name}', from = {from}, to = {to}, \
             count = 3 }}]\n"
        )
    };
    let gilbert = SPIN.replace("0.5\n", "0.5\nform = 'gilbert'\n");
    folder.write("a.toml", &format!("{gilbert}{}", axis("damping.friction", 0.0, 1.0)));
    let done = folder.heavytop(&["sweep", "a.toml", "--out", "s"]);
    assert_eq!(done.code(), 0, "{}", done.stderr());
    let table = rows(&folder, "s/sweep.parquet");
    let ends = column(&table, "Pi3");
    for (end, alpha) in ends.iter().zip([0.0_f64, 0.5, 1.0]) {
        let expected = 2.0 * (6.0 * alpha / (1.0 + alpha * alpha)).tanh();
        assert!((end.unwrap() - expected).abs() < 1e-8, "{alpha}: {end:?}");
    }
    for (friction, temperature, axes, parts) in [
        (
            "0.5",
            "0.3",
            axis("damping.friction", 1.0, 0.0),
            ["the axis damping.friction needs numbers above 0", "noise.temperature = 0.3, got 0"],
        ),
        (
            "0",
            "0",
            axis("noise.temperature", 0.0, 0.7),
            ["the axis noise.temperature needs damping.friction above 0", "up to 0.7, got 0"],
        ),
        (
            "0",
            "0.3",
            axis("noise.temperature", 0.1, 0.7),
            ["beside temperature = 0.3 the friction must be a positive number", "friction = 0"],
        ),
    ] {
        let noise = format!("[noise]\ntemperature = {temperature}\n");
        let text = gilbert.replace("friction = 0.5", &format!("friction = {friction}"));
        folder.write("b.toml", &format!("{text}{noise}{axes}"));
        let done = folder.heavytop(&["sweep", "b.toml", "--out", "t"]);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{told}");
        assert!(!folder.path("t").exists());
    }
    // Control: temperatures of 0 alone do nothing with any friction, and are no mistake.
    let cold = format!("{gilbert}[noise]\ntemperature = 0\n{}", axis("damping.friction", 0.0, 1.0));
    folder.write("b.toml", &cold);
    assert_eq!(folder.heavytop(&["sweep", "b.toml", "--out", "t"]).code(), 0);
}
