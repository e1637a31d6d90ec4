//! The command `events`.

use crate::program::Folder;
use serde_json::Value;

/// A pendulum of length g s², let go at 2 rad from the lowest point; in axes turned by the angle atan(3/4) about e₃.
const PENDULUM: &str = "[body]\ninertia = [[2.64, -0.48, 0], [-0.48, 2.36, 0], [0, 0, 1]]\nweight_moment = 2.0\n\
                        center_of_mass = [0.8, 0.6, 0]\n[initial]\nangular_momentum = [0, 0, 0]\n\
                        vertical = [{x}, {y}, 0]\n[integrator]\nstep = 0.05\nend = 20\n[events]\n\
                        functions = ['0.8*Gamma2 - 0.6*Gamma1']\n";

/// Returns the pendulum, whose moment about e₃ is 1, let go at an angle from its lowest point.
fn pendulum(angle: f64) -> String {
    let (sine, cosine) = angle.sin_cos();
    // The vertical is −c at the lowest point.
    let (x, y) = (-0.8 * cosine - 0.6 * sine, -0.6 * cosine + 0.8 * sine);
    PENDULUM.replace("{x}", &format!("{x}")).replace("{y}", &format!("{y}"))
}

/// Returns half the period of a pendulum with ω = √2 and this amplitude, by the arithmetic-geometric mean.
fn half_period(angle: f64) -> f64 {
    let (mut a, mut b) = (1.0, (angle / 2.0).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    std::f64::consts::PI / (a * 2.0_f64.sqrt())
}

/// Returns the rows of a table as numbers.
fn rows(csv: &str) -> Vec<Vec<f64>> {
    let lines = csv.lines().skip(1);
    lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect()
}

#[test]
fn a_pendulum_passes_its_lowest_point_as_elliptic_integrals_say() {
    let folder = Folder::new();
    folder.write("a.toml", &pendulum(2.0));
    let run = folder.heavytop(&["events", "a.toml", "--out", "-", "--quiet"]);
    assert_eq!((run.code(), run.stderr()), (0, String::new()));
    let header = "event,t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3,h,f1,f2\n";
    assert!(run.stdout().starts_with(header), "{}", run.stdout());
    let found = rows(&run.stdout());
    let expected = half_period(2.0);
    assert_eq!(found.len(), (20.0 / expected - 0.5).ceil() as usize);
    for (number, row) in found.iter().enumerate() {
        // Gauss of order 8 with a step of 0.05 has an error of 1e-10 after 20 s.
        let time = expected * (number as f64 + 0.5);
        assert!((row[1] - time).abs() < 1e-9, "{} {time}", row[1]);
        // Within rounding of the lowest point, in the axes of the file.
        assert!(row[0] == 1.0 && (0.8 * row[6] - 0.6 * row[5]).abs() < 1e-13, "{row:?}");
    }
    // Control: of another amplitude the times are others.
    assert!((half_period(2.1) - expected).abs() > 0.01);
}

#[test]
fn directions_and_ends_are_those_that_are_asked_for() {
    let folder = Folder::new();
    folder.write("a.toml", &pendulum(2.0));
    let summary = |settings: &[&str]| -> Value {
        let settings: Vec<_> = settings.iter().flat_map(|set| ["--set", set]).collect();
        let options = ["events", "a.toml", "--out", "e.csv", "--json"];
        let run = folder.heavytop(&[&options[..], &settings].concat());
        assert_eq!(run.code(), 0, "{}", run.stderr());
        serde_json::from_str(&run.stdout()).unwrap()
    };
    let half = half_period(2.0);
    let both = summary(&[]);
    let interval = |summary: &Value| summary["functions"][0]["interval"].as_f64().unwrap();
    assert!((interval(&both) - half).abs() < 1e-9);
    for direction in ["up", "down"] {
        let one = summary(&[&format!("events.direction={direction}")]);
        assert!((interval(&one) - 2.0 * half).abs() < 1e-9, "{one}");
    }
    let ended = summary(&[
        "events.terminal=2",
        "events.functions=['Pi3 - 1e9', '0.8*Gamma2 - 0.6*Gamma1', 'atan2(Pi3, Gamma1)']",
    ]);
    assert_eq!(ended["functions"][0]["events"], 0);
    assert!((ended["end"].as_f64().unwrap() - 1.5 * half).abs() < 1e-9, "{ended}");
    let table = rows(&folder.read("e.csv"));
    assert!(table.windows(2).all(|pair| pair[0][1] <= pair[1][1]), "{table:?}");
    assert!(table.iter().any(|row| row[0] == 3.0) && table.last().unwrap()[0] == 2.0);
}

#[test]
fn systems_have_events_of_their_coordinates_and_parameters() {
    let folder = Folder::new();
    folder.write(
        "s.toml",
        "[system]\nalgebra = 'so(3)'\nhamiltonian = 'w*Pi3'\nparameters = { w = 0.5 }\n\
         initial = { Pi = [1, 0, 2] }\n[integrator]\nstep = 0.1\nend = 20\n\
         [events]\nfunctions = ['Pi1 - w']\ndirection = 'down'\n",
    );
    let run = folder.heavytop(&["events", "s.toml", "--out", "-", "--quiet"]);
    assert_eq!(run.code(), 0, "{}", run.stderr());
    // Π turns by w = ½: Π₁ = cos t/2 comes down to ½ at t/2 = π/3, and again after 4π.
    let times: Vec<f64> = rows(&run.stdout()).iter().map(|row| row[1]).collect();
    let first = 2.0 * std::f64::consts::FRAC_PI_3;
    let expected = [first, first + 4.0 * std::f64::consts::PI];
    assert_eq!(times.len(), 2);
    for (time, expected) in times.iter().zip(expected) {
        assert!((time - expected).abs() < 1e-10, "{time} {expected}");
    }
}

#[test]
fn functions_of_the_time_and_of_inputs_have_their_zeros_in_systems_and_tops() {
    let folder = Folder::new();
    let half = std::f64::consts::FRAC_PI_2;
    let odd: Vec<f64> = [1.0, 3.0, 5.0].map(|k| k * half).to_vec();
    let times = |file: &str, function: &str| -> Vec<f64> {
        let set = format!("events.functions=[\"{function}\"]");
        let run = folder.heavytop(&["events", file, "--set", &set, "--out", "-", "--quiet"]);
        assert_eq!(run.code(), 0, "{}", run.stderr());
        rows(&run.stdout()).iter().map(|row| row[1]).collect()
    };
    let agree = |found: &[f64], expected: &[f64], most: f64| {
        let near = found.iter().zip(expected).all(|(x, y)| (x - y).abs() < most);
        assert!(near && found.len() == expected.len(), "{found:?} {expected:?}");
    };
    let closed = "[system]\nalgebra = 'so(3)'\nhamiltonian = 'Pi3'\ninitial = { Pi = [1, 0, 2] }\n\
                  [integrator]\nstep = 0.1\nend = 10\n[events]\n";
    let driven = "[inputs.u]\ntimes = [0, 10]\nvalues = [-1, 1]\ninterpolation = 'linear'\n\
                  [drive]\nPi = [0, 0, 'u']\n";
    folder.write("closed.toml", closed);
    folder.write("open.toml", &format!("{closed}{driven}"));
    folder.write("in_time.toml", &closed.replace("'Pi3'", "'cos(t)*Pi3'"));
    folder.write("top.toml", "[integrator]\nstep = 0.05\nend = 10\n[events]\n");
    let torque = "[torque]\nPi = ['-0.1*Pi1', 0, 0]\n";
    folder
        .write("braked.toml", &format!("[integrator]\nstep = 0.05\nend = 10\n[events]\n{torque}"));
    for file in ["closed.toml", "open.toml", "in_time.toml", "top.toml", "braked.toml"] {
        // No integrator has a part in cos t: what is left is rounding.
        agree(&times(file, "cos(t)"), &odd, 1e-14);
    }
    // An input, and a function of both the state and the time: Π₁ = cos t here.
    agree(&times("open.toml", "u - 0.25"), &[6.25], 1e-13);
    let both = times("closed.toml", "Pi1 - cos(t + 1)");
    // cos t = cos(t + 1) at t = −½ + kπ
    let expected = [1.0, 2.0, 3.0].map(|k| k * 2.0 * half - 0.5);
    agree(&both, &expected, 1e-11);
    // Control: the zeros of another function of the time are others.
    assert!(times("closed.toml", "cos(2*t)").len() == 6);
    // A system whose own t is something else keeps it.
    folder.write("own.toml", &closed.replace("'Pi3'", "'t*Pi3'\nparameters = { t = 1 }"));
    // cos t = ½ at ±π/3 + 2kπ
    let sixth = half / 1.5;
    agree(&times("own.toml", "Pi1 - t/2"), &[1.0, 5.0, 7.0].map(|k| k * sixth), 1e-11);
    let refused = folder.heavytop(&[
        "events",
        "closed.toml",
        "--set",
        "events.functions=['u']",
        "--out",
        "u.csv",
    ]);
    assert!(refused.code() == 2 && refused.stderr().contains("u"), "{}", refused.stderr());
}

#[test]
fn what_has_no_events_is_refused() {
    let folder = Folder::new();
    folder.write("notes.csv", "time,temperature\n");
    let with = |set: &str, out: &str| {
        folder.heavytop(&["events", "--set", set, "--set", "integrator.end=10", "--out", out])
    };
    for (set, out, code, part) in [
        ("integrator.step=0.02", "e.csv", 2, "functions is missing"),
        ("events.functions=[]", "e.csv", 2, "functions is missing"),
        ("events.functions=['Gamma3', 'Gamma9']", "e.csv", 2, "Gamma9"),
        ("events={functions=['Pi1'], terminal=0}", "e.csv", 2, "at least 1"),
        ("events.functions=['Pi1']", "e.npz", 2, ".csv"),
        ("events.functions=['Pi1']", "notes.csv", 2, "not overwritten"),
        ("events.functions=['ln(-1 - Pi1^2)']", "e.csv", 2, "has no value at t = 0"),
    ] {
        let run = with(set, out);
        assert!(run.code() == code && run.stderr().contains(part), "{set}: {}", run.stderr());
        assert_eq!(folder.names(), ["notes.csv"], "{set}");
    }
    // A function that loses its value on the way: the events until then are kept.
    let run = with("events.functions=['Gamma1', 'ln(2.5 - Pi1)']", "e.csv");
    assert_eq!(run.code(), 1, "{}", run.stderr());
    assert!(run.stderr().contains("has no value at t = "), "{}", run.stderr());
    assert_eq!(folder.names(), ["e.csv.partial", "notes.csv"]);
}
