//! `heavytop section` of systems and tops with forces: stroboscopic maps, surfaces of the state, paths of a noise, and refusals.

use crate::program::{Folder, numbers};
use std::f64::consts::TAU;

/// A spin in a field along e₃ and one that turns about it.
const SPIN: &str = "\
[system]
algebra = 'so(3)'
bracket = 'plus'
hamiltonian = '-B*Pi3 - b*(cos(w*t)*Pi1 - sin(w*t)*Pi2)'
parameters = { B = 2, b = 0.3, w = 1.6 }
initial.Pi = [0, 0.6, 0.8]
[section]
surface = 'sin(w*t)'
starts = 4
crossings = 5
[integrator]
step = 0.1
";

/// Returns the rows of the section of a configuration.
fn section(folder: &Folder, text: &str, more: &[&str]) -> Vec<Vec<f64>> {
    folder.write("a.toml", text);
    let done = folder.heavytop(&[&["section", "a.toml", "--out", "s", "--force"], more].concat());
    assert_eq!(done.code(), 0, "{}", done.stderr());
    numbers(&folder.read("s/section.csv")).1
}

/// In the frame of the field that turns the spin turns about (b, 0, B − w), so that b Π₁ + (B − w) Π₃ is the same whenever both frames
/// agree.
#[test]
fn once_a_period_a_driven_spin_is_on_a_circle() {
    let folder = Folder::new();
    let rows = section(&folder, SPIN, &[]);
    assert_eq!(rows.len(), 4 * 6);
    let constant = |row: &Vec<f64>| 0.3 * row[3] + 0.4 * row[5];
    for orbit in rows.chunks(6) {
        for (k, row) in orbit.iter().enumerate() {
            assert!((row[2] - TAU / 1.6 * k as f64).abs() < 1e-12, "{row:?}");
            // Steps of order 8 over 20 units of time.
            assert!((constant(row) - constant(&orbit[0])).abs() < 1e-9, "{row:?}");
            let length: f64 = row[3..6].iter().map(|x| x * x).sum();
            assert!((length - 1.0).abs() < 1e-13 && (row[6], row[7]) == (row[3], row[4]));
        }
    }
    assert_eq!(rows[0][3..6], [0.0, 0.6, 0.8]);
    let apart = |a: &[f64], b: &[f64]| (3..6).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max);
    assert!(apart(&rows[0], &rows[6]) > 0.1 && apart(&rows[0], &rows[1]) > 0.1);
    // Control: a quarter of a period later it is another circle.
    let later = section(&folder, &SPIN.replace("'sin(w*t)'", "'-cos(w*t)'"), &[]);
    assert!((later[0][2] - TAU / 6.4).abs() < 1e-12);
    assert!((constant(&later[0]) - constant(&later[1])).abs() > 1e-2);
    // The threads do not matter, and neither does the table of the run.
    let whole = folder.read("s/section.csv");
    section(&folder, &SPIN.replace("'sin(w*t)'", "'-cos(w*t)'"), &["--threads", "3"]);
    assert_eq!(folder.read("s/section.csv"), whole);
    let svg = folder.read("s/section.svg");
    assert!(svg.contains("starts, 5 returns each"), "{svg}");
}

/// Of a damped spin Π₃ = tanh(θBt) from the equator on.
#[test]
fn a_state_with_friction_is_followed_to_the_surface() {
    let folder = Folder::new();
    let damped = "\
[system]
algebra = 'so(3)'
hamiltonian = '-B*Pi3'
parameters.B = 2
initial.Pi = [1, 0, 0]
[damping]
friction = 0.1
[section]
surface = 'Pi3'
level = 0.5
axes = ['t', 'Pi3']
states = [{ Pi = [1, 0, 0] }]
crossings = 2
longest = 20
[integrator]
step = 0.1
";
    let rows = section(&folder, damped, &["--json"]);
    assert_eq!(rows.len(), 1);
    let time = 0.5_f64.atanh() / 0.2;
    assert!((rows[0][2] - time).abs() < 1e-10 && (rows[0][5] - 0.5).abs() < 1e-14, "{rows:?}");
    assert_eq!(rows[0][6..], [rows[0][2], rows[0][5]]);
    let done = folder.heavytop(&["section", "a.toml", "--out", "t", "--set", "section.level=-0.5"]);
    assert!(
        done.code() == 2
            && done.stderr().contains("state 1 does not cross the surface within 20 s"),
        "{}",
        done.stderr()
    );
    // A brake leaves no Casimir.
    let braked = damped.replace("[damping]\nfriction = 0.1", "[torque]\nPi = ['0', '0', '0.1']");
    folder.write("b.toml", &braked);
    let done = folder.heavytop(&["section", "b.toml", "--out", "u"]);
    assert!(done.stdout().contains("the forces leave nothing conserved"), "{}", done.stdout());
    let (_, rows) = numbers(&folder.read("u/section.csv"));
    assert!((rows[0][2] - 5.0).abs() < 1e-12);
}

/// Each start has a path of its own, which is that of `simulate`.
#[test]
fn paths_of_a_noise_have_sections_at_times_alone() {
    let folder = Folder::new();
    let warm = SPIN
        .replace("starts = 4", "states = [{ Pi = [0, 0.6, 0.8] }, { Pi = [0, 0.6, 0.8] }]")
        + "[damping]\nfriction = 0.2\n[noise]\ntemperature = 0.1\n";
    let rows = section(&folder, &warm.replace("'sin(w*t)'", "'sin(2*acos(-1)*(t - 0.5))'"), &[]);
    assert_eq!(rows.len(), 12);
    for (path, orbit) in rows.chunks(6).enumerate() {
        let set = format!("noise.path={path}");
        let run = [
            "simulate",
            "a.toml",
            "--out",
            "p.csv",
            "--force",
            "--set",
            "integrator.end=6",
            "--set",
        ];
        let done = folder.heavytop(&[&run[..], &[&set]].concat());
        assert_eq!(done.code(), 0, "{}", done.stderr());
        let (_, samples) = numbers(&folder.read("p.csv"));
        for (k, row) in orbit.iter().enumerate() {
            let sample = &samples[5 + 10 * k];
            assert!((row[2] - sample[0]).abs() < 1e-12);
            // The time of the return is right to rounding, and noise of the interval before it moves the state by its root.
            assert!((3..6).all(|i| (row[i] - sample[i - 2]).abs() < 1e-5), "{row:?} {sample:?}");
        }
    }
    assert!((rows[5][3] - rows[11][3]).abs() > 1e-3, "control: other paths");
    folder.write("b.toml", &warm.replace("'sin(w*t)'", "'Pi1'"));
    let done = folder.heavytop(&["section", "b.toml", "--out", "n"]);
    let told = done.stderr();
    assert!(
        done.code() == 2
            && told.contains("section.surface: Pi1 is a function of coordinates")
            && told.contains("depends on the step"),
        "{told}"
    );
}

#[test]
fn sections_that_there_are_not_are_refused_with_a_reason() {
    let folder = Folder::new();
    let input = "[inputs.u]\ntimes = [0, 20]\nvalues = [0, 1]\ninterpolation = 'linear'\n[drive]\nPi = ['u', 0, 0]\n";
    let ring = "[system]\nkind = 'spin-lattice'\nparameters = { shape = [4], exchange = 1 }\ninitial.direction = [0, 0, 1]\n\
                [damping]\nfriction = 0.1\n[section]\nsurface = 'sin(t)'\n";
    for (text, parts) in [
        (
            SPIN.replace("starts = 4", "energy = 1"),
            &["energy is of the section of a motion without forces"][..],
        ),
        (
            SPIN.replace("starts = 4", "vertical_momentum = 1"),
            &["vertical_momentum is of the section of a motion"],
        ),
        (SPIN.replace("surface = 'sin(w*t)'\n", ""), &["surface is missing"]),
        (SPIN.replace("'sin(w*t)'", "'sin(w*u)'"), &["[section]", "u"]),
        (SPIN.replace("starts = 4", "level = inf"), &["inf"]),
        (SPIN.replace("starts = 4", "axes = ['Pi1', 'Pj']"), &["Pj"]),
        (SPIN.replace("starts = 4", "states = [{ Pi = [1, 0] }]"), &["Pi"]),
        (SPIN.to_owned() + input, &["from 0 to 20", "from 0 to 10000"]),
        (ring.to_owned(), &["spin-lattice has no section"]),
        (SPIN.replace("step = 0.1", "step = 1000"), &["a step of 1000 s turns the motion"]),
    ] {
        folder.write("a.toml", &text);
        let done = folder.heavytop(&["section", "a.toml", "--out", "s"]);
        let told = done.stderr();
        assert_eq!(done.code(), 2, "{text}: {told}");
        assert!(parts.iter().all(|part| told.contains(part)), "{text}: {told}");
        assert!(!folder.path("s/section.csv").exists());
    }
}

/// A top whose support shakes has a section, too, by formulas of Π, Γ and the time.
#[test]
fn a_driven_top_has_a_stroboscopic_section() {
    let folder = Folder::new();
    let top = "\
[body]
inertia = [1, 1, 0.6]
weight_moment = 1
center_of_mass = [0, 0, 1]
[initial]
angular_velocity = [0.1, 0, 5]
inclination = '20 deg'
[drive]
Pi = [0, 0, '0.2*cos(3*t)']
[section]
surface = 'sin(3*t)'
axes = ['Gamma1', 'Gamma2']
starts = 2
crossings = 4
[integrator]
step = 0.02
";
    let rows = section(&folder, top, &[]);
    assert_eq!(rows.len(), 10);
    assert!(
        rows.iter()
            .all(|row| (row[6].powi(2) + row[7].powi(2) + row[8].powi(2) - 1.0).abs() < 1e-12)
    );
    assert!(rows.iter().all(|row| (row[9], row[10]) == (row[6], row[7])));
    let momentum = |row: &Vec<f64>| (0..3).map(|i| row[3 + i] * row[6 + i]).sum::<f64>();
    assert!(
        (momentum(&rows[0]) - momentum(&rows[4])).abs() < 1e-12
            && (rows[4][2] - 4.0 * TAU / 3.0).abs() < 1e-12
    );
}
