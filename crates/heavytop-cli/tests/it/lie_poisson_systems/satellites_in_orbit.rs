//! Satellites on ellipses: `eccentricity` and the anomalies of `[system.parameters]`.

use crate::program::{Finished, Folder, numbers};

/// A boom with 3 (I₁ − I₃)/I₂ = 1.5, which starts with the pitch that a small eccentricity drives, 4e sin ν.
const BOOM: &str = "\
[system]
kind = 'satellite'
parameters = { I = [100, 120, 40], n = 0.001, eccentricity = 0.001 }
initial = { relative = [0, 4e-6, 0] }

[integrator]
step = 100
end = 12_000
";

fn succeeded(done: &Finished) -> String {
    assert_eq!(done.code(), 0, "{}", done.stderr());
    done.stderr()
}

fn rows(folder: &Folder, configuration: &str) -> (String, Vec<Vec<f64>>) {
    folder.write("a.toml", configuration);
    let told = succeeded(&folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--force"]));
    (told, numbers(&folder.read("a.csv")).1)
}

#[test]
fn a_small_eccentricity_drives_the_pitch() {
    let folder = Folder::new();
    let error = |text: &str, from: f64, response: f64| {
        let (told, rows) = rows(&folder, text);
        assert!(told.contains("deviations c1") && told.contains("does not keep, h"), "{told}");
        let distance = |row: &Vec<f64>| {
            let pitch = (-row[4]).atan2(row[6]);
            (pitch - response * (0.001 * row[0] + from).sin()).abs()
        };
        rows.iter().map(distance).fold(0.0, f64::max)
    };
    // What is left is of the order of e², and the amplitude is 4e.
    assert!(error(BOOM, 0.0, 0.004) < 2e-5);
    assert!(error(BOOM, 0.0, 0.0038) > 1e-4);
    // From the apocentre on, where the pitch is 0 too and falls.
    let later = BOOM.replace("= 0.001 }", "= 0.001, mean_anomaly = 3.141592653589793 }");
    let falling = later.replace("4e-6", "-4e-6");
    assert!(error(&falling, std::f64::consts::PI, 0.004) < 2e-5);
    let by_truth = falling.replace("mean_anomaly", "true_anomaly");
    assert!(error(&by_truth, std::f64::consts::PI, 0.004) < 2e-5);
    // Control: there the other rate swings the boom.
    assert!(error(&later, std::f64::consts::PI, 0.004) > 1e-3);
}

#[test]
fn without_eccentricity_the_bytes_are_those_of_the_circle() {
    let folder = Folder::new();
    let written = |text: &str| {
        let (told, _) = rows(&folder, text);
        assert!(!told.contains("does not keep"), "{told}");
        folder.read("a.csv")
    };
    let circle = BOOM.replace(", eccentricity = 0.001", "");
    let expected = written(&circle);
    assert_eq!(written(&BOOM.replace("= 0.001 }", "= 0 }")), expected);
    rows(&folder, BOOM);
    assert_ne!(folder.read("a.csv"), expected);
}

/// At the pericentre the satellite is fastest, and at the apocentre slowest.
#[test]
fn functions_of_events_may_name_the_rate_and_the_tide() {
    let folder = Folder::new();
    folder.write("a.toml", &BOOM.replace("= 0.001 }", "= 0.2 }"));
    // u³ = 1 where the mean anomaly is ½π − e.
    let functions = "events.functions=[\"orbit_tide - 1e-6\"]";
    succeeded(&folder.heavytop(&["events", "a.toml", "--set", functions, "--out", "e.csv"]));
    let (header, found) = numbers(&folder.read("e.csv"));
    let time = header.iter().position(|name| name == "t").unwrap();
    let expected = (std::f64::consts::FRAC_PI_2 - 0.2) / 0.001;
    assert!((found[0][time] - expected).abs() < 1e-6, "{found:?}");
}

#[test]
fn sweeps_go_over_the_eccentricity_from_the_circle_on() {
    let folder = Folder::new();
    let sweep = "\n[sweep]\nobservables = ['final-state']\n[[sweep.axes]]\n\
                 parameter = 'system.parameters.eccentricity'\nfrom = 0\nto = 0.2\ncount = 3\n";
    folder.write("s.toml", &(BOOM.replace("= 0.001 }", "= 0 }") + sweep));
    succeeded(&folder.heavytop(&["sweep", "s.toml", "--out", "s"]));
    let table = folder.read("s/sweep.csv");
    let mut lines = table.lines();
    assert!(lines.next().unwrap().starts_with("index,system.parameters.eccentricity,Pi1,Pi2,"));
    let member = |line: &str| -> Vec<f64> {
        line.split(',').skip(2).take(9).map(|cell| cell.parse().unwrap()).collect()
    };
    let members: Vec<_> = lines.map(member).collect();
    assert_eq!(members.len(), 3);
    for (member, e) in members.iter().zip(["0", "0.1", "0.2"]) {
        let (_, rows) = rows(&folder, &BOOM.replace("= 0.001 }", &format!("= {e} }}")));
        let last = &rows.last().unwrap()[1..10];
        let scale = |i: usize| if i < 3 { 0.12 } else { 1.0 };
        let errors = (0..9).map(|i| (member[i] - last[i]).abs() / scale(i));
        // The circle goes by another method of the same order.
        assert!(errors.fold(0.0, f64::max) < 1e-9, "{e}: {member:?} {last:?}");
    }
}

/// A sweep of a torque that goes with the tide begins on the circle.
#[test]
fn formulas_name_the_rate_and_the_tide_of_a_circle() {
    let folder = Folder::new();
    let circle = BOOM.replace("eccentricity = 0.001", "eccentricity = 0");
    let torque = |formula: &str| format!("{circle}\n[torque]\nPi = [0, '{formula}', 0]\n");
    let by_names = rows(&folder, &torque("3*orbit_tide + 0.001*orbit_rate")).1;
    assert_eq!(by_names, rows(&folder, &torque("3*n^2 + 0.001*n")).1);
    assert_ne!(by_names, rows(&folder, &torque("3*n^2")).1);
    folder.write("a.toml", &circle);
    let functions = "events.functions=[\"Pi2 - 120*orbit_rate\"]";
    succeeded(&folder.heavytop(&["events", "a.toml", "--set", functions, "--out", "e.csv"]));
    let sweep = "\n[sweep]\nobservables = ['final-state']\n[[sweep.axes]]\n\
                 parameter = 'system.parameters.eccentricity'\nfrom = 0\nto = 0.2\ncount = 2\n";
    folder.write("s.toml", &(torque("3*orbit_tide") + sweep));
    succeeded(&folder.heavytop(&["sweep", "s.toml", "--out", "s"]));
    let table = folder.read("s/sweep.csv");
    assert!(table.lines().count() == 3 && !table.contains("error"), "{table}");
}

#[test]
fn impossible_orbits_are_refused_before_anything_is_written() {
    let folder = Folder::new();
    for (e, part) in [
        ("1", "eccentricity must be at least 0 and below 1, got 1"),
        ("-0.1", "eccentricity must be at least 0 and below 1, got -0.1"),
        ("nan", "eccentricity"),
        ("0.1, mean_anomaly = 1, true_anomaly = 1", "true_anomaly must be left out"),
    ] {
        folder.write("a.toml", &BOOM.replace("= 0.001 }", &format!("= {e} }}")));
        for command in ["simulate", "events"] {
            let functions = "events.functions=[\"Pi1\"]";
            let set: &[&str] = if command == "events" { &["--set", functions] } else { &[] };
            let run = folder.heavytop(&[&[command, "a.toml", "--out", "a.csv"], set].concat());
            assert!(run.code() == 2 && run.stderr().contains(part), "{e}: {}", run.stderr());
            assert!(!folder.path("a.csv").exists() && !folder.path("a.csv.partial").exists());
        }
    }
}
