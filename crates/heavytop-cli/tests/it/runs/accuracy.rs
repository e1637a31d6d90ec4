//! How accurate a run is: the warning about long steps, the estimate of the error, and `--check`.

use crate::program::{Finished, Folder};
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
#[ignore = "long"]
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
        ("gauss-8 at 20 rad by a formula", body("2"), "c1"),
    ] {
        let drift = found["deviations"][casimir].as_f64().unwrap();
        assert!(drift < 1e-9, "{name}: the Casimir holds, {drift:e}");
        // The axis of the body hardly moves: its error is small, whatever the angle.
        let least = if casimir == "f1" { 0.1 } else { 0.0 };
        assert!(found["error_estimate"].as_f64() >= Some(least), "{name}: {found}");
        assert!(said.contains("the motion turns by about "), "{name}: {said}");
        // Only of an error that is large it is said that the invariants do not show it.
        let is_wrong = found["error_estimate"].as_f64() > Some(1e-3);
        assert_eq!(said.contains("; the invariants do not show it: "), is_wrong, "{said}");
        assert!(said.contains(": compare with a step of "), "{said}");
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

/// A laboratory top whose motion is chaotic, for so many seconds that rounding errors have grown to all of its state. Its steps are
/// short, and the first of them agree with half of them to round-off.
const CHAOTIC: &str = "[body]\ninertia = [8e-4, 6e-4, 4e-4]\ninertia_about = 'center-of-mass'\nmass = 0.3\n\
                       gravity = 9.81\nlength = 0.04\ncenter_of_mass = [0.6, 0, 0.8]\n\
                       [initial]\nangular_velocity = [0, 0, 15]\ninclination = 0.3\n[integrator]\n";

/// No step gives the state at the end of a long chaotic motion, and the estimate says so whatever the step is.
#[test]
fn chaos_is_told_from_long_steps() {
    let folder = Folder::new();
    for steps in ["step = 0.004\nend = 80", "step = 0.0005\nend = 80"] {
        let every = "[output]\nevery = 1000\n";
        let (found, said) = simulate(&folder, &format!("{CHAOTIC}{steps}\n{every}"), &[]);
        assert_eq!(found["error_estimate"].as_f64(), Some(1.0), "{steps}: {found}");
        let parts =
            ["the motion is chaotic", "errors grow e-fold in about ", "no step gives the state"];
        assert!(parts.iter().all(|part| said.contains(part)), "{steps}: {said}");
    }
    // Controls: its first two seconds, and a long regular motion.
    let regular = "[integrator]\nstep = 0.02\nend = 400";
    let first = format!("{CHAOTIC}step = 0.0005\nend = 2");
    for config in [first.as_str(), regular] {
        let (found, said) = simulate(&folder, config, &[]);
        assert!(found["error_estimate"].as_f64() < Some(1e-8), "{config}: {found}");
        assert_eq!(said, "", "{config}");
    }
}

/// Where the step is left out, it does not turn a top by more than a radian.
#[test]
fn steps_that_are_left_out_resolve_the_motion() {
    let folder = Folder::new();
    folder.write(
        "a.toml",
        "[body]\ninertia = [3.8e-4, 3.8e-4, 3e-4]\nweight_moment = 0.0589\ncenter_of_mass = [0, 0, 1]\n\
         [initial]\nangular_velocity = [0, 0, 300]\ninclination = '40 deg'\n[integrator]\nend = 1\n\
         [[sweep.axes]]\nparameter = 'initial.angular_velocity[2]'\nfrom = 100\nto = 300\ncount = 3\n",
    );
    let (found, said) = summary(&folder, &["report", "a.toml"]);
    assert_eq!(said, "");
    // At most 0.5 rad at 300 rad/s and some swinging.
    let step = found["step"].as_f64().unwrap();
    assert!(step < 0.5 / 300.0 && step > 0.5 / 600.0, "{step}");
    let (_, said) = summary(&folder, &["sweep", "a.toml", "--out", "s"]);
    assert_eq!(said, "");
    // An end that is left out comes after as many steps as usual.
    let text = folder.read("a.toml").replace("end = 1\n", "");
    folder.write("b.toml", &text);
    let (found, said) = summary(&folder, &["sweep", "b.toml", "--out", "t"]);
    let [step, end] = ["step", "end"].map(|key| found[key].as_f64().unwrap());
    assert!(said.is_empty() && step < 0.005 && (end / step - 1000.0).abs() < 1e-9, "{found}");
    // Control: the step of a slow top is the usual one.
    assert_eq!(summary(&folder, &["report"]).0["step"].as_f64(), Some(0.02));
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
#[ignore = "long"]
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

/// Why a check shows no order is said: the differences are round-off, the run has one step, or twice the step fails.
#[test]
fn a_check_without_an_order_says_why() {
    let folder = Folder::new();
    let long = "scheme = 'lobatto-iiia-iiib-4', step = 0.25, end = 1";
    for (integrator, why) in [
        ("step = 0.01, end = 1", "the differences are round-off"),
        ("step = 0.1, end = 0.1", "twice the step does not fit into the run"),
        (long, "the run with twice the step fails"),
    ] {
        let config = format!("integrator = {{ {integrator} }}");
        let (checked, _) = simulate(&folder, &config, &["--check"]);
        assert_eq!((&checked["order"], &checked["no_order"]), (&Value::Null, &why.into()));
        assert!(checked["error"].is_number(), "{checked}");
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv", "--check"]);
        assert!(
            run.stderr().contains(&format!(" at the end, no order: {why}")),
            "{}",
            run.stderr()
        );
    }
}

/// Ctrl-C during a check loses neither the run nor its summary; during the estimate of the error it stops the run before
/// its first step.
#[test]
#[cfg(unix)]
fn estimates_and_checks_can_be_interrupted() {
    let folder = Folder::new();
    let interrupted = |end: &str, awaited: &str| {
        folder.write("a.toml", &format!("integrator = {{ scheme = 'gauss-4', end = {end} }}"));
        let arguments = ["simulate", "a.toml", "--out", "a.csv", "--check", "--json"];
        let mut child = folder.start_piped(&arguments);
        while !folder.path(awaited).exists() && child.try_wait().unwrap().is_none() {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        let id = child.id().to_string();
        assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
        Finished::of(child.wait_with_output().unwrap())
    };
    // The output has its name: the check goes on.
    let run = interrupted("1000", "a.csv");
    assert_eq!(run.code(), 130, "{}", run.stderr());
    let summary: Value = serde_json::from_str(&run.stdout()).unwrap();
    assert_eq!(summary["rows"], 50_001);
    assert!(summary["error_estimate"].is_number() && summary["error"].is_null(), "{summary}");
    assert_eq!(summary["no_order"], "the check was interrupted");
    assert_eq!(folder.names(), ["a.csv", "a.toml"]);
    std::fs::remove_file(folder.path("a.csv")).unwrap();
    // The output is locked: the estimate goes on, of 100 000 steps.
    let run = interrupted("40000", "a.csv.partial");
    assert_eq!((run.code(), run.stdout()), (130, String::new()), "{}", run.stderr());
    assert!(run.stderr().contains("--resume"), "{}", run.stderr());
    assert!(folder.read("a.csv.checkpoint").contains("\nstep = 0\n"));
}

/// A coordinate that starts as cos(π/2), zero but for rounding, has no error of its own size.
#[test]
fn what_is_zero_but_for_rounding_is_not_wrong() {
    let folder = Folder::new();
    let body = |z: &str| {
        let config = format!(
            "[system]\ncoordinates = ['x', 'y', 'z']\nbrackets = {{ 'x, y' = 'z', 'y, z' = 'x', 'z, x' = 'y' }}\n\
             hamiltonian = 'x^2/2 + y^2/4 + z^2/6'\ninitial = {{ x = 1, y = 0, z = {z} }}\n\
             [integrator]\nformulation = 'FORMULATION'\nstep = 0.1\nend = 20"
        );
        ["collective", "direct"].map(|formulation| {
            let (found, said) = simulate(&folder, &config.replace("FORMULATION", formulation), &[]);
            (found["error_estimate"].as_f64().unwrap(), said)
        })
    };
    for (estimate, said) in body("6.123233995736766e-17") {
        assert!(estimate < 1e-6, "{estimate:e}");
        assert_eq!(said, "");
    }
    // Control: a z that moves has an error of its own size.
    for (estimate, _) in body("0.5") {
        assert!(estimate > 0.0 && estimate < 1e-6, "{estimate:e}");
    }
}

/// Where no scheme is named, every command takes the same.
#[test]
#[ignore = "long"]
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
