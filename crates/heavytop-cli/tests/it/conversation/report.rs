//! The command `report`.

use crate::program::Folder;
use serde_json::Value;

/// A laboratory gyroscope, let go at 40° while it spins with 100 rad/s.
const GYROSCOPE: &str = "[body]\ninertia = [3.8e-4, 3.8e-4, 3e-4]\nmass = 0.2\ngravity = 9.81\nlength = 0.03\n\
                         center_of_mass = [0, 0, 1]\n[initial]\nangular_velocity = [0, 0, 100]\n\
                         inclination = \"40 deg\"\n[integrator]\nstep = 0.002\nend = 5\n";

fn report(arguments: &[&str]) -> Value {
    let folder = Folder::new();
    folder.write("a.toml", GYROSCOPE);
    let run = folder.heavytop(&[&["report", "a.toml", "--json"], arguments].concat());
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    assert_eq!(folder.names(), ["a.toml"]);
    serde_json::from_str(&run.stdout()).unwrap()
}

/// Returns the number of a report whose name begins so.
fn number<'a>(report: &'a Value, name: &str) -> &'a Value {
    let numbers = report["numbers"].as_array().unwrap();
    numbers.iter().find(|line| line["name"].as_str().unwrap().starts_with(name)).unwrap()
}

#[test]
fn a_gyroscope_precesses_as_the_textbook_says() {
    let found = report(&[]);
    let precession = number(&found, "precession");
    let textbook = precession["formulas"][0]["value"].as_f64().unwrap();
    assert!((textbook - 0.2 * 9.81 * 0.03 / (3e-4 * 100.0)).abs() < 1e-15);
    let measured = precession["measured"].as_f64().unwrap();
    // The correction to a fast top is of the order of m g l I₁/(I₃ω₃)² = 0.025.
    assert!((measured / textbook - 1.0).abs() < 0.03 && measured != textbook, "{measured}");
    // The height is where it was let go, or lower: 0.03 m cos 40°.
    let height = number(&found, "largest height")["measured"].as_f64().unwrap();
    assert!((height - 0.03 * 40.0_f64.to_radians().cos()).abs() < 1e-12, "{height}");
    // Twice as fast it precesses half as fast, nearly.
    let fast = report(&["--set", "initial.angular_velocity=[0,0,200]"]);
    let half = number(&fast, "precession")["measured"].as_f64().unwrap();
    assert!((half / measured - 0.5).abs() < 0.02 && (half / measured - 0.5).abs() > 1e-4);
}

#[test]
fn the_report_is_a_table_for_people() {
    let folder = Folder::new();
    let run = folder.heavytop(&["report", "--preset", "euler"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    let text = run.stdout();
    for part in [
        "a body without weight",
        "time from flip to flip",
        "disturbances grow e-fold in",
        "L along",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
}

#[test]
fn what_has_no_report_is_refused() {
    let folder = Folder::new();
    folder.write(
        "s.toml",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi1^2'\ninitial = { Pi = [1, 2, 3] }",
    );
    for (arguments, part) in [
        (vec!["s.toml"], "system"),
        (vec!["--set", "integrator.formulation=direct"], "no attitude"),
        (vec!["--set", "output.every=0"], "at least 1"),
    ] {
        let run = folder.heavytop(&[&["report"], &arguments[..]].concat());
        assert!(run.code() == 2 && run.stderr().contains(part), "{arguments:?}: {}", run.stderr());
    }
}
