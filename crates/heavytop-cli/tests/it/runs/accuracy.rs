//! How accurate a run is: the warning about long steps, the estimate of the error, and `--check`.

use crate::program::Folder;
use serde_json::Value;

/// A free rigid body that turns by 10 rad/s, nearly about e₃.
const BODY: &str = "[system]\nalgebra = 'so(3)'\nhamiltonian = '(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2'\n\
                    initial = { Pi = [0.3, 0.2, 30] }\n";

/// Returns the summary of a command, and what it said on stderr.
fn summary(folder: &Folder, arguments: &[&str]) -> (Value, String) {
    let run = folder.heavytop(&[&["--json"], arguments].concat());
    assert_eq!(run.code(), 0, "{arguments:?}: {}", run.stderr());
    (serde_json::from_str(&run.stdout()).unwrap(), run.stderr())
}

fn simulate(folder: &Folder, config: &str, more: &[&str]) -> (Value, String) {
    folder.write("a.toml", config);
    summary(folder, &[&["simulate", "a.toml", "--out", "a.npz"], more].concat())
}

/// Gauss's method of order 8 at 15 rad a step, and the midpoint rule at 0.15 rad a step over 20 s, conserve the invariants
/// and are wrong in the first digit. A system by a formula is measured by the same angle.
#[test]
fn motions_that_are_wrong_are_warned_of_and_right_ones_are_not() {
    let folder = Folder::new();
    let top = |scheme: &str, step: &str, end: &str| {
        let config = format!("integrator = {{ scheme = '{scheme}', step = {step}, end = {end} }}");
        simulate(&folder, &config, &[])
    };
    let body = |step: &str| {
        simulate(&folder, &format!("{BODY}[integrator]\nstep = {step}\nend = 32"), &[])
    };
    for (name, (found, said), casimir) in [
        ("gauss-8 at 15 rad", top("gauss-8", "2.5", "250"), "f1"),
        ("midpoint at 0.15 rad", top("implicit-midpoint", "0.032", "20"), "f1"),
        ("gauss-8 at 10 rad by a formula", body("1"), "c1"),
        ("gauss-8 at 80 rad by a formula", body("8"), "c1"),
    ] {
        let drift = found["deviations"][casimir].as_f64().unwrap();
        assert!(drift < 1e-9, "{name}: the Casimir holds, {drift:e}");
        // The axis of the body hardly moves: its error is small, whatever the angle.
        let least = if casimir == "f1" { 0.1 } else { 0.0 };
        assert!(found["error_estimate"].as_f64() >= Some(least), "{name}: {found}");
        assert!(said.contains("the motion turns by about "), "{name}: {said}");
        assert!(
            said.contains("; the invariants do not show it: compare with a step of "),
            "{said}"
        );
        assert_eq!(said.lines().count(), 1, "{name}: {said}");
    }
    // Controls: other steps of the same motions.
    for (found, said) in
        [top("gauss-8", "0.1", "20"), top("implicit-midpoint", "0.0005", "1"), body("0.02")]
    {
        assert!(found["error_estimate"].as_f64() < Some(1e-4), "{found}");
        assert_eq!(said, "");
    }
}

/// The same rule, and the same summary, where the motion is a page or many motions.
#[test]
fn pages_and_sweeps_are_warned_of_too() {
    let folder = Folder::new();
    let step = |size: &str| format!("integrator.step={size}");
    let axis = |parameter: &str, from: f64, to: f64| {
        format!("[[sweep.axes]]\nparameter = '{parameter}'\nfrom = {from}\nto = {to}\ncount = 2\n")
    };
    folder.write("tops.toml", &axis("initial.angular_momentum[2]", 3.0, 4.0));
    folder.write("bodies.toml", &format!("{BODY}{}", axis("system.initial.Pi[0]", 0.1, 0.3)));
    for (size, wrong) in [("0.5", true), ("0.05", false)] {
        let set = ["--set", &step(size), "--set", "integrator.end=25"];
        let page = summary(&folder, &[&["animate", "--out", "a.html"], &set[..]].concat());
        let tops = summary(&folder, &[&["sweep", "tops.toml", "--out", "tops"], &set[..]].concat());
        let bodies =
            summary(&folder, &[&["sweep", "bodies.toml", "--out", "bodies"], &set[..]].concat());
        for (found, said) in [&page, &tops, &bodies] {
            assert!(found["error_estimate"].is_number(), "{found}");
            assert_eq!(said.contains("the motion turns by "), wrong, "{size}: {said}");
        }
        for (found, _) in [page, tops] {
            assert_eq!(found["error_estimate"].as_f64() > Some(1e-6), wrong, "{size}: {found}");
        }
    }
}

/// A section has the estimate of some of its orbits, in its summary, its closing lines and its table; long steps are
/// warned of.
#[test]
fn sections_have_the_estimate_too() {
    let folder = Folder::new();
    let section =
        "section = { starts = 3, crossings = 4, energy = 1.5, vertical_momentum = 0.5 }\n";
    folder.write("top.toml", section);
    folder.write(
        "body.toml",
        &format!("{BODY}[section]\nsurface = 'Pi1'\nstarts = 3\ncrossings = 4"),
    );
    let of = |file: &str, step: &str| {
        let set = ["--set", step];
        summary(&folder, &[&["section", file, "--out", "out"], &set[..]].concat())
    };
    let (short, silent) = of("top.toml", "integrator.step=0.05");
    let (long, said) = of("top.toml", "integrator.step=1.5");
    assert!(short["error_estimate"].as_f64() < Some(1e-6) && silent.is_empty(), "{short} {silent}");
    assert!(long["error_estimate"].as_f64() > Some(1e-4), "{long}");
    assert!(said.contains("the motion turns by about "), "{said}");
    let (body, _) = of("body.toml", "integrator.step=0.01");
    assert!(body["error_estimate"].as_f64() < Some(1e-6), "{body}");
    let file = std::fs::read(folder.path("out/section.parquet")).unwrap();
    let text: String = file.iter().map(|byte| char::from(*byte)).collect();
    assert!(text.contains("error_estimate"), "the metadata");
    let run = folder.heavytop(&["section", "top.toml", "--out", "other"]);
    assert!(run.stdout().contains("estimated error of 3 starts at the end: "), "{}", run.stdout());
}

/// Where a step turns the motion by more than 100 rad there is nothing to compute, for tops and for systems, by the same
/// rule.
#[test]
fn absurd_steps_are_refused_everywhere() {
    let folder = Folder::new();
    let section = "[section]\nsurface = 'Pi1'\nstarts = 2\ncrossings = 2\n";
    folder.write("body.toml", &format!("{BODY}{section}"));
    folder.write("top.toml", "[initial]\nangular_momentum = [0, 0, 10]");
    // Both turn by about 10 rad/s; where a section looks for the fastest body of its level it finds twice as much.
    for command in ["simulate", "section"] {
        for file in ["body.toml", "top.toml"] {
            for (step, refused) in [("11", true), ("4", false)] {
                let [step, end] = ["step", "end"].map(|key| format!("integrator.{key}={step}"));
                let set = ["--set", &step, "--set", &end, "--dry-run"];
                let out = ["--out", if command == "simulate" { "a.csv" } else { "a" }];
                let run = folder.heavytop(&[&[command, file], &out[..], &set[..]].concat());
                let is_absurd = run.stderr().contains("rad; it must be at most 100");
                assert_eq!(is_absurd, refused, "{command} {file} {step}: {}", run.stderr());
                assert!(
                    !refused || run.code() == 2 && run.stderr().contains("turns the motion by")
                );
            }
        }
    }
    // A sweep says it in the row of the member.
    let axis =
        "[[sweep.axes]]\nparameter = 'system.initial.Pi[2]'\nfrom = 30\nto = 3000\ncount = 2\n";
    folder.write("sweep.toml", &format!("{BODY}{axis}[integrator]\nstep = 0.5\nend = 1"));
    let (found, _) = summary(&folder, &["sweep", "sweep.toml", "--out", "swept"]);
    assert_eq!(found["failed"], 1, "{found}");
    let reason = found["first_failure"].as_str().unwrap();
    assert!(reason.contains("turns the motion by about 5.00"), "{reason}");
}

/// The estimate is in the closing line and in the file, and an interrupted run has the same.
#[test]
fn the_estimate_is_in_the_closing_line_and_in_the_file() {
    let folder = Folder::new();
    folder.write("a.toml", "integrator = { step = 0.1, end = 10 }");
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.npz"]);
    assert!(run.stderr().contains("; estimated error "), "{}", run.stderr());
    let (found, _) = summary(&folder, &["simulate", "a.toml", "--out", "b.npz"]);
    let metadata = format!("\"error_estimate\":{}", found["error_estimate"]);
    let file = std::fs::read(folder.path("b.npz")).unwrap();
    let text: String =
        file.iter().filter(|byte| **byte > 0).map(|byte| char::from(*byte)).collect();
    assert!(text.contains(&metadata), "{metadata}");
}

/// `--check` says the error at the end, close to the estimate, and the order of the scheme. The rows are the same.
#[test]
fn a_check_says_the_error_and_the_order() {
    let folder = Folder::new();
    for (scheme, order, step) in [("implicit-midpoint", 2.0, "0.005"), ("gauss-8", 8.0, "0.2")] {
        let config = format!("integrator = {{ scheme = '{scheme}', step = {step}, end = 4 }}");
        let (plain, _) = simulate(&folder, &config, &[]);
        assert!(plain.get("error").is_none() && plain.get("order").is_none(), "{plain}");
        let rows = std::fs::read(folder.path("a.npz")).unwrap();
        let (checked, _) = simulate(&folder, &config, &["--check"]);
        assert_eq!(std::fs::read(folder.path("a.npz")).unwrap(), rows);
        let (error, estimate) = (&checked["error"], &checked["error_estimate"]);
        let (error, estimate) = (error.as_f64().unwrap(), estimate.as_f64().unwrap());
        assert!(error <= 1.1 * estimate && error > estimate / 20.0, "{checked}");
        assert!((checked["order"].as_f64().unwrap() - order).abs() < 0.3, "{checked}");
    }
    let body = format!("{BODY}[integrator]\nstep = 0.1\nend = 1");
    let (checked, _) = simulate(&folder, &body, &["--check"]);
    assert!((checked["order"].as_f64().unwrap() - 8.0).abs() < 0.5, "{checked}");
    folder.write("a.toml", &body);
    let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--check"]);
    assert!(run.stderr().contains("; checked: "), "{}", run.stderr());
}

/// Where no scheme is named, every command takes the same.
#[test]
fn the_scheme_that_is_not_named_is_the_same_in_every_command() {
    let folder = Folder::new();
    folder.write("system.toml", BODY);
    let end = ["--set", "integrator.end=1"];
    let section = ["--set", "section.starts=2", "--set", "section.crossings=2"];
    for arguments in [
        &["simulate", "--out", "a.csv", end[0], end[1]][..],
        &["simulate", "system.toml", "--out", "b.csv", end[0], end[1]],
        &["simulate", "--preset", "lagrange", "--out", "c.csv", end[0], end[1]],
        &["animate", "--out", "a.html", end[0], end[1]],
        &["sweep", "--out", "map", end[0], end[1]],
        &["section", "--out", "section", section[0], section[1], section[2], section[3]],
    ] {
        assert_eq!(summary(&folder, arguments).0["scheme"], "gauss-8", "{arguments:?}");
    }
    let init = folder.heavytop(&["init"]).stdout();
    assert!(init.contains("scheme = \"gauss-8\""), "{init}");
    let help = folder.heavytop(&["simulate", "--help"]).stdout();
    assert!(help.contains("scheme = \"gauss-8\""), "{help}");
}
