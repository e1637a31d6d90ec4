//! The presets: tops by name, against published values and closed forms.

use crate::program::{Folder, numbers};

/// Returns the last row of a simulation with these arguments, without a warning.
fn last(folder: &Folder, arguments: &[&str]) -> Vec<f64> {
    let (row, said) = last_and_warning(folder, arguments);
    assert_eq!(said, "", "{arguments:?}");
    row
}

/// Returns the last row of a simulation with these arguments, and the warnings.
fn last_and_warning(folder: &Folder, arguments: &[&str]) -> (Vec<f64>, String) {
    let run = folder.heavytop(&[&["simulate", "--out", "a.csv"], arguments].concat());
    assert_eq!((run.code(), run.complaints()), (0, String::new()), "{arguments:?}");
    let warnings = run.stderr().lines().filter(|line| line.contains("warning: ")).collect();
    (numbers(&folder.read("a.csv")).1.pop().unwrap(), warnings)
}

#[test]
#[ignore = "long"]
fn the_multibody_benchmark_has_its_height() {
    let folder = Folder::new();
    let preset = ["--preset", "multibody-benchmark"];
    let end = last(&folder, &preset);
    assert_eq!(end[0], 2.0);
    // The published number has eleven digits; the centre of mass is at l c, c = e₂, l = 1 m.
    assert!((end[5] + 0.673_022_269_56).abs() < 1e-10, "{end:?}");
    // Negative control: sixteen times the step is too long for this accuracy.
    folder.write("long.toml", "integrator = { step = 0.05 }");
    let (long, said) = last_and_warning(&folder, &["--preset", "multibody-benchmark", "long.toml"]);
    assert!(said.contains("the motion turns by about "), "{said}");
    assert!((long[5] + 0.673_022_269_56).abs() > 1e-10, "{long:?}");
    // Another scheme gives the same height.
    folder.write("other.toml", "integrator = { scheme = 'kahan-li-8', step = 0.00025 }");
    let other = last(&folder, &["--preset", "multibody-benchmark", "other.toml"]);
    assert!((other[5] - end[5]).abs() < 1e-8, "{other:?}");
}

#[test]
fn presets_are_what_their_names_say() {
    let folder = Folder::new();
    folder.write("short.toml", "integrator.end = 0.02");
    let columns = |preset: &str| {
        let run = ["simulate", "--out", "a.csv", "--preset", preset, "short.toml"];
        assert_eq!(folder.heavytop(&run).code(), 0, "{preset}");
        let (header, mut rows) = numbers(&folder.read("a.csv"));
        (header.last().unwrap().clone(), rows.swap_remove(0))
    };
    assert_eq!(columns("kovalevskaya").0, "K");
    let (_, lagrange) = columns("lagrange");
    assert_eq!(lagrange[1..4], [0.0, 0.0, 4.0]);
    let (last, goryachev) = columns("goryachev-chaplygin");
    // G is conserved where f₂ = Π·Γ is zero.
    assert_eq!((last.as_str(), goryachev[9]), ("G", 0.0));
    let (_, euler) = columns("euler");
    // Without a weight, h = ½ Π·(I⁻¹Π).
    assert!((euler[7] - (0.01 + 4.0 / 2.0 + 0.01 / 3.0) / 2.0).abs() < 1e-15);
}

#[test]
fn a_configuration_is_put_over_the_preset_key_by_key() {
    let folder = Folder::new();
    folder.write("a.toml", "[body]\nmass = 7.5\n[integrator]\nend = 0.1\nstep = 0.0125");
    let (end, said) = last_and_warning(&folder, &["--preset", "multibody-benchmark", "a.toml"]);
    assert!(said.contains("the motion turns by about "), "{said}");
    assert_eq!(end[0], 0.1);
    let row = numbers(&folder.read("a.csv")).1.swap_remove(0);
    // The moments and the start are those of the preset. The mass is not, and has no weight at Γ₂ = 0.
    assert_eq!(row[2], 70.3125);
    let kinetic = (70.3125 * 150.0 + 15.234375 * 4.61538 * 4.61538) / 2.0;
    assert!((row[7] - kinetic).abs() < 1e-11);

    folder.write("wrong.toml", "[body]\n\nmass = 'heavy'");
    let run = ["simulate", "--out", "b.csv", "--preset", "euler", "wrong.toml"];
    let said = folder.heavytop(&run).stderr();
    assert!(said.contains("wrong.toml, line 3, column 8: "), "{said}");
}
