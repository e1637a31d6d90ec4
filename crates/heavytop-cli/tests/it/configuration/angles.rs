//! Angles with units, and their ranges.

use crate::commands::sweep::{column, rows};
use crate::program::Folder;

/// Runs a configuration of an initial state, and returns Γ(0).
fn vertical(folder: &Folder, initial: &str) -> [f64; 3] {
    folder.write("a.toml", &format!("{initial}\n[integrator]\nend = 0.02\nstep = 0.02"));
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
    assert_eq!(run.code(), 0, "{initial}: {}", run.stderr());
    let text = folder.read("a.csv");
    let row: Vec<f64> =
        text.lines().nth(1).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    [row[4], row[5], row[6]]
}

#[test]
fn angles_are_degrees_with_a_unit_and_radians_without() {
    let folder = Folder::new();
    let expected = vertical(
        &folder,
        "initial = { inclination = 0.5235987755982988, azimuth = 1.0471975511965976 }",
    );
    for initial in [
        "initial = { inclination = '30 deg', azimuth = '60 deg' }",
        "initial = { inclination = '0.5235987755982988 rad', azimuth = '60°' }",
        "initial = { inclination = '30deg', azimuth = '-300 deg' }",
    ] {
        let found = vertical(&folder, initial);
        let error = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
        assert!(error < 1e-15, "{initial}: {found:?} {expected:?}");
    }
    for (initial, parts) in [
        (
            "inclination = 30",
            ["is in radians, from 0 to π, and 30 is beyond π", "write \"30 deg\""],
        ),
        ("inclination = -0.5", ["-0.5 is beyond 0", "write an angle from 0 to π"]),
        ("inclination = '200 deg'", ["must be from 0 to π, got `200 deg`", "^"]),
        (
            "inclination = '30 grad'",
            ["string \"30 grad\", expected a number", "such as \"30 deg\""],
        ),
        ("inclination = 0.5\nazimuth = 90", ["90 is beyond 2π", "write \"90 deg\""]),
        ("inclination = 0.5\nazimuth = '360 deg'", ["between -2π and 2π", "^"]),
        ("inclination = true", ["expected a number", "^"]),
    ] {
        folder.write("b.toml", &format!("[initial]\n{initial}"));
        for command in ["simulate", "section", "animate", "compare"] {
            let out = if command == "simulate" { "b.csv" } else { "b.html" };
            let run = folder.heavytop(&[command, "b.toml", "--out", out]);
            assert_eq!(run.code(), 2, "{initial}: {}", run.stderr());
            assert!(
                parts.iter().all(|part| run.stderr().contains(part)),
                "{initial}: {}",
                run.stderr()
            );
        }
    }
}

#[test]
fn axes_of_angles_have_units_too() {
    let folder = Folder::new();
    let sweep = |parameter: &str, values: &str, out: &str| {
        let axes = format!("[{{ parameter = '{parameter}', {values} }}]");
        folder.write(
            "map.toml",
            &format!("sweep = {{ observables = ['final-state'], axes = {axes}, count = 3 }}\nintegrator.end = 0.1"),
        );
        let text = folder.read("map.toml");
        if values.contains("from") {
            folder.write("map.toml", &text.replace(", count = 3 }\n", " }\n"));
        }
        folder.heavytop(&["sweep", "map.toml", "--out", out])
    };
    let parameter = "initial.vertical.inclination";
    for (number, values) in [
        "from = '0 deg', to = '90 deg', count = 3",
        "from = 0, to = 1.5707963267948966, count = 3",
        "uniform = ['10 deg', '1 rad']",
        "normal = ['90 deg', '5 deg']",
    ]
    .into_iter()
    .enumerate()
    {
        let run = sweep(parameter, values, &format!("map{number}"));
        assert_eq!(run.code(), 0, "{values}: {}", run.stderr());
    }
    // Degrees and radians are the same motions.
    let final_states = |name: &str| {
        let measured = rows(&folder, &format!("{name}/sweep.parquet"));
        let columns = [parameter, "Pi1", "Pi2", "Pi3", "Gamma1", "Gamma2", "Gamma3"];
        columns.map(|name| column(&measured, name))
    };
    let in_degrees = final_states("map0");
    assert!(in_degrees.iter().all(|values| values.len() == 3 && values[0].is_some()));
    assert_eq!(in_degrees, final_states("map1"));
    // Control: other angles are other motions.
    assert_ne!(in_degrees, final_states("map2"));
    for (parameter, values, part) in [
        (
            parameter,
            "from = 0, to = 90, count = 3",
            "needs an angle: it is in radians, from 0 to π, and 90 is beyond π; write \"90 deg\"",
        ),
        (parameter, "uniform = ['0 deg', '200 deg']", "must be from 0 to π, got `200 deg`"),
        ("initial.vertical.azimuth", "from = -10, to = 0, count = 2", "-10 is beyond -2π"),
        ("body.center_of_mass.inclination", "from = 0, to = 4, count = 2", "beyond π"),
        ("body.gravity", "from = '1 deg', to = '2 deg', count = 2", "needs numbers, got `1 deg`"),
    ] {
        let run = sweep(parameter, values, "refused");
        assert_eq!(run.code(), 2, "{values}: {}", run.stderr());
        assert!(run.stderr().contains(part), "{values}: {}", run.stderr());
    }
}
