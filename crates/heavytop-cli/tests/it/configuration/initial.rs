//! `[initial]` by angular velocity and angles, and unit vectors that are scaled.

use crate::program::{Folder, numbers};

/// Returns the first row of a run: t, Π, Γ and the invariants.
fn first(text: &str, arguments: &[&str]) -> Vec<f64> {
    let folder = Folder::new();
    folder.write("a.toml", &format!("{text}\n[integrator]\nend = 0.1"));
    let arguments = [&["simulate", "a.toml", "--out", "a.csv", "--quiet"], arguments].concat();
    let run = folder.heavytop(&arguments);
    assert_eq!((run.code(), run.stderr()), (0, String::new()), "{text} {arguments:?}");
    numbers(&folder.read("a.csv")).1.remove(0)
}

#[test]
fn the_angular_velocity_gives_the_angular_momentum() {
    // The moments are 2, 2 and 1 kg m².
    let row = first("initial.angular_velocity = [1, -1.5, 4]", &[]);
    assert_eq!(row[1..4], [2.0, -3.0, 4.0]);
    // An assignment overrides the other key of a file, and of a preset.
    let velocity = &["--set", "initial.angular_velocity=[1,1,1]"];
    assert_eq!(first("initial.angular_momentum = [7, 7, 7]", velocity)[1..4], [2.0, 2.0, 1.0]);
    let preset = &[&["--preset", "euler"], &velocity[..]].concat();
    assert_eq!(first("", preset)[1..4], [1.0, 2.0, 3.0]);
    let momentum = &["--set", "initial.angular_momentum=[7,7,7]"];
    assert_eq!(first("initial.angular_velocity = [1, 1, 1]", momentum)[1..4], [7.0, 7.0, 7.0]);
}

/// Γ(0) = (sin i cos a, sin i sin a, cos i): the signs and the zero of both angles.
#[test]
fn the_angles_give_the_vertical() {
    let (half, third) = (std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_3);
    for (inclination, azimuth, expected) in [
        (0.0, "", [0.0, 0.0, 1.0]),
        (half, "", [1.0, 0.0, 0.0]),
        (half, "1.5707963267948966", [0.0, 1.0, 0.0]),
        (half, "-1.5707963267948966", [0.0, -1.0, 0.0]),
        (2.0 * half, "0.7", [0.0, 0.0, -1.0]),
        (third, "0", [0.75_f64.sqrt(), 0.0, 0.5]),
    ] {
        let azimuth =
            if azimuth.is_empty() { String::new() } else { format!("azimuth = {azimuth}") };
        let row = first(&format!("[initial]\ninclination = {inclination}\n{azimuth}"), &[]);
        for (found, expected) in row[4..7].iter().zip(expected) {
            // The cosine of the nearest number to π/2 is 6e-17.
            assert!((found - expected).abs() < 2e-16, "{inclination} {azimuth}: {row:?}");
        }
    }
    // An azimuth alone may complete a file that has an inclination.
    let row = first("initial.inclination = 1.5707963267948966", &["--set", "initial.azimuth=3"]);
    assert!((row[4] - 3.0_f64.cos()).abs() < 2e-16 && (row[5] - 3.0_f64.sin()).abs() < 2e-16);
}

/// A quaternion, or Euler angles, give the vertical Γ = Rᵀe₃ = (sin θ sin ψ, sin θ cos ψ, cos θ) and the attitude.
#[test]
fn the_attitude_gives_the_vertical() {
    let (theta, psi) = (0.9_f64, -2.0_f64);
    let gamma = [theta.sin() * psi.sin(), theta.sin() * psi.cos(), theta.cos()];
    let close = |found: &[f64], expected: &[f64]| {
        let error = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(found.len() == expected.len() && error < 1e-15, "{found:?} {expected:?}");
    };
    let angles = format!("initial.euler_angles = [0.4, {theta}, {psi}]\noutput.attitude = true");
    let row = first(&angles, &[]);
    close(&row[4..7], &gamma);
    let q = &row[row.len() - 4..];
    // The quaternion is the same attitude, and angles of an assignment override it.
    let quaternion = format!("initial.attitude = {q:?}\noutput.attitude = true");
    let again = first(&quaternion, &[]);
    close(&again[4..7], &gamma);
    close(&again[again.len() - 4..], q);
    let double = format!("initial.attitude = {:?}\ninitial.normalise = true", [2.0, 0.0, 0.0, 0.0]);
    close(&first(&double, &[])[4..7], &[0.0, 0.0, 1.0]);
    close(&first(&quaternion, &["--set", "initial.vertical=[0,0,1]"])[4..7], &[0.0, 0.0, 1.0]);
    close(
        &first(
            "initial.vertical = [0, 0, 1]",
            &["--set", &angles.lines().next().unwrap().replace(' ', "")],
        )[4..7],
        &gamma,
    );
    // Another precession is the same motion in another direction of space.
    let turned = first(&angles.replace("0.4", "1.4"), &[]);
    close(&turned[..row.len() - 4], &row[..row.len() - 4]);
    assert!((turned[row.len() - 4] - q[0]).abs() > 1e-2);
    for (text, part) in [
        ("initial.attitude = [1, 1, 0, 0]", "attitude must be a unit vector"),
        (
            "initial = { attitude = [0, 0, 0, 0], normalise = true }",
            "attitude must be a unit vector",
        ),
        (
            "initial = { attitude = [1, 0, 0, 0], vertical = [0, 0, 1] }",
            "`attitude` gives the vertical",
        ),
        (
            "initial = { euler_angles = [0, 1, 0], inclination = 1 }",
            "`euler_angles` give the vertical",
        ),
        ("initial = { euler_angles = [0, 1, 0], attitude = [1, 0, 0, 0] }", "excludes `attitude`"),
        ("initial.euler_angles = [0, inf, 0]", "must be finite"),
    ] {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        assert!(run.code() == 2 && run.stderr().contains(part), "{text}: {}", run.stderr());
    }
}

#[test]
fn vectors_are_scaled_if_asked() {
    let row = first("initial.vertical = [3, 0, 4]\ninitial.normalise = true", &[]);
    assert_eq!(row[4..7], [0.6, 0.0, 0.8]);
    // h = Π·I⁻¹Π/2 + m g l Γ·c with c = (3, 0, 4)/5 and Γ = e₃ is 11.25 + 0.8.
    let body = "body.center_of_mass = [3, 0, 4]\nbody.normalise = true\n\
                initial.angular_momentum = [2, 3, 4]\ninitial.vertical = [0, 0, 1]";
    assert!((first(body, &[])[7] - 12.05).abs() < 1e-14);
    // Negative control: without the key, and without a direction, they are refused.
    for text in [
        "initial.vertical = [3, 0, 4]",
        "body.center_of_mass = [3, 0, 4]",
        "initial = { vertical = [0, 0, 0], normalise = true }",
        "initial = { vertical = [inf, 0, 0], normalise = true }",
    ] {
        let folder = Folder::new();
        folder.write("a.toml", text);
        let run = folder.heavytop(&["simulate", "a.toml", "--out", "a.csv"]);
        assert_eq!(run.code(), 2, "{text}");
        assert!(run.stderr().contains("must be a unit vector"), "{}", run.stderr());
    }
}

/// A run from angles and a velocity is repeatable, and a sweep over bodies keeps Ω(0).
#[test]
fn a_configuration_by_angles_and_velocity_serves_runs_and_sweeps() {
    let folder = Folder::new();
    let text = "[initial]\nangular_velocity = [1, 1.5, 4]\ninclination = 0.3\n\
                [integrator]\nend = 200";
    folder.write("a.toml", text);
    let interval = ["--checkpoint-interval", "0"];
    let run = |arguments: &[&str]| {
        folder.heavytop(&[&["simulate", "a.toml", "--quiet"], &interval[..], arguments].concat())
    };
    assert_eq!(run(&["--out", "a.csv"]).code(), 0);
    assert_eq!(run(&["--out", "b.csv"]).code(), 0);
    assert_eq!(folder.read("a.csv"), folder.read("b.csv"));
    // A sweep over bodies keeps Ω(0): Π₃(0) = I₃ Ω₃(0).
    folder.write(
        "map.toml",
        "initial.angular_velocity = [0, 0, 2]\nintegrator.end = 0.1\n\
        sweep.axes = [{ parameter = 'initial.angular_momentum[2]', from = 1, to = 2, count = 2 }]",
    );
    let refused = folder.heavytop(&["sweep", "map.toml", "--out", "map"]);
    assert_eq!(refused.code(), 2, "{}", refused.stderr());
    assert!(refused.stderr().contains("needs [initial] angular_momentum instead"));
    let axis = "sweep.axes=[{ parameter = 'body.inertia[2]', from = 1, to = 2, count = 2 }]";
    let made = folder.heavytop(&["sweep", "map.toml", "--set", axis, "--out", "map"]);
    assert_eq!(made.code(), 0, "{}", made.stderr());
}
